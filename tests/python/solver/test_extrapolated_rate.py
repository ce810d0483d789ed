"""Rates of change in the limit of small spacing and time steps, and the errors that solves leave."""

from dataclasses import replace

import numpy as np
import pytest

from pyworm.planning.grid import Grid
from pyworm.planning.target import AccuracyTarget
from pyworm.solver.error_estimate import SAFETY, Peak, Reading
from pyworm.solver.transient import rate_errors as errors_module
from pyworm.solver.transient.extrapolated_rate import (
    FIRST_ORDER,
    SECOND_ORDER,
    ExtrapolatedRate,
    share_left,
)
from pyworm.solver.transient.rate_errors import ERROR_SHARE, rate_errors
from pyworm.solver.transient.time_integration import RateOfChange

FILMS = AccuracyTarget(("film_min", "film_central"))
LARGE = 1e6
"""A film beside which the changes are small, so that relative ones add up."""


def reading(film, central=LARGE):
    return Reading(LARGE + film, central, 1.0, (0.0,), {"pressure_max": Peak(1.0, 20.0)})


def test_what_the_last_rate_is_off_is_a_share_of_its_difference_from_the_one_before():
    """Of rates on grids of their own, which are smooth; heat that surfaces remember likewise."""
    grid = Grid(-1.0, -1.0, 0.0625, 0.0625, 33, 33)
    finer, wanted = grid.finer(), Grid(-0.5, -0.5, 0.125, 0.125, 9, 9)

    def found(on, off):
        x, y = on.mesh()
        field = np.broadcast_to((1 + off) * np.cos(x) * np.cos(y), on.shape)
        return RateOfChange(on, field, np.stack([field, 2 * field], axis=-1))

    for order, share in ((2, SECOND_ORDER), (1, FIRST_ORDER)):
        rate = ExtrapolatedRate(found(grid, 0.1 * 2**order), found(finer, 0.1), share)
        exact = found(finer, 0.0)
        assert rate.on(wanted)[0] == 0.0
        assert rate.on(wanted)[1] == pytest.approx(exact.on(wanted)[1], rel=1e-6)
        assert rate.remembered(wanted) == pytest.approx(exact.remembered(wanted), rel=1e-6)
        assert rate.stored(wanted) is None and not rate.limited
    cold = ExtrapolatedRate(replace(found(grid, 0.1), rise=None), found(finer, 0.1), 1.0)
    assert cold.remembered(wanted) == pytest.approx(found(finer, 0.1).remembered(wanted))


@pytest.mark.parametrize(
    ("fall", "share"),
    [(0.1, SECOND_ORDER), (0.25, 1 / 3), (0.4, 2 / 3), (0.5, FIRST_ORDER), (0.7, 1.0), (0.8, 0.0)],
)
def test_the_order_of_rates_is_seen_in_the_changes_of_figures(fall, share):
    """From second to first; in two of them, or where they hardly fall, none is seen."""
    some = [reading(0.0), reading(1.0), reading(1.0 + fall)]
    assert share_left(some[:2], FILMS) == 0.0
    assert share_left(some, FILMS) == pytest.approx(share, rel=1e-3)
    assert share_left([reading(0.0)] * 3, FILMS) == 0.0


def test_no_order_is_seen_in_changes_of_another_sign():
    """A film that is found too thin, then too thick, is not thicker still."""
    some = [reading(0.0), reading(1.0), reading(0.6)]
    assert share_left(some, FILMS) == 0.0


@pytest.fixture
def no_least_error(monkeypatch):
    """Errors by changes alone."""
    monkeypatch.setattr(errors_module, "MIN_TRANSIENT_ERROR", 0.0)


def stated(fall, extrapolation):
    """Error after three solves over the last change, in the linear range of films."""
    found = [reading(0.0), reading(0.0), reading(1.0), reading(1.0 + fall)]
    end = None if not extrapolation else reading(1.0 + fall * (1 + extrapolation))
    errors = rate_errors(found, end, extrapolation, "point", not extrapolation, FILMS)
    return errors["film_min"] * LARGE / fall


def test_errors_after_extrapolation_are_what_a_geometric_series_leaves(no_least_error):
    """With the usual share at least; without one, and where changes hardly fall, both changes add up."""
    share, slow = ERROR_SHARE["point"], errors_module.SLOW_ERROR_SHARE["point"]
    assert stated(0.25, SECOND_ORDER) == pytest.approx(share, rel=1e-3)
    assert stated(0.5, FIRST_ORDER) == pytest.approx(share, rel=1e-3)
    assert stated(0.5, SECOND_ORDER) == pytest.approx(SAFETY * 2 / 3, rel=1e-3)
    assert stated(0.6, FIRST_ORDER) == pytest.approx(SAFETY * 0.5, rel=1e-3)
    assert stated(0.9, SECOND_ORDER) == pytest.approx(1 + 1 / 0.9, rel=1e-3)
    assert stated(1.1, SECOND_ORDER) == pytest.approx(1 + 1 / 1.1, rel=1e-3)
    assert stated(0.4, 0.0) == pytest.approx(slow, rel=1e-3)
    assert stated(0.6, 0.0) == pytest.approx(1 + 1 / 0.6, rel=1e-3)


@pytest.mark.parametrize(
    ("fall", "extrapolation", "of_last"),
    [
        (-0.4, 0.0, ERROR_SHARE["point"]),
        (-0.6, 0.0, 1.0),
        (-1.2, 0.0, 1 + 1 / 1.2),
        (-0.6, SECOND_ORDER, SAFETY * (0.6 / 1.6 + SECOND_ORDER)),
    ],
)
def test_a_change_of_another_sign_that_falls_is_the_error_at_most(
    fall, extrapolation, of_last, no_least_error
):
    """The limit lies between both; an extrapolation by the order of other figures leads away from it."""
    found = [reading(0.0), reading(0.0), reading(1.0), reading(1.0 + fall)]
    end = reading(1.0 + fall * (1 + extrapolation)) if extrapolation else None
    errors = rate_errors(found, end, extrapolation, "point", False, FILMS)
    assert errors["film_min"] * LARGE / abs(fall) == pytest.approx(of_last, rel=1e-3)


def test_a_figure_that_extrapolation_moves_farther_than_rates_change_is_as_uncertain(
    no_least_error,
):
    """Its grids are too coarse: the film follows a change of the rate, but for little, linearly."""
    found = [reading(0.0), reading(4.0), reading(0.0), reading(-1.0)]
    moved = rate_errors(found, reading(-5.0), SECOND_ORDER, "point", False, FILMS)
    assert moved["film_min"] * LARGE == pytest.approx(
        ERROR_SHARE["point"] * 4 / SECOND_ORDER, rel=1e-3
    )
