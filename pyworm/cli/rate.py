"""pyworm rate: rate a case by standards and closed forms, beside its simulated result."""

import argparse
from contextlib import nullcontext
from math import nan
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.cli.arguments import add_anyway, add_json
from pyworm.cli.shared import opened_result, option_value
from pyworm.io import units
from pyworm.io.atomic import atomic_directory, check_writable
from pyworm.io.given import kind_of
from pyworm.io.input_error import CaseError
from pyworm.io.json import print_json
from pyworm.io.terminal import print_message, print_result
from pyworm.result.result_case import case_for

if TYPE_CHECKING:
    from pyworm.drives.heat_network import TemperatureHistory
    from pyworm.io.console import Console
    from pyworm.ratings.operating_map import OperatingMap
    from pyworm.ratings.rate import CaseRatings
    from pyworm.ratings.rated_case import RatingRequest
    from pyworm.ratings.rating import Rating
    from pyworm.result.result import Result


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
    rate.add_argument(
        "--hours",
        type=_hours,
        nargs="+",
        metavar="H",
        help="temperatures over hours of running, of standing still, of running ..., with a picture",
    )
    for name, what in (
        ("speeds", "speeds of the first shaft"),
        ("torques", "torques of the second"),
    ):
        rate.add_argument(
            f"--{name}",
            nargs="+",
            metavar="VALUE",
            help=f"{what} of a map of films, asperities and temperatures, with a picture",
        )
    rate.add_argument(
        "--out", type=Path, default=Path(), metavar="DIR", help="of the picture (default: current)"
    )
    add_anyway(rate)
    add_json(rate)
    rate.set_defaults(command=_rate)


def _rate(options: argparse.Namespace) -> int:
    from pyworm.io.console import Console
    from pyworm.ratings.rate import rated
    from pyworm.ratings.rated_case import load_rating_request, rating_request
    from pyworm.ratings.temperatures import history_summary, rate_history
    from pyworm.result.result import readable

    axes = _map_axes(options)
    request, result, differ = load_rating_request(options.case), None, None
    if options.result is not None and request.drive is None:
        raise CaseError(f"{options.case}: has no [drive] that a result could be of")
    if options.result is not None:
        result = opened_result(options.result)
        case, differ = case_for(options.case, result, options.anyway)
        request = rating_request(case)
    with nullcontext() if result is None else readable(options.result):
        found = rated(request, result, options.case)
    for warning in (*([] if differ is None else [differ]), *request.warnings):
        print_message(f"warning: {warning}")
    history = None if options.hours is None else _history(found.request, options)
    chart = None if axes is None else _operating_map(found.request, axes, options)
    if options.json:
        more = {} if history is None else {"history": history_summary(history)}
        points = {} if chart is None else {"operating_points": chart.summary()}
        print_json(found.summary() | more | points)
        return 0
    _show(found, result)
    if chart is not None:
        from pyworm.report.operating_map import operating_map_table

        Console().print(operating_map_table(chart))
        print_result(f"Picture   {_named(options, 'operating_map')}")
    if history is not None:
        _print(Console(), rate_history(history))
        print_result(f"Picture   {_named(options, 'temperatures')}")
    return 0


def _map_axes(options: argparse.Namespace) -> list[list[float]] | None:
    """Speeds [rad/s] and torques [N m] of a map; None where none are given, CaseError for one of them."""
    if options.speeds is None and options.torques is None:
        return None
    axes = [
        [option_value(name, text, kind_of(kind)) for text in getattr(options, name) or ()]
        for name, kind in (("speeds", units.Speed), ("torques", units.Torque))
    ]
    if not all(axes):
        raise CaseError(f"{options.case}: a map needs --speeds and --torques")
    return axes


def _operating_map(
    request: "RatingRequest", axes: list[list[float]], options: argparse.Namespace
) -> "OperatingMap":
    """The map over speeds and torques, after its picture is drawn."""
    from pyworm.plots.layout import write
    from pyworm.plots.operating_map import draw_operating_map
    from pyworm.ratings.operating_map import operating_map

    if request.drive is None:
        raise CaseError(f"{options.case}: has no [drive] for a map over speeds and torques")
    try:
        found = operating_map(request.drive, request.places, *axes)
    except ValueError as error:
        raise CaseError(f"{options.case}: {error}") from error
    check_writable(options.out)
    with atomic_directory(options.out) as aside:
        picture = draw_operating_map(request.name, found)
        write(picture, aside / _named(options, "operating_map").name)
    return found


def _history(request: "RatingRequest", options: argparse.Namespace) -> "TemperatureHistory":
    """Temperatures over the hours, after their picture is drawn; CaseError of a case without a housing."""
    from pyworm.plots.layout import write
    from pyworm.plots.temperatures import draw_temperatures
    from pyworm.ratings.rated_case import thermal_unit

    try:
        unit = thermal_unit(request)
        history = unit.history(options.hours)
    except ValueError as error:
        raise CaseError(f"{options.case}: {error}") from error
    check_writable(options.out)
    with atomic_directory(options.out) as aside:
        picture = draw_temperatures(request.name, history, unit.steady)
        write(picture, aside / _named(options, "temperatures").name)
    return history


def _named(options: argparse.Namespace, what: str) -> Path:
    """File of a picture."""
    return Path(options.out) / f"{options.case.stem}_{what}.png"


def _hours(text: str) -> float:
    try:
        hours = float(text)
    except ValueError:
        hours = nan
    if not 0 < hours <= 1e5:
        raise argparse.ArgumentTypeError(f"{text}: must be a number of hours up to 1e5, above 0")
    return hours


def _show(found: "CaseRatings", result: "Result | None") -> None:
    """The ratings of a case as tables, with what is not rated and what was assumed."""
    from pyworm.io.console import Console
    from pyworm.result.headline import headline

    console, request = Console(), found.request
    console.print(f"{request.tables.title}\n{request.tables.source}\n")
    films = found.neglected_effects.sentence, headline(result.solutions if result else ())
    for line in (*request.beyond_limits, *filter(None, films)):
        console.print(f"{line}\n")
    for sentence in found.not_converged:
        console.print(sentence)
    for rating in found:
        _print(console, rating)
    if found.not_rated:
        console.print("Not rated:")
    for sentence in found.not_rated:
        console.print(f"- {sentence}")
    if found.assumptions:
        console.print("Assumed, since the source does not give it:")
    for what, why in found.assumptions.items():
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
