"""What is taken off the flanks of a gear pair, and how it is run."""

from dataclasses import dataclass
from typing import Literal

Driver = Literal["pinion", "gear"]

ContactKind = Literal["line", "point"]
"""Which scenes are made: of the middle of the face, or of the whole crowned face."""


@dataclass(frozen=True)
class LinearRelief:
    """Tip relief that grows linearly along the line of action."""

    amount: float = 0.0
    """Relief along the normal, at the tip [m]."""
    length: float = 0.0
    """Length of the relieved part on the line of action [m]."""
