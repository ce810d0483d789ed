"""The table of results on the page of symbols, written from the table of quantities.

python tools/symbols_table.py     rewrites the table in docs/reference/symbols.md
"""

import re
from pathlib import Path

from pyworm.io.quantities import QUANTITIES, Quantity

PAGE = Path(__file__).parents[1] / "docs/reference/symbols.md"
TABLE = re.compile(r"(?<=<!-- results -->\n)[\s\S]*?(?=<!-- end -->)")
"""What stands between the marks of the page."""

GREEK = {"eta": r"\eta", "lambda": r"\lambda", "tau": r"\tau", "µ": r"\mu"}


def typeset(symbol: str) -> str:
    """A symbol of the quantities as an equation: a long index is upright."""
    name, _, index = symbol.partition("_")
    index = index if len(index) < 2 else rf"\mathrm{{{index}}}"
    return f"${GREEK.get(name, name)}{f'_{{{index}}}' if index else ''}$"


def table() -> str:
    """Every quantity with a symbol: symbol, words, SI unit, name in Python, key in JSON."""
    lines = ["| symbol | quantity | unit | Python, NetCDF | JSON |", "|---|---|---|---|---|"]
    for quantity in QUANTITIES.values():
        if quantity.symbol:
            lines.append(_row(quantity))
    return "\n".join(lines) + "\n"


def _row(quantity: Quantity) -> str:
    unit = "-" if quantity.unit == "1" else quantity.unit
    cells = (typeset(quantity.symbol), quantity.words(), unit, quantity.name, quantity.key)
    symbol, words, unit, name, key = cells
    return f"| {symbol} | {words} | {unit} | `{name}` | `{key}` |"


if __name__ == "__main__":
    PAGE.write_text(TABLE.sub(lambda _: table(), PAGE.read_text()))
