"""Worm and wheel of a drive as cut and assembled: flanks, tooth boundaries, mesh cycle.

Lengths in m, angles in rad.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from math import degrees, pi
from typing import Any, Self

import numpy as np

from pyworm.drives.worm.drawing.design import AS_DESIGNED, Assembly, Hob, Wheel, Worm
from pyworm.drives.worm.drawing.designed_flanks import wheel_of, worm_of
from pyworm.drives.worm.drawing.deviations import FlankDeviations
from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.flanks.surfaces import WheelSurface, WormSurface, contact_paths
from pyworm.drives.worm.flanks.thread_section import form_radius
from pyworm.drives.worm.flanks.wheel_envelope import turned
from pyworm.drives.worm.teeth.edge_contact import EdgeContact
from pyworm.drives.worm.teeth.first_touch import FirstTouch, first_touch
from pyworm.drives.worm.teeth.flank_grid import FlankGrid, flank_grid
from pyworm.drives.worm.teeth.gap import ToothGap, surface_points
from pyworm.drives.worm.teeth.interference import PHASES, Interference, deepest
from pyworm.drives.worm.teeth.mesh_cycle import MeshCycle, ToothContact, find_mesh_cycle
from pyworm.drives.worm.teeth.seen_path import SeenPath
from pyworm.drives.worm.teeth.tooth import WheelTooth, WormTooth, wheel_radius
from pyworm.drives.worm.teeth.tooth_outline import RimmedFlank, ToothOutline, flank_outline

TURNS = 2
"""Corrections of the turn of a wheel by which misaligned flanks touch; each leaves its square."""

OUTLINE_SIDE = 60
"""Number of points on each side of the wheel tooth's outline."""

PATH = np.linspace(0.0, 1.0, 21)
"""Phases of the path of contact that is drawn."""


@dataclass(frozen=True, kw_only=True)
class WormGears:
    """A worm and its wheel."""

    worm: Worm
    """The design table of the worm."""
    wheel: Wheel
    """The design table of the wheel."""
    hob: Hob
    """The design table of the hob."""
    centre_distance: float
    """Distance of worm and wheel axes [m]."""
    assembly: Assembly = AS_DESIGNED
    """Errors of the assembly."""

    @property
    def base_pitches(self) -> tuple[float, float]:
        """Distance of neighbouring threads of worm and hob along the normal, on reference cylinders [m]."""
        worm, hob = (
            2 * pi * screw.normal_travel(radius) / self.worm.threads
            for screw, radius in zip(
                (self.worm_flank, self.wheel_flank.hob), self.reference_radii, strict=True
            )
        )
        return worm, hob

    @property
    def reference_radii(self) -> tuple[float, float]:
        """Radii of the reference cylinders of worm and hob, which has its oversize more [m]."""
        oversize = self.hob.centre_distance - self.centre_distance
        return self.reference_radius, self.reference_radius + oversize

    @property
    def profile_shift(self) -> float:
        """Profile shift of the wheel over the module [-]."""
        plain = self.reference_radius + self.wheel_reference_radius
        return (self.centre_distance - plain) / self.module

    @property
    def deviating(self) -> dict[str, FlankDeviations]:
        """Deviations of the flanks of worm and wheel, as far as they are known, by their names."""
        parts = {"worm": self.worm.deviations, "wheel": self.wheel.deviations}
        return {name: part for name, part in parts.items() if part is not None}

    @property
    def module(self) -> float:
        """Axial module [m]."""
        return self.worm.axial_pitch / pi

    @property
    def reference_radius(self) -> float:
        """Radius of the worm's reference cylinder [m]: as given, or one module below the tip as usual."""
        given = self.worm.reference_radius
        return self.worm.tip_radius - self.module if given is None else given

    @property
    def wheel_reference_radius(self) -> float:
        """Radius of the wheel's reference circle [m]."""
        return self.module * self.wheel.teeth / 2

    @property
    def ratio(self) -> float:
        """Mean speed of the wheel by that of the worm, threads / teeth."""
        return self.worm.threads / self.wheel.teeth

    @property
    def pitch(self) -> float:
        """Difference in phase of neighbouring tooth pairs; its inverse is the contact ratio."""
        return 2 * pi / self.worm.threads / abs(self.cycle.worm_rotation)

    @property
    def assembly_under_load(self) -> Assembly:
        """Where the worm runs: the errors of the assembly, of a drive with what its shaft bends."""
        return self.assembly

    @property
    def axes_distance(self) -> float:
        """Distance of worm and wheel axes as assembled [m]."""
        return self.centre_distance + self.assembly_under_load.centre_distance

    @cached_property
    def worm_flank(self) -> WormSurface:
        """The worm's helicoid as assembled."""
        return self._worm_with(self.assembly_under_load)

    def _worm_with(self, errors: Assembly) -> WormSurface:
        distance = self.centre_distance + errors.centre_distance
        seat = distance, errors.shaft_angle, errors.axial_shift
        return worm_of(self.worm, self.reference_radius, seat)

    @cached_property
    def wheel_flank(self) -> WheelSurface:
        """The flank that the hob cuts."""
        return wheel_of(self.hob, self.reference_radius, self.ratio)

    @cached_property
    def worm_tooth(self) -> WormTooth:
        """Boundaries of the worm's thread."""
        return self._thread_of(self.worm_flank)

    def _thread_of(self, flank: WormSurface) -> WormTooth:
        worm = self.worm
        form = form_radius(flank, worm.root_radius, worm.fillet_radius, worm.tip_radius)
        size = form, worm.tip_radius
        return WormTooth(flank, *size, worm.tip_relief, worm.deviations)

    @cached_property
    def wheel_tooth(self) -> WheelTooth:
        """Boundaries of the wheel's tooth."""
        wheel = self.wheel
        size = wheel.face_width, wheel.tip_radius, wheel.throat_radius
        hob, tip = self.wheel_flank.hob, self.hob.tip_radius
        reach = tip, form_radius(hob, tip, wheel.fillet_radius, self.hob.root_radius)
        return WheelTooth(
            hob, *size, *reach, wheel.tip_relief, wheel.groove_radius, wheel.deviations
        )

    @cached_property
    def cycle(self) -> MeshCycle:
        """The mesh cycle of one tooth pair."""
        try:
            return self._cycle_of(self.worm_flank, self.worm_tooth)
        except ValueError:
            if self.aligned:
                raise
        aligned = self.aligned_cycle  # refused by its own words
        path = SeenPath(aligned.path, self.worm_flank)
        for _ in range(TURNS):
            path = replace(path, ahead=path.ahead - self._apart(replace(aligned, path=path)))
        return replace(aligned, path=path)

    def _apart(self, cycle: MeshCycle) -> float:
        """Turn of the wheel by which the flanks of a mesh cycle come to touch at mid-mesh [rad]."""
        contact = cycle.contact(0.5)
        rimmed = RimmedFlank(self.wheel_flank, self.wheel_tooth, _within(cycle))
        rim = _rim_seen(contact, flank_outline(rimmed, OUTLINE_SIDE), self.wheel_flank)
        touch = first_touch(self.gap(contact), *rim)
        if touch is None:
            raise ValueError(
                f"assembly: with {self.errors_in_words} worm and wheel do not reach each other"
            )
        return touch.gap / abs(cycle.lever)

    @property
    def aligned(self) -> bool:
        """Whether the worm runs where it is designed to."""
        return self.assembly_under_load == AS_DESIGNED

    @cached_property
    def aligned_cycle(self) -> MeshCycle:
        """The mesh cycle of one tooth pair without errors of the assembly."""
        if self.aligned:
            return self.cycle
        designed = self._worm_with(AS_DESIGNED)
        return self._cycle_of(designed, self._thread_of(designed))

    def _cycle_of(self, worm: WormSurface, thread: WormTooth) -> MeshCycle:
        """The mesh cycle of one tooth pair with a thread of the worm, whose flank is given too."""
        paths = contact_paths(worm, self.wheel_flank, self.worm.threads, self.reference_radii)
        return find_mesh_cycle(paths, self.ratio, thread, self.wheel_tooth)

    @property
    def errors_in_words(self) -> str:
        """Where the worm runs, as differences from the design."""
        errors = self.assembly_under_load
        return (
            f"the worm {errors.centre_distance * 1e3:.4g} mm farther from the wheel, "
            f"{errors.axial_shift * 1e3:.4g} mm along the wheel's axis and "
            f"{degrees(errors.shaft_angle):.4g} deg tilted, what a bent shaft adds included,"
        )

    def gap(self, contact: ToothContact) -> ToothGap:
        """Undeformed gap over the contact's tangent plane."""
        return ToothGap(contact, self.worm_tooth, self.wheel_tooth)

    def flank_place(self, contact: ToothContact, x: Array, y: Array) -> tuple[Array, Array]:
        """Place on the wheel's flank over points of a tangent plane, the same at all wheel angles.

        Along the face from its middle, and distance from the wheel's axis [m].
        """
        point = surface_points(contact, x, y, contact.wheel_height.solve(x, y)[0])
        return point[1], wheel_radius(point)

    def thread_place(self, contact: ToothContact, x: Array, y: Array) -> tuple[Array, Array]:
        """Place on the worm's thread over points of a tangent plane, the same at all worm angles.

        Along the worm's axis from the line of centres, and distance from that axis [m].
        """
        point = surface_points(contact, x, y, contact.worm_height.solve(x, y)[0])
        return self.worm_flank.along_axis(point), self.worm_flank.radius(point)

    @cached_property
    def rim(self) -> Array:
        """Parameters of the wheel flank's outline: tip, face end, root, face end."""
        rimmed = RimmedFlank(self.wheel_flank, self.wheel_tooth, self.within)
        return flank_outline(rimmed, OUTLINE_SIDE)

    @property
    def within(self) -> tuple[float, ...]:
        """Parameters of a point of the wheel's flank within its outline."""
        return _within(self.cycle)

    def tooth_outline(self, contact: ToothContact) -> ToothOutline:
        """Outline of the wheel tooth and path of contact seen along a contact's normal."""
        angle = contact.wheel_angle
        path = np.stack(
            [turned(c.point, c.wheel_angle - angle) for c in map(self.cycle.contact, PATH)], axis=-1
        )
        x, y, _ = contact.axes @ (path - contact.point[:, None])
        return ToothOutline(*self._rim_seen(contact), x, y)

    def _rim_seen(self, contact: ToothContact) -> tuple[Array, Array]:
        """Outline of the wheel tooth over a contact's tangent plane [m]."""
        return _rim_seen(contact, self.rim, self.wheel_flank)

    @cached_property
    def interference(self) -> Interference | None:
        """The deepest interference of worm and wheel beside their contact point; None where there is none."""
        return deepest(lambda phase: self.first_touch(self.cycle.contact(phase)))

    @cached_property
    def play(self) -> float | None:
        """Play on the wheel's reference circle as assembled [m], negative of teeth that jam; None if unknown.

        The backlash as designed, less how far each flank turns the wheel ahead of where it is without errors
        of the assembly: by its contact point, and by how far it stands off that where the flanks touch at an
        edge.
        """
        backlash = self.wheel.backlash
        if backlash is None or (self.aligned and self.edge_contact is None):
            return backlash
        ahead = self._turned_ahead() + self.turned._turned_ahead()
        return backlash - self.wheel_reference_radius * ahead

    def _turned_ahead(self) -> float:
        """How far the driven flank turns the wheel ahead of where it is without errors of assembly [rad]."""
        ahead = self.cycle.absolute_error - self.aligned_cycle.absolute_error
        pitch = 2 * pi / self.wheel.teeth
        ahead -= pitch * round(ahead / pitch)  # another pair of teeth is as good
        lever = float(abs(self.cycle.lever))
        touches = (self.first_touch(self.cycle.contact(phase)) for phase in PHASES)
        least = min((touch.gap for touch in touches if touch is not None), default=0.0)
        return ahead - least / lever

    def first_touch(self, contact: ToothContact) -> FirstTouch | None:
        """Where worm and wheel without load touch first as a contact holds them."""
        return first_touch(self.gap(contact), *self._rim_seen(contact))

    @cached_property
    def flank_grid(self) -> FlankGrid:
        """Places of the wheel's flank at which patterns are found."""
        return flank_grid(self.wheel_tooth, self.wheel_flank, self.within)

    @cached_property
    def turned(self) -> Self:
        """The gears after half a turn about X, which drives their other flank and reverses shifts along Y."""
        changes = self._turned_parts()
        return replace(self, **changes) if changes else self

    def _turned_parts(self) -> dict[str, Any]:
        """What half a turn about X changes, by its names; deviations are those of the driven flank only."""
        parts = (("hob", self.hob), ("assembly", self.assembly))
        changes: dict[str, Any] = {
            name: replace(part, axial_shift=-part.axial_shift)
            for name, part in parts
            if part.axial_shift
        }
        for name in self.deviating:
            changes[name] = replace(getattr(self, name), deviations=None)
        return changes

    @cached_property
    def edge_contact(self) -> EdgeContact | None:
        """Where misaligned flanks without load touch, at an edge; None where at their contact point."""
        phase = None if self.interference is None else self.interference.phase
        if isinstance(self.cycle.path, SeenPath):
            phase = 0.5
        if phase is None:
            return None
        contact = self.cycle.contact(phase)
        touch = self.first_touch(contact)
        if touch is None:
            raise ValueError(
                f"assembly: with {self.errors_in_words} worm and wheel do not reach each other"
            )
        position = np.asarray(touch.x), np.asarray(touch.y)
        point = surface_points(contact, *position, contact.wheel_height.solve(*position)[0])
        margins = {**self.worm_tooth.margins(point), **self.wheel_tooth.margins(point)}
        return EdgeContact(
            phase=phase,
            face=float(point[1]),
            radius=float(wheel_radius(point)),
            boundary=min(margins, key=lambda name: float(margins[name])),
            depth=(
                0.0
                if isinstance(self.cycle.path, SeenPath) or self.interference is None
                else self.interference.depth
            ),
            assembly_under_load=self.assembly_under_load,
        )

    def touching_place(self, contact: ToothContact) -> tuple[float, float]:
        """Place of a contact's tangent plane about which the flanks touch without load [m]."""
        touch = None if self.edge_contact is None else self.first_touch(contact)
        return (0.0, 0.0) if touch is None else (touch.x, touch.y)


def _within(cycle: MeshCycle) -> tuple[float, ...]:
    """Parameters of a point of the wheel's flank within its outline."""
    middle = cycle.contact(0.5)
    *on_hob, lag = middle.wheel_height.start
    return *on_hob, lag + middle.wheel_angle


def _rim_seen(contact: ToothContact, rim: Array, flank: WheelSurface) -> tuple[Array, Array]:
    """Outline of the wheel tooth, by its parameters, over a contact's tangent plane [m]."""
    x, y, _ = contact.axes @ (
        flank.point(*rim, wheel_angle=contact.wheel_angle) - contact.point[:, None]
    )
    return x, y
