"""The Gaussian filter of roughness against its transmission."""

from math import exp, pi

import numpy as np
import pytest

from pyworm.formulas.gaussian_filter import ALPHA, smoothed


@pytest.mark.parametrize("ratio", [1.0, 0.5, 2.0, 4.0])
def test_a_sine_passes_as_the_standard_says(ratio):
    """Transmission exp(-pi (alpha index/wave)^2): 50 % at the nesting index, within 0.1 %."""
    count, index = 1200, 60.0
    wave = index * ratio
    x = np.arange(count)
    sine = np.sin(2 * pi * x / wave)[:, None] * np.ones((1, 8))
    passed = smoothed(sine, [index], (0,), periodic=True)
    share = (passed * sine).sum() / (sine * sine).sum()
    assert share == pytest.approx(exp(-pi * (ALPHA / ratio) ** 2), abs=1e-3)
    if ratio == 1:
        assert share == pytest.approx(0.5, abs=1e-3)


def test_both_directions_pass_alike():
    count, index = 240, 30.0
    sine = np.sin(2 * pi * np.arange(count) / index)
    waves = np.add.outer(sine, sine)
    assert smoothed(waves, [index, index], (0, 1), periodic=True) == pytest.approx(
        waves / 2, abs=1e-3
    )


def test_ends_weigh_what_is_within_them():
    level = smoothed(np.full((100, 40), 3.0), [25.0, 10.0], (0, 1), periodic=False)
    assert level == pytest.approx(3.0, rel=1e-12)
