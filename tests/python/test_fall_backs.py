"""Every fall-back of the solver, of plans and of batch work is made happen by a test, exceptions or not."""

import ast
import os
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from handlers import REACHED, all_branches, all_handlers

TESTS = Path(__file__).parent
BRANCHES: dict[str, str] = tomllib.loads(
    (TESTS.parent / "support/branches.toml").read_text("utf-8")
)

MADE_BY = {
    "batch/calibrate.py bench_of CaseError":
        "case/test_measured_table.py::test_measurements_that_do_not_fit_the_case_are_refused",
    "batch/adjoint_changes.py _kept (ValueError, KernelError)":
        "batch/test_design.py::test_slopes_are_those_of_closed_forms_where_there_is_no_adjoint",
    "batch/adjoint_changes.py _kept suppress OSError":
        "batch/test_design.py::test_solved_contacts_lead_to_the_limit_and_are_found_again",
    "batch/loss_table.py table_mesh ValueError":
        "batch/test_loss_table.py::test_other_gears_and_oils_of_one_temperature_are_refused",
    "batch/design.py _Search._confirmed_best NotSolvedError":
        "batch/test_design.py::test_a_best_design_without_a_more_accurate_solution_gives_way_to_the_next",
    "batch/design.py _Search._tried NotSolvedError":
        "batch/test_design.py::test_a_contact_without_a_solution_is_passed_over_but_not_that_of_the_case",
    "batch/design_model.py estimated ValueError":
        "batch/test_design.py::test_a_design_without_a_heat_balance_cannot_be",
    "batch/solved_designs.py DesignSolver._slopes CaseError":
        "batch/test_design.py::test_slopes_are_those_of_closed_forms_where_a_variable_cannot_be_moved",
    "batch/design_model.py laid_out (ValueError, ArithmeticError)":
        "batch/test_design.py::test_designs_that_there_cannot_be_are_avoided",
    "batch/run_sensitivities.py sensitivities_of_run (NoAdjointError, KernelError)":
        "batch/test_key_sensitivities.py::test_a_run_has_sensitivities_by_adjoints_or_by_closed_forms",
    "batch/key_sensitivities.py both_sides ValueError":
        "batch/test_key_sensitivities.py::test_numbers_that_cannot_be_moved_are_named_with_the_reason",
    "batch/key_sensitivities.py key_sensitivities ValueError":
        "batch/test_key_sensitivities.py::test_numbers_that_cannot_be_moved_are_named_with_the_reason",
    "batch/calibration.py Bench._point CaseError":
        "case/test_measured_table.py::test_measurements_that_do_not_fit_the_case_are_refused",
    "batch/uncertain_run.py _moved CaseError":
        "batch/test_uncertain_run.py::test_exact_inputs_and_impossible_moves_are_refused",
    "batch/request.py planned ValueError":
        "batch/test_run.py::test_a_contact_that_cannot_be_planned_is_refused",
    "batch/duty.py duty_model ValueError":
        "batch/test_duty.py::test_a_unit_without_sizes_or_cooling_is_refused",
    "batch/duty_run.py duty ValueError":
        "batch/test_duty.py::test_solved_loads_correct_the_losses",
    "batch/duty_run.py _table ValueError":
        "batch/test_duty.py::test_a_unit_without_sizes_or_cooling_is_refused",
    "batch/running_in.py running_in ValueError":
        "batch/test_running_in.py::test_programmes_that_cannot_be_are_refused",
    "batch/wear.py wear ValueError":
        "batch/test_run.py::test_wear_needs_a_roughness",
    "batch/case_run.py _collected OSError":
        "solver/test_memory.py::test_first_grids_beyond_memory_are_refused",
    "batch/case_run.py _solved_before FileNotFoundError":
        "batch/test_faults.py::test_a_truncated_result_is_refused",
    "batch/case_run.py _solved_before ValueError":
        "batch/test_faults.py::test_a_run_over_a_damaged_result_solves_again",
    "batch/case_run.py run OSError":
        "batch/test_solved_scenes.py::test_the_only_scene_is_kept_where_its_result_cannot_be_written",
    "batch/cluster.py _watch Exception":
        "batch/test_cluster.py::test_a_scheduler_lost_on_the_way_is_one_sentence_and_what_was_solved_is_kept",
    "batch/cluster.py cluster (OSError, ValueError)":
        "batch/test_cluster.py::test_a_missing_scheduler_is_reported",
    "batch/cluster.py cluster CancelledError":
        "batch/test_cluster.py::test_a_scheduler_lost_on_the_way_is_one_sentence_and_what_was_solved_is_kept",
    "batch/cluster.py cluster ImportError":
        "batch/test_batch_fall_backs.py::test_without_dask_a_scheduler_is_refused_with_what_to_install",
    "batch/transient_solutions.py LifePart._restart (OSError, DamagedError)":
        "solver/test_stretches.py::test_where_films_to_go_on_from_are_damaged_a_solve_begins_with_the_life",
    "batch/transient_solutions.py LifePart._solve_some NoFilmError":
        "batch/test_transient_solutions.py::test_finer_solves_are_not_begun_where_the_first_finds_no_film",
    "batch/transient_solutions.py LifePart.solve_into Exception":
        "batch/test_batch_fall_backs.py::test_a_life_that_breaks_costs_its_own_tasks_alone",
    "batch/transient_solutions.py drop_rates suppress OSError":
        "batch/test_batch_fall_backs.py::test_a_file_that_cannot_be_removed_costs_nothing",
    "batch/transient_solutions.py is_transient ValueError":
        "batch/test_batch.py::test_a_failing_scene_is_reported_and_costs_no_other",
    "batch/transient_solutions.py left_for (OSError, DamagedError)":
        "batch/test_transient_solutions.py::test_a_damaged_file_of_a_life_counts_as_none",
    "batch/transient_solutions.py tasks_by_part ValueError":
        "batch/test_batch_fall_backs.py::test_a_life_without_load_has_no_parts",
    "batch/tooth_lifts.py steady_ratios Exception":
        "batch/test_transient_lifts.py::test_where_steady_films_are_not_found_lifts_stay_as_they_are",
    "batch/tooth_lifts.py lifts_of suppress Exception":
        "batch/test_transient_lifts.py::test_a_part_that_breaks_costs_its_own_lifts_alone",
    "batch/tooth_lifts.py PartLifts.__call__ suppress KernelError":
        "batch/test_transient_lifts.py::test_no_lift_is_known_of_films_that_are_not_found",
    "batch/provenance.py _git (OSError, subprocess.TimeoutExpired)":
        "batch/test_provenance.py::test_without_git_there_is_no_commit",
    "batch/scene_task.py require_sendable Exception":
        "batch/test_batch_fall_backs.py::test_a_scene_that_no_process_would_find_is_refused",
    "batch/solve_tasks.py solve_and_keep Exception":
        "batch/test_batch.py::test_a_failing_scene_is_reported_and_costs_no_other",
    "batch/solve_tasks.py solve_and_keep KernelError":
        "solver/test_memory.py::test_first_grids_beyond_memory_are_refused",
    "batch/solved_scenes.py Store._stored ValueError":
        "batch/test_solved_scenes.py::test_a_damaged_scene_is_solved_again",
    "batch/solved_scenes.py Store.drop suppress OSError":
        "batch/test_faults.py::test_a_truncated_result_is_refused",
    "batch/solved_scenes.py Store.holds OSError":
        "batch/test_study.py::test_progress_rises_to_one",
    "batch/solved_scenes.py Store.secure suppress OSError":
        "batch/test_batch_fall_backs.py::test_what_cannot_be_secured_on_a_full_disk_does_not_hide_the_first_error",
    "batch/solved_scenes.py Store.solved suppress OSError":
        "batch/test_study.py::test_progress_rises_to_one",
    "batch/solved_scenes.py Store.summary (ValueError, LookupError, TypeError, RecursionError)":
        "batch/test_batch.py::test_stored_scalars_are_unchanged",
    "batch/study.py _study ValueError":
        "batch/test_batch_fall_backs.py::test_a_contact_that_cannot_be_planned_is_refused_with_what_varies",
    "batch/sweep.py _tasks ValueError":
        "batch/test_sweep.py::test_a_bad_sweep_is_refused_in_one_sentence",
    "batch/sweep.py load_sweep CaseError":
        "batch/test_sweep.py::test_a_bad_sweep_is_refused_in_one_sentence",
    "batch/wear_integration.py integrate_wear UnsolvedError":
        "batch/test_wear_integration.py::test_a_rate_that_is_not_known_is_no_step",
    "batch/wear_run.py WearRun._restored DamagedError":
        "batch/test_wear_run.py::test_a_damaged_state_is_not_gone_on_with",
    "batch/wear_run.py WearRun._restored FileNotFoundError":
        "batch/test_wear_run.py::test_wear_is_drawn",
    "batch/wear_run.py WearRun._solved ValueError":
        "batch/test_batch_fall_backs.py::test_worn_flanks_that_cannot_be_solved_are_told_with_the_contacts_that_are_not",
    "batch/workers.py _Worker.call (EOFError, OSError)":
        "batch/test_batch.py::test_a_process_that_died_is_replaced",
    "batch/workers.py _serve (EOFError, OSError)":
        "batch/test_batch_fall_backs.py::test_a_process_that_serves_sends_errors_and_ends_with_its_connection",
    "batch/workers.py _serve Exception":
        "batch/test_batch_fall_backs.py::test_a_process_that_serves_sends_errors_and_ends_with_its_connection",
    "batch/workers.py _serve OSError":
        "batch/test_batch_fall_backs.py::test_a_process_that_serves_sends_errors_and_ends_with_its_connection",
    "planning/by_formula.py films_by_formula ValueError":
        "planning/test_planning_fall_backs.py::test_the_film_of_a_contact_point_at_rest_follows_from_no_formula",
    "planning/effects/selection.py _understood ValueError":
        "batch/test_sweep.py::test_a_bad_sweep_is_refused_in_one_sentence",
    "planning/plan.py plan_of ArithmeticError":
        "planning/test_planning_fall_backs.py::test_numbers_beyond_all_arithmetic_are_refused_in_one_sentence",
    "planning/prediction.py _carried_load ValueError":
        "planning/test_planning_fall_backs.py::test_a_contact_that_carried_no_load_before_is_compared_with_its_first_load",
    "solver/cost/calibration.py _processor OSError":
        "solver/test_solver_fall_backs.py::test_a_processor_without_a_file_of_its_name_has_that_of_the_platform",
    "solver/cost/calibration.py calibration (OSError, ValueError, KeyError, TypeError)":
        "solver/test_solver_fall_backs.py::test_where_nothing_can_be_kept_the_speed_is_measured_each_time",
    "solver/cost/calibration.py calibration OSError":
        "solver/test_solver_fall_backs.py::test_where_nothing_can_be_kept_the_speed_is_measured_each_time",
    "solver/cost/expected_motion.py time_grid_if_any ValueError":
        "solver/test_solver_fall_backs.py::test_a_contact_without_a_life_under_load_has_no_time_steps",
    "solver/cost/expected_motion.py motion ValueError":
        "solver/test_solver_fall_backs.py::test_a_contact_without_a_life_under_load_has_no_time_steps",
    "solver/estimate.py Estimate._with TypeError":
        "solver/test_solver_fall_backs.py::test_an_estimate_is_no_number_beside_what_is_none",
    "solver/grid_sequence.py GridSequence._compare_windows KernelError":
        "solver/test_memory.py::test_a_wider_window_beyond_memory_ends_the_grid_sequence",
    "solver/grid_sequence.py GridSequence._refine KernelError":
        "solver/test_memory.py::test_a_finer_grid_beyond_memory_ends_the_grid_sequence",
    "solver/newton.py newton_step KernelError":
        "solver/test_solver_fall_backs.py::test_a_newton_step_that_does_not_descend_is_none_and_other_failures_are_raised",
    "solver/patch/newton.py PatchNewton._newton KernelError":
        "solver/test_rough_patch.py::test_a_step_without_descent_is_an_error",
    "solver/sensitivities.py sensitivities (NoAdjointError, KernelError)":
        "solver/test_adjoint.py::test_without_a_film_on_the_coarser_grid_no_uncertainty_is_known",
    "solver/solve.py _no_worse KernelError":
        "solver/test_memory.py::test_a_wider_window_beyond_memory_ends_the_grid_sequence",
    "solver/transient/time_grid.py _at ValueError":
        "solver/test_solver_fall_backs.py::test_a_contact_without_a_life_under_load_has_no_time_steps",
    "solver/transient/time_grid.py _predicted ValueError":
        "solver/test_solver_fall_backs.py::test_a_contact_at_rest_is_no_knot_of_a_course",
    "solver/transient/time_integration.py _begun NoFilmError":
        "solver/test_transient.py::test_a_past_whose_film_is_not_found_is_reported",
    "solver/transient/time_integration.py _through_loads NoLoadError":
        "solver/test_transient.py::test_where_load_is_lost_while_coarse_steps_lead_the_films_begin_after_it",
    "solver/transient/time_integration.py _loaded_after suppress NoLoadError":
        "solver/test_transient.py::test_films_go_on_after_a_time_without_load",
    "solver/transient/time_integration.py _begun suppress NoLoadError":
        "solver/test_transient.py::test_where_load_is_lost_while_coarse_steps_lead_the_films_begin_after_it",
    "solver/transient/next_film.py contact_at ValueError":
        "solver/test_transient.py::test_a_time_without_load_has_no_film",
    "solver/transient/next_film.py _found NoLoadError":
        "solver/test_transient.py::test_a_time_without_load_has_no_film",
    "solver/transient/time_integration.py _resumed NoFilmError":
        "solver/test_solver_fall_backs.py::test_where_no_other_beginning_is_found_films_before_the_lost_one_are_kept",
    "solver/transient/next_film.py _found NoFilmError":
        "solver/test_solver_fall_backs.py::test_a_step_that_is_lost_is_halved",
    "solver/transient/next_film.py reached NoFilmError":
        "solver/test_backward_term.py::test_where_its_halves_are_lost_a_step_with_a_limited_rate_is_kept",
    "solver/transient/next_film.py reached suppress NoFilmError":
        "solver/test_backward_term.py::test_where_they_are_lost_the_whole_step_is_made_once",
    "solver/transient/time_integration.py _along NoLoadError":
        "solver/test_transient.py::test_a_time_without_load_has_no_film",
    "solver/transient/time_integration.py _along NoFilmError":
        "solver/test_solver_fall_backs.py::test_films_before_one_that_is_lost_are_kept_with_the_reason",
    "solver/transient/next_film.py _told KernelError":
        "solver/test_solver_fall_backs.py::test_a_film_that_the_kernel_gives_up_is_lost_at_its_time",
    "solver/transient/next_film.py _told ValueError":
        "solver/test_solver_fall_backs.py::test_a_film_that_the_kernel_gives_up_is_lost_at_its_time",
    "solver/transient/time_integration.py _from_first_touch NoFilmError":
        "solver/test_coming_together.py::test_where_the_film_of_flanks_that_come_together_is_not_found_it_begins_with_a_steady_one",
    "solver/transient/time_integration.py _from_first_touch NoFilmError 2":
        "solver/test_solver_fall_backs.py::test_where_the_life_after_the_touch_is_lost_too_what_was_found_before_it_is_kept",
    "solver/transient/transient.py finer (NoFilmError, TooMuchWorkError)":
        "solver/test_solver_fall_backs.py::test_a_finer_transient_solve_that_finds_no_film_leaves_the_rates_as_they_are",
    "solver/transient/transient.py rates_at_present (NoFilmError, ValueError)":
        "solver/test_transient.py::test_a_past_whose_film_is_not_found_is_reported",
}  # fmt: skip
"""Each `except` and `suppress` by file, function and exceptions -> a test that reaches it."""

ELSEWHERE = ("batch/cluster.py cluster CancelledError", "batch/cluster.py _watch Exception")
"""Those that are reached in processes that their tests start, where nobody looks."""


def test_each_fall_back_names_a_test_that_makes_it_happen():
    assert sorted(MADE_BY) == sorted(all_handlers())
    for node in set(MADE_BY.values()):
        file, name = node.split("::")
        defined = ast.parse((TESTS / file).read_text()).body
        assert name in {of.name for of in defined if isinstance(of, ast.FunctionDef)}, node


def test_each_branch_on_a_failure_names_a_test_that_takes_it():
    named = [name.removesuffix(": yes").removesuffix(": no") for name in BRANCHES]
    assert sorted(named) == sorted(all_branches())
    for node in set(BRANCHES.values()):
        file, name = node.split("::")
        defined = ast.parse((TESTS / file).read_text()).body
        assert name in {of.name for of in defined if isinstance(of, ast.FunctionDef)}, node


NAMED = {name: node for name, node in (MADE_BY | BRANCHES).items() if name not in ELSEWHERE}
"""Fall-backs that a test reaches in its own process -> that test."""


@pytest.fixture(scope="module")
def reached(tmp_path_factory):
    """Each fall-back that the named tests reached, with the file of the test; all of them run once."""
    told = tmp_path_factory.mktemp("fall_backs") / "reached.txt"
    nodes = [str(TESTS / node) for node in sorted(set(NAMED.values()))]
    run = [sys.executable, "-m", "pytest", "-q", "-m", "", "-p", "handlers", *nodes]
    paths = os.pathsep.join((str(TESTS.parent / "support"), os.environ.get("PYTHONPATH", "")))
    environment = os.environ | {REACHED: str(told), "PYTHONPATH": paths}
    done = subprocess.run(
        run, cwd=TESTS.parents[1], env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout
    rows = (line.split("\t") for line in told.read_text().splitlines())
    return {(name, test.partition("::")[0].removeprefix("tests/python/")) for name, test in rows}


@pytest.mark.long
@pytest.mark.parametrize("file", sorted({node.partition("::")[0] for node in NAMED.values()}))
def test_the_named_tests_reach_their_fall_backs(file, reached):
    wanted = {(name, file) for name, node in NAMED.items() if node.startswith(f"{file}::")}
    assert wanted <= reached
