"""Shear of a Newtonian film in closed form."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyworm.solver.figures import Array


@dataclass(frozen=True)
class NewtonianShear:
    """Shear of a Newtonian film of one temperature.

    Attributes
    ----------
    stress : tuple of numpy.ndarray
        Stress in the middle of the film along each direction, of body 1 on the oil [Pa].
    friction : numpy.ndarray
        Heat made by it for each area [W/m2].
    rate : numpy.ndarray
        Largest shear rate across the film [1/s].
    """

    stress: tuple[Array, ...]
    friction: Array
    rate: Array


def newtonian_shear(
    viscosity: Array, film: Array, sliding: Sequence[Array], slopes: Sequence[Array]
) -> NewtonianShear:
    """Couette flow by the sliding [m/s] and Poiseuille flow by the pressure's slopes [Pa/m].

    tau = eta us/h + z dp/dx, the heat eta us^2/h + h^3/(12 eta) |grad p|^2 (Hamrock 1994, chapter 7).
    """
    couette = [viscosity * speed / film for speed in sliding]
    poiseuille = sum(slope**2 for slope in slopes)
    heat = sum(stress * speed for stress, speed in zip(couette, sliding, strict=True))
    walls = [
        sum((c + side * film / 2 * s) ** 2 for c, s in zip(couette, slopes, strict=True))
        for side in (-1, 1)
    ]
    return NewtonianShear(
        tuple(-stress for stress in couette),
        heat + film**3 / (12 * viscosity) * poiseuille,
        np.sqrt(np.maximum(*walls)) / viscosity,
    )
