"""pyworm plot: draw the pictures of a results file again."""

import argparse
from functools import partial
from pathlib import Path

from pyworm.cli.arguments import add_compared_case
from pyworm.cli.shared import CONVERGED, FAILED, PICTURES, SWEEP_PICTURE, drawn_pictures
from pyworm.io.atomic import check_writable
from pyworm.io.input_error import CaseError
from pyworm.io.terminal import put, say
from pyworm.result.result_case import case_for


def add_plot(commands: argparse._SubParsersAction) -> None:
    """Add the command `plot`."""
    plot = commands.add_parser("plot", help="draw the pictures of a results file again")
    plot.add_argument("result", type=Path, metavar="RESULT")
    plot.add_argument("--out", type=Path, help="directory (default: that of the results file)")
    add_compared_case(plot)
    plot.set_defaults(command=_plot)


def _plot(options: argparse.Namespace) -> int:
    from pyworm.plots.draw import draw
    from pyworm.plots.sweep import draw_sweep
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
            say(f"warning: {differ}")
    if sweep is not None:
        draw_all, old = (lambda aside: draw_sweep(sweep, aside / SWEEP_PICTURE)), ()
    else:
        draw_all, old = partial(draw, result), PICTURES
    pictures, complete = drawn_pictures(directory, draw_all, old)
    for name in pictures:
        put(f"{directory / name}")
    return CONVERGED if complete else FAILED
