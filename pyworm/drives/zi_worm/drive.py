"""The worm drive at an operating point: speeds and loads of its tooth contacts, and their scenes."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from math import floor, pi
from typing import Any

import numpy as np

from pyworm.drives.drive import AllowedErrors, Drive
from pyworm.drives.duty import WormDuty
from pyworm.drives.hob_setup import HobSetup
from pyworm.drives.lubrication import Bath, Jets, OiledBody, OiledTeeth
from pyworm.drives.mesh_loss import ContactLoss, MeshLoss
from pyworm.drives.misalignment import Misalignment
from pyworm.drives.shape import Space
from pyworm.drives.shim import Shim
from pyworm.drives.tooth_life import ToothLife
from pyworm.drives.zi_worm.checks import check_values
from pyworm.drives.zi_worm.contact_pattern import ContactPattern, both_flanks
from pyworm.drives.zi_worm.dataset import (
    loaded_cycle_data,
    mesh_cycle_data,
    pattern_data,
    tooth_data,
)
from pyworm.drives.zi_worm.described import described_drive, signed_geometry
from pyworm.drives.zi_worm.design import Assembly, Hand
from pyworm.drives.zi_worm.duty import worm_duty
from pyworm.drives.zi_worm.gap import ToothMotion
from pyworm.drives.zi_worm.gears import ZiWormGears
from pyworm.drives.zi_worm.helicoid import Array
from pyworm.drives.zi_worm.load_sharing import Arms, Shaft, SharedLoad, Transmission, share
from pyworm.drives.zi_worm.loaded_pattern import loaded_pattern
from pyworm.drives.zi_worm.mesh_cycle import ToothContact
from pyworm.drives.zi_worm.mesh_loss import worm_mesh_loss
from pyworm.drives.zi_worm.mesh_springs import MeshedTeeth, mesh_springs
from pyworm.drives.zi_worm.meshing import WHEEL_AXIS, across_axis
from pyworm.drives.zi_worm.misalignment import worm_misalignment
from pyworm.drives.zi_worm.play import check_play
from pyworm.drives.zi_worm.sensitivity import sensitivity_data
from pyworm.drives.zi_worm.shapes import in_space
from pyworm.drives.zi_worm.shim import found_shim
from pyworm.drives.zi_worm.tolerances import Tolerance, tolerances
from pyworm.drives.zi_worm.tooth_compliance import BEYOND, LONGEST_RATIO, ToothSprings
from pyworm.drives.zi_worm.tooth_pair_life import tooth_life
from pyworm.drives.zi_worm.wanted_pattern import set_up
from pyworm.drives.zi_worm.worm_shaft import BentShaft, WormShaft, bent_shaft
from pyworm.io.on_demand import xarray as xr
from pyworm.io.plain_dataset import PlainDataset
from pyworm.io.present import present
from pyworm.materials.body import Body, reduced_modulus
from pyworm.materials.oil import Oil
from pyworm.scene.index import Place
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene

MIRRORED = (
    "The left-hand worm is computed as its mirror image, a right-hand one that turns the other way: all "
    "figures are the same, and pictures show the mirror image, the leaving side where it is in both."
)


@dataclass(frozen=True, kw_only=True)
class ZiWormDrive(ZiWormGears, Drive):
    """A worm drive at one operating point.

    Attributes
    ----------
    speed : float
        Speed of the worm [rad/s].
    load : float or Transmission
        Normal load on the tooth [N], or the torque that the teeth in mesh share.
    bodies : tuple of Body
        Worm and wheel.
    oil : Oil
        The oil.
    driver : str
        Driving member, "worm" or "wheel", on the same flanks.
    hand : str
        Hand of the threads; a left-hand drive is computed as its right-hand mirror image.
    taken : tuple of str
        Usual values that were taken where none was given, a sentence each that begins with the key.
    shaft : WormShaft or None
        The worm's shaft between its bearings, which bends under the load; None if rigid.
    lubrication : Bath, Jets or None
        How oil comes to its teeth; None where there is assumed to be enough.
    warmth : str
        Where the bulk temperatures of worm and wheel come from, a sentence; empty where they are given.
    """

    body_names = "worm", "wheel"
    rated_as = WormDuty

    speed: float
    load: float | Transmission
    bodies: tuple[Body, Body]
    oil: Oil
    driver: Shaft = "worm"
    hand: Hand = "right"
    taken: tuple[str, ...] = ()
    shaft: WormShaft | None = None
    lubrication: Bath | Jets | None = None
    warmth: str = ""

    def __post_init__(self) -> None:
        given = {} if isinstance(self.load, Transmission) else {"load": self.load}
        check_values({"speed": self.speed, **given})
        super().__post_init__()

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings of the gears, and that of a worm that is softer than its wheel."""
        worm, wheel = (body.hardness for body in self.bodies)
        if worm is None or wheel is None or worm >= wheel:
            return super().warnings
        return (
            *super().warnings,
            f"worm has flanks of a hardness of {worm / 1e9:.3g} GPa, softer than the wheel's "
            f"{wheel / 1e9:.3g} GPa; worms are the harder ones as a rule, are bodies.worm and bodies.wheel "
            "swapped?",
        )

    @property
    def assumptions(self) -> tuple[str, ...]:
        """The load and its sharing, rigid teeth and shafts, the hand, and usual values taken."""
        load = self.load
        if isinstance(load, Transmission):
            made = (
                f"The teeth in mesh share {load.torque:.4g} N m of the {load.shaft} ({load.sharing} sharing, "
                f"friction {load.friction:.2g} in the balance of torques"
                f"{', with the lift of their films' if load.lifts else ''})."
            )
        else:
            made = (
                f"The load on the tooth, {load / 1e3:.4g} kN, is given and the same at every phase; "
                "it is not shared among teeth."
            )
        return (
            made,
            self._bending,
            *self._deviating,
            *filter(None, (self.warmth,)),
            *(() if self.edge_contact is None else (self.edge_contact.words,)),
            *((MIRRORED,) if self.hand == "left" else ()),
            *(f"Taken as usual: drive.{one}." for one in self.taken),
        )

    @property
    def _bending(self) -> str:
        """What bends, as an assumption."""
        if self.bent is None:
            return (
                "Contacts are those of the unloaded mesh: shafts, bearings and teeth do not bend, but for "
                "the contact itself."
            )
        bent = self.bent
        return (
            f"The worm's shaft bends {bent.deflection * 1e6:.3g} µm at the mesh under its mean forces, "
            f"{bent.away * 1e6:.3g} µm of it away from the wheel, and tilts by {bent.tilt * 1e3:.3g} mrad; "
            "contacts are those of the mesh so displaced. The wheel's shaft and teeth do not bend, but for "
            "the contact itself. The limit of the deflection, 0.04 sqrt(m_x) mm, is the worm standard's from "
            "memory, not compared with its text."
        )

    @property
    def _deviating(self) -> tuple[str, ...]:
        """Where deviations of the flanks hold, as assumptions; empty without any."""
        where = {
            "worm": "driving flank of each thread of the worm; its other flank is a helicoid",
            "wheel": "driven flank of each tooth of the wheel; its other flank is as the hob cuts it",
        }
        return tuple(
            f"The file's deviations differ by {deviations.spread * 1e6:.3g} µm over the {where[name]}."
            for name, deviations in self.deviating.items()
        )

    @cached_property
    def rigid(self) -> "ZiWormDrive":
        """The drive with a shaft that does not bend."""
        return self if self.shaft is None else replace(self, shaft=None)

    @cached_property
    def bent(self) -> BentShaft | None:
        """The worm's shaft under the load; None of a rigid one."""
        return None if self.shaft is None else bent_shaft(self.rigid, self.shaft)

    @property
    def mounted(self) -> Assembly:
        """Where the worm runs under the load: errors of the assembly with those of the bent shaft."""
        return self.assembly if self.bent is None else self.bent.assembly(self.assembly)

    def turned_parts(self) -> dict[str, Any]:
        """What half a turn about X changes, by its names."""
        parts = super().turned_parts()
        if self.shaft is None or not self.shaft.bearing_offset:
            return parts
        return parts | {"shaft": self.shaft.turned}

    @cached_property
    def driven_pattern(self) -> ContactPattern:
        """Contact pattern without load of the flank that the worm drives; nothing bends."""
        return super().driven_pattern if self.shaft is None else self.rigid.driven_pattern

    @cached_property
    def patterns(self) -> tuple[ContactPattern, ContactPattern]:
        """Contact patterns without load of both flanks; nothing bends."""
        return super().patterns if self.shaft is None else self.rigid.patterns

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
        """The same at any phase; before and after the mesh cycle flanks may touch at an edge of a tooth."""
        return self.cycle.contact(phase, self.rotation)

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
    def transmission(self) -> Transmission:
        """The torque that the teeth in mesh share; ValueError where the load of one tooth is given."""
        if not isinstance(self.load, Transmission):
            raise ValueError("the load of one tooth is given, which no teeth share")
        return self.load

    @property
    def wheel_torque(self) -> float:
        """Torque of the wheel [N m]; for a given tooth load the mean over the mesh cycle without friction."""
        if not isinstance(self.load, Transmission):
            return self.load * self.load_arm * self.mean_teeth_in_contact
        arms = self.arms(np.array([0.5]))
        own, wheel = (arms.of(shaft, self.friction)[0] for shaft in (self.load.shaft, "wheel"))
        return self.load.torque * float(wheel / own)

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
        sliding: Array = self.rotation * (
            self.worm_flank.sweep(point) + ratios * across_axis(point)
        )
        return sliding

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

    def shared(self, phase: float) -> SharedLoad:
        """Normal loads of all tooth pairs while one of them is at a phase."""
        first = -floor((phase + BEYOND) / self.pitch)
        last = floor((1 + BEYOND - phase) / self.pitch)
        phases = phase + self.pitch * np.arange(first, last + 1)
        if not isinstance(self.load, Transmission):
            forces = np.where((phases >= 0) & (phases <= 1), self.load, 0.0)
            return SharedLoad(phases, forces, 0.0)
        ahead = self.cycle.transmission_error(phases)
        arms = self.arms(phases)
        torques = arms.of(self.load.shaft, self.load.friction)
        springs = None if self.load.sharing == "equal" else self.springs
        return share(self.load, phases, torques, arms.wheel_normal, ahead, springs)

    def normal_load(self, phase: float) -> float:
        """Normal load of the tooth pair at a phase [N]; 0 where its neighbours carry all of it."""
        return self.shared(phase).force(phase)

    def idle(self, phase: float) -> bool:
        """Whether the tooth pair at a phase carries no load; under a given tooth load never."""
        return isinstance(self.load, Transmission) and self.normal_load(phase) == 0

    @cached_property
    def unlifted(self) -> "ZiWormDrive | None":
        """The drive with load sharing as without films; None where no lift of films is known."""
        if not isinstance(self.load, Transmission) or not self.load.lifts:
            return None
        return replace(self, load=replace(self.load, lifts=()))

    @cached_property
    def mid_mesh_load(self) -> float:
        """Normal load under which the contact at mid-mesh is compared with others [N].

        It is the largest of the mesh cycle where neighbouring teeth carry all of the load at mid-mesh.
        """
        return self.normal_load(0.5) or max(map(self.normal_load, np.linspace(0, 1, 21)))

    @cached_property
    def loaded_patterns(self) -> tuple[ContactPattern, ContactPattern]:
        """Contact patterns under the load, of the flank that the worm drives and of the other one."""
        return both_flanks(self, loaded_pattern)

    def allowed_errors(self) -> AllowedErrors:
        """Errors of the assembly that it allows, each alone."""
        return {one.entry: one.row for one in self.tolerances}

    @cached_property
    def tolerances(self) -> tuple[Tolerance, ...]:
        """Errors of the assembly that it allows, one at a time."""
        return tolerances(self)

    @cached_property
    def springs(self) -> ToothSprings:
        """Compliance of a tooth pair over its mesh cycle; only where a torque is shared."""
        shared = self.transmission
        whole = shared.torque / float(self.arms(np.array([0.5])).of(shared.shaft, 0.0)[0])
        modulus = reduced_modulus(*self.bodies)
        return mesh_springs(MeshedTeeth.of(self), modulus, whole, shared.stiffness)

    def scene(self, phase: float) -> Scene:
        """The lubricated contact at a phase of the mesh cycle: body 1 is the worm, body 2 the wheel."""
        self.contact(phase)  # refuses other phases
        return replace(self._scene(phase), past=self.life.past(phase))

    @cached_property
    def life(self) -> ToothLife:
        """The life of a tooth pair, from flanks that come together to the last ones under load."""
        return tooth_life(self, self._scene, self._axes)

    def _axes(self, phase: float) -> Array:
        return self.contact_beyond(phase).axes

    def _scene(self, phase: float) -> Scene:
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
        return self.load.friction if isinstance(self.load, Transmission) else 0.0

    def cycle_data(self) -> "xr.Dataset":
        """The mesh cycle for the result, without load and with it."""
        parts = (
            self.loaded_cycle(),
            sensitivity_data(self),
            pattern_data(self.patterns, self.loaded_patterns),
        )
        data = mesh_cycle_data(self.mesh_cycle())
        for part in parts:
            data = data.merge(part, combine_attrs="no_conflicts")
        return data

    def loaded_cycle(self) -> "xr.Dataset":
        """Loads, levers and speeds of a tooth pair over its cycle under load."""
        return self._loaded_cycle

    @cached_property
    def _loaded_cycle(self) -> "xr.Dataset":
        return loaded_cycle_data(self, BEYOND if isinstance(self.load, Transmission) else 0.0)

    def varied(self, name: str, change: float) -> "ZiWormDrive":
        """The drive with a difference in one entry of a table, "assembly.axial_shift" or "hob.swivel".

        Raises
        ------
        ValueError
            If such a drive is not possible.
        """
        part, key = name.split(".")
        table = getattr(self, part)
        return replace(self, **{part: replace(table, **{key: getattr(table, key) + change})})

    def mesh_loss(self, contacts: Sequence[ContactLoss]) -> MeshLoss | None:
        """Loss of all teeth in mesh; None for too few phases of teeth that share a torque."""
        return worm_mesh_loss(self, contacts)

    def hob_setup(self, wanted: dict[str, float]) -> HobSetup:
        """The hob's set-up, and the one found for a wanted contact pattern."""
        return set_up(self, wanted)

    def wheel_shim(self, wanted: float | None) -> Shim:
        """The shim under the wheel for a place of the pattern without load; of no errors where None."""
        return found_shim(self.rigid, wanted)

    def oiled_teeth(self) -> OiledTeeth:
        """Worm and wheel as they carry oil."""
        depth = self.worm.tip_radius - self.worm.root_radius
        wheel_speed = self.speed * self.ratio
        return OiledTeeth(
            bodies={
                "worm": OiledBody(self.worm.tip_radius, depth, self.speed),
                "wheel": OiledBody(self.wheel.throat_radius, depth, wheel_speed),
            },
            face_width=self.wheel.face_width,
            rate=self.speed * self.worm.threads / (2 * pi),
            power=self.wheel_torque * wheel_speed,
        )

    def geometry(self) -> dict[str, float | str]:
        """Diameters, lead, profile shift, backlash, clearances and contact ratio."""
        return signed_geometry(self)

    def described(self) -> dict[str, float | str]:
        """The computed drawing, its kinematics and its pattern."""
        return described_drive(self)

    def misalignment(self, contacts: Sequence[Scene | LineScene]) -> Misalignment:
        """The same phases with each error of the assembly, one at a time."""
        return worm_misalignment(self, [of for of in contacts if isinstance(of, Scene)])

    def duty(self) -> WormDuty:
        """The drive as input of ratings by standards of worm gears."""
        return worm_duty(self)

    def in_space(self, places: Sequence[Place]) -> Space:
        """The thread that drives and the flank of the wheel that it drives."""
        return in_space(self, [present(of.phase, "phase") for of in places])

    def scene_data(self, scene: Scene | LineScene) -> PlainDataset:
        """The wheel tooth with its whole gap and its path of contact, for the scene's pictures."""
        if not isinstance(scene, Scene):
            raise TypeError("the contacts of a worm drive are point contacts")
        contact = self.contact(present(scene.phase, "phase"))
        places = partial(self.flank_place, contact), partial(self.thread_place, contact)
        return tooth_data(self.tooth_outline(contact), scene.gap, *places)
