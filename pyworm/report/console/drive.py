"""The computed drawing of a drive on the console, in workshop units."""

from rich.table import Table

from pyworm.drives.drive import Drive

_UNITS = (
    ("_m_per_s", 1.0, "m/s"),
    ("_N_m", 1.0, "N m"),
    ("_N", 1.0, "N"),
    ("_deg", 1.0, "°"),
    ("_m", 1e3, "mm"),
)
"""Ending of a key -> factor from its unit to the one shown, and that."""


def drive_table(drive: Drive) -> Table | None:
    """Computed geometry and kinematics of a drive; None where it describes none."""
    described = drive.described()
    if not described:
        return None
    table = Table(title="The drive as computed", title_justify="left", show_header=False)
    table.add_column("Figure", no_wrap=True)
    table.add_column("Value", justify="right", no_wrap=True)
    for key, value in described.items():
        table.add_row(*described_row(key, value))
    return table


def described_row(key: str, value: float | str) -> tuple[str, str]:
    """Label and value of a figure, in its unit by the ending of its key."""
    if isinstance(value, str):
        return _label(key), value
    for ending, factor, unit in _UNITS:
        if key.endswith(ending):
            return _label(key.removesuffix(ending)), f"{value * factor:.5g} {unit}"
    return _label(key), f"{value:.5g}"


def _label(name: str) -> str:
    return name.replace("_", " ").capitalize()
