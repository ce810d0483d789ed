"""`[lubrication]`: how oil comes to the teeth of a drive."""

from typing import Annotated, Literal

from pydantic import Field

from pyworm.case.table import Table, Text
from pyworm.drives.oil_supply import Bath, Jets, Side
from pyworm.io import units


class BathTable(Table):
    """`[lubrication]`, method = "bath": one body dips into oil."""

    method: Literal["bath"]
    body: Text
    depth: units.Length

    def by(self) -> Bath:
        """The bath."""
        return Bath(self.body, self.depth)


class JetsTable(Table):
    """`[lubrication]`, method = "jets": oil is sprayed onto the mesh."""

    method: Literal["jets"]
    flow: units.OilFlow
    side: Side = "incoming"

    def by(self) -> Jets:
        """The jets."""
        return Jets(self.flow, self.side)


LubricationTable = Annotated[BathTable | JetsTable, Field(discriminator="method")]
