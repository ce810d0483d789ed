"""Error bars from readings on grids, windows and Newton steps."""

import numpy as np
import pytest

from pyworm.accuracy import FIGURES, Reading, algebra_errors, domain_errors, grid_errors

SECOND = dict.fromkeys(FIGURES, 2.0)


def reading(film, central=1.0):
    return Reading(film_min=film, film_central=central, pressure_max=1.0, film_min_at=(0.0,))


LARGE = 1e9
"""A film beside which the changes are small, so that relative ones add up."""


def film_error(*films, order=2.0):
    """Error of a minimum film, given less a constant, in the same unit."""
    readings = [reading(LARGE + film) for film in films]
    return LARGE * grid_errors(readings, SECOND | {"film_min": order})["film_min"]


def test_one_grid_tells_nothing():
    assert film_error(1.0) == np.inf


def test_two_grids_give_the_larger_change_of_both_films_to_all():
    errors = grid_errors([reading(0.9, 0.8), reading(1.0, 1.0)], SECOND)
    assert errors == pytest.approx(dict.fromkeys(FIGURES, 0.2))


@pytest.mark.parametrize(
    ("films", "error"),
    [
        ((21.0, 5.0, 1.0), 4 / 3),  # second order
        ((103.0, 3.0, 1.0), 25 / 3),  # a fall too steep to believe in
        ((3.0, 2.0, 1.0), 1.0),  # no fall
        ((5.0, 1.0, 1.0), 1 / 3),  # stands still by chance
    ],
)
def test_the_fall_of_the_changes_promises_the_error(films, error):
    assert film_error(*films) == pytest.approx(error)


def test_the_steepest_fall_believed_is_the_order():
    assert film_error(9.0, 3.0, 1.0) == pytest.approx(1.0)
    assert film_error(9.0, 3.0, 1.0, order=1.0) == pytest.approx(2.0)


def test_a_window_is_off_by_a_multiple_of_what_a_wider_one_changes():
    assert domain_errors(reading(1.0), reading(1.1), 1.5)["film_min"] == pytest.approx(0.15)


@pytest.mark.parametrize(
    ("before", "last", "error"),
    [
        (0.4, 0.1, 0.1 / 3),  # the rest of a geometric series
        (0.4, 0.3, 0.3),  # no series
        (0.4, 0.001, 0.001 / 4),  # too good to be believed
        (0.0, 0.1, 0.1),
    ],
)
def test_algebra_left_is_what_further_steps_would_change(before, last, error):
    changes = (dict.fromkeys(FIGURES, of) for of in (before, last))
    assert algebra_errors(*changes) == pytest.approx(dict.fromkeys(FIGURES, error))
