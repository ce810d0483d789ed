"""What plans do where closed forms have no answer."""

from dataclasses import replace

import pytest
from plan_scenes import STEEL, mineral, point

import pyworm
from pyworm.planning import plan as plan_module
from pyworm.planning.by_formula import films_by_formula
from pyworm.planning.prediction import predicted
from pyworm.scene.life import Life, Past
from pyworm.scene.point import RigidMotion


def ball(speed=1.0):
    """A ball that rolls at a speed [m/s]."""
    motion = speed, 0.0
    return point("ball", (0.02, 0.02), 50.0, (motion, motion), (STEEL, STEEL), mineral(0.09, 2e-8))


def test_the_film_of_a_contact_point_at_rest_follows_from_no_formula():
    spinning = replace(ball(), motions=(RigidMotion(0, 0, 2e3), RigidMotion(0, 0, 1e3)))
    plan = replace(pyworm.plan(spinning, 0.2, quantities=("film",)), effects=())
    assert films_by_formula(spinning, plan) is None
    rolling = replace(pyworm.plan(ball(), 0.2, quantities=("film",)), effects=())
    assert films_by_formula(ball(), rolling) is not None


def test_a_contact_that_carried_no_load_before_is_compared_with_its_first_load():
    """Half a transit ago; none has been carried where the present is the first time."""
    transit, loads = predicted(ball()).transit, []

    def touching(seconds):
        if seconds < first * transit:
            raise ValueError("no load")
        loads.append(seconds / transit)
        return ball()

    scene = replace(ball(), past=Past(Life(5 * transit, touching), 5 * transit))
    first = 4.5
    assert predicted(scene).before is not None
    assert min(loads) == pytest.approx(4.5, abs=2e-3)
    first = 5.0
    assert predicted(replace(scene, name="first")).before is None
    life = Life(5 * transit, lambda seconds: ball())
    assert predicted(replace(scene, past=Past(life, 5 * transit))).before is not None


def test_numbers_beyond_all_arithmetic_are_refused_in_one_sentence(monkeypatch):
    def beyond(scene):
        raise OverflowError("math range error")

    monkeypatch.setattr(plan_module, "predicted", beyond)
    with pytest.raises(ValueError, match=r"out of all proportion .* check their units"):
        plan_module.plan_of(ball(), 0.1)
