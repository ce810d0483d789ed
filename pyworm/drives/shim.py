"""A shim that moves a wheel along its axis, to correct a contact pattern."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Shim:
    """A shift of the wheel along its axis, and what it does to both flanks.

    Places are middles of the marked part along the face from its middle [m], positive to the side where the
    worm's threads leave as they drive.

    Attributes
    ----------
    shift : float
        Of the wheel [m], positive to that side.
    wanted : float
        Wanted place on the flank that the worm drives.
    before, after : float
        Place there without the shim and with it.
    other_before, other_after : float
        Likewise on the other flank, which the same shift moves by its own way.
    reached : bool
        Whether the shim brings the pattern to the wanted place.
    """

    shift: float
    wanted: float
    before: float
    after: float
    other_before: float
    other_after: float
    reached: bool
