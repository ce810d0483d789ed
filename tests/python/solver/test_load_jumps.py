"""Time steps of a transient solution across a jump of the load."""

from itertools import pairwise
from pathlib import Path

import pytest

import pyworm
from pyworm.solver.transient import march as march_module
from pyworm.solver.transient.course import course_of
from pyworm.solver.transient.march import NoFilmError, march
from pyworm.solver.transient.transient import part_at

HELICAL = Path(__file__).parents[2] / "data" / "helical_a500.toml"


@pytest.fixture(scope="module")
def part():
    """Time integration up to a contact shortly after a second tooth pair has left the mesh."""
    case = pyworm.load(HELICAL)
    scene = case.scene(phase=0.42)
    plan = pyworm.plan(scene, accuracy=0.1, effects=case.effects)
    course = course_of(scene.past.life, plan)
    return course, part_at(course, scene.past.seconds).begin, scene.past.seconds


def first_guesses_of_extrapolated_films(course, solver, grid, contact, before, seconds):
    return solver.on_grid(grid, march_module.extrapolated(before, seconds))


@pytest.mark.parametrize(
    ("begun_from", "steady_films"),
    [(march_module._begun_from, 1), (first_guesses_of_extrapolated_films, 2)],
)
def test_a_step_across_a_jump_has_a_film(part, monkeypatch, begun_from, steady_films):
    """It begins with the last film, or else the steady one: the extrapolated one makes no sense."""
    course, begin, wanted = part
    beside, asked = march_module._beside, []

    def counted(*given):
        asked.append(given)
        return beside(*given)

    monkeypatch.setattr(march_module, "_beside", counted)
    monkeypatch.setattr(march_module, "_begun_from", begun_from)
    found = march(course, 0, begin, [wanted])
    assert found.failure is None
    assert wanted in found.rates
    loads = [one.load for one in found.moments]
    jump = max(after / before for before, after in pairwise(loads))
    assert jump > 1.3  # the load per length
    assert len(asked) == steady_films  # the first film is steady


def test_a_step_whose_film_is_not_found_is_halved(part, monkeypatch):
    course, begin, wanted = part
    onward, diverged, later = march_module._onward, [], []

    def lost_once(course, step, before, *state):
        if not diverged and step.seconds > course.instant(begin + 0.1):
            diverged.append((before[0].seconds, step.seconds))
            with monkeypatch.context() as exacting:
                exacting.setattr(
                    march_module, "MAX_TRANSIENT_RESIDUAL", 0.0
                )  # no film is met so well
                return onward(course, step, before, *state)
        if diverged:
            later.append(step.seconds)
        return onward(course, step, before, *state)

    monkeypatch.setattr(march_module, "_onward", lost_once)
    found = march(course, 0, begin, [wanted])
    assert found.failure is None
    ((before, after),) = diverged
    assert later[:2] == pytest.approx([(before + after) / 2, after])


def test_a_step_is_halved_so_often_only(part, monkeypatch):
    course, begin, wanted = part
    onward, tried = march_module._onward, []

    def lost_soon(course, step, *state):
        if tried or step.seconds > course.instant(begin + 0.1):
            tried.append(step.seconds)
            raise NoFilmError("lost")
        return onward(course, step, *state)

    monkeypatch.setattr(march_module, "_onward", lost_soon)
    found = march(course, 0, begin, [wanted])
    assert found.failure == "lost"
    assert len(tried) == march_module.MOST_HALVINGS + 1
    assert tried == sorted(tried, reverse=True)
