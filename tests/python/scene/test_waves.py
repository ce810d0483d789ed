"""Long waves of measured surfaces in the gap: where they rest, where they roll, what is left out."""

from dataclasses import replace

import numpy as np
import pytest
from folders import CASES

import pyworm
from pyworm.case.past import PastTable
from pyworm.materials.long_waves import LongWaves
from pyworm.materials.topography import Topography
from pyworm.scene.waves import moving_waves, opening, waves_in_gap

HEIGHT, LENGTH, STEP, ACROSS, ALONG = 50e-9, 400e-6, 5e-6, 240, 320
PLACES = np.linspace(-200e-6, 200e-6, 41)
COSINE = HEIGHT * np.cos(2 * np.pi * PLACES / LENGTH)


def wavy(direction=0.0, periodic=True, turn=0.0):
    """Waves whose crests run along a direction from the x axis of their heights."""
    x = STEP * (np.arange(ALONG) - (ALONG - 1) / 2)[:, None]
    y = STEP * (np.arange(ACROSS) - (ACROSS - 1) / 2)[None, :]
    across = np.cos(direction) * y - np.sin(direction) * x
    heights = HEIGHT * np.cos(2 * np.pi * across / LENGTH)
    return LongWaves(Topography(heights - heights.mean(), (STEP, STEP), periodic, turn))


def known(scene, waves, number):
    """The scene with waves on one of its bodies."""
    bodies = [replace(body, roughness=0.1e-6) for body in scene.bodies]
    bodies[number] = replace(bodies[number], long_waves=waves)
    return replace(scene, bodies=tuple(bodies))


def at_rest(scene, number):
    """The scene with one surface at rest."""
    motions = list(scene.motions)
    motions[number] = replace(motions[number], u=0.0, v=0.0)
    return replace(scene, motions=tuple(motions))


def added(scene, *places):
    """What waves add to the gap."""
    return opening(scene, *places)[0] - scene.gap(*places)[0]


@pytest.fixture(scope="module")
def point():
    return pyworm.load(CASES / "mourier_2006.toml").scene()


@pytest.fixture(scope="module")
def line():
    return pyworm.load(CASES / "line_m20_l10.toml").scene()


@pytest.mark.parametrize("number", [0, 1])
def test_waves_of_a_surface_at_rest_are_in_the_gap(point, number):
    scene = known(at_rest(point, number), wavy(direction=np.pi / 2), number)
    assert added(scene, PLACES, 0 * PLACES) == pytest.approx(-COSINE, abs=0.01 * HEIGHT)
    assert moving_waves(scene) is None


@pytest.mark.parametrize("turn", [0.0, 0.4])
def test_a_moving_surface_brings_its_ridges_along_its_motion(point, turn):
    """Whatever the axes of the file."""
    scene = known(point, wavy(direction=-turn, periodic=False, turn=turn), 0)
    found = added(scene, 0 * PLACES + 30e-6, PLACES)
    expected = -COSINE
    assert found - found.mean() == pytest.approx(expected - expected.mean(), abs=0.05 * HEIGHT)


def test_waves_across_the_motion_are_left_to_the_bar(point):
    scene = known(point, wavy(direction=np.pi / 2), 0)
    assert added(scene, PLACES, PLACES) == pytest.approx(0.0, abs=0.01 * HEIGHT)
    left = moving_waves(scene)
    assert left.height == pytest.approx(HEIGHT / 2**0.5, rel=0.01)
    assert left.length == pytest.approx(LENGTH, rel=0.02)


def test_random_waves_do_not_pass_for_ridges(point):
    """The mean of what changes along the motion is chance, of which most is not taken."""
    heights = np.random.default_rng(3).standard_normal((64, 64))
    waves = LongWaves(Topography(heights - heights.mean(), (20e-6, 20e-6), True))
    assert waves_in_gap(known(point, waves, 0)) < 0.6 * heights.mean(axis=0).std()


def test_waves_are_left_out_with_the_roughness(point):
    still = at_rest(known(point, wavy(np.pi / 2), 0), 0)
    assert added(still, PLACES, PLACES).any()
    assert not added(replace(still, smooth=True), PLACES, PLACES).any()


def test_lines_have_the_mean_along_them(line):
    still = replace(line, velocities=(0.0, line.velocities[1]))
    across, along = wavy(direction=np.pi / 2), wavy()
    assert added(known(still, across, 0), PLACES) == pytest.approx(-COSINE, abs=0.01 * HEIGHT)
    assert added(known(still, along, 0), PLACES) == pytest.approx(0.0, abs=0.01 * HEIGHT)
    assert not added(known(line, across, 0), PLACES).any()


def test_waves_roll_with_their_surface(line):
    """Half as fast before: at each time they are where the surface has carried them."""
    speed = line.velocities[0]
    table = PastTable.model_validate({"times": ["0 ms", "1 ms", "2 ms"], "speed": [0.5, 0.5, 1]})
    scene = table.of(known(line, wavy(direction=np.pi / 2), 0))
    for seconds, before in ((2e-3, 0.0), (1e-3, 0.75e-3), (0.0, 1.25e-3)):
        then = scene.past.life.at(seconds)
        carried = HEIGHT * np.cos(2 * np.pi * (PLACES + before * speed) / LENGTH)
        assert added(then, PLACES) == pytest.approx(-carried, abs=0.01 * HEIGHT)
    assert moving_waves(scene).height < 0.1 * HEIGHT
