"""`[lubrication]`: how oil comes to the teeth of a drive."""

from typing import Annotated, Literal

from pydantic import Field

from pyworm.case.table import Table
from pyworm.drives.oil_supply import Bath, Jets


class BathTable(Table, Bath):
    """`[lubrication]`, method = "bath": one body dips into oil."""

    method: Literal["bath"]


class JetsTable(Table, Jets):
    """`[lubrication]`, method = "jets": oil is sprayed onto the mesh."""

    method: Literal["jets"]


LubricationTable = Annotated[BathTable | JetsTable, Field(discriminator="method")]
