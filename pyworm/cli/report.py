"""pyworm report: write a result as one HTML page."""

import argparse
from pathlib import Path

from pyworm.cli.arguments import add_compared_case
from pyworm.cli.shared import opened_result
from pyworm.io.input_error import CaseError
from pyworm.io.terminal import put
from pyworm.result.result_case import case_for


def add_report(commands: argparse._SubParsersAction) -> None:
    """Add the command `report`."""
    report = commands.add_parser("report", help="write a results file as one HTML page")
    report.add_argument("result", type=Path, metavar="RESULT")
    report.add_argument("--out", type=Path, metavar="FILE.html", help="default: beside the results")
    report.add_argument("--drawing", metavar="NUMBER", help="drawing number on the page to sign")
    report.add_argument("--customer", metavar="NAME", help="customer on the page to sign")
    add_compared_case(report)
    report.set_defaults(command=_report)


def _report(options: argparse.Namespace) -> int:
    from pyworm.io.atomic import check_writable, whole_file
    from pyworm.report.page.build import build_report
    from pyworm.report.page.html import render
    from pyworm.result.result import readable

    path = options.out or options.result.with_name("report.html")
    if path.is_dir():
        raise CaseError(f"--out {path}: is a directory, a file such as report.html is needed")
    check_writable(path.parent)
    result = opened_result(options.result)
    case, differ = None, None
    if options.case is not None:
        case, differ = case_for(options.case, result, options.anyway)
    with readable(options.result):
        page = render(build_report(result, case, differ, _identity(options)))
    path.parent.mkdir(parents=True, exist_ok=True)
    with whole_file(path) as partial:
        partial.write_text(page, encoding="utf-8")
    put(f"{path}")
    return 0


def _identity(options: argparse.Namespace) -> tuple[tuple[str, str], ...]:
    """What the page to sign names besides the case."""
    named = ("Drawing", options.drawing), ("Customer", options.customer)
    return tuple((name, value) for name, value in named if value)
