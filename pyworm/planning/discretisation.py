"""Grids, tolerance and expected work of a solve, by kind of contact."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import sqrt
from typing import Any

from pyworm.planning import error_budget
from pyworm.planning.expected_work import (
    AUXILIARY_CHANGE,
    MAX_SPACING_FACTOR,
    Work,
    expected_work,
    first_change,
    first_refinement,
    sharpness,
    stiffness,
)
from pyworm.planning.grid import Grid, led_up_to, nest
from pyworm.planning.line_grid import LineGrid, first_grids
from pyworm.planning.model import Model
from pyworm.planning.window import (
    OUTERMOST_REACH,
    Reach,
    grown,
    near_reach,
    supplied_reach,
    windows,
)
from pyworm.scene.entrainment_continuation import with_auxiliary_entrainment
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.scene.scales import Scales, line_scales, scales

COARSE_CELLS = 16
"""Number of cells of the first grid of the figures over the contact's length in the shorter direction:
Hertz's semi-axis plus, where the film is thick, the distance over which the undeformed gap rises by a
film."""

LARGEST_SHARPNESS, FINEST_OF_STARVED = 1.0, 0.125
"""Largest sharpness (`expected_work.sharpness`) of the first grid of a starved film, whose meniscus is lost
on grids that do not resolve its inlet, and least factor of its spacing for that."""

LARGEST_STRETCH = 3.0
"""Largest ratio of the spacing along the long axis to that along the short one: side lobes and exit of a
slender contact scale with its short axis."""

LARGEST_GRID = 4_000_000
"""Nodes beyond which grids are not refined further."""

LARGEST_LINE = 33_000
"""Largest number of nodes of a line; a step costs some ms at 2000 and grows linearly."""

LINE_TOLERANCE = 1e-6
"""Residual allowed of an isothermal line film; Newton's last step falls far below it at no cost."""

COARSER_MENISCI = 2
"""Grids before the first grid of the figures on which the inlet meniscus of a starved film is sought: it
moves out by a node a step, and those of wide contacts stand far out."""

NEAR_MENISCUS = 0.7
"""Supply over the flooded film up to which the meniscus stands at the dry contact, where it is found at once.
Films so thin would be negative on coarser grids."""


@dataclass(frozen=True)
class _Numerics:
    """The part of a plan that depends on how a kind of contact is solved."""

    grids: tuple[Grid | LineGrid, ...]
    wider_grids: tuple[Grid | LineGrid, ...]
    largest_grid: int
    tolerance: float
    work: Work
    refusal: str | None


@dataclass(frozen=True)
class _Sized:
    """What the grids of a point contact are made of."""

    size: Scales
    near: Reach
    spacing: tuple[float, float]
    change: float
    auxiliary: bool


def _sized(
    scene: Scene, accuracy: float, model: Model, coarsest: float = MAX_SPACING_FACTOR
) -> _Sized:
    """Reach of the window and spacing of the first grid, at most `coarsest` times the usual one."""
    drawn = with_auxiliary_entrainment(scene) if model.heated else scene
    size = scales(drawn)
    near = near_reach(size)
    if scene.oil.supply is not None:
        near = supplied_reach(size, float(scene.oil.layer_at(0.0)))
    spacing = _first_spacing(scene, size)
    change = AUXILIARY_CHANGE
    if drawn is scene:
        change = _first_change(scene, size, spacing)
        factor = min(first_refinement(change, accuracy, model.heated, model.rough), coarsest)
        spacing = spacing[0] * factor, spacing[1] * factor
        change = _first_change(scene, size, spacing)
    return _Sized(size, near, spacing, change, drawn is not scene)


def _plan_point(scene: Scene, accuracy: float, model: Model) -> _Numerics:
    sized = _sized(scene, accuracy, model)
    near, starved = sized.near, scene.oil.supply is not None
    inner, outer, wider, far = windows(
        scene, sized.size, near, OUTERMOST_REACH, near.doubled(), OUTERMOST_REACH.doubled()
    )
    wider = grown(scene, inner, wider)
    # what heat alone carries ends with the heat: nothing lies beyond the window of the figures; nor has oil
    # pressure beyond the meniscus, so that one window holds it all
    nested = slice(-1, None) if sized.auxiliary or starved else slice(None)
    grids = nest(inner, outer, *sized.spacing)[nested]
    wider_grids = nest(wider, far, *sized.spacing)[nested]
    if starved and sized.size.supply_ratio > NEAR_MENISCUS:
        grids, wider_grids = (led_up_to(some[-1], COARSER_MENISCI) for some in (grids, wider_grids))
    work = expected_work(
        "point",
        _nodes(grids, wider_grids),
        sized.change,
        accuracy,
        LARGEST_GRID,
        full=model.levels > 0,
        stiffness=stiffness(model.heated, sized.size.groups.moes_l),
        auxiliary=sized.auxiliary,
    )
    return _Numerics(
        grids=grids,
        wider_grids=wider_grids,
        largest_grid=LARGEST_GRID,
        tolerance=error_budget.RESIDUAL * accuracy,
        work=work,
        refusal=_refusal(work, sized.size.open_film, LARGEST_GRID),
    )


def _plan_line(scene: LineScene, accuracy: float, model: Model) -> _Numerics:
    size = line_scales(scene)
    if model.heated and 0 in scene.velocities:
        at_rest = scene.velocities.index(0) + 1
        raise ValueError(
            f"{scene.name}: body {at_rest} is at rest (0 m/s), and a body at rest under a line contact "
            "warms without end; give it a velocity, or leave heat out (effects = isothermal)"
        )
    grid, wider = first_grids(scene, size, accuracy, model.heated)
    moes_l = float(size.groups.moes_l)
    change = first_change(
        grid.spacing, (size.hertz.half_width,), (scene.radius,), size.open_film, moes_l
    )
    work = expected_work(
        "line",
        _nodes((grid,), (wider,)),
        change,
        accuracy,
        LARGEST_LINE,
        full=model.levels > 0,
        stiffness=stiffness(model.heated, moes_l),
    )
    return _Numerics(
        grids=(grid,),
        wider_grids=(wider,),
        largest_grid=LARGEST_LINE,
        tolerance=error_budget.HEATED_LINE_RESIDUAL * accuracy if model.heated else LINE_TOLERANCE,
        work=work,
        refusal=_refusal(work, size.open_film, LARGEST_LINE),
    )


def _refusal(work: Work, film: float, largest: int) -> str | None:
    """Reason why a film [m] is not solved on finer grids; None if it is."""
    if not work.in_vain:
        return None
    return (
        f"the film of {film * 1e9:.2g} nm that is expected needs some {work.needed / 1e6:.3g} million nodes, "
        f"{largest / 1e6:.3g} million are the largest grid allowed"
    )


def _nodes(*nests: Sequence[Grid | LineGrid]) -> list[list[int]]:
    """Numbers of nodes of the grids of each window."""
    return [[grid.nodes for grid in nest] for nest in nests]


PLANS: dict[type, Callable[[Any, float, Model], _Numerics]] = {
    Scene: _plan_point,
    LineScene: _plan_line,
}
"""Planner of each kind of contact, by its scene."""


def moving_grid(scene: Scene | LineScene, accuracy: float, model: Model) -> Grid | LineGrid:
    """The first grid of the figures with cells of the usual size at most: a rate of change needs them."""
    if isinstance(scene, LineScene):
        return _plan_line(scene, accuracy, model).grids[-1]
    sized = _sized(scene, accuracy, model, 1.0)
    (inner,) = windows(scene, sized.size, sized.near)
    return nest(inner, inner, *sized.spacing)[-1]


def _first_change(scene: Scene, size: Scales, spacing: tuple[float, float]) -> float:
    """Expected relative change of the films from a grid of this spacing to the next."""
    return first_change(
        spacing,
        (size.hertz.semi_axis_x, size.hertz.semi_axis_y),
        scene.radii,
        size.open_film,
        size.groups.moes_l,
        size.slenderness,
    )


def _first_spacing(scene: Scene, size: Scales) -> tuple[float, float]:
    """Spacing of the first grid of the figures along each direction, unless accuracy asks for less [m]."""
    lengths = [
        sqrt(semi_axis**2 + 2 * radius * size.open_film)
        for semi_axis, radius in zip(
            (size.hertz.semi_axis_x, size.hertz.semi_axis_y), scene.radii, strict=True
        )
    ]
    short = min(lengths)
    dx, dy = (min(length, LARGEST_STRETCH * short) / COARSE_CELLS for length in lengths)
    if scene.oil.supply is None:
        return dx, dy
    half_widths = size.hertz.semi_axis_x, size.hertz.semi_axis_y
    blunt = LARGEST_SHARPNESS / sharpness((dx, dy), half_widths, scene.radii, size.open_film)
    finer = min(1.0, max(blunt, FINEST_OF_STARVED))
    return finer * dx, finer * dy
