"""pyworm explore: write a result as one HTML page with a slider, read-outs and the drive in space."""

import argparse
from pathlib import Path

from pyworm.cli.shared import opened_result, page_file, write_page
from pyworm.io.stage import stage


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    command = commands.add_parser(
        "explore", help="write a results file as one interactive HTML page"
    )
    command.add_argument("result", type=Path, metavar="RESULT")
    command.add_argument(
        "--out", type=Path, metavar="FILE.html", help="default: next to the results"
    )
    command.set_defaults(command=_explore)


def _explore(options: argparse.Namespace) -> int:
    from pyworm.report.explore.page import explore
    from pyworm.result.result import readable

    path = page_file(options.out, options.result.with_name("explore.html"))
    result = opened_result(options.result)
    with readable(options.result):
        with stage("making the page"):
            page = explore(result)
    write_page(path, page)
    return 0
