"""pyworm precision: error against time for one contact of a case."""

import argparse
import math
from pathlib import Path

from pyworm.case.case import load
from pyworm.cli.arguments import add_case
from pyworm.cli.shared import CONVERGED, FAILED, NOT_CONVERGED, end_with, planned_tasks
from pyworm.io.atomic import atomic_directory, check_writable
from pyworm.io.input_error import CaseError
from pyworm.io.json import as_json, print_json
from pyworm.io.terminal import print_message

BUDGET = 300.0
"""Time that a study of precision may take unless another is given [s]."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    precision = commands.add_parser("precision", help="error against CPU time for one contact")
    add_case(precision)
    precision.add_argument(
        "--budget",
        type=_time_limit,
        default=BUDGET,
        metavar="SECONDS",
        help="time limit in seconds (default: %(default)g)",
    )
    precision.add_argument("--out", type=Path, help="directory (default: results/ and its name)")
    precision.set_defaults(command=_precision, accuracy=None, effects=None)


def _time_limit(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = math.nan
    if not seconds > 0:
        raise argparse.ArgumentTypeError(f"{text}: must be a number of seconds above 0")
    return seconds


def _precision(options: argparse.Namespace) -> int:
    case = load(options.case)
    directory = options.out or Path("results") / case.name / "precision"
    check_writable(directory)
    tasks = planned_tasks(case, options)
    task = tasks[len(tasks) // 2]  # of a mesh cycle the middle

    from pyworm.io.console import Console, progress_bar
    from pyworm.io.quantity_text import duration
    from pyworm.kernel.core import KernelError
    from pyworm.plots.layout import write
    from pyworm.plots.precision import draw_precision
    from pyworm.precision.survey import BudgetError, NoReferenceError, expected_seconds, study
    from pyworm.precision.tables import as_object, write_csv
    from pyworm.report.console.precision import cheapest_table

    name = ", ".join(part for part in (case.name, str(task.place)) if part)
    expected = expected_seconds(task.scene, task.quantities)
    print_message(
        f"{name}: some {duration(min(expected, options.budget))}, "
        f"of {duration(expected)} without a budget"
    )
    try:
        with progress_bar() as progress:
            studied = study(task.scene, task.quantities, options.budget, progress)
    except BudgetError as error:
        raise CaseError(f"--budget {options.budget:g}: {error}") from None
    except KernelError as error:
        return end_with(f"{name}: {error}", FAILED)
    except NoReferenceError as error:
        return end_with(f"{name}: {error}", NOT_CONVERGED)
    content = {"case": case.name} | as_object(studied)
    with atomic_directory(directory, instead_of=("precision.*",)) as aside:
        (aside / "precision.json").write_text(as_json(content), encoding="utf-8")
        write_csv(studied, aside / "precision.csv")
        figure = draw_precision(studied, name)
        for ending in ("png", "svg"):
            write(figure, aside / f"precision.{ending}")
    if options.json:
        print_json(content)
    else:
        console = Console()
        console.print(cheapest_table(studied))
        for line in studied.omitted:
            console.print(f"omitted: {line}")
        console.print(f"Results  {directory}/precision.*", soft_wrap=True)
    return CONVERGED
