"""What a contact was earlier, on its way through its drive's mesh."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Generic, TypeVar

Contact = TypeVar("Contact")


@dataclass(frozen=True)
class Earlier(Generic[Contact]):
    """A contact as it was.

    Attributes
    ----------
    seconds : float
        Time before the present [s].
    contact : Scene or LineScene
        The contact, in axes of its own that go along with the contact point.
    angle : float
        Angle about the normal of its x axis to the present one [rad], positive from x to y.
    """

    seconds: float
    contact: Contact
    angle: float = 0.0


@dataclass(frozen=True)
class Past(Generic[Contact]):
    """How a contact came to be what it is.

    Attributes
    ----------
    seconds : float
        Time since its mesh cycle began [s].
    before : callable
        Time before the present [s] -> the contact then; ValueError where it carried nothing.
    """

    seconds: float
    before: Callable[[float], Earlier[Contact]]

    def back(self, times: Sequence[float]) -> list[Earlier[Contact]]:
        """The contact at times before the present [s], which increase, as far back as it carried."""
        found: list[Earlier[Contact]] = []
        for seconds in times:
            try:
                found.append(self.before(seconds))
            except ValueError:
                break
        return found

    def map(self, change: Callable[[Contact], Contact]) -> "Past[Contact]":
        """The same of a contact that is changed."""

        def before(seconds: float) -> Earlier[Contact]:
            earlier = self.before(seconds)
            return replace(earlier, contact=change(earlier.contact))

        return replace(self, before=before)
