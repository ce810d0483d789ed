"""pyworm rate: rate a case by standards and closed forms, beside its simulated result."""

import argparse
from collections.abc import Sequence
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.cli.arguments import add_anyway, add_json
from pyworm.cli.shared import opened_result
from pyworm.io.input_error import CaseError
from pyworm.io.json import print_json
from pyworm.io.stage import stage
from pyworm.io.terminal import print_message
from pyworm.result.result_case import case_for

if TYPE_CHECKING:
    from pyworm.io.console import Console
    from pyworm.ratings.rated_case import RatingRequest
    from pyworm.ratings.rating import Rating
    from pyworm.result.result import Result
    from pyworm.solver.neglected_effects import NeglectedEffects


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    rate = commands.add_parser("rate", help="ratings by standards and closed forms")
    rate.add_argument("case", type=Path, metavar="CASE.toml")
    rate.add_argument(
        "--result",
        type=Path,
        metavar="RESULT",
        help="simulated result of the same gears, for comparison",
    )
    add_anyway(rate)
    add_json(rate)
    rate.set_defaults(command=_rate)


def _rate(options: argparse.Namespace) -> int:
    from pyworm.ratings.rated_case import (
        load_rating_request,
        neglected_effects,
        not_rated,
        rating_request,
        ratings,
        unconverged,
    )
    from pyworm.result.result import readable

    request, result, differ = load_rating_request(options.case), None, None
    if options.result is not None and request.drive is None:
        raise CaseError(f"{options.case}: has no [drive] that a result could be of")
    if options.result is not None:
        result = opened_result(options.result)
        case, differ = case_for(options.case, result, options.anyway)
        request = rating_request(case)
    with nullcontext() if result is None else readable(options.result):
        with stage(f"rating {request.name}"):
            rated = ratings(request, result)
            lacking = neglected_effects(request, result)
    if not rated:
        why = next(iter(not_rated(request, tuple(rated)) if request.rating_is_asked else ()), None)
        raise CaseError(
            f"{options.case}: {why}"
            if why
            else f"{options.case}: no rating is requested; give [worm_rating] or [bearings.NAME]"
        )
    for warning in (*([] if differ is None else [differ]), *request.warnings):
        print_message(f"warning: {warning}")
    if options.json:
        print_json(
            {
                "case": request.name,
                **lacking.summary(),
                "ratings": [rating.summary() for rating in rated],
                "not_rated": not_rated(request, tuple(rated)),
                "warnings": request.warnings,
                "beyond_limits": request.beyond_limits,
                "not_converged": unconverged(result),
                "assumed": request.tables.assumed,
            }
        )
    else:
        _show(request, result, rated, lacking)
    return 0


def _show(
    request: "RatingRequest",
    result: "Result | None",
    rated: Sequence["Rating"],
    lacking: "NeglectedEffects",
) -> None:
    """The ratings of a case as tables, with what is not rated and what was assumed."""
    from pyworm.case.workshop_units import assumptions
    from pyworm.io.console import Console
    from pyworm.ratings.rated_case import not_rated, unconverged
    from pyworm.result.headline import headline

    console = Console()
    console.print(f"{request.tables.title}\n{request.tables.source}\n")
    films = lacking.sentence, headline(result.solutions if result else ())
    for line in (*request.beyond_limits, *filter(None, films)):
        console.print(f"{line}\n")
    for sentence in unconverged(result):
        console.print(sentence)
    for rating in rated:
        _print(console, rating)
    left = not_rated(request, tuple(rated))
    if left:
        console.print("Not rated:")
    for sentence in left:
        console.print(f"- {sentence}")
    if request.tables.assumed:
        console.print("Assumed, since the source does not give it:")
    for what, why in assumptions(request.tables).items():
        console.print(f"- {what}: {why}")


def _print(console: "Console", rating: "Rating") -> None:
    from pyworm.report.ratings import rating_table, safeties_table

    if rating.safeties:
        console.print(safeties_table(rating, inputs=False))
    console.print(rating_table(rating))
    for sentence in rating.basis:
        console.print(sentence)
    if rating.safeties:
        for safety in rating.safeties:
            by = f"{safety.symbol} ({safety.clause})" if safety.clause else safety.symbol
            console.print(f"{by}: {safety.inputs_as_text}")
    for reason in rating.failed:
        console.print(f"FAILED: {reason}", style="bold")
    for words in rating.words:
        console.print(words)
    console.print()
