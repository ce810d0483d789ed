"""How a solution converged."""

from math import ceil

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from pyworm.plots.layout import add_grids, heading, placed_panels
from pyworm.solver.solution import Solution

LEGEND_COLUMNS = 4


def draw_history(case_name: str, solution: Solution) -> Figure:
    """Residual (dots) and load error (thin) against iteration, a colour for each grid in turn."""
    history = solution.history
    iteration = history["iteration"].values
    grids = np.stack([history[name].values for name in ("points_x", "points_y") if name in history])
    starts = np.flatnonzero(np.any(np.diff(grids, axis=1) != 0, axis=0)) + 1
    rows = ceil((starts.size + 2) / LEGEND_COLUMNS)  # the stages and the load error
    room = (0.75, 0.1, 0.6 + 0.21 * rows, 0.1)
    figure, (axes,) = placed_panels((8, 5.2), heading(case_name, solution), room)
    for stage in np.split(np.arange(iteration.size), starts):
        if stage.size == 0:
            continue
        (residual,) = axes.semilogy(
            iteration[stage],
            _positive(history["residual"].values[stage]),
            "o-",
            markersize=3.5,
            label=f"{' by '.join(f'{points:.0f}' for points in grids[:, stage[0]])} points",
        )
        error = _positive(np.abs(history["load_error"].values[stage]))
        axes.semilogy(iteration[stage], error, "--", color=residual.get_color(), linewidth=0.9)
    axes.plot([], [], "--", color="0.3", linewidth=0.9, label="load error")
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set_xlabel("iteration")
    axes.set_ylabel("relative residual")
    add_grids([axes])
    figure.legend(loc="lower center", ncols=LEGEND_COLUMNS, frameon=False)
    return figure


def _positive(values: np.ndarray) -> np.ndarray:
    """Values for a logarithmic axis, which has no place for an exact zero."""
    return np.where(values > 0, values, np.nan)
