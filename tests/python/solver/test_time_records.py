"""Curves of figures over a life and their error bars."""

import numpy as np
import pytest

from pyworm.solver.transient.time_records import Frame, TimeRecord, as_arrays, curves, from_arrays


def _moments(values):
    return [
        TimeRecord(1e-3 * number, None, 10.0, (1.0,), {"film_min": value, "film_central": value})
        for number, value in enumerate(values)
    ]


def _bars(solves, present, at=2e-3):
    """Relative error bars of curves whose least error is 1 %."""
    life = curves(solves, -1.0, "line", 0.25, 0.01, at, {"film_min": present}, None, 1e-3)
    return life["life_film_min_error"].values / life["life_film_min"].values


def test_bars_of_a_curve_reach_the_present_film_on_its_finer_grid():
    assert _bars([_moments([2.0, 2.0, 2.0])], 2.4) == pytest.approx([0.2, 0.2, 0.2])
    assert _bars([_moments([2.0, 2.0, 2.0])], 2.0) == pytest.approx([0.01, 0.01, 0.01])


def test_curves_that_go_on_beyond_the_present_are_compared_where_it_is():
    solves = [_moments([2.0, 2.0, 8.0])]
    assert _bars(solves, 2.2, 1e-3) == pytest.approx([0.1, 0.1, 0.1])


def test_the_larger_of_both_differences_counts():
    solves = [_moments([3.0, 2.0, 2.0]), _moments([2.0, 2.0, 2.0])]
    assert _bars(solves, 2.2) == pytest.approx([0.125, 0.1, 0.1])


def test_a_figure_that_the_present_film_does_not_have_has_no_curve():
    """At other times of the life heat was called for."""
    life = curves([_moments([2.0, 2.0])], -1.0, "line", 0.25, 0.01, 2e-3, {}, None, 1e-3)
    assert "life_film_min" not in life and "life_load" in life


@pytest.mark.parametrize("rough", [False, True])
def test_time_records_are_kept_with_their_fields(rough):
    x, y = np.linspace(-1, 1, 3), np.linspace(-2, 2, 5)
    fields = [np.full((3, 5), value, np.float32) for value in ((1, 2, 3) if rough else (1, 2))]
    framed = TimeRecord(0.5, 0.1, 20.0, (1.0, 0.2), {"film_min": 1e-6}, Frame((x, y), *fields))
    plain = TimeRecord(0.6, 0.2, 21.0, (1.0, 0.3), {"film_min": 2e-6})
    again = from_arrays(as_arrays([framed, plain]))
    assert again[1] == plain and again[0].figures == framed.figures
    frame = again[0].frame
    assert [of.tolist() for of in frame.places] == [x.tolist(), y.tolist()]
    kept = [of for of in (frame.pressure, frame.film, frame.rubbing) if of is not None]
    assert [of.tolist() for of in kept] == [of.tolist() for of in fields]
