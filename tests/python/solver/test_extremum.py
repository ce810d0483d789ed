"""Figures read off fields between nodes and levels."""

import warnings
from math import isnan

import numpy as np
import pytest

from pyworm import kernel
from pyworm.planning.grid import Grid
from pyworm.solver.extremum import minimum
from pyworm.solver.figures import (
    exit_minimum,
    maximum,
    maximum_across,
    outline_imbalance,
    peak,
)
from pyworm.solver.level import newtonian_shear


def _across(field, positions, within):
    return maximum_across(field, positions, within, field.max(axis=-1))


@pytest.mark.parametrize("levels", [5, 7, 13])
def test_a_peak_between_nodes_and_levels_is_found(levels):
    z = kernel.level_positions(levels)
    x, y = np.arange(9.0)[:, None, None], np.arange(7.0)[None, :, None]
    across = 1 - 4 * (z - 0.2) ** 2 + 0.3 * (z - 0.2) ** 3
    field = 50 * across * (1 - 0.02 * (x - 4.3) ** 2 - 0.03 * (y - 2.8) ** 2)
    assert field.max() < 0.999 * 50
    assert _across(field, z, np.ones(field.shape[:2], bool)) == pytest.approx(50, rel=2e-4)


def test_a_peak_at_a_wall_in_a_corner_is_found():
    z = kernel.level_positions(7)
    x, y = np.arange(6.0)[:, None, None], np.arange(6.0)[None, :, None]
    assert _across(x + y + 10 * z, z, np.ones((x + y).shape[:2], bool)) == pytest.approx(15)


SHAPE = (25, 21)
X, Y = np.meshgrid(np.arange(SHAPE[0]), np.arange(SHAPE[1]), indexing="ij")
EVERYWHERE = np.ones(SHAPE, dtype=bool)


def valley(x, y, angle, narrow=0.3, flat=0.003):
    """A bowl with its bottom, 1, at (x, y), its long axis turned by an angle."""
    along = np.cos(angle) * (X - x) + np.sin(angle) * (Y - y)
    across = np.cos(angle) * (Y - y) - np.sin(angle) * (X - x)
    return 1 + narrow * across**2 + flat * along**2


@pytest.mark.parametrize("angle", [0.0, 0.3, np.pi / 4, 1.1, -0.4])
def test_the_bottom_of_a_paraboloid_is_found_between_nodes(angle):
    value, place = minimum(valley(12.3, 9.8, angle), EVERYWHERE, EVERYWHERE)
    assert value == pytest.approx(1, abs=2e-5)
    assert place == pytest.approx((12.3, 9.8), abs=0.12)
    assert maximum(-valley(12.3, 9.8, angle)) == pytest.approx(-1, abs=2e-5)


@pytest.mark.parametrize("angle", [0.0, 0.3, 1.1])
def test_a_minimum_does_not_jump_where_the_lowest_node_changes(angle):
    """A valley wanders over five cells; no surface through nodes follows so narrow a one, but steadily."""
    shifts = np.linspace(0, 5, 201)
    values = [
        minimum(np.sqrt(valley(9 + shift, 9.2 + 0.37 * shift, angle, 1.0)), EVERYWHERE, EVERYWHERE)[
            0
        ]
        for shift in shifts
    ]
    assert np.ptp(values) < 0.05
    assert np.abs(np.diff(values)).max() < 1.5e-3
    assert np.abs(np.diff(values, 2)).max() < 1e-3


def test_a_minimum_is_read_at_third_order():
    def error(spacing):
        x, y = spacing * (X - 11.3), spacing * (Y - 8.8)
        return minimum(np.exp(x) - x + np.exp(y) - y, EVERYWHERE, EVERYWHERE)[0] - 2

    coarse, fine = error(0.4), error(0.1)
    assert abs(fine) < abs(coarse) / 4**3
    assert abs(coarse) < 2e-3


def test_a_field_mirrored_or_turned_has_the_same_minimum():
    random = np.random.default_rng(3)
    film = valley(12.3, 9.8, 0.3) + 0.01 * random.random(SHAPE)
    within = film < 1.3
    usable = film < 1.5
    value, (x, y) = minimum(film, within, usable)
    for turn in (np.flipud, np.fliplr, np.transpose, np.rot90):
        again, _ = minimum(*(turn(of).copy() for of in (film, within, usable)))
        assert again == pytest.approx(value, rel=1e-14)
    mirrored, (u, v) = minimum(*(of[::-1] for of in (film, within, usable)))
    assert mirrored == pytest.approx(value, rel=1e-14)
    assert (u, v) == pytest.approx((SHAPE[0] - 1 - x, y))


def test_the_deeper_of_two_valleys_counts():
    film = np.minimum(valley(6.4, 10.1, 0.0), valley(18.5, 10.5, 0.0) - 1e-3)
    assert film[6, 10] < film[18, 10]
    value, (x, _) = minimum(film, EVERYWHERE, EVERYWHERE)
    assert value == pytest.approx(0.999, abs=1e-5)
    assert x == pytest.approx(18.5, abs=0.05)


@pytest.mark.parametrize("seed", range(20))
def test_no_node_is_beyond_the_extremum_however_many_valleys_compete(seed):
    """A flat bowl with ridges and pits, and one lower node that stands out less than they do."""
    random = np.random.default_rng(seed)
    film = valley(12.3, 9.8, 0.3, 1e-3, 1e-4) + 0.2 * random.random(SHAPE)
    film[3 + seed % 5, 4] = 0.999 * film.min()
    film[2:10, 3:6] = np.maximum(film[2:10, 3:6], film.min())
    assert minimum(film, EVERYWHERE, EVERYWHERE)[0] <= film.min()
    assert maximum(-film) >= (-film).max()
    assert maximum(-film[:, 4]) >= (-film[:, 4]).max()


@pytest.mark.parametrize("angle", [0.0, 0.3, np.pi / 4, 1.1])
@pytest.mark.parametrize("width", [5.0, 10.0, 16.0])
def test_the_width_of_a_ridge_in_nodes_does_not_depend_on_its_direction(width, angle):
    across = np.cos(angle) * (Y - 9.8) - np.sin(angle) * (X - 12.3)
    ridge = 1 - 0.5 * (2 * across / width) ** 2
    found = peak(ridge, True, maximum(ridge))
    assert found.nodes == pytest.approx(width, rel=0.15)
    # a parabola is half its second difference too low where no node is at its top, at most
    assert 1 < found.bound < 1 + 2.1 / width**2


def test_a_spike_lower_than_the_middle_is_seen_if_it_may_be_higher():
    pressure = 1 - 0.002 * ((X - 12.0) ** 2 + (Y - 10.0) ** 2)
    assert peak(pressure, True, 1.0).nodes == pytest.approx(2 / np.sqrt(0.008), rel=0.01)
    spiky = pressure.copy()
    spiky[20, 10] += 0.1
    assert maximum(spiky) == pytest.approx(1.0)
    assert peak(spiky, True, 1.0).nodes < 4
    assert peak(spiky, True, 1.0).bound > 1.1
    spiky[20, 10] -= 0.08
    assert peak(spiky, True, 1.0) == peak(pressure, True, 1.0)


def test_the_end_of_a_surface_is_no_spike():
    covered = X <= 14
    pressure = np.where(covered, 1 - 0.002 * (X - 13.0) ** 2, 0.0)
    assert peak(pressure, covered, maximum(pressure, covered)).nodes > 20
    assert peak(pressure[:, 3], covered[:, 3], 1.0).nodes > 20
    steep = np.where(covered, 0.3 + 0.7 * np.exp(1.5 * (X - 14.0)), 0.0)
    assert peak(steep, covered, maximum(steep, covered)).nodes < 4
    assert peak(np.zeros(SHAPE), covered, 0.0).nodes == np.inf


@pytest.mark.parametrize("beyond", [-50.0, 0.0, 50.0, np.nan])
def test_a_minimum_at_an_edge_asks_nothing_of_what_is_beyond(beyond):
    usable = Y <= 12
    film = np.where(usable, valley(12.3, 14.0, 0.0, 0.02, 0.03), beyond)
    value, place = minimum(film, usable, usable)
    assert value == pytest.approx(1 + 0.02 * 4, abs=1e-5)
    assert place == pytest.approx((12.3, 12.0), abs=0.01)


def test_a_minimum_beside_what_does_not_count_is_read_across_one_cell():
    within = X <= 12
    value, place = minimum(valley(12.4, 9.8, 0.0), within, EVERYWHERE)
    assert value == pytest.approx(1, abs=1e-5) and place[0] == pytest.approx(12.4, abs=0.01)
    value, place = minimum(valley(15.0, 10.0, 0.0), within, EVERYWHERE)
    assert place == pytest.approx((13.0, 10.0))


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_fields_that_are_not_finite_have_no_finite_minimum(bad):
    film = np.where(X == 3, bad, 1.0)
    value, _ = minimum(film, X == 3, EVERYWHERE)
    assert not np.isfinite(value)
    value, _ = minimum(film, np.zeros(SHAPE, dtype=bool), EVERYWHERE)
    assert value == np.inf


def test_along_a_line_the_curve_is_that_of_the_surface():
    x = np.arange(30.0)
    for bottom in (7.0, 7.3, 7.5, 0.2, 28.9):
        film = np.sqrt(1 + 0.3 * (x - bottom) ** 2 + 0.01 * (x - bottom) ** 3)
        usable = np.ones(30, dtype=bool)
        value, place = minimum(film, usable, usable)
        strip = [np.stack([of] * 3, axis=1) for of in (film, usable, usable)]
        assert value == pytest.approx(minimum(*strip)[0], abs=1e-5)
        assert place[0] == pytest.approx(minimum(*strip)[1][0], abs=0.01)
    value, place = minimum(np.where(x > 6, np.nan, (x - 6.4) ** 2), x <= 6, x <= 6)
    assert (value, place) == (pytest.approx(0.16), (6.0,))


def test_the_exit_minimum_is_found_between_places_looked_at():
    grid = Grid(-12e-5, -10e-5, 1e-5, 1e-5, *SHAPE)
    x, y = grid.mesh()
    along = 0.8 * x + 0.6 * y
    film = 1 + ((along - 4.3e-5) / 1e-4) ** 2
    value, place = exit_minimum(grid, film, np.arctan2(0.6, 0.8))
    assert value == pytest.approx(1, abs=1e-9)
    assert place == pytest.approx(4.3e-5, rel=1e-4)


def test_where_nothing_flows_there_is_no_share_out_of_balance():
    grid, still = Grid(0.0, 0.0, 1.0, 1.0, *SHAPE), np.zeros(SHAPE)
    assert np.isnan(outline_imbalance(grid, (still, still), still, X > 5))
    assert outline_imbalance(grid, (still + 1, still), still, X > 5) == 0


@pytest.mark.parametrize("shape", [(40, 30), (40,)])
def test_a_hot_column_outside_the_contact_is_not_the_films_temperature(shape):
    places = np.meshgrid(*(np.linspace(-1, 1, count) for count in shape), indexing="ij")
    hump = np.exp(-3 * sum(place**2 for place in places))
    positions = kernel.level_positions(5)
    field = hump[..., np.newaxis] * (1.2 - 2 * positions**2)
    field[(1,) * len(shape)] = 5.0  # a column by the side of the window that heat never settled
    within = hump > 0.2
    assert _across(field, positions, within) == pytest.approx(1.2, rel=2e-3)


def test_shear_of_a_newtonian_film_is_that_of_its_profile():
    """Stress eta du/dz and heat eta (du/dz)^2 across the film, of Couette and Poiseuille flow together."""
    viscosity, film = np.array([0.2, 3.0]), np.array([1e-6, 0.4e-6])
    sliding = np.array([1.5, -0.3]), np.array([0.0, 2.0])
    slopes = np.array([4e11, -1e13]), np.array([-2e11, 3e13])
    shear = newtonian_shear(viscosity, film, sliding, slopes)
    place = np.linspace(-0.5, 0.5, 2001)[:, None] * film  # from body 1, which slides, to body 2
    stresses = [
        -viscosity * speed / film + place * slope
        for speed, slope in zip(sliding, slopes, strict=True)
    ]
    squares = sum(stress**2 for stress in stresses)
    for found, stress in zip(shear.stress, stresses, strict=True):
        assert found == pytest.approx(stress[1000])
    heat = np.trapezoid(squares / viscosity, place, axis=0)
    assert shear.friction == pytest.approx(heat, rel=1e-5)
    assert shear.rate == pytest.approx(np.sqrt(squares).max(axis=0) / viscosity)


def test_what_is_far_from_the_nodes_that_count_does_not_matter():
    field = np.random.default_rng(2).random((40, 50))
    within = np.zeros(field.shape, bool)
    within[15:20, 22:30] = True
    usable = np.ones(field.shape, bool)
    value, place = minimum(field, within, usable)
    changed = field.copy()
    changed[:8], changed[28:], changed[:, :15], changed[:, 37:] = -1.0, -1.0, -1.0, -1.0
    assert minimum(changed, within, usable) == (value, place)
    assert minimum(field, within & False, usable) == (np.inf, (0.0, 0.0))


def test_a_film_without_contact_has_no_largest_temperature_in_it():
    """Of a life whose load begins at nothing (drive 0 of seed 99013 of `tests/hard`)."""
    field = np.ones((9, 9, 5))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert isnan(_across(field, kernel.level_positions(5), np.zeros((9, 9), bool)))
