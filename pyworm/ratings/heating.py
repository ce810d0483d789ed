"""Loss between the teeth for the thermal balance: the simulated one or, if larger, that of rough teeth."""

from dataclasses import dataclass
from typing import Any

from pyworm.case.case import Case
from pyworm.drives.other_losses import NonMeshLosses
from pyworm.io.present import present
from pyworm.ratings.standard_loss import NoStandard, StandardLoss
from pyworm.result.mesh_cycle import DriveCycle


@dataclass(frozen=True)
class HeatingLoss:
    """The loss between the teeth for the thermal balance."""

    power: float
    """Loss [W]."""
    by: str
    """Source: "simulation" or "standard"."""
    words: str
    """Which it is and why."""


def heating_loss(cycle: DriveCycle, standard: StandardLoss | NoStandard) -> HeatingLoss:
    """The simulated loss; where roughness carries load, the larger of it and the standard's."""
    smooth = present(cycle.loss, "loss").power
    surfaces = " with smooth surfaces" if cycle.neglected_effects.as_if_smooth else ""
    simulated = f"{smooth:.4g} W simulated{surfaces}"
    if isinstance(standard, NoStandard):
        return HeatingLoss(
            smooth, "simulation", f"{simulated}, by a standard none: {standard.reason}"
        )
    rough = f"{standard.power:.4g} W of rough teeth by the {standard.source}"
    if cycle.neglected_effects.as_if_smooth and standard.power > smooth:
        return HeatingLoss(standard.power, "standard", f"{rough}, more than the {simulated}")
    return HeatingLoss(smooth, "simulation", f"{simulated}, taken and not the {rough}")


def tooth_loss_of(case: Case) -> float:
    """Loss between the teeth assumed in a case's thermal balance [W]."""
    drive = present(case.drive, "drive")
    cooling = case.tables.cooling_of(drive)
    sump = present(drive.oil.heat, "oil.heat").inlet_temperature
    return (sump - cooling.ambient_temperature) * cooling.conductance - cooling.other.power


@dataclass(frozen=True)
class Heating:
    """The loss assumed in the thermal balance of a solved drive, and the loss found."""

    taken: float
    """Loss between the teeth that the temperatures belong to [W]."""
    found: HeatingLoss
    """What the films solved with them lose."""
    other: NonMeshLosses
    """What bearings, seals and churning lose."""

    @property
    def words(self) -> str:
        """All losses in sentences."""
        return (
            f"Temperatures are struck for {self.taken:.4g} W between the teeth; found: {self.found.words}. "
            f"{self.other.words}"
        )

    def summary(self) -> dict[str, Any]:
        """All losses as an object for JSON."""
        return {
            "taken_W": self.taken,
            "found_W": self.found.power,
            "by": self.found.by,
            **self.other.summary(),
            "whole_W": self.found.power + self.other.power,
        }


def heating_of(
    case: Case, cycle: DriveCycle | None, standard: StandardLoss | NoStandard
) -> Heating | None:
    """The losses of a case and its solved cycle; None where temperatures are given, or without a loss."""
    if getattr(case.tables, "cooling", None) is None or cycle is None or cycle.loss is None:
        return None
    other = case.tables.cooling_of(case.drive).other
    return Heating(tooth_loss_of(case), heating_loss(cycle, standard), other)
