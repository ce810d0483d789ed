"""Dang Van's criterion, the risk integral and Miner's sum against closed forms."""

import numpy as np
import pytest

from pyworm.formulas.fatigue import (
    CYCLE_EXPONENT,
    REFERENCE_CYCLES,
    REFERENCE_DEPTH,
    REFERENCE_EXCESS,
    bending_limit,
    dang_van,
    dang_van_slope,
    failure_probability,
    risk,
    torsion_limit,
)
from pyworm.kernel import subsurface_stress

BENDING, TORSION = 400e6, 250e6
SLOPE = dang_van_slope(BENDING, TORSION)
PHASE = np.linspace(0, 2 * np.pi, 33)


def history(**components):
    """Stress over time at one place."""
    names = ("xx", "yy", "zz", "xy", "xz", "yz")
    return np.stack([components.get(name, 0 * PHASE) for name in names])[..., None]


def test_both_limits_are_met():
    bent = history(xx=BENDING * np.sin(PHASE))
    twisted = history(xz=TORSION * np.sin(PHASE))
    for path in (bent, twisted):
        assert dang_van(path, SLOPE) == pytest.approx(TORSION)


def test_a_steady_shear_does_no_harm_and_a_mean_pull_does():
    twisted = history(xz=TORSION * (2 + np.sin(PHASE)))
    assert dang_van(twisted, SLOPE) == pytest.approx(TORSION)
    pulled = history(xx=BENDING * (1 + np.sin(PHASE)))
    assert dang_van(pulled, SLOPE) == pytest.approx(TORSION + SLOPE * BENDING / 3)
    assert dang_van(twisted, SLOPE, [-90e6]) == pytest.approx(TORSION - SLOPE * 90e6)


def test_a_turning_shear():
    """Shear that turns at constant size: the sphere is centred, and tau is that size."""
    turning = history(xz=TORSION * np.sin(PHASE), yz=TORSION * np.cos(PHASE))
    assert dang_van(turning, SLOPE) == pytest.approx(TORSION, rel=1e-3)


def test_the_middle_of_a_crooked_path():
    """Three stresses on a right-angled triangle: the sphere's diameter is the longest side."""
    corner = history()[:, :3] * 0
    corner[3, 1], corner[4, 2] = 100.0, 100.0
    assert dang_van(corner, 0.0) == pytest.approx(np.sqrt(2) * 50, rel=0.03)


def test_hardness_gives_limits():
    assert bending_limit(300 * 9.80665e6) == pytest.approx(480e6)
    assert torsion_limit(480e6) == pytest.approx(480e6 / np.sqrt(3))


def test_the_reference_volume_fails_by_one_in_a_hundred():
    depths = REFERENCE_DEPTH + np.linspace(-1e-7, 1e-7, 5)
    stress = np.full((5, 1), (1 + REFERENCE_EXCESS) * TORSION)
    one = risk(stress, TORSION, depths)[0] * 100e-6 * REFERENCE_DEPTH / 2e-7
    assert failure_probability([(one, REFERENCE_CYCLES)]) == pytest.approx(0.01, rel=1e-3)
    assert risk(0.99 * TORSION + 0 * stress, TORSION, depths) == 0


def test_miner_adds_lives():
    risks = [1e-8, 3e-9]
    lives = [(np.log(2) / one) ** (1 / CYCLE_EXPONENT) for one in risks]  # half have failed
    duty = [(one, 0.5 * life) for one, life in zip(risks, lives, strict=True)]
    assert failure_probability(duty) == pytest.approx(0.5)


def test_a_frictionless_line_contact():
    """0.186 p0 of steel whose limits are as of von Mises; the bearing limit of 1500 MPa is some 280 MPa."""
    x = np.linspace(-5, 5, 401)
    pressure = np.sqrt(np.maximum(1 - x**2, 0))
    stress = subsurface_stress(pressure, (0 * pressure,), (x[1] - x[0],), 0.3, [0.5, 0.55, 0.6])
    found = dang_van(stress.transpose(0, 2, 1), dang_van_slope(np.sqrt(3), 1.0)).max()
    assert found == pytest.approx(0.186, abs=0.001)
