"""Interface to the compiled kernel: dry contacts, films on a grid, stresses, interpolation between grids."""

from pyworm.kernel.core import (
    NO_DESCENT,
    NO_MEMORY,
    NO_SENSE,
    NOT_CONVERGED,
    NOT_FINITE,
    KernelError,
    compiled_with,
)
from pyworm.kernel.dry_contact import DryContact, dry_contact, elastic_deflection
from pyworm.kernel.film import HeatStorage
from pyworm.kernel.interpolation import level_positions, prolong, prolong_levels
from pyworm.kernel.line_film import LineFilm
from pyworm.kernel.point_film import PointFilm
from pyworm.kernel.subsurface_stress import subsurface_stress, thermal_stress
from pyworm.kernel.surface_heat import (
    FluxRecord,
    SurfacePast,
    extrapolated_flux,
    residual_rise,
)

__all__ = [
    "NOT_CONVERGED",
    "NOT_FINITE",
    "NO_DESCENT",
    "NO_MEMORY",
    "NO_SENSE",
    "DryContact",
    "FluxRecord",
    "HeatStorage",
    "KernelError",
    "LineFilm",
    "PointFilm",
    "SurfacePast",
    "compiled_with",
    "dry_contact",
    "elastic_deflection",
    "extrapolated_flux",
    "level_positions",
    "prolong",
    "prolong_levels",
    "residual_rise",
    "subsurface_stress",
    "thermal_stress",
]
