"""What a mesh cycle comes to: loss and efficiency, extremes and the flank, of made-up solutions."""

import os
from dataclasses import replace

import numpy as np
import pytest
from folders import CASES
from lives import life_dataset
from swept_cycle import (
    LEVER,
    PHASES,
    PITCH,
    SLIDING,
    SLIDING_LEVER,
    WHEEL_SPEED,
    WORM_SPEED,
    cycle_result,
    cycle_solution,
    friction,
    tooth_load,
)
from synthetic_solution import make_result

import pyworm
from pyworm.batch import drive_iteration
from pyworm.batch.task import Task
from pyworm.drives.mesh_loss import MeshLoss
from pyworm.drives.worm import dataset
from pyworm.plots.drives.worm import CYCLE_PICTURES
from pyworm.plots.drives.worm_thread import draw_thread
from pyworm.ratings.mesh_loss import with_missing
from pyworm.ratings.standard_loss import NoStandard
from pyworm.report.console.mesh_cycle import cycle_table, loss_sentence, loss_table
from pyworm.result.flank_map import entry, flank_map, thread_map
from pyworm.result.flank_wear import asperity_pass, flank_grid
from pyworm.result.mesh_cycle import drive_cycle, flank_place
from pyworm.result.result import case_in
from pyworm.solver.ending import Ending
from pyworm.solver.solution import Estimate
from pyworm.solver.transient.lifts import Lift

HEATED = ["temperature_body_1", "temperature_body_2", "temperature_middle"]


def test_a_model_uncertainty_without_a_bound_makes_that_of_the_loss_unknown():
    """Where no power is lost it is nothing, so that there is no NaN; tables have the word, not "inf"."""
    result = cycle_result(PHASES)
    figures = result.solutions[2].figures
    unknown = replace(figures, power_loss=replace(figures.power_loss, model=np.inf))
    solutions = list(result.solutions)
    solutions[2] = replace(solutions[2], figures=unknown)
    cycle = drive_cycle(replace(result, solutions=tuple(solutions)))
    assert cycle.loss.model_error == np.inf and cycle.loss.efficiency_model_error == np.inf
    assert np.isfinite(cycle.loss.error)
    table = loss_table(cycle, NoStandard("none"), None)
    said = "".join(text for row in table.rows for text in row)
    assert said.count("± unknown (model)") == 4 and "inf" not in said


@pytest.mark.parametrize("driver", ("worm", "wheel"))
def test_loss_and_efficiency_are_those_of_the_integrals(driver):
    loss = drive_cycle(cycle_result(PHASES, driver)).loss
    fine = np.linspace(0, 1, 20001)
    power = np.trapezoid(friction(fine) * tooth_load(fine) * SLIDING, fine) / PITCH
    sign = -1 if driver == "wheel" else 1
    lever = LEVER + sign * friction(fine) * SLIDING_LEVER
    torque = np.trapezoid(tooth_load(fine) * lever, fine) / PITCH
    assert loss.power == pytest.approx(power, rel=2e-3)
    assert abs(loss.power - power) < loss.error
    assert loss.wheel_torque == pytest.approx(torque, rel=1e-4)
    # what goes into one shaft and not out of the other is lost
    difference = loss.worm_torque * WORM_SPEED - loss.wheel_torque * WHEEL_SPEED
    assert difference == pytest.approx(sign * loss.power, rel=1e-9)
    powers = sorted([loss.worm_torque * WORM_SPEED, loss.wheel_torque * WHEEL_SPEED])
    assert loss.efficiency == pytest.approx(powers[0] / powers[1], rel=1e-9)
    other = drive_cycle(cycle_result(PHASES, "wheel" if driver == "worm" else "worm")).loss
    assert loss.reverse_efficiency == pytest.approx(other.efficiency, rel=1e-9)


@pytest.mark.parametrize("driver", ("worm", "wheel"))
@pytest.mark.parametrize("shaft", ("worm", "wheel"))
def test_loads_shared_with_an_assumed_friction_carry_the_torque_that_was_asked_for(driver, shaft):
    """300 N m asked for are 300, whatever friction is found; the loss follows the loads."""
    before = cycle_result(PHASES, driver)
    free = drive_cycle(before).loss
    asked = 1.007 * getattr(free, f"{shaft}_torque")
    cycle = before.mesh_cycle.assign_attrs(torque=asked, torque_shaft=shaft)
    loss = drive_cycle(replace(before, mesh_cycle=cycle)).loss
    assert getattr(loss, f"{shaft}_torque") == pytest.approx(asked, rel=1e-12)
    for name in ("power", "wheel_torque", "worm_torque", "error"):
        assert getattr(loss, name) == pytest.approx(1.007 * getattr(free, name), rel=1e-9)
    for name in ("friction", "efficiency", "reverse_efficiency"):
        assert getattr(loss, name) == pytest.approx(getattr(free, name), rel=1e-9)


def test_error_of_the_loss_is_made_of_scenes_phases_and_ends():
    loss = drive_cycle(cycle_result(PHASES)).loss
    assert loss.scene_error == pytest.approx(np.hypot(0.004, 0.001) * loss.power, rel=1e-3)
    coarse = drive_cycle(cycle_result(PHASES[::4])).loss
    assert coarse.phase_error > 3 * loss.phase_error
    assert drive_cycle(cycle_result(PHASES[3:-3])).loss.end_error > 5 * loss.end_error


def test_transient_solutions_tell_the_loss_between_and_beyond_the_phases():
    """Three phases, and the friction's course over all of the cycle but for a factor."""
    few = cycle_result(PHASES[2:-2:3])
    steady = drive_cycle(few).loss
    ends = np.split(np.linspace(0.005, 0.995, 199), [67, 134])
    lively = [
        replace(
            one,
            life=life_dataset(at, 1.02 * friction(at) * SLIDING * tooth_load(at), tooth_load(at)),
        )
        for one, at in zip(few.solutions, ends, strict=True)
    ]
    loss = drive_cycle(replace(few, solutions=tuple(lively))).loss
    truth = drive_cycle(cycle_result(np.linspace(0.01, 0.99, 81))).loss
    assert loss.power == pytest.approx(truth.power, rel=1e-3)
    assert abs(steady.power / truth.power - 1) > 0.005
    assert loss.phase_error + loss.end_error < 0.1 * (steady.phase_error + steady.end_error)


def test_extremes_know_their_phase_and_place():
    solutions = cycle_result(PHASES).solutions
    thin = 4
    figures = replace(
        solutions[thin].figures, film_min=Estimate(0.2e-6, 0.02), film_min_at=(2e-3, -1e-3)
    )
    changed = replace(
        cycle_result(PHASES),
        solutions=tuple(
            replace(one, figures=figures) if number == thin else one
            for number, one in enumerate(solutions)
        )[::-1],
    )
    cycle = drive_cycle(changed)
    assert cycle.film_min.phase == PHASES[thin]
    assert cycle.film_min.error == pytest.approx(0.02 * 0.2e-6)
    place = (2e-3 + 0.02 * (PHASES[thin] - 0.5), 0.27 - 1e-3 - 0.015 * (PHASES[thin] - 0.5))
    assert cycle.film_min.place == pytest.approx(place)
    assert cycle.lambda_min.value == pytest.approx(0.2 / 0.5)
    assert drive_cycle(cycle_result(PHASES, roughness=None)).lambda_min is None
    hottest = max(one.figures.temperature_max_film.value for one in solutions)
    assert cycle.temperatures["film"].value == hottest
    told = cycle.summary()
    assert told["film_min"]["value_m"] == 0.2e-6
    assert told["power_loss_W"] == cycle.loss.power
    table = cycle_table(cycle)
    assert "0.2 µm ± 0.004" in table.column(1)


def test_a_largest_pressure_without_a_bar_says_why():
    whole = cycle_result(PHASES)
    spike = Estimate(9e9, np.inf, reason="unresolved pressure spike, 2.0 nodes wide")
    first, *others = whole.solutions
    first = replace(first, figures=replace(first.figures, pressure_max=spike))
    cycle = drive_cycle(replace(whole, solutions=(first, *others)))
    assert cycle.summary()["pressure_max"]["error_reason"] == spike.reason
    assert "error_reason" not in cycle.summary()["film_min"]
    assert spike.reason in cycle_table(cycle).note


def test_what_did_not_converge_is_left_out_and_named():
    whole = cycle_result(PHASES)
    bad = replace(
        whole.solutions[0],
        converged=False,
        figures=replace(whole.solutions[0].figures, pressure_max=Estimate(9e9, np.inf)),
    )
    cycle = drive_cycle(replace(whole, solutions=(bad, *whole.solutions[1:])))
    assert cycle.unconverged == (PHASES[0],)
    assert cycle.pressure_max.value < 9e9
    assert drive_cycle(cycle_result(PHASES[:2])) is None
    assert drive_cycle(make_result()) is None


def test_an_efficiency_names_the_contacts_that_it_lacks_in_its_line():
    """Whether a contact did not converge or has no solution at all, in tables and JSON objects."""
    whole = cycle_result(PHASES)
    bad = replace(whole.solutions[0], converged=False, ending=Ending.LARGEST_GRID)
    bad = replace(bad, stop_reason="no more nodes")
    torn = replace(
        whole,
        solutions=(bad, *whole.solutions[1:]),
        provenance={"failed": {"phase 0.99": "no contact"}},
    )
    missing = f"2 of {len(PHASES) + 1} contacts missing: {bad.name}, phase 0.99"
    assert torn.missing == torn.sound.missing == missing
    assert torn.stop_reason == f"{missing} (no more nodes; no contact)"
    for result in (whole, torn):
        cycle = drive_cycle(result)
        lacking = result is torn
        assert (cycle.summary().get("missing") == missing) == lacking
        table = loss_table(cycle, NoStandard("none"), None)
        rows = dict(table.rows)
        for label in ("Efficiency of the teeth", "  wheel driving"):
            assert rows[label].endswith(f"; {missing}") == lacking
        loss = MeshLoss(1e3, 50.0, 0.05, 0.01, "of a formula", missing=result.missing)
        assert (
            f"Efficiency of the teeth 95.00 % ± 0.05 ({missing}), power loss" in loss_sentence(loss)
        ) == lacking
        assert (loss.summary().get("missing") == missing) == lacking
        label = with_missing("efficiency", "Efficiency", result)
        assert label == (f"Efficiency (simulation: {missing})" if lacking else "Efficiency")


def test_the_flank_keeps_extremes_of_all_phases():
    whole = cycle_result(PHASES[::3])
    field = flank_map(whole)
    largest = max(float(one.fields["pressure"].max()) for one in whole.solutions)
    thinnest = min(float(one.fields["film"].min()) for one in whole.solutions)
    assert float(field["pressure"].max()) == pytest.approx(largest, rel=0.01)
    assert float(field["film"].min()) == pytest.approx(thinnest, rel=0.02)
    # Hertz's ellipse is swept along the line that the contact point takes
    for phase in (0.1, 0.37, 0.62, 0.9):
        at = field["pressure"].sel(
            face=0.02 * (phase - 0.5), radius=0.27 - 0.015 * (phase - 0.5), method="nearest"
        )
        assert float(at) == pytest.approx(largest, rel=0.02)
    passed = np.isfinite(field["pressure"].values)
    a = 0.5 * whole.solutions[0].figures.dry.length
    reach = 0.02 * (PHASES[-1] - PHASES[0]) / 2 + a
    face = field["face"].values[passed.any(axis=0)]
    assert face[0] == pytest.approx(-reach, abs=1e-3)
    # no gaps between the phases solved
    rows = passed[:, passed.any(axis=0)]
    for column in rows.T:
        inside = np.flatnonzero(column)
        assert inside.size == inside[-1] - inside[0] + 1


def heated_in(result, *numbers):
    """The result with temperatures in some phases alone, by number."""
    cold = [one.fields.drop_vars(HEATED) for one in result.solutions]
    return replace(
        result,
        solutions=tuple(
            one if number in numbers else replace(one, fields=cold[number])
            for number, one in enumerate(result.solutions)
        ),
    )


@pytest.fixture
def coarse_map(monkeypatch):
    """Fewer nodes of solutions on the flank, in tests that compare maps of the same nodes."""
    monkeypatch.setattr("pyworm.result.flank_map.NODES", (100, 50))


@pytest.mark.usefixtures("coarse_map")
def test_the_flank_keeps_temperatures_of_the_phases_that_simulated_heat():
    """Drive 4 of seed 82001 neglected heat in some of its phases; its map ended in a KeyError."""
    whole = cycle_result(PHASES[::3])
    of_whole = flank_map(whole)
    everywhere = of_whole["temperature_middle"]
    mapped = [flank_map(heated_in(whole, *numbers)) for numbers in ((0, 1), (1,), (0, 1, 3), ())]
    places = [np.isfinite(of["temperature_middle"]).values for of in mapped[:3]]
    assert 0 < places[1].sum() < places[0].sum() < places[2].sum() < np.isfinite(everywhere).sum()
    for field, there in zip(mapped, places, strict=False):
        some = field["temperature_middle"].values[there]
        assert np.all(some <= everywhere.values[there] * (1 + 1e-12))
        assert some.max() == pytest.approx(float(everywhere.max()), rel=1e-3)
    assert "temperature_middle" not in mapped[-1]
    for field in mapped:
        assert field["pressure"].equals(of_whole["pressure"])


def ending_in_the_contact(result, phase):
    """The result with teeth that end within the contacts from a phase on; pressures and films stay."""
    return replace(
        result,
        solutions=tuple(
            replace(one, fields=one.fields.isel(tooth_x=slice(0, 3), tooth_y=slice(1, 3)))
            if one.phase >= phase
            else one
            for one in result.solutions
        ),
    )


def test_places_on_a_flank_go_straight_on_beyond_the_tooth():
    whole = cycle_solution(0.7)
    x, y = np.meshgrid(np.linspace(-0.02, 0.02, 5), [-0.005, 0.01])
    short = whole.fields.isel(tooth_x=slice(0, 3), tooth_y=slice(1, 3))
    for one in (whole, replace(whole, fields=short)):
        face, radius = flank_place(one, x, y)
        assert face == pytest.approx(x + 0.02 * 0.2, abs=1e-15)
        assert radius == pytest.approx(0.27 + y - 0.015 * 0.2, abs=1e-15)


@pytest.mark.usefixtures("coarse_map")
def test_the_flank_is_mapped_where_contacts_move_over_the_edge_of_a_tooth():
    """Places on the common grid of all phases lie beyond the tooth of some of them."""
    whole = cycle_result(PHASES[::3])
    field, short = flank_map(whole), flank_map(ending_in_the_contact(whole, 0.5))
    assert np.isfinite(short["pressure"]).sum() > 1000
    for name in field:
        assert short[name].values == pytest.approx(field[name].values, rel=1e-9, nan_ok=True)


@pytest.mark.usefixtures("coarse_map")
def test_a_flank_continued_through_the_other_one_is_no_film():
    """Beyond a flank's end, at -1 um; phases before and after press on the same places."""
    whole = cycle_result(PHASES[::3])
    *others, last = whole.solutions
    covered = last.fields["covered"].where(last.fields["x"] < 0.3 * last.fields["x"].max(), 0)
    film = last.fields["film"].where(covered == 1, -1e-6)
    last = replace(last, fields=last.fields.assign(film=film, covered=covered))
    field = flank_map(replace(whole, solutions=(*others, last)))
    thinnest = min(
        float(one.fields["film"].where(one.fields["covered"] == 1).min()) for one in (*others, last)
    )
    assert float(field["film"].min()) == pytest.approx(thinnest, rel=0.02)


@pytest.mark.usefixtures("coarse_map")
def test_wear_is_found_where_contacts_move_over_the_edge_of_a_tooth():
    whole = cycle_result(PHASES[::3])
    rough = replace(
        whole,
        solutions=tuple(
            replace(one, fields=one.fields.assign(asperity_pressure=one.fields["pressure"] / 2))
            for one in whole.solutions
        ),
    )
    grid = flank_grid(rough)
    built, short = (
        asperity_pass(of, grid, 0.1) for of in (rough, ending_in_the_contact(rough, 0.5))
    )
    assert built.volume > 0 and np.isfinite(built.work).all()
    assert short.volume == pytest.approx(built.volume, rel=1e-9)
    assert short.work == pytest.approx(built.work, rel=1e-9, abs=1e-9 * built.work.max())


def test_entry_is_the_speed_at_which_oil_comes_in():
    one = cycle_solution(0.5)
    x, y = np.linspace(-0.012, 0.012, 241), np.linspace(-1.3e-3, 1.3e-3, 131)
    uniform = one.fields.assign(
        entrainment_x=2.0 + 0 * one.fields["film"], entrainment_y=0 * one.fields["film"]
    )
    came = entry(replace(one, fields=uniform), x, y)
    a, b = one.figures.dry.length / 2, one.figures.dry.width / 2
    for place in (0.0, 0.4e-3, -0.8e-3):  # along x, it enters the ellipse at the left end
        at = a * np.sqrt(1 - (place / b) ** 2)
        normal = np.array([at / a**2, -place / b**2])
        expected = normal[0] / np.hypot(*normal)
        row, column = np.argmin(abs(y - place)), np.argmin(abs(x))
        assert came[row, column] == pytest.approx(expected, abs=0.12)
    assert came[0, 0] == 1


def test_pictures_of_the_cycle():
    draw = {name: picture.draw for name, picture in CYCLE_PICTURES.items()}
    whole = cycle_result(PHASES[::6])
    assert any("tooth pair" in axes.get_ylabel() for axes in draw["mesh_cycle"](whole).axes)
    labels = {axes.get_xlabel() for axes in draw["mesh_cycle_flank"](whole).axes}
    assert "face width coordinate / mm" in labels
    assert draw["mesh_cycle_flank"](cycle_result(PHASES[:2])) is None


@pytest.fixture
def worm_case(tmp_path):
    text = (CASES / "zi_drive.toml").read_text()
    for old, new in (
        ('wheel_torque = "4 kN m"', 'worm_torque = "220 N m"\nsharing = "equal"'),
        ("phases = [0.02", "phases = [0.1, 0.2, 0.3]\n# [0.02"),
    ):
        assert old in text
        text = text.replace(old, new)
    (tmp_path / "worm.toml").write_text(text)
    return pyworm.load(tmp_path / "worm.toml")


def test_friction_found_is_fed_back_where_it_moves_the_loads(worm_case, tmp_path, monkeypatch):
    """The solver is replaced by one that always finds a friction of 0.02."""
    ran, said = [], []

    def run(case, tasks, directory, **rest):
        ran.append([task.case.drive.transmission.friction for task in tasks])
        found = replace(cycle_result(PHASES[::6]), case=case.resolved)
        solutions = tuple(
            replace(
                one,
                figures=replace(one.figures, power_loss=Estimate(0.02 * one.load * SLIDING, 0.001)),
            )
            for one in found.solutions
        )
        found = replace(found, solutions=solutions)
        found.save(directory / "result.nc")
        return found

    monkeypatch.setattr(drive_iteration, "run", run)

    def tasks():
        return [Task(worm_case, place, 0.02) for place in worm_case.places()]

    _, solved = drive_iteration.run_balanced(
        worm_case, tasks(), tmp_path, print_message=said.append
    )
    assert ran == [[0.01] * 3, [0.02] * 3]
    assert solved[0].case.drive.transmission.friction == 0.02
    assert said == ["solved again with operation.friction = 0.02"]
    assert case_in(tmp_path / "result.nc")["operation"]["friction"] == 0.02
    # and another run of the same case begins with it
    ran.clear()
    drive_iteration.run_balanced(worm_case, tasks(), tmp_path)
    assert ran == [[0.02] * 3]
    # of a wheel's torque, friction takes little
    wheel = pyworm.load(CASES / "zi_drive.toml")
    more = {"operation": {"friction": 0.02}}
    moved = [
        drive_iteration.load_change(of, of.with_found(more), (0.3, 0.6))
        for of in (wheel, worm_case)
    ]
    assert moved[0] < 0.005 < 0.02 < moved[1]


@pytest.fixture
def lifting(monkeypatch):
    """The solver is replaced by one whose films lift the teeth by 1 to 3 micrometres: what it ran is told."""
    ran = []

    def run(case, tasks, directory, **rest):
        ran.append((tasks[0].accuracy, case.drive.transmission.lifts))
        found = cycle_result([task.place.phase for task in tasks])
        solutions = tuple(
            replace(
                one,
                figures=replace(
                    one.figures,
                    lift=(1 + 2 * one.phase) * 1e-6,
                    power_loss=Estimate(0.01 * one.load * SLIDING, 0.001),
                ),
            )
            for one in found.solutions
        )
        found = replace(
            found,
            case=case.resolved,
            solutions=solutions,
            mesh_cycle=dataset.loaded_cycle_data(case.drive, 0.0),
        )
        found.save(directory / "result.nc")
        return found

    monkeypatch.setattr(drive_iteration, "run", run)
    monkeypatch.setattr(dataset, "LOADED_PHASES", 11)
    return ran


def three_phases(effects):
    """Tasks of three phases of a drive, and what lifts their teeth there."""
    case = pyworm.load(CASES / "zi_drive.toml")
    places = [place for place in case.places() if place.phase in (0.1, 0.34, 0.82)]
    lifts = tuple((place.phase, pytest.approx((1 + 2 * place.phase) * 1e-6)) for place in places)
    return case, [Task(case, place, 0.02, effects) for place in places], lifts


def test_lifts_found_at_low_accuracy_share_the_load(tmp_path, lifting):
    case, tasks, lifts = three_phases(("auto", "-squeeze"))
    said = []
    balanced, _ = drive_iteration.run_balanced(case, tasks, tmp_path, print_message=said.append)
    # lifts of micrometres move loads by more than one estimate settles
    assert lifting == [
        (drive_iteration.ESTIMATE_ACCURACY, ()),
        (drive_iteration.ESTIMATE_ACCURACY, lifts),
        (0.02, lifts),
    ]
    assert "operation.lifts of 1.20 to 2.64 µm" in said[0]
    share, phase = drive_cycle(balanced).lifted
    at = balanced.mesh_cycle.interp(load_phase=phase)
    assert share == pytest.approx(float(at.tooth_load / at.dry_tooth_load) - 1, abs=1e-4)
    # its neighbour, a pitch later in the cycle, has the thicker film
    assert phase == 0.1 and -0.1 < share < -0.01
    # and another run of the same case begins with them
    lifting.clear()
    drive_iteration.run_balanced(case, tasks, tmp_path)
    assert lifting == [(0.02, lifts)]


def test_lifts_of_moving_teeth_come_from_transient_solutions(tmp_path, lifting, monkeypatch):
    """A coarse transient solve gives lifts, and the friction that balances the torques."""
    asked = []

    def lifts_of(tasks, executor):
        asked.append(tasks[0].case.drive.transmission.lifts)
        return {
            task.place.phase: Lift(1e-6 + 1e-5 * task.place.phase, 0.04, 2.0)
            for task in tasks
            if not lost
        }

    monkeypatch.setattr(drive_iteration, "lifts_of", lifts_of)
    monkeypatch.setattr(drive_iteration, "steady_ratios", lambda *given: (1.0, 1.0))
    case, tasks, _ = three_phases("auto")
    lost, said = False, []
    drive_iteration.run_balanced(case, tasks, tmp_path, print_message=said.append)
    lifts = tuple((phase, pytest.approx(1e-6 + 1e-5 * phase)) for phase in (0.1, 0.34, 0.82))
    # they move loads by more than one solve settles
    assert asked[0] == () and asked[1] == lifts and lifting[0] == (0.02, lifts)
    assert "film-induced separation 2.00 to 9.20 µm" in said[0]
    # where none is found they are found with the films, as of drives whose films are steady
    lost = True
    lifting.clear()
    drive_iteration.run_balanced(case, tasks, tmp_path / "lost")
    assert lifting[0] == (0.02, ())


@pytest.mark.usefixtures("coarse_map")
def test_the_flank_has_the_probability_of_pitting():
    """A risk of 1/m2 a pass, in 1e7 passes of 1 mm2: 1 - exp(-1e-6 (1e7)^(10/9)); as drawn."""
    whole = cycle_result(PHASES[::3])
    fields = [one.fields for one in whole.solutions]
    risky = [
        field.assign(
            fatigue_risk_body_2=0 * field["pressure"] + risk, fatigue_ratio_body_2=field["gap"]
        )
        for field, risk in zip(fields, (1e-3, 0.0, 0.0, 0.0, 0.0), strict=False)
    ]
    solutions = [
        replace(one, fields=field) for one, field in zip(whole.solutions, risky, strict=True)
    ]
    field = flank_map(replace(whole, solutions=tuple(solutions)))
    found = field["pitting_probability"]
    exact = 1 - np.exp(-1e-9 * 1e7 ** (10 / 9))
    assert float(found.max()) == pytest.approx(exact, rel=1e-6)
    assert float(found.min()) == 0
    assert np.isnan(found.values).any()
    assert exact < field.attrs["pitting_probability_of_flank"] < 1


@pytest.mark.usefixtures("coarse_map")
def test_the_thread_has_the_probability_of_pitting():
    """Risks of the worm's thread lie at its radii; without fatigue of the worm there is no map."""
    whole = cycle_result(PHASES[::3])
    assert thread_map(whole) is None
    solutions = tuple(
        replace(
            one,
            fields=one.fields.assign(
                fatigue_risk_body_1=0 * one.fields["pressure"] + 1e-3,
                fatigue_ratio_body_1=one.fields["gap"],
                thread_axial=one.fields["tooth_face"],
                thread_radius=one.fields["tooth_radius"] - 0.2,
            ),
        )
        for one in whole.solutions
    )
    risky = replace(whole, solutions=solutions)
    field = thread_map(risky)
    exact = 1 - np.exp(-1e-9 * 1e7 ** (10 / 9))
    assert float(field["pitting_probability"].max()) == pytest.approx(exact, rel=1e-6)
    assert exact < field.attrs["pitting_probability_of_thread"] < 1
    passed = field["thread_radius"].values[
        np.isfinite(field["fatigue_ratio_body_1"].values).any(axis=1)
    ]
    radii = np.concatenate([one.fields["thread_radius"].values for one in solutions])
    assert radii.min() - 1e-3 < passed.min() < passed.max() < radii.max() + 1e-3
    figure = draw_thread(risky)
    assert "of the whole thread" in figure.axes[1].get_title()
    if target := os.environ.get("THREAD54"):
        figure.savefig(target)
