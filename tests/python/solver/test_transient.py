"""Films of contacts that change while oil passes through them."""

from dataclasses import replace
from itertools import pairwise
from math import cos, sin

import numpy as np
import pytest
from line import OILS, line
from plan_scenes import STEEL, mineral, point

import pyworm
from pyworm.io.quantity_text import percent
from pyworm.planning import error_budget
from pyworm.planning.effects.geometry import as_line
from pyworm.planning.expected_work import STEPS_A_TRANSIT
from pyworm.planning.prediction import predicted
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.life import Life, Past, unturned
from pyworm.scene.scales import line_scales
from pyworm.solver.ending import Ending
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.line.level import LineLevel
from pyworm.solver.transient import next_film, rated_films, time_integration, time_steps
from pyworm.solver.transient import transient as transient_module
from pyworm.solver.transient.differences import backward_weights, weights
from pyworm.solver.transient.next_film import NoLoadError
from pyworm.solver.transient.rate_errors import ERROR_SHARE
from pyworm.solver.transient.time_grid import FOLDS, time_grid_of
from pyworm.solver.transient.time_integration import RateOfChange, TimeIntegration
from pyworm.solver.transient.time_records import TimeRecord
from pyworm.solver.transient.transient import Rates

TRANSITS = 5.0
"""Age of the contacts, in transits of the oil through them."""


def ball(speed=1.0, angle=0.0):
    """A ball that rolls at a speed [m/s], in axes turned by an angle [rad]."""
    velocity = speed * cos(angle), -speed * sin(angle)
    return point(
        "ball", (0.02, 0.02), 50.0, (velocity, velocity), (STEEL, STEEL), mineral(0.09, 2e-8)
    )


def lived(contact_ago, axes_ago=unturned):
    """The contact of now, whose life is that of some time before the present [s] -> contact, and axes."""
    age = TRANSITS * predicted(contact_ago(0.0)).transit
    life = Life(
        age, lambda seconds: contact_ago(age - seconds), lambda seconds: axes_ago(age - seconds)
    )
    return replace(contact_ago(0.0), past=Past(life, age))


def solved(scene, effects="isothermal", accuracy=0.05):
    return pyworm.solve(scene, pyworm.plan(scene, accuracy, effects, ("film",)))


def films(solution):
    assert solution.converged, solution.stop_reason
    return {name: getattr(solution.figures, name).value for name in ("film_min", "film_central")}


TURN = 0.5
"""Angle by which axes turn while oil passes [rad]."""


@pytest.mark.parametrize("turn", [pytest.param(0.0, marks=pytest.mark.long), TURN])
def test_a_contact_without_change_is_steady_in_rotating_axes_too(turn):
    rate = turn / predicted(ball()).transit

    def axes(back):
        angle = -rate * back
        return np.array([[cos(angle), sin(angle), 0], [-sin(angle), cos(angle), 0], [0, 0, 1]])

    contact = lived(lambda back: ball(angle=-rate * back), axes)
    transient = solved(contact, ("isothermal", "squeeze"))
    assert films(transient) == pytest.approx(films(solved(ball())), rel=0.004)


def test_the_start_of_a_transient_is_forgotten():
    transit = predicted(ball()).transit
    contact = lived(lambda back: ball(1.0 if back < 1.5 * transit else 0.8))
    transient = solved(contact, ("isothermal", "squeeze"))
    assert films(transient) == pytest.approx(films(solved(ball())), rel=0.01)


@pytest.mark.parametrize(
    "kind", [pytest.param(lambda scene: scene, marks=pytest.mark.long), as_line]
)
def test_oil_carries_its_film_through_the_contact(kind):
    """Each place keeps the film of the speed at which its oil came in: later ones that of a lower speed."""
    of = predicted(kind(ball()))
    slowing = lived(lambda back: kind(ball(1 - 0.1 * back / of.transit)))
    middle = {"x": [-of.half_width / 2, 0.0, of.half_width / 2]} | (
        {} if kind is as_line else {"y": 0.0}
    )
    now, then, transient = (
        solved(scene, effects).fields["film"].interp(middle).values
        for scene, effects in (
            (kind(ball()), "isothermal"),
            (kind(ball(0.95)), "isothermal"),
            (slowing, ("isothermal", "squeeze")),
        )
    )
    # 0.95 is half a passage ago, and so far lie these places apart
    assert np.diff(now - transient) == pytest.approx(
        np.diff(now - then) + (now - then)[1] / 2, rel=0.1
    )


def test_rates_of_change_are_exact_for_polynomials():
    """Of cubics from four times, of parabolas from three, of straight lines from two."""
    times = [0.1, 0.35, 0.9, 1.6]  # before the present
    for count in (2, 3, 4):
        used = times[:count]
        for power in range(count):
            values = [(-time) ** power for time in used]
            slope = power * (-used[0]) ** (power - 1) if power else 0.0
            of_value, of_rate = weights([-time for time in used], -used[0])
            assert of_rate @ values == pytest.approx(slope, abs=1e-12)
            assert of_value @ values == pytest.approx(values[0], abs=1e-12)


def test_backward_differences_are_exact_for_parabolas():
    times = [-0.1, -0.35, -0.9, -1.6]
    for count in (2, 3, 4):
        for power in range(min(count, 3)):
            values = [time**power for time in times[:count]]
            slope = power * times[0] ** (power - 1) if power else 0.0
            assert backward_weights(times[:count]) @ values == pytest.approx(slope, abs=1e-12)


def test_backward_differences_let_no_wave_grow():
    """Oil carries waves, u h_x = -h_t: they grow along its way where the real part of h_t / h is negative."""
    angles = np.linspace(0.01, np.pi, 300)  # of one time step
    waves = np.exp(-1j * np.outer(np.arange(4), angles))
    assert (backward_weights([0.0, -1.0, -2.0, -3.0]) @ waves).real.min() > -1e-12
    assert (weights([0.0, -1.0, -2.0, -3.0], 0.0)[1] @ waves).real.min() < -0.08


def test_steps_to_wanted_times_are_half_to_one_and_a_half_steps_long():
    wanted = [-1.0, 0.0, 0.2, 1.4, 1.5, 2.6]
    turns = time_integration._turns([0.0, 1.0, 2.0, 3.0], wanted)
    assert turns == {0.0: [0.0, 0.2, 1.4], 1.0: [1.5], 2.0: [2.6]}


def test_thin_films_under_high_pressure_stay_free_of_waves():
    """Under a blow the least film falls by an eighth; waves of six time steps once halved it."""
    steady = line(200.0, 10.0, OILS["incompressible"])
    transit = 2 * line_scales(steady).hertz.half_width / steady.entrainment

    def contact_at(seconds):
        blow = np.sin(np.pi * seconds / transit) ** 2 if transit < seconds < 2 * transit else 0.0
        return replace(steady, load=steady.load * (1 + 0.3 * blow))

    life = Life(3 * transit, contact_at, kinks=(transit, 2 * transit))
    present = replace(contact_at(2.5 * transit), past=Past(life, 2.5 * transit))
    plan = pyworm.plan(present, 0.05, ("isothermal", "squeeze"), ("film",))
    films_of_time = [
        np.array([one.figures["film_min"] for one in found.records])
        for found in (
            time_integration.integrate_in_time(
                time_grid_of(life, plan), refinement, 0.0, [2.5 * transit], 2.9 * transit
            )
            for refinement in (0, 1)
        )
    ]
    least, finer = (of.min() / of[0] for of in films_of_time)
    assert least == pytest.approx(finer, rel=0.02)
    assert 0.8 < finer < 0.95


@pytest.mark.parametrize(
    ("kind", "accuracy", "within"),
    [
        (as_line, 0.05, 0.02),
        pytest.param(lambda scene: scene, 0.02, 0.03, marks=pytest.mark.long),
    ],
    ids=["line", "point"],
)
def test_films_travel_with_the_oil(kind, accuracy, within):
    """d(rho h)/dt + u d(rho h)/dx = 0 where the oil is too thick for pressure to drive it.

    The speed of a contact rises by a tenth while oil passes: what is at a place now was upstream before.
    """
    of = predicted(kind(ball()))
    rise = 0.1 / of.transit
    places = {"x": [-of.half_width / 2, of.half_width / 2]} | (
        {} if kind is as_line else {"y": 0.0}
    )

    def rho_h(ago):
        """At half a half-width before and behind the middle, some time before the present."""
        scene = lived(lambda back: kind(ball(1 - rise * (back + ago))))
        there = (
            solved(scene, ("isothermal", "squeeze"), accuracy)
            .fields[["film", "pressure"]]
            .interp(places)
        )
        return there["film"].values * scene.oil.density(there["pressure"].values)

    # oil moves by t - rise t2/2 in a time t before the present
    seconds = (1 - (1 - 2 * rise * of.half_width) ** 0.5) / rise
    now, then = rho_h(0.0), rho_h(seconds)
    assert now[1] - now[0] == pytest.approx(then[0] - now[0], rel=within)


def test_a_past_whose_film_is_not_found_is_reported(monkeypatch):
    monkeypatch.setattr(next_film, "MAX_TRANSIENT_RESIDUAL", 0.0)
    transient = solved(lived(lambda back: as_line(ball())), ("isothermal", "squeeze"))
    assert not transient.converged and "found no converged film" in transient.stop_reason
    assert transient.ending is Ending.RATE_OF_CHANGE
    assert transient.figures.film_min.error == np.inf


@pytest.mark.parametrize("left, ending", [(0.15, Ending.WIDER_BARS), (0.4, Ending.RATE_OF_CHANGE)])
def test_a_rate_less_accurate_than_asked_for_is_used_with_wider_bars(left, ending, monkeypatch):
    """Up to what leaves a film of use; its figures have that error, and those of the grids."""

    def errors(readings, *others):
        return dict.fromkeys(readings[-1].figures, left)

    monkeypatch.setattr(rated_films, "rate_errors", errors)
    monkeypatch.setattr(transient_module, "MAX_SOLVES", 2)
    solution = solved(lived(lambda back: as_line(ball(1 - 200 * back))), ("isothermal", "squeeze"))
    assert solution.ending is ending
    assert solution.converged == (ending is Ending.WIDER_BARS)
    assert f"leaves an error of {percent(left)}" in solution.stop_reason
    assert solution.accuracy == 0.05 and not solution.accurate
    if solution.converged:
        assert left < solution.figures.film_min.error < 1.3 * left


def test_a_rate_beyond_its_share_leaves_an_accurate_film_if_all_errors_are_within(monkeypatch):
    def errors(readings, *others):
        return dict.fromkeys(readings[-1].figures, 0.042)

    monkeypatch.setattr(rated_films, "rate_errors", errors)
    monkeypatch.setattr(transient_module, "MAX_SOLVES", 2)
    solution = solved(lived(lambda back: as_line(ball(1 - 200 * back))), ("isothermal", "squeeze"))
    assert error_budget.TIME * 0.05 < 0.042 < solution.figures.film_min.error < 0.05
    assert solution.ending is Ending.ACCURATE and solution.accurate


@pytest.mark.parametrize("conduction, solves, accurate", [(0.034, 3, True), (0.042, 2, False)])
def test_one_more_transient_solution_follows_where_grids_cannot_bring_the_accuracy(
    conduction, solves, accurate, monkeypatch
):
    """With another error that grids do not reduce it exceeds the accuracy; alone it has its share."""

    def errors(readings, *others):
        return dict.fromkeys(readings[-1].figures, 0.038 if len(readings) <= 3 else 0.01)

    monkeypatch.setattr(rated_films, "rate_errors", errors)
    monkeypatch.setattr(LineLevel, "conduction_errors", lambda level: {"film_central": conduction})
    solution = solved(lived(lambda back: as_line(ball(1 - 200 * back))), ("isothermal", "squeeze"))
    assert solution.cost.transient_solves == solves
    assert solution.accurate is accurate and solution.converged
    assert accurate or "grid refinement does not reduce the error" in solution.stop_reason


def test_temperatures_of_no_use_do_not_widen_the_bars_of_films():
    scene = ball()
    plan = pyworm.plan(scene, 0.05, "all")
    level = SOLVERS[type(scene)](scene, plan).begin(plan.grids)[0]
    known = transient_module.Transient(None, level, {}, "a flaw", film_error=0.07, heat_error=0.9)
    assert known.usable
    attainable = known.attainable(plan)
    assert attainable.accuracy == pytest.approx(0.07 / error_budget.TIME)
    assert not set(HEAT_FIGURES) & set(attainable.target.figures)
    all_of_use = replace(known, heat_error=0.14).attainable(plan)
    assert all_of_use.accuracy == pytest.approx(0.14 / error_budget.TIME)
    assert set(HEAT_FIGURES) <= set(all_of_use.target.figures)


@pytest.mark.parametrize("kind", [lambda scene: scene, as_line])
def test_where_no_transient_solution_is_found_a_steady_one_stands_for_it(kind, monkeypatch):
    """Where the accuracy decides upon the effects; the neglected squeeze and its influence are reported."""
    accelerated = lived(lambda back: kind(ball(1 - 200 * back)))
    auto = pyworm.plan(accelerated, 0.05, quantities=("film",))
    assert "squeeze" in auto.on
    monkeypatch.setattr(next_film, "MAX_TRANSIENT_RESIDUAL", 0.0)
    substitute = pyworm.solve(accelerated, auto)
    squeeze = next(effect for effect in substitute.effects if effect.name == "squeeze")
    assert not squeeze.on and "not found: the transient solve found no" in squeeze.reason
    assert squeeze.influence["film"] > 0.05
    assert substitute.neglected_effects.influence["squeeze"] == squeeze.influence["film"]
    simulated = [effect.name for effect in substitute.effects if effect.on]
    steady = solved(replace(accelerated, past=None), simulated)
    assert films(substitute) == pytest.approx(films(steady), rel=1e-3)


def test_a_tooth_pair_s_gap_changes_as_its_flanks_move_past_the_contact_point():
    """Rigid flanks z(x, y, t) that move with u, v, w: dz/dt = w - u dz/dx - v dz/dy."""
    drive = pyworm.load("cases/zi_drive.toml").drive
    contact = drive.contact(0.4)
    across, step, time_level = 1e-3, 1e-6, 1e-5
    x, y = across * np.cos(np.arange(8)), across * np.sin(np.arange(8))
    rates = []
    for motion in drive.motions(contact):
        u, v, w = motion.velocity(x, y)
        places = ((x + step, y), (x - step, y), (x, y + step), (x, y - step))
        east, west, north, south = (motion.flank.solve(*place)[0] for place in places)
        rates.append(w - (u * (east - west) + v * (north - south)) / (2 * step))

    def gap(seconds):
        past = drive.scene(0.4).past
        turn = past.life.turning(past.seconds) * seconds
        there = x * cos(turn) - y * sin(turn), y * cos(turn) + x * sin(turn)
        then = drive.contact(0.4 - seconds * drive.phases_per_second)
        worm, wheel = (motion.flank.solve(*there)[0] for motion in drive.motions(then))
        return wheel - worm

    assert (gap(-time_level) - gap(time_level)) / (2 * time_level) == pytest.approx(
        rates[1] - rates[0], rel=1e-3, abs=1e-6
    )


def test_error_bars_of_transient_films_hold(monkeypatch):
    """The load of a line doubles while oil passes, in eight time steps a transit and in 48."""
    transit = predicted(as_line(ball())).transit

    def heavier(back):
        line = as_line(ball())
        return replace(line, load=line.load * (1.5 - 0.5 * np.tanh((back / transit - 1) / 0.3)))

    scene = lived(heavier)
    fine, steady = (solved(scene, effects) for effects in (("isothermal", "squeeze"), "isothermal"))
    assert films(fine) != pytest.approx(films(steady), rel=0.02)
    monkeypatch.setitem(STEPS_A_TRANSIT, "line", 8)
    rough = solved(scene, ("isothermal", "squeeze"), accuracy=0.5)
    for name, value in films(rough).items():
        assert getattr(rough.figures, name).approximation > 0
        better = getattr(fine.figures, name)
        bars = getattr(rough.figures, name).error + better.error
        assert abs(value - better.value) <= bars * better.value


@pytest.mark.parametrize("what", ["speed", pytest.param("load", marks=pytest.mark.long)])
def test_half_the_spacing_with_half_the_time_step_leaves_a_quarter_of_the_error(monkeypatch, what):
    """Of the film at the contact point, in the mean square over three transits, speed or load swinging."""
    line = as_line(ball())
    transit = predicted(line).transit

    def contact_at(seconds):
        swing = np.sin(seconds / transit)
        return (
            as_line(ball(1 + 0.2 * swing))
            if what == "speed"
            else replace(line, load=line.load * (1 + 0.3 * swing))
        )

    life = Life(6 * transit, contact_at)
    scene = replace(contact_at(6 * transit), past=Past(life, 6 * transit))
    time_grid = time_grid_of(life, pyworm.plan(scene, 0.05, ("isothermal", "squeeze"), ("film",)))
    monkeypatch.setitem(STEPS_A_TRANSIT, "line", 24)
    films = [
        {
            one.seconds: one.figures["film_central"]
            for one in time_integration.integrate_in_time(
                time_grid, refinement, 0.0, [5 * transit]
            ).records
        }
        for refinement in range(3)
    ]
    shared = [at for at in films[0] if 2 * transit < at <= 5 * transit]
    assert len(shared) > 60
    coarse, fine = (
        np.sqrt(np.mean([(after[at] / before[at] - 1) ** 2 for at in shared]))
        for before, after in pairwise(films)
    )
    assert 3 < coarse / fine < 5


@pytest.mark.parametrize("kind", ["point", "line", "written"])
def test_a_further_solve_of_one_point_contact_begins_two_transits_before_it(kind):
    """As long before it as a part of a life; of cheap lines and of what is written at its beginning."""

    def contact_at(seconds):
        contact = ball(1 + 0.2 * np.sin(seconds / transit))
        return as_line(contact) if kind == "line" else contact

    transit = predicted(ball()).transit
    life = Life(6 * transit, contact_at, kinks=(transit,) * (kind == "written"))
    time_grid = time_grid_of(life, pyworm.plan(ball(), 0.05, "isothermal", ("film",)))
    part = transient_module.part_at(time_grid, 5.5 * transit)
    begin = transient_module.begin_of_one(time_grid, 5.5 * transit)
    if kind == "point":
        present = time_grid.transits(5.5 * transit)
        assert part.begin < begin == pytest.approx(present - transient_module.WARM_UP["point"])
    else:
        assert begin == part.begin


def test_a_third_solve_of_a_later_part_begins_on_the_grid_before(monkeypatch):
    """For a transit; another later its films are those of one grid, but for a quarter of what it changes."""

    def contact_at(seconds):
        return as_line(ball(1 + 0.3 * np.sin(seconds / transit)))

    transit = predicted(as_line(ball())).transit
    monkeypatch.setitem(STEPS_A_TRANSIT, "line", 12)
    life = Life(6 * transit, contact_at)
    time_grid = time_grid_of(life, pyworm.plan(contact_at(0.0), 0.05, "isothermal", ("film",)))
    at = time_grid.time_at(4.0)
    steps = time_steps.steps_of(time_grid, 2, 2.0, at)
    coarse = [step for step in steps if step.refinement == 1]
    assert len(coarse) == 24
    assert time_grid.place(steps[24].seconds) == pytest.approx(3.0)
    assert {step.refinement for step in steps[24:]} == {2}
    assert all(before.seconds < after.seconds for before, after in pairwise(steps))
    found = time_integration.integrate_in_time(time_grid, 2, 2.0, [at])
    before = time_integration.integrate_in_time(time_grid, 1, 2.0, [at])
    monkeypatch.setattr(time_steps, "COARSE_FROM", 3)
    alone = time_integration.integrate_in_time(time_grid, 2, 2.0, [at])
    assert len(found.records) == len(alone.records) - 48
    for name in ("film_min", "film_central"):
        by_two, by_one, coarser = (
            np.interp(
                at, [one.seconds for one in of.records], [one.figures[name] for one in of.records]
            )
            for of in (found, alone, before)
        )
        assert abs(by_two / by_one - 1) < 0.25 * abs(coarser / by_one - 1)


@pytest.mark.parametrize(
    "unloaded", [[(0.02, 0.1)], [(0.35, 0.45)], [(0.02, 0.1), (0.4, 0.45)]], ids=str
)
@pytest.mark.parametrize("refinement", [0, 1])
def test_films_go_on_after_a_time_without_load(refinement, unloaded):
    """Those after it begin with a steady one, and nothing changes afterwards; coarse steps may lead to it."""
    transit = predicted(as_line(ball())).transit
    duration = 10 * transit
    gaps = [tuple(share * duration for share in gap) for gap in unloaded]

    def contact_at(seconds):
        if parted(seconds):
            raise ValueError("its neighbours carry all")
        return as_line(ball(1 + 0.2 * np.cos(seconds / transit) * (seconds < gaps[0][0])))

    def parted(seconds):
        return any(begin < seconds < end for begin, end in gaps)

    life = Life(duration, contact_at)
    time_grid = time_grid_of(life, pyworm.plan(contact_at(0.0), 0.05, "isothermal", ("film",)))
    early, late = 0.3 * duration, 0.7 * duration
    found = time_integration.integrate_in_time(time_grid, refinement, 0.0, [early, late])
    assert set(found.rates) == {early, late}
    assert not any(parted(record.seconds) for record in found.records)
    film = found.records[-1].figures["film_central"]
    least = 1e-3 * film / transit
    assert np.abs(found.rates[late].rate).max() < least
    assert (np.abs(found.rates[early].rate).max() < least) == (early > gaps[0][1])


def test_a_time_without_load_has_no_film():
    transit = predicted(as_line(ball())).transit

    def contact_at(seconds):
        if seconds > 2 * transit:
            raise ValueError("its neighbours carry all")
        return as_line(ball())

    whole = Life(10 * transit, lambda seconds: as_line(ball()))
    time_grid = time_grid_of(whole, pyworm.plan(as_line(ball()), 0.05, "isothermal", ("film",)))
    time_grid = replace(time_grid, life=Life(10 * transit, contact_at))
    found = time_integration.integrate_in_time(time_grid, 0, 0.0, [5 * transit])
    assert not found.rates and 2 * transit < found.unloaded < 2.2 * transit
    assert found.failure is not None and found.failure.endswith("its neighbours carry all")


@pytest.mark.parametrize("back", [2.4, 6.0])
def test_where_load_is_lost_while_coarse_steps_lead_the_films_begin_after_it(monkeypatch, back):
    transit = predicted(as_line(ball())).transit

    def contact_at(seconds):
        if 2.2 < time_grid.place(seconds) < back:
            raise ValueError("its neighbours carry all")
        return as_line(ball())

    monkeypatch.setitem(STEPS_A_TRANSIT, "line", 12)
    whole = Life(6 * transit, lambda seconds: as_line(ball()))
    time_grid = time_grid_of(whole, pyworm.plan(as_line(ball()), 0.05, "isothermal", ("film",)))
    parted = replace(time_grid, life=Life(6 * transit, contact_at))
    at = time_grid.time_at(4.0)
    if back < 4:
        found = time_integration.integrate_in_time(parted, 2, 2.0, [at])
        assert at in found.rates and time_grid.place(found.records[0].seconds) > back
    else:
        with pytest.raises(NoLoadError, match="its neighbours carry all") as lost:
            time_integration.integrate_in_time(parted, 2, 2.0, [at])
        assert 2.2 < time_grid.place(lost.value.seconds) < 2.3


def test_as_the_load_of_a_tooth_pair_falls_by_an_e_fold_a_time_step_s_share_of_a_transit_passes():
    """Its last ones, where oil passes the shrinking contact more slowly than the load falls."""
    steady = as_line(ball())
    transit = predicted(steady).transit

    def falling(folds):
        life = Life(
            8 * transit,
            lambda at: replace(steady, load=steady.load * np.exp(-folds * at / transit)),
        )
        time_grid = time_grid_of(life, pyworm.plan(steady, 0.05, "isothermal", ("film",)))
        return time_grid.transits(time_grid.end)

    assert falling(4.0) == pytest.approx(4.0 / FOLDS * 8, rel=0.5)
    assert falling(0.01) == pytest.approx(8.0, rel=0.05)


@pytest.mark.parametrize(
    ("ago", "limited", "share"),
    [(1.0, False, 1.5), (3.0, False, ERROR_SHARE["point"]), (3.0, True, 1.5)],
)
def test_where_films_settle_slowly_the_error_is_one_and_a_half_of_the_last_change(
    ago, limited, share
):
    """Some lengths of a ball's contact ago, oil carries a dip as narrow as the grid; it leaves after two.

    So it is where the rate of change is limited.
    """
    transit = predicted(ball()).transit
    scene = lived(lambda back: ball())
    plan = pyworm.plan(scene, 0.05, ("isothermal", "squeeze"), ("film",))
    grid = plan.grids[-1]
    backs = np.arange(4 * TRANSITS, -1, -1) * transit / 4
    film = predicted(scene).film_central
    figures = {"film_min": film, "film_central": film}
    records = tuple(
        TimeRecord(
            TRANSITS * transit - back,
            None,
            scene.load,
            (1.0 - 2 * (back > ago * transit), 0.0),
            figures,
        )
        for back in backs
    )
    rates = tuple(
        RateOfChange(grid, np.full(grid.shape, part * film / transit), limited=limited)
        for part in (0.02, 0.04)
    )
    one, two = (
        transient_module.transient(scene, plan, Rates(rates[:count], (records,) * count))
        for count in (1, 2)
    )
    before, after = (of.level.read().figures for of in (one, two))
    changed = max(abs(before[name] / after[name] - 1) for name in ("film_min", "film_central"))
    assert changed > 0.01
    assert two.errors["film_min"] == pytest.approx(share * changed)


def test_films_of_three_solves_take_the_rate_to_which_their_rates_of_change_converge():
    """The first two are off by four and two times what the third is: first order."""
    scene = lived(lambda back: ball())
    plan = pyworm.plan(scene, 0.05, ("isothermal", "squeeze"), ("film",))
    grid, of = plan.grids[-1], predicted(ball())
    films = dict.fromkeys(("film_min", "film_central"), of.film_central)
    records = (TimeRecord(TRANSITS * of.transit, None, 50.0, (1.0, 0.0), films),)

    def found(*parts):
        """Rates that are a share of a film in a transit."""
        fields = (np.full(grid.shape, part * of.film_central / of.transit) for part in parts)
        rates = tuple(RateOfChange(grid, field) for field in fields)
        return transient_module.transient(scene, plan, Rates(rates, (records,) * len(rates)))

    exact, plain, three = found(0.04), found(0.05), found(0.08, 0.06, 0.05)
    of_exact, of_plain, of_three = (one.level.read().film_central for one in (exact, plain, three))
    assert abs(of_plain / of_exact - 1) > 5e-3
    assert of_three == pytest.approx(of_exact, rel=3e-4)
    assert abs(of_three / of_exact - 1) < three.errors["film_central"] < 5e-3


def test_films_whose_first_grid_leaves_too_much_are_judged_on_finer_grids():
    """Down to the spacing of the last transient solve; no finer one is judged where the first will do."""
    scene = lived(lambda back: ball())
    plan = pyworm.plan(scene, 0.05, ("isothermal", "squeeze"), ("film",))
    of, grid = predicted(ball()), plan.grids[-1].finer()
    level, _ = SOLVERS[type(scene)](scene, plan).begin(plan.grids)
    figures = dict.fromkeys(("film_min", "film_central"), of.film_central)
    records = (TimeRecord(TRANSITS * of.transit, None, 50.0, (1.0, 0.0), figures),)

    def judged(*parts):
        """The film, and its grids, with rates that are a share of a film in a transit."""
        fields = (np.full(grid.shape, part * of.film_central / of.transit) for part in parts)
        rates = tuple(RateOfChange(grid, field) for field in fields)
        found = transient_module.transient(scene, plan, Rates(rates, (records,) * len(rates)))
        return found, rated_films.rated_films(scene, plan, rates, False, level)

    found, first = judged(0.4, 0.0, 0.3)
    second = first.finer()
    assert not first.within and found.errors == pytest.approx(second.errors, rel=1e-3)
    assert found.errors["film_min"] != pytest.approx(first.errors["film_min"], rel=1e-2)
    assert second.finer() is None and found.level.grid == first.level.grid
    found, first = judged(0.08, 0.06, 0.05)
    assert first.within and found.errors == pytest.approx(first.errors, rel=1e-3)


def test_a_finer_grid_on_which_no_film_is_found_judges_nothing(monkeypatch):
    scene = lived(lambda back: ball())
    plan = pyworm.plan(scene, 0.05, ("isothermal", "squeeze"), ("film",))
    level, _ = SOLVERS[type(scene)](scene, plan).begin(plan.grids)
    grid = plan.grids[-1].finer()
    films = rated_films.rated_films(
        scene, plan, (RateOfChange(grid, np.zeros(grid.shape)),) * 2, False, level
    )
    assert films.finer() is not None
    assert replace(films, plan=replace(plan, tolerance=0.0)).finer() is None
    assert replace(films, plan=replace(plan, largest_grid=level.grid.nodes)).finer() is None
    monkeypatch.setattr(rated_films, "shortage", lambda *of, **how: "memory does not suffice")
    assert films.finer() is None


def test_time_steps_are_half_as_long_where_the_entrainment_turns_round():
    def step(contact_ago):
        scene = lived(contact_ago)
        return time_grid_of(scene.past.life, pyworm.plan(scene, 0.05, "isothermal")).step(0)

    age = TRANSITS * predicted(ball()).transit
    turning = step(lambda back: ball(1 - 2 * back / age))
    assert turning == step(lambda back: ball()) / 2


@pytest.mark.parametrize(("after", "solves"), [(1.0, 2), (3.0, 1)])
def test_a_life_begins_later_only_where_films_are_lost_soon_after_the_first_touch(
    monkeypatch, after, solves
):
    transit = predicted(as_line(ball())).transit
    life = Life(8 * transit, lambda at: as_line(ball()), touched=transit)
    time_grid = time_grid_of(life, pyworm.plan(as_line(ball()), 0.05, "isothermal", ("film",)))
    last = time_grid.time_at(time_grid.transits(life.touched) + after)
    asked = []

    def diverged(time_grid, steps, *how):
        asked.append(steps)
        return TimeIntegration(
            {}, {}, (TimeRecord(last, None, 1.0, (1.0,), {}),), 1, failure="no film"
        )

    monkeypatch.setattr(time_integration, "_through", diverged)
    assert (
        time_integration.integrate_in_time(time_grid, 0, 0.0, [life.duration]).failure == "no film"
    )
    # and once more after the last film that was found
    assert len(asked) == solves + 1
    assert all(step.seconds > last for step in asked[-1])


def test_an_accelerated_line_has_the_film_of_its_inlet_s_time():
    """Sugimura, Okumura, Yamamoto and Spikes (1999, Tribology International 32, 117-123).

    The film at a place is the steady one of the speed at which its oil passed the inlet; by squeeze, which
    they leave out, films under acceleration are somewhat thinner.
    """
    first, rise = 0.5, 0.25  # m/s, and that in a passage of the line at 1 m/s
    of = predicted(as_line(ball()))
    acceleration = rise / of.transit

    def speed(seconds):
        return first + acceleration * seconds

    def way(seconds):
        return first * seconds + acceleration * seconds**2 / 2

    duration = 4 * of.transit
    life = Life(duration, lambda seconds: as_line(ball(speed(seconds))))
    scene = replace(as_line(ball(speed(duration))), past=Past(life, duration))
    time_grid = time_grid_of(life, pyworm.plan(scene, 0.05, ("isothermal", "squeeze"), ("film",)))
    records = time_integration.integrate_in_time(time_grid, 1, 0.0, [0.95 * duration]).records
    speeds = np.array([0.4, 0.8, 1.6])
    steady_films = [
        films(solved(as_line(ball(one)), accuracy=0.01))["film_central"] for one in speeds
    ]
    steady = np.polynomial.Polynomial.fit(np.log(speeds), np.log(steady_films), 2)
    for one in records[::20]:
        if way(one.seconds) < 1.5 * of.half_width:  # oil that was in the contact when it began
            continue
        # its root: the time at which the oil in the middle was half a width before it
        entry = (
            np.sqrt(first**2 + 2 * acceleration * (way(one.seconds) - of.half_width)) - first
        ) / (acceleration)
        carried, present = (np.exp(steady(np.log(speed(at)))) for at in (entry, one.seconds))
        film = one.figures["film_central"]
        assert 0 < 1 - film / carried < 0.06
        assert 1 - film / carried < 0.4 * (1 - film / present)


def test_the_grid_of_a_line_reaches_beyond_its_contact_under_a_blow():
    """The load doubles and falls back within a transit, faster than the grid's spacing follows."""
    steady = line(50.0, 5.0, OILS["compressible"])
    half_width = line_scales(steady).hertz.half_width
    transit = 2 * half_width / steady.entrainment

    def contact_at(seconds):
        blow = np.sin(np.pi * seconds / transit) ** 2 if transit < seconds < 2 * transit else 0.0
        return replace(steady, load=steady.load * (1 + blow))

    life = Life(3 * transit, contact_at, kinks=(transit, 2 * transit))
    present = replace(contact_at(1.75 * transit), past=Past(life, 1.75 * transit))
    time_grid = time_grid_of(life, pyworm.plan(present, 0.05, ("isothermal", "squeeze"), ("film",)))
    ends = np.abs(time_grid.grid(1.5 * transit, 0).x[[0, -1]])
    assert min(ends) > 1.05 * 2**0.5 * half_width
    under_the_blow = films(solved(present, ("isothermal", "squeeze")))["film_central"]
    # oil that came in as the edge went to meet it has reached the middle: it is thicker than before
    assert under_the_blow > 1.05 * films(solved(steady))["film_central"]
