"""How heat and shear thinning reduce films of point contacts, fitted to the thermal contacts of the atlas.

ln of the factor of each film is -(T e^a + V e^b): T is that of Wilson and Sheu's heated inlet, which ends
with the thermal loading, V that of an oil whose viscosity falls with the shear rate of the inlet by Eyring's
law, which ends with speed over stress; a and b are a small network of the groups, held constant outside the
box (`benchmarks/atlas/fit_thermal.py`). So a factor is below 1, and 1 where neither is at work.
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from math import log
from typing import TypedDict

import numpy as np

from pyworm.formulas.arrays import Array, Flags, Values
from pyworm.formulas.film_atlas import AtlasGroups, pressure, thickness
from pyworm.formulas.thermal_reduction import wilson_sheu

LEAST_SHEAR = 1e-3
"""Shear rate of the inlet from which the series of the sinh's inverse no longer serves."""


class HeatConstants(TypedDict):
    """The constants of the fit."""

    low: Array
    """Lower bound of each feature's box."""
    high: Array
    """Upper bound of each feature's box."""
    slope: Array
    """Rise of ln of the error of each film with each feature, (features, 2)."""
    level: Array
    """ln of the error of each film in the middle of the box, (2)."""
    films: Mapping[str, Array]
    """Weights of the network, by name."""


@dataclass(frozen=True)
class HeatGroups:
    """Similarity groups of heat and flow of point contacts, numbers or arrays."""

    loading: Values
    """Thermal loading eta0 beta u^2/k of the entrainment speed u [-]."""
    sliding: Values
    """Slide-roll ratio, the size of sliding over entrainment [-]; above 2 of opposite motion."""
    shear: Values
    """eta0 u/(h tau0) with the central film h without heat and the Eyring stress tau0 [-]."""
    conductivity_ratio: Values
    """Conductivity of the oil over that of the bodies [-]."""
    eyring: Values
    """Eyring stress over the Hertz pressure [-]."""
    limiting: Values
    """Limiting stress at the Hertz pressure over that pressure [-]."""
    graetz: Values
    """Heat carried by the film over heat conducted across it, rho c u h^2/(k b) with the half b of Hertz's
    ellipse along the entrainment [-]."""
    peclet: Values
    """rho c u b/k of the bodies [-]."""
    film_warmth: Values
    """beta times the rise of the film over its walls, q h/8k, with the heat q of the shear at the mean
    pressure in an oil that heat leaves alone [-]."""
    surface_warmth: Values
    """beta times the rise of the walls, q [b/(u rho c k)]^(1/2), with the same heat q [-]."""


@dataclass(frozen=True)
class FilmReduction:
    """Factors of films by heat and shear thinning, each shaped as the groups together."""

    central: Array
    """Factor of the film at the contact point [-]."""
    minimum: Array
    """Factor of the least film [-]."""
    central_error: Array
    """Relative error of the central film's factor of 19 of 20 contacts outside the fit [-]."""
    minimum_error: Array
    """Relative error of the minimum film's factor of 19 of 20 contacts outside the fit [-]."""
    inside: Flags
    """Whether the contact is in the box of the thermal contacts; outside it the errors are not known."""


def reduction(groups: AtlasGroups, central: Values, heat: HeatGroups) -> FilmReduction:
    """Factors of central and minimum film by heat and shear thinning, from the central film in Moes' unit."""
    constants = _constants()
    read = features(groups, central, heat)
    inside = np.all((constants["low"] <= read) & (read <= constants["high"]), axis=-1)
    kept = scaled(read, constants)
    factors = np.exp(-heat_reduction(kept, heat, constants["films"]))
    errors = bars(kept, constants)
    return FilmReduction(factors[..., 0], factors[..., 1], errors[..., 0], errors[..., 1], inside)


def bars(kept: Array, constants: HeatConstants) -> Array:
    """Relative errors of both factors that 19 of 20 left-out contacts kept, (..., 2)."""
    level = kept @ constants["slope"] + constants["level"]
    bars: Array = np.exp(np.clip(level, log(LEAST_ERROR), 0))
    return bars


LEAST_ERROR = 0.01
"""Errors below the bars of the thermal contacts are not told."""


SLENDER = 12
"""Place of ln of the ratio of radii in what the network reads."""

LEAST_WARMTH = 1e-3
"""Warmth that changes nothing: as of pure rolling."""


def features(groups: AtlasGroups, central: Values, heat: HeatGroups) -> Array:
    """What the network reads, (..., features); of a circular contact nothing turns with the angle."""
    oval = 1 - np.exp(-groups.slender)
    side, _ = groups.inlet
    return np.stack(
        np.broadcast_arrays(
            np.log(heat.loading),
            heat.sliding,
            np.log(heat.shear),
            np.log(heat.conductivity_ratio),
            np.log(heat.eyring),
            heat.limiting,
            np.log(heat.graetz),
            np.log(heat.peclet),
            np.log(heat.film_warmth + LEAST_WARMTH),
            np.log(heat.surface_warmth + LEAST_WARMTH),
            np.log(groups.moes_m),
            np.log(groups.moes_l),
            groups.slender,
            oval * (2 * side - 1),
            thickness(groups, np.log(central)),
            np.log(pressure(groups)),
        ),
        axis=-1,
    )


def scaled(read: Array, constants: HeatConstants) -> Array:
    """The features inside their box, -1 to 1."""
    low, high = constants["low"], constants["high"]
    scaled: Array = (2 * np.clip(read, low, high) - low - high) / (high - low)
    return scaled


def heat_reduction(kept: Array, heat: HeatGroups, constants: Mapping[str, Array]) -> Array:
    """-ln of both factors, (..., 2)."""
    heat_reduction: Array = (terms(heat)[..., None, :] * np.exp(exponents(kept, constants))).sum(
        axis=-1
    )
    return heat_reduction


def terms(heat: HeatGroups) -> Array:
    """-ln of Wilson and Sheu's factor, and ln of the inlet's viscosity over the thinned one, (..., 2)."""
    warm = -np.log(wilson_sheu(heat.loading, np.minimum(heat.sliding, MOST_SLIDING)))
    given = np.asarray(heat.shear, float)
    small = np.minimum(given, LEAST_SHEAR)
    thin = np.where(given < LEAST_SHEAR, small**2 / 6, np.log(given / np.arcsinh(given)))
    return np.stack(np.broadcast_arrays(warm, thin), axis=-1)


MOST_SLIDING = 2.0
"""Slide-roll ratio beyond which Wilson and Sheu's factor is that of this one."""


def exponents(kept: Array, constants: Mapping[str, Array]) -> Array:
    """a and b, exponents of the shares of heat and thinning in both films, (..., film, share)."""
    hidden = np.tanh(kept @ constants["inner"] + constants["inner_bias"])
    out = hidden @ constants["outer"] + kept @ constants["straight"] + constants["bias"]
    exponents: Array = out.reshape(*out.shape[:-1], 2, 2)
    return exponents


@cache
def _constants() -> HeatConstants:
    content = json.loads(
        files("pyworm.formulas").joinpath("film_reduction.json").read_text("utf-8")
    )
    return {
        "low": np.asarray(content["low"]),
        "high": np.asarray(content["high"]),
        "slope": np.asarray(content["slope"]),
        "level": np.asarray(content["level"]),
        "films": {name: np.asarray(values) for name, values in content["films"].items()},
    }
