"""Heat of oil that circulates in the inlet of a thick film, where no temperature is found.

Where the gap is above three times the film at its narrowest oil flows back in the middle, in closed paths.
Wide ones convey oil around many times before it conducts its heat to the walls: a vortex 1.7 mm high conducts
for 3 s. Its temperature is next to undetermined: sweeps along the oil amplify errors from turn to turn, finer
grids do so more, and films with more levels have other temperatures. Nor is oil for so long in the inlet of
gears.
"""

import numpy as np

from pyworm.solver.level import Level

CIRCULATING_PRESSURE = 0.1
"""Fraction of the largest pressure below which the most warmed or cooled oil is that of a vortex."""

UNSETTLED_CHANGE = 0.01
"""Change of temperature by one sweep over its rise above which it has not settled."""


def warmest_circulates(level: Level) -> bool:
    """Whether a film is heated, and most where it bears next to no pressure."""
    film = level.film
    if not film.heated:
        return False
    largest = np.abs(film.rise()).max(axis=-1)
    place = np.unravel_index(largest.argmax(), largest.shape)
    return bool(film.pressure[place] < CIRCULATING_PRESSURE * film.pressure.max())


def temperature_varies(level: Level) -> bool:
    """Whether the temperature of a film that is warmest where oil circulates has not settled."""
    return level.film.balance.warming > UNSETTLED_CHANGE and warmest_circulates(level)
