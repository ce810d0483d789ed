"""An effect: its indicator, its influence, and the scene without it."""

from collections.abc import Callable
from dataclasses import dataclass
from math import inf
from typing import get_args

from pyworm.io.plain_values import RequestedQuantity
from pyworm.planning.prediction import Prediction
from pyworm.scene.any_contact import AnyContact

FILM, FRICTION, TEMPERATURE = QUANTITIES = get_args(RequestedQuantity)
"""Quantities of a contact: minimum and central film, friction and power loss, largest temperatures."""


@dataclass(frozen=True)
class Influence:
    """Relative change of film, friction and temperature by leaving an effect out."""

    film: float = 0.0
    """Relative change of the films [-]."""
    friction: float = 0.0
    """Relative change of the friction [-]."""
    temperature: float = 0.0
    """Change of the largest temperatures, over their rise or, where that is smaller, over the temperature
    difference by which the inlet's viscosity falls e-fold [-]."""

    def on(self, quantities: tuple[str, ...]) -> float:
        """The largest influence on some quantities."""
        return max((getattr(self, quantity) for quantity in quantities), default=0.0)


EVERYTHING = Influence(inf, inf, inf)
"""Influence of an effect that a contact needs to exist."""


@dataclass(frozen=True)
class Effect:
    """One entry of the catalogue."""

    name: str
    """Name in `--effects` and tables."""
    symbol: str
    """The indicator as a formula."""
    source: str
    """Source of the indicator, or of the law of influence."""
    indicator: Callable[[Prediction], float]
    """Prediction -> the number by which the effect is judged [-]."""
    influence: Callable[[Prediction], Influence]
    """Prediction -> the influence of leaving it out."""
    without: Callable[[AnyContact], AnyContact] | None
    """Scene -> the scene without the effect, unchanged where the solver omits it; None if not simulated."""
    lacking: Callable[[AnyContact], str | None] = lambda scene: None
    """Scene -> reason why the contact does not have it, or why that is unknown; None where it has."""
    together: tuple[str, ...] = ()
    """Effects without which it is not simulated."""
    eased_by: tuple[str, ...] = ()
    """Effects that are simulated with it: they cost nothing more then and ease its solution."""
    part_of: str | None = None
    """An effect earlier in the catalogue that includes this one."""
    passing: bool = False
    """Whether contacts of one drive may have it at some phases of the mesh only."""
