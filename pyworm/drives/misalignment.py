"""Contacts of a drive under errors of mounting, without solving them again."""

from dataclasses import dataclass

from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene


@dataclass(frozen=True)
class DryContact:
    """A dry contact on the surfaces as they are.

    Attributes
    ----------
    pressure_max : float
        Largest pressure [Pa].
    at_edge : bool
        Whether it rests on an edge, so that film formulas do not apply.
    """

    pressure_max: float
    at_edge: bool


@dataclass(frozen=True)
class MountingError:
    """One error of mounting.

    Attributes
    ----------
    label : str
        Kind of error, with its size.
    contacts : tuple of Scene or LineScene
        The contacts under the error, in the order of those without; empty where the teeth do not touch.
    note : str
        Further effects.
    dry : tuple of DryContact
        The dry contact of each; empty where those of Hertz hold.
    """

    label: str
    contacts: tuple[Scene | LineScene, ...]
    note: str
    dry: tuple[DryContact, ...] = ()


@dataclass(frozen=True)
class Misalignment:
    """Response of the contacts of a drive to errors of mounting.

    Attributes
    ----------
    method : str
        Method, a sentence.
    errors : tuple of MountingError
        Errors, one at a time; empty where they are not computed.
    dry : tuple of DryContact
        The dry contacts without them; empty where those of Hertz hold.
    """

    method: str
    errors: tuple[MountingError, ...] = ()
    dry: tuple[DryContact, ...] = ()
