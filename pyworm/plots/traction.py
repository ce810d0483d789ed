"""A traction curve: friction and largest temperatures over slide-roll ratio."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.io.present import present
from pyworm.io.quantities import QUANTITIES
from pyworm.plots.error_bars import draw_figure, draw_largest_temperatures
from pyworm.plots.layout import add_grids, drawn_into, mark_gaps, placed_panels, result_heading
from pyworm.result.headline import of_all
from pyworm.result.result import Result
from pyworm.solver.solution import Solution


def draw_traction(result: Result, ax: Axes | None = None) -> Figure:
    """Friction coefficient, and maximum temperatures where heat was simulated, with their uncertainties.

    With `ax` they take the place of these axes.
    """
    with drawn_into(ax):
        return _drawn(result)


def _drawn(result: Result) -> Figure:
    """The traction curve."""
    swept = sorted(traction_curve(result), key=lambda solution: solution.slide_roll_ratio or 0.0)
    heated = [solution for solution in swept if solution.figures.temperature_max_film is not None]
    rows = 2 if heated else 1
    size, room = (8, 3.2 * rows + 0.6), (0.9, 0.1, 0.5, 0.1)
    words = result_heading(result, "traction curve")
    figure, axes = placed_panels(size, words, room, rows, space=0.06, sharex=True)
    _draw_friction(axes[0], swept)
    if heated:
        ratios = [_slide_roll_ratio(solution) for solution in heated]
        draw_largest_temperatures(axes[1], ratios, heated, result.body_names)
    add_grids(axes)
    axes[-1].set_xlabel("slide-roll ratio")
    return figure


def _slide_roll_ratio(solution: Solution) -> float:
    return present(solution.slide_roll_ratio, f"slide-roll ratio of {solution.name}")


def traction_curve(result: Result) -> list[Solution]:
    """The solutions of a traction curve; none if the result has no slide-roll ratios."""
    return [
        solution
        for solution in result.solutions
        if solution.slide_roll_ratio is not None
        and solution.figures.friction_coefficient is not None
    ]


def _draw_friction(axes: Axes, swept: list[Solution]) -> None:
    """The friction coefficient takes the sign of the sliding."""
    ratios = [_slide_roll_ratio(solution) for solution in swept]
    name, style = "friction_coefficient", {"fmt": "o-", "color": "tab:purple", "capsize": 3}
    draw_figure(axes, ratios, swept, name, style, np.sign(ratios))
    mark_gaps(axes, ratios, swept)
    if not all(solution.converged for solution in swept):
        axes.legend(frameon=False)
    axes.set_ylabel(of_all(swept).qualified(QUANTITIES[name].axis()))
