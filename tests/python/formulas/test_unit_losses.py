"""Losses of bearings, seals and discs in oil, against hand calculations in the units of their sources."""

from math import pi

import pytest

from pyworm.formulas import unit_losses as found
from pyworm.formulas.unit_factors import RPM


def test_a_bearing_s_idle_torque_is_palmgren_s():
    """100 mm2/s, 1000 1/min, 100 mm: 1e-7 4 (1e5)^(2/3) 1e6 N mm = 861.8 N mm."""
    torque = found.bearing_idle_torque(100e-6, 1000 / RPM, 0.1)
    assert torque == pytest.approx(0.8618, rel=1e-4)
    # 160e-7 f_0 d_m^3 of slow ones
    slow = found.bearing_idle_torque(1e-6, 1000 / RPM, 0.1)
    assert slow == pytest.approx(160e-7 * 4 * 1e6 * 1e-3, rel=0.01)
    assert found.bearing_load_torque(1e4, 0.1) == pytest.approx(0.4)


def test_a_seal_of_50_mm_at_1500_rpm_loses_29_w():
    assert found.seal_loss(0.05, 1500 / RPM) == pytest.approx(28.84, rel=1e-3)


def test_a_disc_in_oil_is_karman_s():
    """Laminar 0.616 pi rho R^4 (nu w^3)^(1/2) of both sides, Cochran's shear on the wall."""
    density, viscosity, radius, speed = 870.0, 2e-4, 0.15, 30.0
    exact = 0.616 * pi * density * radius**4 * (viscosity * speed**3) ** 0.5
    assert found.disc_torque(density, viscosity, radius, speed) == pytest.approx(exact, rel=2e-3)
    at_end = found.LAMINAR_DISC * viscosity / radius**2
    below, above = (
        found.disc_torque(density, viscosity, radius, part * at_end) for part in (0.999, 1.001)
    )
    assert 1 < above / below < 2
    assert found.disc_torque(density, viscosity, radius, 0.0) == 0


def test_half_a_disc_dips_to_its_axis():
    assert found.dipping_share(0.1, 0.2) == pytest.approx(0.5)
    assert found.dipping_share(0.3, 0.2) == pytest.approx(1)
    assert found.dipping_share(0.0, 0.2) == 0
    # a segment of a tenth of the diameter: 5.2 % of the circle (tables of segments)
    assert found.dipping_share(0.02, 0.2) == pytest.approx(0.052, abs=1e-3)
