"""Surfaces of few profiles: worn summits, slopes by a scattered spectrum, bias of what is short."""

import numpy as np
import pytest
from surfaces_from_profiles import truth

from pyworm.surfaces.from_profiles import surface_of_profiles
from pyworm.surfaces.parameters import core, texture
from pyworm.surfaces.plateau import heights_on_one_datum, plateau_share
from pyworm.surfaces.profile import PART_COUNT, roughness_profile
from pyworm.surfaces.profile_parameters import profile_figures
from pyworm.surfaces.scatter import uncertainty_of_mean, uncertainty_of_whole

STEP = 1e-6
PLACE = np.linspace(-1, 1, 500)
FORMS = [np.polynomial.Polynomial([0.0, 1e-6, c * 1e-6]) for c in (2.0, -1.0, 0.5)]


def profiles(plateau, missing=False):
    """Three profiles of random heights [m] up to a plateau, on forms of their own."""
    rng = np.random.default_rng(2)
    heights = np.minimum(rng.standard_normal((3, PLACE.size)), plateau) * 1e-7
    measured = [height + form(PLACE) for height, form in zip(heights, FORMS, strict=True)]
    if missing:
        heights[0, 40:50] = measured[0][40:50] = np.nan
    found = [roughness_profile(of, STEP, by_class=False, outliers="keep") for of in measured]
    return heights, found


@pytest.mark.parametrize("missing", [False, True])
def test_worn_summits_of_profiles_lie_on_one_plateau(missing):
    heights, found = profiles(0.0, missing)
    known = heights[np.isfinite(heights)]
    assert plateau_share(found) == 1
    on_datum = heights_on_one_datum(found, 1.0)
    assert on_datum.shape == known.shape
    assert np.abs(on_datum - (known - known.mean())).max() < 0.1 * known.std()
    # half of the points lie on the plateau, and more than the 40 % of the core
    assert core(on_datum)["rk"] < 0.1 * known.std()
    apart = np.concatenate([profile.height[profile.measured] for profile in found])
    assert core(apart)["rk"] > 3 * core(on_datum)["rk"]


def test_without_worn_summits_the_form_stays_that_of_least_squares():
    _, found = profiles(np.inf)
    together = np.concatenate([profile.height for profile in found])
    assert plateau_share(found) == 0
    assert heights_on_one_datum(found, 0.0) == pytest.approx(together, abs=1e-15)


def test_a_surface_is_as_steep_as_profiles_whose_spectrum_scatters():
    whole = truth(130)
    across = [roughness_profile(whole.height[line], whole.spacing[1]) for line in (292, 216, 332)]
    squares = [profile_figures(profile).slope ** 2 for profile in across]
    made = texture(surface_of_profiles(across, whole.spacing[0] / whole.spacing[1], seed=1))
    assert made.slope_y == pytest.approx(np.sqrt(np.mean(squares)), rel=0.1)


def test_parts_show_the_bias_of_a_whole():
    """What n points are too low by on the mean falls with 1 / n: their variance about their own mean."""
    rng = np.random.default_rng(3)
    count, points = 4000, 8
    heights = rng.standard_normal((count, PART_COUNT * points))
    whole = heights.var(axis=1)
    parts = heights.reshape(count, PART_COUNT, points).var(axis=2)
    bias = (whole - parts.mean(axis=1)) / (PART_COUNT - 1)
    assert bias.mean() == pytest.approx(1 / (PART_COUNT * points), rel=0.1)
    added = uncertainty_of_whole(parts.T, whole) - uncertainty_of_mean(parts.T)
    assert added == pytest.approx(np.abs(bias))


def test_a_part_of_a_profile_has_no_form_of_its_own():
    _, (profile, *_) = profiles(np.inf)
    for part in profile.parts:
        place = np.linspace(-1, 1, len(part.height))
        form = np.polynomial.Polynomial.fit(place, part.height, 2)(place)
        assert np.abs(form).max() < 1e-6 * part.height.std()
