"""Identification of a contact within a case."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, fields
from itertools import product
from typing import Any, Self


@dataclass(frozen=True)
class ContactIndex:
    """Identification of one contact of a case; attributes that a case does not have are None.

    Scenes and solutions carry attributes of the same names, tables and command lines take their words from
    here, and scenes are ordered by the fields, the first one slowest.
    """

    section: str | None = None
    """Section of a worm that has two: "left" or "right"."""
    phase: float | None = None
    """Place in the mesh cycle, 0 to 1."""
    station: float | None = None
    """Place along a contact line, 0 to 1; None where the contact is solved as a whole."""
    slide_roll_ratio: float | None = None
    """Place on a traction curve: sliding over entrainment [-]."""

    @classmethod
    def of(cls, solved: object) -> Self:
        """The index of a scene or a solution."""
        return cls(**{name: getattr(solved, name) for name in INDEX_NAMES})

    @property
    def given(self) -> dict[str, Any]:
        """The attributes that are not None, by name."""
        return {name: value for name, value in asdict(self).items() if value is not None}

    def __str__(self) -> str:
        """The index in words, such as "phase 0.5"; empty where the case has one contact only."""
        return ", ".join(
            f"{name.replace('_', ' ')} {value if isinstance(value, str) else f'{value:g}'}"
            for name, value in self.given.items()
        )


INDEX_NAMES = tuple(part.name for part in fields(ContactIndex))
"""Names of the attributes of an index, in order."""


def combinations(values: Mapping[str, Sequence[Any]]) -> tuple[ContactIndex, ...]:
    """Every combination of values by name; a name without values stays None."""
    return tuple(
        ContactIndex(*combination)
        for combination in product(*(values.get(name) or (None,) for name in INDEX_NAMES))
    )
