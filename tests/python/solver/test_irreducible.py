"""Errors that grid refinement does not reduce end a solve, or ask for one more transient solution."""

from math import inf

import pytest

from pyworm.planning.target import AccuracyTarget
from pyworm.solver.ending import Ending
from pyworm.solver.estimate import Estimate
from pyworm.solver.irreducible import TIME, beyond_refinement, time_would_do

TARGET = AccuracyTarget(("film_min", "temperature_max_film"), warmth=10.0)
FIGURES = {"film_min": 1e-7, "temperature_max_film": 40.0}
SOURCES = {
    "levels across the film": {"film_min": 0.001, "temperature_max_film": 0.002},
    TIME: {"film_min": 0.04, "temperature_max_film": 0.06},
    "conduction in the bodies": {"temperature_max_film": 0.068},
}


def ended(grid, accuracy, figures=FIGURES):
    estimates = {name: Estimate(1.0, grid) for name in FIGURES}
    return beyond_refinement(estimates, SOURCES, figures, TARGET, accuracy)


def test_what_leaves_an_error_beyond_the_accuracy_is_told_the_largest_first():
    stop = ended(grid=0.01, accuracy=0.1)
    assert stop.ending is Ending.BEYOND_REFINEMENT and not stop.ending.converged
    assert stop.reason == (
        "grid refinement does not reduce the error of 13 %: conduction in the bodies 6.8 %, "
        "transient solution 6 %"
    )


@pytest.mark.parametrize(
    "grid, accuracy, figures",
    [
        (0.01, 0.13, FIGURES),  # within the accuracy together
        (0.11, 0.1, FIGURES),  # a grid whose film tells nothing of the other errors yet
        (0.01, 0.1, FIGURES | {"temperature_max_film": 5.0}),  # of a film that hardly warms
    ],
)
def test_a_finer_grid_follows_where_it_may_bring_the_accuracy(grid, accuracy, figures):
    assert ended(grid, accuracy, figures) is None


def test_a_source_that_is_not_known_yet_ends_nothing():
    """A film whose wider window was not found is compared with one on the next grid."""
    estimates = {name: Estimate(1.0, 0.01) for name in FIGURES}
    unknown = SOURCES | {"domain truncation": dict.fromkeys(FIGURES, inf)}
    assert beyond_refinement(estimates, unknown, FIGURES, TARGET, 0.1) is None


@pytest.mark.parametrize("accuracy, enough", [(0.086, True), (0.084, False)])
def test_a_quarter_of_the_error_of_the_transient_solution_decides_upon_one_more(accuracy, enough):
    assert time_would_do(SOURCES, FIGURES, TARGET, accuracy) is enough


def test_films_without_transient_solution_have_none_to_add():
    steady = SOURCES | {TIME: {}}
    assert not time_would_do(steady, FIGURES, TARGET, 0.05)
