"""pyworm oil: list, show, chart and choose oils."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.cli.arguments import add_json
from pyworm.formulas.unit_factors import DEGREES_40, DEGREES_100, SQUARE_METRE, ZERO_CELSIUS
from pyworm.io.json import print_json
from pyworm.io.terminal import print_result

if TYPE_CHECKING:
    from pyworm.io.console import Console
    from pyworm.materials.library import NamedOil


SHOWN_TEMPERATURES = (0, 20, 40, 60, 80, 100, 120)
"""Temperatures [degC] at which an oil is shown."""

CHARTED_GRADES = (100, 220, 460)
"""Grades of every base stock that are drawn if no oils are named."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    oil = commands.add_parser(
        "oil", help="oils of the library: list, show, chart; choose one for a case"
    )
    which = oil.add_subparsers(required=True, metavar="WHAT")

    choose = which.add_parser(
        "choose", help="choose the oil grade for the gears of a case, step by step"
    )
    choose.add_argument("case", type=Path, metavar="CASE.toml")
    add_json(choose)
    choose.set_defaults(command=_choose)

    show = which.add_parser("show", help="show properties of oils over temperature")
    show.add_argument(
        "names", nargs="+", metavar="NAME", help='such as "PAG VG 460", or a TOML file'
    )
    add_json(show)
    show.set_defaults(command=_show)

    chart = which.add_parser("chart", help="draw viscosity and alpha of oils over temperature")
    chart.add_argument(
        "names",
        nargs="*",
        metavar="NAME",
        help="as for show; default: a selection from every base stock",
    )
    chart.add_argument(
        "--out", type=Path, default=Path(), metavar="DIR", help="directory (default: current)"
    )
    chart.set_defaults(command=_chart)

    every = which.add_parser("list", help="list oils of the library")
    add_json(every)
    every.set_defaults(command=_list)


def _choose(options: argparse.Namespace) -> int:
    from dataclasses import asdict

    from pyworm.ratings.oil_choice import page
    from pyworm.ratings.oil_duty import oil_choice
    from pyworm.ratings.rated_case import load_rating_request

    asked = load_rating_request(options.case)
    choice = oil_choice(asked)
    if options.json:
        print_json(
            {
                "case": asked.name,
                "lubricant": choice.lubricant,
                "oil": choice.oil,
                "grade": choice.grade,
                "reached": choice.reached,
                "viscosity_needed_40_m2_s": choice.viscosity_needed,
                "grades": [asdict(row) for row in choice.rows],
                "steps": [asdict(step) for step in choice.steps],
            }
        )
    else:
        print_result(page(choice).rstrip("\n"))
    return 0


def _show(options: argparse.Namespace) -> int:
    from pyworm.materials.oil_file import oil_called

    oils = [oil_called(name, Path()) for name in options.names]
    if options.json:
        print_json({"oils": [_properties(oil) for oil in oils]})
        return 0
    from pyworm.io.console import Console

    console = Console()
    for oil in oils:
        _print_oil(console, oil)
    return 0


def _chart(options: argparse.Namespace) -> int:
    from pyworm.io.atomic import atomic_directory, check_writable
    from pyworm.materials.base_stock import BASES
    from pyworm.materials.oil_file import oil_called
    from pyworm.plots.layout import write
    from pyworm.plots.oil import draw_pressure_viscosity, draw_viscosity

    names = options.names or [f"{base} VG {grade}" for base in BASES for grade in CHARTED_GRADES]
    oils = [oil_called(name, Path()) for name in names]
    directory = options.out
    check_writable(directory)
    charts = {
        "oil_viscosity.png": draw_viscosity,
        "oil_pressure_viscosity.png": draw_pressure_viscosity,
    }
    with atomic_directory(directory) as aside:
        for name, chart in charts.items():
            write(chart(oils), aside / name)
    for name in charts:
        print_result(f"{directory / name}")
    return 0


def _properties(oil: "NamedOil") -> dict:
    """An oil as one object, units in the keys."""
    kelvin = [celsius + ZERO_CELSIUS for celsius in SHOWN_TEMPERATURES]
    return {
        "name": oil.name,
        "base": oil.stock.name,
        "source": oil.source,
        "viscosity_index": oil.viscosity_index,
        "temperature_C": list(SHOWN_TEMPERATURES),
        "kinematic_viscosity_m2_s": [
            float(oil.kinematic_viscosity(temperature)) for temperature in kelvin
        ],
        "viscosity_Pa_s": [float(oil.viscosity(temperature)) for temperature in kelvin],
        "density_kg_m3": [float(oil.density(temperature)) for temperature in kelvin],
        "pressure_viscosity_1_Pa": [_alpha(oil, temperature) for temperature in kelvin],
        "specific_heat_J_kgK": oil.stock.specific_heat,
        "sources": oil.stock.sources,
    }


def _alpha(oil: "NamedOil", temperature: float) -> float | None:
    """Pressure-viscosity coefficient [1/Pa]; None where the oil is too thick for its law."""
    try:
        return float(oil.alpha(temperature))
    except ValueError:
        return None


def _print_oil(console: "Console", oil: "NamedOil") -> None:
    from pyworm.report.table import Table

    known, cells = _properties(oil), []
    for row in zip(
        known["temperature_C"],
        known["kinematic_viscosity_m2_s"],
        known["viscosity_Pa_s"],
        known["density_kg_m3"],
        known["pressure_viscosity_1_Pa"],
        strict=True,
    ):
        celsius, nu, eta, rho, alpha = row
        slope = "" if alpha is None else f"{alpha * 1e9:.1f}"
        cells.append((f"{celsius}", f"{nu * 1e6:.4g}", f"{eta * 1e3:.4g}", f"{rho:.0f}", slope))
    title = f"{oil.name}, viscosity index {oil.viscosity_index:.0f}"
    head = ("°C", "mm²/s", "mPa s", "kg/m³", "alpha, 1/GPa")
    console.print(Table(head, tuple(cells), title))
    console.print(f"Viscosity: {oil.source}")
    for what, source in oil.stock.sources.items():
        if what != "grades":
            console.print(f"{what}: {source}")
    console.print()


def _list(options: argparse.Namespace) -> int:
    from pyworm.materials.library import named_oil, names

    oils = [named_oil(name) for name in names()]
    if options.json:
        print_json({"oils": [_properties(oil) for oil in oils]})
        return 0
    from pyworm.io.console import Console
    from pyworm.report.table import Table

    rows = []
    for oil in oils:
        nu_40, nu_100 = (
            oil.kinematic_viscosity(temperature) * SQUARE_METRE
            for temperature in (DEGREES_40, DEGREES_100)
        )
        index = f"{oil.viscosity_index:.0f}"
        rows.append((oil.name, f"{nu_40:.0f}", f"{nu_100:.1f}", index, oil.source))
    head = ("Oil", "40 °C\nmm²/s", "100 °C\nmm²/s", "index", "source")
    Console().print(Table(head, tuple(rows), texts=(4,)))
    return 0
