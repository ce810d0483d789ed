"""Friction of solved contacts, as input of the losses of drives."""

from collections.abc import Iterable

from pyworm.drives.mesh_loss import ContactLoss
from pyworm.io.present import present
from pyworm.solver.solution import Solution

MIN_LOAD_SHARE = 0.02
"""Load, over its largest since the contact before, from which an instant tells friction: as a pair of teeth
comes together its load vanishes, but not the loss of the oil that is pressed out. Of an undercut worm of six
threads loss over load and sliding was 4.5 at the first instant, and taken for the friction of the edges that
touch before."""


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
    """Phases and power lost over load at the instants of a transient solution that tell friction."""
    life = solution.held("life")
    if life is None or "life_phase" not in life:
        return ()
    load = life["life_load"].values
    loaded = load >= MIN_LOAD_SHARE * load.max()
    over_load = life["life_power_loss"].values[loaded] / load[loaded]
    return tuple(zip(life["life_phase"].values[loaded].tolist(), over_load.tolist(), strict=True))
