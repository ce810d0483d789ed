"""pyworm calibrate: fit values of a case to measurements."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.case.case import load
from pyworm.cli.arguments import add_accuracy_and_effects, add_json, add_processes
from pyworm.cli.shared import (
    CONVERGED,
    NOT_CONVERGED,
    batch_executor,
    drawn_pictures,
    end_with,
    option_value,
    warn_of_unusual,
)
from pyworm.io.atomic import atomic_directory, check_writable
from pyworm.io.json import as_json, print_json
from pyworm.io.quantity import SHARE_KIND
from pyworm.io.terminal import print_message, print_result

if TYPE_CHECKING:
    from pyworm.result.calibration import Calibration

FITTED, REPORT, PICTURE = "fitted.toml", "calibration.json", "calibration.png"
"""Names of the files: fitted values, all numbers, picture."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    calibrate = commands.add_parser("calibrate", help="fit values of a case to measurements")
    calibrate.add_argument("case", type=Path, metavar="CASE.toml")
    calibrate.add_argument(
        "--measured",
        type=Path,
        required=True,
        metavar="DATA.csv",
        help="conditions by keys of the case, measured quantities and their u(NAME); units in brackets",
    )
    calibrate.add_argument(
        "--fit",
        nargs="+",
        required=True,
        metavar="NAME",
        help="boundary_friction, limiting_stress, eyring_stress, alpha, z, roughness_slope, conductance, or "
        'keys of the case; with bounds "alpha = 8 1/GPa to 25 1/GPa"',
    )
    add_accuracy_and_effects(calibrate)
    calibrate.add_argument(
        "--out", type=Path, help="directory (default: results/ and the case's name)"
    )
    add_json(calibrate)
    add_processes(calibrate)
    calibrate.set_defaults(command=_calibrate)


def _calibrate(options: argparse.Namespace) -> int:
    case = load(options.case)
    directory = options.out or Path("results") / case.name / "calibration"
    check_writable(directory)
    warn_of_unusual(case)

    from pyworm.batch.calibrate import bench_of, calibration
    from pyworm.batch.operating_points import NotSolvedError, Solving
    from pyworm.io.console import progress_bar
    from pyworm.io.quantity_text import duration
    from pyworm.planning.effects.selection import effect_names

    accuracy = case.accuracy
    if options.accuracy is not None:
        accuracy = option_value("accuracy", options.accuracy, SHARE_KIND)
    effects = case.effects if options.effects is None else effect_names(options.effects)
    with progress_bar() as progress, batch_executor(options) as executor:
        solving = Solving(directory, accuracy, effects, executor, progress)
        bench = bench_of(case, options.measured, options.fit, solving)
        print_message(
            f"{case.name}: some {bench.solves} operating points, expected CPU time "
            f"{duration(bench.expected_seconds)}; solved contacts are reused"
        )
        try:
            found = calibration(bench, options.measured.name)
        except NotSolvedError as error:
            return end_with(f"{case.name}: {error}", NOT_CONVERGED)
    _write(found, directory, options.json)
    return CONVERGED


def _write(found: "Calibration", directory: Path, as_object: bool) -> None:
    """Write and print a calibration."""
    from pyworm.plots.calibration import draw_calibration
    from pyworm.plots.layout import write
    from pyworm.report.console.calibration import show_calibration

    with atomic_directory(directory) as aside:
        found.save(aside / FITTED)
        (aside / REPORT).write_text(as_json(found.summary()), encoding="utf-8")
    if not as_object:
        show_calibration(found)
    pictures, _ = drawn_pictures(
        directory, lambda aside: [write(draw_calibration(found), aside / PICTURE)]
    )
    files = {
        "fitted": str(directory / FITTED),
        "report": str(directory / REPORT),
        "pictures": [str(directory / name) for name in pictures],
    }
    if as_object:
        print_json(found.summary() | files)
        return
    print_result(f'Fitted    {directory / FITTED}: name it in a case, fitted = "{FITTED}"')
    for name in pictures:
        print_result(f"Picture   {directory / name}")
