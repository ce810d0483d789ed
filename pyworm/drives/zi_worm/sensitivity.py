"""Sensitivity of a ZI worm drive's contact at mid-mesh to errors of assembly and set-up."""

from math import nan
from typing import Any

import numpy as np

from pyworm.drives.zi_worm.tooth_compliance import placed_gap
from pyworm.formulas.film import nijenbanning_venner_moes
from pyworm.io.on_demand import xarray as xr
from pyworm.io.variables import describe
from pyworm.materials.body import reduced_modulus
from pyworm.scene.scales import scales

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


def sensitivity_data(drive: Any) -> "xr.Dataset":
    """The contact at mid-mesh under its load with each error alone; NaN where there is none.

    Parameters
    ----------
    drive : ZiWormDrive
        The drive; the middle of each row is the drive itself.
    """
    load = drive.normal_load(0.5)
    own = mid_mesh_contact(drive, load)
    rows = []
    for name, error in ERRORS.items():
        row = []
        for side in SIDES:
            if side == 0:
                row.append(own)
                continue
            try:
                row.append(mid_mesh_contact(drive.varied(name, side * error), load))
            except ValueError:  # no contact on the teeth, or teeth that jam
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


def mid_mesh_contact(drive: Any, load: float) -> dict[str, float]:
    """The contact at mid-mesh under a load [N]: the variables `CONTACT`.

    Place and pressure are those of the dry contact, the film is by formula.
    """
    contact = drive.contact(0.5)
    modulus = reduced_modulus(*drive.bodies)
    placed = placed_gap(drive.gap(contact), contact.radii, load, modulus, drive.wheel.face_width)
    dry = placed.pressed(load, modulus, placed.covered.astype(float))
    weights = dry.pressure / dry.pressure.sum()
    x, y = (
        float((weights * axis).sum()) for axis in np.meshgrid(placed.x, placed.y, indexing="ij")
    )
    face, radius = drive.flank_place(contact, np.array([x]), np.array([y]))
    return {
        "contact_face": float(face[0]),
        "contact_radius_on_wheel": float(radius[0]),
        "radius_long": contact.radii[0],
        "radius_short": contact.radii[1],
        "dry_pressure_max": float(dry.pressure.max()),
        # of errors of these contacts, whose spin is beyond the atlas, the change of this film tells more
        "formula_film": float(
            nijenbanning_venner_moes(scales(drive.scene_under(load, 0.5)).groups).central
        ),
        "contact_ratio": 1 / drive.pitch,
    }
