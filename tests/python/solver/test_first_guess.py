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
    guess = extrapolated([time_level(2.0, 5.0, 1.0), time_level(1.0, 4.0, 1.0)], 3.0, False)
    assert guess.pressure == pytest.approx(np.array([[6.0, 1.0]]))
    assert guess.rigid_film == pytest.approx(4e-7)


def test_a_place_under_pressure_stays_so_and_one_without_has_none():
    guess = extrapolated([time_level(2.0, 2.0, 0.0), time_level(1.0, 9.0, 5.0)], 3.0, False)
    assert guess.pressure == pytest.approx(np.array([[MIN_PRESSURE_RATIO * 2.0, 0.0]]))
    assert guess.oil == pytest.approx(guess.pressure)


def warm_level(seconds, *rises):
    """A film at a time of four nodes, of which the first two bear pressure."""
    pressure = np.array([1.0, 0.5, 0.01, 0.0])
    rise = np.array(rises)[:, np.newaxis]
    return TimeLevel(seconds, np.ones(4), InitialGuess(pressure, 1e-7, rise, pressure))


def test_temperatures_go_on_in_the_contact_if_asked_and_stay_far_from_it():
    before = [warm_level(2.0, 10.0, 8.0, 5.0, 3.0), warm_level(1.5, 9.0, 9.0, 1.0, 0.0)]
    assert extrapolated(before, 3.0, True).rise[:, 0] == pytest.approx([12.0, 6.0, 5.0, 3.0])
    assert np.array_equal(extrapolated(before, 3.0, False).rise, before[0].state.rise)
    assert np.array_equal(extrapolated(before[:1], 3.0, True).rise, before[0].state.rise)
