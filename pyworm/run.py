"""From planned scenes to a result with its provenance."""

import platform
from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from datetime import UTC, datetime
from typing import Any

import numpy as np
import xarray as xr

import pyworm
from pyworm.case import Case
from pyworm.drives.zi_worm import ZiWormDrive
from pyworm.effects import Plan
from pyworm.kernels import KernelError
from pyworm.result import Result, mesh_cycle_dataset
from pyworm.scene import Scene
from pyworm.solution import Solution
from pyworm.solver import solve
from pyworm.variables import describe

TOOTH_SAMPLES = 129
"""Points along each direction at which the gap is sampled over the whole tooth, for its picture."""

MESH_PHASES = 21
"""Phases at which the unloaded mesh cycle is followed for the result."""


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
            solution = _with_tooth(solution, scene, case.drive)
        solutions.append(solution)
    cycle = None
    if case.drive is not None:
        cycle = mesh_cycle_dataset(case.drive.mesh_cycle(MESH_PHASES))
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


def _with_tooth(solution: Solution, scene: Scene, drive: ZiWormDrive) -> Solution:
    """Put the tooth, its whole gap and its path of contact among the fields; the solver knows of no teeth."""
    outline = drive.tooth_outline(drive.contact(solution.phase))
    x = np.linspace(outline.x.min(), outline.x.max(), TOOTH_SAMPLES)
    y = np.linspace(outline.y.min(), outline.y.max(), TOOTH_SAMPLES)
    gap, covered = scene.gap(*np.meshgrid(x, y))
    tooth = xr.Dataset(
        {
            "tooth_gap": (("tooth_y", "tooth_x"), np.where(covered, gap, np.nan)),
            "tooth_outline_x": ("outline", outline.x),
            "tooth_outline_y": ("outline", outline.y),
            "contact_path_x": ("path", outline.path_x),
            "contact_path_y": ("path", outline.path_y),
        },
        coords={"tooth_x": x, "tooth_y": y},
    )
    return replace(solution, fields=solution.fields.merge(describe(tooth)))


def _share(progress, position: int, count: int):
    """Progress of one of several solves as a share of all."""
    if progress is None:
        return None
    return lambda message, fraction: progress(message, (position + fraction) / count)
