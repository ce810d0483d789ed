"""Transient films between rough surfaces: limits in which another film is known."""

from dataclasses import replace

import pytest
from folders import CASES

import pyworm
from pyworm.case.past import PastTable
from pyworm.scene.scales import line_scales

EFFECTS = ("isothermal", "squeeze", "roughness")


REVERSAL = {"times": ["0 ms", "2 ms", "7 ms"], "speed": [-0.6667, -0.6667, 1.0]}
FASTER = {"times": ["0 ms", "2 ms", "4 ms"], "speed": [0.3, 0.3, 1.0]}
CALM = {"times": ["0 ms", "4 ms"], "speed": [1.0, 1.0]}


@pytest.fixture(scope="module")
def line():
    """A rolling line contact without a past."""
    return pyworm.load(CASES / "line_m20_l10.toml").scene()


def _rough(scene, ratio):
    """The scene between surfaces of equal roughness, the expected film over both so many times."""
    each = line_scales(scene).film / ratio / 2**0.5
    return replace(scene, bodies=tuple(replace(body, roughness=each) for body in scene.bodies))


def _after(scene, past):
    """The scene with a past."""
    return PastTable.model_validate(past).of(scene)


def _solved(scene, effects):
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.05, effects))
    assert solution.converged, solution.stop_reason
    return solution.figures


@pytest.mark.long
def test_roughness_to_zero_is_the_transient_film_of_smooth_surfaces(line):
    found = _solved(_after(_rough(line, 1e3), FASTER), EFFECTS)
    smooth = _solved(_after(line, FASTER), ("isothermal", "squeeze"))
    for name in ("film_min", "film_central", "pressure_max"):
        value = getattr(found, name).value
        print(f"{name}: {value / getattr(smooth, name).value - 1:+.1e}")
        assert value == pytest.approx(getattr(smooth, name).value, rel=1e-4), name
    assert found.asperity_load_fraction.value < 1e-12


@pytest.mark.long
def test_a_past_that_is_all_the_same_leaves_the_steady_mixed_film(line):
    scene = _rough(line, 0.7)
    found = _solved(_after(scene, CALM), EFFECTS)
    expected = _solved(scene, ("isothermal", "roughness"))
    assert expected.asperity_load_fraction.value > 0.05
    for name in ("film_min", "film_central", "asperity_load_fraction"):
        one, other = getattr(found, name), getattr(expected, name)
        print(f"{name}: {one.value / other.value - 1:+.1e}, {other.value:.3g}, bar {one.error:.1e}")
        assert one.value == pytest.approx(other.value, rel=2e-3), name


def test_asperities_bear_more_after_the_speed_has_turned_round(line):
    """The film at the contact's end is still that of the slow oil."""
    scene = _rough(line, 0.7)
    turned = _solved(_after(scene, REVERSAL), EFFECTS)
    steady = _solved(scene, ("isothermal", "roughness"))
    shares = [of.asperity_load_fraction.value for of in (turned, steady)]
    print(f"asperities bear {shares[0]:.3g} after a reversal, {shares[1]:.3g} in the steady film")
    assert shares[0] > 1.05 * shares[1]
    assert turned.film_min.value < 0.98 * steady.film_min.value
