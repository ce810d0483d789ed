"""Pressure far from a point contact, where the film is the undeformed gap and the viscosity is ambient.

For h = x^2/2Rx + y^2/2Ry and D = Rx/Ry the exact solution

    p = -4 eta (u x / (1 + 2D/3) + v y / (1 + 2/3D)) / h^2

falls with the cube of the distance; whatever the contact itself adds falls with its sixth power (circular
contact: r^k cos(m phi) with k = -3 - sqrt(9 + m^2)). It is the boundary condition of the outermost grid.
"""

from dataclasses import dataclass

import numpy as np

from pyworm.formulas.arrays import Array, Flags
from pyworm.planning.grid import Grid
from pyworm.scene.point import Scene


@dataclass(frozen=True)
class FarField:
    """Far field beyond a grid."""

    outline: Array
    """True on the grid's outline, shape (nx, ny)."""
    pressure: Array
    """Pressure on the outline [Pa], zero within, shape (nx, ny)."""
    load: float
    """Load that the pressure beyond the outline carries [N]."""


def far_field(scene: Scene, grid: Grid, film: Array, covered: Flags) -> FarField:
    """The far field of a rigid film beyond a grid, of a film [m] known roughly on the outline."""
    x, y = grid.mesh()
    outline = np.zeros(film.shape, dtype=bool)
    outline[[0, -1], :] = outline[:, [0, -1]] = True
    wet = outline & covered & (film > 0)
    if scene.oil.supply is not None:
        wet &= film <= scene.supply_at(x, y)
    u, v = (float(component) for component in scene.entrainment(np.zeros(()), np.zeros(())))
    ratio = scene.radii[0] / scene.radii[1]
    wedge = u * x / (1 + 2 * ratio / 3) + v * y / (1 + 2 / (3 * ratio))
    pressure = np.zeros(film.shape, order="F")
    pressure[wet] = np.maximum(-4 * scene.oil.viscosity.eta0 * wedge[wet] / film[wet] ** 2, 0.0)
    # along every ray p r^3 is constant: the load beyond is the integral of p (x dy - y dx) along the outline
    load = sum(
        float((pressure[side] * np.abs(distance[side])).sum()) * step
        for side, distance, step in (
            (np.s_[0, :], x, grid.dy),
            (np.s_[-1, :], x, grid.dy),
            (np.s_[:, 0], y, grid.dx),
            (np.s_[:, -1], y, grid.dx),
        )
    )
    return FarField(outline, pressure, load)
