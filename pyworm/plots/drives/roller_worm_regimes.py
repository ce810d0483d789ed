"""The path of a roller over the chart of regimes of lines, from entry to exit of each section."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.formulas.regimes import LINE_ERROR, THICKENING_ERROR, Regime
from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import QUANTITIES
from pyworm.plots.drives.roller_worm_drive import SECTION_COLOURS
from pyworm.plots.layout import MICRO, add_grids, placed_panels
from pyworm.plots.regimes import SHORT, draw_chart
from pyworm.result.result import Result


def draw_roller_regimes(result: Result) -> Figure:
    """The chart with the path of the middle of the contact line; beside it the films by the four formulas."""
    cycle = result.cycle_data
    words, room = f"{result.case_name}  ·  regimes of lubrication", (0.8, 0.1, 0.6, 0.1)
    figure, (chart, films) = placed_panels((11, 5.2), words, room, columns=2, space=0.17)
    middle = cycle.isel(station=cycle.sizes["station"] // 2)
    _draw_chart(chart, middle)
    _draw_films(films, middle)
    return figure


def _draw_chart(axes: Axes, middle: "xr.Dataset") -> None:
    moes_m, moes_l = _moes(middle)
    oil = float(middle.attrs["alpha_ratio"])
    shape = Regime(1.0, 1.0, LINE_ERROR, THICKENING_ERROR, 1.0, 1.0, alpha_ratio=oil)
    entries = draw_chart(axes, shape, moes_m.values, moes_l.values)
    for section, colour in SECTION_COLOURS.items():
        cycle_part = middle.sel(section=section)
        x, y = _moes(cycle_part)
        axes.plot(x, y, color=colour, lw=2, label=f"{section} section")
        axes.plot(x[0], y[0], "o", color=colour, mec="black", ms=7)
        axes.plot(x[-1], y[-1], "s", color=colour, mec="black", ms=7)
    axes.plot([], [], "o", color="white", mec="black", label="entry")
    axes.plot([], [], "s", color="white", mec="black", label="exit")
    handles, labels = axes.get_legend_handles_labels()
    labels += [entry.get_label() for entry in entries]
    axes.legend([*handles, *entries], labels, framealpha=0.8, fontsize=8, loc="lower left")


def _moes(cycle: "xr.Dataset") -> tuple["xr.DataArray", "xr.DataArray"]:
    """Moes' M and L of Johnson's parameters, `pyworm.formulas.regime_charts.line_parameters`."""
    moes_m = cycle["elasticity_parameter"] / np.sqrt(2)
    return moes_m, cycle["viscosity_parameter"] / np.sqrt(2) / moes_m**1.5


def _draw_films(axes: Axes, middle: "xr.Dataset") -> None:
    """Film by the formula of each regime, and the regime that holds."""
    for section in SECTION_COLOURS:
        cycle_part = middle.sel(section=section)
        angle = cycle_part["wheel_angle"] * (180 / np.pi)
        for number, (name, style) in enumerate(zip(SHORT, (":", "-.", "--", "-"), strict=True)):
            film = cycle_part["film_by_regime"].sel(regime=name) * MICRO
            label = SHORT[name].replace("\n", " ") if section == "left" else None
            axes.plot(angle, film, style, color="0.25", lw=1.2, label=label)
            holds = cycle_part["regime_number"] == number
            axes.plot(angle.where(holds), film.where(holds), lw=4, alpha=0.6, color="tab:green")
    axes.plot([], [], lw=4, alpha=0.6, color="tab:green", label="the regime that holds")
    axes.axvspan(
        *(np.degrees(middle["wheel_angle"].sel(section=s).values[i]) for s, i in _THROAT),
        color="0.93",
    )
    axes.set_yscale("log")
    axes.set_xlabel("wheel angle of the roller / °")
    film_min = QUANTITIES["film_min"]
    axes.set_ylabel(film_min.axis(f"{film_min.words()} by formula"))
    add_grids([axes])
    axes.legend(frameon=False, ncols=2, fontsize=8)


_THROAT = (("right", -1), ("left", 0))
"""What ends at the throat."""
