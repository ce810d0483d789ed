"""Figures count measured points alone; outliers stand alone; units that make no surface are refused."""

import numpy as np
import pytest

from pyworm.case.case import checked
from pyworm.case.surface import SurfaceTable
from pyworm.cli.main import main
from pyworm.materials.topography import Topography
from pyworm.surfaces.generated import gaussian
from pyworm.surfaces.parameters import slopes, texture
from pyworm.surfaces.preparing import separate_waves

STEP = 1e-6
ROUGH = gaussian(0.4e-6, 10e-6, seed=3).height[:120, :90].copy()


def holed():
    """Heights of which no valley was measured, as confocal instruments lose steep and deep places: 8 %."""
    lost = np.quantile(ROUGH, 0.08) > ROUGH
    return np.where(lost, np.nan, ROUGH), lost


def by_hand(heights):
    """Measured heights without a polynomial of second order, by plain least squares."""
    x, y = np.meshgrid(*(np.linspace(-1, 1, n) for n in heights.shape), indexing="ij")
    there = np.isfinite(heights)
    terms = np.stack([x**i * y**j for i in range(3) for j in range(3 - i)], axis=-1)
    fit = np.linalg.lstsq(terms[there], heights[there], rcond=None)[0]
    return np.where(there, heights - terms @ fit, np.nan)


def test_figures_count_measured_points_alone():
    heights, lost = holed()
    waves = separate_waves(heights, (STEP, STEP))
    level = by_hand(heights)
    level -= np.nanmean(level)
    found, rq = texture(waves.roughness), np.sqrt(np.nanmean(level**2))
    assert waves.filled == pytest.approx(lost.mean())
    assert found.rq == pytest.approx(rq, rel=1e-9)
    assert found.ra == pytest.approx(np.nanmean(np.abs(level)), rel=1e-9)
    assert found.skewness == pytest.approx(np.nanmean(level**3) / rq**3, rel=1e-9)
    assert found.kurtosis == pytest.approx(np.nanmean(level**4) / rq**4, rel=1e-9)
    along = [np.sqrt(np.nanmean(np.diff(level, axis=axis) ** 2)) / STEP for axis in (0, 1)]
    assert (found.slope_x, found.slope_y) == pytest.approx(along, rel=1e-9)
    middle = level[np.isfinite(level)]
    assert found.rvk < np.ptp(middle)


def test_what_fills_the_gaps_changes_no_figure():
    """Whatever heights stand where none were measured, figures and digest of the rest stay."""
    heights, lost = holed()
    surface = separate_waves(heights, (STEP, STEP)).roughness
    other = Topography(
        np.where(lost, 50e-6, surface.height), surface.spacing, measured=surface.measured
    )
    assert texture(other) == texture(surface)
    assert other.rms == surface.rms
    assert other != surface


def test_lengths_of_correlation_come_from_pairs_of_measured_points():
    whole = texture(separate_waves(ROUGH, (STEP, STEP)).roughness)
    heights = ROUGH.copy()
    heights[np.random.default_rng(4).random(ROUGH.shape) < 0.09] = np.nan
    found = texture(separate_waves(heights, (STEP, STEP)).roughness)
    assert found.length_across == pytest.approx(whole.length_across, rel=0.05)
    assert found.rq == pytest.approx(whole.rq, rel=0.02)


def test_filters_weigh_measured_points_alone():
    """A wave longer than the filter's index, with holes on its crests, passes as a whole."""
    x = np.arange(300) * STEP
    wave = 1e-6 * np.sin(2 * np.pi * x / 100e-6)[:, np.newaxis] + np.zeros(80)
    heights = wave + np.random.default_rng(5).normal(0, 0.05e-6, wave.shape)
    heights[(wave > 0.97e-6) & (np.random.default_rng(6).random(wave.shape) < 0.5)] = np.nan
    waves = separate_waves(heights, (STEP, STEP), nesting_index=25e-6)
    measured, inside = waves.roughness.known, np.s_[60:-60, 10:-10]
    rough = waves.roughness.height[inside][measured[inside]]
    whole = separate_waves(wave, (STEP, STEP), nesting_index=25e-6).roughness.height[inside]
    assert rough.std() == pytest.approx(np.hypot(0.05e-6, whole.std()), rel=0.1)


def spiked(count=12, height=30e-6):
    heights = ROUGH.copy()
    places = np.random.default_rng(7).choice(heights.size, count, replace=False)
    heights.flat[places] = height
    return heights


def grooved(depth=20e-6):
    heights = ROUGH.copy()
    heights[40:52, :] -= depth
    return heights


def pitted():
    heights = ROUGH.copy()
    heights[30:42, 20:33] -= 15e-6
    return heights


@pytest.mark.parametrize("real", [grooved, pitted], ids=["a groove", "a pit"])
def test_features_whose_points_lie_together_are_no_outliers(real):
    """Far from the median as they are: 15 and 20 um where the rest is within 2."""
    waves = separate_waves(real(), (STEP, STEP))
    assert waves.filled == 0
    assert waves.roughness.measured_heights.min() < -8e-6


def test_points_that_stand_alone_are_refused_with_what_they_change():
    sentence = (
        r"has 12 outliers, up to .* um from the mean, which stand out .*: Rq is 1\.\d+ um with them "
        r"and 0\.\d+ um without; give outliers = \"fill\" to leave them out, or \"keep\""
    )
    with pytest.raises(ValueError, match=sentence):
        separate_waves(spiked(), (STEP, STEP))
    filled = separate_waves(spiked(), (STEP, STEP), outliers="fill")
    without = separate_waves(np.where(spiked() > 10e-6, np.nan, spiked()), (STEP, STEP))
    assert filled.filled == pytest.approx(12 / ROUGH.size)
    assert filled.roughness.rms == pytest.approx(without.roughness.rms, rel=1e-12)
    kept = separate_waves(spiked(), (STEP, STEP), outliers="keep")
    assert kept.roughness.rms > 2 * filled.roughness.rms


def test_a_single_point_that_changes_nothing_refuses_no_surface():
    waves = separate_waves(spiked(1, 8e-6), (STEP, STEP))
    assert waves.filled == 0


def surface_of(tmp_path, heights, **keys):
    np.save(tmp_path / "flank.npy", heights.T)
    table = checked(SurfaceTable, {"file": "flank.npy", **keys})
    table.lie_in(tmp_path)
    return table.waves()


@pytest.mark.parametrize(
    ("factor", "keys", "sentence"),
    [
        (1, {"height_unit": "um", "spacing": "1 um"}, r"heights of .* nm .*less than 0\.01 nm"),
        (1e6, {"height_unit": "mm", "spacing": "1 um"}, r"slope of 89.3 degrees, more than 60"),
        (1e6, {"height_unit": "um", "spacing": "10 nm"}, "slope of .* degrees, more than 60, with"),
        (
            1e6,
            {"height_unit": "um", "spacing": "50 mm"},
            r"has a side of 6 m, points 0\.05 m apart",
        ),
    ],
)
def test_units_that_make_no_surface_are_refused(tmp_path, factor, keys, sentence):
    with pytest.raises(ValueError, match=sentence) as refused:
        surface_of(tmp_path, ROUGH * factor, **keys)
    assert "\n" not in str(refused.value)


def test_the_right_units_of_the_same_numbers_are_taken(tmp_path):
    waves = surface_of(tmp_path, ROUGH * 1e6, height_unit="um", spacing="1 um")
    assert waves.roughness.rms == pytest.approx(np.std(by_hand(ROUGH)), rel=1e-9)
    assert np.hypot(*slopes(waves.roughness)) < 0.2


def test_sides_that_an_instrument_states_are_judged_too(tmp_path):
    """Files with kilometres in place of micrometres: refused, and read with the distance of the user."""
    library = pytest.importorskip("SurfaceTopography")
    wrong = library.Topography(ROUGH * 1e6, (160e6, 120e6), unit="um")
    wrong.to_netcdf(str(tmp_path / "flank.nc"))
    for spacing, sentence in ((None, "has a side of 160 m, .* give spacing = "), ("1 um", None)):
        keys = {"file": "flank.nc"} | ({} if spacing is None else {"spacing": spacing})
        table = checked(SurfaceTable, keys)
        table.lie_in(tmp_path)
        if sentence is None:
            assert table.waves().roughness.extent == pytest.approx((120e-6, 90e-6))
        else:
            with pytest.raises(ValueError, match=sentence):
                table.waves()


def test_the_command_ends_in_figures_or_a_sentence(tmp_path, capsys):
    path = tmp_path / "grid.xyz"
    x, y = np.meshgrid(np.arange(20) * 0.5, np.arange(20) * 0.5, indexing="ij")
    np.savetxt(path, np.stack([x.ravel(), y.ravel(), ROUGH[:20, :20].ravel() * 1e6], axis=1))
    assert main(["surface", str(path)]) == 2
    said = capsys.readouterr().err
    assert 'give height_unit = "um" and spacing = "0.5 um" with it' in said
    assert main(["surface", str(path), "--height-unit", "um", "--spacing", "0.5 um"]) == 0
    assert "20 x 20, 0.01 x 0.01 mm" in capsys.readouterr().out
