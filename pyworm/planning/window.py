"""Windows of a scene: rectangles of the tangent plane, large enough for a flooded inlet."""

from dataclasses import dataclass

import numpy as np

from pyworm.formulas.arrays import Array, Flags, Indices
from pyworm.formulas.film import point_asymptotes
from pyworm.planning.grid import Box
from pyworm.scene.point import Scene
from pyworm.scene.scales import Scales

SAMPLES = 65
"""Number of points along each side at which the gap is sampled."""

WINDOW_GROWTH = 1.4
"""Factor by which the distance of a side grows at a time."""

MOST_WIDER_STEPS = 2
"""Largest number of such growths from a window to the wider one for its window error, in which the gap at the
sides is twice as high: paraboloids need one, of a distance of 1.4."""

MOST_GROWTHS = 40
"""Number of growths after which the gap is taken never to rise."""

OUTFLOW_FRACTION = 0.5
"""A side is an exit where at least this fraction of the entrainment leaves through it."""


@dataclass(frozen=True)
class Reach:
    """Height of the undeformed gap at a window's sides, in film thicknesses."""

    inlet: float
    """Gap where oil enters or passes by [films]."""
    exit: float
    """Gap where oil leaves [films]; at most `inlet`."""

    @classmethod
    def around(cls, inlet: float) -> "Reach":
        """A reach whose exit is a fifth of the inlet's, in gap.

        Far from a circular contact the pressure c(phi) / r^3 ends not abeam of it, as the exact solution
        without rupture does, but where c'' = 9 c + cos phi ends with c = c' = 0: 18 degrees behind.
        """
        return cls(inlet, inlet / 5)

    def doubled(self) -> "Reach":
        """The reach to twice the gap, that of the wider window for the window error."""
        return Reach(2 * self.inlet, 2 * self.exit)


OUTERMOST_REACH = Reach.around(600.0)
"""The outermost window; pressure beyond it is that of a rigid film (`pyworm.solver.point.far_field`)."""

NEAR_ELASTIC = 12.0
"""Reach of the window of the figures in the elastic limit [films]."""

MENISCUS = 4.0
"""Gap at the sides of a window over the layer of oil that is supplied. The inlet meniscus stands where the
gap is up to three layers high, since pressure turns back oil, which leaves at the sides."""

WIDE_POWER = 2 / 3
"""Power of the contact's width over its length along the entrainment with which that height rises: oil in the
middle of a wide contact has far to go to its sides."""

NEAR_RIGID = 100.0
"""Addition to that reach in the rigid limit, where pressure outside the window carries much load [films]."""


def near_reach(size: Scales) -> Reach:
    """Reach of the window of the figures; pressure beyond it comes from coarser grids.

    Between the limits it follows the share of the load that a rigid film of the expected thickness would
    carry, which is proportional to its square root (Nijenbanning, Venner and Moes' rigid-isoviscous
    asymptote).
    """
    groups = size.groups
    limits = point_asymptotes(groups.moes_m, groups.moes_l, groups.ratio)
    rigid = float(limits.rigid_isoviscous)
    share_squared = min(1.0, rigid * groups.moes_film / size.film)
    return Reach.around(NEAR_ELASTIC + NEAR_RIGID * share_squared)


def supplied_reach(size: Scales, supply: float) -> Reach:
    """Reach of a window that holds the inlet meniscus of a layer of oil [m], beyond which is no pressure."""
    wide = max(1 / size.slenderness, 1.0) ** WIDE_POWER
    return Reach.around(max(NEAR_ELASTIC, MENISCUS * wide * supply / size.film))


def windows(scene: Scene, size: Scales, *reaches: Reach) -> tuple[Box, ...]:
    """Smallest rectangles around the contact on whose sides the gap has the height of each reach.

    The gap counts from the surface that a dry contact would flatten to: Hertz's approach above the least
    gap around the contact point, where relieved tips leave some tens of micrometres. Where the teeth end a
    window ends one sample beyond them.
    """
    half_x, half_y = 1.5 * size.hertz.semi_axis_x, 1.5 * size.hertz.semi_axis_y
    # the windows grow together: few large calls of the gap cost less than many small ones
    boxes = np.tile([-half_x, half_x, -half_y, half_y], (len(reaches), 1))
    inlet, exit_ = (
        np.array([[getattr(reach, side)] for reach in reaches]) for side in ("inlet", "exit")
    )
    flat = _least(scene, boxes[0]) + size.hertz.approach
    for _ in range(MOST_GROWTHS):
        rise = (_lowest(scene, boxes) - flat) / size.open_film
        open_ = rise < inlet
        enough = open_ & (rise >= exit_)  # if the side is an exit
        if enough.any():
            open_[enough] = ~_leaves(scene, np.nonzero(enough)[1], boxes[enough])
        if not open_.any():
            return tuple(tuple(box) for box in boxes.tolist())
        boxes = np.where(open_, WINDOW_GROWTH * boxes, boxes)
    last = int(open_.any(axis=1).argmax())
    raise ValueError(
        f"{scene.name}: the gap does not rise above {reaches[last].inlet:g} films within "
        f"{abs(boxes[last, 0]):.1g} m of the contact point; give it curvature, or ends, in every direction"
    )


def grown(scene: Scene, inner: Box, wider: Box) -> Box:
    """A window one or two steps larger than an inner one on all sides where the teeth continue.

    Beside a thin film the gap may rise beyond both reaches within one step, on one side or on all. Or the
    inner window ends just before a valley of the gap along the flank, which leads to the flank's end.
    """
    least, most = (
        np.abs(enlarged(scene, inner, WINDOW_GROWTH**steps)) for steps in (1, MOST_WIDER_STEPS)
    )
    distance = np.clip(np.abs(wider), least, most)
    west, east, south, north = np.copysign(distance, inner).tolist()
    return west, east, south, north


def enlarged(scene: Scene, window: Box, factor: float) -> Box:
    """A window some times as far from the contact point on all sides where the teeth continue."""
    here = np.array(window)
    ends = np.isinf(_lowest(scene, here[None])[0])
    west, east, south, north = np.where(ends, here, factor * here).tolist()
    return west, east, south, north


def _least(scene: Scene, box: Array) -> float:
    """Least gap in a rectangle [m]; 0 without surfaces."""
    x, y = np.linspace(box[0], box[1], SAMPLES), np.linspace(box[2], box[3], SAMPLES)
    gap, covered = scene.gap(*np.meshgrid(x, y, indexing="ij"))
    return float(gap[covered].min()) if covered.any() else 0.0


def _lowest(scene: Scene, boxes: Array) -> Array:
    """Least gap along the sides of rectangles, (boxes, sides) [m]; infinite without surfaces."""
    west, east, south, north = (np.tile(place, (SAMPLES, 1)) for place in boxes.T)
    x, y = np.linspace(west[0], east[0], SAMPLES), np.linspace(south[0], north[0], SAMPLES)
    gap, covered = scene.gap(np.array([west, east, x, x]).T, np.array([y, y, south, north]).T)
    lowest: Array = np.where(covered, gap, np.inf).min(axis=1)
    return lowest


def _leaves(scene: Scene, side: Indices, place: Array) -> Flags:
    """Whether sides are exits, by where they cross the axes [m], (sides,)."""
    on_x = side < 2
    u, v = scene.entrainment(np.where(on_x, place, 0.0), np.where(on_x, 0.0, place))
    outward = np.where(on_x, u, v) * np.where(side % 2, 1, -1)
    leaves: Flags = outward > OUTFLOW_FRACTION * np.hypot(u, v)
    return leaves
