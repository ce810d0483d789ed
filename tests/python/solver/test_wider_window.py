"""The film of a narrow window as the initial guess in a wider one."""

from types import SimpleNamespace

import numpy as np

from pyworm.planning.grid import Grid
from pyworm.solver.level import InitialGuess
from pyworm.solver.point.level import guess_around


def test_the_film_of_a_grid_that_the_wider_one_does_not_hold_is_taken_where_both_are():
    """Where teeth end, a window grown outward may end before the narrow one."""

    def level(grid, pressure):
        guess = InitialGuess(np.full(grid.shape, pressure), pressure, None)
        return SimpleNamespace(grid=grid, state=lambda: guess)

    narrow = level(Grid(-3.0, -2.0, 1.0, 1.0, 7, 6), 2.0)
    wide = level(Grid(-6.0, -6.0, 1.0, 1.0, 13, 9), 1.0)
    guess = guess_around(narrow, wide)
    assert guess.rigid_film == 2.0
    np.testing.assert_array_equal(guess.pressure[3:10, 4:9], 2.0)
    assert (guess.pressure == 1.0).sum() == 13 * 9 - 7 * 5
