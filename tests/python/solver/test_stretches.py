"""Transient solves through stretches of a life, which go on from films of the solve before."""

from dataclasses import replace

import numpy as np
import pytest

import pyworm
from pyworm.batch import transient_solutions
from pyworm.batch.task import Task
from pyworm.batch.transient_solutions import rates_for, solve_lives
from pyworm.io.kept_arrays import keep, kept
from pyworm.planning.expected_work import STEPS_A_TRANSIT
from pyworm.scene.life import Past
from pyworm.solver.cost.expected_motion import motion
from pyworm.solver.cost.expected_time import Expectation, ExpectedStretch, together
from pyworm.solver.transient import transient as transient_module
from pyworm.solver.transient.heat_memory import remembered
from pyworm.solver.transient.next_film import NoFilmError
from pyworm.solver.transient.restart import restart_arrays, restart_from
from pyworm.solver.transient.time_integration import integrate_in_time, integrate_on
from pyworm.solver.transient.time_records import TimeRecord, completed, curves
from pyworm.solver.transient.time_steps import COARSE_WAY, STRETCH, restart_place
from pyworm.solver.transient.transient import rates_at_present

ISOTHERMAL, HEATED = ("isothermal", "squeeze"), ("all", "-roughness")


@pytest.fixture(autouse=True)
def long_time_steps(monkeypatch):
    """What is tested here does not depend on their accuracy."""
    monkeypatch.setitem(STEPS_A_TRANSIT, "point", 6)


def tasks_of(*phases, effects=ISOTHERMAL, accuracy=0.05):
    case = pyworm.load("cases/zi_drive.toml")
    places = case.places(phase=list(phases))
    return [Task(case, place, accuracy, effects, ("film",)) for place in places]


def seconds_of(task):
    return task.scene.past.seconds


def film_at(found, seconds):
    times = [record.seconds for record in found.records]
    return np.interp(seconds, times, [record.figures["film_central"] for record in found.records])


@pytest.mark.parametrize("effects", [ISOTHERMAL, pytest.param(HEATED, marks=pytest.mark.long)])
def test_a_stretch_has_the_films_of_a_longer_solve(effects, monkeypatch):
    """But for a tenth of what the solve before is off by."""
    monkeypatch.setitem(STEPS_A_TRANSIT, "point", 12)
    (task,) = tasks_of(0.5, effects=effects)
    time_grid, at = task.time_grid, seconds_of(task)
    begin = time_grid.place(at) - 3.0
    first = integrate_in_time(time_grid, 0, begin, [at], solves_after=1)
    whole = integrate_in_time(time_grid, 1, begin, [at])
    stretch = integrate_on(time_grid, first.restarts[at], begin, [at])
    assert stretch.newton_steps < whole.newton_steps / 2
    off = film_at(first, at) / film_at(whole, at) - 1
    assert abs(film_at(stretch, at) / film_at(whole, at) - 1) < 0.1 * abs(off)
    rates = [found.rates[at].rate for found in (first, stretch, whole)]
    assert np.abs(rates[1] - rates[2]).max() < 0.1 * np.abs(rates[2]).max()
    shared = {record.seconds for record in first.records} & {one.seconds for one in stretch.records}
    assert len(shared) >= len(stretch.records) // 2
    begun = time_grid.place(first.restarts[at].step.seconds)
    assert begun < time_grid.place(stretch.memory_end) < time_grid.place(at)
    assert begun == pytest.approx(time_grid.place(at) - STRETCH, abs=time_grid.step(0))


@pytest.mark.parametrize("effects", [ISOTHERMAL, HEATED])
def test_films_from_which_a_solve_goes_on_are_kept_to_the_last_bit(tmp_path, effects):
    (task,) = tasks_of(0.5, effects=effects, accuracy=0.2)
    time_grid, at = task.time_grid, seconds_of(task)
    begin = time_grid.place(at) - 2.0
    restart = integrate_in_time(time_grid, 0, begin, [at], solves_after=1).restarts[at]
    keep(tmp_path / "restart.npz", **restart_arrays(restart))
    again = kept(tmp_path / "restart.npz", restart_from)
    assert again.step == restart.step and again.held == restart.held
    assert len(again.heat) == len(restart.heat) and bool(restart.heat) == (effects == HEATED)
    for one, other in zip(again.heat, restart.heat, strict=True):
        assert one.grid == other.grid and one.velocities == other.velocities
        assert np.array_equal(one.flux, other.flux)
    by_both = (integrate_on(time_grid, one, begin, [at]).rates[at] for one in (restart, again))
    assert np.array_equal(*(rate.rate for rate in by_both))


def test_solves_go_on_from_three_quarters_of_the_way_to_a_touch_that_films_remember():
    early, near, late = tasks_of(0.02, 0.1, 0.5)
    time_grid = early.time_grid
    touched = time_grid.place(time_grid.life.touched)
    for task in (early, near):
        for solves, way in ((1, COARSE_WAY), (2, 2 * COARSE_WAY - 1)):
            assert restart_place(time_grid, seconds_of(task), solves) == pytest.approx(
                way * touched
            )
    place = time_grid.place(seconds_of(late))
    assert restart_place(time_grid, seconds_of(late), 2) == pytest.approx(
        place - 2 * STRETCH, abs=1e-3
    )
    assert restart_place(time_grid, time_grid.time_at(0.9 * touched), 1) is None
    without = replace(time_grid, approach=None)
    assert restart_place(without, without.time_at(1.0), 1) is None
    begun = restart_place(without, without.time_at(3.0), 1)
    assert begun == pytest.approx(without.place_before(3.0, STRETCH))
    written = replace(time_grid, life=replace(time_grid.life, kinks=(0.1,)))
    assert restart_place(written, seconds_of(late), 1) is None


def test_contacts_find_in_stretches_what_one_finds_alone(tmp_path):
    tasks = tasks_of(0.3, 0.5)  # the part of eight transits begins with the life
    solve_lives(tasks, tmp_path, None, lambda message, share: None)
    for task in tasks:
        together_, alone = rates_for(task, tmp_path), rates_at_present(task.scene, task.plan)
        assert len(together_.found) == len(alone.found) == 2
        for one, other in zip(together_.found, alone.found, strict=True):
            largest = np.abs(other.rate).max()
            assert np.abs(one.rate - other.rate).max() < 0.02 * largest
        assert all(len(records) > 20 for records in together_.records)


def test_a_film_that_is_lost_in_a_stretch_costs_no_other_one(tmp_path, monkeypatch):
    tasks = tasks_of(0.34, 0.38, 0.5)
    lost, solved = seconds_of(tasks[0]), []

    def on(time_grid, restart, begin, wanted, after):
        solved.append(list(wanted))
        if lost in wanted:
            raise NoFilmError("lost")
        return integrate_on(time_grid, restart, begin, wanted, after)

    monkeypatch.setattr(transient_solutions, "integrate_on", on)
    solve_lives(tasks, tmp_path, None, lambda message, share: None)
    times = [seconds_of(task) for task in tasks]
    assert solved == [times, times[1:]]
    found = [rates_for(task, tmp_path) for task in tasks]
    assert [len(rates.found) for rates in found] == [1, 2, 2]
    assert [rates.finest for rates in found] == [True, False, False]


def test_where_films_to_go_on_from_are_damaged_a_solve_begins_with_the_life(tmp_path, monkeypatch):
    monkeypatch.setitem(STEPS_A_TRANSIT, "point", 3)
    (task, _) = tasks = tasks_of(0.1, 0.3)
    of_life, begun = transient_solutions.integrate_in_time, []

    def integrated(time_grid, refinement, *how):
        begun.append(refinement)
        found = of_life(time_grid, refinement, *how)
        return found

    kept_of, damage = transient_solutions.keep, b"nothing"

    def damaged(path, **arrays):
        kept_of(path, **arrays)
        if "restart" in path.name:
            path.write_bytes(damage)

    monkeypatch.setattr(transient_solutions, "integrate_in_time", integrated)
    monkeypatch.setattr(transient_solutions, "keep", damaged)
    solve_lives(tasks, tmp_path, None, lambda message, share: None)
    assert begun == [0, 1, 1]
    assert len(rates_for(task, tmp_path).found) == 2


def test_what_a_solve_before_found_is_kept_where_a_stretch_alone_is_lost(monkeypatch):
    (task,) = tasks_of(0.5)

    def lost(*given):
        raise NoFilmError("lost")

    monkeypatch.setattr(transient_module, "integrate_on", lost)
    rates = rates_at_present(task.scene, task.plan)
    assert len(rates.found) == 1 and rates.finest and rates.flaw is None


def records_of(films, first=0.0, step=1.0):
    return [
        TimeRecord(first + number * step, None, 1.0, (1.0, 0.0), figures_of(film))
        for number, film in enumerate(films)
    ]


def figures_of(film):
    return {"film_min": film, "film_central": 2 * film, "power_loss": 2.0}


def test_beyond_a_stretch_a_life_has_the_moments_of_the_solve_before_corrected():
    """Between 2 and 4 s; it does not depend on its beginning from 2.4 s on."""
    coarse = records_of([1.0, 2.0, 3.0, 4.0, 5.0, 6.0])
    fine = records_of([3.0, 3.6, 4.4, 5.0, 5.5], 2.0, 0.5)
    first, second = completed([(coarse, -np.inf), (fine, 2.4)])
    assert first == tuple(coarse)
    assert [record.seconds for record in second] == [0, 1, 2, 2.5, 3, 3.5, 4, 5]
    films = [record.figures["film_min"] for record in second]
    assert films == pytest.approx([1.1, 2.2, 3.3, 3.6, 4.4, 5.0, 5.5, 6.6])
    assert all(record.figures["power_loss"] == 2.0 for record in second)
    assert [record.seconds for record in second if record.corrected] == [0, 1, 2, 5]


def test_bars_beyond_a_stretch_are_twice_as_wide():
    coarse = records_of([1.0] * 6)
    solves = completed([(coarse, -np.inf), (records_of([1.1] * 5, 2.0, 0.5), 2.0)])
    life = curves(solves, -1.0, "point", 0.5, 0.0, 4.0, {"film_min": 1.1}, None, 1e-3)
    bars = life["life_film_min_error"].values / 0.05
    assert bars == pytest.approx([2, 2, 1, 1, 1, 1, 1, 2], rel=1e-6)


def test_a_correction_is_a_factor_of_two_at_most_and_none_of_a_figure_that_is_zero():
    coarse = records_of([1.0, 1.0, 1.0])
    fine = [replace(coarse[1], figures=figures_of(9.0) | {"power_loss": 0.0})]
    films = [record.figures for record in completed([(coarse, -np.inf), (fine, 0.5)])[1]]
    assert [film["film_min"] for film in films] == [2.0, 9.0, 2.0]
    assert [film["power_loss"] for film in films] == [2.0, 0.0, 2.0]


def test_a_stretch_without_a_moment_of_the_solve_before_stands_for_itself():
    coarse, fine = records_of([1.0, 1.0]), records_of([2.0], 0.5)
    assert completed([(coarse, -np.inf), (fine, 0.0)])[1] == tuple(fine)


def test_fluxes_that_later_times_read_are_kept_and_those_between_them(monkeypatch):
    monkeypatch.setitem(STEPS_A_TRANSIT, "point", 24)
    (task,) = tasks_of(0.5, effects=HEATED, accuracy=0.2)
    time_grid, at = task.time_grid, seconds_of(task)
    monkeypatch.setattr(
        "pyworm.solver.transient.film_series.remembered", lambda history, contact: history
    )
    begin = time_grid.place(at) - 2.5
    (restart,) = integrate_in_time(time_grid, 0, begin, [at], solves_after=1).restarts.values()
    history = list(restart.heat)
    few = remembered(history, task.scene)
    assert few[0] is history[0] and few[1] is history[1]
    ages = [history[0].seconds - one.seconds for one in few]
    assert len(few) < 0.8 * len(history) and ages == sorted(ages)
    assert remembered(few, task.scene) == few
    assert remembered(history[:1], task.scene) == history[:1]


def test_each_stretch_is_expected_once_where_several_overlap():
    def contact(end):
        stretch = ExpectedStretch(end - 2.0, end, 8.0)
        return Expectation(20.0, 1.0, 13.0, 5.0, None, stretches=(stretch,))

    some = [replace(contact(end), part="part") for end in (6.0, 3.0, 4.0)]
    assert together(some, ["life"] * 3) == pytest.approx(3 * 7.0 + 5.0 + 8.0 + 4.0 + 8.0)
    assert together(some[:1], ["life"]) == 20.0


def test_a_stretch_is_expected_with_the_steps_that_it_takes():
    (task,) = tasks_of(0.5)
    time_grid, at = task.time_grid, seconds_of(task)
    expected = motion(task.scene, task.plan, time_grid)
    first = integrate_in_time(time_grid, 0, 0.0, [at], solves_after=1)
    found = integrate_on(time_grid, first.restarts[at], 0.0, [at])
    (stretch,) = expected.stretches
    assert sum(one.count for one in stretch.steps) == pytest.approx(len(found.records), abs=2)
    assert stretch.end == time_grid.place(at)
    until = replace(task.scene, past=Past(task.scene.past.life, at, at))
    assert not motion(until, task.plan, time_grid).stretches


def test_a_stretch_that_would_begin_before_its_part_is_expected_from_there():
    (task,) = tasks_of(0.02)
    (stretch,) = motion(task.scene, task.plan).stretches
    assert stretch.begin > 0
    time_grid = replace(task.time_grid, life=replace(task.time_grid.life, touched=at_first(task)))
    (stretch,) = motion(task.scene, task.plan, time_grid).stretches
    assert stretch.begin == 0.0


def at_first(task):
    """A touch that comes after its time."""
    return seconds_of(task) + 1e-4
