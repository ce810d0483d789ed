"""Tables on the console: the rows of a sweep, in workshop units."""

from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

from pyworm.io.console import Console
from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import Quantity, listed
from pyworm.planning.target import FILMS
from pyworm.report.table import Table
from pyworm.result.sweep_result import SweepResult, distinguishing
from pyworm.scene.index import INDEX_NAMES
from pyworm.solver.ending import LESS_ACCURATE

MOST_ROWS = 60
"""Scenes beyond which the table is left to the file."""


def show(result: SweepResult, directory: Path) -> None:
    """Print the table of a sweep and the paths of its files."""
    console = Console()
    data = result.table
    if sentence := result.neglected_effects.sentence:
        console.print(f"{sentence}\n")
    if data.sizes["scene"] <= MOST_ROWS:
        console.print(rows_table(result))
    for sentence in unconverged(result):
        console.print(sentence)
    console.print(f"Results   {directory}/sweep.nc, sweep.csv", soft_wrap=True)


def unconverged(result: SweepResult) -> list[str]:
    """Numbers and reasons of the scenes that did not converge as asked for, a sentence for each reason."""
    scenes = result.table.sizes["scene"]
    reasons = Counter(result.table["stop_reason"].values[~result.converged].tolist())
    sentences = [
        f"{count} of {scenes} contacts did not converge: {reason}"
        for reason, count in reasons.most_common()
    ]
    wide = int((result.converged & ~result.accurate).sum())
    if wide:
        sentences.append(f"{wide} of {scenes} contacts are {LESS_ACCURATE}")
    return sentences


def rows(result: SweepResult) -> list[dict[str, Any]]:
    """The table as a list of objects, one for each scene."""
    named = {str(name): column.values.tolist() for name, column in result.table.items()}
    return [dict(zip(named, row, strict=True)) for row in zip(*named.values(), strict=True)]


def rows_table(result: SweepResult) -> Table:
    """The table with one row for each scene."""
    data = result.table
    varied = [name for axis in result.axes for name in distinguishing(result, axis)]
    varied += [name for name in INDEX_NAMES if name in data and len(np.unique(data[name])) > 1]
    shown = [quantity for quantity in listed("sweep") if quantity.key in data]
    neglected_effects = result.neglected_effects
    head = [_heading(key, data[key].attrs.get("units", "")) for key in varied]
    for quantity in shown:
        rubbing = quantity.name == "friction_coefficient" and neglected_effects.as_if_smooth
        head.append(f"{quantity.column}\nsmooth\nsurfaces" if rubbing else quantity.column)
        head += ["±\n%"] if quantity.name in FILMS else []
    perfect = bool((result.converged & result.accurate).all())
    status_head = () if perfect else ("Converged",)
    rows: list[tuple[str, ...]] = []
    for number in range(data.sizes["scene"]):
        row = data.isel(scene=number)
        values = [row[key].item() for key in varied]
        cells = [value if isinstance(value, str) else f"{value:.4g}" for value in values]
        for quantity in shown:
            cells += _figure(row, quantity)
        accurate = "yes" if row["accurate"] == 1 else "less accurate"
        status = [accurate if row["converged"] == 1 else "NO"] * len(status_head)
        rows.append((*cells, *status))
    return Table(
        head=(*head, *status_head),
        rows=tuple(rows),
        title=neglected_effects.titled(result.title),
        texts=(len(head),) if status_head else (),
        narrow=True,
    )


def _heading(key: str, unit: str) -> str:
    """Heading of a varied quantity."""
    return f"{key.rpartition('.')[2].replace('_', ' ')}\n{unit}".rstrip()


def _figure(row: "xr.Dataset", quantity: Quantity) -> list[str]:
    """A figure, a lower bound where its error has no bound, and the error bar of a film; or empty cells."""
    bars = 1 if quantity.name in FILMS else 0
    if row["converged"] != 1 or np.isnan(row[quantity.key]):
        return [""] * (1 + bars)
    text = quantity.digits(quantity.by_key(row[quantity.key].item()))
    unbounded = quantity.name == "pressure_max" and not np.isfinite(row[quantity.error_key])
    error = [f"{row[quantity.error_key].item() * 100:.2g}"] * bars
    return [f"≥ {text}" if unbounded else text, *error]
