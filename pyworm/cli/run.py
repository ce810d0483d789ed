"""pyworm run: solve a case, print its tables, write its results file and pictures."""

import argparse
from collections.abc import Sequence
from concurrent.futures import Executor
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pyworm.case.case import Case, load
from pyworm.cli.arguments import add_accuracy_and_effects, add_case, add_processes
from pyworm.io.atomic import check_writable, whole_file
from pyworm.io.json import print_json
from pyworm.io.terminal import print_message, print_result

if TYPE_CHECKING:
    from pyworm.batch.task import Task
    from pyworm.io.console import Console
    from pyworm.result.result import Result
from pyworm.cli.sensitive_run import SensitiveRun
from pyworm.cli.shared import (
    CONVERGED,
    FAILED,
    NOT_CONVERGED,
    PICTURES,
    batch_executor,
    drawn_pictures,
    end_with,
    planned_tasks,
    warn_of_refusals,
    warn_of_unusual,
)
from pyworm.cli.uncertain_run import UncertainRun

LIFE_TABLE = "life.csv"


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    run = commands.add_parser("run", help="solve a case: tables, results file, pictures")
    add_case(run)
    add_accuracy_and_effects(run)
    run.add_argument("--out", type=Path, help="directory (default: results/ and the case's name)")
    add_processes(run)
    run.add_argument(
        "--fields",
        choices=("rounded", "full"),
        default="rounded",
        help="rounded (default): fields to a tenth of their numerical uncertainty; full: all digits",
    )
    run.add_argument(
        "--pictures",
        choices=("key", "all", "none"),
        default="key",
        help="key (default): mesh cycle or curve, and the contact with the minimum film thickness",
    )
    run.add_argument(
        "--inputs-uncertain",
        action="store_true",
        help='uncertainty of the results by inputs written "0.4 um +- 0.1 um": two more solves for each',
    )
    run.add_argument(
        "--sensitivities",
        action="store_true",
        help="changes of the results with every number of the case, by adjoint solutions",
    )
    run.add_argument(
        "--stress",
        action="store_true",
        help="maximum von Mises stress below both surfaces, its depth, and a picture of it",
    )
    run.add_argument(
        "--thermal-stress",
        action="store_true",
        help="--stress with the thermal stress of the surface temperature",
    )
    run.set_defaults(command=_run)


def _run(options: argparse.Namespace) -> int:
    case = load(options.case)
    directory = options.out or Path("results") / case.name
    check_writable(directory)
    planned: Sequence[Task] = planned_tasks(case, options)
    warn_of_unusual(case)
    warn_of_refusals(planned)
    uncertain = UncertainRun(case, options)
    uncertain.announce()
    sensitive = SensitiveRun(options)

    from pyworm.batch.case_run import RESULT_NAME, NothingSolvedError
    from pyworm.batch.drive_iteration import run_balanced
    from pyworm.batch.overrun import overrun, processor_seconds
    from pyworm.io.console import progress_bar

    began = processor_seconds()
    with batch_executor(options) as executor:
        try:
            with progress_bar() as progress:
                how = executor, progress, print_message, options.fields == "full"
                result, tasks = run_balanced(case, planned, directory, *how)
        except NothingSolvedError as error:
            if options.json:
                told = {"case": case.name, "scenes": [], "failed": error.reasons}
                print_json(told | {"warnings": list(case.warnings), "stop_reason": str(error)})
            return end_with(f"{case.name}: {error}", FAILED)
        if options.stress or options.thermal_stress:
            from pyworm.batch.run_stress import stressed_run

            heat = options.thermal_stress
            result = stressed_run(result, tasks, directory, print_message, thermal=heat)
        result = uncertain.completed(result, tasks, directory, executor)
        for warning in result.provenance["warnings"][len(case.warnings) :]:
            print_message(f"warning: {warning}")
        if not options.json:
            _show_run(case, tasks, result)
            uncertain.show(result)
        result = sensitive.completed(result, tasks, directory)
        if not options.json:
            sensitive.show(directory)
            print_result(f"Results   {directory / RESULT_NAME}")
        # After the figures, which no picture may cost; and by this machine, since others need not reach
        # this place.
        drawers = None if options.scheduler else executor
        pictures = _pictures(result, directory, options.pictures, drawers)
        pictures += uncertain.pictures(result, directory)
        table = _table_of_lives(result, directory)
    _show_files(case, tasks, result, options, directory, pictures, table, sensitive.summary)
    if not options.scheduler and (
        why := overrun(case, planned, result, processor_seconds() - began - sensitive.seconds)
    ):
        print_message(f"{case.name}: {why.sentence}")
    if result.shortfall is None:
        return CONVERGED
    return end_with(f"{case.name}: {result.shortfall}", NOT_CONVERGED)


def _show_files(
    case: Case,
    tasks: Sequence,
    result: "Result",
    options: argparse.Namespace,
    directory: Path,
    pictures: Sequence[str],
    table: Path | None,
    more_found: dict[str, Any],
) -> None:
    """Show which files a run has left; under `--json` beside all that it found, and more."""
    from pyworm.batch.case_run import RESULT_NAME

    if options.json:
        files = {
            "results": str(directory / RESULT_NAME),
            **({} if table is None else {"life_table": str(table)}),
            "pictures": [str(directory / name) for name in pictures],
        }
        print_json(_summary(case, tasks, result) | more_found | files)
    else:
        more = "; --pictures all: those of every contact" if options.pictures == "key" else ""
        print_result(f"Pictures  {directory}/*.png ({len(pictures)}{more})")
        if table is not None:
            print_result(f"Life      {table}: results with uncertainties at every time")


def _summary(case: Case, tasks: Sequence, result: "Result") -> dict[str, Any]:
    """What a run found, under `--json`; `stop_reason` where a contact lacks the accuracy asked for."""
    from pyworm.ratings.heating import heating_of
    from pyworm.ratings.mesh_loss import mesh_loss
    from pyworm.ratings.standard_loss import standard_loss
    from pyworm.result.life import lives
    from pyworm.result.mesh_cycle import drive_cycle

    cycle, standard = drive_cycle(result), standard_loss(case)
    heating, loss = (
        heating_of(tasks[0].case, cycle, standard, result),
        mesh_loss(case.drive, result),
    )
    inputs = result.input_uncertainty
    lives_found = [life.summary() for life in lives(result)]
    return {
        "case": case.name,
        "scenes": [solution.summary() for solution in result.solutions],
        "failed": result.provenance["failed"],
        "warnings": result.provenance["warnings"],
        "beyond_limits": tasks[0].case.beyond_limits,
        **({} if result.shortfall is None else {"stop_reason": result.shortfall}),
        **({} if cycle is None else {"cycle": cycle.summary()}),
        **({} if case.drive is None else {"standard_loss": standard.summary()}),
        **({} if heating is None else {"heating_loss": heating.summary()}),
        **({} if loss is None else {"mesh_loss": loss.summary()}),
        **({} if inputs is None else {"input_uncertainty": inputs.summary()}),
        **({"lives": lives_found} if lives_found else {}),
    }


def _pictures(
    result: "Result", directory: Path, which: str, executor: Executor | None
) -> list[str]:
    """Names of the pictures drawn of a result."""
    if which == "none":
        return []
    from pyworm.plots.draw import draw

    drawing = partial(draw, result, executor=executor, key_only=which == "key")
    return drawn_pictures(directory, drawing, PICTURES)[0]


def _table_of_lives(result: "Result", directory: Path) -> Path | None:
    """Write the figures of transient solutions over time as a table; None without any, or if that fails."""
    from pyworm.result.life import as_csv, lives

    found = lives(result)
    if not found:
        return None
    path = directory / LIFE_TABLE
    try:
        with whole_file(path) as partial_file:
            partial_file.write_text(as_csv(found), encoding="utf-8")
    except OSError as error:
        print_message(f"no table of the life: {error}")
        return None
    return path


NO_LOSS = (
    "No efficiency is given: it needs friction (--effects auto or all, and an oil with [oil.shear]) and "
    "three or more phases under load."
)


def _show_run(case: Case, tasks: Sequence, result: "Result") -> None:
    """The tables of a run."""
    from pyworm.io.console import Console
    from pyworm.ratings.heating import heating_of
    from pyworm.ratings.mesh_loss import mesh_loss
    from pyworm.ratings.standard_loss import standard_loss
    from pyworm.report.console.mesh_cycle import (
        closed_form_table,
        cycle_table,
        loss_sentence,
        loss_table,
    )
    from pyworm.report.console.scenes import (
        effects_table,
        figures_table,
        heat_table,
        published_for,
        scenes_table,
        solution_table,
    )
    from pyworm.report.console.summary import summary_table
    from pyworm.result.headline import opening
    from pyworm.result.mesh_cycle import drive_cycle

    summaries = [solution.summary() for solution in result.solutions]
    failed = result.provenance["failed"]
    cycle, standard = drive_cycle(result), standard_loss(case)
    console = Console()
    loss = None if case.drive is None else mesh_loss(case.drive, result)
    console.print(f"{case.title}\n{case.source}\n")
    console.print(summary_table(result.solutions, cycle, loss))
    beyond = tasks[0].case.beyond_limits
    for line in opening(result.solutions, standard.words, beyond, summarised=True):
        console.print(f"{line}\n")
    scenes = [task.scene for task in tasks if task.scene.name not in failed]
    for scene, summary, solution in zip(scenes, summaries, result.solutions, strict=True):
        published = published_for(summary, case.published)
        if published or len(scenes) == 1:
            console.print(figures_table(scene, summary, published, case.body_names))
            console.print(solution_table(summary))
            console.print(effects_table(solution.effects, "Effects, judged by the solution"))
    if len(scenes) > 1:
        console.print(scenes_table(scenes, summaries))
        if all("friction_coefficient" in summary for summary in summaries):
            console.print(heat_table(scenes, summaries, case.body_names))
    closed_forms = None if result.mesh_cycle is None else closed_form_table(result.mesh_cycle)
    if closed_forms is not None:
        console.print(closed_forms)
    heating = heating_of(tasks[0].case, cycle, standard, result)
    if cycle is not None:
        console.print(cycle_table(cycle, case.body_names))
        if cycle.loss is not None:
            console.print(loss_table(cycle, standard, heating))
    if case.drive is not None and (cycle is None or cycle.loss is None):
        console.print(NO_LOSS if loss is None else loss_sentence(loss))
        if heating is not None:
            console.print(heating.words)
    _show_shortfalls(console, summaries, failed)


def _show_shortfalls(
    console: "Console", summaries: Sequence[dict[str, Any]], failed: dict[str, str]
) -> None:
    """Contacts that did not converge, are less accurate than requested, or could not be solved."""
    for summary in summaries:
        if not summary["converged"]:
            console.print(f"{summary['name']} did not converge: {summary['stop_reason']}")
        elif not summary["accurate"]:
            console.print(f"{summary['name']} is {summary['stop_reason']}")
    for name, reason in failed.items():
        console.print(f"{name} could not be solved: {reason}")
