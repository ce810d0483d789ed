"""The worm drive: what it answers of its mesh, and what it assumes."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial

from pyworm.drives.answers import HobSetup, Misalignment, Shim, Space
from pyworm.drives.drive import AllowedErrors, Drive
from pyworm.drives.duty import WormDuty
from pyworm.drives.forces import MeshForces, Supports
from pyworm.drives.loaded_root import LoadedRoot
from pyworm.drives.mesh_loss import ContactLoss, MeshLoss
from pyworm.drives.rotor import Rotor
from pyworm.drives.tooth_life import ToothLife
from pyworm.drives.torque_balance import MeshAtTorque, torque_balance
from pyworm.drives.worm.dataset import loaded_cycle_data, mesh_cycle_data, pattern_data, tooth_data
from pyworm.drives.worm.drawing.design import AS_DESIGNED
from pyworm.drives.worm.duty import worm_duty
from pyworm.drives.worm.geometry_table import (
    SHEET,
    described_mesh,
    described_patterns,
    described_tolerances,
    signed_geometry,
)
from pyworm.drives.worm.inspection import AS_DRAWN, Inspection
from pyworm.drives.worm.loads.load_sharing import SHAFTS
from pyworm.drives.worm.loads.mesh import WormMesh
from pyworm.drives.worm.loads.mesh_stiffness import mesh_at_torque
from pyworm.drives.worm.loads.shaft_forces import worm_forces
from pyworm.drives.worm.loads.temperatures import worm_rotors
from pyworm.drives.worm.loads.tooth_compliance import EDGE_CONTACT_PHASES
from pyworm.drives.worm.loads.tooth_pair_motion import tooth_life
from pyworm.drives.worm.mesh_loss import worm_mesh_loss
from pyworm.drives.worm.misalignment import worm_misalignment
from pyworm.drives.worm.patterns.contact_pattern import ContactPattern, both_flanks, contact_pattern
from pyworm.drives.worm.patterns.hob_for_pattern import hob_for_pattern
from pyworm.drives.worm.patterns.loaded_pattern import loaded_pattern
from pyworm.drives.worm.patterns.shim import found_shim
from pyworm.drives.worm.sensitivity import sensitivity_data
from pyworm.drives.worm.shapes import in_space
from pyworm.drives.worm.solids import solids
from pyworm.drives.worm.teeth.checks import check_gears, check_values
from pyworm.drives.worm.teeth.gear_warnings import gear_warnings
from pyworm.drives.worm.teeth_roots import worm_roots
from pyworm.drives.worm.tolerances import Tolerance, tolerances
from pyworm.formulas.ranges import one_of
from pyworm.io.on_demand import xarray as xr
from pyworm.io.plain_dataset import PlainDataset
from pyworm.io.present import present
from pyworm.io.solid import Solid
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene

MIRRORED = (
    "The left-hand worm is computed as its mirror image, a right-hand one that turns the other way: the "
    "results are equal, and pictures show the mirror image, the leaving side where it is in both."
)


@dataclass(frozen=True, kw_only=True)
class WormDrive(WormMesh, Drive):
    """A worm drive at one operating point; ValueError, which begins with a key, if its teeth do not mesh."""

    body_names = "worm", "wheel"
    rated_as = WormDuty
    sheet = SHEET
    possible_drivers = SHAFTS
    # patterns of both flanks, a gear set for each error: 2 to 21 s of ten sets whose gap takes 0.6 to 11 us
    cycle_seconds, cycle_points = 4.0, 4e6

    inspection: Inspection = AS_DRAWN
    """Balls, and deviations of thickness and centre distance, for the inspection sheet."""
    assumed: tuple[str, ...] = ()
    """Usual values that were taken where none was given, a sentence each that begins with the key."""
    warmth: str = ""
    """Where the bulk temperatures of worm and wheel come from, a sentence; empty where they are given."""

    def __post_init__(self) -> None:
        if (self.tooth_load is None) == (self.transmission is None):
            raise ValueError("tooth_load, transmission: give one of both")
        given = {} if self.tooth_load is None else {"tooth_load": self.tooth_load}
        check_values({"speed": self.speed, **given})
        check_gears(self)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings of the gears, and that of a worm that is softer than its wheel."""
        found = gear_warnings(self)
        worm, wheel = (body.hardness for body in self.bodies)
        if worm is None or wheel is None or worm >= wheel:
            return found
        return (
            *found,
            f"worm has flanks of a hardness of {worm / 1e9:.3g} GPa, softer than the wheel's "
            f"{wheel / 1e9:.3g} GPa; worms are the harder ones as a rule, are bodies.worm and bodies.wheel "
            "swapped?",
        )

    @property
    def usual_values(self) -> tuple[str, ...]:
        """Dimensions that the drawing does not give."""
        return tuple(f"Assumed by common practice: drive.{entry}." for entry in self.assumed)

    @property
    def assumptions(self) -> tuple[str, ...]:
        """The load and its sharing, rigid teeth and shafts, the hand, and usual values taken."""
        if self.tooth_load is None:
            shared = self.shared_torque
            load = (
                f"The teeth in mesh share {shared.torque:.4g} N m of the {shared.shaft} ({shared.sharing} "
                f"sharing, friction {shared.friction:.2g} in the balance of torques"
                f"{', with the separation by their films' if shared.lifts else ''})."
            )
        else:
            load = (
                f"The load on the tooth, {self.tooth_load / 1e3:.4g} kN, is given and the same at every "
                "phase; it is not shared among teeth."
            )
        return (
            load,
            self._bending,
            *self._deviating,
            *filter(None, (self.warmth,)),
            *(() if self.edge_contact is None else (self.edge_contact.words,)),
            *((MIRRORED,) if self.hand == "left" else ()),
            *self.usual_values,
        )

    @property
    def _bending(self) -> str:
        if self.shaft_deflection is None:
            return (
                "Contacts are those of the unloaded mesh: shafts, bearings and teeth do not bend, but for "
                "the contact itself."
            )
        bent = self.shaft_deflection
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

    def scene(self, phase: float) -> Scene:
        """The lubricated contact at a phase of the mesh cycle: body 1 is the worm, body 2 the wheel."""
        self.contact(phase)  # refuses other phases
        return replace(self.scene_at(phase), past=self.life.past(phase))

    @cached_property
    def life(self) -> ToothLife:
        """The life of a tooth pair, from flanks that come together to the last ones under load."""
        return tooth_life(self)

    @cached_property
    def driven_pattern(self) -> ContactPattern:
        """Contact pattern without load of the flank that the worm drives; nothing bends."""
        if self.with_rigid_shaft is not self:
            return self.with_rigid_shaft.driven_pattern
        return contact_pattern(self, self.flank_grid)

    @cached_property
    def patterns(self) -> tuple[ContactPattern, ContactPattern]:
        """Contact patterns without load, of that flank and of the wheel's other one; nothing bends."""
        if self.with_rigid_shaft is not self:
            return self.with_rigid_shaft.patterns
        return both_flanks(self, contact_pattern)

    @cached_property
    def _loaded_patterns(self) -> tuple[ContactPattern, ContactPattern]:
        """Contact patterns under the load, of the flank that the worm drives and of the other one."""
        return both_flanks(self, loaded_pattern)

    @property
    def pattern_margin(self) -> float:
        """Distance of the driven flank's contact pattern without load from the nearer end of the face [m]."""
        first, last = self.driven_pattern.along_face()
        return self.wheel.face_width / 2 - max(-first, last)

    def allowed_errors(self) -> AllowedErrors:
        """Errors of the assembly that it allows, each alone."""
        return {tolerance.entry: tolerance.row for tolerance in self.tolerances}

    @cached_property
    def tolerances(self) -> tuple[Tolerance, ...]:
        """Errors of the assembly that it allows, one at a time."""
        return tolerances(self)

    def cycle_data(self) -> "xr.Dataset":
        """The mesh cycle for the result, without load and with it."""
        patterns = pattern_data(self.patterns, self._loaded_patterns)
        return self.cycle_around_contact().merge(patterns, combine_attrs="no_conflicts")

    def cycle_around_contact(self) -> "xr.Dataset":
        """The mesh cycle without the patterns of whole flanks, which cost as much as a film."""
        data = mesh_cycle_data(self.mesh_cycle())
        for part in (self.loaded_cycle(), sensitivity_data(self)):
            data = data.merge(part, combine_attrs="no_conflicts")
        return data

    def loaded_cycle(self) -> "xr.Dataset":
        """Loads, levers and speeds of a tooth pair over its cycle under load."""
        return self._loaded_cycle

    @cached_property
    def _loaded_cycle(self) -> "xr.Dataset":
        return loaded_cycle_data(self, 0.0 if self.transmission is None else EDGE_CONTACT_PHASES)

    def mesh_loss(self, contacts: Sequence[ContactLoss]) -> MeshLoss | None:
        """Loss of all teeth in mesh; None for too few phases of teeth that share a torque."""
        return worm_mesh_loss(self, self.loaded_cycle, contacts)

    def hob_setup(self, wanted: dict[str, float]) -> HobSetup:
        """The hob's set-up, and the one found for a wanted contact pattern."""
        return hob_for_pattern(self, wanted)

    def wheel_shim(self, wanted: float | None) -> Shim:
        """The shim under the wheel for a place of the pattern without load; of no errors where None."""
        return found_shim(self.with_rigid_shaft, self.patterns, wanted)

    def roots(self) -> tuple[LoadedRoot, ...]:
        """Roots of the thread and of the wheel's teeth."""
        return worm_roots(self, self.duty().gear)

    def at_load(self, speed: float, torque: float) -> "WormDrive":
        """The gears at another speed of the worm [rad/s] and torque of the wheel [N m]."""
        shared = replace(self.shared_torque, torque=torque, shaft="wheel")
        return replace(self, speed=speed, transmission=shared)

    def mesh_at_torque(self) -> MeshAtTorque:
        """Loss both ways and yielding of the mesh, the worm driving."""
        return mesh_at_torque(self, torque_balance(self.loaded_cycle()))

    def geometry(self) -> dict[str, float | str]:
        """Diameters, lead, profile shift, backlash, clearances and contact ratio."""
        return signed_geometry(self, self.inspection)

    def geometry_table(self) -> dict[str, float | str]:
        """The computed drawing, its kinematics and its pattern."""
        parts = (
            described_mesh(self, self.inspection),
            described_patterns(
                self.driven_pattern, self._loaded_patterns[0], self.wheel.face_width
            ),
            {}
            if self.assembly == AS_DESIGNED
            else {"wheel_shim_to_leaving_side_m": self.wheel_shim(None).shift},
            described_tolerances(self.play, self.tolerances),
        )
        return dict(item for part in parts for item in part.items())

    def mesh_forces(self, friction: float | None = None, driver: str | None = None) -> MeshForces:
        """Mean forces of all teeth in mesh under the torque of the wheel; ValueError of another shaft."""
        driving = self.driver if driver is None else one_of("driver", driver, SHAFTS)
        return worm_forces(self, self.friction if friction is None else friction, driving)

    @property
    def supports(self) -> dict[str, Supports]:
        """Bearings of the worm's and the wheel's shaft, where they are given."""
        worm = None
        if self.shaft is not None:
            worm = Supports(self.shaft.bearing_span, self.shaft.bearing_offset)
        both = {"worm": worm, "wheel": self.wheel_shaft}
        return {name: supports for name, supports in both.items() if supports is not None}

    @property
    def shaft_speeds(self) -> dict[str, float]:
        """Speeds of both shafts [rad/s]."""
        return {"worm": self.speed, "wheel": self.speed * self.ratio}

    @property
    def rotors(self) -> tuple[Rotor, Rotor]:
        """Worm and wheel; ValueError where the load of one tooth is given."""
        return worm_rotors(
            self, {name: shaft.bearing_span for name, shaft in self.supports.items()}
        )

    def misalignment(self, contacts: Sequence[Scene | LineScene]) -> Misalignment:
        """Contacts at the phases of the given ones with each assembly error, one at a time."""
        return worm_misalignment(
            self, [contact for contact in contacts if isinstance(contact, Scene)]
        )

    def duty(self) -> WormDuty:
        """The drive as input of ratings by standards of worm gears."""
        return worm_duty(self)

    def in_space(self, places: Sequence[ContactIndex]) -> Space:
        """The thread that drives and the flank of the wheel that it drives."""
        return in_space(self, [present(place.phase, "phase") for place in places])

    def solids(self) -> dict[str, Solid]:
        """Worm, wheel and hob as designed, in contact at mid-mesh."""
        return solids(self, self.hand)

    def scene_data(self, scene: Scene | LineScene) -> PlainDataset:
        """The wheel tooth with its whole gap and its path of contact, for the scene's pictures."""
        if not isinstance(scene, Scene):
            raise TypeError("the contacts of a worm drive are point contacts")
        contact = self.contact(present(scene.phase, "phase"))
        places = partial(self.flank_place, contact), partial(self.thread_place, contact)
        return tooth_data(self.tooth_outline(contact), scene.gap, *places)
