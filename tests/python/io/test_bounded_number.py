"""Numbers of files are within the bounds of 64 bits, wherever they stand."""

import json
import tomllib
from fractions import Fraction

import pytest
from folders import CASES
from hypothesis import given
from hypothesis import strategies as st

from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT
from pyworm.io import units
from pyworm.io.bounded_number import LARGEST_INTEGER, read_json
from pyworm.io.given import kind_of, number
from pyworm.io.input_error import CaseError, toml
from pyworm.io.plain_values import MOST_COUNTED
from pyworm.io.toml import read_toml

DRIVES = ("zi_sharif_2001", "worm_drawing", "roller_ref", "spur_pair", "errichello_speed_increaser")


def places_of_integers(table, above=()):
    entries = table.items() if isinstance(table, dict) else enumerate(table)
    for key, value in entries:
        if isinstance(value, dict | list):
            yield from places_of_integers(value, (*above, key))
        elif isinstance(value, int) and not isinstance(value, bool):
            yield (*above, key)


def written(table, above=""):
    lines = [f"[{above}]"] if above else []
    lines += [
        f"{key} = {toml(value)}" for key, value in table.items() if not isinstance(value, dict)
    ]
    for key, value in table.items():
        if isinstance(value, dict):
            lines += written(value, f"{above}.{key}" if above else key)
    return lines


def changed(name, place, value):
    table = tomllib.loads((CASES / f"{name}.toml").read_text())
    inner = table
    for key in place[:-1]:
        inner = inner[key]
    inner[place[-1]] = value
    return "\n".join(written(table))


INTEGERS = [
    (name, place)
    for name in DRIVES
    for place in places_of_integers(tomllib.loads((CASES / f"{name}.toml").read_text()))
]


def test_the_cases_have_integers():
    assert {place[-1] for _, place in INTEGERS} >= {"threads", "teeth", "count"}


@pytest.mark.parametrize(("name", "place"), INTEGERS, ids=lambda of: str(of))
@pytest.mark.parametrize("command", ["check", "rate"])
def test_a_whole_number_of_400_digits_is_refused_by_its_key(tmp_path, capsys, command, name, place):
    path = tmp_path / "case.toml"
    path.write_text(changed(name, place, 10**400))
    assert main([command, str(path)]) == BAD_INPUT
    said = capsys.readouterr().err
    assert place[-1] in said and "whole numbers lie between" in said and said.count("\n") == 1


@pytest.mark.parametrize(
    ("name", "place"),
    [one for one in INTEGERS if one[1][-1] in ("threads", "teeth", "count")],
    ids=lambda of: str(of),
)
def test_counts_have_a_largest_possible_one(tmp_path, capsys, name, place):
    path = tmp_path / "case.toml"
    path.write_text(changed(name, place, LARGEST_INTEGER))
    assert main(["check", str(path)]) == BAD_INPUT
    said = capsys.readouterr().err
    assert f"{place[-1]} = {LARGEST_INTEGER}: must be at most {MOST_COUNTED}" in said


@pytest.mark.parametrize("text", ["inf", "-inf", "nan", "1e999"])
def test_a_number_without_a_size_is_refused_wherever_it_stands(tmp_path, text):
    path = tmp_path / "any.toml"
    path.write_text(f"[deep]\nlist = [1, [2, {text}]]\n")
    with pytest.raises(CaseError, match=r"deep.list\[1\]\[1\] = .*: must be finite"):
        read_toml(path)


@given(st.integers(-LARGEST_INTEGER, LARGEST_INTEGER))
def test_integers_of_64_bits_are_read_back_from_json(value):
    assert read_json(json.dumps({"a": [value, None]})) == {"a": [value, None]}


@pytest.mark.parametrize("text", ["9" * 20, "-" + "9" * 400, "9" * 5000, str(LARGEST_INTEGER + 1)])
def test_larger_ones_are_no_json_of_ours(text):
    with pytest.raises(ValueError, match="digits"):
        read_json(f'{{"a": [{text}]}}')


@pytest.mark.parametrize("value", [10**400, -(10**400), Fraction(10**400, 3)])
def test_numbers_given_in_python_have_a_float(value):
    with pytest.raises(ValueError, match=r"radius = .*must be a radius of a possible size"):
        number("radius", value, kind_of(units.Radius))
