"""Figures in the limit of infinitely fine grids."""

from dataclasses import replace

import pytest

from pyworm.planning.target import FIGURES
from pyworm.solver.contact import FED_FALLS
from pyworm.solver.error_estimate import Convergence, Left, Peak, Reading, grid_errors
from pyworm.solver.grid_limit import grid_limits

CONVERGENCE = Convergence(
    dict.fromkeys(FIGURES, 2.0),
    {"film_min": Left(0.5, 0.25, least=0.1), "film_central": Left(0.1, 0.05, limit=0.4)},
    {},
    kept={"pressure_max": Left(0.6, 0.02)},
)


def readings(*films, central=None, pressures=None):
    """Readings on grids of halving spacing."""
    return [
        Reading(
            film,
            film if central is None else central[place],
            1.0 if pressures is None else pressures[place],
            (0.0,),
            {"pressure_max": Peak(1.0, 20.0)},
        )
        for place, film in enumerate(films)
    ]


def second_order(limit, error, count):
    return [limit + error / 4**number for number in range(count)]


def test_a_figure_of_second_order_is_extrapolated_to_its_limit():
    for count in (2, 3, 4):
        found = grid_limits(readings(*second_order(1.0, 0.3, count)), CONVERGENCE)
        assert found["film_min"].value == pytest.approx(1.0, abs=1e-12)


def test_on_two_grids_a_share_of_the_own_change_is_left():
    films = readings(0.8, 1.0, central=(1.6, 2.0), pressures=(0.9, 1.0))
    found = grid_limits(films, CONVERGENCE)
    assert found["film_min"].error == pytest.approx(0.5 * 0.2)
    assert found["film_central"].error == pytest.approx(0.1 * 0.2)
    assert found["film_central"].value == pytest.approx(2.0 + 0.4 / 3)
    assert found["pressure_max"].error == pytest.approx(0.6 * 0.1)


def test_a_figure_that_stands_still_by_chance_has_a_share_of_the_films_change():
    found = grid_limits(readings(0.8, 1.0, central=(2.0, 2.0), pressures=(1.0, 1.0)), CONVERGENCE)
    assert found["film_central"].error == pytest.approx(0.05 * 0.2)
    assert found["pressure_max"].error == pytest.approx(0.02 * 0.2)


def test_on_three_grids_the_error_is_the_change_of_the_limit():
    found = grid_limits(readings(0.5, 0.9, 1.0), CONVERGENCE)["film_min"]
    limit, earlier = 1.0 + 0.1 / 3, 0.9 + 0.4 / 3
    assert found.value == pytest.approx(limit)
    assert found.error * limit == pytest.approx(max(abs(limit - earlier), 0.1 * 0.1))
    found = grid_limits(readings(0.55, 0.9, 1.0), CONVERGENCE)["film_min"]
    assert found.error * found.value == pytest.approx(1.0 + 0.1 / 3 - 0.9 - 0.35 / 3)


def test_on_three_grids_a_figure_may_have_a_share_of_that_change():
    films = (0.55, 0.9, 1.0)
    limit, earlier = 1.0 + 0.1 / 3, 0.9 + 0.35 / 3
    found = grid_limits(readings(*films), CONVERGENCE)["film_central"]
    assert found.error * limit == pytest.approx(0.4 * abs(limit - earlier))


@pytest.mark.parametrize("films", [(0.9, 1.1, 1.0), (0.8, 0.9, 1.0), (0.0, 0.99, 1.0)])
def test_changes_that_do_not_fall_regularly_promise_no_limit(films):
    """To and fro, hardly falling, and small by chance."""
    found = grid_limits(readings(*films), CONVERGENCE)["film_min"]
    assert found.value == films[-1]
    assert found.error == grid_errors(readings(*films), CONVERGENCE.orders)["film_min"]


def test_the_largest_pressure_is_never_extrapolated():
    films = second_order(1.0, 0.3, 3)
    found = grid_limits(readings(*films, pressures=films), CONVERGENCE)
    assert found["pressure_max"].value == films[-1]


FED = replace(CONVERGENCE, falls=FED_FALLS)


@pytest.mark.parametrize(("first", "second"), [(0.1, 0.0), (0.0, 0.1), (0.05, 0.05)])
def test_first_and_second_order_together_are_seen_on_three_grids(first, second):
    films = [1.0 + first * s + second * s**2 for s in (1.0, 0.5, 0.25)]
    assert grid_limits(readings(*films), FED)["film_min"].value == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize("beyond", [0.0, 1 / 3, 1.0])
def test_on_two_grids_the_limit_may_be_up_to_a_change_away(beyond):
    """As at first order, at second, and where the errors of both cancel."""
    change = 0.03
    found = grid_limits(readings(1.0 - change * (1 + beyond), 1.0 - change * beyond), FED)
    film = found["film_central"]
    assert abs(film.value - 1.0) <= film.error * film.value < 0.7 * change


def test_one_grid_has_no_limit():
    found = grid_limits(readings(1.0), CONVERGENCE)
    assert all(of.error == float("inf") for of in found.values())


def test_a_figure_without_change_has_no_error():
    films = [replace(of, further={"friction_coefficient": 0.0}) for of in readings(1.0, 1.0, 1.0)]
    convergence = replace(
        CONVERGENCE,
        orders=CONVERGENCE.orders | {"friction_coefficient": 2.0},
        left={"friction_coefficient": Left(0.25, 0.25)},
    )
    assert grid_limits(films, convergence)["friction_coefficient"].error == 0.0
    assert grid_limits(films[1:], convergence)["friction_coefficient"].error == 0.0
