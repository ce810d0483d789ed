"""Shares of the asked accuracy: they leave room for the grid, and stand in one file."""

import re

import pytest
from folders import PACKAGE

from pyworm.planning import error_budget


def test_the_shares_leave_room_for_the_grid():
    """Of a steady film window, algebra and levels leave more than a third."""
    taken = error_budget.WINDOW + error_budget.ALGEBRA + error_budget.LEVELS
    assert taken < 0.65
    assert error_budget.PLANNED_LEVELS <= error_budget.LEVELS


@pytest.mark.parametrize("limit", [error_budget.TIME, error_budget.CONDUCTION])
def test_what_no_grid_mends_leaves_room_for_the_rest(limit):
    assert limit + error_budget.ALGEBRA + error_budget.PLANNED_LEVELS < 1


def test_no_share_of_the_accuracy_stands_elsewhere():
    """A constant, or a number, that multiplies the accuracy asked for is one of the error budget."""
    product = re.compile(r"([\w.]+) \* (?:\w+\.)*accuracy\b")
    shares = {
        (file.name, found)
        for room in ("planning", "solver")
        for file in sorted((PACKAGE / room).rglob("*.py"))
        for found in product.findall(file.read_text(encoding="utf-8"))
    }
    known = {name for name in vars(error_budget) if name.isupper()}
    used = {found.removeprefix("error_budget.") for _, found in shares if "error_budget." in found}
    assert not {share for share in shares if "error_budget." not in share[1]}
    assert known - {"WIDER_WINDOW_ALGEBRA", "LEVELS"} <= used <= known
