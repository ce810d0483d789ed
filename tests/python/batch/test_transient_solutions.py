"""Transient films that several phases share."""

import numpy as np
import pytest

import pyworm
from pyworm.batch import transient_solutions
from pyworm.batch.case_run import run
from pyworm.batch.task import Task
from pyworm.batch.transient_solutions import RATES, drop_rates, rates_for, solve_lives
from pyworm.planning.expected_work import STEPS_A_TRANSIT
from pyworm.result.life import lives
from pyworm.solver.transient.next_film import NoFilmError
from pyworm.solver.transient.time_integration import integrate_in_time
from pyworm.solver.transient.transient import part_at, rates_at_present

HOW = 0.5, ("isothermal", "squeeze"), ("film",)


@pytest.fixture(autouse=True)
def long_time_steps(monkeypatch):
    """What is tested here does not depend on their accuracy."""
    monkeypatch.setitem(STEPS_A_TRANSIT, "line", 6)


def some_phases(*phases):
    case = pyworm.load("cases/spur_pair.toml")
    return case, [Task(case, place, *HOW) for place in case.places(phase=phases or [0.35, 0.6])]


def test_phases_share_a_life_and_find_what_each_would_alone(tmp_path):
    case, tasks = some_phases()
    together = run(case, tasks, tmp_path).solutions
    assert not list(tmp_path.rglob("*.npz"))
    for task, solution in zip(tasks, together, strict=True):
        alone = pyworm.solve(task.scene, task.plan)
        assert solution.figures.film_min == alone.figures.film_min
        assert solution.figures.film_central == alone.figures.film_central


def test_what_is_left_for_a_task_has_the_heat_of_surfaces_and_oil(tmp_path):
    case = pyworm.load("cases/spur_pair.toml")
    how = 0.5, ("all", "-roughness"), ("film",)
    tasks = [Task(case, place, *how) for place in case.places(phase=[0.35, 0.6])]
    solve_lives(tasks, tmp_path, None, lambda message, share: None)
    (rate,) = rates_for(tasks[0], tmp_path).found
    assert rate.rise.shape == (*rate.rate.shape, 2) and rate.warming.shape[0] == len(rate.rate)
    assert rate.pressing.any() and rate.warming.any()
    (own,) = rates_at_present(tasks[0].scene, tasks[0].plan).found
    for name in RATES:
        assert np.array_equal(getattr(rate, name), getattr(own, name))
    finer = rate.grid.finer()
    stored = rate.stored(finer)
    assert stored.warming.shape == (*finer.shape, rate.warming.shape[-1])
    assert stored.pressing[::2] == pytest.approx(rate.pressing, abs=1e-9 * rate.pressing.max())


def test_a_phase_within_a_time_step_of_the_one_before_belongs_to_the_life(tmp_path):
    (life,) = lives(run(*some_phases(0.35, 0.35001, 0.37), tmp_path))
    assert [one.phase for one in life.solutions] == [0.35, 0.35001, 0.37]
    assert np.all(np.diff(life.seconds) > 0) and not len(life.gaps)


def test_a_damaged_file_of_a_life_counts_as_none(tmp_path):
    _, tasks = some_phases()
    solve_lives(tasks, tmp_path, None, lambda message, share: None)
    assert all(rates_for(task, tmp_path) is not None for task in tasks)
    first, *_ = sorted(tmp_path.glob(f"{tasks[0].key}*"))
    first.write_bytes(first.read_bytes()[:100])
    assert rates_for(tasks[0], tmp_path) is None
    for task in tasks:
        drop_rates(task, tmp_path)
    assert not list(tmp_path.iterdir())


def test_finer_solves_are_not_begun_where_the_first_finds_no_film(tmp_path, monkeypatch):
    begun = []

    def integrate_in_time(time_grid, refinement, *_):
        begun.append(refinement)
        raise NoFilmError("there is none")

    monkeypatch.setattr(transient_solutions, "integrate_in_time", integrate_in_time)
    case = pyworm.load("cases/spur_pair.toml")
    tasks = [Task(case, place, 0.05, *HOW[1:]) for place in case.places(phase=[0.35, 0.6])]
    solve_lives(tasks, tmp_path, None, lambda message, share: None)
    assert begun == [0] * len(begun)
    assert [rates_for(task, tmp_path).flaw for task in tasks] == ["there is none"] * 2


def test_a_point_contact_alone_begins_later_with_the_same_film():
    """With its part of eight transits; all together begin at first touch."""
    case = pyworm.load("cases/zi_drive.toml")
    (place,) = case.places(phase=[0.74])
    task = Task(case, place, 0.2, ("isothermal", "squeeze"), ("film",))
    alone = rates_at_present(task.scene, task.plan)
    seconds = task.scene.past.seconds
    whole = integrate_in_time(task.time_grid, 0, 0.0, [seconds])
    assert alone.begin > 3 and part_at(task.time_grid, seconds).begin == 0
    assert alone.records[0][0].seconds > 2 * whole.records[0].seconds
    now = alone.records[0][-1]
    same = min(whole.records, key=lambda record: abs(record.seconds - now.seconds))
    assert now.figures["film_min"] == pytest.approx(same.figures["film_min"], rel=5e-3)
