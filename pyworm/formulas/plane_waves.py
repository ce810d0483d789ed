"""Plane waves of tractions and temperatures on the surface of a half-space, by the fast Fourier transform.

A field on a grid is a sum of waves exp(i (kx x + ky y)). Below each the stress is one of plane strain along
the wave, and of antiplane shear across it; `Waves.stress` turns it to the grid's axes and sums it.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt
import scipy

from pyworm.formulas.arrays import Array

Amplitudes = npt.NDArray[Any]
"""Amplitudes of waves, complex or real."""


@dataclass(frozen=True)
class WaveStress:
    """Amplitudes of the stress below each wave; x' is along the wave, y' across it, z into the body."""

    along: Amplitudes
    """sigma_x'x'."""
    across: Amplitudes
    """sigma_y'y'."""
    normal: Amplitudes
    """sigma_zz."""
    shear: Amplitudes
    """sigma_x'z."""
    twist: Amplitudes | float = 0.0
    """sigma_x'y'."""
    antiplane: Amplitudes | float = 0.0
    """sigma_y'z."""


class Waves:
    """Waves on a grid of nodes, repeated periodically."""

    def __init__(self, shape: Sequence[int], spacing: Sequence[float]):
        self.shape = tuple(shape)
        """Number of nodes along each direction, one or two of them."""
        last = len(self.shape) - 1
        axes = [
            2 * np.pi * (np.fft.rfftfreq if axis == last else np.fft.fftfreq)(count, step)
            for axis, (count, step) in enumerate(zip(self.shape, spacing, strict=True))
        ]
        self.numbers = tuple(np.meshgrid(*axes, indexing="ij"))
        """Wave numbers along each direction of the grid [1/m]."""
        self.number = np.sqrt(sum(part**2 for part in self.numbers))
        """Wave number of each wave [1/m]."""

    def spectrum(self, field: Array) -> Amplitudes:
        """Amplitudes of a field."""
        return np.asarray(scipy.fft.rfftn(field))

    def field(self, spectrum: Amplitudes) -> Array:
        """Field of amplitudes."""
        return np.asarray(scipy.fft.irfftn(spectrum, self.shape))

    @cached_property
    def directions(self) -> tuple[Array, Array]:
        """Cosine and sine of each wave's angle from the grid's first direction; 1 and 0 of the mean."""
        number = np.where(self.number > 0, self.number, 1.0)
        cosine = np.where(self.number > 0, self.numbers[0] / number, 1.0)
        sine = self.numbers[1] / number if len(self.numbers) > 1 else np.zeros(number.shape)
        return cosine, sine

    def stress(self, waves: WaveStress) -> Array:
        """Stress at the nodes, xx, yy, zz, xy, xz and yz along the first axis."""
        c, s = self.directions
        along, across, twist = waves.along, waves.across, waves.twist
        spectra = (
            c**2 * along + s**2 * across - 2 * c * s * twist,
            s**2 * along + c**2 * across + 2 * c * s * twist,
            waves.normal,
            c * s * (along - across) + (c**2 - s**2) * twist,
            c * waves.shear - s * waves.antiplane,
            s * waves.shear + c * waves.antiplane,
        )
        return np.stack([self.field(spectrum) for spectrum in spectra])
