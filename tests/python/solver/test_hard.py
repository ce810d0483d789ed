"""A quick part of the suite of hard scenes (tests/hard): seeded draws, and the closest looks at stability."""

import runpy
import sys
from dataclasses import replace
from unittest.mock import Mock

import numpy as np
import pytest
import stability
from draws import DRAWS, HOT_LIMITS, HOT_RANGES, LIMITS, RANGES
from folders import ROOT
from named import ISOTHERMAL, REFUSED
from promise import COUNTS, complaints
from trial import BriefTrial, Verdict, trial, verdict

import pyworm
from pyworm import kernel
from pyworm.batch.solved_scenes import Store
from pyworm.io.input_error import CaseError
from pyworm.kernel.core import NO_DESCENT, KernelError
from pyworm.planning.grid import Grid
from pyworm.scene.scales import scales
from pyworm.solver import contact
from pyworm.solver.contact import UNUSABLE_START_RESIDUAL
from pyworm.solver.ending import Ending
from pyworm.solver.newton import converge, newton_step
from pyworm.solver.point import level
from pyworm.solver.point.contact import PointContactSolver


@pytest.mark.parametrize(
    "name",
    [
        "isothermal:3",
        "isothermal:8",
        "isothermal:36",
        "thermal:22",
        "rough:1",
        "rough:106",
        "starved:2",
    ],
)
def test_random_scenes_converge(tmp_path, name):
    kind, _, number = name.partition(":")
    effects = "isothermal" if kind == "isothermal" else "all"
    one = trial(DRAWS[kind](int(number)).tables, name, tmp_path, effects)
    store = Store(tmp_path / "scenes", fields=False)
    first = verdict(one, store)
    assert first.outcome == "converged"
    assert verdict(one, store).figures["seconds"] == first.figures["seconds"]  # not solved again


@pytest.mark.parametrize("kind", DRAWS)
def test_draws_depend_on_their_number_alone_and_keep_to_their_ranges(kind):
    assert DRAWS[kind](5) == DRAWS[kind](5)
    traits = [DRAWS[kind](number).traits for number in range(60)]
    hot = HOT_RANGES | HOT_LIMITS
    plain = RANGES | LIMITS
    ranges = hot if kind in ("thermal", "rough") else plain
    for name in ("hertz_pressure", "moes_l", "ellipticity", "moes_m", "film"):
        values = np.array([of[name] for of in traits])
        low, high = ranges[name].low, ranges[name].high
        assert low <= values.min() and values.max() <= high
        # two thirds of the decades are met even by these few
        assert np.log(values.max() / values.min()) > 0.6 * np.log(high / low)


def came_to(outcome, number=0):
    return Verdict(f"thermal:{number}", outcome, "a reason", 1.0, (9, 9), {})


def test_only_the_default_seed_has_a_list_of_scenes_that_do_not_converge():
    verdicts = [came_to("not converged", 10**6), came_to("broken")]
    assert [said.split()[0] for said in complaints("thermal", verdicts)] == [
        "thermal:0",
        "thermal:1000000",
    ]
    assert complaints("thermal", verdicts, seed=7) == ["thermal:0 broke: a reason"]


@pytest.mark.parametrize(("missed", "kept"), [(4, True), (5, False)])
def test_the_promise_holds_for_any_seed(missed, kept):
    whole = COUNTS["thermal"]
    verdicts = [came_to("converged")] * (whole - missed) + [came_to("not converged")] * missed
    assert (complaints("thermal", verdicts, seed=7) == []) == kept


def test_results_of_seeds_are_kept_apart(tmp_path, capsys, monkeypatch):
    told = {}
    for seed in ("7", "8"):
        words = ["hard", "isothermal:3-3", "--seed", seed, "--out", str(tmp_path)]
        monkeypatch.setattr(sys, "argv", words)
        with pytest.raises(SystemExit, match="0"):
            runpy.run_path(str(ROOT / "tests" / "hard"), run_name="__main__")
        told[seed] = capsys.readouterr().out
        assert len(list((tmp_path / f"seed-{seed}" / "scenes").glob("*.json"))) == 1
    rows = [next(row for row in out.splitlines() if "isothermal:3" in row) for out in told.values()]
    assert rows[0] != rows[1]


def test_a_grid_on_which_newton_is_lost_costs_only_itself():
    """Its first grids are so coarse that no step helps; from where they end, none helps on finer ones."""
    scene = stability.scene_of(ISOTHERMAL["coarse-grid-lost"])
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.02, "isothermal"))
    assert solution.converged
    assert solution.history.sizes["iteration"] < 100
    assert solution.history.residual.max() < 20


def thermal_solver(number, seed, directory):
    """A drawn scene's plan at the suite's accuracy, and its solver."""
    one = trial(DRAWS["thermal"](number, seed).tables, "drawn", directory, "all")
    return one.plan, PointContactSolver(one.plan.simplified(one.scene), one.plan)


@pytest.mark.parametrize(("warming", "continues"), [(0.4, True), (0.6, False)])
def test_heat_continues_where_no_film_step_helps(tmp_path, warming, continues):
    """A film that no step improves is another one after a sweep that halves the change of temperature."""
    plan, solver = thermal_solver(0, 12, tmp_path)
    film_level, _ = solver.begin(plan.grids)
    film = film_level.film
    before = film.balance.warming

    def sweep_alone(forcing):
        film.balance = replace(film.balance, warming=warming * before)
        raise KernelError(NO_DESCENT)

    film.step = sweep_alone
    taken = newton_step(film_level)
    assert (taken is not None) == continues
    assert taken is None or taken.krylov == 0


def test_the_wider_window_starts_from_the_film_of_the_narrower_one(tmp_path):
    """From scratch this one stays at a residual of 5.3e-3, with a film 1.7 % thicker."""
    plan, solver = thermal_solver(0, 12, tmp_path)
    narrow, _ = solver.begin(plan.grids)
    converge(narrow, plan.tolerance, plan.target, 0.5)
    wide, _ = solver.in_wider_window(plan.wider_grids, narrow)
    assert wide.grid == plan.wider_grids[-1] != narrow.grid
    assert wide.film.balance.worst <= plan.tolerance / 10
    thin, thinner = (level.read().figures["film_min"] for level in (narrow, wide))
    assert thinner == pytest.approx(thin, rel=2e-3)


def test_a_step_after_which_heat_does_not_converge_is_the_last(tmp_path):
    plan, solver = thermal_solver(0, 12, tmp_path)
    film_level, _ = solver.begin(plan.grids)
    taken = [newton_step(film_level)]
    film_level.film.step = Mock(side_effect=KernelError(NO_DESCENT))
    assert taken[0] is not None
    assert newton_step(film_level) is None  # its warming is what it was


def test_an_extrapolated_film_that_no_oil_bears_is_no_initial_guess(tmp_path):
    """Its gradients ask for more stress than the limit: slip without bound."""
    plan, solver = thermal_solver(0, 12, tmp_path)
    film_level, _ = solver.begin(plan.grids)
    converge(film_level, plan.tolerance, plan.target, 0.5)
    (good, *_) = solver._guesses(film_level)
    rough = good.pressure * (1 + 0.9 * np.cos(np.pi * np.arange(good.pressure.shape[0])))[:, None]
    unusable_start = replace(good, pressure=rough)
    assert (
        solver._continued(film_level, unusable_start).film.balance.residual
        > UNUSABLE_START_RESIDUAL
    )
    solver._guesses = lambda level: iter((unusable_start, good))
    finer, steps = solver.refined(film_level)
    assert steps == []  # entered as it is, with its heat
    assert finer.film.balance.residual < 0.1


def test_a_film_hottest_in_a_spike_ends_with_all_else_accurate(tmp_path):
    """A temperature spike that no grid allowed resolves keeps neither films nor friction from their bars."""
    one = trial(DRAWS["thermal"](33, 7117).tables, "drawn", tmp_path, "all")
    scene = one.plan.simplified(one.scene)
    solution = pyworm.solve(scene, replace(one.plan, largest_grid=500_000))
    figures = solution.figures
    assert solution.converged
    assert solution.ending is Ending.ACCURATE_BUT_FOR_SPIKE
    assert solution.stop_reason.startswith(
        "the results have the requested accuracy but for the maximum film temperature, "
    )
    assert figures.temperature_max_film.error == np.inf
    assert "nodes wide" in figures.temperature_max_film.reason
    for name in ("film_min", "film_central", "friction_coefficient", "temperature_max_body_1"):
        assert getattr(figures, name).error <= one.plan.accuracy
        assert getattr(figures, name).reason is None


def test_a_law_no_cold_film_leads_to_is_softened_bit_by_bit_and_hot(tmp_path):
    """A limit of 2 to 3 % of the pressure at 12 to 15 m/s: no cold film bears its stresses."""
    one = trial(DRAWS["thermal"](45, 7117).tables, "drawn", tmp_path, "all")
    solution = pyworm.solve(one.plan.simplified(one.scene), one.plan)
    assert solution.converged, solution.stop_reason
    assert solution.figures.temperature_max_film.value > one.scene.oil.heat.inlet_temperature + 10


@pytest.mark.parametrize("number", range(5))
def test_each_history_is_simulated(number, tmp_path):
    """Also one whose surfaces carried no load a transit time ago."""
    one = trial(DRAWS["past"](number).tables, "past", tmp_path, ("isothermal", "squeeze"))
    assert "squeeze" in one.plan.on


def test_a_law_that_would_be_softened_in_too_many_steps_is_given_up(tmp_path, monkeypatch):
    """On a large grid they would take hours: the film is told not to be found, with infinite error."""
    monkeypatch.setattr(contact, "MOST_STAGE_NODES", 3e4)
    one = trial(DRAWS["thermal"](45, 7117).tables, "drawn", tmp_path, "all", BriefTrial)
    (solution,) = one.solved().solutions
    assert not solution.converged and solution.figures.film_min.error == np.inf


def test_pressures_of_single_nodes_do_not_jump_to_and_fro_without_end(tmp_path):
    """A film that slips and stiffens e-fold within a cell settles on its first grid: `rough:28`."""
    one = trial(DRAWS["rough"](28).tables, "jumping", tmp_path, "all", BriefTrial)
    (solution,) = one.solved().solutions
    assert "largest grid" in solution.stop_reason


def test_a_film_that_is_found_neither_cold_nor_hot_is_left_with_the_reason(tmp_path):
    """Cold it is several times as thick as warm, and far from a Newtonian one under 32 times its stresses."""
    one = trial(DRAWS["thermal"](36, 26267).tables, "drawn", tmp_path, "all", BriefTrial)
    (solution,) = one.solved().solutions
    assert not solution.converged
    assert solution.stop_reason.startswith("no film was found whose stresses and temperatures")
    assert solution.figures.film_min.error == np.inf


def test_a_restarted_film_keeps_its_outline_and_carries_its_load():
    scene = stability.scene_of(ISOTHERMAL["M200-L20"])
    size = scales(scene)
    a = size.hertz.semi_axis_x
    grid = Grid(-3 * a, -2 * a, a / 8, a / 8, 41, 33)
    film_level = level.first_level(scene, scene, size, grid)
    before = film_level.film.pressure.copy()
    film_level.film.start(before / 3, 5 * size.film)
    level.restart(scene, size, film_level)
    outline = np.ones(grid.shape, dtype=bool)
    outline[1:-1, 1:-1] = False
    assert np.array_equal(film_level.film.pressure[outline], before[outline] / 3)
    assert film_level.film.pressure.sum() * grid.cell == pytest.approx(film_level.load, rel=1e-3)
    assert film_level.film.thickness().min() > 0.5 * size.film


@pytest.mark.long
@pytest.mark.parametrize("name", ["coarse-grid-lost"])
def test_small_changes_have_small_effects(name):
    assert list(stability.small_changes(lambda row: None, (name,))) == []


@pytest.mark.parametrize("name", ["coarse-grid-lost"])
def test_first_guesses_do_not_matter(name):
    assert list(stability.first_guesses(lambda row: None, (name,))) == []


def test_mirrored_scenes_have_mirrored_films():
    assert list(stability.mirrors(lambda row: None, range(3, 9, 5))) == []


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_no_contact_is_refused(name):
    tables, said = REFUSED[name]
    with pytest.raises((CaseError, ValueError), match=said):
        scene = stability.scene_of(tables)
        pyworm.plan(scene)


def test_kernel_statuses_all_have_words():
    status = ROOT / "fortran" / "base" / "status.f90"
    numbers = [
        int(line.rpartition("=")[2])
        for line in status.read_text().splitlines()
        if "integer, parameter" in line
    ]
    assert [str(kernel.KernelError(number)) for number in numbers if number]
