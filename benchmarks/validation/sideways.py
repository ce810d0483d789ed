"""What equation 19 of Sharif et al. (2001) misses in slender contacts crossed the long way: conduction aside.

Largest rise of a fast surface under a flux of Hertz's shape, by conduction into depth alone and with the
spread of heat across the path, of variance 2 kappa t. Run from the repository's root:

    python benchmarks/validation/sideways.py
"""

import numpy as np
from numpy.polynomial.hermite_e import hermegauss

from pyworm.materials.body import Body

INSTANTS = 2000
"""Points of the integral over past times."""

STEEL = Body(207e9, 0.3, density=7900, conductivity=47, specific_heat=477)
BRONZE = Body(120e9, 0.35, density=8800, conductivity=52, specific_heat=420)

CONTACTS = (
    ("10:1, U a/kappa = 1000", 10.0, 1.0, 100.0, 1.0),
    ("the worm's, steel at 5.8 m/s", 10.78e-3, 1.169e-3, 5.8, STEEL),
    ("the worm's, bronze at 0.7 m/s", 10.78e-3, 1.169e-3, 0.7, BRONZE),
)
"""Name, half length along the motion and across it [m], speed [m/s], diffusivity [m2/s] or body."""


def diffusivity(of: Body | float) -> float:
    """Diffusivity [m2/s]."""
    return of.conductivity / (of.density * of.specific_heat) if isinstance(of, Body) else of


def largest_rise(along: float, across: float, speed: float, kappa: float, spread: bool) -> float:
    """Largest rise on the middle line, in units that both models share."""
    nodes, weights = hermegauss(40) if spread else (np.zeros(1), np.ones(1))
    weights = weights / weights.sum()
    rises = []
    for place in np.linspace(-1, 1, 81):
        # time since a point of the surface was heated, as a square, which takes the root's singularity away
        root = (np.arange(INSTANTS) + 0.5) / INSTANTS * np.sqrt((place + 1) * along / speed)
        x = place - speed * root**2 / along
        y = np.sqrt(2 * kappa) * root[:, None] / across * nodes
        flux = np.sqrt(np.maximum(0.0, 1 - x[:, None] ** 2 - y**2)) @ weights
        rises.append(2 * np.sqrt((place + 1) * along / speed) * flux.mean())
    return max(rises)


def main() -> None:
    for name, along, across, speed, of in CONTACTS:
        depth, sideways = (
            largest_rise(along, across, speed, diffusivity(of), spread) for spread in (False, True)
        )
        print(f"{name:32} equation 19 alone is {depth / sideways - 1:.1%} too hot")


if __name__ == "__main__":
    main()
