"""The wear of a case: a worn flank, what is kept, where an integration goes on; contacts are stood in for."""

import itertools
import json
from types import SimpleNamespace

import numpy as np
import pytest
from folders import DATA
from full_disk import Disk, files, refusals

import pyworm
from pyworm.batch import wear_run
from pyworm.batch.task import Task
from pyworm.batch.wear_run import STATE, WearPlan, WearRun
from pyworm.cli.main import main
from pyworm.cli.shared import FAILED
from pyworm.plots.wear import draw_wear
from pyworm.result.flank_wear import FlankGrid, Pass

DATA = DATA / "zi_a100.toml"
GRID = FlankGrid(np.linspace(-6e-3, 6e-3, 25), np.linspace(81e-3, 85e-3, 9))


@pytest.fixture(scope="module")
def case():
    return pyworm.load(DATA)


@pytest.fixture
def contacts(monkeypatch):
    """Work of asperities that falls with the roughness as contacts do; the cases that were solved."""
    solved = []

    def run(case, tasks, directory, **how):
        solved.append(case)
        deviations = case.tables.drive.wheel.deviations
        worn = 0.0 if deviations is None else -np.min(deviations.deviation)
        cycle_data = {"wheel_turn": np.full(5, 2e-4 + worn / 75e-3)}
        sound = SimpleNamespace(solutions=(one,))
        return SimpleNamespace(sound=sound, case=case, mesh_cycle=cycle_data), tasks

    def work(result, grid, rate, side="wheel"):
        rough = result.case.tables.bodies.wheel.roughness
        middle = np.exp(-((grid.face / 2e-3) ** 2))[None, :] * np.ones((len(grid.radius), 1))
        built = 3e6 * (rough / 0.6e-6) ** 3 * middle
        return Pass(built, float(built.sum() * grid.cell))

    one = SimpleNamespace(
        figures=SimpleNamespace(
            asperity_load_fraction=SimpleNamespace(value=0.3), film_min=SimpleNamespace(value=2e-7)
        )
    )
    cycle = SimpleNamespace(loss=SimpleNamespace(friction=0.03), lifts=())
    monkeypatch.setattr(wear_run, "run_balanced", run)
    monkeypatch.setattr(wear_run, "flank_grid", lambda result, side="wheel": GRID)
    monkeypatch.setattr(wear_run, "asperity_pass", work)
    monkeypatch.setattr(wear_run, "drive_cycle", lambda result: cycle)
    return solved


def wear(case, directory, hours=200.0, **plan):
    tasks = [Task(case, place, 0.1) for place in case.places()]
    return WearRun(case, tasks, WearPlan(hours, **plan), directory).run()


def test_a_worn_wheel_has_its_depth_off_its_flank(case):
    """Where it is deepest the gap is wider by that, beyond the map nothing is worn."""
    depth = np.zeros(GRID.shape)
    depth[4, 12] = 3e-6
    worn = case.with_found(case.tables.worn(GRID.face, GRID.radius, depth, (0.3e-6, 0.4e-6))).drive
    deviations = worn.wheel.deviations
    assert deviations.removed(0.0, 83e-3) == pytest.approx(3e-6, rel=1e-6)
    assert deviations.removed(-14e-3, 83e-3) == pytest.approx(0, abs=1e-9)
    assert worn.bodies[1].roughness == 0.4e-6
    assert worn.bodies[0].roughness == 0.3e-6


def test_depth_volume_and_grams_are_of_the_same_wear(case, contacts, tmp_path):
    """Turns of the wheel times work of a pass times k; density and teeth of the wheel."""
    steps = wear(case, tmp_path)
    assert next(step.hours for step in steps) == 0 and steps[-1].hours == 200
    last = steps[-1]
    with np.load(tmp_path / STATE) as held:
        depths = held["depths"]
    assert len(depths) == len(steps)
    assert last.depth_max_m == pytest.approx(depths[-1].max())
    assert last.volume_m3 == pytest.approx(depths[-1].sum() * GRID.cell, rel=1e-6)
    assert last.mass_kg == pytest.approx(last.volume_m3 * 41 * 8800)


def test_the_worm_loses_its_share_of_the_same_work(case, contacts, tmp_path):
    """Threads as often as the worm turns, teeth as often as the wheel: volumes as the k of both."""
    *_, last = wear(case, tmp_path, worm_ratio=0.02)
    threads, teeth = 2, 41
    assert last.worm_volume_m3 * threads == pytest.approx(0.02 * last.volume_m3 * teeth)
    assert last.worm_mass_kg == pytest.approx(last.worm_volume_m3 * threads * 7850)
    with np.load(tmp_path / STATE) as held:
        depth = held["worm_depth"]
    # the contacts that stand in do the same work on both maps
    assert depth.sum() * GRID.cell == pytest.approx(last.worm_volume_m3, rel=1e-6)
    assert last.worm_depth_max_m == pytest.approx(depth.max())


def test_bodies_without_a_density_weigh_as_steel_and_bronze_do(contacts, tmp_path):
    """As oil without heat allows: here the worm has one, and the wheel 8.8 g/cm3."""
    text = (
        DATA.read_text().replace('"7850 kg/m^3"', '"7700 kg/m^3"').replace('density = "8800', "# ")
    )
    model = (DATA.parents[2] / "cases/ellipse10_across.toml").read_text()
    oil = model[model.index("[oil]") :].partition("[numerics]")[0]
    head, _, rest = text.partition("[oil]")
    (tmp_path / "unit.toml").write_text(head + oil + rest[rest.index("[worm_rating]") :])
    *_, last = wear(pyworm.load(tmp_path / "unit.toml"), tmp_path, 10.0)
    assert last.mass_kg == pytest.approx(last.volume_m3 * 41 * 8800)
    assert last.worm_mass_kg == pytest.approx(last.worm_volume_m3 * 2 * 7700)


def test_backlash_is_what_the_wheel_stays_behind_at_its_reference_circle(case, contacts, tmp_path):
    first, *_, last = wear(case, tmp_path)
    assert first.backlash_m == 0
    # the contacts that stand in turn the wheel by the deepest wear over 75 mm
    with np.load(tmp_path / STATE) as held:
        turned = held["turns"]
    assert last.backlash_m == pytest.approx((turned[1] - turned[0]) * 4e-3 * 41 / 2, rel=1e-9)
    assert last.backlash_m > 0.5 * last.depth_max_m


def test_calibrated_wear_is_what_it_is_calibrated_to(case, contacts, tmp_path):
    """With the roughness run in from the first hour on: its mean depth an hour."""
    run = WearRun(
        case,
        [Task(case, place, 0.1) for place in case.places()],
        WearPlan(100.0, calibrated_to=2e-8, run_in=1.0),
        tmp_path,
    )
    *_, last = run.run()
    assert last.depth_mean_m == pytest.approx(2e-8 * 100, rel=1e-6)
    assert run.coefficient != 7e-18
    again = WearRun(case, run.tasks, WearPlan(120.0, calibrated_to=2e-8, run_in=1.0), tmp_path)
    *_, more = again.run()
    assert again.coefficient == run.coefficient
    assert more.depth_mean_m == pytest.approx(2e-8 * 120, rel=1e-6)


def test_an_integration_ends_where_the_standard_allows_no_more(case, contacts, tmp_path):
    """0.3 m_x cos gamma: told as worn out, with the hours of it; nothing is simulated beyond."""
    steps = wear(case, tmp_path, hours=1e6, tolerance=50e-6)
    limit = case.drive.duty().gear.wear_limit
    assert steps[-1].hours < 1e6 and 0.2 * limit < steps[-1].depth_max_m <= limit


def test_hours_that_are_allowed_follow_from_the_last_rate(case, contacts, tmp_path):
    run = WearRun(
        case,
        [Task(case, place, 0.1) for place in case.places()],
        WearPlan(100.0, run_in=1.0),
        tmp_path,
    )
    *_, last = run.run()
    limit = case.drive.duty().gear.wear_limit
    assert run.hours_allowed == pytest.approx(100 * limit / last.depth_max_m, rel=1e-6)


def test_worn_flanks_may_be_deeper_than_files_of_deviations(case):
    depth = np.full(GRID.shape, 0.3e-3)  # 0.075 modules
    worn = case.with_found(case.tables.worn(GRID.face, GRID.radius, depth, (0.3e-6, 0.4e-6))).drive
    assert worn.wheel.deviations.worn and worn.wheel.deviations.spread > 0.05 * 4e-3
    with pytest.raises(ValueError, match="worn by"):
        case.with_found(
            case.tables.worn(GRID.face, GRID.radius, 5 * depth, (0.3e-6, 0.4e-6))
        ).scene(phase=0.5)


def test_wear_is_drawn(case, contacts, tmp_path):
    run = WearRun(
        case, [Task(case, place, 0.1) for place in case.places()], WearPlan(50.0), tmp_path
    )
    run.run()
    figure = draw_wear("unit", run, 1e-6)
    assert len(figure.axes) >= 8
    labels = {axes.get_ylabel() for axes in figure.axes}
    assert {"wear depth / µm", r"friction coefficient $\mu$", "contact pattern / mm²"} <= labels


def test_the_energy_form_and_the_standards_curve_are_options(monkeypatch, capsys, tmp_path):
    """k = mu/e_R; and the depth that DIN 3996 has for the case, by its hours."""
    built = []

    class StoppedError(Exception):
        pass

    def run(case, tasks, plan, directory, print_message, **how):
        built.append(plan)
        raise StoppedError

    monkeypatch.setattr(wear_run, "WearRun", run)
    for how in (["--energy", "1e16"], ["--calibrate"]):
        with pytest.raises(StoppedError):
            main(["wear", str(DATA), "--hours", "10", "--out", str(tmp_path), *how])
    by_energy, calibrated = built
    assert by_energy.coefficient == pytest.approx(
        pyworm.load(DATA).drive.oil.boundary_friction / 1e16
    )
    assert main(["rate", str(DATA), "--json"]) == 0
    rated = json.loads(capsys.readouterr().out)["ratings"][0]["standard"]
    assert calibrated.calibrated_to * 25000 == pytest.approx(rated["wear_depth_m"])


def test_without_a_rating_there_is_nothing_to_calibrate_to(capsys, tmp_path):
    text = DATA.read_text().partition("[worm_rating]")[0]
    (tmp_path / "unit.toml").write_text(text)
    assert main(["wear", str(tmp_path / "unit.toml"), "--hours", "10", "--calibrate"]) == 2
    assert "--calibrate: needs [worm_rating]" in capsys.readouterr().err


def test_a_roughness_that_stays_wears_as_it_did_at_first(case, contacts, tmp_path):
    *_, last = wear(case, tmp_path, run_in=1.0)
    assert last.depth_max_m == pytest.approx(7e-18 * 3e6 * 1500 * 2 / 41 * 60 * 200, rel=1e-6)


def test_running_in_goes_one_way(case, contacts, tmp_path):
    steps = wear(case, tmp_path)
    heights = [step.wheel_roughness_m for step in steps]
    assert heights[0] == 0.6e-6 and heights[-1] < 0.5e-6
    assert all(after <= before for before, after in itertools.pairwise(heights))
    assert contacts[0].tables.drive.wheel.deviations is None
    assert contacts[-1].tables.drive.wheel.deviations.deviation != ()


def test_a_run_goes_on_where_it_was_stopped(case, contacts, tmp_path):
    whole = wear(case, tmp_path / "whole")
    kept = []

    def stopped(self, worn, error, keep=WearRun._written):
        keep(self, worn, error)
        kept.append(worn)
        if len(kept) == 3:
            raise KeyboardInterrupt

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(WearRun, "_written", stopped)
        with pytest.raises(KeyboardInterrupt):
            wear(case, tmp_path / "stopped")
    again = wear(case, tmp_path / "stopped")
    assert again == whole  # to the last bit


@pytest.mark.parametrize("share", [0.0, 0.3, 0.9, 0.999])
def test_a_damaged_state_is_not_gone_on_with(case, contacts, tmp_path, share):
    whole = wear(case, tmp_path)
    file = tmp_path / STATE
    content = file.read_bytes()
    file.write_bytes(content[: int(share * len(content))])
    assert wear(case, tmp_path) == whole


@pytest.mark.parametrize("name", ["depths", "steps", "turns", "loads", "worm_depth"])
def test_a_state_that_lacks_something_is_not_gone_on_with(case, contacts, tmp_path, name):
    whole = wear(case, tmp_path)
    with np.load(tmp_path / STATE) as held:
        state = dict(held)
    state[name] = state[name][..., :1] if state[name].ndim else "{}"
    np.savez_compressed(tmp_path / STATE, **state)
    assert wear(case, tmp_path) == whole


def test_a_flank_that_is_not_known_everywhere_is_not_gone_on_with(case, contacts, tmp_path):
    whole = wear(case, tmp_path)
    with np.load(tmp_path / STATE) as held:
        state = dict(held)
    state["depths"][-1, 0, 0] = np.nan
    np.savez_compressed(tmp_path / STATE, **state)
    again = wear(case, tmp_path)
    assert again == whole


def test_another_plan_begins_anew(case, contacts, tmp_path):
    wear(case, tmp_path, 20.0)
    more = wear(case, tmp_path, 20.0, coefficient=14e-18)
    assert more[0].hours == 0 and more[0].volume_m3 == 0


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["--hours", "0"], "--hours = 0: must be above zero"),
        (["--hours", "10", "--coefficient", "-1"], "--coefficient = -1: must be above zero"),
        (["--hours", "10", "--worm-ratio", "0"], "--worm-ratio = 0: must be above zero"),
    ],
)
def test_what_cannot_be_worn_is_refused(arguments, sentence, capsys):
    assert main(["wear", str(DATA), *arguments]) == 2
    assert sentence in capsys.readouterr().err


def test_wear_is_of_worm_drives(capsys):
    other = DATA.parents[2] / "cases" / "spur_pair.toml"
    assert main(["wear", str(other), "--hours", "10"]) == 2
    assert "of worm drives only" in capsys.readouterr().err


def on_a_full_disk(room, out, capsys):
    """What `wear` leaves of a directory and says where no file can be longer than so many bytes."""
    out.mkdir()
    (out / "wear.png").write_bytes(b"of an earlier run")
    with Disk(room):
        code = main(["wear", str(DATA), "--hours", "50", "--out", str(out)])
    after = files(out)
    assert not [path for path in after if path.suffix == ".part"]
    assert after[out / "wear.png"] == b"of an earlier run"
    return code, after, refusals(capsys.readouterr().err)


@pytest.mark.parametrize("room", [0, 1000])
def test_a_full_disk_ends_wear_with_its_state_named(contacts, tmp_path, capsys, room):
    code, after, said = on_a_full_disk(room, tmp_path / "out", capsys)
    assert code == FAILED and len(after) == 1
    assert STATE in said[-1] and "File too large" in said[-1], said


def test_where_the_state_fits_and_the_picture_does_not_wear_is_known(contacts, tmp_path, capsys):
    code, after, said = on_a_full_disk(40_000, tmp_path / "out", capsys)
    assert code == FAILED and tmp_path / "out" / STATE in after
    assert "wear.png: cannot be written (File too large)" in said[-1], said


@pytest.mark.long
def test_a_full_disk_ends_wear_of_contacts_that_are_solved(tmp_path, capsys):
    code, after, said = on_a_full_disk(1000, tmp_path / "out", capsys)
    assert code == FAILED and len(after) == 1
    assert str(tmp_path / "out") in said[-1] and "File too large" in said[-1], said
