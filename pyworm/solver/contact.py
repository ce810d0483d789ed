"""What all kinds of contact share on their way up the grids: rungs, Newton steps, what the top shows."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Protocol

import xarray as xr

from pyworm.solver.error_estimate import Convergence
from pyworm.solver.level import Rung
from pyworm.solver.newton import Stride


@dataclass(frozen=True)
class Outcome:
    """What a kind of contact shows on its last rung.

    Attributes
    ----------
    figures : dict
        The `solution.Figures` that only this kind knows how to come by.
    fields : xarray.Dataset
        Fields over the grid.
    flaw : str or None
        Why they are not to be trusted, whatever the film says.
    profile : xarray.Dataset or None
        Temperature and velocity across the film at its hottest point, where heat is simulated.
    """

    figures: dict[str, Any]
    fields: xr.Dataset
    flaw: str | None = None
    profile: xr.Dataset | None = None


class Ladder(Protocol):
    """A kind of contact as `pyworm.solver.solve` sees it; made from its scene and plan.

    Attributes
    ----------
    kind : str
        What results call it.
    rungs : type
        What its rungs are.
    convergence : Convergence
        How its figures come near the truth.
    origins : dict
        What figures count from, where their readings count from something else.
    """

    kind: ClassVar[str]
    rungs: ClassVar[type]
    convergence: Convergence
    origins: dict[str, float]

    def enter(self, grids: Sequence[Any]) -> tuple[Rung, list[Stride]]:
        """Up the plan's grids to the last of them, not yet settled there."""

    def follow(self, earlier: Sequence[Rung], share: float) -> Rung:
        """The contact on the grid of its rungs at earlier times, the latest first, from where they lead.

        `share` is the time since the latest over that between it and the one before.
        """

    def resume(self, rung: Rung) -> tuple[Rung, list[Stride]]:
        """The grid of a rung, from its film, on which the contact was solved with fewer effects."""

    def higher(self, rung: Rung) -> tuple[Rung, list[Stride]]:
        """Half the spacing over the same window, entered from the present film if that is any good."""

    def outcome(self, rung: Rung) -> Outcome:
        """What the last rung shows."""
