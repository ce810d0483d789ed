"""pyworm plot: draw the pictures of a results file again."""

import argparse
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.cli.arguments import add_compared_case
from pyworm.cli.shared import CONVERGED, FAILED, PICTURES, SWEEP_PICTURE, drawn_pictures
from pyworm.io.atomic import check_writable
from pyworm.io.input_error import CaseError
from pyworm.io.present import present
from pyworm.io.terminal import print_message, print_result
from pyworm.result.result_case import case_for

if TYPE_CHECKING:
    from pyworm.result.result import Result
    from pyworm.result.sweep_result import SweepResult


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    plot = commands.add_parser("plot", help="redraw the pictures of a results file")
    plot.add_argument("result", type=Path, metavar="RESULT")
    plot.add_argument("--out", type=Path, help="directory (default: that of the results file)")
    plot.add_argument(
        "--animate",
        nargs="?",
        const="gif",
        choices=("gif", "mp4"),
        help="an animation of film and pressure of a transient solution instead (default: gif)",
    )
    plot.add_argument(
        "--pictures",
        default="key",
        metavar="NAMES",
        help="key (default): as run draws them; all; or comma-separated names, such as pressure,mesh_cycle",
    )
    add_compared_case(plot)
    plot.set_defaults(command=_plot)


def _plot(options: argparse.Namespace) -> int:
    from pyworm.result.result import open_result
    from pyworm.result.sweep_result import open_sweep

    directory = options.out or options.result.parent
    check_writable(directory)
    try:
        sweep = open_sweep(options.result)
        result = None if sweep else open_result(options.result)
    except (FileNotFoundError, ValueError) as error:
        raise CaseError(str(error)) from error
    if options.case is not None:
        if result is None:
            raise CaseError(
                f"--case {options.case}: {options.result} is a sweep, which has a case for each"
            )
        _, differ = case_for(options.case, result, options.anyway)
        if differ is not None:
            print_message(f"warning: {differ}")
    if options.animate is not None:
        return _animate(options, result, directory)
    draw_all: Callable[[Path], list[Path]]
    old: Sequence[str] = ()
    if result is None:
        draw_all = partial(_draw_table, present(sweep, "a sweep"))
    else:
        draw_all, old = _chosen(options, result)
    pictures, complete = drawn_pictures(directory, draw_all, old)
    for name in pictures:
        print_result(f"{directory / name}")
    return CONVERGED if complete else FAILED


def _draw_table(sweep: "SweepResult", aside: Path) -> list[Path]:
    """Draw the picture of a sweep into a directory."""
    from pyworm.plots.sweep import write_sweep

    return write_sweep(sweep, aside / SWEEP_PICTURE)


def _chosen(
    options: argparse.Namespace, result: "Result"
) -> tuple[Callable[[Path], list[Path]], Sequence[str]]:
    """What draws the pictures asked for, and patterns of those of an earlier run that go."""
    from pyworm.plots.draw import draw, picture_names

    if options.pictures in ("key", "all"):
        return partial(draw, result, key_only=options.pictures == "key"), PICTURES
    names, known = options.pictures.split(","), picture_names(result)
    unknown = [name for name in names if name not in known]
    if unknown:
        raise CaseError(
            f"--pictures {options.pictures}: {options.result} has no picture {unknown[0]!r}, "
            f"it has key, all, {', '.join(known)}"
        )
    return partial(draw, result, names=names), ()


def _animate(options: argparse.Namespace, result: "Result | None", directory: Path) -> int:
    """Write an animation of each life of a result."""
    from pyworm.plots.life_animation import animate
    from pyworm.result.life import life_names

    named = {} if result is None else life_names(result)
    if not named:
        raise CaseError(
            f"--animate: {options.result} has no transient solution; "
            "run the case with --effects auto,squeeze"
        )
    kind = options.animate

    shown = present(result, "a result")

    def draw(aside: Path) -> list[Path]:
        return [animate(shown, life, aside / f"{name}.{kind}") for name, life in named.items()]

    try:
        films, complete = drawn_pictures(directory, draw)
    except ValueError as error:
        raise CaseError(f"--animate {kind}: {error}") from error
    for name in films:
        print_result(f"{directory / name}")
    return CONVERGED if complete else FAILED
