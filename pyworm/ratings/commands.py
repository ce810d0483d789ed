"""What `pyworm rate` and `pyworm oil` show."""

import argparse
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.case_error import CaseError
from pyworm.json_output import print_json
from pyworm.result_case import add_anyway, case_for
from pyworm.terminal import put, say

if TYPE_CHECKING:
    from pyworm.named_oils import NamedOil
    from pyworm.ratings.rating import Rating
    from pyworm.result import Result

SHOWN_TEMPERATURES = (0, 20, 40, 60, 80, 100, 120)
"""Temperatures [degC] at which an oil is shown."""

CHARTED_GRADES = (100, 220, 460)
"""Grades of every base stock that are drawn if no oils are named."""


def add_rate(commands: argparse._SubParsersAction) -> None:
    """The command `rate`."""
    rate = commands.add_parser(
        "rate", help="ratings a case asks for, by standards and closed forms"
    )
    rate.add_argument("case", type=Path, metavar="CASE.toml")
    rate.add_argument(
        "--result", type=Path, metavar="RESULT", help="result of the same drive, shown beside"
    )
    add_anyway(rate)
    rate.add_argument("--json", action="store_true", help="one JSON object on standard output")
    rate.set_defaults(command=_rate)


def add_oil(commands: argparse._SubParsersAction) -> None:
    """The command `oil` and its own."""
    oil = commands.add_parser("oil", help="oils: choose one for a case, show, chart, list all")
    which = oil.add_subparsers(required=True, metavar="WHAT")

    choose = which.add_parser("choose", help="the oil for the drive of a case, step by step")
    choose.add_argument("case", type=Path, metavar="CASE.toml")
    choose.add_argument("--json", action="store_true", help="one JSON object on standard output")
    choose.set_defaults(command=_choose)

    show = which.add_parser("show", help="properties of oils over temperature")
    show.add_argument(
        "names", nargs="+", metavar="NAME", help='such as "PAG VG 460", or a TOML file'
    )
    show.add_argument("--json", action="store_true", help="one JSON object on standard output")
    show.set_defaults(command=_show)

    chart = which.add_parser("chart", help="draw viscosity and alpha of oils over temperature")
    chart.add_argument(
        "names", nargs="*", metavar="NAME", help="as of show; by default some of every base stock"
    )
    chart.add_argument("--out", type=Path, default=Path(), metavar="DIR", help="default: here")
    chart.set_defaults(command=_chart)

    every = which.add_parser("list", help="oils known by name")
    every.add_argument("--json", action="store_true", help="one JSON object on standard output")
    every.set_defaults(command=_list)


def _rate(options: argparse.Namespace) -> int:
    from pyworm.left_out import headline
    from pyworm.ratings.asked import (
        asked_of,
        left_out,
        load_asked,
        not_rated,
        ratings,
        unconverged,
    )
    from pyworm.result import readable
    from pyworm.schema.shown import assumptions

    asked, result, differ = load_asked(options.case), None, None
    if options.result is not None and asked.drive is None:
        raise CaseError(f"{options.case}: has no [drive] that a result could be of")
    if options.result is not None:
        result = _opened(options.result)
        case, differ = case_for(options.case, result, options.anyway)
        asked = asked_of(case)
    with nullcontext() if result is None else readable(options.result):
        made = ratings(asked, result)
        lacking = left_out(asked, result)
    if not made:
        raise CaseError(
            f"{options.case}: nothing is asked to be rated; give [worm_rating] or [bearings.NAME]"
        )
    for warning in (*([] if differ is None else [differ]), *asked.warnings):
        say(f"warning: {warning}")
    if options.json:
        print_json(
            {
                "case": asked.name,
                **lacking.summary(),
                "ratings": [rating.summary() for rating in made],
                "not_rated": not_rated(asked, made),
                "warnings": asked.warnings,
                "not_converged": unconverged(result),
                "assumed": asked.tables.assumed,
            }
        )
        return 0
    from pyworm.console import Console

    console = Console()
    console.print(f"{asked.tables.title}\n{asked.tables.source}\n")
    for line in filter(None, (lacking.sentence, headline(result.solutions if result else ()))):
        console.print(f"{line}\n")
    for sentence in unconverged(result):
        console.print(sentence)
    for rating in made:
        _print(console, rating)
    left = not_rated(asked, made)
    if left:
        console.print("Not rated:")
    for sentence in left:
        console.print(f"  {sentence}", soft_wrap=True)
    if asked.tables.assumed:
        console.print("Assumed, since the source does not give it:")
    for what, why in assumptions(asked.tables).items():
        console.print(f"  {what}: {why}", soft_wrap=True)
    return 0


def _opened(path: Path) -> "Result":
    """A result file."""
    from pyworm.result import open_result

    try:
        return open_result(path)
    except (FileNotFoundError, ValueError) as error:
        raise CaseError(str(error)) from error


def _print(console, rating: "Rating") -> None:
    from rich.table import Table

    table = Table("Figure", title=rating.titled, title_justify="left", caption=rating.source)
    table.caption_justify = "left"
    for heading in rating.headings:
        table.add_column(heading, justify="right")
    for figure in rating.figures:
        table.add_row(figure.label, *(figure.shown(n) for n in range(len(rating.columns))))
    console.print(table)
    for reason in rating.failed:
        console.print(f"FAILED: {reason}", style="bold")
    for words in rating.words:
        console.print(words)
    console.print()


def _choose(options: argparse.Namespace) -> int:
    from dataclasses import asdict

    from pyworm.oil_choice import page
    from pyworm.ratings.asked import load_asked
    from pyworm.ratings.oil_duty import oil_choice

    asked = load_asked(options.case)
    choice = oil_choice(asked)
    if options.json:
        print_json(
            {
                "case": asked.name,
                "oil": choice.oil,
                "grade": choice.grade,
                "reached": choice.reached,
                "viscosity_needed_40_m2_s": choice.viscosity_needed,
                "grades": [asdict(row) for row in choice.rows],
                "steps": [asdict(step) for step in choice.steps],
            }
        )
    else:
        put(page(choice).rstrip("\n"))
    return 0


def _show(options: argparse.Namespace) -> int:
    from pyworm.ratings.oils import oil_called

    oils = [oil_called(name, Path()) for name in options.names]
    if options.json:
        print_json({"oils": [_properties(oil) for oil in oils]})
        return 0
    from pyworm.console import Console

    console = Console()
    for oil in oils:
        _print_oil(console, oil)
    return 0


def _chart(options: argparse.Namespace) -> int:
    from pyworm.named_oils import BASES
    from pyworm.output import check_writable, whole
    from pyworm.plots.oil import draw_pressure_viscosity, draw_viscosity
    from pyworm.plots.style import write
    from pyworm.ratings.oils import oil_called

    names = options.names or [f"{base} VG {grade}" for base in BASES for grade in CHARTED_GRADES]
    oils = [oil_called(name, Path()) for name in names]
    directory = options.out
    check_writable(directory)
    charts = {
        "oil_viscosity.png": draw_viscosity,
        "oil_pressure_viscosity.png": draw_pressure_viscosity,
    }
    with whole(directory) as aside:
        for name, chart in charts.items():
            write(chart(oils), aside / name)
    for name in charts:
        put(f"{directory / name}")
    return 0


def _properties(oil: "NamedOil") -> dict:
    """An oil as one object, units in the keys."""
    kelvin = [celsius + 273.15 for celsius in SHOWN_TEMPERATURES]
    return {
        "name": oil.name,
        "base": oil.stock.name,
        "source": oil.source,
        "viscosity_index": oil.viscosity_index,
        "temperature_C": list(SHOWN_TEMPERATURES),
        "kinematic_viscosity_m2_s": [float(oil.kinematic_viscosity(at)) for at in kelvin],
        "viscosity_Pa_s": [float(oil.viscosity(at)) for at in kelvin],
        "density_kg_m3": [float(oil.density(at)) for at in kelvin],
        "pressure_viscosity_1_Pa": [_alpha(oil, at) for at in kelvin],
        "specific_heat_J_kgK": oil.stock.specific_heat,
        "sources": oil.stock.sources,
    }


def _alpha(oil: "NamedOil", temperature: float) -> float | None:
    """Pressure-viscosity coefficient [1/Pa]; None where the oil is too thick for its law."""
    try:
        return float(oil.alpha(temperature))
    except ValueError:
        return None


def _print_oil(console, oil: "NamedOil") -> None:
    from rich.table import Table

    known = _properties(oil)
    table = Table(title=f"{oil.name}, viscosity index {oil.viscosity_index:.0f}")
    table.title_justify = "left"
    for heading in ("°C", "mm²/s", "mPa s", "kg/m³", "alpha, 1/GPa"):
        table.add_column(heading, justify="right")
    for row in zip(
        known["temperature_C"],
        known["kinematic_viscosity_m2_s"],
        known["viscosity_Pa_s"],
        known["density_kg_m3"],
        known["pressure_viscosity_1_Pa"],
        strict=True,
    ):
        celsius, nu, eta, rho, alpha = row
        table.add_row(
            f"{celsius}",
            f"{nu * 1e6:.4g}",
            f"{eta * 1e3:.4g}",
            f"{rho:.0f}",
            "" if alpha is None else f"{alpha * 1e9:.1f}",
        )
    console.print(table)
    console.print(f"Viscosity: {oil.source}")
    for what, source in oil.stock.sources.items():
        if what != "grades":
            console.print(f"{what}: {source}")
    console.print()


def _list(options: argparse.Namespace) -> int:
    from pyworm.named_oils import named_oil, names

    oils = [named_oil(name) for name in names()]
    if options.json:
        print_json({"oils": [_properties(oil) for oil in oils]})
        return 0
    from rich.table import Table

    from pyworm.console import Console

    table = Table("Oil")
    for heading in ("40 °C\nmm²/s", "100 °C\nmm²/s", "index"):
        table.add_column(heading, justify="right")
    table.add_column("source")
    for oil in oils:
        nu_40, nu_100 = (oil.kinematic_viscosity(at) * 1e6 for at in (313.15, 373.15))
        table.add_row(
            oil.name, f"{nu_40:.0f}", f"{nu_100:.1f}", f"{oil.viscosity_index:.0f}", oil.source
        )
    Console().print(table)
    return 0
