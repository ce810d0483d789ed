"""Lifts of a drive's teeth by transient films."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from types import SimpleNamespace

import pytest

import pyworm
from pyworm.batch import drive_iteration, tooth_lifts, transient_solutions
from pyworm.batch.drive_iteration import Lacking
from pyworm.batch.task import Task
from pyworm.io.kept_arrays import keep
from pyworm.kernel.core import NOT_CONVERGED, KernelError
from pyworm.planning.expected_work import STEPS_A_TRANSIT
from pyworm.solver.transient.lifts import Lift


class Part:
    """A part of a life whose steady film finds a lift at its phase, or breaks."""

    def __init__(self, phase):
        self.phase = phase

    def __call__(self):
        if self.phase > 0.5:
            raise MemoryError
        return {self.phase: 1e-6}


@pytest.mark.parametrize("processes", [0, 2])
def test_a_part_that_breaks_costs_its_own_lifts_alone(processes, monkeypatch):
    monkeypatch.setattr(tooth_lifts, "SteadyLifts", Part)
    monkeypatch.setattr(tooth_lifts, "tasks_by_part", lambda tasks: tasks)
    executor = ThreadPoolExecutor(processes) if processes else None
    assert tooth_lifts.steady_lifts_of([0.2, 0.8], executor) == {0.2: 1e-6}


def test_a_film_without_squeeze_is_not_transient_whatever_its_plan():
    assert not transient_solutions.is_transient(SimpleNamespace(effects=("auto", "-squeeze")))


class Films:
    """First transient solves of phases, whose lifts are given; a phase without one has no film."""

    def __init__(self, lifts):
        self.lifts, self.solved = lifts, []

    def of(self, tasks, directory, executor):
        self.solved.append(tasks)
        for task in tasks:
            keep(directory / f"{task.key}.rate-0.npz", flaw="of no use here")
        return self.lifts


@pytest.fixture
def films(monkeypatch):
    found = Films({phase: Lift(1e-6, 0.02, 3.0) for phase in (1.0, 0.0, 0.5)})
    monkeypatch.setattr(drive_iteration, "moving_lifts_of", found.of)
    return found


def searched(tmp_path, monkeypatch, change, lacking, lifts=((0.5, 1e-6),)):
    """The case that a search by motion ends with, when each solve changes the loads by so much."""
    changes = iter(change)
    monkeypatch.setattr(drive_iteration, "load_change", lambda *given: next(changes))
    case = pyworm.load("cases/zi_drive.toml").with_found({"operation": {"lifts": lifts}})
    tasks = [Task(case, place, 0.05) for place in case.places(phase=[0.3, 0.5])]
    search = drive_iteration._Search({"operation": ("lifts", "friction")}, 0.05, print)
    (tmp_path / "scenes").mkdir()
    return case, search._by_motion(case, tasks, {"directory": tmp_path, "executor": None}, lacking)


def test_what_first_solves_lack_of_a_lift_is_interpolated_between_phases(
    tmp_path, monkeypatch, films
):
    """Steady films find 0.1 and 0.3 um more than those on the first grids, and a tenth less friction."""
    _, found = searched(tmp_path, monkeypatch, [0.2, 0.2], Lacking({0.0: 0.1e-6, 1.0: 0.3e-6}, 0.9))
    operation = found.tables.operation
    assert operation.friction == 0.018
    assert [phase for phase, _ in operation.lifts] == [0.0, 0.5, 1.0]
    assert [lift for _, lift in operation.lifts] == pytest.approx([1.1e-6, 1.2e-6, 1.3e-6])
    # one solve leaves a twentieth of its change, and that under other loads is of no use
    assert len(films.solved) == 1 and not list(tmp_path.rglob("*.npz"))


def solved(phase, friction, slid):
    """A solution by its friction coefficient, if known, and its loss over that [W]."""
    known = [None if friction is None else SimpleNamespace(value=friction * by) for by in (1, slid)]
    figures = SimpleNamespace(friction_coefficient=known[0], power_loss=known[1])
    return SimpleNamespace(phase=phase, figures=figures)


@pytest.mark.parametrize(
    ("frictions", "ratio"), [((0.03, 0.06), 0.04 / 0.025), ((None, None), 1.0)]
)
def test_steady_films_tell_what_first_grids_lack(frictions, ratio):
    """Of two phases, of which the second slides half as far under its load."""
    solutions = [solved(*given) for given in zip((0.2, 0.8), frictions, (100.0, 50.0), strict=True)]
    beside = {0.8: Lift(1.9e-6, 0.03, 1.5), 0.2: Lift(0.8e-6, 0.0225, 2.25)}
    lifts = {0.2: 1e-6, 0.8: 2e-6}
    lacking = drive_iteration._lacking(SimpleNamespace(solutions=solutions), lifts, beside)
    assert lacking.lifts == pytest.approx({0.2: 0.2e-6, 0.8: 0.1e-6})
    assert lacking.friction_ratio == pytest.approx(ratio)


@pytest.mark.usefixtures("films")
def test_a_first_solve_that_hardly_moves_the_loads_is_that_of_the_run(tmp_path, monkeypatch):
    """A quarter of the accuracy is 1.25 %."""
    case, found = searched(tmp_path, monkeypatch, [0.012], Lacking())
    assert found is case and len(list(tmp_path.rglob("*.rate-0.npz"))) == 2


@pytest.mark.usefixtures("films")
def test_lifts_are_known_in_the_end_however_little_they_move_the_loads(tmp_path, monkeypatch):
    case, found = searched(tmp_path, monkeypatch, [0.012] * 3, Lacking(), None)
    assert found.tables.operation.lifts and not case.tables.operation.lifts


def test_loads_that_move_far_are_sought_in_three_solves_at_most(tmp_path, monkeypatch, films):
    case, found = searched(tmp_path, monkeypatch, [0.9] * 6, Lacking())
    assert len(films.solved) == drive_iteration.MAX_TRANSIENT_SOLVES == 3
    assert found.tables.operation.lifts != case.tables.operation.lifts


def two_phases(accuracy):
    """Tasks of an isothermal worm gear with time steps and grids of which nothing is asked here."""
    case = pyworm.load("cases/zi_drive.toml").with_found({"operation": {"lifts": ()}})
    how = accuracy, ("isothermal", "squeeze"), ("film",)
    return [Task(case, place, *how) for place in case.places(phase=[0.1, 0.2])]


def test_lifts_come_from_the_solves_that_a_run_goes_on_from(tmp_path, monkeypatch):
    monkeypatch.setitem(STEPS_A_TRANSIT, "point", 3)
    tasks = two_phases(0.05)
    lifts = tooth_lifts.moving_lifts_of(tasks, tmp_path, None)
    assert sorted(lifts) == [0.1, 0.2] and all(1e-8 < one.distance < 1e-4 for one in lifts.values())
    asked = []

    def integrate_on(time_grid, restart, *given):
        asked.append(restart.step.refinement)
        raise transient_solutions.NoFilmError("there is none")

    monkeypatch.setattr(transient_solutions, "integrate_on", integrate_on)
    transient_solutions.solve_lives(tasks, tmp_path, None, lambda message, share: None)
    assert set(asked) == {0}


def test_no_lift_is_known_of_films_that_are_not_found(tmp_path, monkeypatch):
    """Of the first phase there is no film, and dry bodies of the second do not come together."""
    tasks = two_phases(0.05)

    def integrate_in_time(*given):
        raise transient_solutions.NoFilmError("there is none")

    def moving_lift(*given):
        raise KernelError(NOT_CONVERGED)

    monkeypatch.setattr(transient_solutions, "integrate_in_time", integrate_in_time)
    assert tooth_lifts.moving_lifts_of(tasks, tmp_path, None) == {}
    monkeypatch.setattr(tooth_lifts, "moving_lift", moving_lift)
    left = SimpleNamespace(rigid_film=0.0, records=())
    monkeypatch.setattr(tooth_lifts, "left_for", lambda *given: left)
    assert tooth_lifts.moving_lifts_of(tasks, tmp_path, None) == {}


def test_lifts_are_sought_on_grids_of_moderate_size():
    task = two_phases(0.01)[0]
    estimate = drive_iteration.estimate_of(task)
    assert estimate.plan.largest_grid == drive_iteration.ESTIMATE_GRID < task.plan.largest_grid
    assert estimate.plan.accuracy == 0.1 and not estimate.plan.wider_grids and task.plan.wider_grids
    assert estimate.key != replace(estimate, largest_grid=None).key
