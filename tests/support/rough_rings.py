"""A dry rough contact of revolution solved on rings, by itself: what films of slow contacts become.

Greenwood and Tripp, The elastic contact of rough spheres, J. Appl. Mech. 34 (1967) 153: pressure of the
asperities by the gap, deflection of the half-space by the pressure, both at once by Newton's method.
"""

from itertools import pairwise

import numpy as np
import scipy

from pyworm.materials.rough_surfaces import RoughPair


def dry_rough_pressure(
    pair: RoughPair, radius: float, load: float, modulus: float, reach: float, rings: int = 300
) -> tuple[np.ndarray, np.ndarray]:
    """Radii of rings [m] up to a reach and the pressure on them [Pa].

    `radius` is the relative radius [m], `modulus` the reduced E' [Pa].
    """
    edges = np.linspace(0, reach, rings + 1)
    middle = (edges[1:] + edges[:-1]) / 2
    influence = np.column_stack(
        [_disc(after, middle) - _disc(before, middle) for before, after in pairwise(edges)]
    )
    influence *= 2 / (np.pi * modulus)
    area = np.pi * np.diff(edges**2)
    gap = middle**2 / (2 * radius)
    pressure, rigid = np.zeros(rings), 3 * pair.height
    step = 1e-4 * pair.height
    for _ in range(400):
        film = rigid + gap + influence @ pressure
        bearing, beyond = (pair.contact(h / pair.height)[0] for h in (film, film + step))
        slope = (beyond - bearing) / step
        system = np.zeros((rings + 1, rings + 1))
        system[:rings, :rings] = np.eye(rings) - slope[:, None] * influence
        system[:rings, rings] = -slope
        system[rings, :rings] = area
        missing = np.append(bearing - pressure, load - area @ pressure)
        change = np.linalg.solve(system, missing)
        damping = min(1.0, pair.height / max(abs(change[rings]), 1e-30))
        pressure = np.maximum(pressure + damping * change[:rings], 0.0)
        rigid += damping * change[rings]
        if np.abs(missing[:rings]).max() < 1e-9 * pressure.max() and damping == 1:
            return middle, pressure
    raise ArithmeticError("the dry rough contact did not converge")


def _disc(edge: float, radius: np.ndarray) -> np.ndarray:
    """Integral of 1/distance over a disc, at radii in its plane, by elliptic integrals (Love 1929)."""
    if edge == 0:
        return np.zeros_like(radius)
    inside = radius < edge
    m = np.where(inside, (radius / edge) ** 2, (edge / radius) ** 2)
    second, first = scipy.special.ellipe(m), scipy.special.ellipk(m)
    return np.where(inside, 4 * edge * second, 4 * radius * (second - (1 - m) * first))
