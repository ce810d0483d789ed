"""Catalogue of effects, the most expensive first: these are left out first."""

from pyworm.planning.effects.effect import Effect
from pyworm.planning.effects.geometry import (
    ELASTIC_DEFLECTION,
    REAL_GAP,
    SECOND_DIMENSION,
    VARYING_VELOCITY,
)
from pyworm.planning.effects.heat import FILM_HEATING, SURFACE_HEATING, VISCOSITY_ACROSS
from pyworm.planning.effects.rheology import (
    COMPRESSIBILITY,
    LIMITING_STRESS,
    PRESSURE_VISCOSITY,
    SHEAR_THINNING,
)
from pyworm.planning.effects.roughness import ROUGHNESS
from pyworm.planning.effects.squeeze import SQUEEZE
from pyworm.planning.effects.starvation import STARVATION

EFFECTS: tuple[Effect, ...] = (
    SQUEEZE,
    SECOND_DIMENSION,
    FILM_HEATING,
    SURFACE_HEATING,
    SHEAR_THINNING,
    LIMITING_STRESS,
    REAL_GAP,
    VARYING_VELOCITY,
    VISCOSITY_ACROSS,
    ELASTIC_DEFLECTION,
    PRESSURE_VISCOSITY,
    COMPRESSIBILITY,
    STARVATION,
    ROUGHNESS,
)
