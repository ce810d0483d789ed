"""Tables of sensitivities: what a usual change of each number of a case does to its results."""

from collections.abc import Iterator

from pyworm.io.quantities import quantity_of
from pyworm.report.table import Table
from pyworm.result.key_sensitivities import KeySensitivities, KeySensitivity

COLUMNS = (
    ("film_min", "pressure_max", "power_loss"),
    ("S_H", "S_W", "S_F", "S_B"),
)
"""Results with a column, by table, those that there are: as many as fit into 80 letters. A file has all."""

MOST_COLUMNS = 3
"""Maximum number of columns of results."""

LEAST_CHANGE = 5e-5
"""Relative change below which a number has no row."""


def sensitivities_tables(found: KeySensitivities) -> Iterator[Table]:
    """Relative changes of the main results of contacts, and of safeties, with each number that matters."""
    for columns in COLUMNS:
        names = [name for name in columns if found.results.get(name)][:MOST_COLUMNS]
        if names:
            yield _table(found, names)


def _table(found: KeySensitivities, names: list[str]) -> Table:
    rows = [each for each in found.keys if _matters(found, each, names)]
    return Table(
        head=("Number of the case", "Value", "Change", *map(_heading, names)),
        rows=tuple(_row(found, each, names) for each in rows),
        title=f"Sensitivities of {found.case_name}: relative changes, to first order",
        note=f"{found.method} Numbers without a row change these results by less than 0.005 %.",
        narrow=True,
    )


def _heading(name: str) -> str:
    try:
        symbol = quantity_of(name).symbol
    except KeyError:  # of a safety, which is its symbol
        symbol = name
    return f"{symbol}\n%"


def _matters(found: KeySensitivities, each: KeySensitivity, names: list[str]) -> bool:
    return any(abs(found.relative_change(each.key, name)) >= LEAST_CHANGE for name in names)


def _row(found: KeySensitivities, each: KeySensitivity, names: list[str]) -> tuple[str, ...]:
    return (
        each.key,
        f"{each.value:.5g} {each.unit}".rstrip(),
        each.change_words,
        *(f"{100 * found.relative_change(each.key, name):+.2f}" for name in names),
    )
