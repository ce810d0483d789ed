"""The first guess of a transient film, extrapolated from films before it."""

import numpy as np
import pytest

from pyworm.solver.level import InitialGuess
from pyworm.solver.transient.time_level import MIN_PRESSURE_RATIO, TimeLevel, extrapolated


def time_level(seconds, *pressure):
    """A film at a time of which only its pressure and rigid film count."""
    p = np.array([pressure])
    return TimeLevel(seconds, np.ones_like(p), InitialGuess(p, 1e-7 * (1 + seconds), None, p))


def test_pressures_that_change_evenly_go_on():
    guess = extrapolated([time_level(2.0, 5.0, 1.0), time_level(1.0, 4.0, 1.0)], 3.0)
    assert guess.pressure == pytest.approx(np.array([[6.0, 1.0]]))
    assert guess.rigid_film == pytest.approx(4e-7)


def test_a_place_under_pressure_stays_so_and_one_without_has_none():
    guess = extrapolated([time_level(2.0, 2.0, 0.0), time_level(1.0, 9.0, 5.0)], 3.0)
    assert guess.pressure == pytest.approx(np.array([[MIN_PRESSURE_RATIO * 2.0, 0.0]]))
    assert guess.oil == pytest.approx(guess.pressure)
