"""Sensitivity of a worm drive's contact at mid-mesh to errors of assembly and set-up."""

from math import nan

import numpy as np

from pyworm.drives.worm.loads.dry_contact import CONTACT, mid_mesh_contact
from pyworm.drives.worm.loads.mesh import WormMesh
from pyworm.drives.worm.teeth.checks import check_play
from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import describe

ERRORS = {
    "assembly.centre_distance": 0.1e-3,
    "assembly.axial_shift": 0.1e-3,
    "assembly.shaft_angle": np.radians(0.05),
    "hob.swivel": np.radians(0.05),
}
"""Entry -> error in both directions from the drive's value [m] or [rad]."""

SIDES = (-1, 0, 1)


def sensitivity_data(mesh: WormMesh) -> "xr.Dataset":
    """The contact at mid-mesh under its load with each error alone; NaN where teeth cannot be assembled."""
    load = mesh.mid_mesh_load
    aligned = mid_mesh_contact(mesh, load)
    rows = []
    for name, error in ERRORS.items():
        row = []
        for side in SIDES:
            if side == 0:
                row.append(aligned)
                continue
            try:
                varied = mesh.varied(name, side * error)
                check_play(varied)
                row.append(mid_mesh_contact(varied, load))
            except ValueError:  # teeth that jam or do not reach each other
                row.append(dict.fromkeys(CONTACT, nan))
        rows.append(row)
    errors = np.array(list(ERRORS.values()))
    return describe(
        xr.Dataset(
            {
                f"varied_{name}": (
                    ("error", "side"),
                    np.array([[float(contact[name]) for contact in row] for row in rows]),
                )
                for name in CONTACT
            }
            | {"error_size": ("error", errors)},
            coords={"error": list(ERRORS), "side": list(SIDES)},
            attrs={"varied_load": load},
        )
    )
