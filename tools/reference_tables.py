"""Tables of reference pages that are written from the program: symbols of results, base stocks of oils.

python tools/reference_tables.py     rewrites what stands between the marks of each page
"""

import re
from collections.abc import Callable
from pathlib import Path

from pyworm.formulas.unit_factors import DEGREES_40, DEGREES_100, ZERO_CELSIUS
from pyworm.io.quantities import QUANTITIES
from pyworm.materials.base_stock import BASES, BaseStock, base_stock
from pyworm.materials.library import named_oil, names

REFERENCE = Path(__file__).parents[1] / "docs/reference"
GREEK = {"eta": r"\eta", "lambda": r"\lambda", "tau": r"\tau", "sigma": r"\sigma", "µ": r"\mu"}
ALIASES = {"radii", "radius", "solve_time"}
"""Quantities without a row: names of a radius in tables of contacts, and the elapsed time."""

GRADE = 220
"""ISO viscosity grade of the oils in the table of base stocks."""


def row(*cells: object) -> str:
    """A row of a table in Markdown."""
    return f"|{' |'.join(map(str, cells))} |\n"


def head(*cells: str) -> str:
    """Head of a table in Markdown."""
    return row(*cells) + "|---" * len(cells) + "|\n"


def typeset(symbol: str) -> str:
    """A symbol of the quantities as an equation; a long index is upright."""
    name, _, index = symbol.partition("_")
    index = index if len(index) < 2 else rf"\mathrm{{{index}}}"
    return f"${GREEK.get(name, name)}{f'_{{{index}}}' if index else ''}$"


def results() -> str:
    """Every quantity with a symbol: symbol, words, SI unit, name in Python, key in JSON."""
    return head("symbol", "quantity", "unit", "Python, NetCDF", "JSON") + "".join(
        row(
            typeset(quantity.symbol),
            quantity.words(),
            "-" if quantity.unit == "1" else quantity.unit,
            f"`{quantity.name}`",
            f"`{quantity.key}`",
        )
        for quantity in QUANTITIES.values()
        if quantity.symbol and quantity.name not in ALIASES
    )


def base_stocks() -> str:
    """Properties of the base stocks, and of the grade of each that the table names."""
    stocks = [base_stock(name) for name in BASES]
    return head("property", "unit", *BASES) + "".join(
        row(words, unit, *map(value, stocks)) for words, unit, value in BASE_ROWS
    )


def _index(stock: BaseStock) -> str:
    oils = [named_oil(name) for name in names() if name.startswith(f"{stock.name} ")]
    indices = [oil.viscosity_index for oil in oils]
    low, high = min(indices), max(indices)
    return f"{low:.0f}" if high - low < 1 else f"{low:.0f} to {high:.0f}"


def _alpha(celsius: float) -> Callable[[BaseStock], str]:
    return lambda stock: (
        f"{named_oil(f'{stock.name} VG {GRADE}').alpha(ZERO_CELSIUS + celsius) * 1e9:.1f}"
    )


def _stresses(stock: BaseStock) -> str:
    if stock.limiting_coefficient is not None:
        return f"coefficient {stock.limiting_coefficient:g}"
    return f"{stock.eyring_stress / 1e6:g} and {stock.limiting_stress / 1e6:g} MPa"


def _viscosities(stock: BaseStock) -> str:
    oil = named_oil(f"{stock.name} VG {GRADE}")
    return " / ".join(f"{oil.kinematic_viscosity(t) * 1e6:.1f}" for t in (DEGREES_40, DEGREES_100))


BASE_ROWS: tuple[tuple[str, str, Callable[[BaseStock], str]], ...] = (
    (f"VG {GRADE} at 40 / 100 °C", "mm²/s", _viscosities),
    ("viscosity index of the grades", "-", _index),
    ("density at 15 °C", "kg/m³", lambda stock: f"{stock.density_15:g}"),
    ("fall of density", "1/K", lambda stock: f"{stock.density_coefficient:g}"),
    ("specific heat", "J/(kg K)", lambda stock: f"{stock.specific_heat:g}"),
    (rf"$\alpha$, VG {GRADE} at 40 °C", "1/GPa", _alpha(40)),
    (rf"$\alpha$, VG {GRADE} at 80 °C", "1/GPa", _alpha(80)),
    (r"uncertainty of $\alpha$, `alpha_spread`", "-", lambda stock: f"{stock.alpha_spread:g}"),
    ("limiting stress: coefficient, or Eyring and limiting stress", "-", _stresses),
    ("boundary friction", "-", lambda stock: f"{stock.boundary_friction:g}"),
)

TABLES: dict[str, tuple[str, Callable[[], str]]] = {
    "symbols.md": ("results", results),
    "oils.md": ("base stocks", base_stocks),
}
"""Page -> mark of its table, and what writes that."""


def marked(mark: str) -> re.Pattern[str]:
    """What stands between a mark and the end of its table."""
    return re.compile(rf"(?<=<!-- {mark} -->\n)[\s\S]*?(?=<!-- end -->)")


if __name__ == "__main__":
    for page, (mark, table) in TABLES.items():
        path, text = REFERENCE / page, table()
        path.write_text(marked(mark).sub(lambda _, text=text: text, path.read_text()))
