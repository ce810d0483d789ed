"""Measured against fitted values, with the expanded uncertainties of the measurements."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.io.quantities import quantity_of
from pyworm.plots.layout import add_grids, placed_panels
from pyworm.result.calibration import Calibration, FittedRow

COVERAGE = 2.0
"""Half length of a bar over the standard uncertainty."""


def draw_calibration(found: Calibration) -> Figure:
    """A panel for each measured quantity: measured over computed, before and after the fit."""
    names = list(dict.fromkeys(row.quantity for row in found.rows))
    size, room = (5.2, 4.6 * len(names) + 0.5), (0.9, 0.2, 0.6, 0.2)
    words = f"{found.case_name}  ·  fitted to {found.data_name}"
    figure, axes = placed_panels(size, words, room, len(names), space=0.25)
    for panel, name in zip(axes, names, strict=True):
        _draw(panel, name, [row for row in found.rows if row.quantity == name])
    add_grids(axes)
    return figure


def _draw(panel: Axes, name: str, rows: list[FittedRow]) -> None:
    quantity = quantity_of(name)
    measured, before, after = (
        quantity.number(np.array([getattr(row, part) for row in rows]))
        for part in ("measured", "before", "fitted")
    )
    bars = COVERAGE * quantity.scale * np.array([row.standard for row in rows])
    panel.plot(before, measured, "o", mfc="none", color="0.5", label="values of the case")
    panel.errorbar(
        after, measured, bars, fmt="o", color="tab:blue", capsize=3, label="fitted values"
    )
    low = min(measured.min() - bars.max(), before.min(), after.min())
    high = max(measured.max() + bars.max(), before.max(), after.max())
    margin = 0.04 * (high - low)
    ends = low - margin, high + margin
    panel.plot(ends, ends, color="0.3", linewidth=0.8)
    panel.set(xlim=ends, ylim=ends, aspect="equal")
    panel.set_xlabel(quantity.axis(f"computed {quantity.words()}"))
    panel.set_ylabel(quantity.axis(f"measured {quantity.words()}, ± 2 u"))
    panel.legend(frameon=False, loc="upper left")
