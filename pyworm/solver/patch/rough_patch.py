"""Rough surfaces resolved node by node on their way through a point contact, with the oil's heat.

A bench for the averaged model of roughness: both give the mean film, the asperity load ratio, friction and
temperatures of the same surfaces.
"""

import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from math import hypot

import numpy as np

from pyworm.materials.topography import Topography
from pyworm.planning.grid import Grid
from pyworm.scene.point import Scene, require_point
from pyworm.solver.patch.heat import PatchHeat
from pyworm.solver.patch.moving_heights import (
    MIN_WAVE_NODES,
    MovingHeights,
    resampled,
    shortest_wave,
)
from pyworm.solver.patch.newton import MAX_RESIDUAL_RATIO
from pyworm.solver.patch.patch_record import TOUCHING, PatchReader, PatchRecord, RoughPatch
from pyworm.solver.patch.sheared_oil import ShearedOil
from pyworm.solver.patch.smooth_film import PatchFrame, SmoothFilm, smooth_film
from pyworm.solver.patch.stepping import PatchState, PatchStepping
from pyworm.solver.solution import Solution
from pyworm.solver.solve import solve

FRONT, RAMP = -1.3, 0.1
"""Place where the front of the roughness starts, and half its length, in half-lengths of the contact."""

PASSED = 1.0
"""Place that the front of the slower surface has passed when figures are first taken, in half-lengths."""

SLOW_PACE, GROWTH_PATH = 0.5, 1.0
"""Speed over the entrainment below which heights grow in place, and path of the oil meanwhile [half-lengths].

A front of such a surface would take long to pass, or never do.
"""

SMOOTH_ACCURACY = 0.03
"""Accuracy of the smooth film whose temperatures the patch takes."""

SLIDES_ACROSS = 0.02
"""Maximum sliding across the entrainment over the entrainment."""

MIN_NODES = 65
"""Minimum number of nodes along each side."""

Heights = tuple[MovingHeights | None, MovingHeights | None]
"""Moving heights of both surfaces; None of a smooth one."""


def rough_patch(
    scene: Scene,
    surfaces: Sequence[Topography | None],
    *,
    nodes: int = 513,
    stride: int | None = None,
    averaged: float = 1.0,
    tolerance: float = 1e-3,
    progress: Callable[[float], None] | None = None,
) -> RoughPatch:
    """Move rough surfaces through a point contact, resolved node by node.

    The film of smooth surfaces is solved first, with heat where the oil has it; from it the rough one departs
    as the surfaces enter; heights of a surface that is slow, still or moves against the entrainment grow in
    place. Means are taken while the oil moves on by `averaged` half-lengths of the contact after roughness
    has filled it and earlier oil has left. Both surfaces move as they do at the contact point.

    Args:
        scene: Contact; its own roughness does not count.
        surfaces: Heights of both bodies' surfaces, outwards; None of a smooth one. Angles of their x axes are
            from the surface's motion.
        nodes: Nodes along each side of the patch, one more than a multiple of a power of two.
        stride: Nodes that the oil moves on in a time step; by default so many that the roughness changes the
            gap by `STEP_CHANGE` of the film, and the shortest wave passes in `STEPS_A_WAVE` steps.
        averaged: Path over which means are taken, in half-lengths of the contact.
        tolerance: Residual and load error of a step.
        progress: Called with the fraction that is done.

    ValueError of a line contact, of one without entrainment or with sliding across it, and of waves that the
    nodes do not resolve; RuntimeError if a film does not converge.
    """
    require_point(scene)
    if nodes < MIN_NODES or nodes % 8 != 1:
        raise ValueError(
            f"nodes = {nodes}: must be one more than a multiple of 8, at least {MIN_NODES}"
        )
    frame = PatchFrame.of(scene)
    grid = frame.grid(nodes)
    heights = _heights(frame, grid, surfaces)
    shortest = _resolved_wave(heights, grid)
    solution, oil = _smooth_solution(scene, frame), ShearedOil(scene.oil, frame.sliding)
    smooth = smooth_film(frame, oil, solution, nodes)
    if stride is None:
        stride = _stride(heights, smooth, frame, grid, shortest)
    step = stride * grid.dx / frame.entrainment
    a, _ = frame.half_lengths
    taken_from = max(_filled(known, frame) for known in heights if known is not None)
    whole = taken_from + averaged * a / frame.entrainment
    heat = PatchHeat(frame, oil, smooth, grid, step, whole, solution is not None)
    read = PatchReader(frame, grid, smooth)
    first = read.smooth(heat)
    stepping = PatchStepping(frame, oil, smooth, grid, heights, heat, stride, tolerance, TOUCHING)
    begun = time.perf_counter(), time.process_time()
    records, state = _moved_through(stepping, read, int(np.ceil(whole / step)), progress)
    elapsed = time.perf_counter() - begun[0], time.process_time() - begun[1]
    fields = smooth.film.thickness(), smooth.film.pressure
    converged = all(known.residual <= MAX_RESIDUAL_RATIO * tolerance for known in records)
    times = taken_from, step, shortest
    return RoughPatch(grid, first, records, state, *fields, *times, converged, *elapsed)


def _moved_through(
    stepping: PatchStepping,
    read: PatchReader,
    count: int,
    progress: Callable[[float], None] | None,
) -> tuple[tuple[PatchRecord, ...], PatchState]:
    """Figures after each of a number of time steps, and the last state."""
    records = []
    for number in range(count):
        state = stepping.advance()
        records.append(read(state))
        if progress is not None:
            progress((number + 1) / count)
    return tuple(records), state


def _heights(frame: PatchFrame, grid: Grid, surfaces: Sequence[Topography | None]) -> Heights:
    """Heights of both surfaces that move along the entrainment; ValueError where they do not."""
    if len(surfaces) != 2 or all(surface is None for surface in surfaces):
        raise ValueError("surfaces: give two, at least one of them a Topography")
    if abs(frame.across) > SLIDES_ACROSS:
        raise ValueError("a resolved patch needs surfaces that slide along the entrainment alone")
    a, _ = frame.half_lengths
    found: list[MovingHeights | None] = []
    for surface, speed in zip(surfaces, frame.speeds, strict=True):
        known = None
        if surface is not None:
            slow = speed < SLOW_PACE * frame.entrainment
            growth = GROWTH_PATH * a / frame.entrainment if slow else 0.0
            known = MovingHeights(resampled(surface, grid), speed, FRONT * a, RAMP * a, growth)
        found.append(known)
    return found[0], found[1]


def _filled(known: MovingHeights, frame: PatchFrame) -> float:
    """Time when a surface's heights fill the contact and oil from before them has left it [s]."""
    slower = frame.entrainment if known.growth > 0 else min(known.speed, frame.entrainment)
    return known.growth + (PASSED - FRONT) * frame.half_lengths[0] / slower


def _resolved_wave(heights: Heights, grid: Grid) -> float:
    """Nodes in the shortest wave of the heights that counts; ValueError of one that is not resolved."""
    nodes, shortest = min(
        (wave / spacing, wave)
        for known in heights
        if known is not None
        for axis, spacing in enumerate(grid.spacing)
        for wave in [shortest_wave(known.height, spacing, axis)]
    )
    if nodes < MIN_WAVE_NODES:
        raise ValueError(
            f"waves of {shortest * 1e6:.3g} um and shorter hold 5 % of the variance of the heights, and have "
            f"{nodes:.1f} nodes of {MIN_WAVE_NODES:g}: give more nodes, or a shortest_wave"
        )
    return nodes


def _stride(
    heights: Heights, smooth: SmoothFilm, frame: PatchFrame, grid: Grid, shortest: float
) -> int:
    """Nodes that the oil moves on in a time step; `shortest` is the number in the shortest wave."""
    rough = [known for known in heights if known is not None]
    # past the contact point, and past the oil
    paces = [
        max(abs(known.speed), abs(known.speed - frame.entrainment)) / frame.entrainment
        for known in rough
    ]
    middle = tuple(int(np.argmin(np.abs(axis))) for axis in (grid.x, grid.y))
    film = float(smooth.film.thickness()[middle])
    change = hypot(
        *(
            float(np.diff(known.height, axis=0).std()) * pace
            for known, pace in zip(rough, paces, strict=True)
        )
    )
    wave = shortest / (STEPS_A_WAVE * max(1.0, *paces))
    changed = STEP_CHANGE * film / max(change, MIN_CHANGE * film)
    return int(np.clip(min(changed, wave), 1, MAX_STRIDE))


STEP_CHANGE = 0.15
"""Change of the gap by roughness in a time step over the film, root mean square."""

STEPS_A_WAVE = 10
"""Minimum number of time steps in which the shortest wave passes."""

MAX_STRIDE = 8
"""Maximum number of nodes of a time step."""

MIN_CHANGE = 1e-9
"""Change of the gap over the film that counts as none."""


def _smooth_solution(scene: Scene, frame: PatchFrame) -> Solution | None:
    """The film of smooth surfaces with heat; None where the oil has none, or surfaces do not slide."""
    if scene.oil.heat is None or scene.oil.flow is None or not frame.sliding > 0:
        return None
    first, second = (replace(body, roughness=None, topography=None) for body in scene.bodies)
    solution = solve(replace(scene, bodies=(first, second)), accuracy=SMOOTH_ACCURACY)
    return solution if "temperature_middle" in solution.fields else None
