"""Friction of solved contacts, as input of the losses of drives."""

from collections.abc import Iterable

from pyworm.drives.mesh_loss import ContactLoss
from pyworm.solver.solution import Solution


def contact_losses(solutions: Iterable[Solution]) -> list[ContactLoss]:
    """Friction and loss of solutions with friction, in their order."""
    return [
        ContactLoss(
            phase=of.phase,
            load=of.load,
            friction=of.figures.friction_coefficient.value,
            power=of.figures.power_loss.value,
            error=of.figures.power_loss.error,
            model=of.figures.power_loss.model,
            section=of.section,
            station=of.station,
        )
        for of in solutions
    ]
