"""Pictures: `solution.plot` has those of a solution, the functions here those of more than one."""

from importlib import import_module
from typing import Any

_HOMES = {
    "draw_regimes": "pyworm.plots.regimes",
    "draw_sweep": "pyworm.plots.sweep",
    "draw_traction": "pyworm.plots.traction",
    "draw_viscosity": "pyworm.plots.oil",
    "write": "pyworm.plots.layout",
}
"""Function -> its module."""

__all__ = list(_HOMES)


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted(_HOMES)
