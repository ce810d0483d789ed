"""The work-precision picture: errors of a contact's figures against processor time."""

from collections.abc import Callable, Sequence
from textwrap import fill
from typing import Any

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter, NullFormatter

from pyworm.io.quantities import QUANTITIES
from pyworm.io.quantity_text import percent
from pyworm.precision.grid_series import Point
from pyworm.precision.study import Curve, Study

COLOURS = {
    "line contact": "tab:brown",
    "isothermal Newtonian point": "tab:blue",
    "isothermal Newtonian line": "tab:blue",
    "+ rheology": "tab:green",
    "+ surface heat": "tab:orange",
    "+ film heat": "tab:red",
    "+ roughness": "black",
}

FORMULA_MARKERS = "^v<>Dsp"

PARAMETER_COLOURS = "0.35", "tab:purple", "tab:cyan"

HOLLOW: dict[str, Any] = {"markersize": 4.5, "fillstyle": "none", "linewidth": 0.8, "zorder": 5}
"""Style of figures extrapolated from two grids."""

MIN_SHOWN_ERROR = 1e-6
"""Least error shown."""

PANEL_WIDTH, PANEL_HEIGHT = 7.4, 4.3
"""Size of a panel with its legend [inch]."""

FOOTER_LETTERS_PER_INCH = 13.5


def draw_precision(study: Study, heading: str) -> Figure:
    """Errors against seconds, a panel for each figure.

    Solid lines are errors against the reference, hollow circles those of figures extrapolated from two grids;
    the dotted line of each model is its discretisation error, which finer grids remove, and the plateau at
    its right is the error of the model.
    """
    shown = list(study.references)
    rows, columns = (len(shown) + 1) // 2, min(len(shown), 2)
    width = PANEL_WIDTH * columns
    omitted = [fill(line, int(FOOTER_LETTERS_PER_INCH * width)) for line in study.omitted]
    footer = "\n".join(["Omitted: " + "; ".join(omitted)] if omitted else [])
    footer = fill(footer, int(FOOTER_LETTERS_PER_INCH * width))
    bottom = 1.15 + 0.17 * footer.count("\n")
    height = PANEL_HEIGHT * rows + 0.5 + bottom
    figure = Figure(figsize=(width, height))
    figure.suptitle(
        f"Error against CPU time: {heading}", y=1 - 0.12 / height, verticalalignment="top"
    )
    panels = figure.subplots(rows, columns, squeeze=False).flat
    figure.subplots_adjust(
        left=1.05 / width,
        right=1 - 2.75 / width,
        top=1 - 0.85 / height,
        bottom=(bottom + 0.6) / height,
        wspace=0.86,
        hspace=0.28,
    )
    for panel, name in zip(panels[: len(shown)], shown, strict=True):
        _draw_panel(panel, study, name)
    for panel in list(panels)[len(shown) :]:
        panel.set_visible(False)
    _common_legend(figure, study, (0.5, (bottom - 0.02) / height))
    figure.text(
        0.2 / width, 0.12 / height, footer, fontsize=8, color="0.3", verticalalignment="bottom"
    )
    return figure


def _draw_panel(panel: Axes, study: Study, name: str) -> None:
    reference = study.references[name]
    panel.set_xscale("log")
    panel.set_yscale("log")
    handles: list[Artist] = []
    for curve in study.curves:
        drawn = _drawn(curve, lambda point: study.error(point, name))
        if not drawn:
            continue
        if curve.kind == "formula":
            marker = _look(study, curve, FORMULA_MARKERS)
            panel.plot(*zip(*drawn, strict=True), marker, color="black", fillstyle="none", zorder=4)
        elif curve.kind == "parameter":
            colour = _look(study, curve, PARAMETER_COLOURS)
            panel.plot(
                *zip(*drawn, strict=True), "--", marker=".", color=colour, linewidth=1, zorder=3
            )
        else:
            handles.append(_draw_model(panel, study, curve, name, drawn))
    panel.axhspan(
        MIN_SHOWN_ERROR / 10, max(reference.band, MIN_SHOWN_ERROR), color="0.88", zorder=0
    )
    handles.append(Patch(color="0.88", label=f"reference: ± {percent(reference.band)}"))
    for target in (0.1, 0.01, 0.001):
        panel.axhline(target, color="0.8", linewidth=0.8, zorder=1)
    low, high = panel.get_ylim()
    panel.set_ylim(max(low, MIN_SHOWN_ERROR, reference.band / 5), min(max(high, 1.5), 1e4))
    panel.yaxis.set_major_formatter(FuncFormatter(lambda fraction, _: percent(fraction)))
    panel.yaxis.set_minor_formatter(NullFormatter())
    panel.set_title(QUANTITIES[name].title(), fontsize="medium")
    panel.set_xlabel("CPU time / s")
    panel.set_ylabel("relative error")
    panel.legend(
        handles=handles, loc="upper left", bbox_to_anchor=(1.01, 1.0), fontsize=8, frameon=False
    )


def _drawn(curve: Curve, error_of: Callable[[Point], float | None]) -> list[tuple[float, float]]:
    """Processor time [s] and an error of each converged point that has one."""
    return [
        (point.seconds, max(error, MIN_SHOWN_ERROR))
        for point in curve.points
        if point.converged and (error := error_of(point)) is not None
    ]


def _draw_model(panel: Axes, study: Study, curve: Curve, name: str, drawn: list) -> Line2D:
    """One model: its error, the discretisation error, and the plateau."""
    colour = COLOURS[curve.name]
    panel.plot(*zip(*drawn, strict=True), "o-", color=colour, markersize=4.5, zorder=5)
    limits = _drawn(curve, lambda point: study.limit_error(point, name))
    if limits:
        panel.plot(*zip(*limits, strict=True), "o-.", color=colour, **HOLLOW)
    label = curve.name
    left = study.model_error(curve, name)
    if left is not None:
        grid = _drawn(curve, lambda point: study.grid_error(curve, point, name))
        panel.plot(*zip(*grid, strict=True), ":", color=colour, linewidth=1.2, zorder=2)
        last = drawn[-1][0]
        panel.plot([last, 6 * last], [max(left, MIN_SHOWN_ERROR)] * 2, color=colour, linewidth=0.8)
        order = curve.limits[name].order
        observed = "no order observed" if order is None else f"order {order:.1f}"
        label += f"\n   {observed}, model error {percent(left)}"
    return Line2D([], [], color=colour, marker="o", markersize=4.5, label=label)


def _look(study: Study, curve: Curve, looks: Sequence[str]) -> str:
    """The one of some looks that a curve has among those of its kind."""
    names = [other.name for other in study.curves if other.kind == curve.kind]
    return looks[names.index(curve.name)]


def _common_legend(figure: Figure, study: Study, place: tuple[float, float]) -> None:
    """Legend of formulas, numerical parameters and line styles."""
    handles = [
        Line2D(
            [],
            [],
            linestyle="none",
            marker=_look(study, curve, FORMULA_MARKERS),
            color="black",
            fillstyle="none",
            label=curve.name,
        )
        for curve in study.curves
        if curve.kind == "formula"
    ]
    for curve in study.curves:
        if curve.kind == "parameter":
            colour = _look(study, curve, PARAMETER_COLOURS)
            label = f"{curve.name}: {curve.points[0].label} to {curve.points[-1].label}"
            handles.append(
                Line2D([], [], linestyle="--", marker=".", color=colour, linewidth=1, label=label)
            )
    model = "model on finer and finer grids"
    handles.append(Line2D([], [], color="0.3", marker="o", markersize=4.5, label=model))
    if any(point.limits for curve in study.curves for point in curve.points):
        handles.append(
            Line2D([], [], color="0.3", marker="o", linestyle="-.", label="extrapolated", **HOLLOW)
        )
    handles.append(Line2D([], [], color="0.3", linestyle=":", label="discretisation part"))
    figure.legend(
        handles=handles,
        loc="upper center",
        bbox_to_anchor=place,
        ncols=min(4, len(handles)),
        fontsize=8,
        frameon=False,
    )
