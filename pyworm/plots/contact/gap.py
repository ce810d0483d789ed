"""The undeformed gap with the tooth around it."""

import numpy as np
from matplotlib import colormaps
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle

from pyworm.io.plain_dataset import AnyDataset
from pyworm.plots.layout import MICRO, MILLI, Style, heading, nodes, panels, whole_window
from pyworm.plots.overlays import draw_contact_point, draw_dry_outline, draw_tooth
from pyworm.solver.solution import Solution

LEVELS = np.array([1, 2, 5])
"""Gap contours in each decade."""

LABELLED = 15
"""Contours of less than the largest gap over this are too small for a label."""


def draw_gap(case_name: str, solution: Solution) -> Figure:
    """Tooth outline, path of contact, dry contact and contours of the undeformed gap."""
    fields = solution.fields
    figure, (axes,) = panels(whole_window(fields), [""], heading(case_name, solution))
    gap, x, y = _widest_gap(fields)
    legend: list[Artist] = []
    if np.nanmax(gap) > 0:  # else there is nothing to draw contours of
        legend.append(_draw_contours(axes, gap, x, y))
    draw_tooth(axes, fields)
    draw_dry_outline(axes, fields, "tab:red")
    legend.append(Line2D([], [], color="tab:red", linewidth=1.2, label="dry contact"))
    if "tooth_outline_x" in fields:
        x, y = nodes(fields)
        look: Style = {"fill": False, "edgecolor": "0.5", "linestyle": ":", "label": "grid"}
        solved = Rectangle((x[0], y[0]), np.ptp(x), np.ptp(y), **look)
        axes.add_patch(solved)
        legend.append(solved)
    if "contact_path_x" in fields:
        path = (fields[f"contact_path_{axis}"].values * MILLI for axis in "xy")
        legend += axes.plot(*path, color="tab:blue", linewidth=1.5, label="path of contact")
    draw_contact_point(axes)
    place: Style = {"loc": "lower center", "bbox_to_anchor": (0.5, 1.0), "ncols": len(legend)}
    axes.legend(handles=legend, frameon=False, **place)
    return figure


def _draw_contours(axes: Axes, gap: np.ndarray, x: np.ndarray, y: np.ndarray) -> Line2D:
    """Contours of a gap [um] over x and y [mm]; and their legend."""
    highest = float(np.nanmax(gap))
    levels = _levels(highest)
    colours = colormaps["viridis"](np.linspace(0.1, 0.8, levels.size))
    contours = axes.contour(x, y, gap, levels=levels, colors=colours, linewidths=1.0)
    labelled = levels[levels >= highest / LABELLED]
    axes.clabel(contours, labelled, fmt=lambda value: f"{value:g}", fontsize="small")
    colour = colours[levels.size // 2]
    return Line2D([], [], color=colour, linewidth=1.0, label="undeformed gap / µm")


def _widest_gap(fields: AnyDataset) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Gap [um] over the whole tooth where it is known there, else over the grid, with x and y [mm]."""
    known = "tooth_gap" in fields and bool(np.isfinite(fields["tooth_gap"].values).any())
    prefix = "tooth_" if known else ""
    names = f"{prefix}y", f"{prefix}x"
    gap = fields[f"{prefix}gap"].transpose(*names).values * MICRO
    return gap, fields[names[1]].values * MILLI, fields[names[0]].values * MILLI


def _levels(highest: float) -> np.ndarray:
    """1, 2, 5, 10, ... over the three decades below the largest gap [um]."""
    last = np.ceil(np.log10(highest))
    levels = np.outer(10.0 ** np.arange(last - 4, last), LEVELS).ravel()
    return levels[(levels >= highest / 1000) & (levels < highest)]
