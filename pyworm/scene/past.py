"""States of a contact at earlier times of its mesh cycle."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Generic, TypeVar

Contact = TypeVar("Contact")


@dataclass(frozen=True)
class Earlier(Generic[Contact]):
    """The state of a contact at an earlier time.

    Attributes
    ----------
    seconds : float
        Time before the present [s].
    contact : Scene or LineScene
        The contact, in axes that move with the contact point.
    angle : float
        Angle about the normal of its x axis to the present one [rad], positive from x to y.
    """

    seconds: float
    contact: Contact
    angle: float = 0.0


@dataclass(frozen=True)
class Past(Generic[Contact]):
    """The states of a contact since its mesh cycle began.

    Attributes
    ----------
    seconds : float
        Time since its mesh cycle began [s].
    before : callable
        Time before the present [s] -> the contact then; ValueError where it carried no load.
    """

    seconds: float
    before: Callable[[float], Earlier[Contact]]

    def back(self, times: Sequence[float]) -> list[Earlier[Contact]]:
        """The contact at increasing times before the present [s], as far back as it carried load."""
        found: list[Earlier[Contact]] = []
        for seconds in times:
            try:
                found.append(self.before(seconds))
            except ValueError:
                break
        return found

    def map(self, change: Callable[[Contact], Contact]) -> "Past[Contact]":
        """The past with a change applied to the contact at every time."""

        def before(seconds: float) -> Earlier[Contact]:
            earlier = self.before(seconds)
            return replace(earlier, contact=change(earlier.contact))

        return replace(self, before=before)
