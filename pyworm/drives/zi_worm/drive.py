"""The ZI worm drive: from the design table to tooth contacts and their scenes.

Lengths in m, angles in rad.  Of the redundant entries of a design table the geometry uses the lead and the
base radius; base lead angle and axial pitch must agree with them within a table's rounding.
"""

from dataclasses import dataclass, fields, replace
from functools import cached_property, lru_cache, partial
from math import atan2, degrees, floor, isfinite, pi

import numpy as np
import xarray as xr

from pyworm.drives.mesh_past import Passing
from pyworm.drives.zi_worm.dataset import loaded_cycle_data, mesh_cycle_data, tooth_data
from pyworm.drives.zi_worm.design import AS_DESIGNED, Assembly, Hob, Wheel, Worm
from pyworm.drives.zi_worm.gap import ToothGap, ToothMotion, surface_points
from pyworm.drives.zi_worm.helicoid import Array, Helicoid
from pyworm.drives.zi_worm.interference import deepest
from pyworm.drives.zi_worm.load_sharing import Arms, Shaft, SharedLoad, Transmission, share
from pyworm.drives.zi_worm.mesh_cycle import MeshCycle, ToothContact, find_mesh_cycle
from pyworm.drives.zi_worm.meshing import WheelFlank, turned
from pyworm.drives.zi_worm.sensitivity import sensitivity_data
from pyworm.drives.zi_worm.tooth import WheelTooth, WormTooth, wheel_radius
from pyworm.drives.zi_worm.tooth_compliance import BEYOND, ToothSprings, tooth_springs
from pyworm.drives.zi_worm.tooth_outline import ToothOutline, flank_outline
from pyworm.materials.body import Body, reduced_modulus
from pyworm.materials.oil import Oil
from pyworm.scene.point import Scene

TABLE_ROUNDING = 1e-3
"""Relative disagreement of redundant table entries (four digits each) taken as rounding."""

BASE_PITCH_MISMATCH = 0.01
"""Relative difference of normal base pitches above which worm and wheel cannot mesh in turn."""


OUTLINE_SIDE = 60
"""Points on each side of the wheel tooth's outline."""

PITCH_TOLD = 5e-6
"""Difference of normal base pitches [m] that is told: tables of four digits leave up to 3 um."""


@dataclass(frozen=True)
class ZiWormDrive:
    """A ZI worm drive at one operating point.

    Attributes
    ----------
    worm, wheel, hob : Worm, Wheel, Hob
        The design table.
    centre_distance : float
        Distance of worm and wheel axes [m].
    speed : float
        Speed of the worm [rad/s].
    load : float or Transmission
        Normal load on the tooth [N], or the torque that the teeth in mesh share.
    bodies : tuple of Body
        Worm and wheel.
    oil : Oil
        The oil.
    assembly : Assembly
        Errors of the assembly.
    driver : str
        "worm", or "wheel": the drive runs back under its load, on the same flanks.
    """

    worm: Worm
    wheel: Wheel
    hob: Hob
    centre_distance: float
    speed: float
    load: float | Transmission
    bodies: tuple[Body, Body]
    oil: Oil
    assembly: Assembly = AS_DESIGNED
    driver: Shaft = "worm"

    def __post_init__(self) -> None:
        _check_values(self)
        _check_table(self)
        _check_fit(self)
        self.cycle  # noqa: B018  a drive whose teeth do not touch is refused here

    @property
    def base_pitches(self) -> tuple[float, float]:
        """Normal base pitches of the worm and of the hob, which is the wheel's [m]."""
        screws = self.worm_flank, self.wheel_flank.hob
        worm, hob = (2 * pi * screw.base_travel / self.worm.threads for screw in screws)
        return worm, hob

    @property
    def warnings(self) -> tuple[str, ...]:
        """What is unusual in the drive, a sentence each: a hob of another base pitch than the worm's."""
        worm, hob = self.base_pitches
        apart = hob - worm
        if abs(apart) <= PITCH_TOLD:
            return ()
        return (
            f"hob.lead and hob.base_radius give a normal base pitch of {hob * 1e3:.4f} mm, "
            f"{abs(apart) * 1e6:.1f} um {'more' if apart > 0 else 'less'} than the worm's "
            f"{worm * 1e3:.4f} mm: each tooth pair meets that far off its neighbours and carries most of the "
            "load at one end of its mesh; equal base pitches, lead x cos(base_lead_angle), share it evenly",
        )

    @property
    def ratio(self) -> float:
        """Mean speed of the wheel by that of the worm, threads / teeth."""
        return self.worm.threads / self.wheel.teeth

    @property
    def rotation(self) -> float:
        """Speed of the worm [rad/s], positive from phase 0 to phase 1, negative the other way."""
        return self.speed if self.driver == "worm" else -self.speed

    @property
    def phases_per_second(self) -> float:
        """How fast the mesh cycle passes [1/s]."""
        return self.rotation / abs(self.cycle.worm_rotation)

    @property
    def pitch(self) -> float:
        """Phases between neighbouring tooth pairs; its inverse is the contact ratio."""
        return 2 * pi / self.worm.threads / abs(self.cycle.worm_rotation)

    @property
    def axes_distance(self) -> float:
        """Distance of worm and wheel axes as assembled [m]."""
        return self.centre_distance + self.assembly.centre_distance

    @cached_property
    def worm_flank(self) -> Helicoid:
        """The worm's helicoid in its running seat."""
        errors = self.assembly
        seat = self.axes_distance, errors.shaft_angle, errors.axial_shift
        return Helicoid(self.worm.base_radius, self.worm.lead, *seat)

    @cached_property
    def wheel_flank(self) -> WheelFlank:
        """The flank that the hob cuts."""
        hob = self.hob
        seat = hob.centre_distance, hob.swivel, hob.axial_shift
        return WheelFlank(Helicoid(hob.base_radius, hob.lead, *seat), self.ratio)

    @cached_property
    def worm_tooth(self) -> WormTooth:
        """Where the worm's thread ends."""
        worm = self.worm
        return WormTooth(self.worm_flank, worm.root_radius, worm.tip_radius, worm.tip_relief)

    @cached_property
    def wheel_tooth(self) -> WheelTooth:
        """Where the wheel's tooth ends."""
        wheel = self.wheel
        size = wheel.face_width, wheel.tip_radius, wheel.throat_radius
        return WheelTooth(self.wheel_flank.hob, *size, self.hob.tip_radius, wheel.tip_relief)

    @cached_property
    def cycle(self) -> MeshCycle:
        """The mesh cycle of one tooth pair."""
        return find_mesh_cycle(self.worm_flank, self.wheel_flank, self.worm_tooth, self.wheel_tooth)

    def contact(self, phase: float) -> ToothContact:
        """The unloaded tooth contact at a phase of the mesh cycle, 0 to 1."""
        if not 0 <= phase <= 1:
            raise ValueError(f"phase is {phase:.6g}; a tooth pair touches from phase 0 to phase 1")
        return self.cycle.contact(phase, self.rotation)

    @property
    def mean_teeth_in_contact(self) -> float:
        """Teeth in contact, on average: worm angle of a mesh cycle over that of a pitch [-]."""
        turned = self.contact(1.0).worm_angle - self.contact(0.0).worm_angle
        return turned * self.worm.threads / (2 * pi)

    @property
    def load_arm(self) -> float:
        """Torque on the wheel over the normal load of a tooth, without friction [m].

        The same at every phase: the line of action is the same line in space.
        """
        contact = self.contact(0.5)
        return float(abs(np.cross(contact.point, contact.normal)[1]))

    @property
    def wheel_torque(self) -> float:
        """Torque of the wheel [N m], of a tooth load the mean over the mesh cycle without friction."""
        if not isinstance(self.load, Transmission):
            return self.load * self.load_arm * self.mean_teeth_in_contact
        arms = self.arms(np.array([0.5]))
        own, wheel = (arms.of(shaft, self.friction)[0] for shaft in (self.load.shaft, "wheel"))
        return self.load.torque * float(wheel / own)

    def mesh_cycle(self, count: int = 21) -> tuple[ToothContact, ...]:
        """Contacts at equal steps of the worm's rotation from where the teeth meet to where they part."""
        return tuple(self.contact(float(phase)) for phase in np.linspace(0, 1, count))

    def gap(self, contact: ToothContact) -> ToothGap:
        """Undeformed gap over the contact's tangent plane."""
        return ToothGap(contact, self.worm_tooth, self.wheel_tooth)

    def motions(self, contact: ToothContact) -> tuple[ToothMotion, ToothMotion]:
        """Surface velocities of worm and wheel relative to the contact point."""
        worm_turn, wheel_turn = self._turns
        worm_axis, wheel_axis = self.worm_flank.axis_point, np.zeros(3)
        return (
            ToothMotion(contact, contact.worm_height, worm_axis, worm_turn),
            ToothMotion(contact, contact.wheel_height, wheel_axis, wheel_turn),
        )

    @property
    def _turns(self) -> tuple[Array, Array]:
        """Angular velocities of worm and wheel, each (3,) [rad/s]."""
        wheel = np.array([0.0, -self.cycle.speed_ratio, 0.0])
        return self.rotation * self.worm_flank.axes[:, 2], self.rotation * wheel

    def sliding(self, phases: Array) -> Array:
        """Velocity of the worm against the wheel at contact points [m/s], (3, phases)."""
        point = self.cycle.points(phases)
        worm_turn, wheel_turn = self._turns
        on_worm = np.cross(worm_turn, point - self.worm_flank.axis_point[:, None], axisb=0, axisc=0)
        return on_worm - np.cross(wheel_turn, point, axisb=0, axisc=0)

    def arms(self, phases: Array) -> Arms:
        """Moment arms of the forces between the teeth at some phases."""
        point = self.cycle.points(phases)
        normal = np.broadcast_to(-self.cycle.line.direction[:, None], point.shape)
        sliding = self.sliding(phases)
        sliding = sliding / np.linalg.norm(sliding, axis=0)
        on_worm = point - self.worm_flank.axis_point[:, None]

        def about(arm: Array, force: Array, axis: Array) -> Array:
            return axis @ np.cross(arm, force, axis=0)

        worm_axis, wheel_axis = self.worm_flank.axes[:, 2], np.array([0.0, -1.0, 0.0])
        return Arms(
            worm_normal=about(on_worm, normal, worm_axis),
            wheel_normal=about(point, normal, wheel_axis),
            worm_sliding=about(on_worm, sliding, worm_axis),
            wheel_sliding=about(point, sliding, wheel_axis),
        )

    def shared(self, phase: float) -> SharedLoad:
        """Normal loads of all tooth pairs while one of them is at a phase."""
        first = -floor((phase + BEYOND) / self.pitch)
        last = floor((1 + BEYOND - phase) / self.pitch)
        phases = phase + self.pitch * np.arange(first, last + 1)
        if not isinstance(self.load, Transmission):
            forces = np.where((phases >= 0) & (phases <= 1), self.load, 0.0)
            return SharedLoad(phases, forces, 0.0)
        ahead = self.cycle.transmission_error(phases)
        arms = self.arms(phases).of(self.load.shaft, self.load.friction)
        lever = self.wheel_flank.lever
        springs = None if self.load.sharing == "equal" else self.springs
        return share(self.load, phases, arms, lever, ahead, springs)

    @cached_property
    def unlifted(self) -> "ZiWormDrive | None":
        """The drive whose teeth share their load as without films; None where no lift of films is known."""
        if not isinstance(self.load, Transmission) or not self.load.lifts:
            return None
        return replace(self, load=replace(self.load, lifts=()))

    @cached_property
    def springs(self) -> ToothSprings:
        """Compliance of a tooth pair over its mesh cycle; only where a torque is shared."""
        whole = self.load.torque / float(self.arms(np.array([0.5])).of(self.load.shaft, 0.0)[0])
        teeth = self.wheel_flank, self.worm_tooth, self.wheel_tooth
        return _springs(*teeth, reduced_modulus(*self.bodies), whole, self.load.stiffness)

    def scene(self, phase: float) -> Scene:
        """The lubricated contact at a phase of the mesh cycle: body 1 is the worm, body 2 the wheel."""
        return Passing(self._scene, phase, self.phases_per_second, self._axes).scene()

    def _axes(self, phase: float) -> Array:
        return self.contact(phase).axes

    @cached_property
    def _interference(self) -> str | None:
        """How worm and wheel cut into each other, as a sentence; None where they do not."""
        found = deepest(
            lambda phase: self.gap(self.contact(phase)),
            lambda phase: self.tooth_outline(self.contact(phase)),
        )
        if found is None:
            return None
        face, radius = self.flank_place(self.contact(found.phase), found.x, found.y)
        return (
            f"hob.swivel of {degrees(self.hob.swivel):.4g} deg does not fit: the worm would cut "
            f"{found.depth * 1e6:.1f} um into the flank that the hob leaves, at phase {found.phase:g}, "
            f"{abs(face) * 1e3:.1f} mm from the middle of the face on a radius of {radius * 1e3:.1f} mm, and "
            "touch it there only; another swivel, a larger hob or a smaller wheel.face_width is "
            "needed"
        )

    def _scene(self, phase: float) -> Scene:
        if self._interference is not None:
            raise ValueError(self._interference)
        load = self.shared(phase).force(phase)
        if load == 0:
            raise ValueError("the tooth pair carries no load there, its neighbours carry all")
        return self.scene_under(load, phase)

    def scene_under(self, load: float, phase: float) -> Scene:
        """The contact at a phase under a normal load [N], as it stands."""
        contact = self.contact(phase)
        return Scene(
            name=f"phase {phase:.2f}",
            gap=self.gap(contact),
            radii=contact.radii,
            motions=self.motions(contact),
            load=load,
            bodies=self.bodies,
            oil=self.oil,
            phase=phase,
        )

    @property
    def friction(self) -> float:
        """Friction by which the forces are balanced [-]."""
        return self.load.friction if isinstance(self.load, Transmission) else 0.0

    def flank_place(self, contact: ToothContact, x: Array, y: Array) -> tuple[Array, Array]:
        """Place on the wheel's flank over points of a tangent plane, the same at all wheel angles.

        Returns
        -------
        tuple of ndarray
            Along the face from its middle, and distance from the wheel's axis [m].
        """
        point = surface_points(contact, x, y, contact.wheel_height.solve(x, y)[0])
        return point[1], wheel_radius(point)

    def cycle_data(self) -> xr.Dataset:
        """The mesh cycle for the result, without load and with it."""
        beyond = BEYOND if isinstance(self.load, Transmission) else 0.0
        parts = loaded_cycle_data(self, beyond), sensitivity_data(self)
        data = mesh_cycle_data(self.mesh_cycle())
        for part in parts:
            data = data.merge(part, combine_attrs="no_conflicts")
        return data

    def varied(self, name: str, change: float) -> "ZiWormDrive":
        """The drive with a difference in one entry of a table, "assembly.axial_shift" or "hob.swivel".

        Raises
        ------
        ValueError
            There is no such drive.
        """
        part, key = name.split(".")
        table = getattr(self, part)
        return replace(self, **{part: replace(table, **{key: getattr(table, key) + change})})

    def scene_data(self, scene: Scene) -> xr.Dataset:
        """The wheel tooth with its whole gap and its path of contact, for the scene's pictures."""
        contact = self.contact(scene.phase)
        place = partial(self.flank_place, contact)
        return tooth_data(self.tooth_outline(contact), scene.gap, place)

    @cached_property
    def rim(self) -> tuple[Array, Array]:
        """Generators and rolls of the wheel flank's outline [rad]: tip, face end, root, face end."""
        middle = self.contact(0.5)
        theta, lag = middle.wheel_height.start
        start = theta, lag + middle.wheel_angle
        return flank_outline(self.wheel_flank, self.wheel_tooth, start, OUTLINE_SIDE)

    def tooth_outline(self, contact: ToothContact) -> ToothOutline:
        """Outline of the wheel tooth and path of contact seen along a contact's normal."""
        angle = contact.wheel_angle
        rim = self.wheel_flank.point(*self.rim, angle)
        path = np.stack(
            [turned(c.point, c.wheel_angle - angle) for c in self.mesh_cycle()], axis=-1
        )

        def seen(points: Array, axis: Array) -> Array:
            return axis @ (points - contact.point[:, None])

        x, y = contact.x_axis, contact.y_axis
        return ToothOutline(seen(rim, x), seen(rim, y), seen(path, x), seen(path, y))


@lru_cache(maxsize=2)
def _springs(
    flank: WheelFlank,
    worm_tooth: WormTooth,
    wheel_tooth: WheelTooth,
    modulus: float,
    whole_load: float,
    stiffness: float,
) -> ToothSprings:
    """Compliance by all that decides it; kept, since drives differ in friction, lifts and oil alone."""
    cycle = find_mesh_cycle(worm_tooth.worm, flank, worm_tooth, wheel_tooth)
    return tooth_springs(
        gap_at=lambda phase: ToothGap(cycle.contact(phase), worm_tooth, wheel_tooth),
        radii_at=lambda phase: cycle.contact(phase).radii,
        reduced_modulus=modulus,
        whole_load=whole_load,
        stiffness=stiffness,
        longest=wheel_tooth.face_width,
    )


def _check_values(drive: ZiWormDrive) -> None:
    """Counts and sizes: finite, and positive where nothing else makes sense."""
    signed = {"hob.swivel", "hob.axial_shift"}
    signed |= {f"assembly.{f.name}" for f in fields(drive.assembly)}
    entries: dict[str, float] = {}
    for part in ("worm", "wheel", "hob", "assembly"):
        table = getattr(drive, part)
        entries.update(
            {
                f"{part}.{f.name}": getattr(table, f.name)
                for f in fields(table)
                if f.name != "tip_relief"
            }
        )
    entries.update({key: getattr(drive, key) for key in ("centre_distance", "speed")})
    if not isinstance(drive.load, Transmission):
        entries["load"] = drive.load
    for key, value in entries.items():
        if not isfinite(value):
            raise ValueError(f"{key} is {value}; a finite number is needed")
        if key not in signed and value <= 0:
            raise ValueError(f"{key} is {value:.6g}; it must be positive")
    for key in ("worm.threads", "wheel.teeth"):
        if entries[key] != int(entries[key]):
            raise ValueError(f"{key} is {entries[key]:.6g}; a whole number is needed")


def _check_table(drive: ZiWormDrive) -> None:
    """Redundant entries agree within the table's rounding."""
    for name, screw in (("worm", drive.worm), ("hob", drive.hob)):
        angle = atan2(screw.lead, 2 * pi * screw.base_radius)
        if abs(angle - screw.base_lead_angle) > TABLE_ROUNDING:
            raise ValueError(
                f"{name}.base_lead_angle is {degrees(screw.base_lead_angle):.2f} deg, but {name}.lead and "
                f"{name}.base_radius give {degrees(angle):.2f} deg (tan = lead / 2 pi base_radius)"
            )
        pitch = screw.lead / drive.worm.threads
        if abs(pitch - screw.axial_pitch) > TABLE_ROUNDING * pitch:
            raise ValueError(
                f"{name}.axial_pitch is {screw.axial_pitch * 1e3:.2f} mm, but {name}.lead over "
                f"worm.threads gives {pitch * 1e3:.2f} mm"
            )
        if screw.tip_radius <= screw.root_radius:
            raise ValueError(
                f"{name}.tip_radius is {screw.tip_radius * 1e3:.2f} mm; it must be above "
                f"{name}.root_radius, {screw.root_radius * 1e3:.2f} mm"
            )
    heights = {
        "worm": drive.worm.tip_radius - drive.worm.root_radius,
        "wheel": drive.hob.tip_radius - drive.hob.root_radius,
    }
    for name, height in heights.items():
        relief = getattr(drive, name).tip_relief
        if relief.amount > 0 and not 0 < relief.length < height:
            raise ValueError(
                f"{name}.tip_relief_length is {relief.length * 1e3:.4g} mm; it must lie between 0 and the "
                f"tooth's height, {height * 1e3:.4g} mm"
            )
    if drive.wheel.tip_radius < drive.wheel.throat_radius:
        raise ValueError(
            f"wheel.tip_radius is {drive.wheel.tip_radius * 1e3:.2f} mm; it must not be below "
            f"wheel.throat_radius, {drive.wheel.throat_radius * 1e3:.2f} mm"
        )
    pitch, cut = drive.base_pitches
    if abs(cut / pitch - 1) > BASE_PITCH_MISMATCH:
        raise ValueError(
            f"hob.lead and hob.base_radius give a normal base pitch of {cut * 1e3:.3f} mm, but the "
            f"worm has {pitch * 1e3:.3f} mm; they must be equal to mesh"
        )


def _check_fit(drive: ZiWormDrive) -> None:
    """Worm, wheel and hob reach into each other, and tips stay clear of roots."""
    worm, wheel, hob = drive.worm, drive.wheel, drive.hob
    floor = hob.centre_distance - hob.tip_radius
    lowest = max(worm.tip_radius + floor, worm.root_radius + wheel.throat_radius)
    highest = worm.tip_radius + wheel.throat_radius
    if not lowest <= drive.axes_distance < highest:
        with_error = " with assembly.centre_distance" if drive.assembly.centre_distance else ""
        raise ValueError(
            f"centre_distance{with_error} is {drive.axes_distance * 1e3:.2f} mm; it must lie from "
            f"{lowest * 1e3:.2f} mm, where a tip touches a root, to {highest * 1e3:.2f} mm, where the "
            "teeth no longer reach each other"
        )
    lowest = hob.root_radius + wheel.throat_radius
    if (
        not lowest - TABLE_ROUNDING * hob.root_radius
        <= hob.centre_distance
        < hob.tip_radius + wheel.throat_radius
    ):
        raise ValueError(
            f"hob.centre_distance is {hob.centre_distance * 1e3:.2f} mm; it must lie from "
            f"{lowest * 1e3:.2f} mm, where the hob's root touches the wheel's throat, to "
            f"{(hob.tip_radius + wheel.throat_radius) * 1e3:.2f} mm, where the hob cuts no tooth"
        )
