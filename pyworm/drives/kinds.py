"""Kinds of drives, and the rule by which their modules are found."""

from importlib import import_module
from importlib.util import find_spec
from types import ModuleType

KINDS = ("worm", "gear-pair", "roller-worm")
"""Kinds of drives, as case files and results write them."""


def name_of(kind: str) -> str:
    """Name of a kind of drive in the package, `_` for `-`.

    By it a drive has its folder in `pyworm.drives` and, if it shows more than its contacts, its pictures in
    `pyworm.plots.drives` and its table in `pyworm.report.console.drives`. The tables of its case files are in
    `pyworm.case`.
    """
    return kind.replace("-", "_")


def module_of(kind: str, package: str) -> ModuleType | None:
    """Import the module of a package for a kind of drive; None where there is none."""
    name = f"{package}.{name_of(kind)}"
    return import_module(name) if kind in KINDS and find_spec(name) is not None else None
