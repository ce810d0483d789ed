"""pyworm film: tables and JSON of films by the formula of the atlas."""

import json

import pytest
from folders import CASES

from pyworm.cli.main import main


def printed(capsys, *arguments):
    assert main(["film", *map(str, arguments)]) == 0
    return capsys.readouterr().out


def test_json_has_the_keys_of_run(capsys):
    (scene,) = json.loads(printed(capsys, CASES / "mourier_2006.toml", "--json"))["scenes"]
    assert scene["film_central_m"] == pytest.approx(209e-9, rel=0.1)
    assert scene["film_min_m"] < scene["film_central_m"]
    assert 0 < scene["film_central_error"] < 0.2
    assert scene["inside_atlas"] is True
    assert scene["kind"] == "point"


def test_a_worm_has_its_roughness_and_what_is_left_out(capsys):
    out = json.loads(printed(capsys, CASES / "zi_sharif_2001.toml", "--phase", 0.5, "--json"))
    (scene,) = out["scenes"]
    assert scene["phase"] == 0.5
    assert scene["lambda_central"] == scene["film_central_m"] / scene["composite_roughness_m"]
    assert {"film-heating", "roughness"} <= scene["left_out"].keys()


def test_a_line_contact_says_whose_formula_it_is(capsys):
    (scene,) = json.loads(printed(capsys, CASES / "line_m20_l10.toml", "--json"))["scenes"]
    assert scene["formula"] == "Moes (line)"
    assert scene["film_central_error"] is None
    assert "the formula of Moes" in printed(capsys, CASES / "line_m20_l10.toml")


def test_a_contact_of_options(capsys):
    out = printed(
        capsys, "--radii", "10 mm", "40 mm", "--load", "100 N", "--velocity", "1 m/s",
        "--oil", "PAO VG 220", "--temperature", "60 degC",
    )  # fmt: skip
    assert "contact" in out
    assert "±" in out


def test_what_is_missing_is_named(capsys):
    assert main(["film", "--load", "100 N"]) == 2
    assert "--radii, --velocity, --oil, --temperature" in capsys.readouterr().err


def test_a_wrong_unit_is_refused_by_its_option(capsys):
    options = ["--radii", "10 mm", "100 lbs", "--load", "300 N", "--velocity", "1 m/s"]
    assert main(["film", *options, "--oil", "PAO VG 220", "--temperature", "60 degC"]) != 0
    assert '--radii "100 lbs" must be a radius with its unit' in capsys.readouterr().err


def test_heat_is_held_where_the_contact_is_in_the_box_of_the_thermal_set(capsys):
    """The worm with its roughness left out and its film reduced: what is held is not left out."""
    out = json.loads(printed(capsys, CASES / "zi_sharif_2001.toml", "--phase", 0.5, "--json"))
    (scene,) = out["scenes"]
    assert set(scene["holds"]).isdisjoint(scene["left_out"])
    (cold,) = json.loads(printed(capsys, CASES / "mourier_2006.toml", "--json"))["scenes"]
    assert cold["holds"] == []
