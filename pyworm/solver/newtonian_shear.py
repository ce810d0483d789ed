"""Shear of a Newtonian film in closed form."""

from collections.abc import Sequence

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.kernel.film import Shear


def newtonian_shear(
    viscosity: Array, film: Array, sliding: Sequence[Array], slopes: Sequence[Array]
) -> Shear:
    """Shear of Couette flow by the sliding [m/s] and Poiseuille flow by the pressure gradient [Pa/m].

    tau = eta us/h + z dp/dx, the heat eta us^2/h + h^3/(12 eta) |grad p|^2 (Hamrock 1994, chapter 7).
    """
    couette = [viscosity * speed / film for speed in sliding]
    poiseuille = sum(slope**2 for slope in slopes)
    heat = sum(stress * speed for stress, speed in zip(couette, sliding, strict=True))
    at_body_1, at_body_2 = (
        sum((c + side * film / 2 * s) ** 2 for c, s in zip(couette, slopes, strict=True))
        for side in (-1, 1)
    )
    return Shear(
        tuple(-stress for stress in couette),
        heat + film**3 / (12 * viscosity) * poiseuille,
        np.sqrt(np.maximum(at_body_1, at_body_2)) / viscosity,
    )
