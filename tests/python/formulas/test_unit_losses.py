"""Losses of loaded bearings and seals, and the dipping part of a disc, against hand calculations."""

import pytest

from pyworm.formulas import unit_losses as found
from pyworm.formulas.unit_factors import RPM


def test_a_loaded_bearing_rubs_by_palmgren_s_factor():
    """10 kN on 100 mm: 4e-4 of 1000 N m."""
    assert found.bearing_load_torque(1e4, 0.1) == pytest.approx(0.4)


def test_a_seal_of_50_mm_at_1500_rpm_loses_29_w():
    assert found.seal_loss(0.05, 1500 / RPM) == pytest.approx(28.84, rel=1e-3)


def test_half_a_disc_dips_to_its_axis():
    assert found.dipping_share(0.1, 0.2) == pytest.approx(0.5)
    assert found.dipping_share(0.3, 0.2) == pytest.approx(1)
    assert found.dipping_share(0.0, 0.2) == 0
    # a segment of a tenth of the diameter: 5.2 % of the circle (tables of segments)
    assert found.dipping_share(0.02, 0.2) == pytest.approx(0.052, abs=1e-3)
