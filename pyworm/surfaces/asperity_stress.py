"""Fatigue of the layer below asperities: a rough counterface, pressed on, slides over a body.

Its periodic cell bears the mean pressure of the film's asperities; below them the stress is that of periodic
waves. The stress of the whole contact is not in it: it changes little over the depth of the layer.
"""

from dataclasses import dataclass
from math import inf

import numpy as np
from scipy.optimize import brentq

from pyworm.formulas.arrays import Array
from pyworm.formulas.fatigue import dang_van
from pyworm.formulas.layered_half_space import Layer, wave_stress
from pyworm.kernel.rough_cell import press
from pyworm.materials.body import Body
from pyworm.materials.fatigue_strength import FatigueStrength
from pyworm.materials.topography import Topography

DEPTHS = np.geomspace(0.5, 16.0, 8)
"""Depths over the distance of points."""

MOST_TRACKS = 48
"""Tracks along the sliding whose material is judged at most."""

GAP_TOLERANCE = 1e-3
"""Gap left in the contact over the roughness, root mean square."""

MAX_SEPARATION, MIN_SEPARATION, MIN_YIELDED_SEPARATION = 6.0, 0.05, -2.0
"""Separations of the mean planes over the roughness: the largest, the least of elastic and of yielding
ones."""


@dataclass(frozen=True)
class AsperityLayer:
    """The layer below asperities that slide over it."""

    depths: Array
    """Depths [m]."""
    ratio: Array
    """Largest of Dang Van's stress over its limit at each depth [-]: above 1 micropits form."""
    area: float
    """Real area of the contact over the nominal one."""
    pressure_max: float
    """Largest pressure of an asperity [Pa]."""

    @property
    def safety(self) -> float:
        """Least limit over stress in the layer [-]."""
        return float(1 / self.ratio.max())


def asperity_layer(
    cell: Topography,
    mean_pressure: float,
    body: Body,
    strength: FatigueStrength,
    reduced_modulus: float,
    friction: float = 0.1,
) -> AsperityLayer:
    """Dang Van's stress below a rough cell that slides along its x axis over a smooth body.

    Args:
        cell: A periodic cell of the counterface, both roughnesses together.
        mean_pressure: Mean pressure of the asperities [Pa].
        body: The body below.
        strength: What it endures.
        reduced_modulus: E' of both bodies [Pa].
        friction: Friction coefficient of asperities [-].

    Raises:
        ValueError: A pressure that the cell does not reach.
        KernelError: The contact of the cell did not converge.
    """
    hardness = inf if body.hardness is None else body.hardness
    pressure = _pressed(cell, mean_pressure, reduced_modulus, hardness)
    acting = pressure, friction * pressure, np.zeros_like(pressure)
    half_space = Layer(1.0, (body.youngs_modulus,) * 2, (body.poisson_ratio,) * 2)
    depths = DEPTHS * min(cell.spacing)
    tracks = slice(None, None, -(-pressure.shape[1] // MOST_TRACKS))
    worst = []
    for depth in depths:
        history = wave_stress(acting, cell.spacing, half_space, float(depth))[:, :, tracks]
        residual = strength.residual(np.array([depth]))[0]
        worst.append(dang_van(history, strength.slope, residual).max())
    return AsperityLayer(
        depths,
        np.array(worst) / strength.limit(depths),
        float((pressure > 0).mean()),
        float(pressure.max()),
    )


def _pressed(cell: Topography, wanted: float, modulus: float, hardness: float) -> Array:
    """Pressures of the cell under a mean pressure [Pa]."""
    rough, bound = cell.rms, min(hardness, 1e6 * modulus)

    def at(separation: float) -> Array:
        height = cell.height
        return press(
            height, cell.spacing, modulus, separation * rough, bound, GAP_TOLERANCE * rough
        )[0]

    closest = MIN_SEPARATION if np.isinf(hardness) else MIN_YIELDED_SEPARATION
    reached = float(at(closest).mean())
    if not 0 < wanted < reached:
        raise ValueError(
            f"mean_pressure = {wanted:.3g}: must lie above 0 and below {reached:.3g} Pa of this surface"
        )
    found = brentq(
        lambda away: np.log(max(at(away).mean(), 1e-12 * wanted) / wanted),
        closest,
        MAX_SEPARATION,
        xtol=1e-3,
    )
    return at(float(found))
