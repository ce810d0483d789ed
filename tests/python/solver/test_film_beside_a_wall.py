"""The smallest film beside the wall of an edge that the grid does not resolve."""

import numpy as np
import pytest

from pyworm.solver import extremum
from pyworm.solver.extremum import LEAST_OF_NODES, film_minimum, minimum


def beside_a_wall(thin=0.5):
    """Films of two low nodes beside a wall ten times as high, (nx, ny)."""
    film = np.full((9, 9), 1.2)
    film[6:, :] = 6.0
    film[4:6, 4] = thin, thin
    return film


def test_a_wall_does_not_take_the_film_below_its_lowest_node():
    film, everywhere = beside_a_wall(), np.ones((9, 9), bool)
    dip, _ = minimum(film, everywhere, everywhere)
    assert dip < 0.4
    value, place, at_node = film_minimum(film, everywhere, everywhere)
    assert at_node
    assert value == pytest.approx(LEAST_OF_NODES * 0.5)
    assert place in ((4.0, 4.0), (5.0, 4.0))


def test_the_bound_is_continuous(monkeypatch):
    film, everywhere = beside_a_wall(), np.ones((9, 9), bool)
    dip, _ = minimum(film, everywhere, everywhere)
    for part in (0.999, 1.001):
        monkeypatch.setattr(extremum, "LEAST_OF_NODES", part * dip / 0.5)
        value, _, at_node = film_minimum(film, everywhere, everywhere)
        assert value == pytest.approx(dip, rel=2e-3)
        assert at_node == (part > 1)


@pytest.mark.parametrize("shift", [0.0, 0.3, 0.5])
def test_a_film_that_is_resolved_keeps_its_minimum(shift):
    x, y = np.meshgrid(np.arange(21.0) - 10 + shift, np.arange(21.0) - 10 - shift, indexing="ij")
    film, everywhere = 1 + 0.02 * (x**2 + y**2), np.ones((21, 21), bool)
    value, place, at_node = film_minimum(film, everywhere, everywhere)
    assert not at_node
    assert (value, place) == minimum(film, everywhere, everywhere)
    assert value == pytest.approx(1.0, rel=1e-6)


def test_films_of_no_thickness_are_left_to_the_solver():
    film, everywhere = beside_a_wall(-0.1), np.ones((9, 9), bool)
    value, _, at_node = film_minimum(film, everywhere, everywhere)
    assert value < -0.1
    assert not at_node
    assert film_minimum(film, ~everywhere, everywhere)[0] == np.inf
