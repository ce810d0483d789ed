"""The inspection sheet of a drive in workshop units: gear set, both bodies, allowed assembly errors."""

from collections.abc import Mapping

from pyworm.drives.drive import AllowedErrors, Drive
from pyworm.io.quantities import read_key
from pyworm.ratings.motion import rate_motion
from pyworm.report.ratings import rating_table
from pyworm.report.table import Table


def drive_tables(drive: Drive) -> tuple[Table, ...]:
    """The printed sheet of a drive, with allowed assembly errors; empty where it describes none."""
    found = drive.geometry_table()
    sheet = {key: found[key] for key in drive.sheet if key in found}
    return (
        *sheet_tables(sheet, drive.body_names),
        *_allowed_table(drive.allowed_errors()),
        *_forces_table(drive),
        *_motion_table(drive),
    )


def sheet_tables(sheet: Mapping[str, float | str], bodies: tuple[str, str]) -> tuple[Table, ...]:
    """Values of a geometry table as two tables: of the gear set, and of its bodies by their names."""
    common: list[tuple[str, ...]] = []
    of_bodies: dict[str, list[str]] = {}
    for key, value in sheet.items():
        body = next((name for name in bodies if key.startswith(f"{name}_")), None)
        if body is None:
            common.append(described_row(key, value))
            continue
        label, shown = described_row(key.removeprefix(f"{body}_"), value)
        of_bodies.setdefault(label, ["", ""])[bodies.index(body)] = shown
    rows = tuple((label, *shown) for label, shown in of_bodies.items())
    tables = (
        Table(("", ""), tuple(common), "Gear set as computed"),
        Table(("", *(name.capitalize() for name in bodies)), rows, "Inspection sheet"),
    )
    return tuple(table for table in tables if table.rows)


def described_row(key: str, value: float | str) -> tuple[str, str]:
    """Label and value of a figure, in its unit by the ending of its key."""
    name, factor, unit = (key, 1.0, "") if isinstance(value, str) else read_key(key)
    label = name.replace("_", " ").capitalize()
    if isinstance(value, str):
        return label, value
    number = (
        f"{round(value * factor, 3) + 0.0:.9g}" if unit == "mm" else f"{value * factor:.5g}"
    )  # 0.0: no minus before a zero
    return label, f"{number} {unit}".rstrip()


def _allowed_table(allowed: AllowedErrors) -> tuple[Table, ...]:
    """Allowed assembly errors, each with what limits it; empty where none are known."""
    rows = []
    for entry, row in allowed.items():
        limits = {
            key.partition("_")[0]: (key, value)
            for key, value in row.items()
            if "limited" not in key
        }
        cells = (
            f"{described_row(*limits[end])[1]} ({row[f'{end}_limited_by']})"
            for end in ("from", "to")
        )
        rows.append((entry.replace("_", " ").capitalize(), *cells))
    head = "", "From (set by)", "To (set by)"
    return (Table(head, tuple(rows), "Allowed assembly errors"),) if rows else ()


def _motion_table(drive: Drive) -> tuple[Table, ...]:
    """Motion of parts that no shaft drives; empty of a drive without them."""
    found = drive.motion_figures()
    return () if found is None else (rating_table(rate_motion(found)),)


def _forces_table(drive: Drive) -> tuple[Table, ...]:
    """Mean forces on both shafts as the drive runs; empty where they are not known."""
    forces = drive.mesh_forces()
    if forces is None:
        return ()
    rows = tuple(
        (
            force.shaft.capitalize(),
            *(f"{abs(part):.4g} N" for part in (force.tangential, force.axial, force.radial)),
            f"{abs(force.torque):.4g} N m",
        )
        for force in forces.shafts
    )
    head = "Force of the mesh on", "Tangential", "Axial", "Radial", "Torque"
    title = f"Forces, the {forces.driver} driving, friction {forces.friction:.2g}"
    return (Table(head, rows, title),)
