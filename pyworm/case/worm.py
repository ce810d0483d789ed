"""A case about a worm drive."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from math import inf, pi
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from pydantic import Field

from pyworm.case.bodies import Bodies, BodyTable
from pyworm.case.drive_case import LOADS
from pyworm.case.fitted_friction import with_fitted_friction
from pyworm.case.one_wheel import other_cooling, other_material, other_temperature
from pyworm.case.ratings import CompletedRating, RatedCase, WormRatingTable
from pyworm.case.shafts import supports_of
from pyworm.case.table import Table, plain
from pyworm.case.worm_conditions import conditions, standard_oil
from pyworm.case.worm_cooling import WormCoolingTable
from pyworm.case.worm_table import DeviationTable, WormDriveTable
from pyworm.drives.drive import Drive
from pyworm.drives.duty import WormDuty
from pyworm.drives.gear_unit import GearUnit
from pyworm.drives.other_losses import NonMeshLosses
from pyworm.drives.torque_sharing import Sharing
from pyworm.drives.worm.drawing.design import Assembly
from pyworm.drives.worm.drawing.deviations import FlankDeviations
from pyworm.drives.worm.drive import WormDrive
from pyworm.drives.worm.duty import geometry_of, operating_point
from pyworm.drives.worm.inspection import AS_DRAWN, Inspection
from pyworm.drives.worm.loads.load_sharing import Shaft, Transmission
from pyworm.drives.worm.loads.temperatures import (
    WormCooling,
    WormSurroundings,
    drive_temperatures,
    worm_unit,
)
from pyworm.drives.worm.loads.worm_shaft import WormShaft
from pyworm.formulas.unknown import Unknown, attempt, known
from pyworm.formulas.worm_curves import Lubrication
from pyworm.formulas.worm_losses import other_losses
from pyworm.formulas.worm_rating import NOT_GIVEN, WormRating
from pyworm.io import units
from pyworm.io.plain_values import Phase
from pyworm.io.present import present
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil

HOB_LIFE = (1.0, 0.75, 0.5, 0.25)
"""Parts of its oversize that a hob has left as it is reground."""

AS_IF_BRONZE = (
    "; with the friction of tin bronze, an estimate, since that of the wheel is not known"
)

Friction = Annotated[float, Field(strict=True, ge=0, lt=0.3)]


class WormBodies(Bodies):
    """`[bodies]` of a worm drive."""

    worm: BodyTable
    wheel: BodyTable


class OperationTable(Table):
    """`[operation]`: how the drive runs, and which phases of its mesh cycle are to be solved.

    The load is the normal load of the tooth, or what the teeth in mesh share: a torque of either shaft, or
    the power of the driving one. `friction` is that of the teeth in the balance of torques, `lifts` how far
    films lift the teeth off each other, at phases; left out, they are found.
    """

    worm_speed: units.Speed | None = None
    wheel_speed: units.Speed | None = None
    driver: Shaft = "worm"
    load: units.Force | None = None
    worm_torque: units.Torque | None = None
    wheel_torque: units.Torque | None = None
    power: units.Power | None = None
    sharing: Sharing | None = None
    friction: Friction | None = None
    lifts: Annotated[tuple[tuple[Phase, units.Film], ...], Field(min_length=1)] | None = None
    phases: Annotated[tuple[Phase, ...], Field(min_length=1)]

    def flaws(self) -> Iterator[str]:
        """Not one speed and one load, what has no effect with it, and lifts that are none."""
        yield from self.unless_either("worm_speed", "wheel_speed")
        yield from self.unless_one(*LOADS)
        if self.load is not None:
            for name in self.given("sharing", "friction", "lifts"):
                yield (
                    f"{name} has no effect with the load of one tooth, give a torque or a power instead "
                    "of load"
                )
        phases = [phase for phase, _ in self.lifts or ()]
        if self.sharing == "equal" and phases:
            yield "lifts has no effect with sharing = equal, by which no tooth yields"
        if any(after <= before for before, after in pairwise(phases)):
            listed = ", ".join(f"{phase:g}" for phase in phases)
            yield f"lifts has the phases {listed}; they must rise"


class WormCase(RatedCase):
    """A case file about a worm drive."""

    drive: WormDriveTable
    operation: OperationTable
    bodies: WormBodies
    worm_rating: WormRatingTable | None = None
    cooling: WormCoolingTable | None = None

    def flaws(self) -> Iterator[str]:
        """Cooling of what does not warm, a rating of another drive, stiffness of one tooth."""
        yield from super().flaws()
        if self.cooling is not None:
            if self.oil.heat is None or self.operation.load is not None:
                yield (
                    "[cooling] asks for [oil.heat] and for a torque or a power in [operation], instead of "
                    "load"
                )
            for name, body in self.bodies:
                if body.bulk_temperature is not None:
                    yield f"bodies.{name}.bulk_temperature has no effect with [cooling]"
        if self.worm_rating is not None:
            yield from self._flaws_of_rating(self.worm_rating)
        if self.drive.stiffness is not None and self.operation.load is not None:
            yield (
                "drive.stiffness has no effect with operation.load, the load of one tooth; give a torque "
                "or a power instead"
            )

    def _flaws_of_rating(self, rating: WormRatingTable) -> Iterator[str]:
        """What a rating says otherwise than the rest of the file."""
        lubricated = self._rated_lubrication
        if self.lubrication is not None and rating.lubrication not in (lubricated, None):
            yield (
                f'worm_rating.lubrication = "{rating.lubrication}" contradicts '
                f'lubrication.method = "{self.lubrication.method}"; give "{lubricated}"'
            )
        yield from other_material(rating, self.bodies.wheel)
        yield from other_temperature(rating, self.oil, cooled=self.cooling is not None)
        if self.cooling is not None:
            yield from other_cooling(rating, self.cooling)

    @property
    def _rated_lubrication(self) -> Lubrication | None:
        """How the standard calls the way of the oil to the teeth; None where it is not given."""
        if self.lubrication is None:
            return None
        return "bath" if self.lubrication.method == "bath" else "injection"

    @property
    def left_open(self) -> dict[str, tuple[str, ...]]:
        """The friction in the balance of torques, the lifts of films, and the loss that warms the drive."""
        if self.operation.load is not None:
            return {}
        yields = self.operation.sharing != "equal"
        known = {"operation": ("friction",) + ("lifts",) * yields, "cooling": ("tooth_loss",)}
        left = {
            table: tuple(key for key in keys if getattr(getattr(self, table), key) is None)
            for table, keys in known.items()
            if getattr(self, table) is not None
        }
        return {table: keys for table, keys in left.items() if keys}

    def worn(
        self,
        face: np.ndarray,
        radius: np.ndarray,
        depth: np.ndarray,
        roughness: tuple[float, float],
    ) -> dict[str, dict[str, Any]]:
        """What a case with a worn wheel has in place of this one's (`Case.with_found`).

        `depth` [m] was worn off the driven flanks, (radius, face), beyond the deviations that they have, at
        places along the face and radii [m]; `roughness` is that of worm and wheel then, Rq [m].
        """
        wheel, given = self.drive.wheel, self.drive.wheel.deviations
        design = self.drive.design()
        half, tip = design.wheel.face_width / 2, design.wheel.throat_radius
        face, depth = _reaching(face, depth.T, -half, half)
        radius, below = _reaching(radius, depth.T, tip - design.worm.axial_pitch / pi, tip)
        below = below.T
        if given is not None:
            below = below + plain(given, FlankDeviations).removed(
                *np.meshgrid(face, radius, indexing="ij")
            )
        table = DeviationTable.model_validate(
            {
                "file": "worn",
                "along": face.tolist(),
                "radius": radius.tolist(),
                "deviation": (-below).tolist(),
                "worn": True,
            }
        )
        worm, wheel_body = (
            body.model_copy(
                update={
                    "roughness": now,
                    "roughness_ra": None,
                    "roughness_rz": None,
                    "finish": None,
                }
            )
            for body, now in zip((self.bodies.worm, self.bodies.wheel), roughness, strict=True)
        )
        return {
            "drive": {"wheel": wheel.model_copy(update={"deviations": table})},
            "bodies": {"worm": worm, "wheel": wheel_body},
        }

    def rating_as_run(self) -> CompletedRating:
        """`[worm_rating]` completed by what the other tables state, also where the file has none."""
        cooling, table = self.cooling, self.worm_rating or WormRatingTable()
        cooled = {} if cooling is None else dict(cooling)
        return table.completed(
            oil=None if self.oil.base is None else self.oil.name,
            wheel_material=self.bodies.wheel.material,
            lubrication=self._rated_lubrication,
            ambient_temperature=cooled.get("ambient_temperature"),
            immersion_factor=cooled.get("immersion"),
            bearings=cooled.get("bearings"),
        )

    def rated_duty(self, drive: Drive) -> WormDuty:
        """The worm gear with the temperatures and the cooling of the drive."""
        if not isinstance(drive, WormDrive):
            raise TypeError("a worm drive is rated as a worm gear")
        cooling = self.cooling
        duty = replace(drive.duty(), wheel_material=self.bodies.wheel.material)
        if cooling is not None:
            conductance = self.unit_of(drive).conductance
            duty = replace(duty, conductance=conductance, other_loss=cooling.other_loss)
        balanced = duty.simulated_wheel_temperature != duty.oil_temperature
        if cooling is None and not balanced and self.bodies.wheel.bulk_temperature is None:
            return duty
        return replace(duty, wheel_temperature=duty.simulated_wheel_temperature)

    def cooling_of(self, drive: WormDrive) -> WormCooling:
        """Cooling of the drive; losses besides the teeth are the worm standard's unless they are given."""
        table = present(self.cooling, "cooling")
        if table.other_loss is not None:
            other = NonMeshLosses(given=table.other_loss)
        else:
            load = drive.shared_torque
            torque = load.torque if load.shaft == "wheel" else load.torque / drive.ratio
            losses = other_losses(geometry_of(drive), drive.speed, torque, table.bearings)
            other = NonMeshLosses(losses, table.bearings)
        return WormCooling(other=other, **vars(plain(table, WormSurroundings)))

    def unit_of(self, drive: WormDrive, tooth_loss: float | None = None) -> GearUnit:
        """The thermal network of the drive for a loss between its teeth [W], by default that assumed."""
        loss = self._assumed_loss(drive) if tooth_loss is None else tooth_loss
        return worm_unit(self.cooling_of(drive), drive.rotors, drive.oil, _rim(drive), loss)

    def _assumed_loss(self, drive: WormDrive) -> float:
        """Loss between the teeth in the thermal balance [W]; of a housing of given sizes the standard's."""
        table = present(self.cooling, "cooling")
        if table.tooth_loss is not None:
            return table.tooth_loss
        if table.housing is not None:
            by_standard = attempt(
                lambda: self._by_standard(drive).nearest_loss.driven_by(drive.driver)
            )
            if not isinstance(by_standard, Unknown):
                return by_standard
        return _first_loss(drive.shared_torque, drive.speed, drive.ratio)

    @property
    def hob_life(self) -> tuple[float, ...]:
        """Parts of the hob's oversize left as it is reground; none of a hob given by its base cylinder."""
        return () if self.drive.module is None else HOB_LIFE

    def reground_drive(self, drive: WormDrive, part: float) -> tuple[float, WormDrive]:
        """Oversize [m] of a hob of which a part is left, and the drive; ValueError without mesh."""
        oversize, design = self.drive.reground(part)
        return oversize, replace(drive, worm=design.worm, wheel=design.wheel, hob=design.hob)

    def make_drive(self) -> WormDrive:
        """The drive of a case file about a worm."""
        oil = with_fitted_friction(self.oil.oil(), self.oil, self.bodies.worm, self.bodies.wheel)
        operation = self.operation
        design = self.drive.design()
        ratio = design.worm.threads / design.wheel.teeth
        speed = operation.worm_speed or present(operation.wheel_speed, "wheel_speed") / ratio
        drive = WormDrive(
            worm=design.worm,
            wheel=design.wheel,
            hob=design.hob,
            centre_distance=design.centre_distance,
            speed=speed,
            tooth_load=operation.load,
            transmission=None if operation.load else _transmission(self, speed, ratio),
            bodies=design.seen(self._pair(oil)),
            oil=oil,
            assembly=plain(self.drive.assembly, Assembly),
            driver=operation.driver,
            hand=design.hand,
            assumed=design.assumed,
            shaft=None if self.drive.shaft is None else plain(self.drive.shaft, WormShaft),
            wheel_shaft=supports_of(self.drive.wheel_shaft),
            inspection=_inspection(self.drive),
            lubrication=self.brought_by,
        )
        return self._balanced(drive) if self.cooling is None else self._warm(drive)

    def _pair(self, oil: Oil) -> tuple[Body, Body]:
        """Worm and wheel, the wheel with the temperature limit of the material it is rated as, if of none."""
        worm, wheel = self.bodies.pair(oil)
        rated = None if self.worm_rating is None else self.worm_rating.wheel_material
        if rated is None or wheel.temperature_limit is not None:
            return worm, wheel
        return worm, replace(wheel, temperature_limit=Body.from_name(rated).temperature_limit)

    def _balanced(self, drive: WormDrive) -> WormDrive:
        """The drive with bulk temperatures by the standard's balance of its loss, where none is given.

        Oil and material are those of the drive itself, so that a rating changes no contact. Where the
        standard has no loss, or teeth carry a load that is given, bodies stay as warm as the oil.
        """
        stated = [body.bulk_temperature for _, body in self.bodies]
        if drive.oil.heat is None or stated != [None, None]:
            return drive
        rated = attempt(lambda: self._by_standard(drive))
        found = attempt(lambda: known(rated).bulk_temperature)
        if isinstance(found, Unknown):
            return replace(drive, warmth=f"Worm and wheel have the oil temperature: {found.why}.")
        excess = found - drive.oil.heat.inlet_temperature
        stand_in = "" if known(rated).under.friction_is_known else AS_IF_BRONZE
        return replace(
            drive,
            bodies=(_as_warm(drive.bodies[0], found), _as_warm(drive.bodies[1], found)),
            warmth=(
                f"Worm and wheel are {excess:.3g} K warmer than the oil, by the heat balance of the "
                f"worm-gear standard with its loss between the teeth (from a public transcription{stand_in})."
            ),
        )

    def _by_standard(self, drive: WormDrive) -> WormRating:
        """The drive by the standard, whatever it is rated for; ValueError of the load of one tooth."""
        load = drive.transmission
        if load is None:
            raise ValueError("the load of one tooth is given, which is no balance of a gear set")
        torque = load.torque if load.shaft == "wheel" else load.torque / drive.ratio
        point = operating_point(drive, torque)
        bare = self.model_copy(update={"worm_rating": None}).rating_as_run()
        oil = standard_oil(bare, Path())
        under = conditions(bare, point, oil, torque, drive.speed, NOT_GIVEN)
        return WormRating(point.gear, under)

    def _warm(self, drive: WormDrive) -> WormDrive:
        """The drive with oil and bodies as warm as its losses make them."""
        cooling, loss = self.cooling_of(drive), self._assumed_loss(drive)
        if cooling.conductance is None:
            warm = self.unit_of(drive).temperatures
        else:
            by_hand = cooling.conductance, _rim(drive), drive.speed, loss
            warm = drive_temperatures(cooling, *by_hand)
        return replace(drive, oil=warm.oil(drive.oil), bodies=warm.warm(drive.bodies))


def _rim(drive: WormDrive) -> float:
    """Area of the wheel's rim in the standard's heat balance, its width times its diameter [m2]."""
    return drive.wheel.face_width * 2 * drive.wheel_reference_radius


def _inspection(table: WormDriveTable) -> Inspection:
    return AS_DRAWN if table.inspection is None else plain(table.inspection, Inspection)


def _as_warm(body: Body, temperature: float) -> Body:
    return replace(body, bulk_temperature=temperature)


def _reaching(
    places: np.ndarray, values: np.ndarray, low: float, high: float
) -> tuple[np.ndarray, np.ndarray]:
    """Values over places, along the first axis, with zeros to both ends where they do not reach there."""
    nothing = np.zeros_like(values[:1])
    if places[0] > low:
        places, values = np.append(low, places), np.concatenate([nothing, values])
    if places[-1] < high:
        places, values = np.append(places, high), np.concatenate([values, nothing])
    return places, values


def _transmission(tables: WormCase, worm_speed: float, ratio: float) -> Transmission:
    """What the teeth of a worm drive share; with a power, the torque of the shaft that drives."""
    operation = tables.operation
    if operation.power is not None:
        shaft = operation.driver
        torque = operation.power / (worm_speed if shaft == "worm" else worm_speed * ratio)
    elif operation.worm_torque is not None:
        shaft, torque = "worm", operation.worm_torque
    else:
        shaft, torque = "wheel", present(operation.wheel_torque, "operation.wheel_torque")
    return Transmission(
        torque=torque,
        shaft=shaft,
        sharing=operation.sharing or "elastic",
        friction=FIRST_FRICTION if operation.friction is None else operation.friction,
        stiffness=tables.drive.stiffness or inf,
        lifts=operation.lifts or (),
    )


def _first_loss(transmission: Transmission, worm_speed: float, ratio: float) -> float:
    """Loss between the teeth before it is known [W]."""
    speed = worm_speed if transmission.shaft == "worm" else worm_speed * ratio
    return FIRST_LOSS * transmission.torque * speed


FIRST_LOSS = 0.03
"""Fraction of the power that is lost between worm teeth before it is known."""

FIRST_FRICTION = 0.01
"""Friction of worm teeth in the balance of torques before it is known."""


CASE = WormCase
"""Tables and keys of a case file of this kind of drive."""
