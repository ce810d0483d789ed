"""pyworm check: validate a case and show its plan without solving it."""

import argparse
from typing import TYPE_CHECKING

from pyworm.case.case import Case, load
from pyworm.cli.arguments import add_accuracy_and_effects, add_case
from pyworm.cli.shared import CONVERGED, planned_tasks, warn_of_unusual
from pyworm.io.json import print_json

if TYPE_CHECKING:
    from pyworm.batch.check import CheckedCase
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

    from pyworm.batch.check import checked_case

    found = checked_case(case, tasks)
    if options.json:
        print_json(found.summary())
    else:
        _show(found)
    return CONVERGED


def _show(found: "CheckedCase") -> None:
    """The gears as computed, the contacts with their plans, and the expected time."""
    from pyworm.io.console import Console
    from pyworm.io.quantity_text import duration
    from pyworm.report.console.scenes import effects_table, plan_table
    from pyworm.solver.neglected_effects import worst

    console, case = Console(), found.case
    console.print(f"{case.title}\n{case.source}\n")
    for sentence in found.beyond_limits:
        console.print(f"{sentence}\n")
    without = [contact.neglected_effects for contact in found.contacts]
    if sentence := worst(without).sentence:
        console.print(f"{sentence} (Films by closed forms.)\n")
    _print_drive(console, case)
    for contact in found.contacts:
        console.print(plan_table(contact.scene, contact.plan, contact.expected))
        console.print(effects_table(contact.plan.effects, "Effects"))
    if len(found.contacts) > 1:
        seconds = duration(found.expected_seconds)
        console.print(f"Expected time of all {len(found.contacts)}: {seconds}")
    if found.search_seconds > 0:
        unknowns = " and ".join(key for keys in case.left_open.values() for key in keys)
        console.print(f"Search for {unknowns} before that: {duration(found.search_seconds)}")


def _print_drive(console: "Console", case: Case) -> None:
    """The drive as it was computed, with its assumptions; nothing of a contact without one."""
    from pyworm.case.workshop_units import assumptions
    from pyworm.report.console.drive import drive_tables

    if case.drive is None or not (tables := drive_tables(case.drive)):
        return
    for table in tables:
        console.print(table)
    for sentence in case.drive.all_assumptions:
        console.print(f"- {sentence}")
    for key, reason in assumptions(case.tables).items():
        console.print(f"- {key}: {reason}.")
    console.print()
