"""Generated surfaces have the figures that were asked for; figures of surfaces against closed forms."""

from math import log, pi, sqrt

import numpy as np
import pytest
import scipy

from pyworm.materials.topography import Topography
from pyworm.surfaces.generated import gaussian, self_affine
from pyworm.surfaces.parameters import texture


def test_a_gaussian_surface_has_its_roughness_lengths_and_slope():
    length = 20e-6
    own = texture(gaussian(0.4e-6, length, seed=1))
    assert own.rq == pytest.approx(0.4e-6, rel=1e-12)
    assert own.ra == pytest.approx(0.4e-6 * sqrt(2 / pi), rel=0.01)
    assert own.skewness == pytest.approx(0.0, abs=0.15)
    assert own.kurtosis == pytest.approx(3.0, abs=0.15)
    # exp(-ln 10 (x/l)^2) is 1/2 at x = l sqrt(ln 2/ln 10), and its curvature at 0 gives the slope
    assert own.length_across == pytest.approx(length * sqrt(log(2) / log(10)), rel=0.05)
    assert own.slope_x == pytest.approx(0.4e-6 / length * sqrt(2 * log(10)), rel=0.05)
    assert own.aspect == pytest.approx(1.0, abs=0.1)


@pytest.mark.parametrize("aspect", [3.0, 1 / 3])
def test_ridges_have_their_aspect_and_lay(aspect):
    own = texture(gaussian(0.4e-6, 20e-6, aspect, seed=1))
    assert own.aspect == pytest.approx(3.0, rel=0.1)
    assert own.texture_ratio == pytest.approx(1 / 3, rel=0.1)
    lay = 0.0 if aspect > 1 else pi / 2
    assert abs((own.lay - lay + pi / 2) % pi - pi / 2) < 0.05


def test_the_spectrum_of_a_self_affine_surface_falls_by_its_exponent():
    hurst = 0.8
    surface = self_affine(0.4e-6, hurst, 100e-6, 5e-6, seed=2)
    power = np.abs(np.fft.fft2(surface.height)) ** 2
    q = (
        2
        * pi
        * np.hypot(
            *np.meshgrid(
                *(
                    np.fft.fftfreq(n, step)
                    for n, step in zip(surface.height.shape, surface.spacing, strict=True)
                ),
                indexing="ij",
            )
        )
    )
    within = (q > 2 * pi / 90e-6) & (q < 2 * pi / 5.2e-6)
    fitted, _ = np.polyfit(np.log(q[within]), np.log(power[within]), 1)
    assert fitted == pytest.approx(-2 - 2 * hurst, abs=0.1)
    assert power[(q > 2 * pi / 4.9e-6)].max() < 1e-12 * power.max()


def test_the_seed_decides_the_surface():
    first, again, other = (gaussian(1e-6, 20e-6, seed=seed) for seed in (1, 1, 2))
    assert first == again
    assert hash(first) == hash(again)
    assert first != other


def test_more_scales_than_a_cell_holds_are_refused():
    with pytest.raises(ValueError, match="at most 64"):
        self_affine(1e-6, 0.8, 1e-3, 1e-6)
    with pytest.raises(ValueError, match="above 1"):
        self_affine(1e-6, 0.8, 1e-6, 1e-6)


def test_the_core_of_normal_heights():
    """Rk, Rpk and Rvk by the normal quantiles: the flattest secant over 40 % is that in the middle."""
    quantile = scipy.special.ndtri
    heights = quantile((np.arange(250_000) + 0.5) / 250_000)
    surface = Topography(
        np.random.default_rng(1).permutation(heights).reshape(500, 500), (1.0, 1.0)
    )
    own = texture(surface)
    rk = 2 * quantile(0.7) / 0.4
    top = rk / 2
    mr1 = 1 - scipy.special.ndtr(top)
    above = np.exp(-(top**2) / 2) / sqrt(2 * pi) - top * mr1
    assert own.rk == pytest.approx(rk, rel=2e-3)
    assert own.mr1 == pytest.approx(mr1, rel=5e-3)
    assert own.rpk == pytest.approx(2 * above / mr1, rel=1e-2)
    assert own.rvk == pytest.approx(own.rpk, rel=1e-2)


def test_a_lay_at_an_angle_is_found_on_a_measured_area():
    x, y = np.meshgrid(np.arange(300.0), np.arange(300.0), indexing="ij")
    angle = np.radians(30)
    noise = np.random.default_rng(1).standard_normal((300, 300))
    ridges = np.sin(0.4 * (-np.sin(angle) * x + np.cos(angle) * y)) + 0.1 * noise
    own = texture(Topography(ridges, (1e-6, 1e-6)))
    assert own.lay == pytest.approx(angle, abs=np.radians(2))
    assert own.texture_ratio < 0.1
