"""Friction, loss and efficiency of rough teeth by a standard or a closed form, beside simulated ones.

Flanks are simulated as if they were smooth. Where their roughness carries load, the standards' friction,
which was measured on rough teeth, is what an engineer reckons with.
"""

from dataclasses import dataclass
from typing import Any

from pyworm.case.case import Case, case_again
from pyworm.case.ratings import WormRatingTable
from pyworm.drives.duty import GearPairDuty, WormDuty
from pyworm.formulas.worm_curves import Lubrication
from pyworm.formulas.worm_standard import SOURCE, teeth_loss
from pyworm.formulas.worm_wheel_material import Family
from pyworm.io.input_error import CaseError
from pyworm.materials.oil_file import oil_called
from pyworm.ratings.worm_loads import MEAN_TO_RMS, wheel_material
from pyworm.result.result import Result


@dataclass(frozen=True)
class StandardLoss:
    """Friction, loss and efficiency of all teeth in mesh.

    Attributes
    ----------
    friction, efficiency : float
        Mean coefficient, and power out over power in as the drive runs [-].
    power : float
        Lost between the teeth [W].
    source : str
        By what.
    """

    friction: float
    efficiency: float
    power: float
    source: str

    @property
    def words(self) -> str:
        """Friction, loss and efficiency as a sentence."""
        return (
            f"Rough teeth by the {self.source}: efficiency {self.efficiency * 100:.3g} %, "
            f"loss {self.power:.4g} W, friction {self.friction:.3g}."
        )

    def summary(self) -> dict[str, Any]:
        """Friction, loss and efficiency as an object for JSON."""
        return {
            "friction": self.friction,
            "efficiency": self.efficiency,
            "power_loss_W": self.power,
            "source": self.source,
        }


@dataclass(frozen=True)
class NoStandard:
    """Reason why a case has no loss by a standard.

    Attributes
    ----------
    reason : str
        A clause.
    """

    reason: str

    @property
    def words(self) -> str:
        """The reason in a sentence."""
        return f"No friction, loss and efficiency by a standard: {self.reason}."

    def summary(self) -> dict[str, str]:
        """The reason as an object for JSON."""
        return {"reason": self.reason}


def standard_loss(case: Case) -> StandardLoss | NoStandard:
    """The loss between a drive's teeth by a standard or a closed form, or why there is none."""
    try:
        duty = None if case.drive is None else case.drive.duty()
        if isinstance(duty, WormDuty):
            return _worm(case, duty)
        if isinstance(duty, GearPairDuty):
            return _gear_pair(duty)
    except ValueError as error:  # CaseError, and what lies outside the methods
        return NoStandard(str(error))
    what = "a contact without a drive" if case.drive is None else "a drive of this kind"
    return NoStandard(f"none is known for {what}")


def standard_of_result(result: Result) -> StandardLoss | NoStandard:
    """The loss by a standard for the case stored in a result."""
    try:
        return standard_loss(case_again(result.case))
    except CaseError as error:
        return NoStandard(str(error))


def _worm(case: Case, duty: WormDuty) -> StandardLoss | NoStandard:
    """By DIN 3996 and ISO/TS 14521; the oil is that of `[worm_rating]`, else the case's own by its name."""
    table = getattr(case.tables, "worm_rating", None)
    name = case.tables.oil.name if table is None else table.oil
    lost = teeth_loss(
        duty.gear,
        oil_called(name, case.directory).stock.name,
        duty.worm_speed,
        duty.torque,
        MEAN_TO_RMS * duty.roughness[0],
        *_rubbing(table),
    )
    if duty.driver == "worm":
        return StandardLoss(lost.friction, lost.forward_efficiency, lost.power, SOURCE)
    if lost.backward_efficiency <= 0:
        return NoStandard(f"at its friction of {lost.friction:.3g} the wheel cannot drive the worm")
    power = duty.torque * duty.worm_speed / duty.gear.ratio * (1 - lost.backward_efficiency)
    return StandardLoss(lost.friction, lost.backward_efficiency, power, SOURCE)


def _rubbing(table: WormRatingTable | None) -> tuple[float, Lubrication, Family]:
    """Y_W, lubrication and group of the wheel's material, as `teeth_loss` takes them."""
    if table is None:
        return 1.0, "bath", "tin bronze"
    material, factor = wheel_material(table), table.material_factor
    if material is None:
        return (1.0 if factor is None else factor), table.lubrication, "tin bronze"
    return (
        material.friction_factor if factor is None else factor,
        table.lubrication,
        material.family,
    )


def _gear_pair(duty: GearPairDuty) -> StandardLoss | NoStandard:
    """By the loss factor and the coefficient of friction that the case gives."""
    if duty.friction is None:
        return NoStandard("[surfaces] with a coefficient of friction is missing")
    fraction = duty.loss_factor * duty.friction
    source = f"loss factor {duty.loss_factor:.3g} and the friction of [surfaces]"
    return StandardLoss(duty.friction, 1 - fraction, duty.power * fraction, source)
