"""Figures read off fields between nodes and levels."""

import numpy as np
import pytest

from pyworm import kernels
from pyworm.reading import maximum_across


@pytest.mark.parametrize("levels", [5, 7, 13])
def test_a_peak_between_nodes_and_levels_is_found(levels):
    z = kernels.level_positions(levels)
    x, y = np.arange(9.0)[:, None, None], np.arange(7.0)[None, :, None]
    across = 1 - 4 * (z - 0.2) ** 2 + 0.3 * (z - 0.2) ** 3
    field = 50 * across * (1 - 0.02 * (x - 4.3) ** 2 - 0.03 * (y - 2.8) ** 2)
    assert field.max() < 0.999 * 50
    assert maximum_across(field, z) == pytest.approx(50, rel=2e-4)


def test_a_peak_at_a_wall_in_a_corner_is_found():
    z = kernels.level_positions(7)
    x, y = np.arange(6.0)[:, None, None], np.arange(6.0)[None, :, None]
    assert maximum_across(x + y + 10 * z, z) == pytest.approx(15)
