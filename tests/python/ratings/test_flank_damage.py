"""Scuffing and micropitting: safeties of gears by closed forms and simulated, comparison of worm gears."""

import json
import tomllib
from dataclasses import replace

import numpy as np
import pytest
from folders import CASES
from synthetic_solution import line_with_heat, make_hot_worm, make_line_solution, make_mesh_cycle

import pyworm
from pyworm.case.case import case_of
from pyworm.cli.main import main
from pyworm.formulas.scuffing import scuffing_safety, scuffing_temperature_of_stage
from pyworm.io.input_error import CaseError
from pyworm.ratings.rated_case import not_rated, rating_request, ratings
from pyworm.result.result import Result
from pyworm.solver.estimate import Estimate

TESTED = {"base": "PAO", "scuffing_load_stage": 12, "micropitting_load_stage": 9}
OIL = 60 + 273.15


UNTESTED = (CASES / "spur_pair.toml").read_text().partition("# For pyworm rate")[0]


@pytest.fixture(scope="module")
def untested(tmp_path_factory):
    """The shipped pair of gears without tests of its oil."""
    path = tmp_path_factory.mktemp("cases") / "spur_pair.toml"
    path.write_text(UNTESTED)
    return pyworm.load(path)


def gears(**tested):
    return pyworm.load(CASES / "spur_pair.toml").with_found({"gear_rating": tested})


def solved(case, *phases, **changes):
    built = []
    for phase in phases:
        one = line_with_heat(replace(make_line_solution(phase=phase), inlet_temperature=OIL))
        built.append(replace(one, **changes))
    return Result(case.name, case.resolved, tuple(built), None, {})


def rated(case, result=None):
    asked = rating_request(case)
    built = ratings(asked, result)
    return {of.key: of for of in built}, not_rated(asked, built)


def safeties(case, result=None):
    built, _ = rated(case, result)
    return {of.symbol: of for of in built["gear teeth"].safeties}


def test_stage_12_of_a_mineral_oil_of_30_mpa_s_scuffs_at_353_degrees():
    """80 + (0.85 + 1.4) 144 30^-0.05 by hand; polyalphaolefins have a fifth less above 80."""
    by_hand = 2.25 * 144 / 30**0.05
    assert by_hand == pytest.approx(273.3, abs=0.1)
    assert scuffing_temperature_of_stage(12, 0.03) - 273.15 == pytest.approx(80 + by_hand)
    assert scuffing_temperature_of_stage(12, 0.03, 0.8) - 273.15 == pytest.approx(
        80 + 0.8 * by_hand
    )
    nitrided, carburised = (scuffing_temperature_of_stage(12, 0.03, 1.0, x) for x in (1.5, 1.0))
    assert nitrided > carburised
    assert scuffing_safety(OIL + 50, OIL, OIL + 150) == pytest.approx(3)
    with pytest.raises(ValueError, match="rise of the contact"):
        scuffing_safety(OIL - 1, OIL, OIL + 150)


def test_what_the_oil_bears_is_not_known_without_its_tests(untested):
    built, left = rated(untested)
    by_name = {of.symbol: of for of in built["gear teeth"].safeties}
    assert by_name["S_B"].verdict == by_name["S_lambda"].verdict == "cannot be rated"
    assert any("scuffing_load_stage" in sentence for sentence in left)
    assert any("micropitting_load_stage" in sentence for sentence in left)
    stage = untested.with_found({"gear_rating": {"scuffing_load_stage": 12}})
    assert "base of the oil is missing" in safeties(stage)["S_B"].why
    assert "flanks" not in built


def test_closed_forms_along_the_line_of_action(untested):
    built = safeties(gears(**TESTED))
    assert set(built) == {"S_B", "S_lambda"}
    hot, limit = built["S_B"].inputs["theta_B_C"], built["S_B"].inputs["theta_S_C"]
    assert built["S_B"].value == pytest.approx((limit - 60) / (hot - 60))
    film = built["S_lambda"].inputs
    assert film["Ra_um"] == pytest.approx(0.8 * (0.51 + 0.40) / 2)
    assert film["lambda_GF"] == pytest.approx(film["film_um"] / film["Ra_um"])
    assert built["S_lambda"].value == pytest.approx(film["lambda_GF"] / film["lambda_GFP"])
    permissible = {"base": "PAO", "permissible_specific_film": film["lambda_GF"] / 2}
    given = safeties(untested.with_found({"gear_rating": permissible}))
    assert given["S_lambda"].value == pytest.approx(2)


def test_gears_that_scuffed_fail_their_rating():
    """Errichello's: contact hotter than the mean scuffing temperature that he prints."""
    built, _ = rated(pyworm.load(CASES / "errichello_speed_increaser.toml"))
    teeth = built["gear teeth"]
    assert teeth.safeties[0].value == pytest.approx(0.945, abs=0.01)
    assert any(reason.startswith("S_B = 0.945") for reason in teeth.failed)


def test_simulated_safeties_have_both_bars_and_their_worst_place():
    case = gears(**TESTED)
    result = solved(case, 0.3, 0.6)
    first, last = result.solutions
    hotter = replace(
        last.figures,
        temperature_max_body_1=Estimate(420.0, grid=0.1, model=0.2, datum=OIL),
    )
    result = replace(result, solutions=(first, replace(last, figures=hotter)))
    built = safeties(case, result)
    scuffs = built["S_B_simulated"]
    assert scuffs.inputs["at"] == "phase 0.6"
    limit = scuffing_temperature_of_stage(12, case.drive.oil.viscosity.eta0, 0.8)
    assert scuffs.inputs["margin_K"] == pytest.approx(limit - 420.0)
    assert scuffs.value == pytest.approx((limit - OIL) / (420.0 - OIL))
    assert (scuffs.error, scuffs.model) == (0.1, 0.2) and scuffs.shown.endswith(
        "± 10 % ± 20 % (model)"
    )
    film = built["S_lambda_simulated"]
    assert film.value == pytest.approx(
        first.figures.film_min.value / 0.364e-6 / film.inputs["lambda_GFP"]
    )
    tables, _ = rated(case, result)
    flanks = tables["flanks"].summary()
    assert flanks["phase 0.6"]["S_B_simulated"] == pytest.approx(scuffs.value)
    assert flanks["phase 0.3"]["S_lambda_simulated"] == pytest.approx(film.value)
    assert flanks["phase 0.6"]["contact_temperature_simulated_C_error"] == pytest.approx(
        0.1 * (420.0 - OIL)
    )
    # Blok with the simulated friction: the closed form's flash in the ratio of both
    closed, blok = (
        flanks["phase 0.6"][key] for key in ("contact_temperature_C", "contact_temperature_blok_C")
    )
    friction = last.figures.friction_coefficient.value
    assert (blok - 60) / (closed - 60) == pytest.approx(friction / 0.05)


def test_a_verdict_that_turns_within_its_bars_says_so():
    case = gears(**TESTED)
    result = solved(case, 0.5)
    value = safeties(case, result)["S_lambda_simulated"].value
    near = gears(**TESTED, required_micropitting=value * (1 + 1e-6))
    built = safeties(near, result)["S_lambda_simulated"]
    assert built.verdict == "not sufficient" and built.open
    assert "turn within the uncertainty" in built.doubts[-1]
    far = safeties(gears(**TESTED, required_micropitting=value / 9), result)
    assert not far["S_lambda_simulated"].open


def test_rough_films_are_not_judged_by_limits_of_smooth_ones():
    """Asperities hold the flanks apart, so that lambda hardly falls however thin the oil."""
    case = gears(**TESTED)
    result = solved(case, 0.5)
    one = result.solutions[0]
    touching = replace(one.figures.film_min, value=0.2)
    rough = replace(one, figures=replace(one.figures, asperity_load_fraction=touching))
    result = replace(result, solutions=(rough,))
    built, _ = rated(case, result)
    by_name = {of.symbol: of for of in built["gear teeth"].safeties}
    assert by_name["S_lambda_simulated"].value is None
    assert "20% of the load" in by_name["S_lambda_simulated"].why
    assert by_name["S_lambda"].value is not None and by_name["S_B_simulated"].value is not None
    assert "S_lambda_simulated" not in built["flanks"].summary()["phase 0.5"]
    assert built["flanks"].summary()["phase 0.5"]["asperity_share"] == 0.2
    assert "wear_probability" not in built["gear teeth"].summary()["simulation"]


def test_contacts_without_heat_have_no_simulated_temperature():
    case = gears(**TESTED)
    cold = Result(case.name, case.resolved, (make_line_solution(phase=0.5),), None, {})
    built = safeties(case, cold)["S_B_simulated"]
    assert built.value is None and built.why == "heat was not simulated."


def test_worm_gears_are_compared_and_not_rated():
    """No limit of steel gears stands beside the temperatures and films of a bronze wheel."""
    case = pyworm.load(CASES / "zi_sharif_2001.toml")
    result = Result(case.name, case.resolved, (make_hot_worm(0.5),), make_mesh_cycle(), {})
    built, left = rated(case, result)
    assert {of.symbol for of in built["worm"].safeties} == {"S_W", "S_H", "S_delta", "S_F", "S_T"}
    flanks = built["flanks"]
    assert flanks.safeties == () and flanks.failed == ()
    assert any(
        "rate neither scuffing nor micropitting of worm gears" in word for word in flanks.words
    )
    values = flanks.summary()["phase 0.5"]
    hot = make_hot_worm(0.5).figures
    hottest = max(hot.temperature_max_body_1.value, hot.temperature_max_body_2.value)
    assert values["contact_temperature_simulated_C"] == pytest.approx(hottest - 273.15)
    assert np.isfinite(values["specific_film_simulated"])
    assert not any(key.startswith(("S_B", "S_lambda")) for key in values)
    assert any(sentence.startswith("Micropitting: ISO/TS 14521") for sentence in left)


def test_tests_of_an_oil_between_steel_gears_say_nothing_about_a_worm_gear():
    text = (CASES / "zi_sharif_2001.toml").read_text()
    tested = text.replace("[worm_rating]", "[worm_rating]\nscuffing_load_stage = 12")
    with pytest.raises(CaseError, match=r"worm_rating\.scuffing_load_stage: no such key"):
        case_of(tomllib.loads(tested), "tested", CASES)


def test_json_has_the_safeties(capsys):
    path = CASES / "spur_pair.toml"
    assert main(["rate", str(path), "--json"]) == 0
    built = json.loads(capsys.readouterr().out)["ratings"][0]["safeties"]
    assert built["S_B"]["verdict"] == "sufficient" and built["S_B"]["minimum"] == 2
    assert built["S_lambda"]["value"] == pytest.approx(3.0, abs=0.1)
    assert main(["rate", str(path)]) == 0
    assert "S_lambda, micropitting" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("keys", "sentence"),
    [
        ("scuffing_load_stage = 15", "scuffing_load_stage"),
        ("micropitting_load_stage = 4", "micropitting_load_stage"),
        ("micropitting_load_stage = 9\npermissible_specific_film = 0.2", "give either"),
    ],
)
def test_what_no_oil_was_tested_at_is_refused(keys, sentence, capsys, tmp_path):
    path = tmp_path / "spur.toml"
    path.write_text(f"{UNTESTED}[gear_rating]\n{keys}\n")
    assert main(["rate", str(path)]) == 2
    assert sentence in capsys.readouterr().err
