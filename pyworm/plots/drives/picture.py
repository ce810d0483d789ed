"""A picture of a whole mesh cycle."""

from collections.abc import Callable
from dataclasses import dataclass

from matplotlib.figure import Figure

from pyworm.result.result import Result


@dataclass(frozen=True)
class CyclePicture:
    """What a drive shows of its whole mesh cycle."""

    caption: str
    """What a report writes over it."""
    draw: Callable[[Result], Figure | None]
    """Result -> figure; None where too few phases are solved for it."""
    signed: bool = False
    """Whether it belongs to what is signed."""
