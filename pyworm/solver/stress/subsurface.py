"""Stress below the surface of a solved contact: six components at chosen depths, and its maxima."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from math import hypot, isfinite
from typing import cast

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.formulas.layered_half_space import Layer
from pyworm.formulas.stress_invariants import (
    max_shear_stress,
    principal_stresses,
    tresca,
    von_mises,
)
from pyworm.formulas.thermal_stress import ThermalSolid
from pyworm.io import units
from pyworm.io.given import WithUnit, in_si
from pyworm.io.quantities import QUANTITIES
from pyworm.io.shown import Shown
from pyworm.scene.any_contact import AnyContact
from pyworm.solver.estimate import Estimate, in_words
from pyworm.solver.solution import Solution, StressFigures
from pyworm.solver.stress.layer import CoatedBody
from pyworm.solver.stress.maximum import Measure, StressBelow
from pyworm.solver.stress.thermal import heated_body, thermal_solid
from pyworm.solver.stress.tractions import EDGE_PRESSURE, has_shear, tractions

DEFAULT_DEPTHS = 17
"""Number of depths of a field whose depths are not given."""

DEPTH_REACH = 2.0
"""Largest of them over the half-width of the contact."""


@dataclass(frozen=True)
class StressMaximum:
    """Maximum of a stress below a surface."""

    value: Estimate
    """The maximum [Pa], between the depths and nodes of the fields too."""
    depth: float
    """Its depth [m]."""
    position: tuple[float, ...]
    """Its position on the surface [m]: (x, y) along the grid, or (x,) of a line contact."""


@dataclass(frozen=True, repr=False)
class SubsurfaceStress(Shown):
    """Elastic stress below the surface of one body under pressure and shear of film and asperities.

    Fields have the shape (depth, nx, ny), of a line contact (depth, nx), whose bodies are in plane strain. z
    points into the body: at the surface sigma_zz is the pressure with a negative sign, sigma_xz the shear
    stress on the body with one.
    """

    name: str
    """The scene's name."""
    body: int
    """Number of the body."""
    poisson_ratio: float
    """Its Poisson's ratio [-]."""
    depths: Array
    """Depths of the fields [m]."""
    axes: tuple[Array, ...]
    """Positions of the nodes along each direction [m]; the part of the film's grid that bears pressure."""
    components: Array = field(compare=False)
    """sigma_xx, sigma_yy, sigma_zz, sigma_xy, sigma_xz and sigma_yz [Pa] along the first axis."""
    von_mises_max: StressMaximum
    """Maximum equivalent stress of von Mises."""
    shear_max: StressMaximum
    """Maximum shear stress, half of Tresca's equivalent stress."""

    @property
    def sigma_xx(self) -> Array:
        """Normal stress along x [Pa]."""
        return cast(Array, self.components[0])

    @property
    def sigma_yy(self) -> Array:
        """Normal stress along y [Pa]."""
        return cast(Array, self.components[1])

    @property
    def sigma_zz(self) -> Array:
        """Normal stress along the depth [Pa]."""
        return cast(Array, self.components[2])

    @property
    def sigma_xy(self) -> Array:
        """Shear stress along x and y [Pa]."""
        return cast(Array, self.components[3])

    @property
    def sigma_xz(self) -> Array:
        """Shear stress along x and the depth [Pa]."""
        return cast(Array, self.components[4])

    @property
    def sigma_yz(self) -> Array:
        """Shear stress along y and the depth [Pa]."""
        return cast(Array, self.components[5])

    @property
    def von_mises(self) -> Array:
        """Equivalent stress of von Mises [Pa]."""
        return von_mises(self.components)

    @property
    def shear(self) -> Array:
        """Maximum shear stress at each place [Pa]."""
        return max_shear_stress(self.components)

    @property
    def tresca(self) -> Array:
        """Equivalent stress of Tresca [Pa]."""
        return tresca(self.components)

    @property
    def principal(self) -> Array:
        """Principal stresses along the first axis, most tensile first [Pa]."""
        return principal_stresses(self.components)

    @property
    def von_mises_profile(self) -> Array:
        """Largest equivalent stress of von Mises over the nodes at each depth [Pa]."""
        return cast(Array, self.von_mises.reshape(len(self.depths), -1).max(axis=1))

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the maxima in words."""
        rows = {}
        for label, found in (
            (QUANTITIES["von_mises"].worst(), self.von_mises_max),
            ("maximum shear stress", self.shear_max),
        ):
            text = in_words(found.value, QUANTITIES["pressure_max"])
            rows[label] = f"{text} at a depth of {found.depth * 1e6:.4g} µm"
        return f"Stress below the surface of body {self.body}, {self.name}", rows


@dataclass(frozen=True)
class StressInputs:
    """What the stress below the surface of a body depends on besides the fields of the film."""

    poisson_ratios: tuple[float, float]
    """Poisson's ratio of each body [-]."""
    boundary_friction: float
    """Friction coefficient of asperities [-]."""
    coatings: tuple[Layer | None, Layer | None] = (None, None)
    """Layer on each body; None of a bare one."""
    heated: tuple[ThermalSolid, ThermalSolid] | None = None
    """Thermal constants of both bodies; None without thermal stress."""


def inputs_of_scene(scene: AnyContact, thermal: bool = False) -> StressInputs:
    """What the stress of a contact depends on besides the fields of its film.

    ValueError of a thermal stress of bodies without thermal constants.
    """
    first, second = scene.bodies
    heated = (thermal_solid(first, 1), thermal_solid(second, 2)) if thermal else None
    return StressInputs(
        (first.poisson_ratio, second.poisson_ratio),
        scene.boundary_friction,
        (first.layer, second.layer),
        heated,
    )


def stress_inputs(solution: Solution, thermal: bool | None = None) -> StressInputs:
    """What its stress depends on besides its fields; ValueError of a solution that does not know it.

    `thermal` is whether heat counts, by default as among its figures.
    """
    known = solution.figures.stress
    if known is not None and thermal in (None, known.heated is not None):
        return StressInputs(
            known.poisson_ratios, known.boundary_friction, known.coatings, known.heated
        )
    if solution.solved is None:
        raise ValueError(
            f"{solution.name}: read from a file without stresses; solve it with pyworm run --stress, "
            "or by pyworm.solve"
        )
    return inputs_of_scene(solution.solved[0], bool(thermal))


def subsurface_stress(
    solution: Solution,
    body: int = 1,
    depths: Sequence[WithUnit] | Array | None = None,
    thermal: bool | None = None,
) -> SubsurfaceStress:
    """Stress below the surface of body 1 or 2 of a solved contact, each an elastic half-space.

    Args:
        solution: The solved contact.
        body: Number of the body.
        depths: Depths of the fields [m]; by default from the surface to twice the half-width.
        thermal: Whether to add the thermal stress of the surface temperature; by default as among the
            solution's figures, or not.

    Raises:
        ValueError: Another body, a depth above the surface, a film that did not converge, thermal stress
            without simulated heat or thermal expansion, or a file without stresses.
    """
    below = stress_below(solution, body, stress_inputs(solution, thermal))
    if depths is None:
        chosen = np.linspace(0, DEPTH_REACH * below.half_width, DEFAULT_DEPTHS)
    else:
        chosen = np.atleast_1d(np.asarray(in_si("depths", depths, units.LengthOrZero), dtype=float))
        if not (chosen >= 0).all():
            raise ValueError("depths: must not be negative, since they are counted into the body")
    acting = below.grid(0)
    return SubsurfaceStress(
        name=solution.name,
        body=body,
        poisson_ratio=below.poisson_ratio,
        depths=chosen,
        axes=acting.axes(),
        components=below.stress(acting, chosen),
        von_mises_max=maximum_below(below, von_mises, solution),
        shear_max=maximum_below(below, max_shear_stress, solution),
    )


def stress_below(solution: Solution, body: int, inputs: StressInputs | None = None) -> StressBelow:
    """Stress below a body; ValueError of another one, or of a film that did not converge."""
    if body not in (1, 2):
        raise ValueError(f"body = {body}: must be 1 or 2")
    if not solution.converged:
        raise ValueError(f"{solution.name}: no stress, since the film did not converge")
    inputs = inputs or stress_inputs(solution)
    layer = inputs.coatings[body - 1]
    solids = inputs.heated
    return StressBelow(
        tractions(solution, body, inputs.boundary_friction),
        inputs.poisson_ratios[body - 1],
        None if layer is None else CoatedBody(layer),
        None if solids is None else heated_body(solution, body, solids[body - 1]),
    )


def with_stress(solution: Solution, inputs: StressInputs) -> Solution:
    """A converged solution with the maximum von Mises stress of both bodies among its figures."""
    first_below = stress_below(solution, 1, inputs)
    first = maximum_below(first_below, von_mises, solution)
    alike = inputs.coatings == (None, None) and inputs.heated is None
    if alike and len(set(inputs.poisson_ratios)) == 1 and not has_shear(solution):
        second = first  # the same tractions on the same half-space
    else:
        other = stress_below(solution, 2, inputs)
        bare = inputs.coatings == (None, None)
        inside = bare and other.largest_near_surface < first.value.value
        near = first.depth if alike or inside else None
        second = maximum_below(other, von_mises, solution, near)
    stress = StressFigures(
        first.value,
        second.value,
        first.depth,
        second.depth,
        inputs.poisson_ratios,
        inputs.boundary_friction,
        inputs.coatings,
        inputs.heated,
    )
    return solution.changed(figures=replace(solution.figures, stress=stress))


def maximum_below(
    below: StressBelow, measure: Measure, solution: Solution, near: float | None = None
) -> StressMaximum:
    """Maximum of a measure of the stress, with its uncertainty and that of the film's pressure.

    `near` is the depth of the maximum of the other body [m], which is not searched again.
    """
    peak = below.peak(measure, below.critical_depth if near is None else near)
    pressure = solution.figures.pressure_max.error
    film = pressure if isfinite(pressure) else solution.figures.film_central.error
    hot = solution.figures.temperature_max_body_1, solution.figures.temperature_max_body_2
    heat = hypot(*(flank.error for flank in hot if flank is not None))
    value = Estimate(
        peak.value,
        grid=hypot(peak.grid_error, film, below.heat_share(measure, peak) * heat),
        domain=EDGE_PRESSURE,
        approximation=peak.depth_error,
    )
    return StressMaximum(value, peak.depth, peak.position)
