"""An effect: its indicator, its influence, and the scene without it."""

from collections.abc import Callable
from dataclasses import dataclass
from math import inf

from pyworm.planning.prediction import Prediction
from pyworm.scene.contact import Contact

FILM, FRICTION, TEMPERATURE = "film", "friction", "temperature"

QUANTITIES = (FILM, FRICTION, TEMPERATURE)
"""What may be asked of a contact: minimum and central film, friction and power loss, largest temperatures."""


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
"""The influence of what a contact cannot do without."""


@dataclass(frozen=True)
class Effect:
    """One entry of the catalogue.

    Attributes
    ----------
    name : str
        What `--effects` and tables call it.
    symbol : str
        The indicator as a formula.
    source : str
        Where the indicator, or the law of influence, comes from.
    indicator : callable
        The number that it is judged by, from a prediction [-].
    influence : callable
        The influence of leaving it out, from a prediction.
    without : callable or None
        A scene without the effect; itself where it lies in the solver's hands; None if it is not simulated.
    lacking : callable
        Why a contact has none of it, or why it cannot be told; None where it has.
    together : tuple of str
        Effects without which it is not simulated.
    eased_by : tuple of str
        Effects that are kept beside it: they cost nothing more there and make it easier to solve.
    part_of : str or None
        An effect earlier in the catalogue without which there is nothing of it.
    only_named : bool
        Whether it is simulated only where it is asked for by its name: its cost is out of proportion.
    """

    name: str
    symbol: str
    source: str
    indicator: Callable[[Prediction], float]
    influence: Callable[[Prediction], Influence]
    without: Callable[[Contact], Contact] | None
    lacking: Callable[[Contact], str | None] = lambda scene: None
    together: tuple[str, ...] = ()
    eased_by: tuple[str, ...] = ()
    part_of: str | None = None
    only_named: bool = False
