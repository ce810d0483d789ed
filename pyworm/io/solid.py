"""Solids with a pattern about an axis, such as gears: nets of points of one pitch, and their triangles.

Between the points of a net its surface is the quintic spline through them, in meshes and in CAD files alike.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from math import pi

import numpy as np
import scipy

Array = np.ndarray

ACCURACY = 0.2e-6
"""Distance of splines through nets from the surface [m]."""

MAX_FINER = 8
"""Number of steps for each one of the coarsest net up to which that is sought."""

SPLINE_DEGREE = 5
"""Degree of splines through nets, less where a side has fewer points."""


@dataclass(frozen=True, eq=False)
class Solid:
    """A solid between two planes square to its axis, repeated about it.

    Nets of one pitch follow one another about the axis; the last line of each is the first one of the next.
    """

    name: str
    """What it is."""
    nets: tuple[Array, ...]
    """Points (around, along, 3) [m] of one pitch; around cross along points out of the solid."""
    breaks: tuple[int, ...]
    """Places along the axis, from first to last, between which surfaces are smooth."""
    copies: int
    """Number of pitches around the axis."""
    axis_point: Array
    """A point of the axis (3,) [m]."""
    axis: Array
    """Direction of the axis (3,)."""
    bore_radius: float = 0.0
    """Radius of its bore [m]; zero of a solid without one."""
    flank: tuple[int, ...] = ()
    """Indices of the nets of the flank on which results are shown."""

    def mirrored(self) -> "Solid":
        """The mirror image at z = 0."""
        image = np.array([1.0, 1.0, -1.0])
        nets = tuple((net * image)[::-1] for net in reversed(self.nets))
        return replace(
            self,
            nets=nets,
            axis_point=self.axis_point * image,
            axis=self.axis * image,
            flank=tuple(len(nets) - 1 - place for place in reversed(self.flank)),
        )

    def turns(self) -> Array:
        """Rotations (copies, 3, 3) that carry the first pitch to all of them."""
        x, y, z = self.axis
        cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        angle = (2 * pi * np.arange(self.copies) / self.copies)[:, None, None]
        turns = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * (cross @ cross)
        return np.asarray(turns)

    def end_middle(self, end: int) -> Array:
        """Point of the axis in the first (0) or the last (-1) end plane (3,) [m]."""
        along = (self.nets[0][0, end] - self.axis_point) @ self.axis
        return np.asarray(self.axis_point + along * self.axis)

    def bore_line(self) -> Array:
        """First and last point of the bore below the beginning of the pitch (2, 3) [m]."""
        lines = []
        for end in (0, -1):
            middle = self.end_middle(end)
            out = self.nets[0][0, end] - middle
            lines.append(middle + self.bore_radius * out / np.linalg.norm(out))
        return np.array(lines)

    def flank_points(self, finer: int) -> Array:
        """Points (around, along, 3) [m] of the flank farthest along -x, with so many steps for each one."""
        nets = []
        for place in self.flank:
            strips = [
                resampled(strip, *(finer * (count - 1) for count in strip.shape[:2]))
                for strip in self.smooth_nets[place]
            ]
            nets.append(
                np.concatenate([strip[:, :-1] for strip in strips] + [strips[-1][:, -1:]], axis=1)
            )
        points = np.concatenate([net[:-1] for net in nets] + [nets[-1][-1:]]) - self.axis_point
        copies = np.einsum("kij,abj->kabi", self.turns(), points) + self.axis_point
        return np.asarray(copies[np.argmin(copies[..., 0].mean(axis=(1, 2)))])

    @cached_property
    def smooth_nets(self) -> tuple[tuple[Array, ...], ...]:
        """Nets cut at the breaks: for each one, those along the axis."""
        return tuple(
            tuple(net[:, first : last + 1] for first, last in pairwise(self.breaks))
            for net in self.nets
        )


def spline_through(values: Array, axis: int = 0) -> "scipy.interpolate.BSpline":
    """Spline over 0 to 1 through values at evenly spaced places."""
    count = values.shape[axis]
    return scipy.interpolate.make_interp_spline(
        np.linspace(0.0, 1.0, count), values, k=min(SPLINE_DEGREE, count - 1), axis=axis
    )


def resampled(net: Array, around: int, along: int) -> Array:
    """A smooth net with other numbers of even steps around and along the axis."""
    for axis, steps in enumerate((around, along)):
        net = spline_through(net, axis)(np.linspace(0.0, 1.0, steps + 1))
    return net


def accurate(build: Callable[[int], Solid]) -> Solid:
    """The coarsest of solids with a number of steps for each one of the first whose splines are accurate.

    The one with twice the steps is taken for exact. ValueError if none is.
    """
    finer, solid = 1, build(1)
    while finer <= MAX_FINER:
        finer, coarse, solid = 2 * finer, solid, build(2 * finer)
        if _apart(coarse, solid) < ACCURACY:
            return coarse
    raise ValueError(f"{solid.name}: its flanks are too uneven for splines right to a micrometre")


def _apart(coarse: Solid, fine: Solid) -> float:
    """Largest distance of the splines of a solid from the points of one with twice the steps [m]."""
    distances = []
    for strips, exact_strips in zip(coarse.smooth_nets, fine.smooth_nets, strict=True):
        for strip, exact in zip(strips, exact_strips, strict=True):
            off = resampled(strip, exact.shape[0] - 1, exact.shape[1] - 1) - exact
            normal = np.cross(np.gradient(exact, axis=0), np.gradient(exact, axis=1))
            size = np.linalg.norm(normal, axis=-1, keepdims=True)
            distances.append(np.abs(np.sum(off * normal / size, axis=-1)).max())
    return float(max(distances))
