"""Power through a mesh and what friction takes of it."""

from dataclasses import dataclass


@dataclass(frozen=True)
class ContactLoss:
    """Friction of one solved contact of a mesh cycle.

    Attributes
    ----------
    phase : float
        Where in the cycle, 0 to 1.
    load : float
        Normal load [N], for each length of a line contact [N/m].
    friction : float
        Friction coefficient [-].
    power : float
        Power lost [W], for each length of a line contact [W/m].
    error : float
        Relative error bar of the power lost [-].
    """

    phase: float
    load: float
    friction: float
    power: float
    error: float


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
