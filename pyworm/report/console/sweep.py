"""Tables on the console: the rows of a sweep, in workshop units."""

from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
from rich.box import SIMPLE_HEAD
from rich.table import Table

from pyworm.io.console import Console
from pyworm.io.on_demand import xarray as xr
from pyworm.result.sweep_result import SweepResult, distinguishing
from pyworm.scene.index import PLACE_NAMES
from pyworm.solver.accuracy_met import LESS_ACCURATE

MOST_ROWS = 60
"""Scenes beyond which the table is left to the file."""

# Heading, variable, factor from SI to the unit shown, format, of figures that a table has.
_FIGURES = (
    ("p max\nMPa", "pressure_max_Pa", 1e-6, ".4g"),
    ("h centr.\nµm", "film_central_m", 1e6, ".4g"),
    ("±\n%", "film_central_error", 100, ".2g"),
    ("h min\nµm", "film_min_m", 1e6, ".4g"),
    ("±\n%", "film_min_error", 100, ".2g"),
    ("lambda", "specific_film", 1, ".3g"),
    ("Friction", "friction_coefficient", 1, ".3g"),
    ("Film\n°C", "temperature_max_C_film", 1, ".1f"),
)


def show(result: SweepResult, directory: Path) -> None:
    """Print the table of a sweep and the paths of its files."""
    console = Console()
    data = result.table
    if sentence := result.left_out.sentence:
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
        f"{count} of {scenes} scenes did not converge: {reason}"
        for reason, count in reasons.most_common()
    ]
    wide = int((result.converged & ~result.accurate).sum())
    if wide:
        sentences.append(f"{wide} of {scenes} scenes are {LESS_ACCURATE}")
    return sentences


def rows(result: SweepResult) -> list[dict[str, Any]]:
    """The table as a list of objects, one for each scene."""
    named = {str(name): column.values.tolist() for name, column in result.table.items()}
    return [dict(zip(named, row, strict=True)) for row in zip(*named.values(), strict=True)]


def rows_table(result: SweepResult) -> Table:
    """The table with one row for each scene."""
    data = result.table
    varied = [name for axis in result.axes for name in distinguishing(result, axis)]
    varied += [name for name in PLACE_NAMES if name in data and len(np.unique(data[name])) > 1]
    shown = [figure for figure in _FIGURES if figure[1] in data]
    left_out = result.left_out
    table = Table(
        title=left_out.titled(result.title),
        title_justify="left",
        box=SIMPLE_HEAD,
        padding=0,
        show_edge=False,
    )
    for key in varied:
        unit = data[key].attrs.get("units", "")
        heading = key.rpartition(".")[2].replace("_", " ")
        table.add_column(f"{heading}\n{unit}".rstrip(), justify="right", overflow="fold")
    for heading, name, *_ in shown:
        if name == "friction_coefficient" and left_out.as_if_smooth:
            heading = f"{heading}\nas if\nsmooth"
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column("Con-\nverged")
    for number in range(data.sizes["scene"]):
        row = data.isel(scene=number)
        converged = row["converged"] == 1
        accurate = "yes" if row["accurate"] == 1 else "less accurate"
        cells = [_cell(row[key].item()) for key in varied]
        cells += [
            _figure(row, name, f"{row[name].item() * scale:{form}}") if converged else ""
            for _, name, scale, form in shown
        ]
        table.add_row(*cells, accurate if converged else "NO")
    return table


def _figure(row: "xr.Dataset", name: str, text: str) -> str:
    """A figure, as a lower bound where its error has no bound; empty where there is none."""
    if np.isnan(row[name]):
        return ""
    unbounded = name == "pressure_max_Pa" and not np.isfinite(row["pressure_max_error"])
    return f"≥ {text}" if unbounded else text


def _cell(value: float | str) -> str:
    return value if isinstance(value, str) else f"{value:.4g}"
