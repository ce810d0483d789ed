"""A surface's figures and curves as one object, units in the keys."""

from dataclasses import asdict
from typing import Any

import numpy as np

from pyworm.materials.topography import Topography
from pyworm.surfaces.cell_table import CellTable
from pyworm.surfaces.parameters import Texture, slopes
from pyworm.surfaces.parameters import texture as texture_of
from pyworm.surfaces.preparing import SeparatedWaves
from pyworm.surfaces.profile import Profile
from pyworm.surfaces.profile_parameters import ProfileFigures, profile_figures
from pyworm.surfaces.scatter import figures_scatter

UNITS = {
    "rq": "m",
    "ra": "m",
    "rz": "m",
    "rt": "m",
    "rp": "m",
    "rv": "m",
    "width": "m",
    "correlation_length": "m",
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
        "outliers": waves.outliers,
        "long_waves_rq_m": waves.long_waves.rms,
        **_with_units(asdict(texture)),
        **_by_samples([asdict(texture_of(sample)) for sample in surface.samples], asdict(texture)),
    }


def profile_summary(profile: Profile, known: ProfileFigures) -> dict[str, Any]:
    """Figures of a profile, and of what it was made from."""
    return {
        "points": len(profile.height),
        "spacing_m": profile.spacing,
        "section_m": profile.section,
        "filled_fraction": profile.filled,
        "outliers": profile.outliers,
        "long_waves_rq_m": profile.waviness,
        **_with_units(asdict(known)),
        **_by_samples([asdict(profile_figures(part)) for part in profile.parts], asdict(known)),
    }


def _by_samples(
    samples: list[dict[str, float]], whole: dict[str, float]
) -> dict[str, dict[str, float]]:
    """Uncertainty of each figure, by samples of the surface; nothing without."""
    return {"uncertainty": _with_units(figures_scatter(samples, whole))} if samples else {}


def _with_units(known: dict[str, Any]) -> dict[str, Any]:
    return {
        f"{name}_{UNITS[name]}" if name in UNITS else name: value for name, value in known.items()
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
