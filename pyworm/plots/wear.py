"""Wear of a wheel over its life: depth, running in, contact pattern, and the depth over the flank."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.io.quantities import QUANTITIES
from pyworm.plots.layout import MICRO, MILLI, new_figure

if TYPE_CHECKING:
    from pyworm.batch.wear_run import WearFigures, WearRun


def draw_wear(name: str, run: "WearRun", limit: float) -> Figure:
    """Depth with its limit [m], friction and pattern over the hours, and maps of the depth."""
    figure = new_figure(11.0, 6.4, f"{name} · wear of the wheel, k = {run.coefficient:.3g} m²/N")
    panels = figure.subplots(2, 3)
    steps = run.steps
    _draw_depth(panels[0, 0], steps, limit)
    _draw_running_in(panels[0, 1], steps)
    _draw_pattern(panels[0, 2], steps)
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
    axes.plot(hours, [step.depth_max_m * MICRO for step in steps], "o-", label="maximum")
    axes.plot(
        hours, [step.depth_mean_m * MICRO for step in steps], "s-", label="mean in the pattern"
    )
    axes.plot(
        hours, [step.backlash_m * MICRO for step in steps], "^--", color="0.4", label="backlash"
    )
    if steps[-1].depth_max_m > 0.3 * limit:
        axes.axhline(limit * MICRO, color="tab:red", linestyle=":", label="permissible")
    axes.set_xlabel("time / h")
    axes.set_ylabel("wear depth / µm")
    axes.legend(frameon=False, fontsize="small")
    axes.grid(True, color="0.9")


def _draw_running_in(axes: Axes, steps: Sequence["WearFigures"]) -> None:
    hours = [step.hours for step in steps]
    axes.plot(hours, [step.friction for step in steps], "o-", color="tab:purple")
    axes.set_ylim(0, 1.15 * max(step.friction for step in steps))
    axes.set_xlabel("time / h")
    axes.set_ylabel(QUANTITIES["friction_coefficient"].axis(), color="tab:purple")
    shared = axes.twinx()
    shared.plot(hours, [100 * step.asperity_share for step in steps], "s--", color="tab:brown")
    shared.set_ylim(0, 115 * max(step.asperity_share for step in steps))
    shared.set_ylabel(QUANTITIES["asperity_load_fraction"].axis(), color="tab:brown")


def _draw_pattern(axes: Axes, steps: Sequence["WearFigures"]) -> None:
    hours = [step.hours for step in steps]
    axes.plot(hours, [step.pattern_m2 * 1e6 for step in steps], "o-", color="tab:blue")
    axes.set_ylim(0, 1.15 * max(step.pattern_m2 for step in steps) * 1e6)
    axes.set_xlabel("time / h")
    axes.set_ylabel("contact pattern / mm²", color="tab:blue")
    films = np.array([step.film_min_m for step in steps]) * MICRO
    axes_film = axes.twinx()
    axes_film.plot(hours, films, "s--", color="tab:green")
    axes_film.set_ylim(0, 1.15 * films.max())
    axes_film.set_ylabel(QUANTITIES["film_min"].axis(), color="tab:green")
