"""pyworm sweep: solve a case over ranges of its values."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.io.atomic import check_writable, whole
from pyworm.io.json import print_json
from pyworm.io.terminal import put, say

if TYPE_CHECKING:
    pass
from pyworm.cli.shared import (
    CONVERGED,
    NOT_CONVERGED,
    SWEEP_NAME,
    SWEEP_PICTURE,
    TABLE_NAME,
    batch_executor,
    drawn_pictures,
)


def sweep_case(options: argparse.Namespace) -> int:
    """Solve a case over ranges of its values; returns the exit code."""
    from pyworm.batch.sweep import load_sweep
    from pyworm.io.console import progress_bar

    directory = options.out or Path("results") / options.sweep.stem
    check_writable(directory)
    with progress_bar() as progress, batch_executor(options) as executor:
        share = options.share or (1, 1)
        sweep = load_sweep(options.sweep, share, executor, progress)

        from pyworm.batch.sweep_run import run_sweep, solve_share

        how = (directory, options.fields, executor, progress, say)
        if options.share is not None:
            reasons, _ = solve_share(sweep.tasks, *how)
            for reason in reasons.values():
                say(f"a scene could not be solved: {reason}")
            return NOT_CONVERGED if reasons else CONVERGED
        result = run_sweep(sweep, *how)

    from pyworm.plots.sweep import draw_sweep
    from pyworm.report.console.sweep import rows, show

    with whole(directory) as aside:
        result.save(aside / SWEEP_NAME)
        result.save_csv(aside / TABLE_NAME)
    if not options.json:
        show(result, directory)
    pictures, _ = drawn_pictures(directory, lambda aside: draw_sweep(result, aside / SWEEP_PICTURE))
    if options.json:
        print_json(
            {
                "sweep": result.name,
                "scenes": rows(result),
                "results": str(directory / SWEEP_NAME),
                "table": str(directory / TABLE_NAME),
                "pictures": [str(directory / name) for name in pictures],
            }
        )
    else:
        for name in pictures:
            put(f"Picture   {directory / name}")
    return CONVERGED if result.converged.all() else NOT_CONVERGED
