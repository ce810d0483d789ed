"""The way of a tooth contact over the chart of regimes of point contacts."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from pyworm.drive_cycle import FEWEST_PHASES
from pyworm.formulas.film import PointGroups, radii_at_angle
from pyworm.formulas.regimes import (
    ISOVISCOUS_ELASTIC,
    ISOVISCOUS_RIGID,
    PIEZOVISCOUS_ELASTIC,
    PIEZOVISCOUS_RIGID,
    point_regime,
)
from pyworm.plots.style import new_figure
from pyworm.result import Result
from pyworm.solution import Solution

NAMES = (ISOVISCOUS_RIGID, PIEZOVISCOUS_RIGID, ISOVISCOUS_ELASTIC, PIEZOVISCOUS_ELASTIC)

SHADES = ["0.96", "#dfe9d8", "#e6e0ee", "#f6ecd6"]

SPEED = 1e-11
"""Speed parameter U at which the chart is drawn; it does not depend on it."""

NODES = 90


def draw_regime_path(result: Result) -> Figure | None:
    """Hamrock and Dowson's regimes over Moes' parameters, with the phases solved; None with too few of them.

    The regimes are those of the radii in mid-mesh.
    """
    solved = sorted(
        (one for one in result.solutions if one.phase is not None), key=lambda one: one.phase
    )
    if len(solved) < FEWEST_PHASES:
        return None
    figure = new_figure(7, 5.2, f"{result.case_name}  ·  regimes of lubrication")
    axes = figure.subplots()
    m = np.array([one.figures.moes_m for one in solved])
    l_ = np.array([one.figures.moes_l for one in solved])
    ends = [(values.min() / 10, values.max() * 10) for values in (m, l_)]
    _draw_chart(axes, *ends, _ratio(result, solved[len(solved) // 2]))
    phases = axes.scatter(m, l_, c=[one.phase for one in solved], cmap="viridis", zorder=3)
    axes.plot(m, l_, color="black", lw=1.0)
    figure.colorbar(phases, ax=axes, label="phase of the mesh cycle")
    axes.set(xscale="log", yscale="log", xlim=ends[0], ylim=ends[1])
    axes.set_xlabel("load parameter $M$")
    axes.set_ylabel("lubricant parameter $L$")
    return figure


def _ratio(result: Result, solution: Solution) -> float:
    """D, radius along over radius across the entrainment, at a solution's contact point."""
    cycle = result.mesh_cycle
    radii = [
        float(np.interp(solution.phase, cycle["phase"], cycle[f"radius_{axis}"])) for axis in "xy"
    ]
    at = solution.fields[["entrainment_x", "entrainment_y"]].interp(x=0.0, y=0.0)
    along, across = radii_at_angle(
        *radii, float(np.arctan2(at["entrainment_y"], at["entrainment_x"]))
    )
    return along / across


def _draw_chart(axes: Axes, ms: tuple[float, float], ls: tuple[float, float], ratio: float) -> None:
    load, oil = (np.geomspace(low, high, NODES) for low, high in (ms, ls))
    number = np.array([[NAMES.index(_regime(m, l_, ratio)) for m in load] for l_ in oil])
    axes.contourf(load, oil, number, levels=np.arange(5) - 0.5, colors=SHADES)
    axes.contour(load, oil, number, levels=np.arange(4) + 0.5, colors="0.4", linewidths=0.8)
    shown = [index for index in range(len(NAMES)) if (number == index).any()]
    patches = [
        Patch(facecolor=SHADES[index], edgecolor="0.4", label=NAMES[index]) for index in shown
    ]
    axes.legend(handles=patches, loc="lower right", fontsize=8)


def _regime(m: float, l_: float, ratio: float) -> str:
    """The regime at a place of the chart."""
    groups = PointGroups(
        radius=1.0,
        ratio=ratio,
        speed=SPEED,
        load=m * (2 * SPEED) ** 0.75,
        material=l_ * (2 * SPEED) ** -0.25,
    )
    return point_regime(groups).name
