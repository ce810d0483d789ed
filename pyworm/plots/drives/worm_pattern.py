"""The contact pattern of worm and wheel, without load and under it, as marking compound shows it."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.io.on_demand import xarray as xr
from pyworm.plots.drives.worm_flank import name_sides
from pyworm.plots.layout import MICRO, MILLI, new_figure, result_heading
from pyworm.result.result import Result

LEVELS = 10.0, 20.0, 50.0, 100.0
"""Separations of the lines beyond the marked part [um]."""

MARKED = "#3f6fb5"
"""Colour of the marked part, as of engineer's blue."""


ROWS = (
    ("marking_separation", "marking_fraction", "without load"),
    ("loaded_separation", "loaded_marking_fraction", "under load"),
)
"""Separation, marked part, and how the compound was marked."""


def draw_pattern(result: Result) -> Figure | None:
    """Both flanks without load and under it, lines of equal separation beyond; None without a pattern."""
    cycle = result.cycle_data
    if "marking_separation" not in cycle:
        return None
    thickness = cycle.attrs["marking_thickness"] * MICRO
    what = f"contact pattern, compound of {thickness:g} µm"
    figure = new_figure(13, 7.4, result_heading(result, what))
    axes = figure.subplots(2, 2, sharex=True, sharey=True)
    forward = cycle.attrs["driver"] == "worm"
    names = "flank that the worm drives", "other flank, the worm turned the other way"
    for row, (separation, part, load) in zip(axes, ROWS, strict=True):
        for number, flank in enumerate(cycle["marked_flank"].values):
            panel, here = row[number], cycle.sel(marked_flank=flank)
            _draw_marks(panel, here, here[separation].values * MICRO, thickness)
            _name_sides(panel, leaving_right=forward == (number == 0))
            panel.set_title(f"{names[number]}, {load}: {float(here[part]):.0%} marked", fontsize=9)
        row[0].set_ylabel("radius / mm")
    for panel in axes[-1]:
        panel.set_xlabel("face width coordinate / mm")
    return figure


def _draw_marks(axes: Axes, flank: "xr.Dataset", separation: np.ndarray, thickness: float) -> None:
    """Outline of the flank, what is marked, and lines of equal separation [um]."""
    face, radius = flank["marking_place"].values * MILLI, flank["marking_radius"].values * MILLI
    for edge in (0, -1):
        axes.plot(face[edge], radius[edge], color="0.25", lw=1.5)
        axes.plot(face[:, edge], radius[:, edge], color="0.25", lw=1.5)
    axes.contourf(face, radius, separation, [-1.0, thickness], colors=[MARKED])
    lines = axes.contour(face, radius, separation, LEVELS, colors="0.5", linewidths=0.8)
    axes.clabel(lines, fmt="%g µm", fontsize=7)
    half, low, high = face.max(), radius.min(), radius.max()
    axes.set_xlim(-1.15 * half, 1.15 * half)
    axes.set_ylim(low - 0.3 * (high - low), high + 0.1 * (high - low))
    axes.set_aspect("equal")


def _name_sides(axes: Axes, leaving_right: bool) -> None:
    """Words at the four sides of a flank, and the way of the worm's threads over it."""
    name_sides(axes, leaving_right, root=0.235)
    ends = (0.75, 0.25) if not leaving_right else (0.25, 0.75)
    axes.annotate(
        "",
        (ends[1], 0.05),
        (ends[0], 0.05),
        xycoords="axes fraction",
        arrowprops={"arrowstyle": "->", "color": "0.3"},
    )
    axes.text(0.5, 0.07, "threads of the worm", ha="center", fontsize=8, transform=axes.transAxes)
