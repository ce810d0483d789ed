"""`pyworm rate` and `pyworm oil`: against the sources' numbers, trends, the contract of JSON, refusals."""

import json
import re
import tomllib
from dataclasses import replace
from math import atan, pi, tan
from pathlib import Path

import numpy as np
import pytest
from folders import CASES, DATA
from hypothesis import given, settings
from hypothesis import strategies as st
from refusals import changed, refusal
from synthetic_solution import (
    line_with_heat,
    make_hot_worm,
    make_line_solution,
    make_mesh_cycle,
    without_heat,
)

import pyworm
from pyworm.case.case import checked
from pyworm.case.ratings import BearingTable, RatingCase
from pyworm.cli.main import main
from pyworm.ratings.bearing import bearing_life, carried_load
from pyworm.ratings.rated_case import rating_request, ratings
from pyworm.ratings.worm import worm_duty_of_table
from pyworm.ratings.worm_loads import RatedWormGear
from pyworm.result.result import Result

BEARING, WORM, INCREASER = (
    (CASES / f"{name}.toml").read_text()
    for name in ("bearing_nu2210", "oil_zi", "errichello_speed_increaser")
)
MICROINCH, FAHRENHEIT = 25.4e-9, 1 / 1.8


def said(capsys, *arguments):
    """The object that a command prints with --json."""
    assert main([*map(str, arguments), "--json"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    return json.loads(out, parse_constant=lambda word: pytest.fail(f"{word} is no JSON"))


def rated(capsys, name):
    """The ratings of a shipped case by their keys."""
    ratings = said(capsys, "rate", CASES / f"{name}.toml")["ratings"]
    return {rating["rating"]: rating for rating in ratings}


# ------------------------------------------------------------------------------------- contract


@pytest.mark.parametrize(
    ("name", "keys"),
    [
        ("bearing_nu2210", ["bearing vg_220", "bearing vg_460"]),
        ("oil_zi", ["worm", "starting", "bearing worm_shaft"]),
        ("zi_sharif_2001", ["worm", "films", "forces", "bearing worm_shaft"]),
        ("errichello_speed_increaser", ["gear teeth", "gear oil supply", "films", "forces"]),
    ],
)
def test_shipped_cases_are_rated(capsys, name, keys):
    content = said(capsys, "rate", CASES / f"{name}.toml")
    lubrication = {"left_out", "lubrication", "lambda_central", "lambda_min"}
    assert set(content) - lubrication == {
        "case",
        "ratings",
        "not_rated",
        "not_converged",
        "warnings",
        "assumed",
        "beyond_limits",
    }
    assert content["case"] == name
    assert [rating["rating"] for rating in content["ratings"]] == keys
    for rating in content["ratings"]:
        assert rating["source"] and rating["title"]
        about = {
            *("rating", "title", "source", "words", "failed", "not_rated"),
            *("safeties", "differs", "basis"),
        }
        columns = set(rating) - about
        assert columns <= {
            "computed", "standard", "simulation", "printed", "closed form", "central film", "minimum film"
        }  # fmt: skip
        for column in columns:
            numbers = [v for v in rating[column].values() if not isinstance(v, str)]
            assert numbers and all(np.isfinite(numbers))


@pytest.mark.parametrize("name", ["oil_zi", "errichello_speed_increaser"])
def test_assumptions_are_shown_with_value_and_reason(capsys, name):
    assumed = said(capsys, "rate", CASES / f"{name}.toml")["assumed"]
    assert len(assumed) > 10 and all(assumed.values())
    assert main(["rate", str(CASES / f"{name}.toml")]) == 0
    text = " ".join(capsys.readouterr().out.split())
    assert all(reason in text for reason in assumed.values())
    lines = {"oil_zi": "worm_gear.worm_roughness = 0.3 µm: a ground worm"}
    assert lines.get(name, "drive.module = 5.08 mm: normal diametral pitch 5") in text


def test_tables_show_what_json_has(capsys):
    assert main(["rate", str(CASES / "bearing_nu2210.toml")]) == 0
    text = capsys.readouterr().out
    for shown in ("24.13 mm²/s", "27.6 mm²/s", "0.9158", "1.14", "137.8 Mrev", "171 Mrev"):
        assert shown in text


# ---------------------------------------------------------------------- against the sources' numbers


@pytest.mark.parametrize(
    ("name", "kappa", "modification", "life", "printed"),
    [
        ("vg_220", 0.912, 0.916, 137.8, (0.80, 1.14, 171.0)),
        ("vg_460", 1.740, 1.587, 238.8, (1.52, 1.75, 262.5)),
    ],
)
def test_nu2210_recomputed_beside_its_misprints(capsys, name, kappa, modification, life, printed):
    """The article on worm oils prints nu1 = 27.6, which is that of 65 mm; its 85 mm make 24.13."""
    rating = rated(capsys, "bearing_nu2210")[f"bearing {name}"]
    ours, theirs = rating["computed"], rating["printed"]
    assert ours["reference_viscosity_m2_s"] == pytest.approx(24.13e-6, rel=2e-4)
    assert ours["kappa"] == pytest.approx(kappa, abs=6e-4)
    assert ours["modification"] == pytest.approx(modification, abs=6e-4)
    assert ours["basic_life_rev"] == pytest.approx(150.4e6, rel=3e-4)
    assert ours["basic_life_h"] == pytest.approx(4179, rel=3e-4)
    assert ours["modified_life_rev"] == pytest.approx(life * 1e6, rel=5e-4)
    assert theirs["reference_viscosity_m2_s"] == pytest.approx(27.6e-6)
    values = [theirs[key] for key in ("kappa", "modification", "modified_life_rev")]
    assert values == pytest.approx([printed[0], printed[1], printed[2] * 1e6])
    hours = {"vg_220": 4750, "vg_460": 7292}[name]
    assert theirs["modified_life_h"] == pytest.approx(hours)


def test_worm_gear_of_sharif_2001_by_the_standards_own_units(capsys):
    """h_min,m of DIN 3996 (2012) by hand, in rpm, mm, N/mm2 and N m, and what follows from friction."""
    worm = rated(capsys, "oil_zi")["worm"]["standard"]
    q, x, z1, z2, mx, u = 8.5, -0.42, 3, 59, 9.145, 59 / 3
    wide = (6 * mx * q * mx - 9 * mx**2 + mx) ** 0.5
    shape = 2.9157e-6 * z2**-0.0847 * 20**0.0595 * (7.947e-7 * x + 5.927e-5)
    shape *= ((1 - 0.038 * q) * q + 65.576) * ((108.8547 * z1 / q - 1) * z1 / q - 3294.921)
    shape = shape * ((0.003291 * wide + 1) * wide - 13064.58) - 0.393
    assert worm["film_parameter"] == pytest.approx(shape, rel=1e-12)
    # polyglycol VG 460 on flanks as warm as the rating says: log10 log10(nu + 0.7) = 5.7612 - 2.1381 log10 T
    kelvin = worm["bulk_temperature_C"] + 273.15
    nu = 10**10 ** (5.7612 - 2.1381 * np.log10(kelvin)) - 0.7
    eta = nu * 1e-6 * 1059 * (1 - 7.1e-4 * (kelvin - 288.15))
    film = 21 * shape * 1.3e-8**0.6 * eta**0.7 * 1500**0.7 * 304.8**1.39 * 170810**0.03
    assert worm["film_m"] == pytest.approx(film / 6690**0.13 * 1e-6, rel=2e-3)
    assert worm["specific_film"] == pytest.approx(worm["film_m"] / 0.34**0.5 * 1e6)
    speed = worm["sliding_speed_m_s"]
    assert speed == pytest.approx(pi * q * mx * 1e-3 * 25 / np.cos(atan(z1 / q)), rel=1e-3)
    # Y_S ends at 250 mm, Y_W of CuSn12Ni2 is 0.95
    friction = (0.024 + 0.0032 / (speed + 0.1) ** 1.71) * (100 / 250 * 0.07 / shape) ** 0.5
    assert worm["friction"] == pytest.approx(friction * 0.95 * (0.8 * 0.3 / 0.5) ** 0.25, rel=1e-9)
    lead = atan(z1 / q)
    forward = tan(lead) / tan(lead + atan(worm["friction"]))
    assert worm["efficiency"] == pytest.approx(forward)
    assert worm["efficiency_back"] == pytest.approx(tan(lead - atan(worm["friction"])) / tan(lead))
    output = 6690 * 1500 * pi / 30 / u
    assert worm["loss_W"] == pytest.approx(output / forward - output)
    warmed = 60 + worm["loss_W"] / ((1940 + 15 * 1500) * 60.33 * (z2 + 2 * x) * mx * 1e-6)
    assert worm["bulk_temperature_C"] == pytest.approx(warmed)


def test_the_drive_makes_the_same_worm_gear_as_its_table(capsys):
    """Module, diameter factor and torque derived from the ZI drive are those written in oil_zi.toml."""
    table, drive = (
        rated(capsys, name)["worm"]["standard"] for name in ("oil_zi", "zi_sharif_2001")
    )
    for key, value in table.items():
        expected = value if isinstance(value, str) else pytest.approx(value, rel=1e-3)
        assert drive[key] == expected, key


TRIAL = (DATA / "zi_a100.toml").read_text()


def worm_of(text, tmp_path, capsys, changes=()):
    """What `rate` makes of a worm drive's case, and what it leaves out."""
    (tmp_path / "trial.toml").write_text(changed(text, *changes))
    content = said(capsys, "rate", tmp_path / "trial.toml")
    return content["ratings"][0], content["not_rated"]


def test_the_drives_profile_shift_is_in_its_rating(tmp_path, capsys):
    """q = 10 by its lead angle of atan(2/10), whose base lead angle at 20 degrees the drawing has."""
    lead = atan(2 / 10)
    base = np.degrees(np.arccos(np.cos(lead) * np.cos(np.radians(20))))
    assert base == pytest.approx(22.8618, abs=1e-4)
    worm, _ = worm_of(TRIAL, tmp_path, capsys)
    assert worm["standard"]["locking"] == pytest.approx(worm["standard"]["friction"] * 10 / 2)
    assert "profile shift of the wheel -0.500" in worm["words"][0]
    speed = 1500 * pi / 30 * 20e-3 / np.cos(lead)
    assert worm["standard"]["sliding_speed_m_s"] == pytest.approx(speed)


@pytest.mark.parametrize(
    ("threads", "factor", "rpm", "verdict"),
    [
        (2, 10, 1500, "Not self-locking, neither running nor at rest"),
        (1, 14, 1500, "Self-locking at rest only"),
        (1, 25, 20, "Self-locking, running and at rest"),
    ],
)
def test_self_locking_is_rated_running_and_at_rest(tmp_path, capsys, threads, factor, rpm, verdict):
    """Lead angle against friction angles: a worm may hold a load at rest that it lets go once it runs."""
    distance = (factor + 41) * 2
    text = changed(
        WORM,
        ("304.8 mm", f"{distance} mm"),
        ("9.145 mm", "4 mm"),
        ("60.33 mm", "30 mm"),
        ("6.69 kN m", "0.3 kN m"),
        ("teeth = 59", "teeth = 41"),
        ("starts = 3", f"starts = {threads}"),
        ("diameter_factor = 8.5", f"diameter_factor = {factor}"),
        ("profile_shift = -0.42", "profile_shift = 0.0"),
        ('worm_speed = "1500 rpm"', f'worm_speed = "{rpm} rpm"'),
    )
    worm, _ = worm_of(text, tmp_path, capsys)
    standard = worm["standard"]
    rest = 0.13 * (100 / distance) ** 0.25 * 0.95 * (0.8 * 0.3 / 0.5) ** 0.25
    assert standard["friction_rest"] == pytest.approx(rest)
    assert standard["locking_rest"] == pytest.approx(rest * factor / threads)
    assert any(words.startswith(verdict) for words in worm["words"])


def test_wear_beyond_the_tooth_is_a_failed_rating(tmp_path, capsys):
    """Mineral oil as thin as water on a creeping worm: the standard's wear comes to more than the tooth."""
    thin = [
        ('"PAG VG 220"\ntemp', '"mineral VG 32"\ntemp'),
        ('"PAG VG 220"\nsump', '"mineral VG 32"\nsump'),
    ]
    worm, left = worm_of(TRIAL, tmp_path, capsys, thin)
    thickness = pi / 2 * 4e-3 * np.cos(atan(2 / 10))
    allowed = 0.3 * 4e-3 * np.cos(atan(2 / 10))
    standard = worm["standard"]
    assert standard["wear_depth_m"] > thickness
    safety = worm["safeties"]["S_W"]
    assert safety["value"] == pytest.approx(allowed / standard["wear_depth_m"])
    assert safety["verdict"] == "not sufficient"
    assert any("would take the whole tooth, which is 6.16 mm thick" in of for of in worm["failed"])
    assert main(["rate", str(tmp_path / "trial.toml")]) == 0
    assert "FAILED: Wear of" in capsys.readouterr().out
    assert not any(of.startswith("S_W") for of in left)


def test_what_is_not_rated_is_listed_with_its_reason(tmp_path, capsys):
    _, left = worm_of(TRIAL, tmp_path, capsys)
    assert any(of.startswith("Scuffing") for of in left)
    assert any(of.startswith("Bearings") for of in left)
    assert main(["rate", str(tmp_path / "trial.toml")]) == 0
    text = " ".join(capsys.readouterr().out.split())
    assert all(of in text for of in left) and "[bearings.NAME]" in text
    shorter = [('wheel_material = "CuSn12Ni2"\nlife = "25000 h"\n', "")]
    _, left = worm_of(TRIAL, tmp_path, capsys, shorter)
    missing = "worm_rating.wheel_material is missing, worm_rating.life is missing."
    assert f"S_H, pitting of the wheel flanks: {missing}" in left
    assert f"S_W, wear of the wheel flanks: {missing}" in left


def test_a_safety_below_one_fails(tmp_path, capsys):
    worm, _ = worm_of(TRIAL, tmp_path, capsys, [('"600 N m"', '"1000 N m"')])
    assert worm["safeties"]["S_H"]["value"] < 1
    assert any(of.startswith("S_H = ") for of in worm["failed"])
    worm, _ = worm_of(TRIAL, tmp_path, capsys)
    assert worm["safeties"]["S_H"]["value"] > 1 and worm["failed"] == []


@pytest.mark.parametrize(
    ("text", "old", "new", "sentence"),
    [
        (
            TRIAL,
            '"PAG VG 220"\nsump',
            '"PAG VG 460"\nsump',
            'but oil.name = "PAG VG 220": one sump',
        ),
        (
            (CASES / "zi_sharif_2001.toml").read_text(),
            '"PAG VG 460"\nsump_temperature',
            '"PAG VG 220"\nsump_temperature',
            "but worm_rating.oil = ",
        ),
    ],
)
def test_two_oils_in_one_file_are_refused(refuse, text, old, new, sentence):
    assert sentence in refuse(changed(text, (old, new)))
    assert sentence in refuse(changed(text, (old, new)), "check")


def test_an_oil_thicker_than_the_one_named_is_refused(refuse):
    text = (CASES / "zi_sharif_2001.toml").read_text().replace('"PAG VG 460"', '"PAG VG 220"')
    error = refuse(text)
    assert 'worm_rating.oil = "PAG VG 220" has 0.103 Pa s at 60 degC' in error
    assert "oil.viscosity is 0.227 Pa s" in error


MEASURED = """law = "tabulated"
pressure = ["0 Pa", "100 MPa", "200 MPa", "400 MPa"]
temperature = ["40 degC", "60 degC", "80 degC"]
viscosity_at = [
    ["0.5 Pa s", "0.227 Pa s", "0.12 Pa s"], ["2 Pa s", "0.9 Pa s", "0.4 Pa s"],
    ["7 Pa s", "3 Pa s", "1.2 Pa s"], ["60 Pa s", "20 Pa s", "7 Pa s"],
]
"""
MEASURED_OIL = (
    ('law = "roelands"\neta0 = "0.227 Pa s"\nz = 0.227\n', MEASURED),
    ('pole_coefficient = "5.1 1/GPa" # equation 20\n', ""),
    ("s0 = 0.782\n", ""),
)


def test_an_oil_given_by_measurements_is_held_against_the_one_named(refuse, tmp_path):
    """Its table has no eta0, of which the comparison was made."""
    text = changed((CASES / "zi_sharif_2001.toml").read_text(), *MEASURED_OIL)
    (tmp_path / "same.toml").write_text(text)
    pyworm.load(tmp_path / "same.toml")
    error = refuse(text.replace('"PAG VG 460"', '"PAG VG 220"'))
    assert "has 0.103 Pa s at 60 degC, but oil.viscosity is 0.227 Pa s" in error


def test_a_bearing_in_grease_has_an_oil_of_its_own(tmp_path, capsys):
    grease = ('"PAG VG 460"\ntemp', '"mineral VG 220"\ntemp'), ('"oil bath"', '"grease"')
    worm_of(changed(WORM, *grease, ('"-/17/14"', '"high"')), tmp_path, capsys)


def test_errichellos_teeth_beside_his_figures(capsys):
    """2.1 microinch, 0.073, 439 and 418 degF, 63 %, above 95 %; the assumed gears have 13 % more film."""
    teeth = rated(capsys, "errichello_speed_increaser")["gear teeth"]
    ours, printed = teeth["closed form"], teeth["printed"]
    assert printed["film_min_m"] == pytest.approx(2.1 * MICROINCH)
    assert printed["contact_temperature_C"] == pytest.approx((439 - 32) * FAHRENHEIT)
    assert ours["pitch_line_velocity_m_s"] == pytest.approx(400 * 0.3048 / 60, rel=0.01)
    assert ours["film_min_m"] == pytest.approx(2.1 * MICROINCH, rel=0.14)
    assert ours["specific_film"] == pytest.approx(ours["film_min_m"] / (800**0.5 * MICROINCH))
    assert ours["contact_temperature_C"] == pytest.approx((439 - 32) * FAHRENHEIT, abs=6)
    assert ours["scuffing_temperature_C"] == pytest.approx((418 - 32) * FAHRENHEIT, abs=1e-6)
    assert ours["scuffing_probability"] == pytest.approx(0.63, abs=0.07)
    assert ours["scuffing_risk"] == "high"
    assert ours["wear_probability"] > 0.95
    assert ours["regime"] == "boundary"
    assert ours["loss_W"] == pytest.approx(258.0e3 * 0.1 * ours["loss_factor"], rel=1e-3)


def test_errichellos_oil_supply(capsys):
    """7000/sqrt(403) mm2/s; 346 hp over 200 hp/gpm is 1.73 gpm; jets pass the flow by Torricelli."""
    supply = rated(capsys, "errichello_speed_increaser")["gear oil supply"]["computed"]
    assert supply["viscosity_40_m2_s"] == pytest.approx(7000 / 402.8**0.5 * 1e-6, rel=1e-3)
    assert supply["nearest_grade"] == 320
    gpm = 3.785411784e-3 / 60
    for word, c in (("copious", 200), ("adequate", 400), ("lean", 800), ("starved", 1000)):
        assert supply[f"flow_{word}_m3_s"] == pytest.approx(346 / c * gpm, rel=1e-4)
    speed = (2 * 30 * 6894.757 / 847) ** 0.5
    assert supply["jet_velocity_m_s"] == pytest.approx(speed, rel=1e-3)
    holes = 4 * 0.7 * pi / 4 * supply["jet_diameter_m"] ** 2
    assert holes * speed == pytest.approx(supply["flow_copious_m3_s"], rel=1e-3)


# ------------------------------------------------------------------ what the simulation says beside


@pytest.fixture(scope="module")
def worm_case():
    return pyworm.load(CASES / "zi_sharif_2001.toml")


def worm_result(case, **changes):
    solutions = tuple(make_hot_worm(phase, **changes) for phase in (0.25, 0.75))
    return Result(case.name, case.resolved, solutions, make_mesh_cycle(), {})


def simulated(case, result):
    return ratings(rating_request(case), result)[0].summary()["simulation"]


def test_the_simulation_stands_beside_the_standard(worm_case):
    result = worm_result(worm_case)
    beside = simulated(worm_case, result)
    films = [solution.figures.film_min.value for solution in result.solutions]
    losses = [solution.figures.power_loss.value for solution in result.solutions]
    assert beside["film_m"] == pytest.approx(np.mean(films))
    assert beside["specific_film"] == pytest.approx(np.mean(films) / 0.34**0.5 * 1e6)
    # a pair is in mesh for 239.8 deg of the worm's turn, the next comes after 120 deg
    loss = np.mean(losses) * 239.8 / 120
    assert beside["loss_W"] == pytest.approx(loss, rel=5e-4)
    # 14 kN on each of two teeth, on an arm of 239 mm, at 1500 rpm times 3/59
    output = 6.69e3 * 50 * pi * 3 / 59
    assert beside["efficiency"] == pytest.approx(output / (output + loss), rel=1e-4)
    assert beside["efficiency_back"] == pytest.approx((output - loss) / output, rel=1e-4)


def test_quantities_not_simulated_are_not_shown(worm_case):
    result = worm_result(worm_case)
    cold = replace(result, solutions=tuple(map(without_heat, result.solutions)))
    assert "surface_temperature_max_C" in simulated(worm_case, result)
    assert "surface_temperature_max_C" not in simulated(worm_case, cold)
    assert {"friction", "loss_W"} <= set(simulated(worm_case, cold))


def test_gears_of_constant_friction_lose_it_times_their_loss_factor():
    """With the same friction at every phase the mean over the line of action is that friction."""
    case = pyworm.load(CASES / "errichello_speed_increaser.toml")
    solutions = tuple(line_with_heat(make_line_solution(phase=p)) for p in (0.13, 0.6, 0.87))
    friction = solutions[0].figures.friction_coefficient.value
    result = Result(case.name, case.resolved, solutions, None, {})
    beside = ratings(rating_request(case), result)[0].summary()["simulation"]
    assert beside["friction"] == pytest.approx(friction)
    assert beside["loss_W"] == pytest.approx(case.drive.power * case.drive.loss_factor * friction)
    assert beside["efficiency"] == pytest.approx(1 - case.drive.loss_factor * friction)


def test_film_formulas_stand_beside_the_thinnest_film_solved(worm_case):
    result = worm_result(worm_case)
    thin = min(result.solutions, key=lambda of: of.figures.film_min.value)
    films = next(of for of in ratings(rating_request(worm_case), result) if of.key == "films")
    assert films.title == f"Films by formula at phase {thin.phase}"
    summary = films.summary()
    assert summary["central film"]["simulated_m"] == thin.figures.film_central.value
    assert summary["minimum film"]["simulated_m"] == thin.figures.film_min.value
    outside = next(words for words in films.words if words.startswith("Not shown"))
    assert "Hamrock and Dowson 1977 (ellipticity 0.21, made for 1 to 8)" in outside
    assert "Masjedi and Khonsari 2015 (ellipticity 0.21, made for 1 to 8)" in outside
    shown = {key for key, value in summary["central film"].items() if value is not None}
    assert shown == {"chittenden_m", "simulated_m"}


def test_film_formulas_of_errichellos_thinnest_listed_contact(capsys):
    """Dowson and Higginson by hand from the curvature, speed, load and oil at phase 0.13."""
    films = rated(capsys, "errichello_speed_increaser")["films"]
    scene = pyworm.load(CASES / "errichello_speed_increaser.toml").scene(phase=0.13)
    modulus = 207e9 / (1 - 0.3**2)
    u = 6.6e-3 * sum(scene.velocities) / 2 / (modulus * scene.radius)
    g, w = 1.02e-4 / 6894.757 * modulus, scene.load / (modulus * scene.radius)
    least = 2.65 * scene.radius * u**0.7 * g**0.54 * w**-0.13
    assert films["minimum film"]["dowson_higginson_m"] == pytest.approx(least, rel=1e-4)
    central = 3.06 * scene.radius * u**0.69 * g**0.56 * w**-0.10
    assert films["central film"]["dowson_toyoda_m"] == pytest.approx(central, rel=1e-4)
    assert "moes_m" in films["central film"] and "moes_m" in films["minimum film"]
    heat = next(words for words in films["words"] if words.startswith("Heating of the inlet"))
    shares = [float(share) for share in re.findall(r"([0-9.]+) \(", heat.split("film: ")[1])]
    assert len(shares) == 3 and all(0.97 < share < 1 for share in shares)


def test_rate_with_a_result_file(tmp_path, capsys, worm_case):
    path = worm_result(worm_case).save(tmp_path / "result.nc")
    worm = said(capsys, "rate", CASES / "zi_sharif_2001.toml", "--result", path)["ratings"][0]
    assert {"standard", "simulation"} <= set(worm)
    error = refusal(["rate", str(CASES / "oil_zi.toml"), "--result", str(path)], tmp_path, capsys)
    assert "has no [drive] that a result could be of" in error


# ---------------------------------------------------------------------------------------- trends

BEARING_TABLE = BearingTable.model_validate(tomllib.loads(BEARING)["bearings"]["vg_220"])


def life(**changes):
    table = BEARING_TABLE.model_copy(update=changes)
    return bearing_life(table, Path(), carried_load(table, None)).modified_life


@given(st.floats(3e-6, 3e-4), st.floats(1.001, 3))
def test_bearings_live_longer_on_thicker_oil(viscosity, more):
    assert life(viscosity=viscosity * more) >= life(viscosity=viscosity)


@given(st.floats(1e3, 4e4), st.floats(1.01, 1.1), st.floats(0.05, 0.9), st.floats(1.01, 1.1))
def test_bearings_live_shorter_under_load_and_dirt(load, heavier, clean, cleaner):
    assert life(load=load * heavier) < life(load=load)
    assert life(contamination=clean * cleaner) >= life(contamination=clean)


def test_the_last_of_many_bearings_live_shorter():
    lives = [life(reliability=r) for r in (0.9, 0.95, 0.99)]
    assert np.array(lives[1:]) / lives[0] == pytest.approx([0.64, 0.25], abs=0.006)


WORM_TABLES = checked(RatingCase, tomllib.loads(WORM))


def worm_standard(sump=333.15, **duty):
    table = WORM_TABLES.worm_rating.completed()
    table = table.model_copy(update={"sump_temperature": sump})
    duty = replace(worm_duty_of_table(WORM_TABLES.worm_gear), **duty)
    return RatedWormGear(table, duty, Path()).hardest.rated


@settings(max_examples=30)
@given(st.floats(290, 370), st.floats(1, 30), st.floats(5, 70), st.floats(1.05, 3))
def test_worm_films_thin_with_heat_and_load_and_grow_with_speed(sump, rise, speed, more):
    base = worm_standard(sump, worm_speed=speed)
    assert worm_standard(sump + rise, worm_speed=speed).film < base.film
    heavy = worm_standard(sump, worm_speed=speed, torque=6690 * more)
    assert heavy.film < base.film and heavy.mean_pressure > base.mean_pressure
    assert heavy.pitting_safety < base.pitting_safety
    assert (
        worm_standard(sump, worm_speed=speed * more).forward_efficiency >= base.forward_efficiency
    )


# -------------------------------------------------------------------------------------- refusals

ESTER = changed(WORM, ('"PAG VG 460"\ntemp', '"ester VG 320"\ntemp'))
"""The worm's bearing in another oil than the standards know."""


@pytest.fixture
def refuse(tmp_path, monkeypatch, capsys):
    """A command on a case text in an empty directory; the sentence of its refusal."""
    monkeypatch.chdir(tmp_path)

    def run(text, *command):
        Path("case.toml").write_text(text)
        return refusal([*(command or ["rate"]), "case.toml"], tmp_path, capsys)

    return run


@pytest.mark.parametrize(
    ("text", "old", "new", "sentence"),
    [
        # units and sizes mistaken
        (BEARING, '"22 mm^2/s"', '"22 mPa s"', "must be a kinematic viscosity"),
        (BEARING, '"20 kN"', '"20 kg"', 'bearings.vg_220.load = "20 kg": must be a force'),
        (BEARING, '"20 kN"', "20", "bearings.vg_220.load = 20"),
        (BEARING, '"600 rpm"', '"600 m/s"', "must be a speed of rotation"),
        (
            BEARING,
            "contamination = 0.6",
            "contamination = 6",
            "contamination = 6: must be at most 1",
        ),
        (BEARING, '"roller"', '"needle"', 'elements = "needle": must be "ball" or "roller"'),
        (WORM, '"6.69 kN m"', '"6.69 kN"', "worm_gear.wheel_torque"),
        (WORM, '"304.8 mm"', '"304.8 cm"', "centre distance = 3.048 m"),
        (WORM, '"9.145 mm"', '"91.45 um"', "module = 9.145e-05 m"),
        (WORM, '"0.3 um"', '"0.3 mm"', 'worm_gear.worm_roughness = "0.3 mm": must be a root mean'),
        (WORM, '"170.81 GPa"', '"170.81 MPa"', "reduced modulus = 1.7081e+08 Pa"),
        (WORM, '"25000 h"', '"25000"', "worm_rating.life"),
        (INCREASER, '"30 psi"', '"30 N"', "gear_rating.feed_pressure"),
        # what belongs together
        (
            BEARING,
            'viscosity = "22 mm^2/s"',
            'viscosity = "22 mm^2/s"\noil = "PAG VG 220"\ntemperature = "60 degC"',
            "give either viscosity or oil with temperature",
        ),
        (BEARING, "contamination = 0.6 #", 'lubrication = "oil bath" #', "cleanliness together"),
        (
            BEARING,
            'fatigue_load_limit = "11.4 kN"',
            'fatigue_load_limit = "11.4 kN"\nstatic_rating = "88 kN"',
            "fatigue_load_limit or static_rating",
        ),
        (BEARING, 'viscosity = "22 mm^2/s"', 'oil = "PAG VG 220"', "oil and temperature together"),
        (INCREASER, "jets = 4\n", "", "flow, feed_pressure and jets together"),
        (
            INCREASER,
            'flow = "copious"\nfeed_pressure = "30 psi"\njets = 4\n',
            "jet_length = 2\n",
            "jet_length has no effect without jets",
        ),
        # what there is
        (WORM, '"PAG VG 460"', '"PAG VG 450"', 'oil "PAG VG 450": must be a base stock'),
        (WORM, '"CuSn12Ni2"', '"brass"', 'wheel_material = "brass": must be'),
        (WORM, "diameter_factor = 8.5\n", "diameter_factor = 10.5\n", "make 0.313948 m"),
        # one sump, one oil
        (WORM, '"PAG VG 460"\ntemp', '"PAG VG 220"\ntemp', "one sump holds one oil, name the same"),
        (WORM, "module = ", "modul = ", "worm_gear.modul: no such key; did you mean module?"),
        (WORM, "[worm_gear]", "[worm_geer]", "worm_geer: no such key; did you mean worm_gear or"),
        (WORM, "worm_gear.module = ", "worm_gear.modul = ", "does not give worm_gear.modul"),
        (INCREASER, "drive.module = ", "drive.rim = ", "the file does not give drive.rim"),
    ],
)
def test_wrong_ratings_are_refused_in_one_sentence(refuse, text, old, new, sentence):
    assert sentence in refuse(changed(text, (old, new)))


def test_jets_of_thick_oil_are_larger(tmp_path, capsys):
    """With the length of their holes, jets are sized for the viscosity of the oil as it enters."""
    plain = rated(capsys, "errichello_speed_increaser")["gear oil supply"]["computed"]
    (tmp_path / "thick.toml").write_text(
        changed(INCREASER, ("jets = 4\n", "jets = 4\njet_length = 2\n"))
    )
    found = said(capsys, "rate", tmp_path / "thick.toml")["ratings"]
    thick = next(rating for rating in found if rating["rating"] == "gear oil supply")["computed"]
    assert "jet_discharge" not in plain
    larger = (0.7 / thick["jet_discharge"]) ** 0.5
    assert thick["jet_diameter_m"] == pytest.approx(plain["jet_diameter_m"] * larger)
    assert 1.005 < larger < 1.1  # oil of 230 degF


def test_rate_names_missing_data(refuse):
    sphere = (CASES / "point_m20_l10.toml").read_text()
    assert 'drives of kind "worm", "gear-pair", "roller-worm" and bearings are rated' in refuse(
        sphere
    )
    assert "[drive], [bearings.NAME] or [worm_gear]" in refuse('title = "?"\nsource = "?"')
    plain = WORM[: WORM.index("[worm_rating]")]
    assert "give [worm_rating] or [bearings.NAME]" in refuse(plain)
    assert "[oil_choice] is missing" in refuse(BEARING, "oil", "choose")


def test_worms_of_unknown_flanks_are_rated_without_them(tmp_path, capsys):
    """Strengths need no roughness; the friction of the worm's flanks does, and wear by the wheel's heat."""
    drive = (CASES / "zi_sharif_2001.toml").read_text()
    rough = 'bodies.worm.roughness = "a ground worm"\n'
    smooth = changed(drive, ('roughness = "0.3 um"\n', ""), (rough, ""))
    worm, left = worm_of(smooth, tmp_path, capsys)
    built = {symbol: of["value"] for symbol, of in worm["safeties"].items()}
    assert None not in (built["S_H"], built["S_F"], built["S_T"])
    assert built["S_W"] is built["S_delta"] is None
    assert worm["safeties"]["S_delta"]["why"] == "bodies.worm.roughness is missing."
    assert any("Specific film" in of and "roughness is missing" in of for of in left)


ONE_BEARING = """
title = "A ball bearing by its catalogue"
source = "C, P and n of an example"

[bearings.worm]
elements = "ball"
dynamic_rating = "30 kN"
load = "3 kN"
speed = "1000 rpm"
"""


def test_a_bearing_of_c_p_and_n_alone_has_its_basic_life(tmp_path, capsys):
    (tmp_path / "bearing.toml").write_text(ONE_BEARING)
    content = said(capsys, "rate", tmp_path / "bearing.toml")
    computed = content["ratings"][0]["computed"]
    assert computed["basic_life_rev"] == pytest.approx(1e9)
    assert computed["basic_life_h"] == pytest.approx(1e9 / 1000 / 60)
    assert "modified_life_h" not in computed
    missing = " ".join(content["not_rated"])
    for key in ("viscosity", "mean_diameter", "contamination"):
        assert f"{key} is missing" in missing
    assert main(["rate", str(tmp_path / "bearing.toml")]) == 0
    shown = capsys.readouterr().out
    assert "1000 Mrev" in shown and "not rated" in shown


@pytest.mark.parametrize(
    ("old", "new", "lost", "why"),
    [
        ('"22 mm^2/s"', '"22 m^2/s"', "modified_life_h", "kinematic viscosity = 22 m2/s: must lie"),
        ('"85 mm" # ', '"15 m" # ', "kappa", "mean diameter of the bearing = 15 m"),
        (
            '"90 kN"',
            '"30 kN"',
            "basic_life_h",
            "holds up to half of the dynamic load rating, 15000 N",
        ),
        ('viscosity = "22 mm^2/s"', "", "kappa", "viscosity is missing, or oil with temperature"),
        ('fatigue_load_limit = "11.4 kN"', "", "modification", "fatigue_load_limit is missing"),
    ],
)
def test_a_bearing_is_rated_line_by_line(tmp_path, capsys, old, new, lost, why):
    (tmp_path / "bearing.toml").write_text(changed(BEARING, (old, new)))
    assert main(["rate", str(tmp_path / "bearing.toml"), "--json"]) == 0
    content = json.loads(capsys.readouterr().out)
    computed = content["ratings"][0]["computed"]
    assert lost not in computed and "reliability_factor" in computed
    assert any(
        sentence.startswith("bearings.") and why in sentence for sentence in content["not_rated"]
    )


def test_a_worm_gear_in_ester_is_rated_line_by_line(tmp_path, capsys):
    worm, _ = worm_of(ESTER, tmp_path, capsys, [('"PAG VG 460"', '"ester VG 320"')])
    built = worm["safeties"]
    assert built["S_F"]["value"] and built["S_T"]["value"]
    for symbol in ("S_W", "S_H", "S_delta"):
        assert "the standards know mineral, PAO, PAG only" in built[symbol]["why"]


def test_a_file_of_ratings_alone_cannot_be_solved(refuse):
    assert "ratings only; pyworm rate shows them" in refuse(BEARING, "run")


def test_gears_of_unknown_flanks_are_rated_without_them():
    case = pyworm.load(CASES / "errichello_speed_increaser.toml")
    bodies = tuple(replace(body, roughness=None) for body in case.drive.bodies)
    unknown = replace(case.drive, surfaces=None, bodies=bodies)
    teeth, _, films, _ = ratings(replace(rating_request(case), drive=unknown))
    known = teeth.summary()["closed form"]
    assert {"film_min_m", "hertz_pressure_Pa", "loss_factor"} <= set(known)
    assert not {"specific_film", "friction", "contact_temperature_C"} & set(known)
    assert "lambda" not in " ".join(films.words)


# ------------------------------------------------------------------------------------------- oils


def test_oil_list_has_every_oil_by_name(capsys):
    oils = said(capsys, "oil", "list")["oils"]
    assert len({oil["name"] for oil in oils}) == 40
    thick = next(oil for oil in oils if oil["name"] == "mineral VG 1000")
    assert thick["pressure_viscosity_1_Pa"][0] is None  # 0 degC: thicker than its law
    assert thick["pressure_viscosity_1_Pa"][2] > thick["pressure_viscosity_1_Pa"][5] > 1e-8
    assert main(["oil", "show", "mineral VG 1000"]) == 0
    assert main(["oil", "list"]) == 0
    assert "PAG VG 460" in capsys.readouterr().out


def test_oil_show_has_units_in_its_keys_and_sources(capsys):
    (oil,) = said(capsys, "oil", "show", "pag vg 460")["oils"]
    at = oil["temperature_C"].index(100)
    assert oil["kinematic_viscosity_m2_s"][at] == pytest.approx(66.8e-6, rel=1e-3)
    assert oil["viscosity_Pa_s"][at] == pytest.approx(
        oil["kinematic_viscosity_m2_s"][at] * oil["density_kg_m3"][at]
    )
    assert oil["source"] and all(oil["sources"].values())
    assert main(["oil", "show", "PAG VG 460"]) == 0
    assert "66.78" in capsys.readouterr().out


def test_oil_show_takes_a_file(tmp_path, capsys):
    (tmp_path / "mine.toml").write_text(
        'name = "Shop oil 12"\nsource = "data sheet"\nbase = "PAO"\n'
        'viscosity_40 = "225 mm^2/s"\nviscosity_100 = "27 mm^2/s"\n'
    )
    (oil,) = said(capsys, "oil", "show", tmp_path / "mine.toml")["oils"]
    assert oil["kinematic_viscosity_m2_s"][2] == pytest.approx(225e-6)
    assert oil["name"] == "Shop oil 12"


def test_oil_chart_draws_two_charts(tmp_path, capsys):
    assert main(["oil", "chart", "PAG VG 460", "--out", str(tmp_path / "charts")]) == 0
    paths = [Path(line) for line in capsys.readouterr().out.splitlines()]
    assert [path.name for path in paths] == ["oil_viscosity.png", "oil_pressure_viscosity.png"]
    assert all(path.read_bytes().startswith(b"\x89PNG") for path in paths)


def test_unknown_oils_are_refused(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for command in (["show"], ["chart", "--out", "charts"]):
        error = refusal(["oil", *command, "lard"], tmp_path, capsys)
        assert 'oil "lard": must be a base stock' in error
    assert "mine.toml" in refusal(["oil", "show", "mine.toml"], tmp_path, capsys)


def test_oil_choose_prints_its_page_or_json(capsys):
    path = CASES / "errichello_speed_increaser.toml"
    content = said(capsys, "oil", "choose", path)
    assert (content["oil"], content["grade"], content["reached"]) == ("mineral VG 320", 320, False)
    assert content["viscosity_needed_40_m2_s"] is None
    assert [step["title"] for step in content["steps"]][-1] == "Recommendation"
    assert main(["oil", "choose", str(path)]) == 0
    text = capsys.readouterr().out
    assert len(text.splitlines()) < 70
    assert "thicker oil is not the cure" in text
