"""The one door to the compiled kernel: arrays in Fortran order go in, status numbers become exceptions."""

import os
import weakref
from dataclasses import dataclass, replace

import numpy as np

# One thread a process unless asked otherwise, since batch work runs a process a core. This stands before the
# kernel is loaded, which counts its threads then.
os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from pyworm import _core
from pyworm.oils import Barus, FlowLaw, Oil, OilHeat

_MESSAGES = {
    1: "a size, a spacing, a load or a first guess makes no sense",
    2: "a field holds a value that is not finite",
    3: "the FFT library made no plan",
    4: "the iteration ended before its tolerance was met",
    5: "no step along the Newton direction lowers the residual",
    6: "there is not enough memory",
    7: "it was interrupted",
}

NO_SENSE = 1
NOT_FINITE = 2
NOT_CONVERGED = 4
NO_DESCENT = 5
NO_MEMORY = 6


class KernelError(RuntimeError):
    """The kernel could not do what it was asked.

    Attributes
    ----------
    status : int
        The kernel's status number (`fortran/base/status.f90`).
    """

    def __init__(self, status: int):
        super().__init__(_MESSAGES[status])
        self.status = status


def _check(status: int) -> None:
    if status:
        raise KernelError(status)


def _field(values) -> np.ndarray:
    return np.asfortranarray(values, dtype=np.float64)


def elastic_deflection(pressure, dx: float, dy: float, reduced_modulus: float) -> np.ndarray:
    """Deflection [m] of both half-spaces together under nodal pressure [Pa], shape (nx, ny)."""
    deflection, status = _core.bindings.elastic_deflection(
        _field(pressure), dx, dy, reduced_modulus
    )
    _check(status)
    return deflection


@dataclass(frozen=True)
class DryContact:
    """Frictionless contact of a gap under a load.

    Attributes
    ----------
    pressure : numpy.ndarray
        Pressure [Pa], shape (nx, ny).
    approach : float
        Rigid approach of the bodies [m].
    iterations : int
        Conjugate-gradient iterations.
    converged : bool
        Whether they met the tolerance.
    """

    pressure: np.ndarray
    approach: float
    iterations: int
    converged: bool


def dry_contact(
    gap, covered, dx: float, dy: float, reduced_modulus: float, load: float, guess, tolerance: float
) -> DryContact:
    """Dry contact of a gap [m], shape (nx, ny), from coarser grids by conjugate gradients.

    Parameters
    ----------
    gap, covered : array_like
        Undeformed gap [m] and where both bodies exist.
    dx, dy : float
        Grid spacing [m].
    reduced_modulus, load : float
        E' [Pa] and normal load [N].
    guess : array_like
        First pressure; its size does not matter, where it is positive does.
    tolerance : float
        Film left in the contact over the approach.

    Raises
    ------
    KernelError
        If the contact makes no sense to the kernel.
    """
    pressure = _field(guess).copy(order="F")
    approach, iterations, status = _core.bindings.dry_contact_solve(
        _field(gap),
        np.asfortranarray(covered, dtype=np.int32),
        dx,
        dy,
        reduced_modulus,
        load,
        tolerance,
        _MOST_DRY_ITERATIONS,
        pressure,
    )
    if status != NOT_CONVERGED:
        _check(status)
    return DryContact(pressure, approach, iterations, status != NOT_CONVERGED)


_MOST_DRY_ITERATIONS = 2000


@dataclass(frozen=True)
class Balance:
    """How far a film is from its equations.

    Attributes
    ----------
    residual : float
        Summed Reynolds residual over the summed wedge flow.
    load_error : float
        Missing load over the load.
    warming : float
        Last change of the film's temperature over its largest rise; zero where heat is not simulated,
        infinite before the first.
    """

    residual: float
    load_error: float
    warming: float = 0.0

    @property
    def worst(self) -> float:
        """The largest of them; without bound if one is no number."""
        parts = (self.residual, abs(self.load_error), self.warming)
        return max(parts) if all(np.isfinite(part) for part in parts) else np.inf

    def within(self, tolerance: float, warming: float | None = None) -> bool:
        """Whether all of them are within a tolerance, or warming within its own."""
        if warming is None:
            return self.worst <= tolerance
        return self.warming <= warming and replace(self, warming=0.0).worst <= tolerance


@dataclass(frozen=True)
class Step:
    """One Newton step.

    Attributes
    ----------
    balance : Balance
        Where the step led.
    krylov : int
        GMRES iterations.
    share : float
        Share of the full Newton step that was taken.
    """

    balance: Balance
    krylov: int
    share: float


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


LEAST_RISE = 10.0
"""Temperature [K] against which changes are measured where less heat than that is made."""

_FLOW_LAWS = {"newtonian": 0, "eyring": 1, "bair-winer": 2, "eyring-limited": 3, "carreau": 4}
"""Numbers of the laws in `fortran/oil/flow_laws.f90`."""


def _oil_numbers(oil: Oil) -> tuple:
    """The oil as the kernel takes it: law, eta0, exponent, pole pressure, d1, d2 (`viscosity_density`)."""
    law, density = oil.viscosity, oil.density
    if isinstance(law, Barus):
        return 1, law.eta0, law.alpha, 1.0, density.d1, density.d2
    return 2, law.eta0, law.z, law.p0, density.d1, density.d2


class _Film:
    """A film on one grid and its present state, held by the kernel.

    Parameters
    ----------
    made : tuple
        The kernel's handle of the film and its status.
    shape : tuple of int
        Nodes along each direction.

    Raises
    ------
    KernelError
        If the kernel made none.
    """

    def __init__(self, made: tuple[int, int], shape: tuple[int, ...]):
        self._handle, status = made
        _check(status)
        self._shape = shape
        self._nodes = (*shape, 1)[:2]
        self.levels = 0
        self.heated = False
        self._warming = 0.0
        weakref.finalize(self, _core.bindings.film_free, self._handle)

    def _on_nodes(self, field) -> np.ndarray:
        """A field as the kernel takes it, the second direction of a line contact one node long; no copy."""
        field = _field(field)
        return field[:, np.newaxis] if len(self._shape) == 1 else field

    def _on_grid(self, field: np.ndarray) -> np.ndarray:
        """A field that the kernel gave, in the shape of the grid; no copy."""
        return field[:, 0] if len(self._shape) == 1 else field

    def start(self, pressure, rigid_film: float) -> Balance:
        """Takes up a pressure [Pa] and a rigid film h0 [m]; the pressure on the outline stays as given."""
        self.pressure = _field(pressure).copy(order="F")
        self.rigid_film = rigid_film
        residual, load_error = _core.bindings.film_evaluate(
            self._handle, self._on_nodes(self.pressure), rigid_film
        )
        self.balance = Balance(residual, load_error, self._warming)
        return self.balance

    def restart(self) -> Balance:
        """Starts from the present pressure and rigid film, in which something else has changed."""
        return self.start(self.pressure, self.rigid_film)

    def store(self, renewal: float, squeeze) -> None:
        """Lets the oil that the film stores change; it is to be started before it steps.

        Parameters
        ----------
        renewal : float
            Change by what the film holds, for each rho h [1/s].
        squeeze : array_like
            Change by what else is known of it, at the nodes [m/s].

        Raises
        ------
        KernelError
            If they are not finite, or of another grid.
        """
        _check(_core.bindings.film_store(self._handle, renewal, self._on_nodes(squeeze)))

    def step(self, forcing: float) -> Step:
        """One Newton step, and where heat is simulated one sweep of it at the new pressure.

        The linear system is solved to `forcing` times the right-hand side.

        Raises
        ------
        KernelError
            If the step cannot be made; pressure and film are as they were. If the temperature left all sense
            the film counts as far from its equations.
        """
        rigid_film, residual, load_error, krylov, share, change, rise, status = (
            _core.bindings.film_step(
                self._handle,
                forcing,
                self._on_nodes(self.pressure),
                self.rigid_film,
                self.balance.residual,
                self.balance.load_error,
            )
        )
        self.rigid_film = rigid_film
        if self.heated:
            self._warming = change / max(LEAST_RISE, rise)
        self.balance = Balance(residual, load_error, self._warming)
        _check(status)
        return Step(self.balance, krylov, share)

    def fields(self) -> tuple[np.ndarray, ...]:
        """Film [m], relative density and net outflow of each cell over its size [m/s]."""
        return tuple(
            self._on_grid(field) for field in _core.bindings.film_fields(self._handle, *self._nodes)
        )

    def thickness(self) -> np.ndarray:
        """Film [m]."""
        return self._on_grid(_core.bindings.film_thickness(self._handle, *self._nodes))

    def work(self) -> dict[str, float]:
        """What was done since this was last asked, by name of a history's variable (`pyworm.variables`)."""
        return {}

    def unsolved(self) -> int:
        """Faces and columns whose shear stress was not found when they were last met."""
        return int(_core.bindings.film_unsolved(self._handle))

    def convolve(self) -> np.ndarray:
        """Deflection [m] under the present pressure: one convolution, the unit of cost."""
        return self._on_grid(
            _core.bindings.film_convolve(self._handle, self._on_nodes(self.pressure))
        )

    def warm(self) -> None:
        """One sweep of heat at the present pressure; the film is to be started before it steps."""
        _, status = _core.bindings.film_warm(self._handle)
        _check(status)

    def rise(self) -> np.ndarray:
        """Temperature above the inlet's [K] at the levels, from body 1 to body 2, the last index."""
        return self._on_grid(_core.bindings.film_rise(self._handle, *self._nodes, self.levels))

    def _shear(self, law: FlowLaw, levels: int, sliding_x, sliding_y) -> None:
        """Lets the oil flow by a law, body 1 moving over body 2 with the nodal sliding (x, y) [m/s]."""
        _check(
            _core.bindings.film_shear(
                self._handle,
                -self._on_nodes(sliding_x),
                -self._on_nodes(sliding_y),
                _FLOW_LAWS[law.law],
                law.stress or 1.0,
                law.stress_pressure,
                law.stress_temperature,
                law.limit,
                law.limit_pressure,
                law.exponent,
                levels,
            )
        )
        self.levels = levels

    def _warm_from(self, rise) -> None:
        """Begins with a rise above the inlet's temperature at the levels [K], or with none."""
        if rise is not None:
            _core.bindings.film_set_rise(self._handle, self._on_nodes(rise))
        self.heated = True
        self._warming = np.inf

    def _nodal_shear(self, factors: bool) -> list[np.ndarray]:
        """Stresses along x and y, friction, shear rate, flow factors D and C, and slip at the nodes."""
        *fields, status = _core.bindings.film_shear_fields(self._handle, factors, *self._nodes)
        _check(status)
        return [self._on_grid(field) for field in fields]

    def _heat_flux(self) -> list[np.ndarray]:
        """Heat flux into the bodies [W/m2], and what oil carries away less what compression gives it."""
        fields = _core.bindings.film_heat_fields(self._handle, *self._nodes)
        return [self._on_grid(field) for field in fields]

    def _velocities(self, i: int, j: int, u1: float, v1: float) -> tuple[np.ndarray, np.ndarray]:
        """Velocity (u, v) [m/s] at the levels above a node, counted from 0."""
        u, v, status = _core.bindings.film_profile(self._handle, i + 1, j + 1, u1, v1, self.levels)
        _check(status)
        return u, v


class PointFilm(_Film):
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
        made = _core.bindings.point_film_new(
            _field(gap),
            np.asfortranarray(covered, dtype=np.int32),
            _field(entrainment[0]),
            _field(entrainment[1]),
            dx,
            dy,
            reduced_modulus,
            *_oil_numbers(oil),
            load,
            floor,
        )
        super().__init__(made, np.shape(gap))
        self._told = self._tallies()

    def _tallies(self) -> np.ndarray:
        """Work since the film was made: counts, then processor times [s]."""
        counts, seconds = _core.bindings.film_work(self._handle)
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
        _core.bindings.point_film_entrain(self._handle, *(_field(part) for part in entrainment))

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
        self.conduction_errors, status = _core.bindings.point_film_heat(
            self._handle,
            *(_field(component) for motion in motions for component in motion),
            _heat_numbers(oil),
            _bodies_numbers(bodies, oil.heat),
            np.array(semi_axes),
        )
        _check(status)
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
        shear = _core.bindings.point_film_swept_shear(self._handle, *self._nodes)
        return HeatFields(*shear, *self._heat_flux())

    def profile(self, node: tuple[int, int], velocity) -> tuple[np.ndarray, np.ndarray]:
        """Velocity (u, v) [m/s] at the levels above a node, where body 1's surface has this `velocity`.

        Raises
        ------
        KernelError
            If memory does not suffice.
        """
        return self._velocities(*node, *velocity)


def _heat_numbers(oil: Oil) -> np.ndarray:
    """How an oil takes heat, as the kernel takes it (`bindings.f90`, point_film_heat)."""
    heat = oil.heat
    return np.array(
        [
            heat.inlet_temperature,
            heat.viscosity_exponent,
            heat.expansivity,
            heat.expansivity_decay,
            heat.conductivity,
            heat.conductivity_c1,
            heat.conductivity_c2,
            oil.density.rho0 * heat.specific_heat,
            heat.heat_capacity_k1,
            heat.heat_capacity_k2,
            heat.heat_capacity_b0,
            heat.heat_capacity_b1,
            heat.heat_capacity_b2,
        ]
    )


def _bodies_numbers(bodies, heat: OilHeat) -> np.ndarray:
    """How both bodies conduct and store heat, a column each, as the kernel takes it."""
    columns = [
        (
            body.conductivity,
            body.density * body.specific_heat,
            body.bulk_temperature - heat.inlet_temperature,
        )
        for body in bodies
    ]
    return np.array(columns).T


class LineFilm(_Film):
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
        made = _core.bindings.line_film_new(
            _field(gap),
            np.asarray(covered, dtype=np.int32),
            _field(entrainment),
            dx,
            reduced_modulus,
            *_oil_numbers(oil),
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
        _check(
            _core.bindings.line_film_heat(
                self._handle,
                np.full(self._shape, velocities[0]),
                _heat_numbers(oil),
                _bodies_numbers(bodies, oil.heat),
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


def level_positions(levels: int) -> np.ndarray:
    """Where the levels across a film are, from -1/2 at body 1 to 1/2 at body 2."""
    return _core.bindings.level_positions(levels)


def prolong(field) -> np.ndarray:
    """A field on the grid of half the spacing, by cubic interpolation."""
    return _core.bindings.prolong_cubic(_field(field))


def prolong_levels(fields) -> np.ndarray:
    """The same for fields at levels across the film, the last index."""
    return np.stack([prolong(level) for level in np.moveaxis(fields, 2, 0)], axis=2)


def compiled_with() -> tuple[str, str]:
    """The compiler of the kernel and its options: those that were given, without places of files.

    A compiler tells its target as one option for each feature; -march says the same.
    """
    compiler, options = (said.decode().strip() for said in _core.bindings.compiled_with())
    kept = [
        one
        for one in options.split()
        if one.startswith("-") and "/" not in one and not one.startswith(_NOT_GIVEN)
        if not one.startswith("-m") or one.startswith(("-march", "-mtune"))
    ]
    return compiler, " ".join(dict.fromkeys(kept))


_NOT_GIVEN = ("-I", "-J", "-o", "-c", "--param", "-fdiagnostics")
"""Beginnings of options that say nothing of the code that was made."""
