"""A drive in space for the page, with the pressure of each contact on its flank, or the line of contact."""

from collections.abc import Sequence
from typing import Any

import numpy as np
import scipy

from pyworm.case.case import case_again
from pyworm.drives.answers import Shape
from pyworm.io.input_error import CaseError
from pyworm.io.on_demand import xarray as xr
from pyworm.plots.layout import MEGA, MILLI
from pyworm.report.explore.flank import pressure_on
from pyworm.report.explore.packed import packed
from pyworm.result.result import Result
from pyworm.scene.index import ContactIndex

FINER = 3
"""Points of the flank with the contact between two of the drive's own, so that the contact is seen."""


def space(result: Result, grids: "Sequence[xr.Dataset]") -> dict[str, Any] | None:
    """The drive of a result in space; None where it has none, or one whose surfaces are not known."""
    places = [ContactIndex.of(solution) for solution in result.solutions]
    if not result.case or any(place.phase is None for place in places):
        return None
    try:
        drive = case_again(result.case).drive
    except CaseError:  # of another version: the page is without
        return None
    found = None if drive is None else drive.in_space(places)
    if found is None:
        return None
    return {
        "drawn": found.drawn,
        "view": found.view.tolist(),
        "size": found.size * MILLI,
        "shapes": [_shape(shape, grids) for shape in found.shapes],
        "lines": [(line * MILLI).round(4).tolist() for line in found.lines],
    }


def _shape(shape: Shape, grids: "Sequence[xr.Dataset]") -> dict[str, Any]:
    surface, pressures, stride = shape.surface, [], 1
    if shape.face is not None and shape.radius is not None:
        surface, face, radius = (_finer(nodes) for nodes in (surface, shape.face, shape.radius))
        stride = FINER  # where there is no pressure to be seen
        pressures = [packed(pressure_on(grid, face, radius) * MEGA) for grid in grids]
    return {
        "body": shape.body,
        "axisPoint": (shape.axis_point * MILLI).tolist(),
        "axis": shape.axis.tolist(),
        "rows": surface.shape[0],
        "columns": surface.shape[1],
        "stride": stride,
        "points": packed(surface * MILLI),
        "turns": shape.turns.tolist(),
        "copies": list(shape.copies),
        "pressures": pressures,
    }


def _finer(values: np.ndarray) -> np.ndarray:
    """Values at places of a grid with more rows and columns, linear between."""
    rows, columns = (np.arange(0, (size - 1) * FINER + 1) / FINER for size in values.shape[:2])
    places = np.meshgrid(rows, columns, indexing="ij")
    flat = values.reshape(*values.shape[:2], -1)
    found = [
        scipy.ndimage.map_coordinates(flat[..., part], places, order=1)
        for part in range(flat.shape[-1])
    ]
    return np.stack(found, axis=-1).reshape(*places[0].shape, *values.shape[2:])
