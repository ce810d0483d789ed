"""Solid of a worm or of its hob: threads with flanks, fillets and lands between two end planes.

A flank's height over the axis is z = A(r) + p (polar - angle) with its axial profile A: at a height t the
section of a thread is the axial one with the polar angle (t - A(r)) / p, so that end planes cut no surface.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from math import cos, pi, sin, sqrt

import numpy as np

from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.flanks.surfaces import WormSurface
from pyworm.drives.worm.flanks.thread_section import axial_angle, form_radius
from pyworm.drives.worm.teeth.fillet_checks import hob_thickness
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.drives.worm.teeth.tooth_form import worm_thickness
from pyworm.io.solid import Solid

FLANK_STEPS = 12
"""Steps over the height of a smooth part of a flank in the coarsest net."""

FILLET_STEPS = 12
"""Steps around a fillet."""

LAND_STEPS = 6
"""Steps over the width of a tip or a root."""

STEPS_PER_TURN, MIN_STEPS = 30, 8
"""Steps along a thread in a turn, and all of them."""

MIN_LAND = 1e-3
"""Width of a tip or a root over the module below which a solid is refused."""

Removed = Callable[[Array, Array], Array]
"""What is taken off a flank [m] at places along the axis and radii [m]."""


@dataclass(frozen=True)
class ThreadSection:
    """Half of the axial section of a thread, of the flank that drives, at rotation angle zero."""

    flank: WormSurface
    """The flank."""
    root_radius: float
    """Radius of the root cylinder [m]."""
    tip_radius: float
    """Radius of the tip cylinder [m]."""
    root_fillet: float
    """Radius of the fillet at the root [m]."""
    tip_rounding: float
    """Radius of the rounded edge of the tip [m]."""
    smooth_until: float
    """Radius at which a relief begins [m]."""

    finer: int = 1
    """Steps for each one of the coarsest net."""

    def parts(self) -> list[Array]:
        """Smooth parts from the tip to the root, each radii and heights (2, points) [m]."""
        flank, top = self.flank, self.tip_radius
        form = form_radius(flank, self.root_radius, self.root_fillet, top)
        start = max(form, flank.start_radius)
        end = form_radius(flank, top, self.tip_rounding, self.root_radius)
        parts = []
        if end < top:
            parts.append(self._tip_arc(end))
        nodes = [end, *([self.smooth_until] if start < self.smooth_until < end else []), start]
        parts += [self._flank(*ends) for ends in pairwise(nodes)]
        height = flank.axial_profile(start)
        if form > self.root_radius and form > flank.start_radius:
            turn = pi / 2 - axial_angle(flank, form)
            return [*parts, self._root_arc(form, height, self.root_fillet, turn)]
        fillet = min(self.root_fillet, start - self.root_radius)
        foot = self.root_radius + fillet
        if foot < start:  # below the beginning of its flank a thread has radial walls
            wall = np.linspace(start, foot, self.finer * LAND_STEPS + 1)
            parts.append(np.array([wall, np.full(wall.shape, height)]))
        if fillet > 0:
            parts.append(self._root_arc(foot, height, fillet, pi / 2))
        return parts

    def _flank(self, outer: float, inner: float) -> Array:
        radius = np.linspace(outer, inner, self.finer * FLANK_STEPS + 1)
        return np.array([radius, [self.flank.axial_profile(float(r)) for r in radius]])

    def _root_arc(self, form: float, height: float, fillet: float, turn: float) -> Array:
        """The arc from the flank, whose axial pressure angle is pi / 2 - turn there, to the root."""
        angle = np.linspace(pi / 2 - turn, pi / 2, self.finer * FILLET_STEPS + 1)
        centre = form + fillet * cos(turn), height - fillet * sin(turn)
        return np.array([centre[0] - fillet * np.sin(angle), centre[1] + fillet * np.cos(angle)])

    def _tip_arc(self, form: float) -> Array:
        """The arc from the tip to the flank."""
        arc = tip_arc(self.flank, form, self.tip_rounding)
        angle = np.linspace(0.0, arc.first, self.finer * FILLET_STEPS + 1)
        out, up = arc.rounding * np.cos(angle), arc.rounding * np.sin(angle)
        return np.array([arc.radius + out, arc.height + up])


@dataclass(frozen=True)
class TipArc:
    """The arc that rounds the edge of a thread's tip in its axial section."""

    radius: float
    """Distance of its centre from the axis [m]."""
    height: float
    """Height of its centre [m]."""
    rounding: float
    """Its radius [m]."""
    first: float
    """Angle at which it begins on the flank [rad], negative; it ends on the tip cylinder at zero."""


def tip_arc(flank: WormSurface, form: float, rounding: float) -> TipArc:
    """The arc of a radius that begins on the flank at a form radius [m]."""
    angle = axial_angle(flank, form)
    height = flank.axial_profile(form) + rounding * cos(angle)
    return TipArc(form - rounding * sin(angle), height, rounding, angle - pi / 2)


def worm_solid(gears: WormGears, angle: float, finer: int = 1) -> Solid:
    """The worm at a rotation angle [rad]; ValueError without a tip or a root between its flanks.

    Its threads reach one module beyond where the wheel's outside cylinder cuts their tip cylinder.
    """
    worm, tooth, radius = gears.worm, gears.worm_tooth, gears.reference_radius
    half = _half_length(gears, gears.centre_distance, worm.tip_radius)
    relief = worm.tip_relief

    def relieved(along: Array, radius: Array) -> Array:
        return (
            relief(worm.tip_radius - radius) + 0 * along if relief.amount else 0 * (along + radius)
        )

    def deviating(along: Array, radius: Array) -> Array:
        taken = relieved(along, radius)
        if tooth.deviations is None:
            return taken
        along, radius = np.broadcast_arrays(along, np.maximum(radius, tooth.start_radius))
        return taken + tooth.deviations.removed(along, radius)

    section = ThreadSection(
        gears.worm_flank,
        worm.root_radius,
        worm.tip_radius,
        worm.fillet_radius,
        0.0,
        worm.tip_radius - relief.length if relief.amount else worm.tip_radius,
        finer,
    )
    thickness = worm_thickness(gears, radius)
    return _solid("worm", section, (radius, thickness), gears, (angle, half), (deviating, relieved))


def hob_solid(gears: WormGears, angle: float, finer: int = 1) -> Solid:
    """The hob's threads, without its gashes, at a rotation angle [rad]; ValueError as of `worm_solid`."""
    hob, radius = gears.hob, gears.reference_radii[1]
    flank = gears.wheel_flank.hob
    root = min(hob.root_radius, hob.centre_distance - gears.wheel.throat_radius)
    section = ThreadSection(
        flank, root, hob.tip_radius, 0.0, gears.wheel.fillet_radius, hob.tip_radius, finer
    )
    half = _half_length(gears, hob.centre_distance, hob.tip_radius)

    def nothing(along: Array, radius: Array) -> Array:
        return 0 * (along + radius)

    thickness = hob_thickness(gears, radius)
    return _solid("hob", section, (radius, thickness), gears, (angle, half), (nothing, nothing))


def _half_length(gears: WormGears, distance: float, tip_radius: float) -> float:
    """Half the length of threads of a tip radius at a distance from the wheel [m]."""
    reach = gears.wheel.tip_radius**2 - (distance - tip_radius) ** 2
    return sqrt(max(reach, 0.0)) + gears.module


def _solid(
    name: str,
    section: ThreadSection,
    thickness: tuple[float, float],
    gears: WormGears,
    place: tuple[float, float],
    removed: tuple[Removed, Removed],
) -> Solid:
    """A screw by its section, its axial thickness at a radius, its angle and half its length."""
    flank, threads = section.flank, gears.worm.threads
    angle, half = place
    pitch = 2 * pi * flank.screw / threads
    middle = flank.axial_profile(thickness[0]) + thickness[1] / 2
    turns = half / (pi * flank.screw)
    steps = section.finer * max(round(STEPS_PER_TURN * turns), MIN_STEPS)
    along = np.linspace(-half, half, steps + 1)

    def swept(part: Array, side: int) -> Array:
        """Radii and polar angles (2, points, along) of parts of the driving flank, 0, or the other, 1."""
        radius, height = (row[:, None] for row in part)
        sign = 1 - 2 * side
        taken = removed[side](along, radius)
        if taken.any():
            travel = np.array([flank.normal_travel(float(r)) for r in part[0]])[:, None]
            taken = taken / travel
        polar = angle + (along - middle - sign * (height - middle)) / flank.screw - sign * taken
        return np.stack([radius + 0 * along, polar])

    parts = section.parts()
    driving = [swept(part, 0) for part in parts]
    other = [swept(part, 1)[:, ::-1] for part in reversed(parts)]
    before = driving[-1][:, -1] - np.array([[0.0], [pitch / flank.screw]])
    land_steps = section.finer * LAND_STEPS
    root = between(before, other[0][:, 0], land_steps)
    tip = between(other[-1][:, -1], driving[0][:, 0], land_steps)
    for land, where in ((root, "root"), (tip, "tip")):
        if flank.screw * (land[1, -1] - land[1, 0]).min() < MIN_LAND * gears.module:
            raise ValueError(
                f"{name}: its flanks meet before its {where}, of which no solid is made"
            )
    nets = []
    for radius, polar in (root, *other, tip, *driving):
        local = np.stack([radius * np.cos(polar), radius * np.sin(polar), along + 0 * polar])
        nets.append(np.moveaxis(np.tensordot(flank.axes, local, 1), 0, -1) + flank.axis_point)
    return Solid(name, tuple(nets), (0, steps), threads, flank.axis_point, flank.axes[:, 2])


def between(first: Array, last: Array, steps: int) -> Array:
    """Even steps from one line to another of some coordinates, (coordinates, points, along)."""
    part = np.linspace(0.0, 1.0, steps + 1)[:, None]
    return np.asarray(first[:, None] + part * (last - first)[:, None])
