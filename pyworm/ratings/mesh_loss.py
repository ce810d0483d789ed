"""What the simulated friction costs a drive: loss between its teeth and efficiency."""

from dataclasses import dataclass

import numpy as np

from pyworm.drives.drive import Drive
from pyworm.drives.gear_pair.drive import GearPairDrive
from pyworm.drives.zi_worm.drive import ZiWormDrive
from pyworm.drives.zi_worm.load_sharing import Transmission
from pyworm.result.mesh_cycle import FEWEST_PHASES
from pyworm.result.tooth_loss import cycle_loss
from pyworm.solver.solution import Solution


@dataclass(frozen=True)
class MeshLoss:
    """Power through the teeth and what friction takes of it.

    Attributes
    ----------
    power : float
        That the driver puts in [W].
    loss : float
        Between the teeth [W].
    friction : float
        Mean friction coefficient [-].
    error : float
        Largest relative error bar of the friction it was made of [-].
    words : str
        How it was made.
    """

    power: float
    loss: float
    friction: float
    error: float
    words: str

    @property
    def efficiency(self) -> float:
        """Of the teeth alone [-]."""
        return 1 - self.loss / self.power


def mesh_loss(drive: Drive | None, solutions: tuple[Solution, ...]) -> MeshLoss | None:
    """Loss between the teeth of a drive; None where friction was not simulated or power is not known."""
    if not solutions or any(of.figures.friction_coefficient is None for of in solutions):
        return None
    error = max(of.figures.power_loss.error for of in solutions)
    if isinstance(drive, ZiWormDrive) and isinstance(drive.load, Transmission):
        good = sorted((of for of in solutions if of.converged), key=lambda of: of.phase)
        if len(good) < FEWEST_PHASES:
            return None
        loss = cycle_loss(drive.cycle_data(), good)
        driven = loss.worm_torque * drive.speed
        return MeshLoss(
            power=driven if drive.driver == "worm" else driven + loss.power,
            loss=loss.power,
            friction=loss.friction,
            error=loss.error / loss.power,
            words="of all teeth in mesh, each under its share of the load, over the mesh cycle",
        )
    if isinstance(drive, ZiWormDrive):
        teeth = drive.mean_teeth_in_contact
        loss = float(np.mean([of.figures.power_loss.value for of in solutions])) * teeth
        ratio = drive.wheel.teeth / drive.worm.threads
        output = drive.load * drive.load_arm * teeth * drive.speed / ratio
        return MeshLoss(
            power=output + loss,
            loss=loss,
            friction=float(np.mean([of.figures.friction_coefficient.value for of in solutions])),
            error=error,
            words=f"means over the solved mesh phases; {teeth:.2f} teeth in contact on average, each "
            "under the load given",
        )
    if isinstance(drive, GearPairDrive):
        friction = _friction(drive, solutions)
        if friction is not None:
            return MeshLoss(
                power=drive.power,
                loss=drive.power * drive.loss_factor * friction,
                friction=friction,
                error=error,
                words=f"loss factor H_V = {drive.loss_factor:.4f}, friction interpolated between the solved "
                "phases",
            )
    return None


def _friction(drive: GearPairDrive, solutions: tuple[Solution, ...]) -> float | None:
    """Mean friction of solved contacts, weighted by load times sliding along the line of action [-].

    Friction between solved phases is interpolated, beyond the last ones constant. None where it was not
    simulated or fewer than two phases were solved.
    """
    known = sorted(
        (of.phase, of.figures.friction_coefficient.value)
        for of in solutions
        if of.figures.friction_coefficient is not None
    )
    if len(known) < 2:
        return None
    phases = drive.cycle_phases()
    contacts = drive.contacts(phases)
    weight = contacts.unit_load * np.abs(contacts.sliding)
    friction = np.interp(phases, *zip(*known, strict=True))
    return float(np.trapezoid(weight * friction, phases) / np.trapezoid(weight, phases))
