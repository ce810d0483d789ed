"""Wear of a wheel over its life: depth, running in, contact pattern, and the depth over the flank."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.io.quantities import QUANTITIES
from pyworm.plots.layout import MICRO, MILLI, add_grids, new_figure

if TYPE_CHECKING:
    from pyworm.batch.wear_run import WearFigures, WearRun


def draw_wear(name: str, run: "WearRun", limit: float) -> Figure:
    """Depth with its limit [m], friction and pattern over the hours, and maps of the depth."""
    figure = new_figure(11.0, 6.4, f"{name} · wear of the wheel, k = {run.coefficient:.3g} m²/N")
    panels = figure.subplots(2, 3)
    steps = run.steps
    _draw_depth(panels[0, 0], steps, limit)
    for axes, pair in zip(panels[0, 1:], _PAIRS, strict=True):
        _draw_pair(axes, steps, pair)
    chosen = sorted({min(1, len(steps) - 1), len(steps) // 2, len(steps) - 1})
    deepest = max(float(run.depths[-1].max()) * MICRO, 1e-3)
    for axes, index in zip(panels[1][: len(chosen)], chosen, strict=True):
        drawn = axes.pcolormesh(
            run.grid.face * MILLI, run.grid.radius * MILLI, run.depths[index] * MICRO,
            cmap="inferno", vmin=0, vmax=deepest, rasterized=True,
        )  # fmt: skip
        axes.set_title(f"after {steps[index].hours:.4g} h", fontsize="small")
        axes.set_xlabel("face width coordinate / mm")
        axes.set_ylabel("radius / mm")
        figure.colorbar(drawn, ax=axes, label="wear depth / µm", pad=0.03)
    for axes in panels[1, len(chosen) :]:
        axes.set_axis_off()
    return figure


def _draw_depth(axes: Axes, steps: Sequence["WearFigures"], limit: float) -> None:
    hours = [step.hours for step in steps]
    for name, style, label, colour in (
        ("depth_max_m", "o-", "maximum", "tab:blue"),
        ("depth_mean_m", "s-", "mean in the pattern", "tab:orange"),
        ("backlash_m", "^--", "backlash", "0.4"),
    ):
        depths = [getattr(step, name) * MICRO for step in steps]
        axes.plot(hours, depths, style, label=label, color=colour)
    if steps[-1].depth_max_m > 0.3 * limit:
        axes.axhline(limit * MICRO, color="tab:red", linestyle=":", label="permissible")
    axes.set_xlabel("time / h")
    axes.set_ylabel("wear depth / µm")
    axes.legend(frameon=False, fontsize="small")
    add_grids([axes])


_PAIRS = (
    (
        ("friction", 1.0, QUANTITIES["friction_coefficient"].axis(), "o-", "tab:purple"),
        ("asperity_share", 100.0, QUANTITIES["asperity_load_fraction"].axis(), "s--", "tab:brown"),
    ),
    (
        ("pattern_m2", 1e6, "contact pattern / mm²", "o-", "tab:blue"),
        ("film_min_m", MICRO, QUANTITIES["film_min"].axis(), "s--", "tab:green"),
    ),
)
"""Figure on the left and on the right of each panel: factor to the unit shown, label, style and colour."""


def _draw_pair(axes: Axes, steps: Sequence["WearFigures"], pair: tuple) -> None:
    """Two figures over time, each on a scale from zero of its own."""
    axes.set_xlabel("time / h")
    for panel, (name, scale, label, style, colour) in zip((axes, axes.twinx()), pair, strict=True):
        values = scale * np.array([getattr(step, name) for step in steps])
        panel.plot([step.hours for step in steps], values, style, color=colour)
        panel.set_ylim(0, 1.15 * values.max())
        panel.set_ylabel(label, color=colour)
