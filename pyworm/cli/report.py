"""pyworm report: write a result, or variants side by side, as one HTML page, and as PDF."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.cli.arguments import add_compared_case
from pyworm.cli.shared import opened_result, page_file, write_page
from pyworm.io.input_error import CaseError
from pyworm.io.stage import stage
from pyworm.io.terminal import print_result
from pyworm.result.result_case import case_for

if TYPE_CHECKING:
    from pyworm.report.page.content import Picture
    from pyworm.result.result import Result


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    report = commands.add_parser(
        "report", help="write one HTML page of a results file, or of several side by side"
    )
    report.add_argument("results", type=Path, nargs="+", metavar="RESULT")
    report.add_argument(
        "--out", type=Path, metavar="FILE.html", help="default: next to the first result"
    )
    report.add_argument("--pdf", action="store_true", help="also as PDF, printed by Chromium")
    report.add_argument("--drawing", metavar="NUMBER", help="drawing number on the page to sign")
    report.add_argument("--customer", metavar="NAME", help="customer on the page to sign")
    report.add_argument(
        "--wear", type=Path, metavar="DIR", help="add the wear results in this directory"
    )
    add_compared_case(report)
    report.set_defaults(command=_report)


def _report(options: argparse.Namespace) -> int:
    from pyworm.io.atomic import whole_file

    several = len(options.results) > 1
    name = "variants.html" if several else "report.html"
    path = page_file(options.out, options.results[0].with_name(name))
    if several:
        _refuse_of_one(options)
    with stage("making the page"):
        page = _variants(options.results) if several else _one(options)
    write_page(path, page)
    if options.pdf:
        from pyworm.report.pdf import print_pdf

        pdf = path.with_suffix(".pdf")
        with stage("printing the page"), whole_file(pdf) as partial:
            print_pdf(path, partial)
        print_result(f"{pdf}")
    return 0


def _refuse_of_one(options: argparse.Namespace) -> None:
    """Refuse options that mean one result."""
    for name in ("case", "drawing", "customer", "wear"):
        if getattr(options, name) is not None:
            raise CaseError(f"--{name}: is of one result, {len(options.results)} are given")


def _one(options: argparse.Namespace) -> str:
    """The page of one result."""
    from pyworm.report.page.build import build_report
    from pyworm.report.page.html import render
    from pyworm.result.result import readable

    (path,) = options.results
    result = opened_result(path)
    case, differ = None, None
    if options.case is not None:
        case, differ = case_for(options.case, result, options.anyway)
    with readable(path):
        return render(build_report(result, case, differ, _identity(options), _worn(options.wear)))


def _worn(directory: Path | None) -> "tuple[Picture, ...]":
    """The picture of a simulated wear; none without one."""
    from pyworm.report.page.content import Picture

    if directory is None:
        return ()
    file = directory / "wear.png"
    if not file.is_file():
        raise CaseError(f"--wear {directory}: has no wear.png, which pyworm wear writes at its end")
    return (Picture("Simulated wear of the wheel", file.read_bytes()),)


def _variants(paths: list[Path]) -> str:
    """The page of several results."""
    from contextlib import ExitStack

    from pyworm.report.page.html import render_variants
    from pyworm.report.page.variants import variants_page
    from pyworm.result.result import readable

    with ExitStack() as stack:
        for path in paths:
            stack.enter_context(readable(path))
        results = [opened_result(path) for path in paths]
        return render_variants(variants_page(results, _names(paths, results)))


def _names(paths: list[Path], results: "list[Result]") -> list[str]:
    """Names of variants: of their cases where each has its own, else of their folders, else their numbers."""
    for names in ([result.case_name for result in results], [path.parent.name for path in paths]):
        if len(set(names)) == len(names):
            return names
    return [f"{n}: {result.case_name}" for n, result in enumerate(results, 1)]


def _identity(options: argparse.Namespace) -> tuple[tuple[str, str], ...]:
    """What the page to sign names besides the case."""
    named = ("Drawing", options.drawing), ("Customer", options.customer)
    return tuple((name, value) for name, value in named if value)
