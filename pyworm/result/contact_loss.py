"""Friction of solved contacts, as input of the losses of drives."""

from collections.abc import Iterable

from pyworm.drives.mesh_loss import ContactLoss
from pyworm.io.present import present
from pyworm.solver.solution import Solution


def contact_losses(solutions: Iterable[Solution]) -> list[ContactLoss]:
    """Friction and loss of solutions with friction, in their order."""
    return [
        ContactLoss(
            phase=present(solution.phase, "phase"),
            load=solution.load,
            friction=present(solution.figures.friction_coefficient, "friction").value,
            power=present(solution.figures.power_loss, "power_loss").value,
            error=present(solution.figures.power_loss, "power_loss").error,
            model=present(solution.figures.power_loss, "power_loss").model,
            section=solution.section,
            station=solution.station,
            loss_history=_loss_over_phase(solution),
        )
        for solution in solutions
    ]


def _loss_over_phase(solution: Solution) -> tuple[tuple[float, float], ...]:
    """Phases and power lost over load at each instant of a transient solution."""
    life = solution.held("life")
    if life is None or "life_phase" not in life:
        return ()
    over_load = life["life_power_loss"].values / life["life_load"].values
    return tuple(zip(life["life_phase"].values.tolist(), over_load.tolist(), strict=True))
