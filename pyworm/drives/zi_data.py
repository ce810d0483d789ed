"""What the pictures of a ZI worm drive show beside solutions: its mesh cycle, and the tooth of a contact."""

from collections.abc import Iterable
from typing import Any

import numpy as np
import xarray as xr

from pyworm.scene import Gap
from pyworm.variables import describe

KIND = "zi-worm"

TOOTH_SAMPLES = 129
"""Points along each direction at which the gap is sampled over the whole tooth."""


def mesh_cycle_data(contacts: Iterable[Any]) -> xr.Dataset:
    """The contacts of a mesh cycle as one dataset over phase.

    Parameters
    ----------
    contacts : iterable
        Objects with phase [-], worm_angle and wheel_angle [rad], transmission_error [rad], point
        [m] and normal as three components in the axes of the drive, and radii [m] along x and y of
        the tangent plane.
    """
    contacts = tuple(contacts)

    def column(name: str) -> np.ndarray:
        return np.array([getattr(contact, name) for contact in contacts], dtype=float)

    radii = column("radii")
    return describe(
        xr.Dataset(
            {
                "worm_angle": ("phase", column("worm_angle")),
                "wheel_angle": ("phase", column("wheel_angle")),
                "transmission_error": ("phase", column("transmission_error")),
                "point": (("phase", "axis"), column("point")),
                "normal": (("phase", "axis"), column("normal")),
                "radius_x": ("phase", radii[:, 0]),
                "radius_y": ("phase", radii[:, 1]),
            },
            coords={"phase": column("phase"), "axis": ["x", "y", "z"]},
            attrs={"drive": KIND},
        )
    )


def tooth_data(outline: Any, gap: Gap) -> xr.Dataset:
    """The tooth, its whole gap and its path of contact over a contact's tangent plane.

    Parameters
    ----------
    outline : ToothOutline
        Outline and path.
    gap : Gap
        The gap of the contact.
    """
    x = np.linspace(outline.x.min(), outline.x.max(), TOOTH_SAMPLES)
    y = np.linspace(outline.y.min(), outline.y.max(), TOOTH_SAMPLES)
    opening, covered = gap(*np.meshgrid(x, y))
    tooth = xr.Dataset(
        {
            "tooth_gap": (("tooth_y", "tooth_x"), np.where(covered, opening, np.nan)),
            "tooth_outline_x": ("outline", outline.x),
            "tooth_outline_y": ("outline", outline.y),
            "contact_path_x": ("path", outline.path_x),
            "contact_path_y": ("path", outline.path_y),
        },
        coords={"tooth_x": x, "tooth_y": y},
    )
    return describe(tooth)
