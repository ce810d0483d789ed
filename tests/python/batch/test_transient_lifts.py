"""Lifts of a drive's teeth by transient films."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from types import SimpleNamespace

import pytest

import pyworm
from pyworm.batch import drive_iteration, tooth_lifts, transient_solutions
from pyworm.batch.task import Task
from pyworm.kernel.core import NOT_CONVERGED, KernelError
from pyworm.planning.expected_work import STEPS_A_TRANSIT
from pyworm.solver.transient.lifts import Lift, moving_lift
from pyworm.solver.transient.next_film import NoFilmError
from pyworm.solver.transient.time_integration import integrate_in_time
from pyworm.solver.transient.transient import present_in_life


class Part:
    """A part of a life whose films find a lift at its phase, or breaks."""

    def __init__(self, phase):
        self.phase = phase

    def __call__(self):
        if self.phase > 0.5:
            raise MemoryError
        return {self.phase: 1e-6}


@pytest.mark.parametrize("processes", [0, 2])
def test_a_part_that_breaks_costs_its_own_lifts_alone(processes, monkeypatch):
    monkeypatch.setattr(tooth_lifts, "PartLifts", Part)
    monkeypatch.setattr(tooth_lifts, "tasks_by_part", lambda tasks: tasks)
    executor = ThreadPoolExecutor(processes) if processes else None
    assert tooth_lifts.lifts_of([0.2, 0.8], executor) == {0.2: 1e-6}


def test_a_film_without_squeeze_is_not_transient_whatever_its_plan():
    assert not transient_solutions.is_transient(SimpleNamespace(effects=("auto", "-squeeze")))


class Films:
    """Coarse transient solves, whose lifts are given."""

    def __init__(self, lifts):
        self.lifts, self.solved, self.compared = lifts, [], []

    def of(self, tasks, executor):
        self.solved.append(tasks)
        return self.lifts

    def ratios_of(self, task, steady, executor):
        self.compared.append((task, steady))
        return 1.2, 0.9


@pytest.fixture
def films(monkeypatch):
    found = Films({phase: Lift(1e-6, 0.02, 3.0) for phase in (1.0, 0.0, 0.5)})
    monkeypatch.setattr(drive_iteration, "lifts_of", found.of)
    monkeypatch.setattr(drive_iteration, "steady_ratios", found.ratios_of)
    return found


def searched(monkeypatch, change):
    """The case that a search by motion ends with, when each solve changes the loads by so much."""
    changes = iter(change)
    monkeypatch.setattr(drive_iteration, "load_change", lambda *given: next(changes))
    case = pyworm.load("cases/zi_drive.toml")
    tasks = [Task(case, place, 0.05) for place in case.places(phase=[0.3, 0.5])]
    search = drive_iteration._Search({"operation": ("lifts", "friction")}, 0.05, print)
    return search._by_motion(case, tasks, None)


def test_a_solve_that_leaves_little_ends_the_search(monkeypatch, films):
    """It leaves a quarter of its change, and half of the accuracy is 2.5 %."""
    operation = searched(monkeypatch, [0.09]).tables.operation
    assert operation.friction == 0.018 and len(films.solved) == 1
    assert operation.lifts == ((0.0, 1.2e-6), (0.5, 1.2e-6), (1.0, 1.2e-6))


def test_the_next_solve_is_under_the_loads_of_the_one_before(monkeypatch, films):
    searched(monkeypatch, [0.11, 0.01])
    before, after = (tasks[0].case.tables.operation.lifts for tasks in films.solved)
    assert before is None and len(after) == 3
    ((task, steady),) = films.compared  # once, of a contact in the middle
    assert (task.place.phase, task.accuracy) == (0.5, 0.05) and steady.place == task.place
    assert steady.accuracy == drive_iteration.ESTIMATE_ACCURACY and "-squeeze" in steady.effects


def test_loads_that_move_far_are_sought_in_three_solves_at_most(monkeypatch, films):
    searched(monkeypatch, [0.9] * 3)
    assert len(films.solved) == drive_iteration.MAX_TRANSIENT_SOLVES == 3


def two_phases(accuracy):
    """Tasks of an isothermal worm gear with time steps and grids of which nothing is asked here."""
    case = pyworm.load("cases/zi_drive.toml").with_found({"operation": {"lifts": ()}})
    how = accuracy, ("isothermal", "squeeze"), ("film",)
    return [Task(case, place, *how) for place in case.places(phase=[0.1, 0.2])]


def test_lifts_come_from_coarse_solves_of_their_life(monkeypatch):
    """They are those of the first solve, of half the spacing and time step, to a fifth."""
    monkeypatch.setitem(STEPS_A_TRANSIT, "point", 6)
    tasks = two_phases(0.05)
    lifts, time_grid = tooth_lifts.lifts_of(tasks, None), tasks[0].time_grid
    seconds = [present_in_life(task.scene).seconds for task in tasks]
    found = integrate_in_time(time_grid, 0, 0.0, seconds)
    for phase, then in zip((0.1, 0.2), seconds, strict=True):
        first = moving_lift(time_grid, then, found.rigid_films[then], found.records).distance
        assert lifts[phase].distance == pytest.approx(first, rel=0.2)


@pytest.mark.parametrize("processes", [0, 2])
def test_steady_films_tell_what_coarse_lifts_lack(processes):
    """Pressure beyond the window of a life is a tenth of a lift, its coarse grid another."""
    executor = ThreadPoolExecutor(processes) if processes else None
    task = two_phases(0.05)[1]
    estimate = drive_iteration.steady(drive_iteration.estimate_of(task))
    lift, friction = tooth_lifts.steady_ratios(task, estimate, executor)
    assert 1.05 < lift < 1.4 and friction == 1.0


@pytest.mark.parametrize(
    ("full", "coarse", "ratio"),
    [(0.02, 0.025, 0.8), (0.02, 0.0, 1), (None, 0.025, 1), (0.02, 0.05, 1), (0.02, 0.009, 1)],
)
def test_steady_films_tell_how_much_friction_is_too_large(full, coarse, ratio, monkeypatch):
    friction = full and SimpleNamespace(value=full)
    solution = SimpleNamespace(figures=SimpleNamespace(lift=3e-6, friction_coefficient=friction))
    steady = SimpleNamespace(solved=lambda: SimpleNamespace(solutions=(solution,)))
    monkeypatch.setattr(tooth_lifts, "steady_lift", lambda *given: Lift(2e-6, coarse))
    found = tooth_lifts.steady_ratios(two_phases(0.05)[1], steady, None)
    assert found == pytest.approx((1.5, ratio))


def test_where_steady_films_are_not_found_lifts_stay_as_they_are(monkeypatch):
    def lost(*given):
        raise NoFilmError("there is none")

    monkeypatch.setattr(tooth_lifts, "steady_lift", lost)
    task = two_phases(0.1)[1]
    assert tooth_lifts.steady_ratios(task, drive_iteration.steady(task), None) == (1.0, 1.0)


def test_a_coarser_time_grid_reaches_as_far():
    """Its cells on each side are half as many, up to multiples of four, eight in all."""
    time_grid = two_phases(0.05)[0].time_grid
    coarser = time_grid.coarser()
    for seconds in (0.0, time_grid.end / 2):
        fine, coarse = time_grid.grid(seconds, 0), coarser.grid(seconds, 0)
        assert coarse.spacing == pytest.approx([2 * step for step in fine.spacing])
        for before, after in zip(fine.box, coarse.box, strict=True):
            assert 0 <= abs(after) - abs(before) + 1e-12 <= 8 * max(coarse.spacing)
    assert coarser.step(1) == time_grid.step(0)


def test_no_lift_is_known_of_films_that_are_not_found(monkeypatch):
    """Of one phase dry bodies do not come together; then there is no film of any."""
    tasks = two_phases(0.05)
    seconds = [present_in_life(task.scene).seconds for task in tasks]

    def integrate_in_time(*given):
        return SimpleNamespace(rigid_films=dict.fromkeys(seconds, 1e-6), records=())

    def moving_lift(time_grid, then, *given):
        if then == seconds[0]:
            raise KernelError(NOT_CONVERGED)
        return Lift(1e-6)

    def lost(*given):
        raise NoFilmError("there is none")

    monkeypatch.setattr(tooth_lifts, "integrate_in_time", integrate_in_time)
    monkeypatch.setattr(tooth_lifts, "moving_lift", moving_lift)
    assert tooth_lifts.lifts_of(tasks, None) == {0.2: Lift(1e-6)}
    monkeypatch.setattr(tooth_lifts, "integrate_in_time", lost)
    assert tooth_lifts.lifts_of(tasks, None) == {}


def test_lifts_are_sought_on_grids_of_moderate_size():
    task = two_phases(0.01)[0]
    estimate = drive_iteration.estimate_of(task)
    assert estimate.plan.largest_grid == drive_iteration.ESTIMATE_GRID < task.plan.largest_grid
    assert estimate.plan.accuracy == 0.1 and not estimate.plan.wider_grids and task.plan.wider_grids
    assert estimate.key != replace(estimate, largest_grid=None).key
