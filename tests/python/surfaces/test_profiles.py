"""Profiles: figures against closed forms, files as written, and surfaces with their spectrum and lay."""

import numpy as np
import pytest

from pyworm.surfaces.from_profiles import lay_aspect, sampled_surface, surface_of_profiles
from pyworm.surfaces.generated import gaussian
from pyworm.surfaces.parameters import texture
from pyworm.surfaces.profile import roughness_profile
from pyworm.surfaces.profile_parameters import correlation_length, profile_figures
from pyworm.surfaces.reading import read_area, read_heights, read_profile
from pyworm.surfaces.scatter import uncertainty_of_mean
from pyworm.surfaces.spectrum import spectrum

STEP, WAVE, AMPLITUDE = 0.5e-6, 50e-6, 0.3e-6
PLACES = np.arange(4000) * STEP
SINE = AMPLITUDE * np.sin(2 * np.pi * PLACES / WAVE)


def test_a_sine_has_the_figures_of_its_closed_forms():
    figures = profile_figures(roughness_profile(SINE, STEP, nesting_index=0.8e-3))
    assert figures.rq == pytest.approx(AMPLITUDE / np.sqrt(2), rel=2e-3)
    assert figures.ra == pytest.approx(2 * AMPLITUDE / np.pi, rel=2e-3)
    assert figures.rz == pytest.approx(2 * AMPLITUDE, rel=1e-2)
    assert figures.rp == pytest.approx(figures.rv, rel=3e-2)
    assert figures.skewness == pytest.approx(0, abs=1e-2)
    assert figures.kurtosis == pytest.approx(1.5, rel=5e-3)
    assert figures.slope == pytest.approx(AMPLITUDE * 2 * np.pi / WAVE / np.sqrt(2), rel=2e-3)
    assert figures.width == pytest.approx(WAVE, rel=1e-3)
    # the autocorrelation is a cosine
    assert figures.correlation_length == pytest.approx(WAVE / 6, rel=1e-2)


@pytest.mark.parametrize(("wave", "left"), [(0.8e-3, 0.5), (0.1e-3, 1.0), (5e-3, 0.0)])
def test_half_of_a_wave_as_long_as_the_nesting_index_is_roughness(wave, left):
    places = np.arange(20000) * STEP
    heights = AMPLITUDE * np.sin(2 * np.pi * places / wave)
    profile = roughness_profile(heights, STEP, nesting_index=0.8e-3)
    middle = profile.height[6000:14000]
    assert np.ptp(middle) / 2 == pytest.approx(left * AMPLITUDE, abs=0.03 * AMPLITUDE)


@pytest.mark.parametrize(
    ("height", "length", "section"),
    [
        (0.5e-6, 4e-3, 0.8e-3),
        (0.05e-6, 4e-3, 0.25e-3),
        (6e-6, 8e-3, 2.5e-3),
        (0.5e-6, 0.5e-3, 0.1e-3),
    ],
)
def test_the_nesting_index_follows_ra_where_the_profile_holds_it(height, length, section):
    rng = np.random.default_rng(1)
    heights = height * rng.standard_normal(int(length / 2e-6))
    profile = roughness_profile(heights, 2e-6)
    assert profile.section == pytest.approx(section)
    assert (profile.waviness > 0) == (length > 1e-3)


def test_the_spectrum_sums_to_the_mean_square():
    heights = np.random.default_rng(2).standard_normal(8192) * 1e-7
    profile = roughness_profile(heights, STEP, nesting_index=0.1e-3)
    wavenumber, density = spectrum(profile)
    whole = density.sum() * (wavenumber[1] - wavenumber[0])
    assert whole == pytest.approx(profile_figures(profile).rq ** 2, rel=0.02)


def test_missing_points_and_outliers_are_filled_but_not_counted():
    heights = SINE.copy()
    heights[100:110] = np.nan
    heights[777] = 30e-6
    with pytest.raises(ValueError, match="has 1 outliers"):
        roughness_profile(heights, STEP)
    profile = roughness_profile(heights, STEP, outliers="fill")
    assert profile.outliers == 1
    assert profile.measured.sum() == len(SINE) - 11
    assert profile_figures(profile).rt < 1e-6
    with pytest.raises(ValueError, match=r"0 % of its points are missing, at most 0 % are filled"):
        roughness_profile(heights, STEP, outliers="fill", fill=0.001)
    half = np.where(np.arange(4000) % 2, np.nan, SINE)
    with pytest.raises(ValueError, match="50 % of its points"):
        roughness_profile(half, STEP)


@pytest.mark.parametrize("heights", [np.zeros(200), PLACES[:200] ** 2])
def test_a_profile_that_is_all_form_is_refused(heights):
    with pytest.raises(ValueError, match="is flat"):
        roughness_profile(np.round(heights, 3), STEP)


@pytest.mark.parametrize(
    ("text", "options"),
    [
        ("x [um] z [nm]\n{um_nm}", {}),
        ("{um_nm}", {"spacing": STEP, "height_unit": "nm"}),
        ("Lateral um,Raw nanometers,\n{commas}", {}),
        ("{column}", {"spacing": STEP, "height_unit": "nm"}),
    ],
)
def test_profiles_are_read_as_written(tmp_path, text, options):
    pairs = list(zip(PLACES[:300] * 1e6, SINE[:300] * 1e9, strict=True))
    path = tmp_path / "line.txt"
    path.write_text(
        text.format(
            um_nm="\n".join(f"{x:.6f} {z:.9f}" for x, z in pairs),
            commas="\n".join(f"{x:.6f},{z:.9f}," for x, z in pairs),
            column="\n".join(f"{z:.9f}" for _, z in pairs),
        )
    )
    heights, spacing = read_profile(path, **options)
    assert heights == pytest.approx(SINE[:300], abs=1e-17)
    assert spacing == pytest.approx(STEP, rel=1e-6)
    with pytest.raises(ValueError, match="is a profile along a line"):
        read_area(path, **options)


def test_uneven_places_are_interpolated(tmp_path):
    rng = np.random.default_rng(3)
    places = np.cumsum(rng.uniform(0.2, 0.4, 500))
    path = tmp_path / "line.txt"
    np.savetxt(path, np.c_[places, 2 * places], header="x [um]  z [um]")
    heights, spacing = read_profile(path)
    assert spacing == pytest.approx(0.3e-6, rel=0.1)
    assert np.diff(heights) == pytest.approx(np.full(len(heights) - 1, 2 * spacing), rel=1e-6)


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        ("x [um] z [um]\n" + "1 2\n1 3\n" * 50, "two points lie at one place"),
        (
            "x [um] z [um]\n" + "\n".join(f"{n} 1" for n in range(30)),
            "has 30 points, a profile needs",
        ),
        (
            "x [um] z [um]\n" + "\n".join(f"{n} 1" for n in (0, 1, 2, 3, 1e8)),
            "is a profile of 100000001 places",
        ),
    ],
)
def test_other_profiles_are_refused_in_a_sentence(tmp_path, content, sentence):
    path = tmp_path / "line.txt"
    path.write_text(content)
    with pytest.raises(ValueError, match=sentence):
        read_heights(path)


def test_an_area_is_no_profile(tmp_path):
    path = tmp_path / "area.npy"
    np.save(path, np.random.default_rng(1).standard_normal((20, 30)))
    with pytest.raises(ValueError, match="not a profile; give it as file"):
        read_profile(path, 1e-6, "um")


TRUTH = gaussian(0.5e-6, 10e-6, 3.0, seed=4)
ACROSS = [roughness_profile(TRUTH.height[line], TRUTH.spacing[1]) for line in (10, 100, 200)]
ALONG = [roughness_profile(TRUTH.height[:, line], TRUTH.spacing[0]) for line in (20, 150)]


def test_a_surface_has_the_heights_spectrum_and_lay_of_its_profiles():
    aspect = lay_aspect(ACROSS, ALONG)
    assert aspect == pytest.approx(3.0, rel=0.25)
    made = surface_of_profiles(ACROSS, aspect, seed=1, nodes=128)
    again, other = (surface_of_profiles(ACROSS, aspect, seed, nodes=128) for seed in (1, 2))
    assert made == again
    assert made != other
    heights = np.concatenate([profile.height for profile in ACROSS])
    found = texture(made)
    assert found.rq == pytest.approx(heights.std(), rel=5e-3)
    assert found.skewness == pytest.approx(((heights / heights.std()) ** 3).mean(), abs=0.02)
    slopes = np.mean([profile_figures(profile).slope for profile in ACROSS])
    assert found.slope_y == pytest.approx(slopes, rel=0.12)
    assert found.slope_y / found.slope_x == pytest.approx(aspect, rel=0.1)
    width = correlation_length(ACROSS, 0.5)
    assert found.length_across == pytest.approx(width, rel=0.15)
    assert abs(found.lay) < 0.05


def test_its_samples_are_of_parts_of_the_profiles():
    made = sampled_surface(ACROSS, ALONG, 3.0, seed=0)
    assert len(made.samples) == 4
    assert len({sample.digest for sample in made.samples}) == 4
    assert made.turned(0.3).samples[1].x_direction == 0.3
    assert made.mirrored.samples[2].height[:, ::-1] == pytest.approx(made.samples[2].height)


def test_the_mean_of_samples_lies_within_its_uncertainty_19_times_of_20():
    rng = np.random.default_rng(5)
    samples = rng.standard_normal((4, 20000))
    inside = np.abs(samples.mean(axis=0)) <= uncertainty_of_mean(samples)
    assert inside.mean() == pytest.approx(0.95, abs=0.01)
