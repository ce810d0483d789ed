"""An effect: its indicator, its influence, and the scene without it."""

from collections.abc import Callable
from dataclasses import dataclass
from math import inf

from pyworm.planning.prediction import Prediction
from pyworm.scene.any_contact import AnyContact

FILM, FRICTION, TEMPERATURE = "film", "friction", "temperature"

QUANTITIES = (FILM, FRICTION, TEMPERATURE)
"""Quantities of a contact: minimum and central film, friction and power loss, largest temperatures."""


@dataclass(frozen=True)
class Influence:
    """Relative change of film, friction and temperature by leaving an effect out.

    Attributes
    ----------
    film, friction : float
        Relative change of the films and of the friction [-].
    temperature : float
        Change of the largest temperatures, over their rise or, where that is smaller, over the temperature
        difference by which the inlet's viscosity falls e-fold [-].
    """

    film: float = 0.0
    friction: float = 0.0
    temperature: float = 0.0

    def on(self, quantities: tuple[str, ...]) -> float:
        """The largest influence on some quantities."""
        return max((getattr(self, quantity) for quantity in quantities), default=0.0)


EVERYTHING = Influence(inf, inf, inf)
"""Influence of an effect that a contact needs to exist."""


@dataclass(frozen=True)
class Effect:
    """One entry of the catalogue.

    Attributes
    ----------
    name : str
        Name in `--effects` and tables.
    symbol : str
        The indicator as a formula.
    source : str
        Source of the indicator, or of the law of influence.
    indicator : callable
        Prediction -> the number by which the effect is judged [-].
    influence : callable
        Prediction -> the influence of leaving it out.
    without : callable or None
        Scene -> the scene without the effect, unchanged where the solver omits it; None if not simulated.
    lacking : callable
        Scene -> reason why the contact does not have it, or why that is unknown; None where it has.
    together : tuple of str
        Effects without which it is not simulated.
    eased_by : tuple of str
        Effects that are simulated with it: they cost nothing more then and ease its solution.
    part_of : str or None
        An effect earlier in the catalogue that includes this one.
    passing : bool
        Whether contacts of one drive may have it at some phases of the mesh only.
    """

    name: str
    symbol: str
    source: str
    indicator: Callable[[Prediction], float]
    influence: Callable[[Prediction], Influence]
    without: Callable[[AnyContact], AnyContact] | None
    lacking: Callable[[AnyContact], str | None] = lambda scene: None
    together: tuple[str, ...] = ()
    eased_by: tuple[str, ...] = ()
    part_of: str | None = None
    passing: bool = False
