"""Bending of threads, teeth and pins at their roots."""

from math import pi
from pathlib import Path

import pytest

import pyworm
from pyworm.formulas.root_bending import (
    PLATE_SPREAD,
    bearing_width,
    pin_root_stress,
    plate_root_stress,
)
from pyworm.io.toml import read_toml
from pyworm.ratings.roots import rate_roots

LIMITS = {"bending_limit": "300 MPa", "torsion_limit": "175 MPa"}


def test_plates_and_pins_in_closed_form():
    assert bearing_width(1.0, 0.0, 100.0) == PLATE_SPREAD
    assert bearing_width(1.0, 90.0, 50.0) == 50.0
    long_arm = plate_root_stress(100.0, 10.0, 0.1, 2.0)
    assert long_arm == pytest.approx(6 * 100 * 10 / (2 * 0.1**2), rel=1e-3)
    assert plate_root_stress(100.0, 0.0, 0.1, 2.0) == pytest.approx(3**0.5 * 500)
    assert pin_root_stress(100.0, 5.0, 0.1) == pytest.approx(32 * 500 / (pi * 1e-3), rel=1e-3)


def test_a_worm_drive_line_by_line():
    tables = read_toml(Path("cases/zi_sharif_2001.toml"))
    tables["bodies"]["wheel"]["fatigue"] = LIMITS
    rating = rate_roots(pyworm.load(tables).drive)
    thread, tooth = rating.safeties
    assert thread.why and tooth.symbol == "S_F_tooth"
    assert tooth.value == pytest.approx(300 / tooth.inputs["sigma_F_MPa"])
    lines = [figure.values[0] for figure in rating.figures if "tooth_stress" in figure.key]
    assert max(lines) == pytest.approx(tooth.inputs["sigma_F_MPa"] * 1e6)
    assert 20 < tooth.inputs["sigma_F_MPa"] < 120


def test_pins_of_rollers():
    tables = read_toml(Path("cases/roller_ref.toml"))
    tables["drive"]["rollers"]["pin"] = {"radius": "3 mm", "friction": 0.1}
    tables["bodies"]["rollers"]["fatigue"] = LIMITS
    rating = rate_roots(pyworm.load(tables).drive)
    pin = rating.safeties[1]
    inputs = pin.inputs
    assert inputs["arm_mm"] == pytest.approx(7) and inputs["thickness_mm"] == pytest.approx(6)
    bent = 32 * inputs["F_N"] * 7e-3 / (pi * 6e-3**3) * 1e-6
    assert inputs["sigma_F_MPa"] == pytest.approx(bent, rel=0.2)
    assert rating.words


def test_gears_without_limits_are_not_rated():
    assert rate_roots(pyworm.load("cases/roller_ref.toml").drive) is None
