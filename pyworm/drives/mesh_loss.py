"""Power through a mesh and its loss by friction."""

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class ContactLoss:
    """Friction of one solved contact of a mesh cycle."""

    phase: float
    """Phase in the mesh cycle, 0 to 1."""
    load: float
    """Normal load [N], for each length of a line contact [N/m]."""
    friction: float
    """Friction coefficient [-]."""
    power: float
    """Power lost [W], for each length of a line contact [W/m]."""
    error: float
    """Relative numerical error bar of the power lost [-]."""
    model: float | None = None
    """Its relative uncertainty by the model of roughness [-]; None where roughness was not simulated."""
    section: str | None = None
    """Section of a worm that has two."""
    station: float | None = None
    """Place along a contact line, 0 to 1; None where the contact is solved as a whole."""
    loss_history: tuple[tuple[float, float], ...] = ()
    """Phases since the contact before, and transient power lost over the load at each [m/s]."""


@dataclass(frozen=True)
class MeshLoss:
    """Power through the teeth and its loss by friction."""

    power: float
    """Input power of the driver [W]."""
    loss: float
    """Power lost between the teeth [W]."""
    friction: float
    """Mean friction coefficient [-]."""
    error: float
    """Largest relative error bar of the friction in it [-]."""
    words: str
    """Derivation, in words."""
    model: float | None = None
    """Relative uncertainty of the friction by the model of roughness [-]; None where none was simulated."""
    missing: str = ""
    """Contacts of the cycle without a converged solution, in words; empty where every one has one."""

    @property
    def efficiency(self) -> float:
        """Efficiency of the teeth alone [-]."""
        return 1 - self.loss / self.power

    def summary(self) -> dict[str, float | str | None]:
        """The figures, units in the keys."""
        return {
            "power_W": self.power,
            "power_loss_W": self.loss,
            "friction": self.friction,
            "efficiency": self.efficiency,
            **({"missing": self.missing} if self.missing else {}),
            "relative_error": self.error,
            "relative_model_error": self.model,
            "words": self.words,
        }


def largest_model(contacts: Sequence[ContactLoss]) -> float | None:
    """Largest relative uncertainty by the model of roughness; None where none was simulated."""
    return max((contact.model for contact in contacts if contact.model is not None), default=None)
