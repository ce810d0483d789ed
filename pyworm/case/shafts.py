"""Tables of shafts on two bearings that do not bend."""

from pyworm.case.table import Table, plain
from pyworm.drives.forces import Supports


class SupportsTable(Table, Supports):
    """`[drive.wheel_shaft]`, `[drive.pinion_shaft]`, `[drive.gear_shaft]`: bearings of a rigid shaft."""


def supports_of(table: SupportsTable | None) -> Supports | None:
    """The bearings of a table; None without one."""
    return None if table is None else plain(table, Supports)
