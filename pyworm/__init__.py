"""Elastohydrodynamic lubrication of worm gears.

import pyworm
case = pyworm.load("cases/zi_sharif_2001.toml")
scene = case.scene(phase=0.5)
plan = pyworm.plan(scene, accuracy=0.01)
solution = pyworm.solve(scene, plan)
"""

import os
from importlib import import_module
from typing import Any

# One thread a process unless asked otherwise, since batch work runs a process a core. This stands before
# NumPy and the kernel are loaded, which count their threads then.
os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

__all__ = ["Case", "CaseError", "LineScene", "Scene", "Solution", "load", "plan", "solve"]

_HOMES = {
    "Case": "pyworm.case.case",
    "CaseError": "pyworm.io.input_error",
    "LineScene": "pyworm.scene.line",
    "Scene": "pyworm.scene.point",
    "Solution": "pyworm.solver.solution",
    "load": "pyworm.case.case",
    "plan": "pyworm.planning.plan",
    "solve": "pyworm.solver.solve",
}


def __getattr__(name: str) -> Any:
    # Late, so that a look at the version or a check of a case does not wait for, or need, the kernel.
    if name == "__version__":
        from importlib.metadata import version

        return version("pyworm")
    if name not in _HOMES:
        raise AttributeError(f"module 'pyworm' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)
