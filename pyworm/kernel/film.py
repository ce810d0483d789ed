"""Base of the kernel's films of point and line contacts on one grid."""

import weakref
from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from pyworm.formulas.arrays import Array, Flags
from pyworm.kernel import core
from pyworm.kernel.core import check_status, fortran_array
from pyworm.kernel.interpolation import at_levels
from pyworm.kernel.numbers import flow_numbers, oil_numbers
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil
from pyworm.materials.rough_surfaces import GapCurves
from pyworm.materials.tabulated import Tabulated


@dataclass(frozen=True)
class Balance:
    """Residuals of a film's equations."""

    residual: float
    """Summed Reynolds residual over the summed wedge flow."""
    load_error: float
    """Missing load over the load."""
    warming: float = 0.0
    """Last change of the film's temperature over its largest rise; infinite before the first."""

    @property
    def worst(self) -> float:
        """The largest of the residuals; infinite if one is NaN."""
        parts = (self.residual, abs(self.load_error), self.warming)
        return max(parts) if all(np.isfinite(part) for part in parts) else np.inf

    def within(self, tolerance: float, warming: float | None = None) -> bool:
        """Whether all residuals are within a tolerance, warming within its own if given."""
        if warming is None:
            return self.worst <= tolerance
        return self.warming <= warming and replace(self, warming=0.0).worst <= tolerance


@dataclass(frozen=True)
class Step:
    """One Newton step."""

    balance: Balance
    """Residuals after the step."""
    krylov: int
    """GMRES iterations."""
    damping: float
    """Damping factor: the fraction of the full Newton step taken [-]."""


@dataclass(frozen=True)
class Shear:
    """Shear of a film at the nodes."""

    stress: tuple[Array, ...]
    """Shear stress in mid-film along each direction, along body 2's velocity relative to body 1 [Pa]."""
    friction: Array
    """Heat of shearing [W/m2]."""
    rate: Array
    """Largest shear rate across the film [1/s]."""


@dataclass(frozen=True)
class ShearFields(Shear):
    """Shear of a film with its flow factors and slip."""

    along: Array
    """Flow factor D of Sharif et al. (2001), equations 13a and 14a [m3/(Pa s)]."""
    across: Array
    """Flow factor C of Sharif et al. (2001), equations 13a and 14a [m3/(Pa s)]."""
    slip: Array
    """Where the film slips: 1 at body 1, 2 at body 2, 3 at both."""


@dataclass(frozen=True)
class HeatFields:
    """Heat flows of a film at the nodes at its last sweep of heat."""

    flux: Array
    """Heat flux into each body [W/m2], body along the last axis."""
    carried: Array
    """Heat convected or stored by the oil, less that of its compression [W/m2]."""


@dataclass(frozen=True)
class HeatStorage:
    """Rates of change of a film's oil at the nodes."""

    warming: Array
    """That of its temperature, at the levels along the last axis [K/s]."""
    pressing: Array
    """That of its pressure [Pa/s]."""


SLIP_STEP = 1e-3
"""Stress in which the slip of a wall grows e-fold, over that at slip [-] (`fortran/oil/flow_laws.f90`)."""


@dataclass(frozen=True)
class Asperities:
    """What asperities of rough surfaces bear at the nodes."""

    pressure: Array
    """Pressure that they bear, a part of the total [Pa]."""
    curve: Array
    """Pressure of their curve at the present gap [Pa], another one until the film is solved."""
    area: Array
    """Real area of contact over the nominal one [-]."""


WEIGHED = ("pressure", "film", "asperities", "stress_x", "stress_y", "heat")
"""Fields that figures of an adjoint weigh, in the kernel's order (`fortran/film/figure_adjoint.f90`)."""


@dataclass(frozen=True)
class Adjoints:
    """Adjoint solutions of a film for some figures, figure along the last axis of fields."""

    rows: Array
    """Weight of each node's equation: of its net outflow [1/(m/s)] where `active`; elsewhere, between rough
    surfaces, of the total pressure less the asperities' [1/Pa]."""
    heat_rows: Array
    """Weight of the equations of the temperature at the levels, along the axis before the last: of a wall's
    balance [1/K], between the walls of the heat that a level lacks [1/(W/m2)]; zero without heat."""
    by_gap: Array
    """Whole change of each figure by the undeformed gap at each node [1/m]."""
    by_load: Array
    """Change of each figure by the load on the grid [1/N], of a line for each length [m/N]; what the figure
    itself has of the load is left out."""
    active: Flags
    """Where the oil's flow is balanced."""
    iterations: Array
    """GMRES iterations for each figure."""
    reduction: Array
    """Preconditioned residual of each over that of no solution [-]."""


LEAST_RISE = 10.0
"""Least reference of relative changes of temperature [K]."""


class Film(ABC):
    """A film on one grid, by the kernel's handle and its status; KernelError if it was not made."""

    def __init__(self, handles: tuple[int, int], shape: tuple[int, ...]):
        self._handle, status = handles
        check_status(status)
        self._shape = shape
        self._nodes = (*shape, 1)[:2]
        self.levels = 0
        self.heated = False
        self.rough = False
        self.fed = False
        self.boundary_friction = 0.0
        self._swept = True
        self._warming = 0.0
        weakref.finalize(self, core.bindings.film_free, self._handle)

    def _tabulate(self, oil: Oil) -> None:
        """Give the kernel the tables of an oil that has some, before the film is first evaluated."""
        for number, law in ((1, oil.viscosity), (2, oil.density)):
            if isinstance(law, Tabulated):
                table = law.kernel_table
                scales = table.per_pressure, table.per_rise, table.first_rise
                core.bindings.film_tabulate(
                    self._handle, number, table.coefficient, table.cold, *scales
                )

    def _on_nodes(self, field: npt.ArrayLike) -> Array:
        """A field in the kernel's shape, with a second direction of one node for a line contact; no copy."""
        field = fortran_array(field)
        return field[:, np.newaxis] if len(self._shape) == 1 else field

    def _on_grid(self, field: Array) -> Array:
        """A field of the kernel in the shape of the grid; no copy."""
        return field[:, 0] if len(self._shape) == 1 else field

    def place(self, pressure: npt.ArrayLike, rigid_film: float) -> None:
        """Set pressure [Pa] and rigid film h0 [m]; the film must be started before a step."""
        self.pressure = fortran_array(pressure).copy(order="F")
        self.rigid_film = rigid_film
        core.bindings.film_place(self._handle, self._on_nodes(self.pressure), rigid_film)

    def start(
        self, pressure: npt.ArrayLike, rigid_film: float, oil: Array | None = None
    ) -> Balance:
        """Start from a pressure [Pa] and a rigid film h0 [m]; pressure on the outline stays fixed.

        Between rough surfaces `oil` is the part that the oil bears, zero where it has ruptured. Errors of a
        pressure that was interpolated may exceed it: then the total is the oil's with that of the
        asperities at the film.
        """
        if not self.rough or oil is None:
            return self._evaluate(fortran_array(pressure).copy(order="F"), rigid_film)
        ruptured = np.asfortranarray(np.asarray(oil) <= 0, dtype=np.int32)
        core.bindings.film_set_ruptured(self._handle, ruptured.reshape(self._nodes, order="F"))
        total = fortran_array(pressure).copy(order="F")
        core.bindings.film_place(self._handle, self._on_nodes(total), rigid_film)
        inner = tuple(slice(1, -1) for _ in self._shape)
        total[inner] = np.where(
            total[inner] > 0, oil[inner] + self.asperities().curve[inner], total[inner]
        )
        return self._evaluate(total, rigid_film)

    def _evaluate(self, pressure: Array, rigid_film: float) -> Balance:
        self.pressure = pressure
        self.rigid_film = rigid_film
        residual, load_error = core.bindings.film_evaluate(
            self._handle, self._on_nodes(self.pressure), rigid_film
        )
        self.balance = Balance(residual, load_error, self._warming)
        return self.balance

    def restart(self) -> Balance:
        """Restart from the present pressure and rigid film after a change of the equations."""
        return self._evaluate(self.pressure, self.rigid_film)

    def oil_pressure(self) -> Array:
        """Pressure that the oil bears [Pa]."""
        return self.pressure - self.asperities().pressure if self.rough else self.pressure

    def evaluate_at(self, other: "Film") -> Balance:
        """Evaluate at the state of another film with the same nodes, gap and moduli, ruptured where it is.

        Pressure on the outline is the other film's, too.
        """
        self.pressure, self.rigid_film = other.pressure.copy(order="F"), other.rigid_film
        residual, load_error = core.bindings.film_evaluate_at(
            self._handle, other._handle, other.rigid_film
        )
        self.balance = Balance(residual, load_error, self._warming)
        return self.balance

    def adjoints(
        self, weights: Array, rise_weights: Array, tolerance: float, most: int
    ) -> Adjoints:
        """Solve the adjoint of the film, evaluated at its solution, for figures by their weights of fields.

        `weights` (nodes, `WEIGHED`, figures) are those of sums over the nodes, `rise_weights` (nodes, levels,
        figures) of the rise at the levels; linear systems are solved to `tolerance` times their first
        residual, or within `most` iterations. KernelError if the film is filled in part, stresses are
        weighed without a flow law, or memory does not suffice.
        """
        fields, rises = (
            np.asfortranarray(given).reshape((*self._nodes, *given.shape[-2:]), order="F")
            for given in (weights, rise_weights)
        )
        rows, heat_rows, by_gap, by_load, active, iterations, reduction, status = (
            core.bindings.film_adjoints(self._handle, fields, rises, tolerance, most)
        )
        check_status(status)
        return Adjoints(
            self._on_grid(rows),
            self._on_grid(heat_rows),
            self._on_grid(by_gap),
            by_load,
            self._on_grid(active) > 0,
            iterations,
            reduction,
        )

    def heat_change(self, other: "Film") -> Array:
        """Change of what the equations of the temperature miss, from another film in the same state.

        At the levels along the last axis: of the walls' balance [K], between them the heat that a level lacks
        [W/m2]; with the conduction of the other's bodies. KernelError of a film filled in part, and of one
        that remembers heat.
        """
        change, status = core.bindings.film_heat_change(
            self._handle, other._handle, *self._nodes, self.levels
        )
        check_status(status)
        return self._on_grid(change)

    def spread_change(self, other: "Film") -> Array:
        """As `heat_change` by the conduction of the bodies alone.

        It is rounded to single precision of the bodies' rise.
        """
        change, status = core.bindings.film_spread_change(
            self._handle, other._handle, *self._nodes, self.levels
        )
        check_status(status)
        return self._on_grid(change)

    def take_oil(self, oil: Oil) -> None:
        """Set the oil; flow law, roughness and heat must be set anew, and the film evaluated."""
        core.bindings.film_set_oil(self._handle, *oil_numbers(oil))
        self._tabulate(oil)

    @abstractmethod
    def entrain(self, entrainment: Sequence[npt.ArrayLike]) -> None:
        """Set the nodal entrainment along each direction [m/s]; the film must be restarted before a step."""

    def set_transient_term(self, implicit: float, explicit: npt.ArrayLike) -> None:
        """Set d(rho h)/dt of the Reynolds equation; the film must be restarted before a step.

        `implicit` is the coefficient of rho h at present [1/s], `explicit` the part by rho h at earlier times
        at the nodes [m/s]. KernelError if a value is not finite or the shape is not that of the grid.
        """
        check_status(core.bindings.film_transient(self._handle, implicit, self._on_nodes(explicit)))

    def hold(self) -> None:
        """Keep the rigid film as it is started, whatever load the film then carries."""
        core.bindings.film_hold(self._handle)

    def hold_rise(self) -> None:
        """Keep a heated film's temperatures as they are: its steps make no sweeps of heat."""
        core.bindings.film_hold_rise(self._handle)
        self._swept = False
        self._warming = 0.0

    def judge(self, fraction: float) -> None:
        """Judge a heated film's temperatures where the pressure exceeds this fraction of the largest [-]."""
        core.bindings.film_judge(self._handle, fraction)

    def remember(self, rise: npt.ArrayLike) -> None:
        """Set what surfaces are warmer by than in steady conduction [K]; restart before a step.

        KernelError if a value is not finite.
        """
        field = fortran_array(rise)
        of_nodes = field[:, np.newaxis] if len(self._shape) == 1 else field
        check_status(core.bindings.film_remember(self._handle, of_nodes))

    def store_heat(self, storage: HeatStorage) -> None:
        """Let a heated film's oil store heat as it warms and is pressed; restart before a step.

        Its levels may be others than the film's. KernelError if a value is not finite or memory does not
        suffice.
        """
        field = at_levels(storage.warming, self.levels)
        warming = fortran_array(field).reshape((*self._nodes, self.levels), order="F")
        pressing = self._on_nodes(storage.pressing)
        check_status(core.bindings.film_store(self._handle, warming, pressing))

    def step(self, forcing: float) -> Step:
        """Make one Newton step and, where heat is simulated, one sweep of it at the new pressure.

        The linear system is solved to `forcing` times the right-hand side. KernelError if the step fails;
        pressure and film are unchanged. If the temperature diverged, the residual is large.
        """
        rigid_film, residual, load_error, krylov, damping, change, rise, status = (
            core.bindings.film_step(
                self._handle,
                forcing,
                self._on_nodes(self.pressure),
                self.rigid_film,
                self.balance.residual,
                self.balance.load_error,
            )
        )
        self.rigid_film = rigid_film
        if self.heated and self._swept:
            self._warming = change / max(LEAST_RISE, rise)
        self.balance = Balance(residual, load_error, self._warming)
        check_status(status)
        return Step(self.balance, krylov, damping)

    def fields(self) -> tuple[Array, ...]:
        """Film [m], relative density and net outflow of each cell over its size [m/s]."""
        return tuple(
            self._on_grid(field) for field in core.bindings.film_state(self._handle, *self._nodes)
        )

    def thickness(self) -> Array:
        """Film [m]."""
        return self._on_grid(core.bindings.film_thickness(self._handle, *self._nodes))

    def work(self) -> dict[str, float]:
        """Operations since the last call, by name of a variable of the history (`io.quantities`)."""
        return {}

    def unsolved(self) -> int:
        """Number of faces and columns whose shear stress did not converge when last solved."""
        return int(core.bindings.film_unsolved(self._handle))

    def convolve(self) -> Array:
        """Deflection [m] under the present pressure: one convolution, the unit of cost."""
        return self._on_grid(
            core.bindings.film_convolve(self._handle, self._on_nodes(self.pressure))
        )

    def warm(self) -> None:
        """Make one sweep of heat at the present pressure; the film must be restarted before its next step."""
        _, status = core.bindings.film_warm(self._handle)
        check_status(status)

    def rise(self) -> Array:
        """Temperature above the inlet's [K] at the levels, from body 1 to body 2 along the last axis."""
        return self._on_grid(core.bindings.film_rise(self._handle, *self._nodes, self.levels))

    def shear(
        self,
        law: FlowLaw,
        levels: int,
        sliding: Iterable[npt.ArrayLike],
        slip_step: float = SLIP_STEP,
    ) -> None:
        """Set the flow law of the oil, at the inlet's temperature; the film must be restarted, or heated.

        `levels` across the film include walls; `sliding` is the velocity of body 1 relative to body 2 at the
        nodes along each direction [m/s]; in `slip_step` of the limiting stress the slip of a wall beyond it
        grows e-fold [-]. KernelError if memory does not suffice or a velocity is not finite.
        """
        sliding_x, sliding_y = (*sliding, np.zeros(self._shape))[:2]
        check_status(
            core.bindings.film_shear(
                self._handle,
                -self._on_nodes(sliding_x),
                -self._on_nodes(sliding_y),
                *flow_numbers(law),
                slip_step,
                levels,
            )
        )
        self.levels = levels
        self.heated = False
        self._warming = 0.0

    def roughen(self, curves: GapCurves, boundary_friction: float) -> None:
        """Make a sheared film's surfaces rough by averages over the gap; it must be restarted, or heated.

        `boundary_friction` is the coefficient of asperities in contact. KernelError if memory does not
        suffice or a curve is not finite.
        """
        values, slopes = (fortran_array(table) for table in (curves.values, curves.slopes))
        check_status(
            core.bindings.film_roughen(
                self._handle,
                curves.scale,
                curves.first,
                curves.spacing,
                values,
                slopes,
                boundary_friction,
            )
        )
        self.rough = True
        self.boundary_friction = boundary_friction

    def feed(self, supply: npt.ArrayLike) -> None:
        """Limit the oil that enters to a layer at the nodes [m]; restart the film before its next step.

        KernelError if memory does not suffice or a thickness is negative or not finite.
        """
        check_status(core.bindings.film_feed(self._handle, self._on_nodes(supply)))
        self.fed = True

    def fraction(self) -> Array:
        """Fraction of the gap that oil fills [-], as last evaluated."""
        if not self.fed:
            return np.ones(self._shape)
        return self._on_grid(core.bindings.film_fraction(self._handle, *self._nodes))

    def asperities(self) -> Asperities:
        """What asperities of rough surfaces bear, as last evaluated."""
        fields = core.bindings.film_asperities(self._handle, *self._nodes)
        return Asperities(*(self._on_grid(field) for field in fields))

    def set_rise(self, rise: npt.ArrayLike) -> None:
        """Set the rise over the inlet temperature at the levels [K]; the film must be restarted."""
        core.bindings.film_set_rise(self._handle, self._on_nodes(rise))
        self._warming = np.inf

    def _warm_from(self, rise: npt.ArrayLike | None) -> None:
        """Heat the film from a rise over the inlet temperature at the levels [K], by default zero."""
        self.heated = self._swept = True
        self._warming = np.inf
        if rise is not None:
            self.set_rise(rise)

    def shear_fields(self, factors: bool = False, counted: Flags | None = None) -> ShearFields:
        """Shear of a film with a flow law; flow factors only on request, else zero.

        At nodes that are not `counted` it may be zero, too. KernelError if memory does not suffice.
        """
        nodes = np.ones(self._nodes, dtype=np.int32, order="F")
        if counted is not None:
            nodes = np.asfortranarray(counted, dtype=np.int32).reshape(self._nodes, order="F")
        *fields, status = core.bindings.film_shear_fields(self._handle, factors, nodes)
        check_status(status)
        x, y, *others = (self._on_grid(field) for field in fields)
        return ShearFields((x, y)[: len(self._shape)], *others)

    def present_shear(self) -> Shear:
        """Shear of a film with a flow law, in its present state."""
        return self.shear_fields()

    def heat_fields(self) -> HeatFields:
        """Heat flows of a heated film at its last sweep of heat."""
        fields = core.bindings.film_heat_fields(self._handle, *self._nodes)
        return HeatFields(*(self._on_grid(field) for field in fields))

    def profile(self, node: tuple[int, ...], velocity: Sequence[Array]) -> tuple[Array, ...]:
        """Velocity [m/s] at the levels above an inner node, counted from 0, along each direction.

        `velocity` is that of body 1's surface there [m/s]. KernelError if memory does not suffice.
        """
        i, j = (*node, 0)[:2]
        u1, v1 = (*velocity, 0.0)[:2]
        *velocities, status = core.bindings.film_profile(
            self._handle, i + 1, j + 1, u1, v1, self.levels
        )
        check_status(status)
        return tuple(velocities[: len(self._shape)])
