"""The way of a roller over Hooke's chart of regimes, from entry to exit of either section."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.formulas.film import LineGroups
from pyworm.formulas.regimes import (
    ISOVISCOUS_ELASTIC,
    ISOVISCOUS_RIGID,
    PIEZOVISCOUS_ELASTIC,
    PIEZOVISCOUS_RIGID,
    line_regime,
)
from pyworm.plots.roller_drive import SECTION_COLOURS
from pyworm.plots.style import MICRO, new_figure
from pyworm.result import Result

SHORT = {
    ISOVISCOUS_RIGID: "R-I",
    PIEZOVISCOUS_RIGID: "R-V",
    ISOVISCOUS_ELASTIC: "E-I",
    PIEZOVISCOUS_ELASTIC: "E-V",
}
"""Regime -> what it is called in the source and in the chart."""

SHADES = ["0.96", "#dfe9d8", "#e6e0ee", "#f6ecd6"]

SPEED = 1e-11
"""Speed parameter U at which the chart is drawn; it does not depend on it."""


def draw_roller_regimes(result: Result) -> Figure:
    """The chart with the way of the middle of the contact line; beside it the four formulas' films."""
    cycle = result.mesh_cycle
    figure = new_figure(11, 5.2, f"{result.case_name}  ·  regimes of lubrication")
    chart, films = figure.subplots(1, 2)
    middle = cycle.isel(station=cycle.sizes["station"] // 2)
    _draw_chart(chart, middle)
    _draw_films(films, middle)
    return figure


def _draw_chart(axes: Axes, middle) -> None:
    elastic, viscous = (
        middle[name].values for name in ("elasticity_parameter", "viscosity_parameter")
    )
    ends = [
        (min(0.5, np.nanmin(values) / 3), np.nanmax(values) * 10) for values in (elastic, viscous)
    ]
    ge, gv = (np.geomspace(low, high, 140) for low, high in ends)
    number = np.array([[_regime(x, y) for x in ge] for y in gv])
    axes.contourf(ge, gv, number, levels=np.arange(5) - 0.5, colors=SHADES)
    axes.contour(ge, gv, number, levels=np.arange(4) + 0.5, colors="0.4", linewidths=0.8)
    for index, name in enumerate(SHORT.values()):
        rows, columns = np.nonzero(number == index)
        if len(rows):
            axes.text(
                ge[int(np.median(columns))], gv[int(np.median(rows))], name, color="0.35", size=13
            )
    for section, colour in SECTION_COLOURS.items():
        way = middle.sel(section=section)
        x, y = way["elasticity_parameter"], way["viscosity_parameter"]
        axes.plot(x, y, color=colour, lw=2, label=f"{section} section")
        axes.plot(x[0], y[0], "o", color=colour, mec="black", ms=7)
        axes.plot(x[-1], y[-1], "s", color=colour, mec="black", ms=7)
    axes.plot([], [], "o", color="white", mec="black", label="entry")
    axes.plot([], [], "s", color="white", mec="black", label="exit")
    axes.set(xscale="log", yscale="log", xlim=ends[0], ylim=ends[1])
    axes.set_xlabel("elasticity parameter $g_E$")
    axes.set_ylabel("viscosity parameter $g_V$")
    axes.legend(frameon=False, loc="lower right")


def _regime(ge: float, gv: float) -> int:
    """Number of the regime at a place of the chart."""
    load = ge * SPEED**0.5
    material = gv / (load**3 / SPEED) ** 0.5
    return list(SHORT).index(line_regime(LineGroups(1.0, SPEED, load, material)).name)


def _draw_films(axes: Axes, middle) -> None:
    """What each regime's formula gives, and which of them holds."""
    for section in SECTION_COLOURS:
        way = middle.sel(section=section)
        angle = np.degrees(way["wheel_angle"])
        for number, (name, style) in enumerate(zip(SHORT, (":", "-.", "--", "-"), strict=True)):
            film = way["film_by_regime"].sel(regime=name) * MICRO
            label = SHORT[name] if section == "left" else None
            axes.plot(angle, film, style, color="0.25", lw=1.2, label=label)
            holds = way["regime_number"] == number
            axes.plot(angle.where(holds), film.where(holds), lw=4, alpha=0.6, color="tab:green")
    axes.plot([], [], lw=4, alpha=0.6, color="tab:green", label="the regime that holds")
    axes.axvspan(
        *(np.degrees(middle["wheel_angle"].sel(section=s).values[i]) for s, i in _THROAT),
        color="0.93",
    )
    axes.set_yscale("log")
    axes.set_xlabel("wheel angle of the roller / deg")
    axes.set_ylabel("minimum film by formula / µm")
    axes.grid(True, color="0.9")
    axes.legend(frameon=False, ncols=2, fontsize=8)


_THROAT = (("right", -1), ("left", 0))
"""What ends at the throat."""
