"""Kinds of drives, and the rule by which their modules are found."""

from importlib import import_module
from importlib.util import find_spec
from types import ModuleType

KINDS = ("zi-worm", "gear-pair", "roller-worm")
"""Kinds of drives as case files write them.

By its kind, with `_` for `-`, a drive has its folder or file in `pyworm.drives`, its tables in `pyworm.case`,
and, if it shows more than its contacts, its pictures in `pyworm.plots.drives` and its table in
`pyworm.report.console.drives`.
"""


def module_of(kind: str, package: str) -> ModuleType | None:
    """Import the module of a package for a kind of drive; None where there is none."""
    name = f"{package}.{kind.replace('-', '_')}"
    return import_module(name) if kind in KINDS and find_spec(name) is not None else None
