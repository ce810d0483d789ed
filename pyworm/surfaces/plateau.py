"""Heights of profiles with worn summits, from the line of their plateaus.

Least squares draw the form of a profile through valleys too: its plateaus are bent, and those of several
profiles lie apart. Of twenty worn surfaces, read along three lines of 75 correlation lengths, the core height
Rk was 2.8 times too large. Valleys are therefore cut off at the form and the form is fitted again, as
ISO 13565-1 does for its mean line, until it follows the plateaus. Without plateaus that would follow single
summits: the skewness of the heights decides.
"""

from collections.abc import Sequence

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.surfaces.profile import FORM_DEGREE, Profile

CUTS = 32
"""Fits of the form with the valleys cut off."""

NO_PLATEAU, PLATEAU = -0.3, -0.8
"""Skewness of heights whose form is that of least squares, and of those whose form is that of plateaus;
between them straight. Three Gaussian lines of 75 correlation lengths: -0.25 to 0.33; Rq worn to 0.7: -1.4 to
-0.77."""


def plateau_share(profiles: Sequence[Profile]) -> float:
    """Share of the form of plateaus in that of some profiles, by the skewness of all their heights [-]."""
    heights = _pooled(profiles, [_form(profile, 0) for profile in profiles])
    skewness = float(np.mean(heights**3) / np.mean(heights**2) ** 1.5)
    return float(np.interp(skewness, (PLATEAU, NO_PLATEAU), (1.0, 0.0)))


def heights_on_one_datum(profiles: Sequence[Profile], share: float) -> Array:
    """Measured heights [m] of all profiles in a row, of mean zero, from forms of a `plateau_share`."""
    forms = [_form(profile, 0) for profile in profiles]
    if share > 0:
        forms = [
            (1 - share) * form + share * _form(profile, CUTS)
            for form, profile in zip(forms, profiles, strict=True)
        ]
    return _pooled(profiles, forms)


def _pooled(profiles: Sequence[Profile], forms: Sequence[Array]) -> Array:
    pairs = zip(profiles, forms, strict=True)
    heights: Array = np.concatenate(
        [(profile.height - form)[profile.measured] for profile, form in pairs]
    )
    return heights - heights.mean()


def _form(profile: Profile, cuts: int) -> Array:
    """Form of a profile [m] by least squares, its valleys cut off some times at the form before."""
    place, there = np.linspace(-1, 1, len(profile.height)), profile.measured

    def fitted(heights: Array) -> Array:
        form = np.polynomial.Polynomial.fit(place[there], heights[there], FORM_DEGREE)
        values: Array = form(place)
        return values

    form = fitted(profile.height)
    for _ in range(cuts):
        form = fitted(np.maximum(profile.height, form))
    return form
