"""Time steps of a transient solution across a jump of the load."""

from itertools import pairwise
from pathlib import Path

import pytest

import pyworm
from pyworm.solver.transient import march as march_module
from pyworm.solver.transient.course import course_of
from pyworm.solver.transient.march import LostError, march
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


def test_a_step_whose_film_is_not_found_is_halved(part, monkeypatch):
    course, begin, wanted = part
    onward, lost = march_module._onward, []

    def counted(course, step, *state):
        try:
            return onward(course, step, *state)
        except LostError:
            lost.append(step.seconds)
            raise

    monkeypatch.setattr(march_module, "_onward", counted)
    found = march(course, 0, begin, [wanted])
    assert found.lost is None
    assert wanted in found.rates
    loads = [one.load for one in found.moments]
    jump = max(after / before for before, after in pairwise(loads))
    assert jump > 1.3  # the load per length
    assert lost


def test_a_step_is_halved_so_often_only(part, monkeypatch):
    course, begin, wanted = part
    onward, tried = march_module._onward, []

    def lost_soon(course, step, *state):
        if tried or step.seconds > course.instant(begin + 0.1):
            tried.append(step.seconds)
            raise LostError("lost")
        return onward(course, step, *state)

    monkeypatch.setattr(march_module, "_onward", lost_soon)
    found = march(course, 0, begin, [wanted])
    assert found.lost == "lost"
    assert len(tried) == march_module.MOST_HALVINGS + 1
    assert tried == sorted(tried, reverse=True)
