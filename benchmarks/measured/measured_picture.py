"""Measured against computed, both with their standard uncertainty, on one panel for each kind of figure."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from pyworm.plots.layout import new_figure

if TYPE_CHECKING:
    from measured import Compared

PANELS = (
    ("film thickness / nm", 1e9, ("film thickness",), None),
    ("friction, limiting stress / pressure, efficiency", 1.0,
     ("friction coefficient", "limiting stress / pressure", "efficiency"), (0.02, 1.5)),
    ("pressure-viscosity coefficient / (1/GPa)", 1e9, ("pressure-viscosity coefficient",), None),
    ("viscosity / mPa s", 1e3, ("viscosity",), (1.0, 1e4)),
)  # fmt: skip
"""Title, factor from SI, quantities, and the range of logarithmic axes."""

HEADING = (
    "Measured and computed (thick: standard uncertainty, thin: with the model's; dashed: equal)"
)

MARKS = "os^Dvp*X"
"""Marks of the sources in their order."""


def draw(rows: "Sequence[Compared]") -> Figure:
    """Four panels; the dashed line is equality."""
    figure = new_figure(10, 9.5, HEADING)
    sources = list(dict.fromkeys(row.source for row in rows))
    marks = dict(zip(sources, MARKS, strict=False))
    for axes, (title, factor, quantities, ends) in zip(
        figure.subplots(2, 2).flat, PANELS, strict=True
    ):
        shown = [row for row in rows if row.quantity in quantities]
        for number, source in enumerate(sources):
            of_source = [row for row in shown if row.source == source]
            if of_source:
                _points(axes, of_source, factor, marks[source], f"C{number}")
        _finish(axes, title, ends)
    return figure


def _points(axes: Axes, rows: "Sequence[Compared]", factor: float, mark: str, colour: str) -> None:
    """Rows of one source: thick bars u_D and of the computation, thin ones with the model's uncertainty."""
    measured = [row.comparison.measured * factor for row in rows]
    computed = [row.comparison.computed.value * factor for row in rows]
    along = [row.comparison.measurement * factor for row in rows]
    numbers = [row.comparison.computed for row in rows]
    thick = [factor * (found.numerical**2 + found.by_inputs**2) ** 0.5 for found in numbers]
    model = [bar + found.model * factor for bar, found in zip(thick, numbers, strict=True)]
    style = {"fmt": "none", "ecolor": colour}
    axes.errorbar(measured, computed, yerr=model, elinewidth=0.6, alpha=0.5, **style)
    axes.errorbar(measured, computed, yerr=thick, xerr=along, elinewidth=1.8, **style)
    label = rows[0].source
    look = {"markersize": 6, "markeredgecolor": "white", "markeredgewidth": 0.6, "zorder": 5}
    axes.plot(measured, computed, mark, color=colour, label=label, **look)


def _finish(axes: Axes, title: str, ends: tuple[float, float] | None) -> None:
    """Equal axes with the line of equality."""
    if ends is not None:
        axes.set_xscale("log")
        axes.set_yscale("log")
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_formatter("{x:g}")
            axis.set_minor_formatter(NullFormatter())
    low = min(axes.get_xlim()[0], axes.get_ylim()[0]) if ends is None else ends[0]
    high = max(axes.get_xlim()[1], axes.get_ylim()[1]) if ends is None else ends[1]
    axes.plot([low, high], [low, high], "--", color="0.5", linewidth=1, zorder=0)
    axes.set_xlim(low, high)
    axes.set_ylim(low, high)
    axes.set_aspect("equal")
    axes.set_title(title)
    axes.set_xlabel("measured")
    axes.set_ylabel("computed")
    axes.grid(True, color="0.92")
    axes.legend(frameon=False, fontsize="small", loc="upper left")
