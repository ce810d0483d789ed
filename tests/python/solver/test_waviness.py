"""Waves that roll through a line contact."""

import pytest
from line import OILS, line
from waviness import VENNER, L, M, amplitude_left


@pytest.mark.parametrize("ratio", [0.5, 1.0])
def test_the_film_keeps_of_a_wave_what_venner_found(ratio):
    """On a grid whose own error is 3 to 8 %."""
    found = amplitude_left(line(M, L, OILS["compressible"]), 64, ratio, 0.1)
    assert found == pytest.approx(VENNER[0.1][ratio], rel=0.1)
