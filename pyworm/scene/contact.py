"""Base of point and line scenes: the data of one lubricated contact."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from math import hypot, inf, isfinite, prod
from typing import TYPE_CHECKING, Any

import numpy as np

from pyworm.formulas.arrays import Array, Flags
from pyworm.formulas.layered_half_space import Layer
from pyworm.formulas.ranges import positive
from pyworm.io import units
from pyworm.io.given import Given, in_si, kind_of, number, quantities, row, take
from pyworm.io.shown import Shown
from pyworm.materials.body import Body, composite_roughness, reduced_modulus
from pyworm.materials.oil import Oil, require_kinds, require_oil
from pyworm.materials.rough_surfaces import rough_pair
from pyworm.scene.coated import coated_modulus, compliance
from pyworm.scene.life import Past
from pyworm.scene.oil_arrival import arriving, bulk_temperature

if TYPE_CHECKING:
    from pyworm.materials.roughness_assumptions import RoughSurfaces

RADIUS_TOLERANCE = 0.01
"""Largest relative difference between the radii of a contact and those of its gap."""

MIN_ENTRAINMENT = 1e-30
"""Entrainment [m/s] that has no direction."""

FROM_GAP: Any = None
"""Radii of a contact that are not given: it takes those of its gap when it is made."""


@dataclass(frozen=True, kw_only=True, repr=False)
class Contact(Shown, ABC):
    """One lubricated contact at one instant; ValueError for oil or bodies unknown to the kernel."""

    name: str = "contact"
    """Name in tables and pictures."""
    gap: Callable[..., tuple[Array, Flags]]
    """Undeformed gap, and where both surfaces exist."""
    load: float
    """Normal load [N], of a line contact that for each length [N/m]."""
    bodies: tuple[Body, Body]
    """Body 1 and body 2; where the oil has heat, as warm as it is at the inlet unless they say otherwise."""
    oil: Oil
    """The oil at its inlet temperature: the mean of the bodies' where it has heat, whatever it was before it
    met them (`pyworm.scene.oil_arrival`)."""
    phase: float | None = None
    """Place in the mesh cycle, 0 to 1; None outside a drive."""
    slide_roll_ratio: float | None = None
    """Place on a traction curve: sliding over entrainment [-]; None outside one."""
    section: str | None = None
    """Section of a worm that has two; None elsewhere."""
    station: float | None = None
    """Place along the contact line, 0 to 1; None elsewhere."""
    separation: float | None = None
    """Distance of the undeformed surfaces at the contact point that is given instead of the load, which is
    then that of the scales alone [m]; of a contact in its past. None where the load is given."""
    past: Past[Any] | None = None
    """Its present in its life, as the drive turns; None where nothing changes."""
    rigid: bool = False
    """Whether the bodies are rigid under the film."""
    smooth: bool = False
    """Whether roughness is left out of the film."""
    travelled: tuple[tuple[float, ...], tuple[float, ...]] | None = None
    """How far each surface has moved from its place at present, along each direction [m]; None of a contact
    that is no instant of a written past."""

    def __post_init__(self) -> None:
        """Refuse what is no contact, and an oil or a body whose formulas the kernel would ignore."""
        if not isinstance(self.name, str):
            raise ValueError(f"name = {self.name!r:.40}: must be a text")
        take(self)
        if self.separation is not None:
            kind = kind_of(units.Offset)
            object.__setattr__(self, "separation", number("separation", self.separation, kind))
        if self.travelled is not None:
            kind = kind_of(units.Offset)
            ways = tuple(
                tuple(number("travelled", distance, kind) for distance in row("travelled", body))
                for body in row("travelled", self.travelled)
            )
            object.__setattr__(self, "travelled", ways)
        if not (isfinite(self.load) and self.load >= 0):
            raise ValueError(f"load = {self.load:g}: must be finite and greater than zero")
        if not callable(self.gap):
            raise ValueError(
                f"gap is a {type(self.gap).__name__}: must be a function of places, such as a Paraboloid"
            )
        require_oil(self.oil)
        if not (isinstance(self.bodies, tuple) and len(self.bodies) == 2):
            raise ValueError("bodies: must be a tuple of two, body 1 and body 2")
        for body in self.bodies:
            if not isinstance(body, Body):
                raise ValueError(
                    f"a body is a {type(body).__name__}, {body!r:.40}: must be a Body, such as "
                    'Body.from_name("16MnCr5") or Body("207 GPa", 0.3)'
                )
            require_kinds("a body", body, Body)
        if self.oil.heat is not None:
            inlet = self.oil.heat.inlet_temperature
            bodies = tuple(body.warm_at(inlet) for body in self.bodies)
            object.__setattr__(self, "bodies", bodies)
            object.__setattr__(self, "oil", arriving(self.oil, bodies))

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the contact in words."""
        origin = (np.zeros(()),) * len(self.radii_along)
        entrainment, sliding = (
            ", ".join(f"{float(part):.3g}" for part in velocity(*origin))
            for velocity in (self.entrainment_at, self.sliding_at)
        )
        moduli = ", ".join(f"{body.youngs_modulus / 1e9:.4g}" for body in self.bodies)
        return f"{type(self).__name__} {self.name}", {
            "load": f"{self.load:.4g} {quantities(type(self))['load'][0].unit}",
            "radii": ", ".join(f"{radius * 1e3:.4g}" for radius in self.radii_along) + " mm",
            "moduli": f"{moduli} GPa",
            "entrainment": f"{entrainment} m/s",
            "sliding": f"{sliding} m/s",
            "oil": f"{self.oil.viscosity.eta0:.3g} Pa s, alpha {self.oil.viscosity.alpha * 1e9:.3g} 1/GPa",
        }

    @property
    @abstractmethod
    def radii_along(self) -> tuple[float, ...]:
        """Relative radius of curvature along each direction of the contact [m]."""

    @abstractmethod
    def velocities_at(self, *places: Given) -> tuple[tuple[Array, ...], tuple[Array, ...]]:
        """Velocity [m/s] of body 1's and of body 2's surface at places [m], along each direction."""

    def entrainment_at(self, *places: Given) -> tuple[Array, ...]:
        """Mean surface velocity [m/s] at places [m], along each direction."""
        return tuple((u1 + u2) / 2 for u1, u2 in zip(*self.velocities_at(*places), strict=True))

    def sliding_at(self, *places: Given) -> tuple[Array, ...]:
        """Velocity of body 1 relative to body 2 [m/s] at places [m], along each direction."""
        return tuple(u1 - u2 for u1, u2 in zip(*self.velocities_at(*places), strict=True))

    def supply_at(self, *places: Given) -> Array:
        """Thickness of the oil that arrives at places [m], of a contact whose supply is limited."""
        u, v = (
            *(
                float(component)
                for component in self.entrainment_at(*(np.zeros(()),) * len(places))
            ),
            0.0,
        )[:2]
        x, y = (*as_arrays(*places), np.zeros(np.shape(places[0])))[:2]
        return self.oil.layer_at((u * y - v * x) / max(hypot(u, v), MIN_ENTRAINMENT))

    @property
    def bending_modulus(self) -> float:
        """Reduced modulus of the deflection under films [Pa], without coatings; infinite if rigid."""
        return inf if self.rigid else reduced_modulus(*self.bodies)

    @property
    def layers(self) -> tuple[Layer | None, Layer | None]:
        """Coating on each body where it deflects; none of rigid bodies."""
        first, second = self.bodies
        return (None, None) if self.rigid else (first.layer, second.layer)

    @property
    def reduced_modulus(self) -> float:
        """Reduced modulus E' of the two bodies [Pa]; of coated ones equivalent, for scales and formulas."""
        first, second = self.bodies
        if first.coating is None and second.coating is None:
            return reduced_modulus(first, second)
        compliances = compliance(first), compliance(second)
        layers = first.layer, second.layer
        return coated_modulus(layers, compliances, tuple(self.radii_along), self.load)

    @property
    def coldest(self) -> float:
        """Bulk temperature of the colder body above the inlet's [K]: zero or less; 0 where none is known."""
        if self.oil.heat is None:
            return 0.0
        coldest = min(bulk_temperature(body) for body in self.bodies)
        return coldest - self.oil.heat.inlet_temperature

    @property
    def composite_roughness(self) -> float | None:
        """Composite root mean square height of both surfaces [m]; None if it is not known."""
        return composite_roughness(*self.bodies)

    @property
    def boundary_friction(self) -> float:
        """Friction coefficient of the bodies' asperities in contact under the oil [-]."""
        factor = prod(body.boundary_friction_factor for body in self.bodies)
        return factor * self.oil.boundary_friction

    @property
    def rough_pair(self) -> "RoughSurfaces | None":
        """Both surfaces with their roughness; None where it is not known, or left out."""
        if self.smooth or self.composite_roughness is None:
            return None
        if any(body.topography is not None for body in self.bodies):
            from pyworm.surfaces.topography_pair import topography_pair

            return topography_pair(self.bodies, self.motion_angles)
        return rough_pair(self.bodies, self.motion_angles)

    @property
    @abstractmethod
    def motion_angles(self) -> tuple[float, float]:
        """Directions of both surfaces' velocities at the contact point, from the x axis [rad]."""


def as_arrays(*coordinates: Given) -> tuple[Array, ...]:
    """Coordinates of places [m] as arrays."""
    return tuple(
        np.asarray(in_si("xy"[axis], coordinate, units.Offset), dtype=float)
        for axis, coordinate in enumerate(coordinates)
    )


def radii_of(gap: Any, given: tuple[Any, ...] | None) -> tuple[float, ...]:
    """Radii of a contact, those of its gap if they are not given; window, far field and grids depend on them.

    ValueError if a radius differs from that of the gap, is none, or is missing where the gap has none.
    """
    of_gap = getattr(gap, "radii", None)
    if given is not None:
        return _given_radii(given, of_gap)
    if of_gap is None:
        raise ValueError(
            f"radii are missing: a gap that is a {type(gap).__name__} has none of its own; give the relative "
            "radii of curvature at the contact point [m]"
        )
    return tuple(of_gap)


def _given_radii(given: tuple[Any, ...], of_gap: tuple[float, ...] | None) -> tuple[float, ...]:
    """Radii that are given, as numbers; ValueError where they contradict those of the gap."""
    kind = kind_of(units.Radius)
    radii = tuple(number("radii", radius, kind) for radius in row("radii", given))
    positive("radii", radii, "m")
    if of_gap is None:
        return radii
    if len(radii) != len(of_gap) or any(
        abs(given - gap_radius) > RADIUS_TOLERANCE * gap_radius
        for given, gap_radius in zip(radii, of_gap, strict=True)
    ):
        theirs, its = (
            ", ".join(f"{radius:g}" for radius in radii_of_one) for radii_of_one in (radii, of_gap)
        )
        key = "radii" if len(radii) > 1 else "radius"
        raise ValueError(
            f"radii {theirs} m contradict the gap, whose radii are {its} m; leave them out, and where "
            f"dataclasses.replace changes the gap, give {key}=None with it"
        )
    return radii
