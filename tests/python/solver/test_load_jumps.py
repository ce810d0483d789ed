"""Time steps of a transient solution across a jump of the load."""

from itertools import pairwise

import pytest
from folders import DATA

import pyworm
from pyworm.solver.transient import next_film
from pyworm.solver.transient.next_film import NoFilmError
from pyworm.solver.transient.time_grid import time_grid_of
from pyworm.solver.transient.time_integration import integrate_in_time
from pyworm.solver.transient.transient import part_at

HELICAL = DATA / "helical_a500.toml"


@pytest.fixture(scope="module")
def part():
    """Time integration up to a contact shortly after a second tooth pair has left the mesh."""
    case = pyworm.load(HELICAL)
    scene = case.scene(phase=0.42)
    plan = pyworm.plan(scene, accuracy=0.1, effects=case.effects)
    time_grid = time_grid_of(scene.past.life, plan)
    return time_grid, part_at(time_grid, scene.past.seconds).begin, scene.past.seconds


def first_guesses_of_extrapolated_films(
    time_grid, solver, grid, contact, before, seconds, settling
):
    return solver.on_grid(grid, next_film.extrapolated(before, seconds, False))


@pytest.mark.parametrize("begun_from", [next_film._begun_from, first_guesses_of_extrapolated_films])
def test_a_step_across_a_jump_has_a_film(part, monkeypatch, begun_from):
    """It begins with the last film, or that of half the step does: the extrapolated one makes no sense."""
    time_grid, begin, wanted = part
    monkeypatch.setattr(next_film, "_begun_from", begun_from)
    found = integrate_in_time(time_grid, 0, begin, [wanted])
    assert found.failure is None
    assert wanted in found.rates
    loads = [one.load for one in found.records]
    jump = max(after / before for before, after in pairwise(loads))
    assert jump > 1.3  # the load per length


def test_half_a_step_whose_film_is_not_found_begins_with_the_steady_one(part, monkeypatch):
    """A steady film costs as much as many of a step; a whole one goes without."""
    time_grid, begin, wanted = part
    onward, beside, is_found = next_film._onward, next_film._beside, next_film._is_found
    tried, lost, steady = [0.0], [], []

    def onward_of(time_grid, step, *state):
        tried.append(step.seconds)
        return onward(time_grid, step, *state)

    def found_later(level):
        """The first film of a whole step is lost, and that of its first half until it begins again."""
        now = tried[-1]
        begins = not lost and now > time_grid.time_at(begin + 0.1)
        if begins or (len(lost) == 1 and now < lost[0]):
            lost.append(now)
            return False
        return not lost == [now] and is_found(level)

    def counted(*given):
        steady.append(tried[-1])
        return beside(*given)

    for name, given in (("_onward", onward_of), ("_is_found", found_later), ("_beside", counted)):
        monkeypatch.setattr(next_film, name, given)
    found = integrate_in_time(time_grid, 0, begin, [wanted])
    assert found.failure is None and wanted in found.rates
    whole, half = lost
    assert half < whole
    assert steady == [0.0, half]  # the first film of all is steady


def test_a_step_whose_film_is_not_found_is_halved(part, monkeypatch):
    time_grid, begin, wanted = part
    onward, diverged, later = next_film._onward, [], []

    def lost_once(time_grid, step, before, *state):
        if not diverged and step.seconds > time_grid.time_at(begin + 0.1):
            diverged.append((before[0].seconds, step.seconds))
            with monkeypatch.context() as exacting:
                exacting.setattr(next_film, "MAX_TRANSIENT_RESIDUAL", 0.0)  # no film is met so well
                return onward(time_grid, step, before, *state)
        if diverged:
            later.append(step.seconds)
        return onward(time_grid, step, before, *state)

    monkeypatch.setattr(next_film, "_onward", lost_once)
    found = integrate_in_time(time_grid, 0, begin, [wanted])
    assert found.failure is None
    ((before, after),) = diverged
    assert later[:2] == pytest.approx([(before + after) / 2, after])


def test_a_step_is_halved_so_often_only(part, monkeypatch):
    time_grid, begin, wanted = part
    onward, tried = next_film._onward, []

    def lost_soon(time_grid, step, *state):
        if tried or step.seconds > time_grid.time_at(begin + 0.1):
            tried.append(step.seconds)
            raise NoFilmError("lost")
        return onward(time_grid, step, *state)

    monkeypatch.setattr(next_film, "_onward", lost_soon)
    found = integrate_in_time(time_grid, 0, begin, [wanted])
    assert found.failure == "lost" and not found.rates
    # once more where the solve begins again after the film that is lost
    each = next_film.MOST_HALVINGS + 1
    assert len(tried) == 2 * each
    for steps in (tried[:each], tried[each:]):
        assert steps == sorted(steps, reverse=True)
