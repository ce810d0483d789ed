"""From a case to its results: every scene planned before the first is solved."""

import platform
from collections.abc import Callable, Sequence
from dataclasses import asdict
from datetime import UTC, datetime
from typing import Any

import numpy as np

import pyworm
from pyworm.case import Case
from pyworm.case_error import CaseError
from pyworm.effects import Plan, plan
from pyworm.result import Result, mesh_cycle_dataset
from pyworm.scene import Scene
from pyworm.solve import solve

MESH_PHASES = 21
"""Phases at which the unloaded mesh cycle is followed for the result."""


def plan_case(
    case: Case, accuracy: float, effects: str, phases: Sequence[float] | None
) -> list[tuple[Scene, Plan]]:
    """Make the case's scenes and plan each; cheap, and the place where bad input is found.

    Parameters
    ----------
    case : Case
        The case.
    accuracy : float
        Relative error wanted [-].
    effects : str
        Name of the model.
    phases : sequence of float, optional
        Phases of the mesh cycle in place of the case's own.

    Raises
    ------
    CaseError
        No contact at a phase, or a model or an accuracy that there is none of.
    """
    scenes = list(case.scenes(phases))
    try:
        return [(scene, plan(scene, accuracy, effects)) for scene in scenes]
    except ValueError as error:
        raise CaseError(f"{case.name}: {error}") from error


def run(
    case: Case, work: Sequence[tuple[Scene, Plan]], progress: Callable[[str, float], None] | None
) -> Result:
    """Solve planned scenes.

    Parameters
    ----------
    case : Case
        The case.
    work : sequence of (Scene, Plan)
        What `plan_case` made of it.
    progress : callable, optional
        Told what is being done and which share of all is done, 0 to 1.
    """
    solutions = []
    for position, (scene, scene_plan) in enumerate(work):
        solutions.append(solve(scene, scene_plan, progress=_share(progress, position, len(work))))
    return Result(
        case_name=case.name,
        case=case.resolved,
        solutions=tuple(solutions),
        mesh_cycle=case.drive and mesh_cycle_dataset(case.drive.mesh_cycle(MESH_PHASES)),
        provenance=provenance(work),
    )


def provenance(work: Sequence[tuple[Scene, Plan]]) -> dict[str, Any]:
    """What made a result: versions, time, machine and plans; JSON-able."""
    return {
        "pyworm": pyworm.__version__,
        "python": platform.python_version(),
        "numpy": np.__version__,
        "machine": platform.machine(),
        "created": datetime.now(UTC).isoformat(timespec="seconds"),
        "plans": [asdict(scene_plan) for _, scene_plan in work],
    }


def _share(progress, position: int, count: int):
    """Progress of one of several solves as a share of all."""
    if progress is None:
        return None
    return lambda message, fraction: progress(message, (position + fraction) / count)
