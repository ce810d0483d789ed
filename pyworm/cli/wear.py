"""pyworm wear: the wear of the wheel of a worm gear set over its service life."""

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.case.case import Case, load
from pyworm.cli.arguments import add_case, add_processes
from pyworm.cli.shared import CONVERGED, FAILED, batch_executor, end_with, planned_tasks
from pyworm.formulas.wear_law import WEAR_ACCURACY, WEAR_COEFFICIENT, WEAR_TOLERANCE
from pyworm.io.atomic import check_writable, whole_file
from pyworm.io.input_error import CaseError
from pyworm.io.json import print_json
from pyworm.io.quantities import QUANTITIES
from pyworm.io.terminal import print_message, print_result

if TYPE_CHECKING:
    from pyworm.batch.wear_run import WearFigures, WearRun


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    wear = commands.add_parser("wear", help="wear of the worm wheel over its service life")
    add_case(wear)
    wear.add_argument(
        "--hours", type=float, required=True, metavar="H", help="operating hours to simulate"
    )
    how = wear.add_mutually_exclusive_group()
    how.add_argument(
        "--coefficient",
        type=float,
        metavar="K",
        help=f"k of Archard's law in m2/N (default: {WEAR_COEFFICIENT:g} for steel on tin bronze, known to a "
        "factor of 3; none for plastic wheels)",
    )
    how.add_argument(
        "--energy",
        type=float,
        metavar="E",
        help="friction energy per worn volume in J/m3, instead of k",
    )
    how.add_argument(
        "--calibrate",
        action="store_true",
        help="fit k to the wear rate of the run-in flank by the standard ([worm_rating])",
    )
    wear.add_argument(
        "--tolerance",
        type=float,
        default=WEAR_TOLERANCE * 1e6,
        metavar="UM",
        help="maximum error of the depth in a step in micrometres, in addition to 2 %% of the maximum depth "
        "(default: %(default)g)",
    )
    wear.add_argument(
        "--worm-ratio",
        type=float,
        metavar="R",
        help="k of the worm over that of the wheel (default: by their hardnesses)",
    )
    wear.add_argument("--out", type=Path, help="directory (default: results/ and the case's name)")
    add_processes(wear)
    wear.set_defaults(command=_wear, accuracy=WEAR_ACCURACY, effects=None)


def _wear(options: argparse.Namespace) -> int:
    from pyworm.batch.wear import WearInput, require_above_zero, require_worm, worn

    names = ("hours", "coefficient", "energy", "tolerance", "worm_ratio")
    require_above_zero({name.replace("_", "-"): getattr(options, name) for name in names}, "--")
    case = load(options.case)
    directory = options.out or Path("results") / case.name / "wear"
    check_writable(directory)
    require_worm(case, options.case)
    tasks = planned_tasks(case, options)

    from pyworm.batch.case_run import NothingSolvedError
    from pyworm.batch.wear_run import WearRun

    given = options.coefficient, options.energy, options.calibrate, options.worm_ratio
    plan, *words = WearInput(*given, prefix="--").plan(
        case, options.hours, options.tolerance * 1e-6
    )
    with batch_executor(options) as executor:
        try:
            run = WearRun(case, tasks, plan, directory, print_message, executor=executor)
            found = worn(run, *words)
        except NothingSolvedError as error:
            return end_with(f"{case.name}: {error}", FAILED)
        except ValueError as error:
            raise CaseError(f"{options.case}: {error}") from None
    if options.json:
        print_json(found.summary())
        return CONVERGED
    _show(found.steps)
    verdict = "within" if found.within_limit else f"WORN OUT before {plan.hours:g} h"
    print_result(
        f"Allowed: {found.limit * 1e6:.4g} µm: {verdict}; at the last rate as deep after "
        f"{found.hours_allowed:.4g} h. {found.assumed}."
    )
    _draw(case, found.run, found.limit)
    return CONVERGED


def _draw(case: Case, run: "WearRun", limit: float) -> None:
    """The worm's wear in words, and the picture."""
    from pyworm.batch.wear_run import STATE
    from pyworm.plots.layout import DOTS_PER_INCH
    from pyworm.plots.wear import draw_wear

    last = run.steps[-1]
    deep = last.worm_depth_max_m
    print_result(
        f"Worm: {deep * 1e6:.3g} µm at most, {last.worm_mass_kg * 1e3:.3g} g: {run.plan.worm_ratio:.2g} of "
        f"the wheel's volume, {deep / last.depth_max_m:.2g} of its depth."
    )
    picture = run.directory / "wear.png"
    with whole_file(picture) as partial:
        draw_wear(case.name, run, limit).savefig(partial, format="png", dpi=DOTS_PER_INCH)
    print_result(f"Maps: {run.directory / STATE}, picture: {picture}")


def _show(steps: "Sequence[WearFigures]") -> None:
    from pyworm.io.console import Console
    from pyworm.report.table import Table

    friction, film = QUANTITIES["friction_coefficient"], QUANTITIES["film_min"]
    rows = (
        (
            f"{step.hours:.4g}",
            f"{step.depth_max_m * 1e6:.3g}",
            f"{step.depth_mean_m * 1e6:.3g}",
            f"{step.mass_kg * 1e6:.3g}",
            f"{step.backlash_m * 1e6:.2f}",
            f"{step.pattern_m2 * 1e6:.1f}",
            f"{step.asperity_share * 100:.1f}",
            f"{step.friction:.4f}",
            f"{film.number(step.film_min_m):.3g}",
            f"{step.wheel_roughness_m * 1e6:.3g}",
        )
        for step in steps
    )
    carried = QUANTITIES["asperity_load_fraction"].column
    depths = "Max.\ndepth\nµm", "Mean\ndepth\nµm"
    worn = "Mass\nmg", "Backlash\nµm", "Pattern\nmm²"
    head = ("Time\nh", *depths, *worn, carried, friction.column, film.column, "Rq\nµm")
    Console().print(Table(head, tuple(rows), "Wear of the wheel", narrow=True))
