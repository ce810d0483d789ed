"""Type and life of lubricants, torque of cold oil, and jets of thick oil, by what their sources print."""

from math import log, pi, sqrt

import pytest

from pyworm.formulas.lubricant_type import TypeConditions, type_verdicts
from pyworm.formulas.no_load_torque import DippingBody, bearing_torque
from pyworm.formulas.nozzle import discharge_coefficient, jet_discharge
from pyworm.formulas.oil_life import UsedOil, change_interval, maker_interval, oil_life

C = 273.15
HOUR = 3600.0


def test_lives_of_flender():
    """10,000 h of mineral oil and 20,000 h of polyglycol at 80 degC; 10 K more halve, less about double."""
    assert oil_life("mineral", 80 + C) == pytest.approx(10_000)
    assert oil_life("PAG", 90 + C) == pytest.approx(10_000)
    assert oil_life("PAO", 70 + C) == pytest.approx(40_000, rel=0.05)


def test_life_falls_by_arrhenius():
    """The logarithm of the life is straight over 1/T, by 74 kJ/mol."""
    warm, hot = 60 + C, 110 + C
    slope = log(oil_life("ester", warm) / oil_life("ester", hot)) / (1 / warm - 1 / hot)
    assert 8.314462618 * slope == pytest.approx(73.9e3, rel=0.003)


@pytest.mark.parametrize(
    ("celsius", "mineral", "synthetic"),
    [(60, 8000, 25000), (66, 4000, 15000), (90, 2000, 12500), (96, None, None)],
)
def test_intervals_of_bonfiglioli(celsius, mineral, synthetic):
    assert maker_interval("mineral", celsius + C) == mineral
    assert maker_interval("PAG", celsius + C) == synthetic


def test_oil_is_changed_by_what_comes_first():
    assert change_interval("mineral", 60 + C, 6000) == 8000
    assert change_interval("mineral", 60 + C, 1000) == 2000  # two years
    assert change_interval("PAG", 100 + C, 8000) == pytest.approx(5000, rel=0.1)


def used(viscosity, acid=None, hours=4000):
    return UsedOil(
        operation=hours * HOUR,
        viscosity_40=viscosity * 1e-6,
        new_viscosity_40=220e-6,
        acid_number=acid,
        new_acid_number=0.5,
    )


def test_used_oil_by_the_limits_of_amarillo_gear():
    """VG 220 from 198 to 242 mm2/s with an acid number below 2."""
    for viscosity in (198, 242):
        assert used(viscosity).consumed == pytest.approx(1)
    assert used(230, 2.0).verdict == "change it now"
    assert (used(232).verdict, used(225, 0.6).verdict) == ("watch it", "usable")
    assert used(231, 0.5).life == pytest.approx(8000)
    assert used(220).life is None


def test_bearings_by_palmgren():
    """f_0 of 2, 100 mm, 20 mm2/s, 1000 rpm: 20,000^(2/3) is 736.8; below 2000 the torque stands still."""
    turning = 1000 * pi / 30
    assert bearing_torque(2, 0.1, 20e-6, turning) == pytest.approx(0.14736, rel=1e-4)
    assert bearing_torque(2, 0.1, 1e-6, turning) == bearing_torque(2, 0.1, 2e-6, turning)


def test_a_creeping_disc_by_jeffery():
    """32/3 mu w R^3 on both sides; 4 pi mu w R^2 on each length of the rim."""
    mu = 900 * 0.5
    torque = DippingBody(0.1, 0.01, 1.0).torque(900.0, 0.5, 0.1)
    assert torque == pytest.approx(mu * 0.1 * (32 / 3 * 1e-3 + 4 * pi * 1e-4), rel=1e-3)


def test_a_fast_disc_by_von_karman():
    """Moment coefficients 3.87 Re^-1/2 and 0.146 Re^-1/5 of both sides of a disc with a thin rim."""
    body, speed = DippingBody(0.2, 1e-3, 1.0), 100.0
    scale = 900 / 2 * speed**2 * 0.2**5
    assert body.torque(900.0, 4e-4, speed) == pytest.approx(scale * 3.87 / 100, rel=0.02)
    assert body.torque(900.0, 4e-7, speed) == pytest.approx(scale * 0.146 * 1e7**-0.2, rel=0.02)
    assert DippingBody(0.2, 1e-3, 0.5).torque(900.0, 4e-4, speed) == pytest.approx(
        body.torque(900.0, 4e-4, speed) / 2
    )


def test_discharge_of_thick_and_thin_oil():
    """Hagen and Poiseuille: dp = 32 mu l v/d2; Sampson: q = d3 dp/(24 mu); 0.7 of thin oil."""
    assert discharge_coefficient(1e9, 2) == pytest.approx(0.7, rel=1e-5)
    reynolds = 1e-3
    drag = 12 * pi + 64 * 2
    assert discharge_coefficient(reynolds, 2) == pytest.approx(reynolds / drag, rel=1e-6)


def test_jets_of_thick_oil_are_larger():
    """The pressure is that of the hole at its mean velocity: kinetic, Poiseuille's and Sampson's."""
    flow, pressure, density, viscosity, number, length = 1e-4, 2e5, 870.0, 2e-4, 4, 2.0
    discharge = jet_discharge(flow, pressure, density, viscosity, number, length)
    ideal = sqrt(2 * pressure / density)
    diameter = sqrt(4 * flow / (number * pi * discharge * ideal))
    mean = discharge * ideal
    viscous = density * viscosity * mean / diameter * (32 * length + 6 * pi)
    assert density * (mean / 0.7) ** 2 / 2 + viscous == pytest.approx(pressure)
    assert discharge < jet_discharge(flow, pressure, density, 1e-5, number, length) < 0.7


def suitable(**others):
    given = {
        "base": "mineral", "velocity": 2.0, "sliding": False, "coldest": 10 + C, "hottest": 60 + C,
        "enclosure": "oil-tight", "pressure": 4e8,
    }  # fmt: skip
    return [v.kind for v in type_verdicts(TypeConditions(**given | others)) if v.suitable]


@pytest.mark.parametrize(
    ("case", "first"),
    [
        ({}, "oil"),
        ({"enclosure": "leaking"}, "grease"),
        ({"enclosure": "open"}, "open-gear compound"),
        ({"enclosure": "vacuum"}, "solid film"),
        ({"hottest": 180 + C}, "solid film"),
        ({"coldest": -60 + C}, "solid film"),
        ({"enclosure": "leaking", "velocity": 8.0}, "solid film"),
    ],
)
def test_types_of_lubricant_as_errichello_has_them(case, first):
    """Oil unless precluded; grease in housings that leak; compounds on open gears; films without oil."""
    assert suitable(**case)[0] == first


def test_grease_and_compounds_are_for_slow_and_light_gears():
    assert "grease" not in suitable(velocity=7.0) + suitable(pressure=1.2e9)
    assert "grease" not in suitable(velocity=5.0, sliding=True)
    assert suitable(enclosure="open", velocity=3.0) == []
    assert "open-gear compound" not in suitable(enclosure="open", sliding=True)
