"""Computed numbers as indices."""

import numpy as np
import pytest

from pyworm.formulas.whole_numbers import whole


def test_fractions_are_cut_off():
    assert whole(np.array([0.0, 2.9, -1.5])).tolist() == [0, 2, -1]
    assert int(whole(3.7)) == 3


@pytest.mark.parametrize("lost", [np.nan, np.inf, -np.inf])
def test_what_is_not_finite_is_no_index(lost):
    with pytest.raises(ValueError, match="1 of 3 places"):
        whole(np.array([0.0, lost, 1.0]))
