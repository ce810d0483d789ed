"""How a hob is set up, and what pattern and contact its wheel has."""

from dataclasses import dataclass

Row = dict[str, float]
"""A set-up, its contact pattern without load and its contact at mid-mesh; keys end in their unit."""


@dataclass(frozen=True)
class HobSetup:
    """The set-up of a hob, and the one that was looked for.

    Attributes
    ----------
    now : dict
        As the drive is cut.
    found : dict or None
        With the wanted pattern; None where none was wanted.
    reached : bool
        Whether it has the wanted pattern, or is only nearest to it.
    """

    now: Row
    found: Row | None = None
    reached: bool = True
