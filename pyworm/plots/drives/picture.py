"""Pictures of a whole mesh cycle, by the kind of drive."""

from collections.abc import Callable
from dataclasses import dataclass

from matplotlib.figure import Figure

from pyworm.drives.kinds import module_of
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


def cycle_pictures(result: Result) -> dict[str, CyclePicture]:
    """Name in the file name -> picture of the mesh cycle of a result; empty without one.

    They are `CYCLE_PICTURES` of the drive's module of pictures (`pyworm.drives.kinds`).
    """
    if result.mesh_cycle is None:
        return {}
    module = module_of(result.mesh_cycle.attrs["drive"], "plots")
    return {} if module is None else module.CYCLE_PICTURES
