"""Loss between the teeth for the thermal balance: the simulated one or, if larger, that of rough teeth."""

from dataclasses import dataclass
from typing import Any

from pyworm.case.case import Case
from pyworm.drives.mesh_loss import MeshLoss
from pyworm.drives.other_losses import NonMeshLosses
from pyworm.io.present import present
from pyworm.ratings.mesh_loss import mesh_loss
from pyworm.ratings.standard_loss import NoStandard, StandardLoss
from pyworm.result.headline import of_all
from pyworm.result.mesh_cycle import DriveCycle
from pyworm.result.result import Result
from pyworm.solver.neglected_effects import NeglectedEffects


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
    return _larger(present(cycle.loss, "loss").power, cycle.neglected_effects, standard)


def mesh_heating_loss(
    loss: MeshLoss, result: Result, standard: StandardLoss | NoStandard
) -> HeatingLoss:
    """As `heating_loss`, of gears whose loss is no integral over a mesh cycle."""
    return _larger(loss.loss, of_all(result.solutions), standard)


def _larger(
    smooth: float, neglected: NeglectedEffects, standard: StandardLoss | NoStandard
) -> HeatingLoss:
    """The heating loss by a simulated one [W] and the effects that this neglects."""
    surfaces = " with smooth surfaces" if neglected.as_if_smooth else ""
    simulated = f"{smooth:.4g} W simulated{surfaces}"
    if isinstance(standard, NoStandard):
        return HeatingLoss(
            smooth, "simulation", f"{simulated}, by a standard none: {standard.reason}"
        )
    rough = f"{standard.power:.4g} W of rough teeth by the {standard.source}"
    if neglected.as_if_smooth and standard.power > smooth:
        return HeatingLoss(standard.power, "standard", f"{rough}, more than the {simulated}")
    return HeatingLoss(smooth, "simulation", f"{simulated}, taken and not the {rough}")


def tooth_loss_of(case: Case) -> float:
    """Loss between the teeth assumed in a case's thermal balance [W]."""
    drive = present(case.drive, "drive")
    unit = case.tables.unit_of(drive)
    cooling, sump = unit.cooling, present(drive.oil.heat, "oil.heat").inlet_temperature
    return (sump - cooling.ambient_temperature) * unit.conductance - cooling.other.power


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
    case: Case,
    cycle: DriveCycle | None,
    standard: StandardLoss | NoStandard,
    result: Result | None = None,
) -> Heating | None:
    """The losses of a case and its solved cycle, or of other gears' result.

    None where temperatures are given, or without a loss.
    """
    if getattr(case.tables, "cooling", None) is None:
        return None
    if cycle is not None and cycle.loss is not None:
        found = heating_loss(cycle, standard)
    else:
        loss = None if result is None else mesh_loss(case.drive, result)
        if loss is None or result is None:
            return None
        found = mesh_heating_loss(loss, result, standard)
    return Heating(tooth_loss_of(case), found, case.tables.unit_of(case.drive).cooling.other)
