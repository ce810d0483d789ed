"""How much of the tangent plane a scene needs: far enough out that the oil supply is not felt to end."""

from dataclasses import dataclass

import numpy as np

from pyworm.formulas.film import point_asymptotes
from pyworm.grid import Box
from pyworm.scales import Scales
from pyworm.scene import Scene

SAMPLES = 65
"""Points of the sampling grid along each direction."""

GROWTH = 1.4
"""How much a side moves out at a time."""

MOST_GROWTHS = 40
"""Moves after which a gap that has not risen never will."""

OUTFLOW_SHARE = 0.5
"""A side is an exit where at least this share of the entrainment leaves through it."""


@dataclass(frozen=True)
class Reach:
    """How high above the film the undeformed gap must have risen at a window's sides.

    Attributes
    ----------
    inlet : float
        In films, where oil comes in or passes by.
    exit : float
        In films, where it leaves.
    """

    inlet: float
    exit: float

    @classmethod
    def around(cls, inlet: float) -> "Reach":
        """Exit a fifth as far out, in gap, as the inlet.

        Far from a circular contact the pressure c(phi) / r^3 ends not abeam of it, as the exact solution
        without rupture does, but where c'' = 9 c + cos phi ends with c = c' = 0: 18 degrees behind.
        """
        return cls(inlet, inlet / 5)

    def doubled(self) -> "Reach":
        """Twice as high a gap: the next larger window, for its influence."""
        return Reach(2 * self.inlet, 2 * self.exit)


FAR = Reach.around(600.0)
"""The outermost window; pressure beyond it is that of a rigid film (`pyworm.far_field`)."""

NEAR_ELASTIC = 12.0
"""Reach of the window of the figures in the elastic limit [films]."""

NEAR_RIGID = 100.0
"""What a rigid film adds to that reach, for then pressure on the coarser grids around carries much load."""


def near_reach(size: Scales) -> Reach:
    """Reach of the window of the figures; pressure beyond it comes from coarser grids.

    The share of the load that a rigid film of the expected thickness would carry, which goes with its square
    root (Nijenbanning, Venner and Moes' rigid-isoviscous asymptote), leads from the one limit to the other.
    """
    groups = size.groups
    rigid = point_asymptotes(groups.moes_m, groups.moes_l, groups.ratio).rigid_isoviscous
    share_squared = min(1.0, rigid * groups.moes_film / size.film)
    return Reach.around(NEAR_ELASTIC + NEAR_RIGID * share_squared)


def window(scene: Scene, size: Scales, reach: Reach) -> Box:
    """Smallest rectangle around the contact on whose sides the gap is as high as `reach` asks.

    The gap counts from the surface that a dry contact would flatten to: Hertz's approach above the least
    gap around the contact point, where relieved tips leave some tens of micrometres. Where the teeth end the
    window ends one sample beyond them.
    """
    box = [
        -1.5 * size.hertz.semi_axis_x,
        1.5 * size.hertz.semi_axis_x,
        -1.5 * size.hertz.semi_axis_y,
        1.5 * size.hertz.semi_axis_y,
    ]
    gap, covered = _sampled(scene, box)
    least = gap[covered].min() if covered.any() else 0.0
    flat = least + size.hertz.approach
    for _ in range(MOST_GROWTHS):
        open_sides = [
            side
            for side, (low, exists) in enumerate(_sides(gap, covered))
            if exists.any()
            and low[exists].min() < flat + _height(scene, box, side, reach) * size.film
        ]
        if not open_sides:
            return tuple(box)
        for side in open_sides:
            box[side] *= GROWTH
        gap, covered = _sampled(scene, box)
    raise ValueError(
        f"{scene.name}: the gap does not rise above {reach.inlet:g} films within {abs(box[0]):.1g} m of the "
        "contact point; give it curvature, or ends, in every direction"
    )


def _sampled(scene: Scene, box) -> tuple[np.ndarray, np.ndarray]:
    """Gap and where both surfaces exist, on the sampling grid."""
    x, y = np.linspace(box[0], box[1], SAMPLES), np.linspace(box[2], box[3], SAMPLES)
    return scene.gap(*np.meshgrid(x, y, indexing="ij"))


def _sides(gap, covered):
    """Gap and existence along the west, east, south and north side."""
    return (
        (gap[0], covered[0]),
        (gap[-1], covered[-1]),
        (gap[:, 0], covered[:, 0]),
        (gap[:, -1], covered[:, -1]),
    )


def _height(scene: Scene, box, side: int, reach: Reach) -> float:
    """Films that the gap must have risen at a side, by whether it is an exit."""
    middle_x, middle_y = np.array(0.0), np.array(0.0)
    if side < 2:
        middle_x = np.array(box[side])
    else:
        middle_y = np.array(box[side])
    u, v = scene.entrainment(middle_x, middle_y)
    outward = (-u, u, -v, v)[side]
    return reach.exit if outward > OUTFLOW_SHARE * np.hypot(u, v) else reach.inlet
