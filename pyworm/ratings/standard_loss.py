"""Friction, loss and efficiency of rough teeth by a standard or a closed form, beside simulated ones.

Flanks are simulated as if they were smooth. Where their roughness carries load, the standards' friction,
which was measured on rough teeth, is what an engineer reckons with.
"""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from pyworm.case.case import Case, case_again
from pyworm.case.ratings import CompletedRating
from pyworm.case.worm_conditions import conditions, standard_oil
from pyworm.drives.duty import GearPairDuty, WormDuty
from pyworm.formulas.worm_rating import NOT_GIVEN, WormRating
from pyworm.formulas.worm_standard import SOURCE
from pyworm.io.input_error import CaseError
from pyworm.result.result import Result


@dataclass(frozen=True)
class StandardLoss:
    """Friction, loss and efficiency of all teeth in mesh."""

    friction: float
    """Mean coefficient of friction [-]."""
    efficiency: float
    """Power out over power in as the drive runs [-]."""
    power: float
    """Lost between the teeth [W]."""
    source: str
    """Source of the loss."""

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
    """Reason why a case has no loss by a standard."""

    reason: str
    """The reason, a clause."""

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
        duty = None if case.drive is None else case.tables.rated_duty(case.drive)
        if isinstance(duty, WormDuty):
            return _worm(case, duty)
        if isinstance(duty, GearPairDuty):
            return _gear_pair(duty)
    except ValueError as error:  # CaseError, and what lies outside the methods
        return NoStandard(str(error))
    what = "a contact without gears" if case.drive is None else "gears of this kind"
    return NoStandard(f"none is known for {what}")


def standard_of_result(result: Result) -> StandardLoss | NoStandard:
    """The loss by a standard for the case stored in a result."""
    try:
        return standard_loss(case_again(result.case))
    except CaseError as error:
        return NoStandard(str(error))


def rated_teeth(table: CompletedRating, directory: Path, duty: WormDuty) -> WormRating:
    """A worm gear at its operating point by the standards, for the oil and material of its rating."""
    oil = standard_oil(table, directory)
    under = conditions(table, duty, oil, duty.torque, duty.worm_speed, NOT_GIVEN)
    return WormRating(duty.gear, replace(under, torque=duty.torque))


def _worm(case: Case, duty: WormDuty) -> StandardLoss | NoStandard:
    """By DIN 3996 and ISO/TS 14521, for the oil and the material that a rating of the case takes."""
    rated = rated_teeth(case.tables.rating_as_run(), case.directory, duty)
    if duty.driver == "worm":
        return StandardLoss(rated.friction, rated.forward_efficiency, rated.tooth_loss, SOURCE)
    if rated.backward_efficiency <= 0:
        return NoStandard(
            f"at its friction of {rated.friction:.3g} the wheel cannot drive the worm"
        )
    return StandardLoss(rated.friction, rated.backward_efficiency, rated.tooth_loss, SOURCE)


def _gear_pair(duty: GearPairDuty) -> StandardLoss | NoStandard:
    """By the loss factor and the coefficient of friction that the case gives."""
    if duty.friction is None:
        return NoStandard("[surfaces] with a coefficient of friction is missing")
    fraction = duty.loss_factor * duty.friction
    source = f"loss factor {duty.loss_factor:.3g} and the friction of [surfaces]"
    return StandardLoss(duty.friction, 1 - fraction, duty.power * fraction, source)
