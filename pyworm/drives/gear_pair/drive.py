"""The drive of a pair of involute gears: what it answers of its mesh."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import get_args

import numpy as np

from pyworm.drives.answers import Misalignment, MountingError, Space
from pyworm.drives.drive import Drive
from pyworm.drives.duty import GearPairDuty
from pyworm.drives.forces import MeshForces, Supports
from pyworm.drives.gear_pair.checks import check_gears, check_mesh
from pyworm.drives.gear_pair.dataset import line_of_action_data
from pyworm.drives.gear_pair.design import Driver
from pyworm.drives.gear_pair.film_formulas import contact_coefficient, mean_bulk_temperature
from pyworm.drives.gear_pair.geometry_table import SHEET, described_pair
from pyworm.drives.gear_pair.inspection import AS_DRAWN, PairInspection
from pyworm.drives.gear_pair.mesh import GearPairMesh
from pyworm.drives.gear_pair.shapes import in_space
from pyworm.drives.mesh_loss import ContactLoss, MeshLoss, largest_model
from pyworm.drives.rotor import Rotor
from pyworm.drives.tooth_life import ToothLife
from pyworm.formulas.ranges import one_of
from pyworm.io.on_demand import xarray as xr
from pyworm.io.present import present
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene

LEAD_ERROR = 10e-6
"""Deviation of the flank lines over the face width [m]."""

MESH_STIFFNESS = 0.85 * 20e9
"""Stiffness of the teeth of steel spur gears, for each width, against an uneven load [N/m2].

0.85 of 20 N/(mm um), the usual value of ISO 6336-1 (method C), from memory.
"""

METHOD = (
    "Misalignment by K_Hbeta of ISO 6336-1 with a mesh stiffness of 17 N/(mm µm), without crowning: "
    "1 + c F/(2 w), or 2 [c F/(2 w)]^(1/2) where the contact does not reach over the whole face."
)


@dataclass(frozen=True)
class GearPairDrive(GearPairMesh, Drive):
    """A pair of gears at one operating point; ValueError, which begins with a key, if it cannot run."""

    body_names = "pinion", "gear"
    rated_as = GearPairDuty
    sheet = SHEET
    possible_drivers = get_args(Driver)

    inspection: PairInspection = AS_DRAWN
    """Balls, spans, and deviations of thickness and centre distance, for the inspection sheet."""

    def __post_init__(self) -> None:
        check_gears(self.teeth)
        check_mesh(self)

    @property
    def assumptions(self) -> tuple[str, ...]:
        """The rule of load sharing, and rigid teeth and shafts."""
        return (
            f"Load sharing by the rule '{self.load_sharing}'; load factor {self.load_factor:g}.",
            "Shafts and teeth do not deform except in the contact; no dynamic loads but by the load "
            "factor.",
        )

    def scene(self, phase: float) -> LineScene | Scene:
        """The contact at a phase, of a line in mid-face; body 1: pinion, x to its tip, y along the line."""
        base_speed = self.pinion_speed * self.teeth.cylinders[0].base
        return ToothLife(self.scene_at, base_speed / self.teeth.path_length).at(phase)

    def in_space(self, places: Sequence[ContactIndex]) -> Space:
        """Some teeth of both gears."""
        return in_space(
            self.teeth,
            [float(self.contacts(present(place.phase, "phase")).pinion_length) for place in places],
        )

    def mesh_loss(self, contacts: Sequence[ContactLoss]) -> MeshLoss | None:
        """Loss by the loss factor and the mean friction; None for fewer than two phases."""
        if len(contacts) < 2:
            return None
        friction = self._mean_friction(contacts)
        return MeshLoss(
            power=self.power,
            loss=self.power * self.loss_factor * friction,
            friction=friction,
            error=max(contact.error for contact in contacts),
            words=f"loss factor H_V = {self.loss_factor:.4f}, friction interpolated between the solved "
            "phases",
            model=largest_model(contacts),
        )

    def _mean_friction(self, contacts: Sequence[ContactLoss]) -> float:
        """Mean friction over load times sliding, interpolated between the contacts, else constant [-]."""
        known = sorted((contact.phase, contact.friction) for contact in contacts)
        phases = self.cycle_phases()
        all_of_them = self.contacts(phases)
        weight = all_of_them.unit_load * np.abs(all_of_them.sliding)
        solved_phases, frictions = zip(*known, strict=True)
        friction = np.interp(phases, solved_phases, frictions)
        return float(np.trapezoid(weight * friction, phases) / np.trapezoid(weight, phases))

    def misalignment(self, contacts: Sequence[LineScene | Scene]) -> Misalignment:
        """Line contacts under the uneven load of flanks that are not parallel."""
        if not all(isinstance(contact, LineScene) for contact in contacts):
            return Misalignment(METHOD)
        mean = self.normal_force / self.teeth.face_width
        excess = MESH_STIFFNESS * LEAD_ERROR / (2 * mean)
        factor = 1 + excess if excess <= 1 else 2 * excess**0.5
        uneven = MountingError(
            label=f"flank lines {LEAD_ERROR * 1e6:g} µm apart over the face",
            contacts=tuple(replace(contact, load=contact.load * factor) for contact in contacts),
            note=f"load at one end {factor:.2f} times the mean (K_Hbeta)",
        )
        return Misalignment(METHOD, (uneven,))

    def duty(self) -> GearPairDuty:
        """The gears as input of ratings by standards."""
        surfaces, (pinion, gear) = self.surfaces, self.bodies
        cold, rough = self.oil.heat is None, None
        if pinion.roughness is not None and gear.roughness is not None:
            rough = pinion.roughness, gear.roughness
        return GearPairDuty(
            centre_distance=self.teeth.centre_distance,
            power=self.power,
            pitch_line_velocity=self.pitch_line_velocity,
            loss_factor=self.loss_factor,
            reduced_modulus=self.reduced_modulus,
            oil=self.oil,
            line_of_action=self.rating(self.contacts(self.cycle_phases())),
            bulk_temperature=None if cold else mean_bulk_temperature(self.bodies),
            effusivities=None if cold else (contact_coefficient(pinion), contact_coefficient(gear)),
            roughness=rough,
            friction=None if surfaces is None else surfaces.friction_coefficient,
            scuffing_temperature=None if surfaces is None else surfaces.scuffing_temperature,
        )

    def at_load(self, speed: float, torque: float) -> "GearPairDrive":
        """The gears at another speed of the pinion [rad/s] and torque of the gear [N m]."""
        return replace(self, pinion_speed=speed, power=torque * speed / self.teeth.ratio)

    def geometry_table(self) -> dict[str, float | str]:
        """The gears with their measures, backlash and mesh."""
        return described_pair(self, self.inspection)

    def mesh_forces(self, friction: float | None = None, driver: str | None = None) -> MeshForces:
        """Mean forces on both shafts, which friction does not change; ValueError of another shaft."""
        return self.shaft_forces(
            self.driver if driver is None else one_of("driver", driver, get_args(Driver))
        )

    @property
    def supports(self) -> dict[str, Supports]:
        """Bearings of both shafts, where they are given."""
        both = {"pinion": self.pinion_shaft, "gear": self.gear_shaft}
        return {name: supports for name, supports in both.items() if supports is not None}

    @property
    def shaft_speeds(self) -> dict[str, float]:
        """Speeds of both shafts [rad/s]."""
        return {"pinion": self.pinion_speed, "gear": self.gear_speed}

    @property
    def rotors(self) -> tuple[Rotor, Rotor]:
        """Pinion and gear as cylinders of their pitch circles."""
        pinion, gear = (
            Rotor(
                name=name,
                diameter=2 * cylinder.pitch,
                width=self.teeth.face_width,
                speed=speed,
                torque=self.power / speed,
                body=body,
                bearing_span=self.supports[name].bearing_span if name in self.supports else None,
            )
            for (name, speed), cylinder, body in zip(
                self.shaft_speeds.items(), self.teeth.cylinders, self.bodies, strict=True
            )
        )
        return pinion, gear

    def cycle_data(self) -> "xr.Dataset":
        """The line of action with its closed forms, for the result."""
        return line_of_action_data(self)
