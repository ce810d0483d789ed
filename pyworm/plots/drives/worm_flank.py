"""The wheel's flank over a mesh cycle, for comparison with a worn tooth."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke
from matplotlib.ticker import LogLocator, NullLocator

from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import QUANTITIES
from pyworm.plots.layout import MILLI, broken, new_figure, result_heading
from pyworm.result.flank_map import FAILURE, flank_map
from pyworm.result.flank_wear import FlankGrid, flank_work
from pyworm.result.result import Result

_PANELS = (
    "film", "pressure", "temperature_body_2", "asperity_pressure", "asperity_rubbing", "asperity_work",
    "entry", "fatigue_ratio_body_2", "pitting_probability",
)  # fmt: skip
"""Fields that are shown."""

SHOWN_RATIO = 0.01
"""That product over the largest above which a place is shown."""

MARKS = (0.0, 0.25, 0.5, 0.75, 1.0)
"""Phases marked on the path of contact."""


def draw_flank(result: Result) -> Figure | None:
    """Film, pressure, temperature and entering oil on the wheel's flank; None without enough phases."""
    field = flank_map(result)
    if field is None:
        return None
    work = flank_work(result, FlankGrid(field["face"].values, field["radius"].values))
    if work is not None:
        field["asperity_work"] = (
            ("radius", "face"),
            np.where(work > SHOWN_RATIO * work.max(), work, np.nan),
        )
    cycle = result.cycle_data
    if "pitting_probability" in field and not field["pitting_probability"].max() > 0:
        field = field.drop_vars("pitting_probability")
    shown = [QUANTITIES[name] for name in _PANELS if name in field]
    rows = (len(shown) + 1) // 2
    gaps = ", ".join(f"{solution.phase:g}" for solution in result.unsound)
    what = f"wheel flank, phase {gaps} not converged, not shown" if gaps else "wheel flank"
    figure = new_figure(13, 2.4 * rows + 0.5, result_heading(result, what))
    axes = figure.subplots(rows, 2, squeeze=False).ravel()
    places = field["face"] * MILLI, field["radius"] * MILLI
    for panel, quantity in zip(axes[: len(shown)], shown, strict=True):
        name, label = quantity.name, quantity.axis(quantity.worst(result.body_names))
        if name == "entry":
            label += f" (white: {FAILURE:g})"
        values = quantity.number(field[name])
        thick = name in THICK
        mesh = panel.pcolormesh(
            *places,
            values,
            cmap=quantity.colours,
            shading="nearest",
            norm=LogNorm(float(values.min()), THICK[name] * float(values.min())) if thick else None,
        )
        bar = figure.colorbar(
            mesh, ax=panel, label=broken(label), shrink=0.8, extend="max" if thick else "neither"
        )
        if thick:
            bar.ax.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
            bar.ax.yaxis.set_major_formatter("{x:g}")
            bar.ax.yaxis.set_minor_locator(NullLocator())
        if name == "entry":
            panel.contour(*places, field[name], levels=[FAILURE], colors="white", linewidths=1.2)
        if name == "pitting_probability":
            of_flank = quantity.number(field.attrs["pitting_probability_of_flank"])
            panel.set_title(f"of the whole flank: {of_flank:.3g} %", fontsize="medium")
        _draw_tooth(panel, cycle)
    for panel in axes[len(shown) :]:
        panel.remove()
    return figure


THICK = {"film": 10.0}
"""Field that grows without bound off the contact -> how far above its least value colours end, as a ratio."""


def _draw_tooth(axes: Axes, cycle: "xr.Dataset") -> None:
    """Outline of the flank and path of contact with its phases."""
    axes.plot(cycle["rim_face"] * MILLI, cycle["rim_radius"] * MILLI, color="0.25", lw=1.5)
    point = cycle["point"]
    face = point.sel(axis="y").values * MILLI
    radius = np.hypot(point.sel(axis="x").values, point.sel(axis="z").values) * MILLI
    axes.plot(face, radius, color="0.5", lw=1.0)
    for mark in MARKS:
        along, across = (
            float(np.interp(mark, cycle["phase"], coordinate)) for coordinate in (face, radius)
        )
        axes.plot(along, across, "o", color="white", mec="black", ms=4)
        axes.annotate(
            f"{mark:g}" if mark else "phase 0",
            (along, across),
            xytext=(5, 4),
            textcoords="offset points",
            fontsize=7,
            path_effects=[withStroke(linewidth=2, foreground="white")],
        )
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    axes.set_xlim(left - 0.06 * (right - left), right + 0.06 * (right - left))
    axes.set_ylim(low - 0.15 * (high - low), high + 0.08 * (high - low))
    name_sides(axes, cycle.attrs.get("driver", "worm") == "worm", root=0.02)
    axes.set_aspect("equal")
    axes.set_xlabel("face width coordinate / mm")
    axes.set_ylabel("radius / mm")


def name_sides(axes: Axes, leaving_right: bool, root: float) -> None:
    """Words at tip, root and both ends of a flank that fills a panel, whose left is the start of the face.

    The worm's threads leave at the right end if `leaving_right`; the word for the root stands at the height
    `root`, a fraction of the panel.
    """
    right, left = ("leaving side", "entering side")[:: 1 if leaving_right else -1]
    in_axes = axes.transAxes
    axes.text(0.5, 0.985, "tip", ha="center", va="top", transform=in_axes)
    axes.text(0.5, root, "root", ha="center", va="bottom", transform=in_axes)
    axes.text(0.985, 0.5, right, rotation=90, ha="right", va="center", transform=in_axes)
    axes.text(0.015, 0.5, left, rotation=90, ha="left", va="center", transform=in_axes)
