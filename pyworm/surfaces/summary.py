"""A surface's figures and curves as one object, units in the keys."""

from dataclasses import asdict
from typing import Any

import numpy as np

from pyworm.materials.topography import Topography
from pyworm.surfaces.cell_table import CellTable
from pyworm.surfaces.parameters import Texture, slopes
from pyworm.surfaces.preparing import SeparatedWaves

UNITS = {
    "rq": "m",
    "ra": "m",
    "rk": "m",
    "rpk": "m",
    "rvk": "m",
    "length_across": "m",
    "length_along": "m",
    "shortest_length": "m",
    "lay": "rad",
}
"""Unit of a figure; those that are not here are plain numbers."""


def figures(waves: SeparatedWaves, texture: Texture) -> dict[str, Any]:
    """Figures of a surface, and of what it was made from."""
    surface = waves.roughness
    return {
        "points": list(surface.height.shape),
        "spacing_m": list(surface.spacing),
        "filled_fraction": waves.filled,
        "long_waves_rq_m": waves.long_waves.rms,
        **{
            f"{name}_{UNITS[name]}" if name in UNITS else name: value
            for name, value in asdict(texture).items()
        },
    }


def curves(cell: Topography, table: CellTable) -> dict[str, Any]:
    """Contact and flow of a surface's cell against a smooth one, the widest separation first."""
    cube = table.flowing**3
    return {
        "cell_points": list(cell.height.shape),
        "cell_spacing_m": list(cell.spacing),
        "cell_slope": float(np.hypot(*slopes(cell))),
        "separation_m": table.separation.tolist(),
        "pressure_Pa": table.pressure.tolist(),
        "real_area": table.area.tolist(),
        "thickness_m": table.thickness.tolist(),
        **{
            f"{name}_{axes}": (values[k] / scale).tolist()
            for name, values, scale in (
                ("pressure_flow_factor", table.conducted, cube),
                ("shear_flow_factor", table.dragged, table.height),
            )
            for k, axes in enumerate(("xx", "yy", "xy"))
        },
    }
