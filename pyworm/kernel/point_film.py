"""The kernel's film of a point contact."""

from dataclasses import dataclass

import numpy as np

from pyworm.kernel import core
from pyworm.kernel.core import check_status, fortran_array
from pyworm.kernel.film import Film, bodies_numbers, heat_numbers, oil_numbers
from pyworm.materials.oil import FlowLaw, Oil


@dataclass(frozen=True)
class ShearFields:
    """Fields of a sheared film, each of shape (nx, ny).

    Attributes
    ----------
    stress_x, stress_y : numpy.ndarray
        Shear stress at the middle of the film, along the velocity of body 2 relative to body 1 [Pa].
    friction : numpy.ndarray
        Heat of shearing [W/m2].
    rate : numpy.ndarray
        Largest shear rate across the film [1/s].
    along, across : numpy.ndarray
        Flow factors D and C of Sharif et al. (2001), equations 13a and 14a [m3/(Pa s)].
    slip : numpy.ndarray
        Where the film slips: 1 at body 1, 2 at body 2, 3 at both.
    """

    stress_x: np.ndarray
    stress_y: np.ndarray
    friction: np.ndarray
    rate: np.ndarray
    along: np.ndarray
    across: np.ndarray
    slip: np.ndarray


@dataclass(frozen=True)
class HeatFields:
    """Fields of a heated film, each of shape (nx, ny) but `flux`.

    Attributes
    ----------
    stress_x, stress_y, friction, rate : numpy.ndarray
        As those of `ShearFields`.
    flux : numpy.ndarray
        Heat flux into both bodies [W/m2], shape (nx, ny, 2).
    carried : numpy.ndarray
        What oil carries away of the heat, less what compression gives it [W/m2].
    """

    stress_x: np.ndarray
    stress_y: np.ndarray
    friction: np.ndarray
    rate: np.ndarray
    flux: np.ndarray
    carried: np.ndarray


class PointFilm(Film):
    """A point contact on one grid and its present state, held by the kernel.

    Parameters
    ----------
    gap, covered : array_like
        Undeformed gap [m] and where both surfaces exist, shape (nx, ny).
    entrainment : tuple of array_like
        Nodal entrainment velocity (u, v) [m/s].
    dx, dy : float
        Grid spacing [m].
    reduced_modulus, load : float
        E' [Pa] and normal load [N].
    oil : Oil
        Oil at its inlet temperature.
    floor : float
        Film [m] below which the mobility falls no further, far below any film of interest.
    """

    def __init__(self, gap, covered, entrainment, dx, dy, reduced_modulus, load, oil: Oil, floor):
        made = core.bindings.point_film_new(
            fortran_array(gap),
            np.asfortranarray(covered, dtype=np.int32),
            fortran_array(entrainment[0]),
            fortran_array(entrainment[1]),
            dx,
            dy,
            reduced_modulus,
            *oil_numbers(oil),
            load,
            floor,
        )
        super().__init__(made, np.shape(gap))
        self._told = self._tallies()

    def _tallies(self) -> np.ndarray:
        """Work since the film was made: counts, then processor times [s]."""
        counts, seconds = core.bindings.film_work(self._handle)
        return np.concatenate([counts, seconds])

    def work(self) -> dict[str, float]:
        """Convolutions, preconditioner solves and processor time by part [s], since this was last asked."""
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

    def entrain(self, entrainment) -> None:
        """Changes the nodal entrainment velocity (u, v) [m/s]; the film is to be started before it steps."""
        core.bindings.point_film_entrain(
            self._handle, *(fortran_array(part) for part in entrainment)
        )

    def shear(self, law: FlowLaw, levels: int, sliding) -> None:
        """Lets the oil flow by a law; the film is to be started, or heated, before its next step.

        Parameters
        ----------
        law : FlowLaw
            The oil's law.
        levels : int
            Levels across the film, walls included.
        sliding : tuple of array_like
            Velocity (u, v) of body 1 relative to body 2 at the nodes [m/s].

        Raises
        ------
        KernelError
            If memory does not suffice or a velocity is not finite.
        """
        self._shear(law, levels, *sliding)

    def heat(self, oil: Oil, bodies, motions, semi_axes, rise=None) -> None:
        """Lets a sheared film and the bodies beside it warm; the film is to be started before its next step.

        Parameters
        ----------
        oil : Oil
            Oil that is known to take heat.
        bodies : tuple of Body
            Both bodies, with thermal constants.
        motions : tuple
            Velocity (u, v) of each body's surface at the nodes [m/s].
        semi_axes : tuple of float
            Semi-axes of the contact along x and y [m].
        rise : array_like, optional
            Temperature above the inlet's to begin with [K], shape (nx, ny, levels).

        Raises
        ------
        KernelError
            If memory does not suffice.
        """
        self.conduction_errors, status = core.bindings.point_film_heat(
            self._handle,
            *(fortran_array(component) for motion in motions for component in motion),
            heat_numbers(oil),
            bodies_numbers(bodies, oil.heat),
            np.array(semi_axes),
        )
        check_status(status)
        self._warm_from(rise)

    def shear_fields(self, factors: bool = False) -> ShearFields:
        """Fields of a sheared film, with its flow factors or with zeros in their place.

        Raises
        ------
        KernelError
            If memory does not suffice.
        """
        return ShearFields(*self._nodal_shear(factors))

    def heat_fields(self) -> HeatFields:
        """Fields of a heated film, as of its last sweep of heat."""
        shear = core.bindings.point_film_swept_shear(self._handle, *self._nodes)
        return HeatFields(*shear, *self._heat_flux())

    def profile(self, node: tuple[int, int], velocity) -> tuple[np.ndarray, np.ndarray]:
        """Velocity (u, v) [m/s] at the levels above a node, where body 1's surface has this `velocity`.

        Raises
        ------
        KernelError
            If memory does not suffice.
        """
        return self._velocities(*node, *velocity)
