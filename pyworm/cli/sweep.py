"""pyworm sweep: solve a case over ranges of its values."""

import argparse
from pathlib import Path

from pyworm.cli.arguments import add_json, add_processes
from pyworm.cli.shared import (
    CONVERGED,
    NOT_CONVERGED,
    SWEEP_NAME,
    SWEEP_PICTURE,
    TABLE_NAME,
    batch_executor,
    drawn_pictures,
    end_with,
)
from pyworm.io.atomic import atomic_directory, check_writable
from pyworm.io.json import print_json
from pyworm.io.terminal import print_message, print_result


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    sweep = commands.add_parser(
        "sweep", help="solve a case over ranges of its values: table, results file, picture"
    )
    sweep.add_argument("sweep", type=Path, metavar="SWEEP.toml")
    sweep.add_argument(
        "--out", type=Path, help="directory (default: results/ and the name of the sweep)"
    )
    sweep.add_argument("--fields", action="store_true", help="store the fields of every contact")
    sweep.add_argument(
        "--share",
        type=_sweep_part,
        metavar="I/N",
        help="solve only the I-th of N shares; writes no table",
    )
    add_json(sweep)
    add_processes(sweep)
    sweep.set_defaults(command=_sweep)


def _sweep_part(text: str) -> tuple[int, int]:
    first, _, count = text.partition("/")
    if not (first.isdecimal() and count.isdecimal() and 1 <= int(first) <= int(count)):
        raise argparse.ArgumentTypeError(f"{text}: must be a share such as 1/40, 2/40 to 40/40")
    return int(first), int(count)


def _sweep(options: argparse.Namespace) -> int:
    from pyworm.batch.case_run import SCENES
    from pyworm.batch.solved_scenes import Store
    from pyworm.batch.sweep import load_sweep
    from pyworm.io.console import progress_bar
    from pyworm.io.progress import log_lines

    directory = options.out or Path("results") / options.sweep.stem
    check_writable(directory)
    with progress_bar() as progress, batch_executor(options) as executor:
        share = options.share or (1, 1)
        if options.share is not None and progress is None:
            progress = log_lines(print_message, f"share {share[0]}/{share[1]}")
        store = Store(directory.absolute() / SCENES, options.fields)
        sweep = load_sweep(options.sweep, share, executor, progress, store)

        from pyworm.batch.sweep_run import run_sweep, solve_share

        how = (directory, options.fields, executor, progress, print_message)
        if options.share is not None:
            reasons, _ = solve_share(sweep.tasks, *how)
            for reason in reasons.values():
                print_message(f"a scene could not be solved: {reason}")
            solved = len(sweep.tasks) - len(reasons)
            print_message(
                f"share {share[0]}/{share[1]}: ended, {solved} of {len(sweep.tasks)} contacts solved"
            )
            return NOT_CONVERGED if reasons else CONVERGED
        result = run_sweep(sweep, *how)

    from pyworm.plots.sweep import write_sweep
    from pyworm.report.console.sweep import rows, show, unconverged

    with atomic_directory(directory) as aside:
        result.save(aside / SWEEP_NAME)
        result.save_csv(aside / TABLE_NAME)
    if not options.json:
        show(result, directory)
    pictures, _ = drawn_pictures(
        directory, lambda aside: write_sweep(result, aside / SWEEP_PICTURE)
    )
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
            print_result(f"Picture   {directory / name}")
    if result.accurate.all():
        return CONVERGED
    return end_with(f"{result.name}: {'; '.join(unconverged(result))}", NOT_CONVERGED)
