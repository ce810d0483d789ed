"""What case files about a drive have in common, `[lubrication]` among it: how oil comes to the teeth."""

from abc import abstractmethod
from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field

from pyworm.case.case_file import CaseTable
from pyworm.case.table import Table, plain
from pyworm.drives.drive import Drive
from pyworm.drives.duty import Duty
from pyworm.drives.oil_supply import Bath, Jets

LOADS = ("load", "worm_torque", "wheel_torque", "power")
"""Keys of `[operation]` of which one gives the load of the teeth."""


class BathTable(Table, Bath):
    """`[lubrication]`, method = "bath": one body dips into oil."""

    method: Literal["bath"]


class JetsTable(Table, Jets):
    """`[lubrication]`, method = "jets": oil is sprayed onto the mesh."""

    method: Literal["jets"]


LubricationTable = Annotated[BathTable | JetsTable, Field(discriminator="method")]


class DriveCase(CaseTable):
    """A case file about a drive; each kind has its own `drive`, `operation` and `bodies` besides."""

    if TYPE_CHECKING:  # each kind has its own
        drive: Any
        operation: Any

    lubrication: LubricationTable | None = None

    def flaws(self) -> Iterator[str]:
        """Two supplies, or a bath for a body that there is not."""
        yield from super().flaws()
        if self.lubrication is not None and self.oil.supply is not None:
            yield "give either oil.supply or [lubrication], from which it follows"
        names = tuple(type(self.bodies).model_fields)
        if isinstance(self.lubrication, BathTable) and self.lubrication.body not in names:
            yield f'lubrication.body = "{self.lubrication.body}": must be one of {", ".join(names)}'

    @property
    def brought_by(self) -> Bath | Jets | None:
        """How oil comes to the teeth; None where the file does not say."""
        if isinstance(self.lubrication, BathTable):
            return plain(self.lubrication, Bath)
        return None if self.lubrication is None else plain(self.lubrication, Jets)

    @abstractmethod
    def make_drive(self) -> Drive:
        """The gear set of the file; ValueError with a key of `[drive]` if its parts do not make one."""

    def rated_duty(self, drive: Drive) -> Duty | None:
        """Input of the drive's rating by standards; as `Drive.duty`."""
        return drive.duty()

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
