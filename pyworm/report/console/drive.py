"""The computed drawing of a drive on the console, in workshop units."""

import re

from pyworm.drives.drive import Drive
from pyworm.io.quantities import read_key
from pyworm.report.table import Table

_LIMIT = re.compile(r"^(Allowed .*) (from|to)( limited by)?$")
"""Labels of keys of allowed assembly errors."""


def drive_table(drive: Drive) -> Table | None:
    """Computed geometry and kinematics of a drive; None where it describes none."""
    geometry_table = drive.geometry_table()
    if not geometry_table:
        return None
    rows = tuple(described_row(key, value) for key, value in geometry_table.items())
    return Table(("", ""), rows, "Gear set as computed")


def described_row(key: str, value: float | str) -> tuple[str, str]:
    """Label and value of a figure, in its unit by the ending of its key."""
    name, factor, unit = (key, 1.0, "") if isinstance(value, str) else read_key(key)
    label = _LIMIT.sub(_limit, name.replace("_", " ").capitalize())
    return label, value if isinstance(value, str) else f"{value * factor:.5g} {unit}".rstrip()


def _limit(found: re.Match[str]) -> str:
    """Label of a limit of an allowed assembly error, or of what sets it."""
    end = "lower" if found[2] == "from" else "upper"
    return f"{found[1]}, {end} limit{' set by' if found[3] else ''}"
