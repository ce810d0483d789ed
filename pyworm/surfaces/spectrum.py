"""Spectra of profiles: power spectral density over the wavenumber."""

import numpy as np
import scipy

from pyworm.formulas.arrays import Array
from pyworm.surfaces.profile import Profile

SPECTRUM_PARTS, LEAST_POINTS = 8, 64
"""Parts of a profile's length, overlapping by half, over which its spectrum is averaged, and their least
number of points."""


def spectrum(profile: Profile, points: int | None = None) -> tuple[Array, Array]:
    """Wavenumbers 2 pi/l [1/m] and spectral density [m3] of a profile, whose integral is Rq^2.

    It is averaged over parts of so many points, by default `SPECTRUM_PARTS` of them, under Hann's window
    (P. D. Welch, IEEE Trans. Audio Electroacoust. 15 (1967) 70); waves longer than a part are not in it.
    """
    usual = max(LEAST_POINTS, len(profile.height) // SPECTRUM_PARTS)
    length = min(len(profile.height), points or usual)
    frequency, density = scipy.signal.welch(
        profile.height,
        fs=2 * np.pi / profile.spacing,
        nperseg=length,
        noverlap=length // 2,
        detrend="constant",
    )
    return frequency[1:], density[1:]
