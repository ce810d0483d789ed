"""What case files about a drive have in common."""

from abc import abstractmethod

from pyworm.case.case_file import CaseTable
from pyworm.drives.drive import Drive

LOADS = ("load", "worm_torque", "wheel_torque", "power")
"""Keys of `[operation]` of which one gives the load of the teeth."""


class DriveCase(CaseTable):
    """A case file about a drive; each kind has its own `drive`, `operation` and `bodies` besides."""

    @abstractmethod
    def make_drive(self) -> Drive:
        """The machine that the file describes.

        Raises
        ------
        ValueError
            The parts do not make a drive; the sentence begins with a key of `[drive]`.
        """

    @property
    def load_key(self) -> str:
        """The key that gives the load."""
        return next(
            f"operation.{key}" for key in LOADS if getattr(self.operation, key, None) is not None
        )

    @property
    def left_open(self) -> dict[str, tuple[str, ...]]:
        """Unknowns that the solution has to determine by iteration: table -> keys in it."""
        return {}
