"""Films over time that are thinner than the grid of a transient solve shows, and the error that this proves.

A film under pressure is what its inlet lets in. At a start from near rest the inlet is narrower than a cell,
and the film is off by a height that hardly depends on it: for a ball of 10 mm radius from 0.001 m/s by 72 nm,
with half the spacing by 18 nm. Such films may be less than zero, by which they show the least error of the
grid.
"""

from collections.abc import Mapping, Sequence

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.planning.target import FILMS


def unresolved(figures: Sequence[Mapping[str, float]]) -> Array:
    """Times at which the minimum film thickness is not above zero: none of their films is a result."""
    return np.array([at_a_time["film_min"] <= 0 for at_a_time in figures])


def least_error(
    figures: Sequence[Mapping[str, float]], seconds: Array, speed: Array, reach: float
) -> Array:
    """Least error of the films at each time [m]: how far below zero any is within a distance that oil goes.

    Args:
        figures: Figures of a transient solve at its times.
        seconds: These times [s].
        speed: Entrainment then [m/s].
        reach: The distance [m].
    """
    depth = np.array([max(0.0, *(-at_a_time[name] for name in FILMS)) for at_a_time in figures])
    gone = np.append(0.0, np.cumsum((speed[1:] + speed[:-1]) / 2 * np.diff(seconds)))
    near = np.abs(gone[:, None] - gone[depth > 0]) <= reach
    least: Array = np.max(near * depth[depth > 0], axis=1, initial=0.0)
    return least
