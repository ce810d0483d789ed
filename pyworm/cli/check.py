"""pyworm check: validate a case and show its plan without solving it."""

import argparse
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from pyworm.case.case import Case, load
from pyworm.cli.arguments import add_accuracy_and_effects, add_case
from pyworm.cli.shared import CONVERGED, planned_tasks, warn_of_unusual
from pyworm.io.json import print_json
from pyworm.io.stage import stage

if TYPE_CHECKING:
    from pyworm.io.console import Console


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    check = commands.add_parser("check", help="check a case and show its plan; nothing is solved")
    add_case(check)
    add_accuracy_and_effects(check)
    check.set_defaults(command=_check)


def _check(options: argparse.Namespace) -> int:
    case = load(options.case)
    tasks = planned_tasks(case, options)
    warn_of_unusual(case)

    from pyworm.batch.expected_run import expected_run
    from pyworm.io.console import Console
    from pyworm.io.quantity_text import duration
    from pyworm.report.console.scenes import effects_table, plan_table
    from pyworm.scene.summary import scene_summary
    from pyworm.solver import neglected_effects

    with stage("estimating times and the influence of neglected effects"):
        of_run = expected_run(case, tasks)
        expected = of_run.each
        without = [neglected_effects.expected(task.scene, task.plan) for task in tasks]
    if options.json:
        scenes = [
            scene_summary(task.scene)
            | lacking.summary()
            | {
                "plan": asdict(task.plan),
                "effects": [asdict(effect) for effect in task.plan.effects],
                "expected_seconds": expectation.seconds,
                "expected_convolutions": expectation.convolutions,
            }
            for task, lacking, expectation in zip(tasks, without, expected, strict=True)
        ]
        content: dict[str, Any] = {"case": case.name, "resolved": case.resolved, "scenes": scenes}
        if case.drive is not None:
            content |= {
                "drive": case.drive.geometry_table(),
                "assumptions": case.drive.all_assumptions,
            }
        content["expected_seconds"] = of_run.seconds
        content["expected_seconds_of_search"] = of_run.search
        print_json(content | {"warnings": case.warnings, "beyond_limits": case.beyond_limits})
    else:
        console = Console()
        console.print(f"{case.title}\n{case.source}\n")
        for sentence in case.beyond_limits:
            console.print(f"{sentence}\n")
        if sentence := neglected_effects.worst(without).sentence:
            console.print(f"{sentence} (Films by closed forms.)\n")
        _print_drive(console, case)
        for task, expectation in zip(tasks, expected, strict=True):
            console.print(plan_table(task.scene, task.plan, expectation))
            console.print(effects_table(task.plan.effects, "Effects"))
        if len(tasks) > 1:
            console.print(f"Expected time of all {len(tasks)}: {duration(of_run.seconds)}")
        if of_run.search > 0:
            found = " and ".join(key for keys in case.left_open.values() for key in keys)
            console.print(f"Search for {found} before that: {duration(of_run.search)}")
    return CONVERGED


def _print_drive(console: "Console", case: Case) -> None:
    """The drive as it was computed, with its assumptions; nothing of a contact without one."""
    from pyworm.case.workshop_units import assumptions
    from pyworm.report.console.drive import drive_table

    if case.drive is None or (table := drive_table(case.drive)) is None:
        return
    console.print(table)
    for sentence in case.drive.all_assumptions:
        console.print(f"- {sentence}")
    for key, reason in assumptions(case.tables).items():
        console.print(f"- {key}: {reason}.")
    console.print()
