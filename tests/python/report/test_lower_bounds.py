"""Figures without an upper bound are lower bounds with a reason, and the accuracy names its figures."""

from dataclasses import replace
from math import inf

import numpy as np
import pytest
from synthetic_solution import make_solution

import pyworm
from pyworm.io.quantities import QUANTITIES
from pyworm.io.quantity_text import percent, with_bars
from pyworm.report.console.scenes import figures_table, solution_table
from pyworm.report.explore.scenes import scene_rows
from pyworm.result.accuracy import accuracy_words
from pyworm.solver.estimate import Estimate
from pyworm.solver.grid_sequence import _extrapolated

SPIKE = Estimate(864.5e6, inf, reason="unresolved pressure spike, 1.7 nodes wide")


def spiked():
    """A converged contact with an unresolved pressure spike."""
    solution = make_solution()
    figures = replace(solution.figures, pressure_max=SPIKE)
    return replace(
        solution, figures=figures, accuracy=0.01, accuracy_of=("film_min", "film_central")
    )


def test_an_unresolved_spike_is_a_lower_bound_everywhere():
    bound = "≥ 864.5 MPa (unresolved pressure spike, 1.7 nodes wide)"
    assert spiked().figure_text(QUANTITIES["pressure_max"]) == bound
    assert str(SPIKE) == "≥ 8.645e+08 (unresolved pressure spike, 1.7 nodes wide)"
    rows = dict(scene_rows(spiked(), ("body 1", "body 2")))
    assert rows["Maximum pressure"] == bound
    assert rows["Requested accuracy"] == "1 % of minimum film thickness, central film thickness"
    assert with_bars("1 K", inf, 0.1) == "≥ 1 K ± 10 % (model) (error not known)"
    assert with_bars("1 K", 0.02) == "1 K ± 2 %"
    assert with_bars("1 K", 0.02, inf) == "1 K ± 2 % ± unknown (model)"


def test_the_console_shows_the_bound_and_what_is_accurate():
    scene = pyworm.load("cases/ball_pag_460.toml").scene()
    table = figures_table(scene, spiked().summary(), {})
    text = "\n".join((*map(" ".join, table.rows), table.note))
    assert "≥ 864.5 MPa" in text and "no upper bound" in text and "inf" not in text
    text = "\n".join(map(" ".join, solution_table(spiked().summary()).rows))
    assert "1 % of minimum film thickness, central film thickness" in text


def test_the_minimum_on_the_centre_line_is_never_below_that_of_the_contact():
    """Extrapolated by the same factor, and at least as large."""
    film = Estimate(1.1e-7, 0.01, on_grid=1.0e-7)
    assert _extrapolated({"film_exit_min": 1.02e-7}, film)["film_exit_min"] == pytest.approx(
        1.122e-7
    )
    assert _extrapolated({"film_exit_min": 0.99e-7}, film)["film_exit_min"] == film.value
    assert _extrapolated({"lift": 1.0}, film) == {"lift": 1.0}


def test_errors_left_are_never_rounded_to_nothing():
    assert percent(3.4e-4) == "0.034 %"
    assert percent(1.2e-6) == "0.00012 %"


def test_an_accuracy_names_each_kind_of_figure_once():
    names = ("film_min", "temperature_max_body_1", "temperature_max_body_2")
    assert (
        accuracy_words(0.001, names)
        == "0.1 % of minimum film thickness, maximum surface temperature"
    )
    assert accuracy_words(0.01, ()) == ""


def test_a_solution_names_the_figures_of_its_accuracy():
    scene = pyworm.load("cases/point_m20_l10.toml").scene()
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.05))
    assert solution.accuracy_of == ("film_min", "film_central")
    summary = solution.summary()
    assert summary["accuracy_of"] == ["film_min", "film_central"] and summary["accuracy"] == 0.05
    assert summary["film_exit_min_m"] >= summary["film_min_m"]
    assert np.isfinite(summary["film_min_error"])
