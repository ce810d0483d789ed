"""Base of the levels of point and line contacts: a film on one grid."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import hypot
from typing import Any, ClassVar, Protocol

import numpy as np

from pyworm import kernel
from pyworm.formulas.arrays import Array, Flags
from pyworm.kernel.film import Shear
from pyworm.materials.flow_laws import NEWTONIAN
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.any_contact import AnyContact
from pyworm.solver import figures
from pyworm.solver.error_estimate import Peak, Reading

MIN_MOBILITY_FILM = 1e-3
"""Film over the expected central film below which the mobility is constant."""

START_PRESSURE_RATIO = 1e-6
"""Pressure that a film starts with outside its dry contact, over the largest dry pressure.

A rupture line that starts too far out is found in a few Newton steps; one that starts too near moves by one
cell a step."""

CONTACT_PRESSURE = 0.01
"""Pressure over the largest down to which friction and the film's temperature belong to the contact. Oil
farther out is sheared too, but its friction falls with the gap alone, so that the sum depends on the size of
the bodies. Where surfaces move in opposite directions its temperature is that of a recirculation that depends
on the window."""

RUBBED = ("friction_coefficient", "power_loss", "friction_boundary")
"""Figures that are sums over the contact."""

LEAST_LOAD = 1e-30
"""Load that friction is relative to where surfaces that are held apart press on nothing."""

MIN_SLIDING_SPEED = 1e-30
"""Sliding speed [m/s] that has no direction."""

MAX_GUESS_RESIDUAL = 1e-2
"""Residual or load error beyond which a film is no initial guess for a finer grid: Newton's iteration
diverged on it, as happens on a grid far too coarse for the film, and diverges from there on finer grids
too."""


class TransientTerm(Protocol):
    """d(rho h)/dt of the Reynolds equation, and heat that surfaces remember and oil stores."""

    @property
    def limited(self) -> Any:
        """Whether the rate is limited (`transient.backward_term`), anywhere or at each node."""

    def on(self, grid: Any) -> tuple[float, Array]:
        """Implicit [1/s] and explicit part [m/s] at nodes of a grid, as of `Film.set_transient_term`."""

    def remembered(self, grid: Any) -> Array | None:
        """What both surfaces are warmer by than in steady conduction [K]; None where that is not known."""

    def stored(self, grid: Any) -> kernel.HeatStorage | None:
        """Rates of change of the oil's temperature and pressure; None where they are not known."""


@dataclass(frozen=True)
class InitialGuess:
    """State of a film: the initial guess of an iteration, or its end."""

    pressure: Array
    """Pressure [Pa] at the nodes."""
    rigid_film: float
    """Rigid film [m]."""
    rise: Array | None = None
    """Temperature above the inlet's at the levels of a heated film [K], along the last axis."""
    oil: Array | None = None
    """Part of the pressure that the oil bears [Pa]."""

    def finer(self, window: Any = np.s_[...]) -> "InitialGuess":
        """Interpolate to nodes of half the spacing within a window."""
        return InitialGuess(
            np.maximum(kernel.prolong(self.pressure[window]), 0.0),
            self.rigid_film,
            None if self.rise is None else kernel.prolong_levels(self.rise[window]),
            None if self.oil is None else np.maximum(kernel.prolong(self.oil[window]), 0.0),
        )

    def beyond(self, coarser: "InitialGuess") -> "InitialGuess":
        """Extrapolate to half the spacing at second order from the coarser state (Richardson)."""
        pressure = (
            self.pressure + np.where(self.pressure > 0, self.pressure - coarser.pressure, 0.0) / 4
        )
        rise = self.rise
        if rise is not None and coarser.rise is not None:
            rise = rise + (rise - coarser.rise) / 4
        return InitialGuess(
            np.maximum(pressure, 0.0),
            self.rigid_film + (self.rigid_film - coarser.rigid_film) / 4,
            rise,
            self.oil,
        )


@dataclass(frozen=True)
class Level(ABC):
    """A film on one grid."""

    forcing: ClassVar[float]
    """Residual, over the present one, to which each Newton step solves its linear system."""

    scene: AnyContact
    """The contact."""
    grid: Any
    """The grid."""
    gap: Array
    """Undeformed gap [m] at its nodes."""
    covered: Flags
    """Where both surfaces exist."""
    film: kernel.PointFilm | kernel.LineFilm
    """The kernel's film, in its present state."""
    transient_term: TransientTerm | None
    """d(rho h)/dt; None of a steady film."""

    @abstractmethod
    def conduction_errors(self) -> dict[str, float]:
        """Relative error of figures by the approximation of the bodies' conduction."""

    def read(self) -> Reading:
        """Read the film's figures in its present state, without their `peaks`, which few readings need."""
        film, pressure = self.film.thickness(), self.film.pressure
        film_min, film_place = figures.film_minimum(self.grid, film, self.borne(), self.covered)
        pressure_max = figures.maximum(pressure, self.covered)
        return Reading(
            film_min,
            figures.value_at_origin(self.grid, film),
            pressure_max,
            film_place,
            {},
            self._sheared(self.share_of_contact()) | self._temperatures(),
        )

    def rubbed(self, nodes: Array) -> dict[str, float]:
        """Friction and loss, as far as they are known, of those nodes of the contact that are among some."""
        found = self._sheared(self.share_of_contact() * nodes)
        return {name: found[name] for name in RUBBED if name in found}

    def _sheared(self, shares: Array) -> dict[str, float]:
        """Figures of the shear of the film and of its asperities over shares of the nodes' cells."""
        return self._rough_figures(self._shear_figures(shares), shares)

    def peaks(self, reading: Reading) -> dict[str, Peak]:
        """Resolution, on the grid, of the largest values that were read in the film's present state."""
        pressure, heat = (
            {"pressure_max": (self.film.pressure, self.covered)},
            self._temperature_fields(),
        )
        return {
            name: figures.peak(field - start, counted, reading.figures[name])
            for name, (field, counted, start) in (
                *((name, (*counted_field, 0.0)) for name, counted_field in pressure.items()),
                *(
                    (name, (*counted_field, self.scene.coldest))
                    for name, counted_field in heat.items()
                ),
            )
        }

    def borne(self) -> Flags:
        """Nodes with pressure, of rough surfaces more than the trace that asperities bear far outside."""
        pressure = self.film.pressure
        return pressure > (START_PRESSURE_RATIO * pressure.max() if self.film.rough else 0.0)

    def flowing(self) -> Flags:
        """Nodes where the oil has not ruptured."""
        return self.film.oil_pressure() > 0

    def holds_all_pressure(self) -> bool:
        """Whether a film of a limited supply has no pressure next to the outline: nothing lies beyond."""
        inner = self.film.pressure[(slice(1, -1),) * self.film.pressure.ndim]
        edges = (np.take(inner, (0, -1), axis) for axis in range(inner.ndim))
        return self.film.fed and not any(edge.any() for edge in edges)

    def contact(self) -> Flags:
        """Nodes of the contact (`CONTACT_PRESSURE`), where friction and the film's temperature are read."""
        return self.covered & (self.film.pressure > CONTACT_PRESSURE * self.film.pressure.max())

    def share_of_contact(self) -> Array:
        """Share of each node's cell in the contact [-], by linear pressure: whole cells make jumps."""
        pressure = self.film.pressure
        above = pressure - CONTACT_PRESSURE * pressure.max()
        slopes = np.gradient(pressure)
        across = np.abs(slopes) if pressure.ndim == 1 else np.abs(slopes).sum(axis=0)
        half = across / 2
        crossed = self.covered & (np.abs(above) < half)
        shares = np.where(self.covered & (above > 0), 1.0, 0.0)
        shares[crossed] = 0.5 + above[crossed] / across[crossed]
        return shares

    def carried(self) -> float:
        """Load that the film carries: the scene's, or where surfaces are held apart the pressure's."""
        if self.scene.separation is None:
            return self.scene.load
        return float(self.film.pressure.sum()) * self.grid.cell

    def rigid_film_on(self, grid: Any, pressure: Array) -> float:
        """Rigid film [m] on another grid, with this film's pressure there, for the same film thickness."""
        return float(self.film.rigid_film)

    def state(self) -> InitialGuess:
        """Pressure, rigid film and temperature at present."""
        film = self.film
        rise = film.rise() if film.heated else None
        return InitialGuess(film.pressure, film.rigid_film, rise, film.oil_pressure())

    def diverged(self) -> bool:
        """Whether its film is no initial guess for a finer grid (`MAX_GUESS_RESIDUAL`)."""
        balance = self.film.balance
        return not max(balance.residual, abs(balance.load_error)) <= MAX_GUESS_RESIDUAL

    def _shear(self) -> Shear | None:
        """Shear of the oil, its stress a mean over the area; None where its flow law is not known."""
        oil = self.scene.oil
        if oil.flow is None and oil.heat is None:
            return None
        if self.film.levels:
            shear = self.film.present_shear()
            if not self.film.rough:
                return shear
            wetted = 1 - self.film.asperities().area
            return replace(shear, stress=tuple(wetted * component for component in shear.stress))
        if oil.flow != NEWTONIAN:
            return None
        pressure = self.film.pressure
        slopes = [
            np.gradient(pressure, step, axis=axis) for axis, step in enumerate(self.grid.spacing)
        ]
        return newtonian_shear(
            np.asarray(oil.viscosity(pressure)),
            self.film.thickness(),
            self.scene.sliding_at(*self.grid.mesh()),
            slopes,
        )

    def _shear_figures(self, shares: Array) -> dict[str, float]:
        shear = self._shear()
        if shear is None:
            return {}
        return {
            "friction_coefficient": self._friction(shear.stress, shares),
            "power_loss": float((shares * shear.friction).sum()) * self.grid.cell,
            "shear_rate_max": float(shear.rate[self.contact() & (shares > 0)].max(initial=0.0)),
        }

    def _friction(self, stress: Sequence[Array], shares: Array) -> float:
        """Friction coefficient of stresses [Pa] on body 1, along the sliding at the contact point."""
        force = [float((shares * component).sum()) * self.grid.cell for component in stress]
        # without any sliding friction has no direction, and no size
        origin = [np.array(0.0) for _ in force]
        sliding = [float(component) for component in self.scene.sliding_at(*origin)]
        speed = hypot(*sliding)
        friction = -float(np.dot(force, sliding)) / speed if speed > 0 else 0.0
        return friction / max(self.carried(), LEAST_LOAD)

    def _rough_figures(self, shear: dict[str, float], shares: Array) -> dict[str, float]:
        """Figures of asperities, and of the film's `shear` with theirs, over shares of the nodes' cells."""
        if not self.film.rough:
            return shear
        borne = float(self.film.asperities().pressure.sum()) * self.grid.cell
        share = {"asperity_load_fraction": borne / max(self.carried(), LEAST_LOAD)}
        if not shear:
            return share
        stress, heat = self.rubbing()
        boundary = self._friction(stress, shares)
        whole = {
            "friction_boundary": boundary,
            "friction_coefficient": shear["friction_coefficient"] + boundary,
            "power_loss": shear["power_loss"] + float((shares * heat).sum()) * self.grid.cell,
        }
        return shear | share | whole

    def rubbing(self) -> tuple[tuple[Array, ...], Array]:
        """Stress [Pa] of the asperities' friction on body 1, and its heat [W/m2]; both zero if smooth."""
        sliding = self.scene.sliding_at(*self.grid.mesh())
        speed = np.sqrt(sum(component**2 for component in sliding))
        bearing = self.film.asperities().pressure if self.film.rough else np.zeros(speed.shape)
        stress = self.film.boundary_friction * bearing
        return tuple(
            -stress * component / np.maximum(speed, MIN_SLIDING_SPEED) for component in sliding
        ), stress * speed

    def _temperature_fields(self) -> dict[str, tuple[Array, Flags | bool]]:
        """Temperatures above the inlet's [K] whose largest values are figures, and where they count.

        Those figures themselves are above the colder body's, which none is below.
        """
        if not self.film.heated:
            return {}
        rise = self.film.rise()
        fields = rise[..., 0], rise[..., -1], rise.max(axis=-1)
        return dict(
            zip(HEAT_FIGURES, zip(fields, (True, True, self.contact()), strict=True), strict=True)
        )

    def _temperatures(self) -> dict[str, float]:
        """Largest temperatures above that of the colder body [K]."""
        if not self.film.heated:
            return {}
        *surfaces, (highest, contact) = self._temperature_fields().values()
        largest = [figures.maximum(field, counted) for field, counted in surfaces]
        positions = kernel.level_positions(self.film.levels)
        across = figures.maximum_across(self.film.rise(), positions, np.asarray(contact), highest)
        coldest = self.scene.coldest
        return dict(
            zip(
                HEAT_FIGURES,
                (temperature - coldest for temperature in (*largest, across)),
                strict=True,
            )
        )


def newtonian_shear(
    viscosity: Array, film: Array, sliding: Sequence[Array], slopes: Sequence[Array]
) -> Shear:
    """Shear of Couette flow by the sliding [m/s] and Poiseuille flow by the pressure gradient [Pa/m].

    tau = eta us/h + z dp/dx, the heat eta us^2/h + h^3/(12 eta) |grad p|^2 (Hamrock 1994, chapter 7).
    """
    couette = [viscosity * speed / film for speed in sliding]
    poiseuille = sum(slope**2 for slope in slopes)
    heat = sum(stress * speed for stress, speed in zip(couette, sliding, strict=True))
    at_body_1, at_body_2 = (
        sum((c + side * film / 2 * s) ** 2 for c, s in zip(couette, slopes, strict=True))
        for side in (-1, 1)
    )
    return Shear(
        tuple(-stress for stress in couette),
        heat + film**3 / (12 * viscosity) * poiseuille,
        np.sqrt(np.maximum(at_body_1, at_body_2)) / viscosity,
    )
