"""What errors of mounting make of a drive's contacts, before anything is solved again."""

from dataclasses import dataclass

from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene


@dataclass(frozen=True)
class MountingError:
    """One error of mounting.

    Attributes
    ----------
    label : str
        Which, with its size.
    contacts : tuple of Scene or LineScene
        The contacts with it, in the order of those without; empty where the teeth no longer touch.
    note : str
        What else it does.
    """

    label: str
    contacts: tuple[Scene | LineScene, ...]
    note: str


@dataclass(frozen=True)
class Misalignment:
    """How the contacts of a drive answer to its mounting.

    Attributes
    ----------
    method : str
        By what, a sentence.
    errors : tuple of MountingError
        One at a time; none where nothing is known of them.
    """

    method: str
    errors: tuple[MountingError, ...] = ()
