"""Error bars of figures over a sweep: the numerical one, and behind it that of the model of roughness."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from pyworm.solver.solution import Estimate

Array = np.ndarray


def draw_estimates(
    axes: Axes,
    places: Sequence[float] | Array,
    values: Array,
    sizes: Array,
    estimates: Sequence[Estimate],
    **style: Any,
) -> None:
    """Draw figures over a sweep with both error bars, the model's wide and pale.

    `values` are in the unit of the axes, `sizes` what errors are relative to, in that unit: of temperatures
    the rise. `style` is that of `Axes.errorbar`.
    """
    sizes = np.abs(sizes)
    numerical = sizes * [estimate.error for estimate in estimates]
    (line, *_) = axes.errorbar(places, values, numerical, **style)
    model = sizes * [np.nan if estimate.model is None else estimate.model for estimate in estimates]
    known = np.isfinite(model)
    known_places, middle, half = (np.asarray(numbers)[known] for numbers in (places, values, model))
    low = np.maximum(middle - half, np.minimum(middle, 0.0))
    axes.vlines(known_places, low, middle + half, color=line.get_color(), alpha=0.25, linewidth=6)
