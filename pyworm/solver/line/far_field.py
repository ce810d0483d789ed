"""Oil pressure before the inlet end of a line contact's grid.

Far from the contact viscosity and density are the ambient ones and pressure is too small to deform anything,
so that the film there is known, and Reynolds' equation with its flow u h* (h* the film where the pressure is
largest) is an integral,

    p(x) = int 12 eta0 u (h - h*) / h^3 dx from afar to x.

For h = x^2/2R it is 4 eta0 u (2R)^2 / |x|^3 to leading order. Under Barus' law the integral is exactly
[1 - exp(-alpha p)] / alpha.
"""

from dataclasses import dataclass
from math import log1p

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.planning.line_grid import LineGrid
from pyworm.scene.line import LineScene

POINTS = 24
"""Points of Gauss and Legendre over the reciprocal distance, in which the integrands are smooth."""

LARGEST_REDUCED = 0.9
"""Upper bound of alpha times the integral: at 1 the pressure is infinite."""


@dataclass(frozen=True)
class LineFarField:
    """Far field before the inlet end of a grid."""

    pressure: float
    """Pressure at the inlet node [Pa]."""
    load: float
    """Load for each length that the pressure beyond it carries [N/m]."""


def line_far_field(scene: LineScene, grid: LineGrid, pressure: Array, film: Array) -> LineFarField:
    """The far field before a grid's inlet end, of a pressure [Pa] and a film [m] known roughly."""
    x = grid.x
    inlet = 0 if scene.entrainment > 0 else -1
    if not scene.gap(x[[inlet]])[1][0]:
        return LineFarField(0.0, 0.0)
    viscosity, density = scene.oil.viscosity, scene.oil.density
    peak = np.argmax(pressure)
    flow = density(pressure[peak]) / density(0.0) * film[peak]
    if scene.oil.supply is not None and scene.supply_at(x[[inlet]])[0] < flow:
        return LineFarField(0.0, 0.0)  # no oil is turned back so far out

    nodes, weights = np.polynomial.legendre.leggauss(POINTS)
    fraction = (nodes + 1) / 2
    far = x[inlet] / fraction
    thickness = film[inlet] + (far**2 - x[inlet] ** 2) / (2 * scene.radius)
    thickness += _deflection(scene, far, grid, pressure)
    thickness -= _deflection(scene, x[[inlet]], grid, pressure)
    slope = 12 * viscosity.eta0 * abs(scene.entrainment) * (thickness - flow) / thickness**3
    steps = weights / 2 * abs(x[inlet]) / fraction**2
    reduced = max(float(slope @ steps), 0.0)
    # by parts: the integral of pressure is that of its slope times the distance from the inlet
    load = float((slope * abs(far - x[inlet])) @ steps)
    if not viscosity.alpha > 0:
        return LineFarField(reduced, max(load, 0.0))
    believed = min(viscosity.alpha * reduced, LARGEST_REDUCED)
    # alpha/2 times the squared integral, which falls with the sixth power of the distance
    stiffening = viscosity.alpha * reduced**2 * abs(x[inlet]) / 10
    return LineFarField(-log1p(-believed) / viscosity.alpha, max(load, 0.0) + stiffening)


def _deflection(scene: LineScene, places: Array, grid: LineGrid, pressure: Array) -> Array:
    """Deflection [m], up to a constant, beyond a grid, with the pressure of each cell as a line load."""
    distance = np.maximum(abs(places[:, None] - grid.x[None, :]), grid.dx / 2)
    return -4 * grid.dx / (np.pi * scene.bending_modulus) * np.log(distance) @ pressure
