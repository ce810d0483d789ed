"""pyworm design: the best design of a gear set."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.cli.arguments import add_json, add_processes
from pyworm.cli.shared import CONVERGED, NOT_CONVERGED, batch_executor, drawn_pictures, end_with
from pyworm.io.atomic import atomic_directory, check_writable
from pyworm.io.json import as_json, print_json
from pyworm.io.terminal import print_message, print_result

if TYPE_CHECKING:
    from pyworm.result.design import BestDesign

BEST, REPORT, PICTURE = "best.toml", "design.json", "front.png"
"""Names of the files: values of the best design, all numbers, picture of the front."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    design = commands.add_parser(
        "design", help="find the best design of a gear set between bounds, under constraints"
    )
    design.add_argument("design", type=Path, metavar="DESIGN.toml")
    design.add_argument(
        "--out", type=Path, help="directory (default: results/ and the name of the design file)"
    )
    add_json(design)
    add_processes(design)
    design.set_defaults(command=_design)


def _design(options: argparse.Namespace) -> int:
    from pyworm.case.design import load_design

    task = load_design(options.design)
    directory = options.out or Path("results") / options.design.stem
    check_writable(directory)

    from pyworm.batch.design import best_design
    from pyworm.batch.operating_points import NotSolvedError
    from pyworm.io.console import progress_bar

    with progress_bar() as progress, batch_executor(options) as executor:
        try:
            found = best_design(task, directory, executor, progress, print_message)
        except NotSolvedError as error:
            return end_with(f"{task.name}: {error}", NOT_CONVERGED)
    _write(found, directory, options.json)
    if found.feasible:
        return CONVERGED
    return end_with(f"{found.name}: {' '.join(found.violated)}", NOT_CONVERGED)


def _write(found: "BestDesign", directory: Path, as_object: bool) -> None:
    """Write and print the best design."""
    from pyworm.plots.layout import write
    from pyworm.report.console.design import show_design

    with atomic_directory(directory) as aside:
        found.save(aside / BEST)
        (aside / REPORT).write_text(as_json(found.summary()), encoding="utf-8")
    if not as_object:
        show_design(found)
    pictures: list[str] = []
    if found.front:
        from pyworm.plots.design import draw_front

        pictures, _ = drawn_pictures(
            directory, lambda aside: [write(draw_front(found), aside / PICTURE)]
        )
    files = {
        "best": str(directory / BEST),
        "report": str(directory / REPORT),
        "pictures": [str(directory / name) for name in pictures],
    }
    if as_object:
        print_json(found.summary() | files)
        return
    print_result(f'Best      {directory / BEST}: name it in a case, fitted = "{BEST}"')
    for name in pictures:
        print_result(f"Picture   {directory / name}")
