"""A contact a little earlier and a little later, from which rates of change are taken."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, TypeVar

Contact = TypeVar("Contact")


@dataclass(frozen=True)
class Neighbours(Generic[Contact]):
    """The contact before and after an instant, as its drive turns.

    Attributes
    ----------
    before, after : Scene or LineScene
        The contacts.
    seconds : float
        Time from one to the other [s].
    """

    before: Contact
    after: Contact
    seconds: float

    def rate(self, of: Callable[[Contact], float]) -> float:
        """How fast a number of the contact changes, in its unit for each second."""
        return (of(self.after) - of(self.before)) / self.seconds
