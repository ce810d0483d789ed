"""Error bars from readings on grids, windows and Newton steps."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from pyworm.planning.grid import Grid
from pyworm.planning.target import FIGURES, HEAT_FIGURES, AccuracyTarget
from pyworm.solver.ending import Ending, Stop
from pyworm.solver.error_estimate import (
    SAFETY,
    Peak,
    Reading,
    algebra_errors,
    grid_errors,
    hot_spike,
    peak_errors,
    unresolved,
)
from pyworm.solver.estimate import Estimate
from pyworm.solver.newton import Iteration
from pyworm.solver.stop_reason import bound_by_conduction, spike_stays, stop_reason, with_wider_bars

SECOND = dict.fromkeys(FIGURES, 2.0)


def reading(film, central=1.0, bound=1.0, nodes=20.0):
    return Reading(
        film_min=film,
        film_central=central,
        pressure_max=1.0,
        film_min_at=(0.0,),
        peaks={"pressure_max": Peak(bound, nodes)},
    )


LARGE = 1e9
"""A film beside which the changes are small, so that relative ones add up."""


def film_error(*films, order=2.0):
    """Error of a minimum film, given less a constant, in the same unit."""
    readings = [reading(LARGE + film) for film in films]
    return LARGE * grid_errors(readings, SECOND | {"film_min": order})["film_min"]


def test_one_grid_gives_no_error_bar():
    assert film_error(1.0) == np.inf


def test_two_grids_give_the_larger_change_of_both_films_to_all():
    errors = grid_errors([reading(0.9, 0.8), reading(1.0, 1.0)], SECOND)
    assert errors == pytest.approx(dict.fromkeys(FIGURES, SAFETY * 0.2))


@pytest.mark.parametrize(
    ("films", "error"),
    [
        ((21.0, 5.0, 1.0), 4 / 3),  # second order
        ((13.5, 3.5, 1.0), 2.5 / 3),  # four times
        ((3.0, 2.0, 1.0), 1.0),  # no fall
        ((1.0, 1.0, 1.0), 0.0),
    ],
)
def test_the_ratio_of_changes_gives_the_error(films, error):
    assert film_error(*films) == pytest.approx(SAFETY * error)


def test_the_ratio_of_changes_is_bounded_by_the_order():
    assert film_error(17.0, 3.0, 1.0) == pytest.approx(14 / 4 / 3)


@pytest.mark.parametrize(
    ("films", "error"),
    [
        ((2.0, 1.0, 1.5), 0.5),  # to and fro
        ((9.0, 1.0, 1.5), 2.0),
        ((10.0, 1.0, 0.0), 9 / 4),  # stands still by chance
        ((5.0, 1.0, 1.0), 1.0),
    ],
)
def test_changes_of_alternating_sign_or_small_by_chance_give_no_order(films, error):
    assert film_error(*films) == pytest.approx(error)
    assert film_error(*(-film for film in films)) == pytest.approx(error)


def test_bars_hold_on_grids_where_changes_flip_their_sign():
    """Minimum films [nm] of the same contacts on grids of halving spacing, the last ones as their truth.

    M 100, L 8, radii 1:5, entrained at 50 degrees; and a heated one at a slide-roll ratio of 1.1.
    """
    for films in (
        (80.295, 83.184, 83.031, 82.723, 82.623),
        (30.507, 52.134, 56.559, 56.299, 55.807),
    ):
        readings = [reading(film, film) for film in films]
        for count in (3, 4):
            error = grid_errors(readings[:count], SECOND)["film_min"]
            assert error > abs(films[-1] / films[count - 1] - 1)


def test_the_largest_ratio_of_changes_is_that_of_the_order():
    assert film_error(9.0, 3.0, 1.0) == pytest.approx(SAFETY * 1.0)
    assert film_error(9.0, 3.0, 1.0, order=1.0) == pytest.approx(SAFETY * 2.0)


def test_a_peak_a_few_nodes_wide_may_be_as_high_as_the_grid_leaves_open():
    assert peak_errors(reading(1.0, bound=1.1)) == pytest.approx({"pressure_max": SAFETY * 0.1})
    assert peak_errors(reading(1.0, bound=0.9)) == {"pressure_max": 0.0}
    assert unresolved(reading(1.0, bound=1.1)) is None


def test_a_pressure_spike_too_narrow_for_the_grid_has_no_bound_and_a_reason():
    spike = reading(1.0, bound=1.1, nodes=2.34)
    assert peak_errors(spike) == {"pressure_max": np.inf}
    assert unresolved(spike) == "unresolved pressure spike, 2.3 nodes wide"


def test_a_narrow_hot_spot_has_a_bar_however_few_nodes_it_is_wide():
    rise = {"temperature_max_film": 50.0}
    hot = replace(
        reading(1.0),
        peaks={**reading(1.0).peaks, "temperature_max_film": Peak(60.0, 2.0)},
        further=rise,
    )
    errors = peak_errors(hot)
    assert errors["temperature_max_film"] == pytest.approx(SAFETY * 0.2)
    assert unresolved(hot) is None


def test_a_film_hottest_at_the_tip_of_a_spike_says_how_narrow_it_is():
    def hot(nodes):
        return replace(reading(1.0), peaks={"temperature_max_film": Peak(60.0, nodes)})

    assert hot_spike(hot(5.68)) == "tip of a temperature spike, 5.7 nodes wide"
    assert hot_spike(hot(8.0)) is None
    assert hot_spike(reading(1.0)) is None  # of a film that does not warm


def test_no_grid_is_refined_for_a_spike_that_the_largest_one_does_not_resolve():
    """Eight nodes are wanted; twice as many lie across a spike on each finer grid at most."""
    grid = Grid(0.0, 0.0, 1.0, 1.0, 17, 17)
    assert grid.finer().finer().shape == (65, 65)

    def stays(nodes, largest):
        hot = replace(reading(1.0), peaks={"temperature_max_film": Peak(60.0, nodes)})
        return spike_stays(hot, grid, largest)

    assert stays(1.9, 65**2)
    assert not stays(2.1, 65**2)
    assert stays(2.1, 65**2 - 1)
    assert not stays(8.1, 17**2)
    assert not spike_stays(reading(1.0), grid, 17**2)


@pytest.mark.parametrize(
    ("before", "last", "error"),
    [
        (0.4, 0.1, 0.1 / 3),  # the rest of a geometric series
        (0.4, 0.3, 0.9),  # as slowly as heat settles
        (0.4, 0.39, 4 * 0.39),  # more slowly than any series is believed to
        (0.3, 0.4, 4 * 0.4),  # slower still
        (0.4, 0.001, 0.2 * 0.4 / 4),  # small by chance: too good to be believed
        (0.0, 0.1, 0.1),
        (1.0, 0.03, 0.03),  # from nothing: no series yet
    ],
)
def test_the_algebraic_error_is_the_change_by_further_steps(before, last, error):
    changes = (dict.fromkeys(FIGURES, of) for of in (before, last))
    assert algebra_errors(*changes) == pytest.approx(dict.fromkeys(FIGURES, error))


def test_temperatures_that_conduction_leaves_inaccurate_ask_for_no_finer_grid():
    """Models of conduction in the bodies are no better on a finer grid: all else decides, and it is said."""

    def ended(conduction, film=0.01, rest=0.01):
        names = ("film_min", *HEAT_FIGURES)
        figures = reading(1.0)
        hot = replace(figures, further=dict.fromkeys(HEAT_FIGURES, 20.0))
        level = SimpleNamespace(
            film=SimpleNamespace(balance=SimpleNamespace(worst=0.0)),
            grid=Grid(0.0, 0.0, 1.0, 1.0, 17, 17),
            conduction_errors=lambda: dict.fromkeys(HEAT_FIGURES, conduction),
        )
        plan = SimpleNamespace(
            target=AccuracyTarget(names), accuracy=0.05, tolerance=1e-3, largest_grid=10_000
        )
        found = {"film_min": Estimate(1.0, film)} | {
            name: Estimate(20.0, rest, approximation=conduction) for name in HEAT_FIGURES
        }
        bound = bound_by_conduction(level, found, hot.figures, plan)
        return bound, stop_reason(level, Iteration((), hot, {}), found, 0, 3, plan)

    bound, stop = ended(0.1)
    assert bound == HEAT_FIGURES
    assert stop.ending.accurate and stop.ending.converged
    assert stop.reason.endswith("conduction in the bodies leaves 11 % of their rise")
    assert ended(0.01) == ((), Ending.ACCURATE.stop())
    assert ended(0.1, film=0.06) == (HEAT_FIGURES, None)  # a finer grid mends the film
    assert ended(0.1, rest=0.06) == ((), None)


def test_films_are_used_whose_temperatures_at_an_edge_are_not_known():
    """Films and friction count for losses over a cycle; a film that is itself not known does not."""
    plan = SimpleNamespace(target=AccuracyTarget(("film_min", *HEAT_FIGURES)))

    def told(film, heat):
        found = {"film_min": Estimate(1.0, film)} | {
            name: Estimate(20.0, heat) for name in HEAT_FIGURES
        }
        figures = {"film_min": 1.0} | dict.fromkeys(HEAT_FIGURES, 20.0)
        stop = Stop(Ending.LARGEST_GRID, "no finer grid")
        return with_wider_bars(stop, found, figures, plan)

    assert told(0.1, 0.3).reason == "less accurate than requested, 30 %: no finer grid"
    assert told(0.1, np.inf).reason == (
        "less accurate than requested, 10 %, of temperatures more than 50 %: no finer grid"
    )
    assert told(0.1, 0.3).ending.converged and told(0.1, np.inf).ending.converged
    assert told(0.6, 0.3) == Stop(Ending.LARGEST_GRID, "no finer grid")


def test_each_ending_has_a_message_of_its_own():
    """Files keep the word; what is accurate has converged, and is said so."""
    assert len({ending.message for ending in Ending} - {"{reason}"}) == len(Ending) - 3
    assert all(Ending(str(ending)) is ending for ending in Ending)
    accurate = [ending for ending in Ending if ending.accurate]
    assert len(accurate) == 3
    assert all(ending.converged for ending in accurate)
    assert sum(ending.converged for ending in Ending) == 6
    assert Ending.RESIDUAL.stop(residual=0.01, tolerance=1e-6) == Stop(
        Ending.RESIDUAL, "the residual stayed at 1.0e-02, 1.0e-06 is required"
    )
