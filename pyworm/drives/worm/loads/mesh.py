"""The mesh of a worm drive: speeds and loads of its tooth contacts, and their scenes under a load."""

from dataclasses import dataclass, replace
from functools import cached_property
from math import floor, pi
from typing import Any, Self

import numpy as np

from pyworm.drives.forces import Supports
from pyworm.drives.oil_supply import Bath, Jets, Lubricated, LubricatedBody, LubricatedTeeth
from pyworm.drives.worm.drawing.design import Assembly, Hand
from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.flanks.wheel_envelope import WHEEL_AXIS, across_axis
from pyworm.drives.worm.loads.load_sharing import Arms, Shaft, SharedLoad, Transmission, share
from pyworm.drives.worm.loads.tooth_compliance import (
    EDGE_CONTACT_PHASES,
    LONGEST_RATIO,
    MeshedTeeth,
    ToothSprings,
    mesh_springs,
)
from pyworm.drives.worm.loads.worm_shaft import BentShaft, MeshForce, WormShaft, bent_shaft
from pyworm.drives.worm.teeth.checks import check_play
from pyworm.drives.worm.teeth.gap import ToothMotion
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.drives.worm.teeth.mesh_cycle import ToothContact
from pyworm.materials.body import Body, reduced_modulus
from pyworm.materials.oil import Oil
from pyworm.scene.point import Scene


@dataclass(frozen=True, kw_only=True)
class WormMesh(WormGears, Lubricated):
    """Worm and wheel at a speed and a load."""

    speed: float
    """Speed of the worm [rad/s]."""
    tooth_load: float | None = None
    """Normal load on each tooth in mesh [N]; None where the teeth share a torque."""
    transmission: Transmission | None = None
    """Torque that the teeth in mesh share; None where the load of a tooth is given."""
    bodies: tuple[Body, Body]
    """Worm and wheel."""
    oil: Oil
    """The oil."""
    driver: Shaft = "worm"
    """Driving member, "worm" or "wheel", on the same flanks."""
    hand: Hand = "right"
    """Hand of the threads; a left-hand drive is computed as its right-hand mirror image."""
    shaft: WormShaft | None = None
    """The worm's shaft between its bearings, which bends under the load; None if rigid."""
    wheel_shaft: Supports | None = None
    """The bearings of the wheel's shaft, which does not bend; None where they are not given."""
    lubrication: Bath | Jets | None = None
    """How oil comes to its teeth; None where there is assumed to be enough."""

    @cached_property
    def with_rigid_shaft(self) -> Self:
        """The mesh with a shaft that does not bend."""
        return self if self.shaft is None else replace(self, shaft=None)

    @cached_property
    def shaft_deflection(self) -> BentShaft | None:
        """The worm's shaft under the load; None of a rigid one."""
        if self.shaft is None:
            return None
        modulus = self.bodies[0].youngs_modulus
        return bent_shaft(
            self.shaft, self.with_rigid_shaft, self.with_rigid_shaft.mean_force, modulus
        )

    @property
    def mean_force(self) -> MeshForce:
        """The force of all teeth in mesh on the worm, as if it acted in mid-mesh."""
        return self.force_with(self.friction)

    def force_with(self, friction: float) -> MeshForce:
        """That force with another friction and the same torque of the wheel.

        A negative coefficient is that of sliding the other way, as the other shaft drives on these flanks.
        """
        middle = np.array([0.5])
        point, normal = self.cycle.points(middle)[:, 0], self.cycle.normals(middle)[:, 0]
        sliding = self.sliding(middle)[:, 0]
        wheel = float(self.arms(middle).of("wheel", friction)[0])
        load = self.wheel_torque / wheel
        force = -load * (normal + friction * sliding / np.linalg.norm(sliding))
        return MeshForce(point, force)

    @property
    def assembly_under_load(self) -> Assembly:
        """Where the worm runs under the load: errors of the assembly with those of the bent shaft."""
        return (
            self.assembly
            if self.shaft_deflection is None
            else self.shaft_deflection.assembly(self.assembly)
        )

    def _turned_parts(self) -> dict[str, Any]:
        """What half a turn about X changes, by its names."""
        parts = super()._turned_parts()
        if self.shaft is None or not self.shaft.bearing_offset:
            return parts
        return parts | {"shaft": self.shaft.turned}

    @property
    def rotation(self) -> float:
        """Speed of the worm [rad/s], positive from phase 0 to phase 1, negative the other way."""
        return self.speed if self.driver == "worm" else -self.speed

    @property
    def phases_per_second(self) -> float:
        """Rate of change of the phase [1/s]."""
        return self.rotation / abs(self.cycle.worm_rotation)

    def contact(self, phase: float) -> ToothContact:
        """The unloaded tooth contact at a phase of the mesh cycle, 0 to 1."""
        if not 0 <= phase <= 1:
            raise ValueError(f"phase is {phase:.6g}; a tooth pair touches from phase 0 to phase 1")
        return self.contact_beyond(phase)

    def contact_beyond(self, phase: float) -> ToothContact:
        """The unloaded tooth contact at any phase; outside the mesh cycle it may lie at a tooth's edge."""
        return self.cycle.contact(phase, self.rotation)

    def contact_axes(self, phase: float) -> Array:
        """Axes of the tangent plane of the contact at any phase, as rows, (3, 3)."""
        return self.contact_beyond(phase).axes

    @property
    def mean_teeth_in_contact(self) -> float:
        """Teeth in contact, on average: worm angle of a mesh cycle over that of a pitch [-]."""
        turned = self.contact(1.0).worm_angle - self.contact(0.0).worm_angle
        return turned * self.worm.threads / (2 * pi)

    @property
    def load_arm(self) -> float:
        """Torque on the wheel over the normal load of a tooth, without friction [m].

        In mid-mesh; of involute worms, whose line of action is one line in space, the same at every phase.
        """
        contact = self.contact(0.5)
        return float(abs(np.cross(contact.point, contact.normal)[1]))

    @property
    def shared_torque(self) -> Transmission:
        """The torque that the teeth in mesh share; ValueError where the load of one tooth is given."""
        if self.transmission is None:
            raise ValueError("the load of one tooth is given, which no teeth share")
        return self.transmission

    @property
    def wheel_torque(self) -> float:
        """Torque of the wheel [N m]; for a given tooth load the mean over the mesh cycle without friction."""
        if self.tooth_load is not None:
            return self.tooth_load * self.load_arm * self.mean_teeth_in_contact
        shared, arms = self.shared_torque, self.arms(np.array([0.5]))
        shaft_arm, wheel = (arms.of(shaft, self.friction)[0] for shaft in (shared.shaft, "wheel"))
        return shared.torque * float(wheel / shaft_arm)

    def mesh_cycle(self, count: int = 21) -> tuple[ToothContact, ...]:
        """Contacts at equal steps of the worm's rotation from where the teeth meet to where they part."""
        return tuple(self.contact(float(phase)) for phase in np.linspace(0, 1, count))

    def motions(self, contact: ToothContact) -> tuple[ToothMotion, ToothMotion]:
        """Surface velocities of worm and wheel relative to the contact point."""
        worm_turn = self.rotation * self.worm_flank.axes[:, 2]
        wheel_turn = (
            self.rotation * -WHEEL_AXIS * self.cycle.speed_ratios(np.array([contact.phase]))
        )
        worm_axis, wheel_axis = self.worm_flank.axis_point, np.zeros(3)
        return (
            ToothMotion(contact, contact.worm_height, worm_axis, worm_turn),
            ToothMotion(contact, contact.wheel_height, wheel_axis, wheel_turn),
        )

    def sliding(self, phases: Array) -> Array:
        """Velocity of the worm against the wheel at contact points [m/s], (3, phases)."""
        point, ratios = self.cycle.points(phases), self.cycle.speed_ratios(phases)
        return self.rotation * (self.worm_flank.sweep(point) + ratios * across_axis(point))

    def arms(self, phases: Array) -> Arms:
        """Moment arms of the forces between the teeth at some phases."""
        point = self.cycle.points(phases)
        normal = self.cycle.normals(phases)
        sliding = self.sliding(phases)
        sliding = sliding / np.linalg.norm(sliding, axis=0)
        on_worm = point - self.worm_flank.axis_point[:, None]

        def about(arm: Array, force: Array, axis: Array) -> Array:
            return axis @ np.cross(arm, force, axis=0)

        worm_axis, wheel_axis = self.worm_flank.axes[:, 2], -WHEEL_AXIS
        return Arms(
            worm_normal=about(on_worm, normal, worm_axis),
            wheel_normal=about(point, normal, wheel_axis),
            worm_sliding=about(on_worm, sliding, worm_axis),
            wheel_sliding=about(point, sliding, wheel_axis),
        )

    def shared(self, phase: float, load_factor: float = 1.0) -> SharedLoad:
        """Normal loads of all tooth pairs while one of them is at a phase, under some times the torque."""
        first = -floor((phase + EDGE_CONTACT_PHASES) / self.pitch)
        last = floor((1 + EDGE_CONTACT_PHASES - phase) / self.pitch)
        phases = phase + self.pitch * np.arange(first, last + 1, dtype=np.float64)
        if self.tooth_load is not None:
            forces = np.where((phases >= 0) & (phases <= 1), self.tooth_load, 0.0)
            return SharedLoad(phases, forces, 0.0)
        ahead = self.cycle.transmission_error(phases)
        shared, arms = self.shared_torque, self.arms(phases)
        torques = arms.of(shared.shaft, shared.friction)
        springs = None if shared.sharing == "equal" else self.springs
        shared = replace(shared, torque=load_factor * shared.torque)
        return share(shared, phases, torques, arms.wheel_normal, ahead, springs)

    def normal_load(self, phase: float) -> float:
        """Normal load of the tooth pair at a phase [N]; 0 where its neighbours carry all of it."""
        return self.shared(phase).force(phase)

    def idle(self, phase: float) -> bool:
        """Whether the tooth pair at a phase carries no load; under a given tooth load never."""
        return self.transmission is not None and self.normal_load(phase) == 0

    @cached_property
    def without_film_lift(self) -> Self | None:
        """The mesh with load sharing as without films; None where no lift of films is known."""
        if self.transmission is None or not self.transmission.lifts:
            return None
        return replace(self, transmission=replace(self.transmission, lifts=()))

    @cached_property
    def mid_mesh_load(self) -> float:
        """Normal load under which the contact at mid-mesh is compared with others [N].

        It is the largest of the mesh cycle where neighbouring teeth carry all of the load at mid-mesh.
        """
        return self.normal_load(0.5) or max(map(self.normal_load, np.linspace(0, 1, 21)))

    @cached_property
    def springs(self) -> ToothSprings:
        """Compliance of a tooth pair over its mesh cycle; only where a torque is shared."""
        shared = self.shared_torque
        whole = shared.torque / float(self.arms(np.array([0.5])).of(shared.shaft, 0.0)[0])
        modulus = reduced_modulus(*self.bodies)
        return mesh_springs(MeshedTeeth.of(self), modulus, whole, shared.stiffness)

    def scene_at(self, phase: float) -> Scene:
        """The contact under its share of the load, without its past; ValueError if teeth jam or have none."""
        check_play(self)
        load = self.normal_load(phase)
        if load == 0:
            raise ValueError("the tooth pair carries no load there, its neighbours carry all")
        return self.scene_of(self.contact_beyond(phase), load)

    def scene_under(self, load: float, phase: float) -> Scene:
        """The contact at a phase under a normal load [N], without its past."""
        return self.scene_of(self.contact(phase), load)

    def scene_of(self, contact: ToothContact, load: float) -> Scene:
        """Scene of one tooth contact under a normal load [N]."""
        radius_x, radius_y = contact.radii
        return Scene(
            name=f"phase {contact.phase:.2f}",
            gap=self.gap(contact),
            radii=(min(radius_x, LONGEST_RATIO * radius_y), radius_y),
            motions=self.motions(contact),
            load=load,
            bodies=self.bodies,
            oil=self.oil_supplied,
            phase=contact.phase,
        )

    @property
    def friction(self) -> float:
        """Coefficient of friction in the balance of forces [-]."""
        return 0.0 if self.transmission is None else self.transmission.friction

    def varied(self, name: str, change: float) -> Self:
        """The mesh with a difference in one entry of a table, "assembly.axial_shift" or "hob.swivel".

        ValueError from a drive if such a one is not possible.
        """
        part, key = name.split(".")
        table = getattr(self, part)
        return replace(self, **{part: replace(table, **{key: getattr(table, key) + change})})

    def lubricated_teeth(self) -> LubricatedTeeth:
        """Worm and wheel as they carry oil."""
        depth = self.worm.tip_radius - self.worm.root_radius
        wheel_speed = self.speed * self.ratio
        return LubricatedTeeth(
            bodies={
                "worm": LubricatedBody(self.worm.tip_radius, depth, self.speed),
                "wheel": LubricatedBody(self.wheel.throat_radius, depth, wheel_speed),
            },
            face_width=self.wheel.face_width,
            rate=self.speed * self.worm.threads / (2 * pi),
            power=self.wheel_torque * wheel_speed,
        )
