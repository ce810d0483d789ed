"""The computed drawing of a drive on the console, in workshop units."""

from pyworm.drives.drive import Drive
from pyworm.io.quantities import read_key
from pyworm.report.table import Table


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
    label = name.replace("_", " ").capitalize()
    return label, value if isinstance(value, str) else f"{value * factor:.5g} {unit}".rstrip()
