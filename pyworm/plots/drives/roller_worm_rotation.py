"""Rotation of a roller through both sections of the worm, with entrainment and film."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.formulas.unit_factors import RPM
from pyworm.io.on_demand import xarray as xr
from pyworm.plots.drives.roller_worm_drive import SECTION_COLOURS
from pyworm.plots.layout import MICRO, add_grids, joined, new_figure
from pyworm.result.result import Result

ZOOM = 3.0
"""Wheel angle after the entry into the driving section that is shown apart [deg]."""


def draw_roller_rotation(result: Result) -> Figure | None:
    """Speed, entrainment and film over the wheel angle; None where rollers are not turned by friction."""
    cycle = result.cycle_data
    if "rotation_speed" not in cycle:
        return None
    figure = new_figure(10.5, 8.5, joined(result.case_name, "rotation of a roller", "closed forms"))
    panels = figure.subplots(3, 2, sharex="col", gridspec_kw={"width_ratios": [2, 1]})
    angle = np.degrees(cycle["rotation_wheel_angle"].values)
    touches = np.isfinite(cycle["rotation_rolling"].values)
    entry = angle[_driving_entry(cycle, angle, touches)]
    forward = np.sign(angle[-1] - angle[0])
    for column in panels.T:
        _draw_speed(column[0], cycle, angle)
        _draw_touched(column[1], cycle, "rotation_entrainment", angle, 1.0)
        _draw_touched(column[2], cycle, "rotation_film", angle, MICRO)
        column[2].set_yscale("log")
        column[2].set_xlabel("wheel angle / °")
    panels[0, 0].set_ylabel("rotation / (1000 rpm)")
    panels[1, 0].set_ylabel("entrainment velocity,\nmean / (m/s)")
    panels[2, 0].set_ylabel("central film thickness\n(Moes), mean / µm")
    panels[0, 0].legend(frameon=False, fontsize=8)
    panels[0, 0].set_title("both sections", fontsize=10)
    panels[0, 1].set_title(f"entry into the {cycle.attrs['driving']} section, driving", fontsize=10)
    ends = entry - 0.3 * forward, entry + ZOOM * forward
    panels[2, 1].set_xlim(min(ends), max(ends))
    add_grids([*panels.flat])
    return figure


def _driving_entry(cycle: "xr.Dataset", angle: np.ndarray, touches: np.ndarray) -> int:
    """Sample at which the roller first touches the driving section."""
    beyond = angle > 0 if cycle.attrs["driving"] == "left" else angle < 0
    return int(np.flatnonzero(beyond & touches)[0])


def _draw_speed(axes: Axes, cycle: "xr.Dataset", angle: np.ndarray) -> None:
    rolling = cycle["rotation_rolling"].values * RPM / 1e3
    axes.plot(angle, cycle["rotation_speed"].values * RPM / 1e3, "k", lw=1.5, label="roller")
    axes.plot(angle, rolling, "--", color="tab:red", lw=1.2, label="without sliding")


def _draw_touched(
    axes: Axes, cycle: "xr.Dataset", name: str, angle: np.ndarray, factor: float
) -> None:
    """A variable over the wheel angle, in the colour of the section."""
    values = cycle[name].values * factor
    for section, sign in (("right", -1), ("left", 1)):
        inside = sign * angle > 0
        axes.plot(angle[inside], values[inside], color=SECTION_COLOURS[section], label=section)
