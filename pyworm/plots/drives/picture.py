"""A picture of a whole mesh cycle."""

from collections.abc import Callable
from dataclasses import dataclass

from matplotlib.figure import Figure

from pyworm.result.result import Result


@dataclass(frozen=True)
class CyclePicture:
    """What a drive shows of its whole mesh cycle.

    Attributes
    ----------
    caption : str
        What a report writes over it.
    draw : callable
        Result -> figure; None where too few phases are solved for it.
    signed : bool
        Whether it belongs to what is signed.
    """

    caption: str
    draw: Callable[[Result], Figure | None]
    signed: bool = False
