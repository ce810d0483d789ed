"""A film on one grid: what point and line contacts share."""

from typing import Any, ClassVar, Protocol

import numpy as np

from pyworm.kernel.line_film import LineFilm
from pyworm.kernel.point_film import PointFilm
from pyworm.solver.error_estimate import Reading

FLOOR_SHARE = 1e-3
"""Film, as a share of the expected central film, below which mobility falls no further."""

TRACE = 1e-6
"""Pressure that a film starts with outside its dry contact, over the largest dry pressure."""

CONTACT_PRESSURE = 0.01
"""Pressure over the largest down to which friction and the film's temperature count as the contact's. Oil
farther out is dragged along too, but its friction falls with the gap alone, so that its sum has no end but
the bodies'. Where opposite surfaces turn it round, its temperature is that of a recirculation that ends with
the window."""


Array = np.ndarray


class Storage(Protocol):
    """How the oil that a film stores changes."""

    def on(self, grid: Any) -> tuple[float, Array]:
        """Renewal [1/s] and squeeze [m/s] at nodes of a grid, as `kernels.PointFilm.store` takes them."""


class Rung(Protocol):
    """A film on one grid.

    Attributes
    ----------
    grid : object
        The grid, with its `shape`, its number of `nodes` and the `finer()` one of half its spacing.
    film : kernels.PointFilm or kernels.LineFilm
        The kernel's film, in its present state.
    forcing : float
        Share of the residual to which each Newton step solves its linear system.
    """

    grid: Any
    film: PointFilm | LineFilm
    forcing: ClassVar[float]

    def read(self) -> Reading:
        """The film's figures in its present state."""

    def model_errors(self) -> dict[str, float]:
        """Relative error of figures by the models that they come from, as far as it is known."""
