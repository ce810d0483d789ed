"""Where the solver goes another way, or says why, without an exception; by stand-ins for films."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from circular_contact import circular
from synthetic_solution import make_hot_worm, make_solution

import pyworm
from pyworm.io.quantities import QUANTITIES
from pyworm.kernel.core import NO_DESCENT, NO_MEMORY, KernelError
from pyworm.solver import newton, timing
from pyworm.solver import passes as passes_module
from pyworm.solver.ending import Ending
from pyworm.solver.error_estimate import Peak, Reading
from pyworm.solver.estimate import Estimate
from pyworm.solver.grid_sequence import _lack_of_memory
from pyworm.solver.stop_reason import _not_met
from pyworm.solver.transient import next_film, time_integration
from pyworm.solver.transient.differences import weights


def left(worst, unsolved=0):
    """A level whose film left a residual, and places without a shear stress."""
    film = SimpleNamespace(unsolved=lambda: unsolved, balance=SimpleNamespace(worst=worst))
    return SimpleNamespace(film=film)


@pytest.mark.parametrize(
    ("level", "words"),
    [
        (left(1e-3, unsolved=7), "the shear stress was not found in 7 places"),
        (left(np.inf), "no film was found whose stresses"),
        (left(np.nan), "no film was found whose stresses"),
        (left(1e-3), "the residual stayed at 1.0e-03, 1.0e-06 is required"),
    ],
)
def test_what_is_not_met_is_named(level, words):
    assert words in _not_met(level, SimpleNamespace(tolerance=1e-6)).reason


def test_any_other_failure_than_memory_is_raised_again():
    assert "memory" in _lack_of_memory(KernelError(NO_MEMORY)).reason
    with pytest.raises(KernelError):
        _lack_of_memory(KernelError(NO_DESCENT))


def test_newton_steps_end_where_none_is_found(monkeypatch):
    """The film keeps its figures, and their algebraic error has no bound."""
    reading = replace(_reading(), film_min=2e-7)
    level = SimpleNamespace(
        read=lambda: reading,
        peaks=lambda of: {},
        film=SimpleNamespace(balance=SimpleNamespace(worst=1.0)),
    )
    monkeypatch.setattr(newton, "newton_step", lambda level: None)
    monkeypatch.setattr(newton, "_most_steps", lambda level, tolerance: 5)
    iteration = newton.converge(level, 1e-6, SimpleNamespace(worst=lambda *of: np.inf), 1e-3)
    assert iteration.steps == () and iteration.reading.film_min == 2e-7
    assert set(iteration.algebra.values()) == {np.inf}


def _reading():
    return Reading(1e-7, 2e-7, 1e9, (0.0, 0.0), {"pressure_max": Peak(1e9, 20.0)})


def test_where_the_processors_clock_stands_elapsed_time_is_taken(monkeypatch):
    monkeypatch.setattr(timing, "process_time", lambda: 0.0)
    assert timing.convolution_seconds(SimpleNamespace(convolve=lambda: sum(range(1000)))) > 0


def test_one_time_has_its_own_value_and_no_rate():
    values, rates = weights([0.25], 0.25)
    assert values == pytest.approx([1.0]) and rates == pytest.approx([0.0])


def test_a_model_uncertainty_is_that_of_the_parts_that_have_one():
    of_model = Estimate(2.0, 0.1, model=0.05) * Estimate(3.0, 0.1)
    assert of_model.model == pytest.approx(0.05)


def test_a_temperature_without_a_datum_rises_from_zero_kelvin_without_an_inlet():
    solution = replace(make_solution(), inlet_temperature=None)
    assert solution.rise(Estimate(350.0, 0.01)) == 350.0


def test_what_a_solution_lacks_is_refused_by_name():
    with pytest.raises(ValueError, match="has no profile"):
        make_solution().dataset("profile")


@pytest.mark.parametrize(("converged", "word"), [(True, "converged ("), (False, "not converged (")])
def test_a_solution_shows_whether_it_converged(converged, word):
    ending = Ending.WIDER_BARS if converged else Ending.LARGEST_GRID
    solution = replace(make_hot_worm(), converged=converged, ending=ending)
    assert ending.converged is converged and not solution.accurate
    solution = replace(solution, composite_roughness=1e-7)
    _, rows = solution.shown()
    assert rows["status"].startswith(word)
    assert ("specific_film" in solution.summary()) is converged
    assert bool(solution.figure_text(QUANTITIES["film_min"])) is converged


def test_a_transient_solve_beyond_memory_is_lost(monkeypatch):
    monkeypatch.setattr(time_integration, "shortage", lambda grid, model: "needs 9 GB")
    time_grid = SimpleNamespace(
        grid=lambda seconds, refinement: None, begin=0.0, plan=SimpleNamespace(model=None)
    )
    with pytest.raises(next_film.NoFilmError, match="needs 9 GB"):
        time_integration._require_memory(time_grid, 1)


def test_passes_end_with_a_film_that_did_not_converge(monkeypatch):
    ball = circular(100, 10)
    starved = replace(ball, oil=replace(ball.oil, supply=2e-7))
    solution = replace(make_solution(), converged=False)
    monkeypatch.setattr(passes_module, "solve", lambda *given, **how: solution)
    assert list(passes_module.passes(starved, 5)) == [solution]


def test_a_refused_plan_shows_why():
    plan = pyworm.plan(circular(100, 10), 0.05)
    assert "refused" in str(replace(plan, refusal="refused: no grid").shown())
    assert "refused" not in str(plan.shown())
