"""From planned scenes to a result with its provenance."""

import platform
from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from datetime import UTC, datetime
from typing import Any

import numpy as np

import pyworm
from pyworm.case import Case
from pyworm.kernels import KernelError
from pyworm.planning import Plan
from pyworm.result import Result
from pyworm.scene import Scene
from pyworm.solver import solve


def run(
    case: Case, work: Sequence[tuple[Scene, Plan]], progress: Callable[[str, float], None] | None
) -> Result:
    """Solve planned scenes.

    Parameters
    ----------
    case : Case
        The case.
    work : sequence of (Scene, Plan)
        Scenes of this case and their plans.
    progress : callable, optional
        Told what is being done and which share of all is done, 0 to 1.

    Returns
    -------
    Result
        Scenes that the kernel gave up are missing and named, with the reason, under `failed` in its
        provenance.

    Raises
    ------
    KernelError
        If the kernel gave up every scene.
    """
    solutions, failed = [], {}
    for position, (scene, scene_plan) in enumerate(work):
        try:
            solution = solve(scene, scene_plan, progress=_share(progress, position, len(work)))
        except KernelError as error:
            failed[scene.name] = str(error)
            if len(failed) == len(work):
                raise
            continue
        if case.drive is not None:
            beside = case.drive.scene_data(scene)
            solution = replace(solution, fields=solution.fields.merge(beside))
        solutions.append(solution)
    cycle = None if case.drive is None else case.drive.cycle_data()
    return Result(
        case.name, case.resolved, tuple(solutions), cycle, provenance(work) | {"failed": failed}
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
