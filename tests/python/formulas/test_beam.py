"""Bending of a shaft on two supports against Maxwell and Mohr's integral of unit loads."""

import numpy as np
import pytest

from pyworm.formulas.beam import bending, second_moment


def moments(force, moment, before, beyond, x):
    """Bending moment along a shaft by the force and the moment at one place."""
    span = before + beyond
    first = -(force * beyond - moment) / span
    return first * x + np.where(x > before, force * (x - before) - moment, 0.0)


@pytest.mark.parametrize(("before", "beyond"), [(0.09, 0.09), (0.05, 0.13), (0.14, 0.02)])
@pytest.mark.parametrize(("force", "moment"), [(2e3, 0.0), (0.0, 150.0), (-3e3, 80.0)])
def test_deflection_and_slope_are_those_of_unit_loads(force, moment, before, beyond):
    rigidity = 210e9 * second_moment(30e-3)
    x, weights = np.polynomial.legendre.leggauss(8)
    energy = np.zeros(2)
    for low, high in ((0.0, before), (before, before + beyond)):
        at = low + (high - low) * (x + 1) / 2
        for row, unit in enumerate(((1.0, 0.0), (0.0, 1.0))):
            both = moments(force, moment, before, beyond, at) * moments(*unit, before, beyond, at)
            energy[row] += weights @ both * (high - low) / 2 / rigidity
    bent = bending(force, moment, before, beyond, rigidity)
    np.testing.assert_allclose((bent.deflection, bent.slope), energy, rtol=1e-12, atol=1e-18)


def test_reactions_balance_and_soft_bearings_move_the_shaft_as_a_rigid_one():
    stiff, soft = (bending(1e3, 40.0, 0.06, 0.12, 1e4, stiffness) for stiffness in (np.inf, 1e8))
    first, last = stiff.reactions
    assert first + last + 1e3 == pytest.approx(0)
    assert 0.18 * last + 0.06 * 1e3 + 40.0 == pytest.approx(0)
    ends = -first / 1e8, -last / 1e8
    assert soft.deflection - stiff.deflection == pytest.approx(ends[0] * 2 / 3 + ends[1] / 3)
    assert soft.slope - stiff.slope == pytest.approx((ends[1] - ends[0]) / 0.18)


def test_a_force_in_the_middle_of_a_shaft():
    bent = bending(1e3, 0.0, 0.1, 0.1, 5e4)
    assert bent.deflection == pytest.approx(1e3 * 0.2**3 / 48 / 5e4) and bent.slope == 0
