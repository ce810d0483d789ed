"""pyworm explore: write a result as one HTML page with a slider, read-outs and the drive in space."""

import argparse
from pathlib import Path

from pyworm.cli.shared import opened_result
from pyworm.io.input_error import CaseError
from pyworm.io.stage import stage
from pyworm.io.terminal import print_result


def add_explore(commands: argparse._SubParsersAction) -> None:
    """Add the command `explore`."""
    command = commands.add_parser(
        "explore", help="write a results file as one interactive HTML page"
    )
    command.add_argument("result", type=Path, metavar="RESULT")
    command.add_argument(
        "--out", type=Path, metavar="FILE.html", help="default: next to the results"
    )
    command.set_defaults(command=_explore)


def _explore(options: argparse.Namespace) -> int:
    from pyworm.io.atomic import check_writable, whole_file
    from pyworm.report.explore.page import explore
    from pyworm.result.result import readable

    path = options.out or options.result.with_name("explore.html")
    if path.is_dir():
        raise CaseError(f"--out {path}: is a directory, a file such as explore.html is needed")
    check_writable(path.parent)
    result = opened_result(options.result)
    with readable(options.result):
        with stage("making the page"):
            page = explore(result)
    path.parent.mkdir(parents=True, exist_ok=True)
    with whole_file(path) as partial:
        partial.write_text(page, encoding="utf-8")
    print_result(f"{path}")
    return 0
