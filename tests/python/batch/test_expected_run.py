"""Expected cost of a run: what is shared counts once, what a case leaves open is searched for before."""

import pytest
from zi_drives import coarse_springs

import pyworm
from pyworm.batch.expected_run import MOVING_PASSES, ExpectedRun, expected_run
from pyworm.batch.task import Task
from pyworm.solver.cost.expected_time import Expectation

PHASES = [0.26, 0.5, 0.74]


def of_run(path, accuracy, effects, **places):
    """Expected cost of contacts of a case."""
    case = pyworm.load(path)
    return expected_run(case, [Task(case, at, accuracy, effects) for at in case.places(**places)])


@pytest.fixture(autouse=True, scope="module")
def coarse_teeth():
    """Fewer phases and loads of tooth springs: what is counted are solves."""
    with pytest.MonkeyPatch.context() as patch:
        coarse_springs(patch)
        yield


def test_phases_of_one_life_share_its_transient_solves():
    expected = of_run(
        "cases/spur_pair.toml", 0.5, ("isothermal", "squeeze"), phase=[0.58, 0.6, 0.62]
    )
    lone = sum(of.seconds for of in expected.each)
    assert max(of.seconds for of in expected.each) < expected.once < lone
    assert expected.search == 0


def test_lifts_are_searched_for_where_they_are_left_open():
    """By coarse transient solves of the life."""
    how = {"path": "cases/zi_drive.toml", "effects": ("isothermal", "squeeze"), "phase": PHASES}
    fine, coarse = (of_run(accuracy=accuracy, **how) for accuracy in (0.05, 0.2))
    assert (MOVING_PASSES - 1) * fine.once < fine.search < 2 * fine.once
    assert 0 < coarse.search < coarse.once < fine.once


def test_flanks_that_take_long_lengthen_the_data_of_a_mesh_cycle():
    case = pyworm.load("cases/zi_drive.toml")
    some = [Expectation(1.0, 1.0, sampling=sampling) for sampling in (1e-6, 3e-6)]
    drive = case.drive
    several, one = (ExpectedRun(case, (), tuple(each), 0.0).cycle for each in (some, some[:1]))
    assert several == pytest.approx(drive.cycle_seconds + drive.cycle_points * 2e-6)
    assert one == 0.0


def test_temperatures_are_searched_for_too():
    cooled = of_run("cases/zi_cooled.toml", 0.05, "isothermal", phase=PHASES)
    given = of_run("cases/zi_drive.toml", 0.05, "isothermal", phase=PHASES)
    assert cooled.search > given.search + cooled.once


def test_a_run_takes_more_than_its_solves():
    """Start, results file and pictures, without which a gear pair is announced in tenths of a second."""
    expected = of_run("cases/spur_pair.toml", 0.5, "isothermal", phase=[0.5])
    assert expected.once < 1 < expected.seconds < 4
