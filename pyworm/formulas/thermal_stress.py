"""Thermal stress in a half-space whose surface temperature is steady as seen from the contact.

Heat moves with the body at a velocity V and by conduction, V.grad T = kappa lap T (Carslaw and Jaeger 1959).
A wave of the surface temperature decays with depth by s, s^2 = k^2 + i k.V/kappa; Goodier's potential of
thermoelastic displacement is (1 + nu) alpha T/((1 - nu)(s^2 - k^2)), and an isothermal field frees the
surface of its tractions (Boley and Weiner 1960). Inertia and the heat of deformation are neglected.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from pyworm.formulas.arrays import Array
from pyworm.formulas.plane_waves import Amplitudes, Waves, WaveStress

MEAN_NUMBER = 1e-6
"""Wave number of the mean temperature over that of the longest wave: as good as none."""


@dataclass(frozen=True)
class ThermalSolid:
    """What the thermal stress of a body depends on."""

    youngs_modulus: float
    """Young's modulus [Pa]."""
    poisson_ratio: float
    """Poisson's ratio [-]."""
    expansion: float
    """Linear thermal expansion [1/K]."""
    diffusivity: float
    """Thermal diffusivity [m2/s]."""
    bulk_temperature: float
    """Temperature far below the surface, where there is no thermal stress [K]."""

    @property
    def restrained(self) -> float:
        """Pressure along the surface of a body that is warmed and cannot expand along it [Pa/K]."""
        return self.youngs_modulus * self.expansion / (1 - self.poisson_ratio)


def thermal_stress(
    rise: Array,
    spacing: Sequence[float],
    velocity: Sequence[float],
    solid: ThermalSolid,
    depths: npt.ArrayLike,
) -> Array:
    """Stress [Pa] of a rise of the surface temperature, along the first axes components and depths.

    Components are xx, yy, zz, xy, xz, yz, z points into the body. The rise repeats periodically: it needs
    room around it that is not heated.

    Args:
        rise: Surface temperature above that far below [K], shape (nx, ny), or (nx,) of a line contact in
            plane strain.
        spacing: Grid spacing along each direction [m].
        velocity: Velocity of the body's material past the contact along each direction [m/s].
        solid: The body.
        depths: Depths [m].
    """
    waves = Waves(rise.shape, spacing)
    mean, k = (0,) * rise.ndim, waves.number.copy()
    longest = float(k[k > 0].min())
    k[mean] = MEAN_NUMBER * longest
    carried = sum(part * speed for part, speed in zip(waves.numbers, velocity, strict=True))
    # the mean is heated for as long as the longest wave takes to pass
    carried[mean] = longest * float(np.linalg.norm(velocity))
    s = np.sqrt(k**2 + 1j * carried / solid.diffusivity)
    amplitude = solid.restrained * waves.spectrum(rise)
    found = [
        waves.stress(_below(amplitude, k, s, depth, solid.poisson_ratio))
        for depth in np.atleast_1d(depths)
    ]
    return np.stack(found, axis=1)


def _below(
    amplitude: Amplitudes, k: Array, s: Amplitudes, z: float, poisson_ratio: float
) -> WaveStress:
    """Stress at a depth below waves of E alpha T/(1 - nu), written so that steady heat, s = k, is its limit.

    Particular and isothermal part share exp(-k z); `depth` is (1 - exp(-(s - k) z))/(s - k), z where s = k.
    """
    difference = s - k
    at_rest = np.abs(difference) * max(z, 1e-300) < 1e-8
    depth = np.where(at_rest, z, -np.expm1(-difference * z) / np.where(at_rest, 1, difference))
    scale = amplitude / (s + k) * np.exp(-k * z)
    return WaveStress(
        along=scale * (s**2 * depth - difference - k**2 * z),
        across=2 * poisson_ratio * k * scale - amplitude * np.exp(-s * z),
        normal=scale * k**2 * (z - depth),
        shear=1j * k * scale * (s * depth - k * z),
    )
