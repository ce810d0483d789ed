"""A roller enveloping worm drive in three dimensions: rollers, both sections' flanks, contact lines."""

from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MultipleLocator

from pyworm.io.on_demand import xarray as xr
from pyworm.plots.layout import MILLI, new_figure
from pyworm.result.result import Result

SECTION_COLOURS = {"right": "tab:orange", "left": "tab:blue"}
"""Colour of a section in all pictures of the drive."""


def draw_roller_drive(result: Result) -> Figure:
    """The drive from the front and from above; rollers in mesh are dark, contact lines red."""
    cycle = result.cycle_data
    figure = new_figure(11, 5.6, f"{result.case_name}  ·  rollers, worm flanks and contact lines")
    views = ((24, -100, "the gear set"), (90, -90, "along the wheel's axis"))
    for number, (elevation, azimuth, title) in enumerate(views):
        axes = figure.add_subplot(1, 2, number + 1, projection="3d")
        axes.set_proj_type("ortho")
        _draw_rollers(axes, cycle)
        for section in cycle["section"].values:
            x, y, z = _components(cycle["flank"].sel(section=section))
            axes.plot_surface(
                x, y, z, color=SECTION_COLOURS[section], alpha=0.55, rcount=5, ccount=240, lw=0
            )
            axes.plot([], [], color=SECTION_COLOURS[section], lw=6, label=f"{section} section")
        for line in cycle["contact_line"].values:
            axes.plot(*(line.T * MILLI), color="tab:red", lw=2.2, zorder=20)
        axes.plot([], [], color="tab:red", lw=2.2, label="contact line")
        sizes = [np.diff(limits())[0] for limits in (axes.get_xlim, axes.get_ylim, axes.get_zlim)]
        axes.set_box_aspect(sizes, zoom=1.12)
        for ticked in (axes.xaxis, axes.yaxis, axes.zaxis):
            ticked.set_major_locator(MultipleLocator(100))
        axes.view_init(elevation, azimuth)
        axes.set_title(title, fontsize=10)
        axes.set_xlabel("x / mm")
        axes.set_ylabel("y / mm")
        if number:
            axes.set_zticks([])
            # seen from above the axis' own label falls off the picture
            axes.set_xlabel("")
            axes.text2D(0.5, -0.04, "x / mm", transform=axes.transAxes, ha="center")
        else:
            axes.set_zlabel("z / mm")
            axes.legend(loc="upper left", frameon=False, fontsize=8)
    return figure


def _draw_rollers(axes: Any, cycle: "xr.Dataset") -> None:
    """All rollers of the wheel; those that touch are darker."""
    lines = cycle["contact_line"].mean("across").values
    for surface in cycle["roller_surface"].values:
        away = np.linalg.norm(lines - surface.mean(axis=(0, 1)), axis=-1).min()
        touching = away < np.linalg.norm(np.ptp(surface, axis=(0, 1))) / 2
        x, y, z = (part * MILLI for part in np.moveaxis(surface, -1, 0))
        axes.plot_surface(x, y, z, color="0.35" if touching else "0.8", alpha=0.9, lw=0)


def _components(points: "xr.DataArray") -> tuple[np.ndarray, ...]:
    return tuple(points.sel(axis=axis).values * MILLI for axis in "xyz")
