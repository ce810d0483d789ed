"""The wheel's flank for the page: extremes over the cycle, and where each contact lies on it."""

from collections.abc import Sequence
from typing import Any

import numpy as np
import scipy

from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import QUANTITIES
from pyworm.plots.layout import MILLI
from pyworm.report.explore.colours import FLANK
from pyworm.report.explore.packed import packed
from pyworm.result.flank_map import flank_map
from pyworm.result.result import Result

TOUCHED_PRESSURE_RATIO = 0.02
"""Pressure over the contact's largest within which a place of the flank counts as touched."""


def flank(result: Result, grids: "Sequence[xr.Dataset]") -> dict[str, Any] | None:
    """The map of the flank, its outline and the path of contact; None without enough phases."""
    cycle = result.mesh_cycle
    if cycle is None or "rim_face" not in cycle:
        return None
    field = flank_map(result)
    if field is None:
        return None
    point = cycle["point"]
    radius = np.hypot(point.sel(axis="x").values, point.sel(axis="z").values)
    return {
        "face": _ends(field["face"].values),
        "radius": _ends(field["radius"].values),
        "fields": {
            name: packed(QUANTITIES[name].number(field[name].values), QUANTITIES[name].logarithmic)
            for name in FLANK
            if name in field
        },
        "rim": [_shown(cycle[name].values) for name in ("rim_face", "rim_radius")],
        "path": [_shown(point.sel(axis="y").values), _shown(radius)],
        "places": [_places(grid) for grid in grids],
    }


def _ends(places: np.ndarray) -> list[float]:
    return [float(places[0]) * MILLI, float(places[-1]) * MILLI, len(places)]


def _shown(values: np.ndarray) -> list[float]:
    return [round(float(value) * MILLI, 4) for value in values]


def _places(grid: "xr.Dataset") -> dict[str, Any] | None:
    """Places on the flank of a contact's nodes [mm], and those that it loads."""
    if "face" not in grid:
        return None
    loaded = grid["pressure"].values > TOUCHED_PRESSURE_RATIO * float(grid["pressure"].max())
    return {
        "face": packed(grid["face"].values * MILLI),
        "radius": packed(grid["radius"].values * MILLI),
        "loaded": packed(loaded.astype(float)),
    }


def pressure_on(grid: "xr.Dataset", face: np.ndarray, radius: np.ndarray) -> np.ndarray:
    """Pressure [Pa] of a contact, on its reduced grid, at places of the flank; zero beside it."""
    if "face" not in grid:
        return np.zeros(face.shape)
    known = np.stack([grid["face"].values.ravel(), grid["radius"].values.ravel()], axis=1)
    values = grid["pressure"].values.ravel()
    sound = np.isfinite(known).all(axis=1) & np.isfinite(values)
    interpolated = scipy.interpolate.LinearNDInterpolator(
        known[sound], values[sound], fill_value=0.0
    )
    return interpolated(face, radius)
