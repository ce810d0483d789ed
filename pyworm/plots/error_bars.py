"""Error bars of figures over a sweep: the numerical one, and behind it that of the model of roughness."""

from collections.abc import Sequence
from math import isfinite, nan

import numpy as np
from matplotlib.axes import Axes

from pyworm.io.quantities import QUANTITIES
from pyworm.plots.layout import Style, broken, mark_gaps
from pyworm.solver.solution import Estimate, Solution

Array = np.ndarray

BODY_COLOURS = "tab:blue", "tab:orange", "tab:red"
"""Colours of curves of the first body, the second one and the film between them."""

TEMPERATURES = "temperature_max_body_1", "temperature_max_body_2", "temperature_max_film"
"""Largest temperatures of the first body, the second one and the film."""


def estimates_of(solutions: Sequence[Solution], name: str) -> tuple[list[Estimate], Array, Array]:
    """A figure of solutions with its values as shown, and what its errors are relative to, as shown.

    Values are NaN, and so gaps of a curve, where a solution did not converge; errors of temperatures are
    relative to the rise, and NaN without bound.
    """
    quantity = QUANTITIES[name]
    estimates = [getattr(solution.figures, name) for solution in solutions]
    converged = [solution.converged for solution in solutions]
    values = np.where(converged, [estimate.value for estimate in estimates], np.nan)
    rises = [
        (solution.rise(estimate) if quantity.unit == "K" else estimate.value)
        if isfinite(estimate.error)
        else nan
        for solution, estimate in zip(solutions, estimates, strict=True)
    ]
    return estimates, quantity.number(values), np.abs(rises) * quantity.scale


def draw_figure(
    axes: Axes,
    places: Sequence[float] | Array,
    solutions: Sequence[Solution],
    name: str,
    style: Style,
    signs: Array | float = 1.0,
) -> Array:
    """Draw a figure over a sweep with both error bars, the model's wide and pale; returns its values.

    `style` is that of `Axes.errorbar`; of values that a sign is given to errors keep their size.
    """
    estimates, values, sizes = estimates_of(solutions, name)
    values = signs * values
    numerical = sizes * [estimate.error for estimate in estimates]
    (line, *_) = axes.errorbar(places, values, numerical, **style)
    model = sizes * [np.nan if estimate.model is None else estimate.model for estimate in estimates]
    known = np.isfinite(model)
    known_places, middle, half = (np.asarray(numbers)[known] for numbers in (places, values, model))
    low = np.maximum(middle - half, np.minimum(middle, 0.0))
    axes.vlines(known_places, low, middle + half, color=line.get_color(), alpha=0.25, linewidth=6)
    return values


def draw_largest_temperatures(
    axes: Axes, places: Sequence[float], solutions: Sequence[Solution], bodies: tuple[str, str]
) -> None:
    """Largest temperatures of heated solutions over a sweep, with their error bars, and the inlet's."""
    for name, label, colour in zip(TEMPERATURES, (*bodies, "film"), BODY_COLOURS, strict=True):
        style = {"fmt": "o-", "color": colour, "capsize": 3, "label": label}
        draw_figure(axes, places, solutions, name, style)
    inlet = np.array([solution.inlet_temperature for solution in solutions])
    maximum = QUANTITIES["temperature_max"]
    axes.plot(places, maximum.number(inlet), "--", color="0.4", label="inlet")
    mark_gaps(axes, places, solutions)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.25 * (high - low))  # room for the legend
    axes.set_ylabel(broken(maximum.axis()))
    axes.legend(frameon=False, ncols=4, loc="upper left")
