"""The kernel's film of a line contact."""

from dataclasses import dataclass

import numpy as np

from pyworm.kernel import core
from pyworm.kernel.core import check_status, fortran_array
from pyworm.kernel.film import Film, bodies_numbers, heat_numbers, oil_numbers
from pyworm.materials.oil import FlowLaw, Oil


@dataclass(frozen=True)
class LineShearFields:
    """Fields of a sheared line contact, each of shape (n,).

    Attributes
    ----------
    stress : numpy.ndarray
        Shear stress at the middle of the film, along the velocity of body 2 relative to body 1 [Pa].
    friction : numpy.ndarray
        Heat of shearing [W/m2].
    rate : numpy.ndarray
        Largest shear rate across the film [1/s].
    factor : numpy.ndarray
        Flow factor D of Sharif et al. (2001), equation 13a [m3/(Pa s)].
    slip : numpy.ndarray
        Where the film slips: 1 at body 1, 2 at body 2, 3 at both.
    """

    stress: np.ndarray
    friction: np.ndarray
    rate: np.ndarray
    factor: np.ndarray
    slip: np.ndarray


class LineFilm(Film):
    """A line contact on one grid and its present state, held by the kernel.

    Parameters
    ----------
    gap, covered : array_like
        Undeformed gap [m] and where both surfaces exist, shape (n,).
    entrainment : array_like
        Nodal entrainment velocity [m/s].
    dx : float
        Grid spacing [m].
    reduced_modulus, load : float
        E' [Pa] and load for each length [N/m].
    oil : Oil
        Oil at its inlet temperature.
    floor : float
        Film [m] below which the mobility falls no further, far below any film of interest.

    Notes
    -----
    The rigid film counts deflection from where a line load leaves none: at the distance of the grid's length
    (`fortran/elastic/half_plane.f90`). It is the same on every grid over one interval.
    """

    def __init__(self, gap, covered, entrainment, dx, reduced_modulus, load, oil, floor):
        made = core.bindings.line_film_new(
            fortran_array(gap),
            np.asarray(covered, dtype=np.int32),
            fortran_array(entrainment),
            dx,
            reduced_modulus,
            *oil_numbers(oil),
            load,
            floor,
        )
        super().__init__(made, np.shape(gap))

    def shear(self, law: FlowLaw, levels: int, sliding) -> None:
        """Lets the oil flow by a law; the film is to be started, or heated, before its next step.

        Parameters
        ----------
        law : FlowLaw
            The oil's law.
        levels : int
            Levels across the film, walls included.
        sliding : array_like
            Velocity of body 1 relative to body 2 at the nodes [m/s].

        Raises
        ------
        KernelError
            If memory does not suffice or a velocity is not finite.
        """
        self._shear(law, levels, sliding, np.zeros(self._shape))

    def heat(self, oil: Oil, bodies, velocities, rise=None) -> None:
        """Lets a sheared film and the bodies beside it warm; the film is to be started before its next step.

        Parameters
        ----------
        oil : Oil
            Oil that is known to take heat.
        bodies : tuple of Body
            Both bodies, with thermal constants.
        velocities : tuple of float
            Velocity of each body's surface [m/s], neither of them zero.
        rise : array_like, optional
            Temperature above the inlet's to begin with [K], shape (n, levels).

        Raises
        ------
        KernelError
            If memory does not suffice or a body is at rest.
        """
        check_status(
            core.bindings.line_film_heat(
                self._handle,
                np.full(self._shape, velocities[0]),
                heat_numbers(oil),
                bodies_numbers(bodies, oil.heat),
                np.array(velocities),
            )
        )
        self._warm_from(rise)

    def shear_fields(self) -> LineShearFields:
        """Fields of a sheared film.

        Raises
        ------
        KernelError
            If memory does not suffice.
        """
        stress, _, friction, rate, factor, _, slip = self._nodal_shear(factors=True)
        return LineShearFields(stress, friction, rate, factor, slip)

    def heat_fields(self) -> list[np.ndarray]:
        """Heat flux into the bodies, shape (n, 2), and what oil carries away of the friction [W/m2]."""
        return self._heat_flux()

    def profile(self, node: int, velocity: float) -> np.ndarray:
        """Velocity [m/s] at the levels above an inner node, where body 1's surface has this `velocity`.

        Raises
        ------
        KernelError
            If memory does not suffice.
        """
        return self._velocities(node, 0, velocity, 0.0)[0]
