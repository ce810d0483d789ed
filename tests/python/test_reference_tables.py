"""Tables of reference pages have the values, names, units and keys of the program."""

import importlib
import pkgutil
import re
from collections.abc import Iterator

import pytest
from pydantic import BaseModel
from reference_tables import REFERENCE, TABLES, marked

import pyworm.case
from pyworm.io.units import Quantity

PAGE = REFERENCE / "symbols.md"
INPUT = re.compile(r"^\|(\$.+?\$) \|(.+?) \|(.+?) \|`([\w.*]+)` \|$", re.M)
"""Symbol, quantity, unit and key of an input."""


def _tables(base: type = BaseModel) -> Iterator[type[BaseModel]]:
    for below in base.__subclasses__():
        yield below
        yield from _tables(below)


@pytest.fixture(scope="module")
def units() -> dict[str, set[str]]:
    """Key of case files -> its SI units in all tables, "-" without one."""
    for module in pkgutil.walk_packages(pyworm.case.__path__, "pyworm.case."):
        importlib.import_module(module.name)
    found: dict[str, set[str]] = {}
    for model in _tables():
        if model.__module__.startswith("pyworm.case"):
            for name, field in model.model_fields.items():
                direct = {kind.unit for kind in field.metadata if isinstance(kind, Quantity)}
                nested = set(re.findall(r"unit='([^']+)'", str(field.annotation)))
                found.setdefault(name, set()).update(direct or nested or {"-"})
    return found


@pytest.mark.parametrize("page", TABLES)
def test_a_table_is_that_of_the_program(page):
    mark, table = TABLES[page]
    shown = marked(mark).search((REFERENCE / page).read_text())[0]
    assert shown == table(), "python tools/reference_tables.py rewrites it"


def test_inputs_have_keys_and_units_of_case_files(units):
    rows = INPUT.findall(PAGE.read_text().split("## Results")[0])
    assert len(rows) > 30
    for symbol, _, unit, key in rows:
        name = key.rpartition(".")[2]
        assert name in units, f"{symbol}: no case file has {key}"
        assert set(unit.split(", ")) <= units[name], f"{key} has {units[name]}"


def test_a_symbol_of_the_inputs_means_one_quantity():
    rows = INPUT.findall(PAGE.read_text().split("## Results")[0])
    symbols = [symbol for symbol, *_ in rows]
    assert len(symbols) == len(set(symbols))
