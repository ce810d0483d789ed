"""Shear of the slices of a roller's contact line by closed forms: of the film, and of asperities.

The film is Moes' central one at the entrainment of the instant, its stress that of the oil's flow law at the
mean pressure. Between rough surfaces asperities bear their pressure at that film, at most the mean one, and
rub with the boundary friction, as in the estimate of a mesh (`pyworm.ratings.mesh_estimate`).
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import pi, prod
from typing import Self

import numpy as np
import scipy

from pyworm.drives.roller_worm.envelope import Array
from pyworm.drives.roller_worm.motion import FilmTraction, flow_stress
from pyworm.drives.roller_worm.roller_path import LEAST_LOAD, Slices
from pyworm.io.present import present
from pyworm.materials.body import composite_roughness, reduced_modulus
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.rough_surfaces import GapCurves, rough_pair

LEAST_FILM = 1e-9
"""Film at no entrainment [m]: a few molecules."""

MAX_PRESSURE, PRESSURES = 5e9, 251
"""Highest mean pressure [Pa] of the tabulated viscosity, and number of its pressures."""

LEAST_ENTRAINMENT = 1e-12
"""Entrainment that films by closed forms have at least [m/s]; theirs is then below `LEAST_FILM`."""


@dataclass(frozen=True)
class Shear:
    """Shear between worm and roller, summed over the contact line."""

    moment: float = 0.0
    """Moment on the roller about its axis [N m], towards growing theta."""
    sliding_power: float = 0.0
    """Power that sliding loses [W]."""
    worm_power: float = 0.0
    """Power that the worm's surface gives to a roller that does not turn about its axis [W]."""
    force: float = 0.0
    """Normal load of the roller [N]."""

    def __add__(self, other: "Shear") -> "Shear":
        """That of two contact lines."""
        return Shear(
            *(sum(pair) for pair in zip(vars(self).values(), vars(other).values(), strict=True))
        )


@dataclass(frozen=True)
class SliceShear:
    """Film and asperities that shear between worm and roller."""

    traction: FilmTraction
    """The film's closed forms."""
    viscosity: Callable[[Array], Array]
    """Pressure [Pa] -> logarithm of the viscosity."""
    flow: FlowLaw
    """The oil's flow law."""
    boundary_friction: float
    """Friction coefficient of asperities [-]."""
    asperities: GapCurves | None
    """Averages of the rough surfaces over their gap; None of smooth ones."""

    @classmethod
    def between(cls, traction: FilmTraction, rough: bool = True) -> Self:
        """The shear of bodies and oil; smooth where a roughness is unknown, or left out."""
        bodies, oil = traction.bodies, traction.oil
        known = rough and composite_roughness(*bodies) is not None
        factor = prod(body.boundary_friction_factor for body in bodies)
        pressures = np.linspace(0.0, MAX_PRESSURE, PRESSURES)
        logarithms = np.log([oil.viscosity(pressure) for pressure in pressures.tolist()])
        return cls(
            traction,
            scipy.interpolate.CubicSpline(pressures, logarithms),
            present(oil.flow, "oil.shear"),
            factor * oil.boundary_friction,
            rough_pair(bodies, (0.0, 0.0)).curves() if known else None,
        )

    def film(self, slices: Slices, speed: float) -> Array:
        """Central film [m] of slices while the roller turns at a speed [rad/s]."""
        entrainment = np.maximum(np.abs(slices.entrainment(speed)), LEAST_ENTRAINMENT)
        load = np.maximum(slices.load, LEAST_LOAD)
        film = self.traction.film(load, slices.curvature, entrainment)
        return np.maximum(film, LEAST_FILM)

    def asperity_share(self, film: Array, pressure: Array) -> Array:
        """Share of the load that asperities bear [-] at a film [m] and a mean pressure [Pa]."""
        if self.asperities is None:
            return np.zeros(film.shape)
        borne = np.interp(film, self.asperities.thicknesses, self.asperities.values[0])
        return np.minimum(np.exp(borne) / pressure, 1.0)

    def at(self, slices: Slices, speed: float, factor: Array | float = 1.0) -> Shear:
        """Shear of one contact line at a speed of the roller about its axis [rad/s].

        `factor` multiplies the closed-form stress of each slice.
        """
        slices = slices.scaled(np.maximum(slices.load, LEAST_LOAD), 1.0)
        width = self._width(slices)
        pressure, film = slices.load / width, self.film(slices, speed)
        across, along = slices.sliding(speed)
        total = np.hypot(across, along)
        viscous = flow_stress(self.flow, np.exp(self.viscosity(pressure)), pressure, total / film)
        share = self.asperity_share(film, pressure)
        stress = (1 - share) * viscous + share * self.boundary_friction * pressure
        force = factor * stress * width * slices.length
        unit = np.divide(force, total, out=np.zeros_like(total), where=total > 0)
        around = across * slices.round_across + along * slices.round_along
        given = across * slices.rel_across + along * slices.rel_along
        return Shear(
            moment=float(np.sum(unit * around * slices.radius)),
            sliding_power=float(np.sum(force * total)),
            worm_power=float(np.sum(unit * given)),
            force=slices.force,
        )

    def _width(self, slices: Slices) -> Array:
        """Hertz's width [m]."""
        modulus = reduced_modulus(*self.traction.bodies)
        return 2 * np.sqrt(8 * slices.load / (pi * modulus * slices.curvature))
