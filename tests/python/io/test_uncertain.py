"""Quantities with their uncertainty as texts."""

import math

import pytest

from pyworm.io.uncertain import Uncertain, parse_uncertain


@pytest.mark.parametrize(
    ("text", "value", "standard", "unit"),
    [
        ("0.4 um +- 0.1 um", 0.4, 0.1, "um"),
        ("0.4 um ± 100 nm", 0.4, 0.1, "um"),
        ("15 N +- 2 %", 15.0, 0.3, "N"),
        ("60 degC +- 2 K", 60.0, 2.0, "degC"),
        ("206 nm to 212 nm", 209.0, 3 / math.sqrt(3), "nm"),
        ("206 to 212 nm", 209.0, 3 / math.sqrt(3), "nm"),
        ("0.065 +- 0.003", 0.065, 0.003, ""),
        ("5 % +- 1 %", 5.0, 1.0, "%"),
        ("14 kN", 14.0, 0.0, "kN"),
        (0.489, 0.489, 0.0, ""),
    ],
)
def test_a_quantity_has_a_value_and_a_standard_uncertainty_in_its_unit(text, value, standard, unit):
    found = parse_uncertain(text)
    assert (found.value, found.standard) == pytest.approx((value, standard), rel=1e-14)
    assert found.unit == unit


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("60 degC +- 2 %", "a difference in K"),
        ("5 N +- 1 m", "unit of the same kind"),
        ("5 +- 1 N", "must be without unit, as its value is, or in %"),
        ("5 N +- -1 N", "zero or more"),
        ("212 nm to 206 nm", "from the smaller value to the larger one"),
        ("2 mm to 3 N", "unit of the same kind"),
        ("thick", "must be a quantity"),
        ("0,4 um", "must be a quantity"),
        (True, "must be a quantity with its uncertainty"),
        (math.inf, "must be finite"),
    ],
)
def test_what_is_no_such_quantity_is_refused_in_one_sentence(text, words):
    with pytest.raises(ValueError, match=words) as refused:
        parse_uncertain(text)
    assert "\n" not in str(refused.value)


def test_a_moved_quantity_is_written_as_a_case_file_has_it():
    assert parse_uncertain("15 N +- 2 %").moved(1) == "15.3 N"
    assert parse_uncertain("60 degC +- 2 K").moved(-1) == "58 degC"
    assert parse_uncertain("0.489 +- 0.01").moved(1) == 0.499


def test_in_another_unit_a_temperature_keeps_its_difference():
    assert parse_uncertain("60 degC +- 2 K").in_unit("K") == Uncertain(333.15, 2.0, "K")
    assert parse_uncertain("0.4 um +- 25 %").in_unit("m").standard == pytest.approx(1e-7)
    with pytest.raises(ValueError, match="unit of the same kind"):
        parse_uncertain("1 N").in_unit("m")
