"""A rough surface with the spectrum, lay and height distribution of profiles across and along its lay.

Waves of the surface are those of an elliptic spectrum, of circles stretched along the lay by the aspect: its
density C2 depends on k, k^2 = (aspect kx)^2 + ky^2. A profile across the lay sees the integral of C2 over kx,
an integral equation of Abel's kind, solved here by least squares of densities that are not negative, so that
the scatter of a measured spectrum leads to no negative one. Phases are random, and heights are then given
the distribution of the profiles', in turns with the spectrum (T. Schreiber and A. Schmitz, Phys. Rev. Lett.
77 (1996) 635).
"""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import scipy

from pyworm.formulas.arrays import Array
from pyworm.materials.topography import Topography
from pyworm.surfaces.plateau import heights_on_one_datum, plateau_share
from pyworm.surfaces.profile import PART_COUNT, Profile
from pyworm.surfaces.profile_parameters import correlation_length
from pyworm.surfaces.spectrum import spectrum

NODES = 512
"""Points along each side of the surface."""

LENGTHS = 24.0
"""Correlation lengths along each side at least, as of cells cut from areas (`surfaces.cell`)."""

HATS = 40
"""Wavenumbers, evenly spaced in the logarithm, between which the density of the surface is interpolated."""

TURNS = 25
"""Turns of height distribution and spectrum."""

WEIGHTINGS = 4
"""Rounds of the weights of the densities' fit. What is measured scatters by a share of the density; weighed
by the measured one itself the lowest count most, and slopes are up to 40 % off."""

LEAST_DENSITY = 1e-6
"""Part of the largest density below which a weight rises no further."""

ROUNDS = 5
"""Rounds of the aspect and the nesting index of the profiles along the lay."""

ASPECTS = 1 / 9, 9.0
"""Least and largest aspect."""

PEKLENIK = 0.5
"""Autocorrelation at which lengths along and across give the aspect."""


def lay_aspect(across: Sequence[Profile], along: Sequence[Profile]) -> float:
    """Correlation length along the lay over that across, of profiles in both directions, within `ASPECTS`."""
    length, width = (correlation_length(profiles, PEKLENIK) for profiles in (along, across))
    return float(np.clip(length / width, *ASPECTS))


def profiles_along(
    prepared: Callable[[float | None], Sequence[Profile]], across: Sequence[Profile]
) -> Sequence[Profile]:
    """Profiles along the lay, prepared by a nesting index that is the aspect times that of those across.

    A wave across the lay is as many times longer along it: one index for both would take the long waves from
    the profiles along it alone, and make the aspect 12 % less on the mean of twenty surfaces. `prepared`
    makes the profiles by an index [m], or None; the aspect follows in `ROUNDS`.
    """
    index = across[0].nesting_index
    along = prepared(index)
    if index is not None:
        for _ in range(ROUNDS):
            along = prepared(index * lay_aspect(across, along))
    return along


def sampled_surface(
    across: Sequence[Profile], along: Sequence[Profile], given: float | None, seed: int
) -> Topography:
    """A surface of profiles, with `Topography.samples` by parts of their length; as `surface_of_profiles`.

    The aspect is that given, or that of profiles along the lay.
    """
    samples, share = [], plateau_share(across)
    for number in range(PART_COUNT):
        part, lay_part = ([profile.parts[number] for profile in some] for some in (across, along))
        aspect = given if given is not None else lay_aspect(part, lay_part)
        samples.append(surface_of_profiles(part, aspect, seed + 1 + number, NODES // 2, share))
    aspect = given if given is not None else lay_aspect(across, along)
    return replace(surface_of_profiles(across, aspect, seed, plateau=share), samples=tuple(samples))


def surface_of_profiles(
    across: Sequence[Profile],
    aspect: float,
    seed: int,
    nodes: int = NODES,
    plateau: float | None = None,
) -> Topography:
    """A periodic surface [m], its lay along x, with spectrum and heights of profiles across the lay.

    `aspect` is the correlation length along the lay over that across; another `seed` gives another surface of
    the same statistics. Points are those of the profile with the widest spacing, or every second, third or
    so, where `nodes` would not hold `LENGTHS` correlation lengths. `plateau` is the `plateau_share` of what
    the profiles are parts of, by default their own.
    """
    step = max(profile.spacing for profile in across)
    width = correlation_length(across, PEKLENIK)
    step *= max(1, int(np.ceil(LENGTHS * width / (nodes * step))))
    spacing = step * aspect, step
    density = _density(across, step, nodes)
    kx, ky = (2 * np.pi * np.fft.fftfreq(nodes, distance) for distance in spacing)
    stretched = np.hypot(aspect * kx[:, None], ky[None, :])
    amplitude = np.sqrt(density(stretched))
    heights = heights_on_one_datum(across, plateau_share(across) if plateau is None else plateau)
    rank = np.quantile(heights, (np.arange(nodes * nodes) + 0.5) / (nodes * nodes))
    height = np.random.default_rng(seed).standard_normal((nodes, nodes))
    for _ in range(TURNS):
        phase = scipy.fft.rfft2(height)
        phase /= np.maximum(np.abs(phase), 1e-300)
        height = scipy.fft.irfft2(phase * amplitude[:, : phase.shape[1]], s=height.shape)
        order = height.ravel().argsort(kind="stable")
        height.ravel()[order] = rank
    return Topography(height - height.mean(), spacing, periodic=True)


def _density(across: Sequence[Profile], step: float, nodes: int) -> Callable[[Array], Array]:
    """Density of the surface's waves over their stretched wavenumber [1/m], but for a factor."""
    least, most = 2 * np.pi / (nodes * step), np.pi / step
    k: Array = least * np.arange(1.0, nodes // 2 + 1)
    measured = np.mean([_resampled(profile, k) for profile in across], axis=0)
    marks = np.log(np.geomspace(least, np.sqrt(2) * most, HATS))
    # the profile's density at ky: the sum over all kx, those of the stretched circle
    stretched = np.hypot(np.concatenate([[0.0], k, k])[:, None], k[None, :])
    seen = np.array(
        [_hat(marks, number, np.log(stretched)).sum(axis=0) for number in range(HATS)]
    ).T
    scale, found, expected = measured.mean(), np.zeros(HATS), measured
    for _ in range(WEIGHTINGS):
        weight = 1 / np.maximum(expected, measured.max() * LEAST_DENSITY)
        found, _ = scipy.optimize.nnls(seen * weight[:, None] * scale, measured * weight)
        expected = seen @ found * scale

    def density(wavenumber: Array) -> Array:
        inside = wavenumber >= least * (1 - 1e-9)
        logarithm = np.log(np.where(inside, wavenumber, least))
        values: Array = np.where(inside, np.interp(logarithm, marks, found, right=0.0), 0.0)
        return values

    return density


def _hat(marks: Array, number: int, place: Array) -> Array:
    """The function that is one at a mark, zero at the others and linear between them."""
    return np.interp(place, marks, np.eye(len(marks))[number], right=0.0)


def _resampled(profile: Profile, k: Array) -> Array:
    """Density of a profile [m3] at wavenumbers, means over a wavenumber's share where it has more of them.

    Parts of the profile are as long as the longest wave.
    """
    known, density = spectrum(profile, round(2 * np.pi / (k[0] * profile.spacing)))
    total = np.concatenate([[0.0], np.cumsum(density) * (known[1] - known[0])])
    ends = np.concatenate([[known[0] / 2], known + (known[1] - known[0]) / 2])
    half = (k[1] - k[0]) / 2
    low, high = np.maximum(k - half, ends[0]), np.minimum(k + half, ends[-1])
    shares = np.interp(high, ends, total) - np.interp(low, ends, total)
    whole: Array = shares / np.maximum(high - low, 1e-9 * half)
    return np.where(high > low, whole, density[0])
