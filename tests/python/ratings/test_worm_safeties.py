"""The five safeties of worm gears: a worked example, ordinary units without a gap, spectra, verdicts."""

import json
from math import atan, cos, log10, pi, tan

import pytest
from folders import CASES
from refusals import changed

from pyworm.cli.main import main

GEAR = """
title = "The standards' reference gear"
source = "its sizes; bath of PAO"

[worm_gear]
centre_distance = "100 mm"
starts = 2
teeth = 41
module = "4 mm"
diameter_factor = 9.0
face_width = "30 mm"
worm_speed = "1500 rpm"
wheel_torque = "300 N m"
reduced_modulus = "150622 MPa"
worm_roughness = "0.625 um"
wheel_roughness = "0.8 um"

[worm_rating]
oil = "PAO VG 220"
sump_temperature = "80 degC"
temperature_limit = "100 degC"
wheel_material = "CuSn12Ni2"
life = "25000 h"
"""

SYMBOLS = ("S_W", "S_H", "S_delta", "S_F", "S_T")


@pytest.fixture
def rate(tmp_path, capsys):
    """The worm's rating of a case, as JSON."""

    def rating(text, *changes):
        path = tmp_path / "gear.toml"
        path.write_text(changed(text, *changes))
        assert main(["rate", str(path), "--json"]) == 0
        return json.loads(capsys.readouterr().out)["ratings"][0]

    return rating


def test_a_worked_example_with_all_safeties(rate):
    """Step by step in mm, N, rpm and mm2/s, by the formulas of a public transcription of DIN 3996.

    (The worksheet on worm gears of MITCalc.) The oil's viscosity is that of its Walther constants.
    """
    safety = {key: of["value"] for key, of in rate(GEAR)["safeties"].items()}
    assert tuple(safety) == SYMBOLS
    lead, output = atan(2 / 9), 300 * 1500 * pi / 30 / 20.5
    v = pi * 36e-3 * 25 / cos(lead)
    mu = (0.027 + 0.0056 / (v + 0.15) ** 1.63) * (0.07 / 0.06934) ** 0.5 * 0.95
    loss = output * (tan(lead + atan(mu)) / tan(lead) - 1)
    hot = 80 + loss / ((1940 + 15 * 1500) * 30e-3 * 164e-3)
    nu = 10**10 ** (7.4846 - 2.8510 * log10(hot + 273.15)) - 0.7
    eta = nu * 1e-6 * 859 * (1 - 5.5e-4 * (hot + 273.15 - 288.15))
    film = 21 * 0.06934 * (1.4e-8) ** 0.6 * eta**0.7 * 1500**0.7 * 100**1.39
    film *= 150622**0.03 / 300**0.13
    stress = 4 / pi * (0.9470 * 300e3 * 150622 / 100**3) ** 0.5
    wear = 5.58e-10 * (film * eta**-0.35) ** -1.91
    turns = 25000 * 60 * 1500 / 20.5
    worn = wear * (0.78 + 0.21 * 20.5 + 5.6 * 4.5) * stress * 100 / 150622 * turns
    allowed = 0.3 * 4 * cos(lead)
    assert safety["S_W"] == pytest.approx(allowed / worn, rel=3e-3)
    endured = 520 * (5 / (4 + v)) ** 0.5 * 1.0 * 0.94
    assert safety["S_H"] == pytest.approx(endured / stress, rel=1e-3)
    thick = 1.06 * (2 * pi - worn / cos(lead) + 10 * tan(pi / 9) / cos(lead))
    shear = 2000 * 300 / 164 / (30 * 4) * 0.5 * 2.9 * 4 / thick / cos(lead)
    assert safety["S_F"] == pytest.approx(100 / shear, rel=1e-3)
    force = 2000 * 300 / 164 * (tan(lead + atan(mu)) ** 2 + (tan(pi / 9) / cos(lead)) ** 2) ** 0.5
    bent = force * 172**3 / (48 * 210e3 * pi / 64 * (1.1 * 26) ** 4)
    assert safety["S_delta"] == pytest.approx(0.04 * 4**0.5 / bent, rel=1e-3)
    assert safety["S_T"] == pytest.approx(100 / 80)


def test_each_safety_has_its_minimum_verdict_and_inputs(rate):
    built = rate(GEAR)["safeties"]
    assert {key: of["minimum"] for key, of in built.items()} == {
        "S_W": 1.1,
        "S_H": 1.0,
        "S_delta": 1.0,
        "S_F": 1.1,
        "S_T": 1.1,
    }
    for of in built.values():
        assert of["verdict"] == "sufficient" and of["inputs"] and of["why"] == ""
    assert any("sign is doubtful" in doubt for doubt in built["S_T"]["doubts"])
    assert any("Bearings assumed" in doubt for doubt in built["S_delta"]["doubts"])
    assert built["S_T"]["inputs"]["theta_S_without_fan_C"] > 60


def test_what_is_missing_cannot_be_rated_and_says_why(rate):
    bare = rate(GEAR, ('wheel_material = "CuSn12Ni2"\nlife = "25000 h"\n', ""))
    built = bare["safeties"]
    for symbol in ("S_W", "S_H"):
        assert built[symbol]["verdict"] == "cannot be rated" and built[symbol]["value"] is None
        why = "worm_rating.wheel_material is missing, worm_rating.life is missing."
        assert built[symbol]["why"] == why
    assert built["S_F"]["why"] == "worm_rating.wheel_material is missing."
    assert built["S_T"]["verdict"] == built["S_delta"]["verdict"] == "sufficient"
    assert any(of.startswith("S_H, pitting") for of in bare["not_rated"])


def test_too_hot_a_sump_is_not_sufficient(rate):
    rated = rate(GEAR, ('"80 degC"', '"95 degC"'))
    assert rated["safeties"]["S_T"]["verdict"] == "not sufficient"
    assert "S_T = 1.053 against temperature of the oil is below 1.1." in rated["failed"]


def test_a_spectrum_of_one_load_is_that_load_and_halves_add_up(rate):
    """Miner: twice the same load for half the time each is that load; idle hours add wear, no pitting."""
    whole = rate(GEAR)["safeties"]
    step = '[[worm_rating.spectrum]]\nwheel_torque = "{} N m"\nworm_speed = "1500 rpm"\nduration = "{} h"\n'
    spectrum = [('life = "25000 h"\n', step.format(300, 12500) * 2)]
    halves = rate(GEAR, *spectrum)["safeties"]
    for symbol in SYMBOLS:
        assert halves[symbol]["value"] == pytest.approx(whole[symbol]["value"], rel=1e-9)
    light = step.format(300, 25000) + step.format(60, 25000)
    more = rate(GEAR, ('life = "25000 h"\n', light))["safeties"]
    # (60/300)^(6/2) of its hours count in pitting; 2 equal halves of 25000 h are 50000 h
    assert more["S_H"]["value"] == pytest.approx(
        whole["S_H"]["value"] * (1 + (60 / 300) ** 3) ** (-1 / 6)
    )
    assert more["S_W"]["value"] < whole["S_W"]["value"]
    assert more["S_F"]["value"] < whole["S_F"]["value"]  # more is worn off
    both = changed(GEAR, ('life = "25000 h"', f'life = "25000 h"\n{light}'))
    assert both.count("spectrum") == 2


def test_life_and_spectrum_together_are_refused(tmp_path, capsys):
    step = (
        '[[worm_rating.spectrum]]\nwheel_torque = "9 N m"\nworm_speed = "9 rpm"\nduration = "1 h"\n'
    )
    path = tmp_path / "gear.toml"
    path.write_text(GEAR + step)
    assert main(["rate", str(path)]) == 2
    assert "give either life or spectrum" in capsys.readouterr().err


def test_without_a_sump_temperature_the_standards_is_taken(rate):
    cool = rate(GEAR, ('sump_temperature = "80 degC"\n', "fan = true\n"))["safeties"]["S_T"]
    warm = rate(GEAR, ('sump_temperature = "80 degC"\n', ""))["safeties"]["S_T"]
    assert cool["inputs"]["theta_S_C"] == cool["inputs"]["theta_S_with_fan_C"]
    assert warm["inputs"]["theta_S_C"] == warm["inputs"]["theta_S_without_fan_C"]
    assert warm["value"] < cool["value"]


@pytest.mark.parametrize("material", ["CuSn12", "CuSn12Ni2-GC", "CuAl10Fe5Ni5", "EN-GJL-250"])
@pytest.mark.parametrize("oil", ["mineral VG 220", "PAO VG 220", "PAG VG 220"])
@pytest.mark.parametrize("lubrication", ["bath", "injection"])
def test_no_gap_with_any_material_oil_and_lubrication(rate, material, oil, lubrication):
    built = rate(
        GEAR,
        ('"CuSn12Ni2"', f'"{material}"'),
        ('"PAO VG 220"', f'"{oil}"'),
        ("[worm_rating]\n", f'[worm_rating]\nlubrication = "{lubrication}"\n'),
    )
    assert all(of["value"] > 0 for of in built["safeties"].values())


@pytest.mark.parametrize("name", ["zi_sharif_2001", "oil_zi"])
def test_cases_of_the_package_are_rated_without_a_gap(name, capsys):
    assert main(["rate", str(CASES / f"{name}.toml"), "--json"]) == 0
    built = json.loads(capsys.readouterr().out)["ratings"][0]["safeties"]
    assert all(of["value"] is not None for of in built.values())


def test_ordinary_units_are_rated_without_a_gap(tmp_path, capsys):
    """Catalogue units of 100 mm, by their measured helicoids and by the numbers of a drawing."""
    measured = (CASES.parent / "tests" / "data" / "zi_a100.toml").read_text()
    rated = GEAR[GEAR.index("[worm_rating]") :].replace("PAO VG 220", "PAG VG 460")
    # the drawing's own oil has a temperature, which is the one of its sump
    as_drawn = rated.replace('sump_temperature = "80 degC"\n', "")
    drawn = (CASES / "worm_drawing.toml").read_text() + as_drawn
    for name, text in {"measured": measured, "drawn": drawn}.items():
        path = tmp_path / f"{name}.toml"
        path.write_text(text)
        assert main(["rate", str(path), "--json"]) == 0
        built = json.loads(capsys.readouterr().out)["ratings"][0]["safeties"]
        assert set(built) == set(SYMBOLS)
        assert all(of["value"] is not None for of in built.values())


def test_the_table_on_the_console_has_every_verdict(tmp_path, capsys):
    path = tmp_path / "gear.toml"
    path.write_text(GEAR)
    assert main(["rate", str(path)]) == 0
    out = capsys.readouterr().out
    assert all(symbol in out for symbol in SYMBOLS) and out.count("sufficient") >= 5
