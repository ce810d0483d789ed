"""The kernel's film of a line contact."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from pyworm.formulas.layered_half_space import Layer
from pyworm.kernel import core
from pyworm.kernel.core import check_status, fortran_array
from pyworm.kernel.film import Film
from pyworm.kernel.numbers import bodies_numbers, heat_numbers, layer_numbers, oil_numbers
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil


class LineFilm(Film):
    """A line contact on one grid in its present state, owned by the kernel.

    By the gap [m] and where both surfaces exist, (n,), nodal entrainment [m/s], spacing [m], E' [Pa]
    without coatings, load for each length [N/m], oil at its inlet, a film below which the mobility is
    constant, far below any of interest [m], and the coatings' layers.

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
        layers: Sequence[Layer | None] = (),
    ):
        handles = core.bindings.line_film_new(
            fortran_array(gap),
            np.asarray(covered, dtype=np.int32),
            fortran_array(entrainment),
            dx,
            reduced_modulus,
            layer_numbers(layers),
            *oil_numbers(oil),
            load,
            floor,
        )
        super().__init__(handles, np.shape(gap))
        self._tabulate(oil)

    def entrain(self, entrainment: Sequence[npt.ArrayLike]) -> None:
        """Set the nodal entrainment [m/s] of a gap that is full; the film must be restarted before a step."""
        (along,) = entrainment
        core.bindings.line_film_entrain(self._handle, fortran_array(along))

    def heat(
        self,
        oil: Oil,
        bodies: tuple[Body, Body],
        velocities: Sequence[float],
        rise: npt.ArrayLike | None = None,
    ) -> None:
        """Add heat to a sheared film and its bodies; the film must be restarted before its next step.

        By the velocity of each body's surface [m/s], not zero, and the first temperature above the inlet's
        [K], (n, levels). KernelError if memory does not suffice or a body is at rest.
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
