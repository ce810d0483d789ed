"""The mesh of a pair of involute gears: tooth contacts at a speed and a power, and their scenes.

Lengths in m, angles in rad. The pinion is body 1, the gear body 2, whichever drives. The mesh cycle is that
of one pair of teeth in the middle of the face, counted along the pinion's tooth as its roll angle is: phase 0
at the start of its active profile (SAP), low on the tooth, 1 at the end (EAP), its tip. Where the pinion
drives, contact runs that way; where the gear drives (a speed increaser), it runs from 1 to 0.
"""

from dataclasses import dataclass
from functools import cached_property
from math import cos, pi, sin, tan

import numpy as np

from pyworm.drives.duty import LineOfAction
from pyworm.drives.forces import MeshForces, ShaftAxes, Supports
from pyworm.drives.gear_pair.design import ContactKind, Driver, LinearRelief
from pyworm.drives.gear_pair.film_formulas import Surfaces, rate
from pyworm.drives.gear_pair.gap import Flank, GearGap, GearSection
from pyworm.drives.gear_pair.gears import InvolutePair
from pyworm.drives.gear_pair.load_sharing import LoadSharing, SharingRule
from pyworm.drives.oil_supply import Bath, Jets, Lubricated, LubricatedBody, LubricatedTeeth
from pyworm.materials.body import Body, reduced_modulus
from pyworm.materials.oil import Oil
from pyworm.scene.line import LineScene
from pyworm.scene.point import RigidMotion, Scene

Array = np.ndarray


@dataclass(frozen=True)
class ToothContacts:
    """Contacts along the line of action; numbers or arrays of one shape."""

    phase: Array
    """Place on the path of contact, 0 at the SAP of the pinion, 1 at its EAP."""
    pinion_length: Array
    """Radius of curvature of the pinion in the transverse section [m]."""
    gear_length: Array
    """Radius of curvature of the gear in the transverse section [m]."""
    roll_angle: Array
    """Roll angle of the pinion, radius of curvature over base radius [rad]."""
    pinion_radius: Array
    """Radius of curvature of the pinion across the contact line [m]."""
    gear_radius: Array
    """Radius of curvature of the gear across the contact line [m]."""
    radius: Array
    """Relative radius of curvature across the contact line [m]."""
    pinion_velocity: Array
    """Velocity of the pinion's surface across the contact line, relative to it [m/s]."""
    gear_velocity: Array
    """Velocity of the gear's surface across the contact line, relative to it [m/s]."""
    unit_load: Array
    """Normal load for each length of the contact line [N/m]."""
    load_share: Array
    """Share of the normal force that the contact line carries [-]."""
    line_length: Array
    """Length of the contact line [m]."""
    approach: Array
    """Whether contact is before the pitch point, where friction changes direction."""

    @property
    def entrainment(self) -> Array:
        """Mean surface velocity [m/s]."""
        return (self.pinion_velocity + self.gear_velocity) / 2

    @property
    def sliding(self) -> Array:
        """Velocity of the pinion's surface relative to the gear's [m/s]."""
        return self.pinion_velocity - self.gear_velocity

    @property
    def slide_roll_ratio(self) -> Array:
        """Sliding over entrainment [-]."""
        return self.sliding / self.entrainment

    @property
    def pinion_specific_sliding(self) -> Array:
        """Sliding over the velocity of the pinion's surface [-]."""
        return self.sliding / self.pinion_velocity

    @property
    def gear_specific_sliding(self) -> Array:
        """Sliding of the gear's surface over its velocity [-]."""
        return -self.sliding / self.gear_velocity


CYCLE_POINTS = 401
"""Number of phases of the closed forms; the ends of single contact are added, twice."""


@dataclass(frozen=True)
class GearPairMesh(Lubricated):
    """The teeth of a pair of gears at a speed and a power."""

    teeth: InvolutePair
    """The gears."""
    driver: Driver
    """Driving gear: "pinion" (a speed reducer) or "gear" (a speed increaser)."""
    pinion_speed: float
    """Speed of the pinion [rad/s]."""
    power: float
    """Power through the mesh [W]."""
    bodies: tuple[Body, Body]
    """Pinion and gear."""
    oil: Oil
    """The oil."""
    load_factor: float = 1.0
    """Load over that of the power, by shocks, dynamics and uneven distribution over the face: the product of
    the K factors of ISO 6336 or AGMA 2101 [-]."""
    load_sharing: SharingRule = "ramp"
    """How contact lines share the load (`LoadSharing`)."""
    contact: ContactKind = "line"
    """Kind of the scenes: "line", or "point" of the whole crowned face."""
    tip_relief: tuple[LinearRelief, LinearRelief] = (LinearRelief(), LinearRelief())
    """Tip relief of pinion and gear in the gaps of scenes; load sharing ignores it."""
    lead_crowning: float = 0.0
    """Lead crowning: height removed from both flanks together at the ends of the face [m]."""
    surfaces: Surfaces | None = None
    """Further input of the closed forms of friction and scuffing; None if not known."""
    lubrication: Bath | Jets | None = None
    """How oil comes to their teeth; None where there is assumed to be enough."""
    pinion_shaft: Supports | None = None
    """Bearings of the pinion's shaft; None where they are not given."""
    gear_shaft: Supports | None = None
    """Bearings of the gear's shaft, likewise."""

    @cached_property
    def sharing(self) -> LoadSharing:
        """Sharing of the normal force among contact lines."""
        return LoadSharing(self.teeth, self.load_sharing)

    @property
    def gear_speed(self) -> float:
        """Speed of the gear [rad/s]."""
        return self.pinion_speed / self.teeth.ratio

    @property
    def _pinion_torque(self) -> float:
        """Torque on the pinion [N m]."""
        return self.power / self.pinion_speed

    def shaft_forces(self, driver: Driver) -> MeshForces:
        """Forces on both shafts without the load factor, at the pitch point, where friction changes sign.

        F_t = T_1/r_w1, F_r = F_t tan alpha_wt, F_a = F_t tan beta_w; where the other gear than its own
        drives, flanks and axial forces are the opposite ones.
        """
        teeth, pitch = self.teeth, self.teeth.cylinders[0].pitch
        sense = 1.0 if driver == self.driver else -1.0
        tangential = self._pinion_torque / pitch
        tilt = tan(teeth.system.helix_angle) * pitch / teeth.cylinders[0].reference
        radial, axial = tangential * tan(teeth.pressure_angle), tangential * tilt
        force = np.array([[-radial], [-sense * tangential], [sense * axial]])
        point, along = np.array([[pitch], [0.0], [0.0]]), np.array([0.0, 0.0, 1.0])
        across = np.array([1.0, 0.0, 0.0])
        pinion = ShaftAxes("pinion", np.zeros(3), across, along)
        gear = ShaftAxes("gear", teeth.centre_distance * across, -across, -along)
        return MeshForces(driver, 0.0, (pinion.force(point, force), gear.force(point, -force)))

    @property
    def normal_force(self) -> float:
        """Force along the normal of the flanks [N], without friction, times the load factor."""
        arm = self.teeth.cylinders[0].base * cos(self.teeth.system.base_helix_angle)
        return self.load_factor * self._pinion_torque / arm

    @property
    def pitch_line_velocity(self) -> float:
        """Velocity of the pitch circles [m/s]."""
        return self.pinion_speed * self.teeth.cylinders[0].pitch

    @property
    def reduced_modulus(self) -> float:
        """Reduced modulus E' of the two gears [Pa]."""
        return reduced_modulus(*self.bodies)

    def phase_of(self, pinion_length: float) -> float:
        """Phase at which the pinion has this radius of curvature [m], such as that of `teeth.pitch_point`."""
        return (pinion_length - self.teeth.start) / self.teeth.path_length

    def contacts(self, phase: float | Array) -> ToothContacts:
        """The tooth contacts at phases of the mesh cycle, 0 to 1; ValueError if a phase is out of contact."""
        phase = np.asarray(phase, float)
        if not np.all((phase >= 0) & (phase <= 1)):
            worst = float(phase.flat[np.argmax(np.abs(phase - 0.5))])
            raise ValueError(f"phase is {worst:.6g}; a tooth pair touches from phase 0 to phase 1")
        teeth = self.teeth
        tilt = cos(teeth.system.base_helix_angle)
        pinion = teeth.start + phase * teeth.path_length
        # At the very ends the sum may round to beyond them, where nothing is in contact.
        pinion = np.clip(pinion, teeth.start, teeth.end)
        gear = teeth.base_tangent - pinion
        before = pinion < teeth.pitch_point
        return ToothContacts(
            phase=phase,
            pinion_length=pinion,
            gear_length=gear,
            roll_angle=pinion / teeth.cylinders[0].base,
            pinion_radius=pinion / tilt,
            gear_radius=gear / tilt,
            radius=pinion * gear / (teeth.base_tangent * tilt),
            pinion_velocity=self.pinion_speed * pinion,
            gear_velocity=self.gear_speed * gear,
            unit_load=self.normal_force * self.sharing.per_length(pinion),
            load_share=self.sharing.of_line(pinion),
            line_length=self.sharing.line_length(pinion),
            approach=before if self.driver == "pinion" else ~before,
        )

    def gap(self, phase: float) -> GearGap:
        """Undeformed gap of the pair of teeth over the tangent plane."""
        teeth = self.teeth
        contact = self.contacts(phase)
        pinion, gear = (
            Flank(
                base=size.base,
                length=float(length),
                helix=teeth.system.base_helix_angle,
                form_length=size.form_length,
                tip_length=size.tip_length,
                relief=relief.amount,
                relief_length=relief.length,
            )
            for size, length, relief in zip(
                teeth.cylinders,
                (contact.pinion_length, contact.gear_length),
                self.tip_relief,
                strict=True,
            )
        )
        return GearGap(pinion, gear, teeth.face_width, self.lead_crowning)

    def scene_at(self, phase: float) -> LineScene | Scene:
        """The lubricated contact at a phase as it is then, without its past."""
        return self._line(phase) if self.contact == "line" else self._point(phase)

    @property
    def _direction(self) -> float:
        """Sign along x, which runs to the pinion's tip, of the surfaces' velocities at the contact line."""
        return -1.0 if self.driver == "pinion" else 1.0

    def _line(self, phase: float) -> LineScene:
        contact, direction = self.contacts(phase), self._direction
        return LineScene(
            name=_name(phase),
            gap=GearSection(self.gap(phase)),
            radius=float(contact.radius),
            velocities=(
                direction * float(contact.pinion_velocity),
                direction * float(contact.gear_velocity),
            ),
            load=float(contact.unit_load),
            bodies=self.bodies,
            oil=self.oil_supplied,
            phase=phase,
        )

    def _point(self, phase: float) -> Scene:
        """The scene of the whole face; surfaces spin by their rotation's component along the normal.

        What the height of the flank over the plane adds to their velocities is neglected: relative to
        them it is that height over the radius of curvature.
        """
        contact, direction = self.contacts(phase), self._direction
        helix = self.teeth.system.base_helix_angle
        along = self.teeth.face_width**2 / (8 * self.lead_crowning * cos(helix) ** 2)
        return Scene(
            name=_name(phase),
            gap=self.gap(phase),
            radii=(float(contact.radius), along),
            motions=(
                RigidMotion(
                    direction * float(contact.pinion_velocity),
                    0.0,
                    -direction * self.pinion_speed * sin(helix),
                ),
                RigidMotion(
                    direction * float(contact.gear_velocity),
                    0.0,
                    direction * self.gear_speed * sin(helix),
                ),
            ),
            load=float(self.normal_force * contact.load_share),
            bodies=self.bodies,
            oil=self.oil_supplied,
            phase=phase,
        )

    def lubricated_teeth(self) -> LubricatedTeeth:
        """Pinion and gear as they carry oil."""
        speeds = self.pinion_speed, self.gear_speed
        return LubricatedTeeth(
            bodies={
                name: LubricatedBody(gear.tip, gear.tip - gear.root, speed)
                for name, gear, speed in zip(
                    ("pinion", "gear"), self.teeth.cylinders, speeds, strict=True
                )
            },
            face_width=self.teeth.face_width,
            rate=self.pinion_speed * self.teeth.pinion.teeth / (2 * pi),
            power=self.power,
        )

    def cycle_phases(self) -> Array:
        """Phases from 0 to 1 with both sides of the ends of single contact, where the load may jump."""
        ends = (self.phase_of(self.teeth.lowest_single), self.phase_of(self.teeth.highest_single))
        sides = [end + side for end in ends for side in (-1e-9, 1e-9) if 0 < end < 1]
        return np.sort(np.concatenate([np.linspace(0, 1, CYCLE_POINTS), sides]))

    @property
    def loss_factor(self) -> float:
        """H_V [-]: power loss of the mesh over power and a constant coefficient of friction.

        It is the mean over the mesh cycle of load times sliding, with the load of the middle on every slice
        of the face, which is exact for spur gears. Ohlendorf's closed form is that of uniform sharing.
        """
        contacts = self.contacts(self.cycle_phases())
        system = self.teeth.system
        slice_of_line = self.teeth.face_width / cos(system.base_helix_angle)
        rubbed = contacts.unit_load * np.abs(contacts.sliding) / (self.load_factor * self.power)
        return float(
            np.trapezoid(rubbed, contacts.pinion_length) * slice_of_line / system.base_pitch
        )

    def friction_load_factor(self, contacts: ToothContacts, friction: float) -> Array:
        """Normal load with friction over that without, at the same torque of the driver [-].

        It is 1 / (1 -+ mu rho / (r_b cos beta_b)) of the driver: in approach the faster tip of the driven
        gear drags its root along (-), which raises the load; in recess its tip is held back (+).
        """
        base = self.teeth.cylinders[0 if self.driver == "pinion" else 1].base
        length = contacts.pinion_length if self.driver == "pinion" else contacts.gear_length
        arm = length / (base * cos(self.teeth.system.base_helix_angle))
        return 1 / (1 - friction * arm * np.where(contacts.approach, 1.0, -1.0))

    def rating(self, contacts: ToothContacts) -> LineOfAction:
        """Film, specific film and contact temperature by closed forms at these contacts."""
        return rate(contacts, self.bodies, self.oil, self.surfaces)


def _name(phase: float) -> str:
    return f"phase {phase:.3g}"
