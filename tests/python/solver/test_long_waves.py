"""Films with the long waves of measured surfaces: rolling through, at rest, and in the model's bar."""

from dataclasses import replace

import numpy as np
import pytest
from line import OILS, line
from waviness import VENNER

import pyworm
from pyworm.case.past import PastTable
from pyworm.materials.long_waves import LongWaves
from pyworm.materials.topography import Topography
from pyworm.scene.scales import line_scales
from pyworm.solver.transient.time_grid import time_grid_of
from pyworm.solver.transient.time_integration import integrate_in_time

PART = 0.1
"""Amplitude of the waves over the smooth film."""

POINTS, ROWS = 64, 8
"""Points on a wave, and rows along its crests."""


@pytest.fixture(scope="module")
def contact():
    return line(100.0, 11.0, OILS["compressible"])


def _with_waves(scene, length, number=0):
    """The scene with waves across the motion on a body, and hardly any roughness."""
    film = line_scales(scene).film
    step = length / POINTS
    count = POINTS * round(40 * line_scales(scene).hertz.half_width / length)
    x = (np.arange(count) - (count - 1) / 2) * step
    heights = np.tile(PART * film * np.cos(2 * np.pi * x / length)[:, None], (1, ROWS))
    waves = LongWaves(Topography(heights - heights.mean(), (step, step), periodic=True))
    bodies = [replace(body, roughness=0.005 * film) for body in scene.bodies]
    bodies[number] = replace(bodies[number], long_waves=waves)
    return replace(scene, bodies=tuple(bodies))


@pytest.mark.parametrize("ratio", [pytest.param(0.5, marks=pytest.mark.long), 1.0, 2.0])
def test_rolling_waves_are_flattened_as_venner_found(contact, ratio):
    """Amplitudes of C. H. Venner et al. (1997), table 1, by a contact whose past is all the same."""
    half_width = line_scales(contact).hertz.half_width
    length, speed = ratio * half_width, contact.entrainment
    whole = (3 * half_width + 1.25 * length) / speed
    table = PastTable.model_validate({"times": ["0 s", f"{whole:.9g} s"], "speed": [1.0, 1.0]})
    scene = table.of(_with_waves(contact, length))
    plan = pyworm.plan(scene, 0.02, ("isothermal", "squeeze", "roughness"))
    found = integrate_in_time(time_grid_of(scene.past.life, plan), 1, 0.0, [whole]).records
    last = [of.figures["film_central"] for of in found if of.seconds > whole - length / speed]
    film = line_scales(contact).film
    left = (max(last) - min(last)) / (2 * PART * film)
    print(f"{left:.4f} of the amplitude is left, {VENNER[PART][ratio]} in the table")
    assert left == pytest.approx(VENNER[PART][ratio], rel=0.06)


def test_waves_at_rest_are_those_of_a_gap_with_waves(contact):
    sliding = replace(contact, velocities=(0.0, contact.velocities[1]))
    length = line_scales(contact).hertz.half_width
    scene = _with_waves(sliding, length)
    smooth = tuple(replace(body, long_waves=None) for body in scene.bodies)
    height = PART * line_scales(scene).film

    def gap(x):
        opening, covered = sliding.gap(x)
        return opening - height * np.cos(2 * np.pi * x / length), covered

    found, expected, without = (
        pyworm.solve(one, pyworm.plan(one, 0.02, ("isothermal", "roughness")))
        for one in (scene, replace(scene, bodies=smooth, gap=gap), replace(scene, bodies=smooth))
    )
    film, same, other = (of.figures.film_min.value for of in (found, expected, without))
    print(
        f"waves change the least film by {film / other - 1:.2%}, a gap with them {same / other - 1:.2%}"
    )
    assert abs(film - other) > 0.005 * other
    assert abs(film - same) < 0.05 * abs(film - other)


def test_waves_that_roll_through_a_steady_film_widen_its_bar(contact):
    scene = _with_waves(contact, line_scales(contact).hertz.half_width)
    smooth = replace(scene, bodies=tuple(replace(of, long_waves=None) for of in scene.bodies))
    waves, none = (
        pyworm.solve(one, pyworm.plan(one, 0.02, ("isothermal", "roughness"))).figures
        for one in (scene, smooth)
    )
    assert waves.film_central.value == pytest.approx(none.film_central.value, rel=1e-9)
    # of the waves that part is left in the film which the same table has
    film = line_scales(scene).film
    expected = VENNER[PART][1.0] * PART * film / 2**0.5 / waves.film_central.value
    bar = waves.film_central.model
    print(f"bar {bar:.3g}, without waves {none.film_central.model:.3g}, expected {expected:.3g}")
    assert none.film_central.model < 0.1 * expected
    assert 0.7 * expected < bar < 1.4 * expected
