"""Tables of a calibration: fitted values, correlations, residuals."""

from collections.abc import Sequence
from math import isfinite
from typing import Any

from pyworm.io.console import Console
from pyworm.io.number_with_unit import number_and_unit
from pyworm.io.quantities import quantity_of
from pyworm.report.table import Table
from pyworm.result.calibration import Calibration, FittedRow, FittedValue

MAX_ROWS = 40
"""Measurements beyond which the table is left to the file."""


def show_calibration(found: Calibration) -> None:
    """Print a calibration."""
    console = Console()
    console.print(values_table(found))
    if len(found.values) > 1:
        console.print(correlation_table(found))
    if len(found.rows) <= MAX_ROWS:
        console.print(rows_table(found))
    for sentence in found.statements:
        console.print(sentence)
    for name, error in found.leave_one_out_error.items():
        quantity = quantity_of(name)
        text = quantity.with_unit(f"{error * quantity.scale:.2g}").replace("°C", "K")
        console.print(f"Prediction error of {quantity.words()}, leave-one-out: {text}.")


def values_table(found: Calibration) -> Table:
    """The fitted values with their intervals."""
    return Table(
        head=("Value", "Case", "Fitted", "Standard\nuncertainty", "95 % interval"),
        rows=tuple(_value(value) for value in found.values),
        title=f"{found.case_name} fitted to {found.data_name}: chi squared {found.chi_squared:.3g} with "
        f"{found.degrees} degrees of freedom",
        narrow=True,
    )


def _value(value: FittedValue) -> tuple[str, ...]:
    def text(number: float) -> str:
        return f"{number:.4g} {value.unit}".rstrip()

    if value.at_bound:
        return value.name, text(value.start), text(value.value), "at its bound", ""
    if not isfinite(value.standard):
        return value.name, text(value.start), text(value.value), "not determined", ""
    low, high = value.interval
    return (
        value.name,
        text(value.start),
        text(value.value),
        f"{value.standard:.2g} {value.unit}".rstrip(),
        f"{low:.4g} to {text(high)}",
    )


def correlation_table(found: Calibration) -> Table:
    """Correlations of the fitted values."""
    names = [value.name for value in found.values]
    return Table(
        head=("Correlation", *names),
        rows=tuple(
            (name, *(f"{entry:.2f}" for entry in row))
            for name, row in zip(names, found.correlation, strict=True)
        ),
        narrow=True,
    )


def rows_table(found: Calibration) -> Table:
    """Measured and computed values of each row, its residual and its leave-one-out error."""
    varied = [
        key
        for key in found.rows[0].conditions
        if len({str(row.conditions[key]) for row in found.rows}) > 1
    ]
    names = {row.quantity for row in found.rows}
    several = len(names) > 1
    unit = "" if several else f"\n{quantity_of(found.rows[0].quantity).shown}"
    return Table(
        head=(
            *(_heading(key, found.rows[0].conditions[key]) for key in varied),
            *(["Quantity"] if several else []),
            *(f"{name}{unit}".rstrip() for name in ("Measured", "Case", "Fitted")),
            *("Residual\n/ u", "Leave-\none-out\n/ u"),
        ),
        rows=tuple(_row(row, varied, several) for row in found.rows),
        title="" if several else quantity_of(names.pop()).title(),
        note="Residual: measured less fitted value; leave-one-out: less the prediction by a fit to the "
        "others; both over the standard uncertainty u.",
        narrow=True,
    )


def _heading(key: str, value: Any) -> str:
    """Heading of a condition: the last part of its key, and its unit."""
    words = key.rpartition(".")[2].replace("_", "\n")
    return f"{words}\n{_parts(value)[1]}".rstrip()


def _parts(value: Any) -> tuple[str, str]:
    """Number and unit of a condition."""
    parts = number_and_unit(value) if isinstance(value, str) else None
    return parts or (str(value), "")


def _row(row: FittedRow, varied: Sequence[str], several: bool) -> tuple[str, ...]:
    quantity = quantity_of(row.quantity)
    measured = quantity.digits(quantity.number(row.measured))
    return (
        *(_parts(row.conditions[key])[0] for key in varied),
        *([quantity.words()] if several else []),
        f"{measured} ± {row.standard * quantity.scale:.2g}",
        quantity.digits(quantity.number(row.before)),
        quantity.digits(quantity.number(row.fitted)),
        f"{row.residual:.2f}",
        f"{row.leave_one_out / row.standard:.2f}",
    )
