"""pyworm duty: temperatures, losses, wear and damage of a gear unit over its duty."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.case.case import Case, load
from pyworm.cli.arguments import add_json
from pyworm.cli.shared import CONVERGED, NOT_CONVERGED, end_with, warn_of_unusual
from pyworm.io.atomic import atomic_directory, check_writable
from pyworm.io.json import print_json
from pyworm.io.quantity_text import percent
from pyworm.io.terminal import print_message, print_result

if TYPE_CHECKING:
    from pyworm.batch.duty_run import CaseDuty

BLOCKS, TEMPERATURES, PICTURE = "blocks.csv", "temperatures.csv", "duty.png"

RUN_IN_STATES, RUN_IN_PICTURE = "running_in.csv", "running_in.png"


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    duty = commands.add_parser(
        "duty", help="temperatures, losses, wear and damage of a gear unit over its [duty]"
    )
    duty.add_argument("case", type=Path, metavar="CASE.toml")
    duty.add_argument(
        "--table", type=Path, metavar="CSV", help="loss table of the gears (pyworm table)"
    )
    duty.add_argument(
        "--solve", type=int, default=0, metavar="N", help="loads that are solved, heaviest first"
    )
    duty.add_argument(
        "--running-in",
        action="store_true",
        help="the programme of [running_in] instead, compared with none",
    )
    duty.add_argument(
        "--out", type=Path, help="directory (default: results/, the case's name, duty)"
    )
    add_json(duty)
    duty.set_defaults(command=_duty)


def _duty(options: argparse.Namespace) -> int:
    case = load(options.case)
    directory = options.out or Path("results") / case.name / "duty"
    check_writable(directory)
    warn_of_unusual(case)
    return (_run_in if options.running_in else _over_blocks)(case, directory, options)


def _over_blocks(case: Case, directory: Path, options: argparse.Namespace) -> int:
    from pyworm.batch.duty_run import duty
    from pyworm.batch.operating_points import NotSolvedError
    from pyworm.plots.duty import draw_duty
    from pyworm.plots.layout import write
    from pyworm.report.duty import blocks_csv, temperatures_csv

    try:
        found = duty(case, table=options.table, solve_loads=options.solve, progress=print_message)
    except NotSolvedError as error:
        return end_with(f"{case.name}: {error}", NOT_CONVERGED)
    with atomic_directory(directory) as aside:
        (aside / BLOCKS).write_text(blocks_csv(found), encoding="utf-8")
        (aside / TEMPERATURES).write_text(temperatures_csv(found), encoding="utf-8")
        write(draw_duty(found), aside / PICTURE)
    if options.json:
        print_json(found.summary())
        return CONVERGED
    _show(found)
    print_result(f"Written   {directory}: {BLOCKS}, {TEMPERATURES}, {PICTURE}")
    return CONVERGED


def _run_in(case: Case, directory: Path, options: argparse.Namespace) -> int:
    from pyworm.batch.running_in import running_in
    from pyworm.io.console import Console
    from pyworm.plots.layout import write
    from pyworm.plots.running_in import draw_running_in
    from pyworm.report.running_in import stages_table, states_csv, words

    found = running_in(case)
    with atomic_directory(directory) as aside:
        (aside / RUN_IN_STATES).write_text(states_csv(found), encoding="utf-8")
        write(draw_running_in(found), aside / RUN_IN_PICTURE)
    if options.json:
        print_json(found.summary())
        return CONVERGED
    console = Console()
    console.print(stages_table(found))
    for sentence in words(found):
        console.print(sentence)
    print_result(f"Written   {directory}: {RUN_IN_STATES}, {RUN_IN_PICTURE}")
    return CONVERGED


def _show(found: "CaseDuty") -> None:
    """The blocks as a table, and the sums in sentences."""
    from pyworm.io.console import Console
    from pyworm.report.duty import blocks_table, damage_table, words

    console = Console()
    console.print(blocks_table(found))
    console.print(damage_table(found))
    for sentence in words(found):
        console.print(sentence)
    for each in found.confirmed:
        console.print(
            f"Solved: {each.block}, loss between the teeth {each.tooth_loss:.4g} W ± {percent(each.error)}, "
            f"{each.closed_form_loss:.4g} W before ({100 * each.deviation:+.0f} %)."
        )
