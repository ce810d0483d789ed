"""The contact of a worm drive with errors of its assembly, for people."""

import numpy as np

from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import QUANTITIES
from pyworm.report.table import Table


def sensitivity_table(cycle: "xr.Dataset") -> Table:
    """Contact of a worm drive in mid-mesh with errors of assembly and set-up, one at a time."""
    load, dry = QUANTITIES["load"].text(cycle.attrs["varied_load"]), QUANTITIES["dry_pressure_max"]
    film, rows = QUANTITIES["film"], []
    columns = (
        ("Face\nmm", "contact_face", 1e3, ".1f"),
        ("Radius\nmm", "contact_radius_on_wheel", 1e3, ".1f"),
        ("Rx\nmm", "radius_long", 1e3, ".0f"),
        ("Ry\nmm", "radius_short", 1e3, ".1f"),
        (dry.column, dry.name, dry.scale, ".0f"),
        (f"Formula\n{film.symbol} {film.shown}", "formula_film", film.scale, ".2f"),
    )
    for number, error in enumerate(cycle["error"].values):
        size = float(cycle["error_size"][number])
        angle = error in ANGLES
        shown = f"{np.degrees(size):.2g} deg" if angle else f"{size * 1e3:.2g} mm"
        for side, sign in ((0, "-"), (1, ""), (2, "+")):
            if side == 1 and number > 0:
                continue
            label = f"{_ERRORS[error]} {sign}{shown}" if sign else "as it is"
            varied = cycle.isel(error=number, side=side)
            values = [float(varied[f"varied_{name}"]) * scale for _, name, scale, _ in columns]
            known = np.isfinite(values[0])
            cells = [
                f"{value:{style}}" if np.isfinite(value) else NO_FORMULA
                for value, (*_, style) in zip(values, columns, strict=True)
            ]
            rows.append((label, *(cells if known else ["cannot be assembled"])))
    return Table(
        head=("Error", *(heading for heading, *_ in columns)),
        rows=tuple(rows),
        title=f"Contact in mid-mesh under {load} with errors of the assembly",
    )


_ERRORS = {
    "assembly.centre_distance": "centre distance",
    "assembly.axial_shift": "shift of the worm",
    "assembly.shaft_angle": "shaft angle",
    "hob.swivel": "hob's swivel",
}
"""Entry in error -> what people call it."""

NO_FORMULA = "at edge"
"""What is shown in place of radii and films of a contact that rests on an edge of a tooth."""

ANGLES = ("assembly.shaft_angle", "hob.swivel")

CYCLE_TABLE = sensitivity_table
"""What `pyworm run` prints of the mesh cycle."""
