"""Parameters of a roughness profile by ISO 21920-2."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.surfaces.parameters import core
from pyworm.surfaces.profile import Profile

LEAST_HEIGHT = 0.1
"""Height of a peak above, or depth of a valley below the mean line from which it counts for the mean width of
profile elements, over Rz (vertical discrimination of ISO 4287, kept from memory)."""


@dataclass(frozen=True)
class ProfileFigures:
    """Parameters of a profile."""

    rq: float
    """Root mean square height Rq [m]."""
    ra: float
    """Arithmetic mean height Ra [m]."""
    rz: float
    """Height from the lowest to the highest point, mean of the sections, Rz [m]."""
    rt: float
    """Height from the lowest to the highest point of all, Rt [m]."""
    rp: float
    """Highest point, mean of the sections, Rp [m]."""
    rv: float
    """Depth of the lowest point, mean of the sections, Rv [m]."""
    skewness: float
    """Rsk [-]."""
    kurtosis: float
    """Rku [-]."""
    rk: float
    """Core height Rk [m]."""
    rpk: float
    """Reduced peak height Rpk [m]."""
    rvk: float
    """Reduced valley height Rvk [m]."""
    mr1: float
    """Lower end of the core on the Abbott curve, Rmrk1 [-]."""
    mr2: float
    """Upper end of the core on the Abbott curve, Rmrk2 [-]."""
    slope: float
    """Root mean square slope Rdq [-]."""
    width: float
    """Mean width of profile elements Rsm [m]; NaN where the profile has no whole one."""
    correlation_length: float
    """Distance at which the autocorrelation has fallen to 0.5 [m]."""


def profile_figures(profile: Profile) -> ProfileFigures:
    """Parameters of a profile, of its measured points alone."""
    height = profile.height[profile.measured]
    height = height - height.mean()
    rq = float(height.std())
    peaks, valleys = (
        [float(extreme(section)) for section in profile.sections] for extreme in (np.max, np.min)
    )
    rp, rv = float(np.mean(peaks)), -float(np.mean(valleys))
    return ProfileFigures(
        rq=rq,
        ra=float(np.abs(height).mean()),
        rz=rp + rv,
        rt=float(np.ptp(height)),
        rp=rp,
        rv=rv,
        skewness=float((height**3).mean() / rq**3),
        kurtosis=float((height**4).mean() / rq**4),
        **core(height),
        slope=_slope(profile),
        width=_width(profile, LEAST_HEIGHT * (rp + rv)),
        correlation_length=correlation_length([profile], 0.5),
    )


def _slope(profile: Profile) -> float:
    both = profile.measured[1:] & profile.measured[:-1]
    steps = np.diff(profile.height)[both] / profile.spacing
    return float(np.sqrt(np.mean(steps**2)))


def _width(profile: Profile, least: float) -> float:
    """Mean distance of upward crossings between a valley and a peak that are both as far from the mean line.

    A crossing counts from the last point below -least to the first one above it.
    """
    height = profile.height
    side = np.where(height > least, 1, np.where(height < -least, -1, 0))
    places = np.flatnonzero(side)
    turned = places[1:][(side[places[1:]] == 1) & (side[places[:-1]] == -1)]
    if len(turned) < 2:
        return float("nan")
    return float((turned[-1] - turned[0]) / (len(turned) - 1) * profile.spacing)


def correlation_length(profiles: Sequence[Profile], level: float) -> float:
    """Distance [m] at which the mean autocorrelation of profiles of one spacing falls to a level.

    Half their length where it does not.
    """
    count = min(len(profile.height) for profile in profiles)
    spacing = profiles[0].spacing
    mean: Array = np.mean([_autocorrelation(profile)[: count // 2] for profile in profiles], axis=0)
    below = np.flatnonzero(mean <= level * mean[0])
    if not below.size:
        return count // 2 * spacing
    after = int(below[0])
    high, low = mean[after - 1] / mean[0], mean[after] / mean[0]
    return float((after - 1 + (high - level) / (high - low)) * spacing)


def _autocorrelation(profile: Profile) -> Array:
    """Mean products of heights [m2] over their distance, of pairs of measured points."""
    size = 2 * len(profile.height)
    raw, pairs = (
        np.fft.irfft(np.abs(np.fft.rfft(field, size)) ** 2, size)[: len(profile.height)]
        for field in (
            np.where(profile.measured, profile.height, 0.0),
            profile.measured.astype(float),
        )
    )
    products: Array = raw / np.maximum(pairs, 1.0)
    return products
