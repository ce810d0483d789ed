"""Sensitivity of a ZI worm drive's contact at mid-mesh to errors of assembly and set-up."""

from math import nan
from typing import TYPE_CHECKING

import numpy as np

from pyworm.drives.zi_worm.dry_contact import dry_contact_of
from pyworm.drives.zi_worm.play import check_play
from pyworm.formulas.film import nijenbanning_venner_moes
from pyworm.io.on_demand import xarray as xr
from pyworm.io.variables import describe
from pyworm.scene.scales import scales

if TYPE_CHECKING:
    from pyworm.drives.zi_worm.drive import ZiWormDrive

ERRORS = {
    "assembly.centre_distance": 0.1e-3,
    "assembly.axial_shift": 0.1e-3,
    "assembly.shaft_angle": np.radians(0.05),
    "hob.swivel": np.radians(0.05),
}
"""Entry -> error in both directions from the drive's value [m] or [rad]."""

SIDES = (-1, 0, 1)

CONTACT = (
    "contact_face",
    "contact_radius_on_wheel",
    "radius_long",
    "radius_short",
    "dry_pressure_max",
    "formula_film",
    "contact_ratio",
)
"""Variables of each contact."""


def sensitivity_data(drive: "ZiWormDrive") -> "xr.Dataset":
    """The contact at mid-mesh under its load with each error alone; NaN where teeth cannot be assembled.

    Parameters
    ----------
    drive : ZiWormDrive
        The drive; the middle of each row is the drive itself.
    """
    load = drive.mid_mesh_load
    own = mid_mesh_contact(drive, load)
    rows = []
    for name, error in ERRORS.items():
        row = []
        for side in SIDES:
            if side == 0:
                row.append(own)
                continue
            try:
                varied = drive.varied(name, side * error)
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


def mid_mesh_contact(drive: "ZiWormDrive", load: float) -> dict[str, float]:
    """The contact at mid-mesh under a load [N]: the variables `CONTACT`.

    Place and pressure are those of the dry contact on the flanks as they are, edges included. The film is by
    formula, NaN where the contact rests on an edge, for which formulas of smooth flanks mean nothing.
    """
    dry = dry_contact_of(drive, load)
    contact = dry.contact
    face, radius = drive.flank_place(contact, np.array([dry.x]), np.array([dry.y]))
    film = nan
    if not dry.at_edge:
        # of errors of these contacts, whose spin is beyond the atlas, the change of this film tells more
        film = nijenbanning_venner_moes(scales(drive.scene_under(load, 0.5)).groups).central_number
    return {
        "contact_face": float(face[0]),
        "contact_radius_on_wheel": float(radius[0]),
        "radius_long": contact.radii[0],
        "radius_short": contact.radii[1],
        "dry_pressure_max": dry.pressure_max,
        "formula_film": film,
        "contact_ratio": 1 / drive.pitch,
    }
