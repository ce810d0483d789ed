"""What heat takes from a film."""

import numpy as np


def wilson_sheu(viscosity, temperature_coefficient, conductivity, velocity_1, velocity_2):
    """Film heated in its inlet over the isothermal one, 1 / [1 + 0.241 (1 + 14.8 Z^0.83) L^0.64].

    Z = |u1 - u2| / |u1 + u2| and L = eta0 beta um^2 / k with the mean velocity um.

    Source: W. R. D. Wilson and S. Sheu, J. Lubr. Technol. 105 (1983) 187-188. Range: line contacts, Z up to
    1; nothing is lost below L = 0.1.

    Parameters
    ----------
    viscosity : float
        eta0 at the inlet [Pa s].
    temperature_coefficient : float
        beta = -d ln eta / dT [1/K].
    conductivity : float
        Of the oil [W/(m K)].
    velocity_1, velocity_2 : float or array
        Surface velocities across the line [m/s].
    """
    mean = np.abs(velocity_1 + velocity_2) / 2
    loading = viscosity * temperature_coefficient * mean**2 / conductivity
    ratio = np.abs(velocity_1 - velocity_2) / (2 * mean)
    return 1 / (1 + 0.241 * (1 + 14.8 * ratio**0.83) * loading**0.64)
