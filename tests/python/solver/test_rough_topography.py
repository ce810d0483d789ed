"""Films between surfaces whose heights are known, beside those of closed curves for the same figures."""

from dataclasses import replace

import numpy as np
import pytest
from folders import CASES

import pyworm
from pyworm.materials.topography import Topography
from pyworm.surfaces.generated import self_affine
from pyworm.surfaces.parameters import slopes


@pytest.fixture(scope="module")
def line(tmp_path_factory):
    """A sliding line contact and its smooth film."""
    patch = pytest.MonkeyPatch()
    patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
    heavy = pyworm.load(CASES / "line_thermal.toml").scene()
    u = heavy.entrainment
    scene = replace(heavy, load=heavy.load / 10, velocities=(1.15 * u, 0.85 * u))
    yield scene, _solved(scene, "isothermal").figures.film_central.value
    patch.undo()


def _solved(scene, effects):
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.02, effects))
    assert solution.converged, solution.stop_reason
    return solution


def _surface(height):
    """A flank of such a slope that asperities share the load with the oil."""
    fine = self_affine(height, 0.8, 1600 * height, 200 * height, seed=1)
    return Topography(
        fine.height[::2, ::2], tuple(2 * step for step in fine.spacing), periodic=True
    )


def _rough(scene, bodies):
    """The scene with a topography, or its figures alone, on body 1, 2 or both."""
    changed = tuple(replace(body, **one) for body, one in zip(scene.bodies, bodies, strict=True))
    return replace(scene, bodies=changed)


def test_a_film_between_known_surfaces_is_near_that_of_their_figures(line):
    scene, film = line
    surface = _surface(film / 1.5)
    slope = float(np.hypot(*slopes(surface)))
    figures = {"roughness": surface.rms, "roughness_slope": slope}
    smooth = {"roughness": 0.01 * surface.rms, "roughness_slope": 0.01 * slope}
    found = [
        _solved(_rough(scene, (one, smooth)), ("isothermal", "roughness")).figures
        for one in (figures, figures | {"topography": surface})
    ]
    closed, cell = ((one.film_central.value, one.asperity_load_fraction) for one in found)
    shares = [getattr(share, "value", share) for share in (closed[1], cell[1])]
    print(
        f"film {closed[0]:.3g} and {cell[0]:.3g} m, load on asperities {shares[0]:.3g} and {shares[1]:.3g}"
    )
    assert cell[0] == pytest.approx(closed[0], rel=0.02)
    assert shares[1] == pytest.approx(shares[0], rel=0.2)
    assert 0.005 < shares[1] < 0.6


def test_known_heights_on_the_slow_wall_thicken_the_film(line):
    """What the rough wall drags: the sign of the shear factor."""
    scene, film = line
    surface = _surface(film / 3)
    known = {"roughness": surface.rms, "topography": surface}
    smooth = {"roughness": 0.01 * surface.rms}
    fast, slow = (
        _solved(_rough(scene, bodies), ("isothermal", "roughness")).figures.film_central.value
        for bodies in ((known, smooth), (smooth, known))
    )
    assert slow > 1.005 * fast
