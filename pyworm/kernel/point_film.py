"""The kernel's film of a point contact."""

from collections.abc import Iterable, Sequence

import numpy as np
import numpy.typing as npt

from pyworm.formulas.arrays import Array
from pyworm.formulas.layered_half_space import Layer
from pyworm.kernel import core
from pyworm.kernel.core import check_status, fortran_array
from pyworm.kernel.film import Balance, Film, Shear
from pyworm.kernel.numbers import bodies_numbers, heat_numbers, layer_numbers, oil_numbers
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil


class PointFilm(Film):
    """A point contact on one grid in its present state, owned by the kernel.

    By the gap [m] and where both surfaces exist, (nx, ny), nodal entrainment (u, v) [m/s], spacing [m], E'
    [Pa] without coatings, load [N], oil at its inlet, a film below which the mobility is constant, far below
    any of interest [m], and the coatings' layers.
    """

    def __init__(
        self,
        gap: npt.ArrayLike,
        covered: npt.ArrayLike,
        entrainment: Sequence[npt.ArrayLike],
        dx: float,
        dy: float,
        reduced_modulus: float,
        load: float,
        oil: Oil,
        floor: float,
        layers: Sequence[Layer | None] = (),
    ):
        handles = core.bindings.point_film_new(
            fortran_array(gap),
            np.asfortranarray(covered, dtype=np.int32),
            fortran_array(entrainment[0]),
            fortran_array(entrainment[1]),
            dx,
            dy,
            reduced_modulus,
            layer_numbers(layers),
            *oil_numbers(oil),
            load,
            floor,
        )
        super().__init__(handles, np.shape(gap))
        self._tabulate(oil)
        self._told = self._tallies()

    def _tallies(self) -> Array:
        """Operations since the film was made: counts, then processor times [s]."""
        counts, seconds = core.bindings.film_tally(self._handle)
        return np.concatenate([counts, seconds])

    def work(self) -> dict[str, float]:
        """Convolutions, preconditioner solves and processor time by part [s] since the last call."""
        before, self._told = self._told, self._tallies()
        done = self._told - before
        convolution, flow, building, cycle, heat, whole = done[6:]
        return {
            "convolutions": int(done[0]),
            "cycles": int(done[3]),
            "convolution_seconds": convolution,
            "flow_seconds": flow,
            "cycle_seconds": building + cycle,
            "heat_seconds": heat,
            "vector_seconds": whole - convolution - flow - building - cycle - heat,
        }

    def entrain(self, entrainment: Sequence[npt.ArrayLike]) -> None:
        """Set the nodal entrainment velocity (u, v) [m/s]; the film must be restarted before a step."""
        core.bindings.point_film_entrain(
            self._handle, *(fortran_array(part) for part in entrainment)
        )

    def limit_rate(self, explicit: npt.ArrayLike) -> Balance:
        """Replace the explicit part of the transient term [m/s] of a film that was evaluated.

        Its balance follows by that change alone, and the next step goes on. KernelError if a value is not
        finite or the shape is not that of the grid.
        """
        residual, load_error, status = core.bindings.point_film_limit(
            self._handle, fortran_array(explicit)
        )
        check_status(status)
        self.balance = Balance(residual, load_error, self._warming)
        return self.balance

    def transport(self) -> None:
        """Prepare a film of smooth surfaces for time steps along the path of the oil.

        Its entrainment becomes zero; the mass that arrives is the explicit part of `set_transient_term`.
        KernelError if memory does not suffice, or of a film with a flow law, roughness or limited supply.
        """
        check_status(core.bindings.point_film_transport(self._handle))

    def set_fluidity(
        self, fluidity: npt.ArrayLike, by_pressure: npt.ArrayLike, by_film: npt.ArrayLike
    ) -> None:
        """Set the mobility over that of the oil at its inlet's temperature and at rest, at the nodes [-].

        `by_pressure` [1/Pa] and `by_film` [1/m] are the slopes of its logarithm. The film must be restarted
        before its next step. KernelError if a value is not positive and finite.
        """
        fields = (fortran_array(field) for field in (fluidity, by_pressure, by_film))
        check_status(core.bindings.point_film_fluidity(self._handle, *fields))

    def set_gap(self, gap: npt.ArrayLike) -> None:
        """Set the undeformed gap [m]; the film must be restarted before its next step."""
        core.bindings.film_set_gap(self._handle, fortran_array(gap))

    def heat(
        self,
        oil: Oil,
        bodies: tuple[Body, Body],
        motions: Iterable[Iterable[npt.ArrayLike]],
        semi_axes: Sequence[float],
        rise: npt.ArrayLike | None = None,
    ) -> None:
        """Add heat to a sheared film and its bodies; the film must be restarted before its next step.

        By the velocity (u, v) of each body's surface at the nodes [m/s], the contact's semi-axes [m], and the
        first temperature above the inlet's [K], (nx, ny, levels). KernelError if memory does not suffice.
        """
        self.conduction_errors, status = core.bindings.point_film_heat(
            self._handle,
            *(fortran_array(component) for motion in motions for component in motion),
            heat_numbers(oil),
            bodies_numbers(bodies, oil.thermal),
            np.array(semi_axes),
        )
        check_status(status)
        self._warm_from(rise)

    def present_shear(self) -> Shear:
        """Shear of a film with a flow law; of a heated film at its last sweep of heat."""
        if not self.heated:
            return self.shear_fields()
        x, y, *others = core.bindings.point_film_swept_shear(self._handle, *self._nodes)
        return Shear((x, y), *others)
