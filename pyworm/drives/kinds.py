"""Kinds of drives, those of other packages too, and the rule by which their modules are found."""

from importlib import import_module
from importlib.metadata import entry_points
from importlib.util import find_spec
from types import ModuleType
from typing import Literal

BUILT_IN = ("worm", "gear-pair", "roller-worm")
"""Kinds of drives of this package, as case files and results write them."""

PACKAGES = {
    entry.name: entry.value
    for entry in entry_points(group="pyworm.drives")
    if entry.name not in BUILT_IN
}
"""Kind of a drive outside -> the installed package with its modules `case`, `plots` and `console`."""

KINDS = (*BUILT_IN, *PACKAGES)
"""All kinds of drives."""

Role = Literal["case", "plots", "console"]

ROOMS: dict[Role, str] = {
    "case": "pyworm.case",
    "plots": "pyworm.plots.drives",
    "console": "pyworm.report.console.drives",
}
"""What a module does for a drive of this package -> where it is: tables of its case files, and, if it shows
more than its contacts, pictures of its mesh cycle, and their table."""


def name_of(kind: str) -> str:
    """Name of a kind of drive in this package, `_` for `-`: that of its folder and of its modules."""
    return kind.replace("-", "_")


def module_of(kind: str, role: Role) -> ModuleType | None:
    """Import what does something for a kind of drive; None where there is no such kind or module."""
    if kind not in KINDS:
        return None
    name = f"{PACKAGES[kind]}.{role}" if kind in PACKAGES else f"{ROOMS[role]}.{name_of(kind)}"
    return import_module(name) if find_spec(name) is not None else None
