"""Figures in the limit of endless windows."""

import pytest

from pyworm.planning.target import FIGURES
from pyworm.solver.error_estimate import Convergence, Left, Peak, Reading
from pyworm.solver.window_limit import (
    MAX_CHANGE_RATIO,
    MAX_EXTRAPOLATED_CHANGE,
    in_this_window,
    in_wider_window,
    with_falls,
)

CONVERGENCE = Convergence(
    dict.fromkeys(FIGURES, 2.0), {"film_min": Left(0.5, 0.5)}, dict.fromkeys(FIGURES, (1.5, 2.5))
)
EXACT = dict.fromkeys(FIGURES, 0.0)


def reading(film):
    return Reading(film, film, film, (0.0,), {"pressure_max": Peak(1.0, 20.0)})


@pytest.mark.parametrize("film", [lambda reach: 1 - 0.2 / reach, lambda reach: 1 + 0.2 / reach])
def test_a_figure_whose_error_halves_with_the_reach_is_extrapolated_to_its_limit(film):
    here, wider = reading(film(1)), reading(film(2))
    near = in_this_window(here, wider, CONVERGENCE, EXACT)["film_min"]
    far = in_wider_window(here, wider, CONVERGENCE, EXACT, {})["film_min"]
    # changes are relative to the figure in the wider window
    assert film(1) + near.rest * film(2) == pytest.approx(1.0)
    assert film(2) + far.rest * film(2) == pytest.approx(1.0)
    assert near.error == pytest.approx(0.5 * 0.1 / film(2)) == far.error


@pytest.mark.parametrize("left", [1 / 3, 0.5, 0.6])
def test_the_error_holds_for_what_is_left_at_each_doubling(left):
    """1 / (1 - left) times the change is left in all: 1.5 to 2.5 times."""
    here, wider = reading(1.0), reading(1.01)
    near = in_this_window(here, wider, CONVERGENCE, EXACT)["film_min"]
    true = 1.0 + 0.01 / (1 - left)
    assert abs(1.0 + near.rest * 1.01 - true) <= near.error * 1.01 * (1 + 1e-9)


def test_a_figure_that_promises_no_limit_keeps_its_value():
    near = in_this_window(reading(1.0), reading(1.25), CONVERGENCE, EXACT)["film_central"]
    assert near.rest == 0.0
    assert near.error == pytest.approx(2.5 * 0.2)
    far = in_wider_window(reading(1.0), reading(1.25), CONVERGENCE, EXACT, {})["film_central"]
    assert far.error == pytest.approx(1.5 * 0.2)


@pytest.mark.parametrize("here", [0.4, 180.0])
def test_a_change_as_large_as_the_figure_tells_of_no_limit(here):
    """Another film: the power lost at a phase of a gear set was extrapolated from 0.066 W to -8.3 W."""
    far = in_wider_window(reading(here), reading(1.0), CONVERGENCE, EXACT, {})["film_min"]
    assert abs(here - 1.0) > MAX_EXTRAPOLATED_CHANGE
    assert far.rest == 0.0
    assert far.error == pytest.approx(1.5 * abs(here - 1.0))


def test_unfinished_algebra_may_hide_a_change():
    algebra = EXACT | {"film_min": 0.02, "film_central": 0.02}
    near = in_this_window(reading(1.0), reading(1.0), CONVERGENCE, algebra)
    assert near["film_min"].error == pytest.approx(2.5 * 0.02)
    assert near["film_central"].error == pytest.approx(0.02)


def test_what_a_window_cuts_off_is_no_sign_of_more_to_come():
    cut = {"film_central": 0.19, "film_min": 0.2}
    far = in_wider_window(reading(1.0), reading(1.25), CONVERGENCE, EXACT, cut)
    assert far["film_min"].rest == far["film_min"].error == pytest.approx(0.0)
    assert far["film_central"].error == pytest.approx(1.5 * 0.01)


@pytest.mark.parametrize(
    ("fall", "most"), [(0.3, 2.5), (0.8, 5.0), (1.2, 1 / (1 - MAX_CHANGE_RATIO))]
)
def test_a_slower_fall_that_is_seen_counts(fall, most):
    convergence = with_falls(CONVERGENCE, {"film_central": fall})
    near = in_this_window(reading(1.0), reading(1.25), convergence, EXACT)
    assert near["film_central"].error == pytest.approx(most * 0.2)
    assert (
        near["film_min"]
        == in_this_window(reading(1.0), reading(1.25), CONVERGENCE, EXACT)["film_min"]
    )
