"""The kernel's film of a line contact."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from pyworm.kernel import core
from pyworm.kernel.core import check_status, fortran_array
from pyworm.kernel.film import Film
from pyworm.kernel.numbers import bodies_numbers, heat_numbers, oil_numbers
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil


class LineFilm(Film):
    """A line contact on one grid in its present state, owned by the kernel.

    Args:
        gap, covered: Undeformed gap [m] and where both surfaces exist, shape (n,).
        entrainment: Nodal entrainment velocity [m/s].
        dx: Grid spacing [m].
        reduced_modulus, load: E' [Pa] and load for each length [N/m].
        oil: Oil at its inlet temperature.
        floor: Film [m] below which the mobility is constant, far below any film of interest.

    The datum of deflection is at a distance of the grid's length from a line load
    (`fortran/elastic/half_plane.f90`); it is the same on every grid over one interval.
    """

    def __init__(
        self,
        gap: npt.ArrayLike,
        covered: npt.ArrayLike,
        entrainment: npt.ArrayLike,
        dx: float,
        reduced_modulus: float,
        load: float,
        oil: Oil,
        floor: float,
    ):
        handles = core.bindings.line_film_new(
            fortran_array(gap),
            np.asarray(covered, dtype=np.int32),
            fortran_array(entrainment),
            dx,
            reduced_modulus,
            *oil_numbers(oil),
            load,
            floor,
        )
        super().__init__(handles, np.shape(gap))
        self._tabulate(oil)

    def heat(
        self,
        oil: Oil,
        bodies: tuple[Body, Body],
        velocities: Sequence[float],
        rise: npt.ArrayLike | None = None,
    ) -> None:
        """Add heat to a sheared film and its bodies; the film must be restarted before its next step.

        Args:
            oil: Oil with thermal properties.
            bodies: Both bodies, with thermal constants.
            velocities: Velocity of each body's surface [m/s], neither of them zero.
            rise: Initial temperature above the inlet's [K], shape (n, levels).

        Raises:
            KernelError: If memory does not suffice or a body is at rest.
        """
        check_status(
            core.bindings.line_film_heat(
                self._handle,
                np.full(self._shape, velocities[0]),
                heat_numbers(oil),
                bodies_numbers(bodies, oil.thermal),
                np.array(velocities),
            )
        )
        self._warm_from(rise)
