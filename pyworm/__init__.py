"""Elastohydrodynamic lubrication of worm gears.

import pyworm
case = pyworm.load("cases/zi_sharif_2001.toml")
scene = case.scene(phase=0.5)
plan = pyworm.plan(scene, accuracy=0.01)
solution = pyworm.solve(scene, plan)
"""

from importlib import import_module
from typing import Any

__all__ = ["Case", "CaseError", "LineScene", "Scene", "Solution", "load", "plan", "solve"]

_HOMES = {
    "Case": "pyworm.case",
    "CaseError": "pyworm.case_error",
    "LineScene": "pyworm.line.scene",
    "Scene": "pyworm.scene",
    "Solution": "pyworm.solution",
    "load": "pyworm.case",
    "plan": "pyworm.planning",
    "solve": "pyworm.solver",
}


def __getattr__(name: str) -> Any:
    # Late, so that a look at the version or a check of a case does not wait for, or need, the kernel.
    if name == "__version__":
        from importlib.metadata import version

        return version("pyworm")
    if name not in _HOMES:
        raise AttributeError(f"module 'pyworm' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)
