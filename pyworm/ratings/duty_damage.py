"""What an hour at one load and temperature takes of the life of a gear unit, by the ratings of its case.

Worm wheels: wear, pitting and roots by the worm standard. Gears: wear by Archard's law over the pressure of
asperities. Bearings: ISO 281, with the viscosity at their temperature. Damages add up linearly (Miner).
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from math import pi

import numpy as np

from pyworm.case.case import Case
from pyworm.case.ratings import BearingTable
from pyworm.case.worm_conditions import conditions, material_of, standard_oil
from pyworm.drives.drive import Drive
from pyworm.drives.duty import WormDuty
from pyworm.formulas.unknown import Unknown, attempt, known
from pyworm.formulas.wear_law import (
    STEEL_WEAR_COEFFICIENT,
    WEAR_COEFFICIENT,
    WHEEL_HARDNESS,
    WORM_HARDNESS,
    harder_ratio,
    pass_depth,
)
from pyworm.formulas.worm_rating import WormRating
from pyworm.io.present import present
from pyworm.materials.body import Body
from pyworm.ratings.bearing import ShaftLoad, bearing_life, carried_load
from pyworm.ratings.element_bearing import element_load
from pyworm.ratings.mesh_estimate import MeshEstimate
from pyworm.ratings.rated_case import Cooled, WormRated
from pyworm.ratings.worm_safeties import pitting_damage, root_damage

HOUR = 3600.0
"""[s]."""

STIFF = 150e9
"""Young's modulus above which a body of unknown hardness is taken for hard steel, else for bronze [Pa]."""

SOFT = 3e9
"""Indentation hardness of the softer body up to which it wears as bronze does [Pa]."""

NO_ROOT = "pitting, roots: no formulas of them are known here for this kind of gears"


@dataclass(frozen=True)
class HourlyDamage:
    """What an hour takes."""

    wear: Mapping[str, float]
    """Gear body -> largest depth worn off [m/h]."""
    lives: Mapping[str, float]
    """What is damaged -> share of its life [1/h]."""
    not_rated: tuple[str, ...] = ()
    """What is not rated, each with the reason."""


@dataclass(frozen=True)
class DutyDamage:
    """The ratings of a case at any load and temperature."""

    case: Case
    """The case."""

    def hourly(
        self, drive: Drive, mesh: MeshEstimate, temperatures: Mapping[str, float]
    ) -> HourlyDamage:
        """What an hour takes of the drive at a load, with its mesh and the temperatures of its nodes [K]."""
        wear: dict[str, float] = {}
        lives: dict[str, float] = {}
        missing: list[str] = []
        if isinstance(self.case.tables, WormRated):
            self._worm(drive, temperatures, wear, lives, missing)
        else:
            missing.append(NO_ROOT)
            wear |= {name: depth for name, (depth, _) in tooth_wear(drive, mesh).items()}
        for name, table in self.case.tables.bearings.items():
            rated = attempt(lambda: self._bearing(drive, mesh, name, table, temperatures))  # noqa: B023
            if isinstance(rated, Unknown):
                missing.append(f"bearing {name}: {rated.why}")
            else:
                lives[f"bearing {name}"] = 1 / rated
        return HourlyDamage(wear, lives, tuple(missing))

    @cached_property
    def _duty(self) -> WormDuty:
        """The worm gear at the case's own operating point."""
        duty = self.case.tables.rated_duty(self.case.drive)
        return replace(
            present(duty if isinstance(duty, WormDuty) else None, "worm gear"), conductance=None
        )

    def _worm(
        self,
        drive: Drive,
        temperatures: Mapping[str, float],
        wear: dict[str, float],
        lives: dict[str, float],
        missing: list[str],
    ) -> None:
        """Wear, pitting and roots of the wheel in an hour."""
        worm, wheel = present(drive.rotors, "rotors")
        table = self.case.tables.rating_as_run()
        duty = replace(
            self._duty,
            worm_speed=worm.speed,
            torque=wheel.torque,
            oil_temperature=temperatures["oil"],
            wheel_temperature=temperatures[wheel.name],
        )
        oil = standard_oil(table, self.case.directory)
        under = conditions(table, duty, oil, wheel.torque, worm.speed, 1.0)
        rated = WormRating(duty.gear, under)
        depth = attempt(lambda: rated.wear.depth)
        if isinstance(depth, Unknown):
            missing.append(f"wear: {depth.why}")
        else:
            wear[wheel.name] = depth
            lives["wear"] = depth / duty.gear.wear_limit
        over_25000 = WormRating(duty.gear, replace(under, life=25000.0))
        pitting = attempt(lambda: pitting_damage(1.0, over_25000.pitting_safety))
        cycles = wheel.speed / (2 * pi) * HOUR
        strength = attempt(lambda: known(known(material_of(table)).root_strength))
        root = attempt(lambda: root_damage(cycles, known(strength) / rated.root_shear))
        for name, found in (("pitting", pitting), ("root", root)):
            if isinstance(found, Unknown):
                missing.append(f"{name}: {found.why}")
            else:
                lives[name] = found

    def _bearing(
        self,
        drive: Drive,
        mesh: MeshEstimate,
        name: str,
        table: BearingTable,
        temperatures: Mapping[str, float],
    ) -> float:
        """Life of a bearing [h], the modified one where it is known; ValueError of one that is not rated."""
        shaft, speed = None, table.speed
        if table.shaft is not None and table.side is not None:
            friction = mesh.loss.friction
            force = present(drive.mesh_forces(friction), "forces").on(table.shaft)
            if table.shaft not in drive.supports:
                raise ValueError(f"the distance of the {table.shaft} shaft's bearings is not given")
            speed = drive.shaft_speeds[table.shaft]
            bearing = force.bearings(drive.supports[table.shaft])[table.side]
            shaft = ShaftLoad(bearing, speed, "closed form")
            table = self._warm(table, drive, temperatures.get(f"{table.shaft} bearings"))
        elif (element := drive.element_bearing()) is not None and table.shaft == element.name:
            shaft = element_load(element)
        rated = bearing_life(table, self.case.directory, carried_load(table, shaft))
        modified = attempt(lambda: known(rated.modified_hours))
        return rated.basic_hours if isinstance(modified, Unknown) else modified

    def _warm(self, table: BearingTable, drive: Drive, temperature: float | None) -> BearingTable:
        """A bearing in the oil of the sump, at its temperature [K]."""
        tables = self.case.tables
        if temperature is None or table.lubrication == "grease" or not isinstance(tables, Cooled):
            return table
        fluid = tables.unit_of(drive).fluid(temperature)
        given = {"viscosity": fluid.viscosity, "oil": None, "temperature": None}
        return table.model_copy(update=given)


def tooth_wear(drive: Drive, mesh: MeshEstimate) -> dict[str, tuple[float, float]]:
    """Depth worn off each gear body in an hour [m/h]: the largest, and the mean over where it wears.

    Archard's law over the load of asperities, at each contact as a line that passes once in a turn.
    """
    rotors, worn = present(drive.rotors, "rotors"), {}
    for number, (rotor, coefficient) in enumerate(
        zip(rotors, wear_coefficients(drive.bodies), strict=True)
    ):
        depths = np.array(
            [
                pass_depth(
                    coefficient,
                    contact.asperity_load_fraction * contact.unit_load,
                    contact.sliding,
                    contact.velocities[number],
                )
                for contact in mesh.contacts
            ]
        )
        hourly = rotor.speed / (2 * pi) * HOUR * depths
        total = float(hourly.sum())
        mean = float((hourly**2).sum()) / total if total else 0.0
        worn[rotor.name] = float(hourly.max()), mean
    return worn


def wear_coefficients(bodies: tuple[Body, Body]) -> tuple[float, float]:
    """k of both bodies [m2/N]: that of bronze or of hard steel of the softer one, less of the harder one."""
    usual = [
        body.hardness or (WHEEL_HARDNESS if body.youngs_modulus < STIFF else WORM_HARDNESS)
        for body in bodies
    ]
    softer = min(usual)
    base = STEEL_WEAR_COEFFICIENT if softer > SOFT else WEAR_COEFFICIENT
    first, second = (base * harder_ratio(hard, softer) for hard in usual)
    return first, second
