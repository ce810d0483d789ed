"""The solids in contact: elastic and thermal constants."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Self

from pyworm.formulas import wear_distress
from pyworm.formulas.layered_half_space import Layer
from pyworm.formulas.ranges import positive, scalar
from pyworm.io import units
from pyworm.io.given import WithUnit, in_si, take, text
from pyworm.io.plain_values import AboveZeroToOne
from pyworm.io.present import present
from pyworm.io.shown import ShownFields
from pyworm.materials import solids
from pyworm.materials.coating import Coating
from pyworm.materials.fatigue_strength import FatigueStrength
from pyworm.materials.long_waves import LongWaves
from pyworm.materials.roughness import ASPERITY_DENSITY, RUN_IN_SLOPE, Roughness
from pyworm.materials.softening import Points, modulus_at, points
from pyworm.materials.topography import Topography


@dataclass(frozen=True)
class SolidConstants:
    """Constants of a solid and its surface."""

    modulus_by_temperature: Points = field(default=(), kw_only=True)
    """Temperatures [K] and Young's moduli there [Pa] of a solid that softens; empty of one that does not."""
    youngs_modulus: units.Modulus
    """Young's modulus [Pa]; with `modulus_by_temperature` and a bulk temperature that of the latter."""
    poisson_ratio: float
    """Poisson's ratio [-]."""
    density: units.MassDensity | None = None
    """Density [kg/m3]; needed only where heat is simulated."""
    conductivity: units.Conductivity | None = None
    """Thermal conductivity [W/(m K)]; needed only where heat is simulated."""
    specific_heat: units.SpecificHeat | None = None
    """Specific heat [J/(kg K)]; needed only where heat is simulated."""
    bulk_temperature: units.Temperature | None = None
    """Temperature far below the surface and of the surface before the contact [K]; needed with heat."""
    roughness: units.Roughness | None = None
    """Root mean square height of the surface, Rq [m]; None if it is not known. Drawings often give the
    arithmetic mean Ra, from which it is about 1.25 Ra where heights are spread normally."""
    asperity_sharpness: AboveZeroToOne | None = field(default=None, kw_only=True)
    """Composite roughness over the radius of all asperities [-]; None if rough on all scales."""
    hardness: units.Hardness | None = field(default=None, kw_only=True)
    """Indentation hardness [Pa], which asperities bear at most; None of a surface that does not yield."""
    temperature_limit: units.MaterialTemperature | None = field(default=None, kw_only=True)
    """Temperature that it bears in continuous use [K]; None where it is not known."""
    thermal_expansion: units.ThermalExpansion | None = field(default=None, kw_only=True)
    """Linear thermal expansion [1/K]; needed only for thermal stress."""


@dataclass(frozen=True, repr=False)
class Body(ShownFields, SolidConstants):
    """One of the two solids.

    Raises:
        ValueError: A constant that no solid has.
    """

    roughness_slope: float = RUN_IN_SLOPE
    """Root mean square slope of the surface [-]."""
    roughness_aspect: float = 1.0
    """Correlation length of the roughness along its lay over that across it [-]; 1 where it has no lay."""
    lay: units.Tilt = 0.0
    """Angle of the lay from the surface's own motion through the contact [rad]."""
    asperity_density: float = ASPERITY_DENSITY
    """Such asperities for each area times radius times composite roughness [-]."""
    boundary_friction_factor: float = 1.0
    """Boundary friction of its asperities over that of steel or tin bronze under the same oil [-]."""
    topography: Topography | None = None
    """Heights of the surface, in place of averages by the figures above; None where they are not known."""
    long_waves: LongWaves | None = None
    """Its waves longer than those of the roughness; None where they are not known."""
    coating: Coating | None = field(default=None, kw_only=True)
    """Elastic layer on its surface; None of a bare one."""
    fatigue: FatigueStrength | None = field(default=None, kw_only=True)
    """What it endures; None of a body whose fatigue is not rated."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI
        # fmt: off
        def __init__(
            self, youngs_modulus: WithUnit, poisson_ratio: float, density: WithUnit | None = ...,
            conductivity: WithUnit | None = ..., specific_heat: WithUnit | None = ...,
            bulk_temperature: WithUnit | None = ..., roughness: WithUnit | Roughness | None = ...,
            roughness_slope: float = ..., roughness_aspect: float = ..., lay: WithUnit = ...,
            asperity_density: float = ..., boundary_friction_factor: float = ...,
            topography: Topography | None = ..., long_waves: LongWaves | None = ..., *,
            modulus_by_temperature: Sequence[Sequence[WithUnit]] = ...,
            asperity_sharpness: float | None = ..., hardness: WithUnit | None = ...,
            temperature_limit: WithUnit | None = ..., thermal_expansion: WithUnit | None = ...,
            coating: Coating | None = ..., fatigue: FatigueStrength | None = ...
        ) -> None: ...
        # fmt: on

    def __post_init__(self) -> None:
        """Read quantities with units; refuse impossible constants of a solid."""
        if isinstance(self.roughness, Roughness):
            for name, value in self.roughness.of_body.items():
                object.__setattr__(self, name, value)
        take(self)
        self._soften()
        positive("youngs_modulus", self.youngs_modulus, "Pa")
        if not -1 < scalar("poisson_ratio", self.poisson_ratio) <= 0.5:
            raise ValueError(
                f"poisson_ratio = {self.poisson_ratio:g}: must lie above -1 and be at most 0.5, such as 0.3"
            )
        for name, unit in _POSITIVE.items():
            if getattr(self, name) is not None:
                positive(name, getattr(self, name), unit)

    def _soften(self) -> None:
        """Read the modulus over temperature, and take its value at the bulk temperature."""
        given = points("modulus_by_temperature", self.modulus_by_temperature)
        object.__setattr__(self, "modulus_by_temperature", given)
        if given and self.bulk_temperature is not None:
            object.__setattr__(self, "youngs_modulus", modulus_at(given, self.bulk_temperature))

    @classmethod
    def from_name(
        cls,
        material: str,
        roughness: WithUnit | Roughness | None = None,
        bulk_temperature: WithUnit | None = None,
    ) -> Self:
        """A solid of the list of materials (`pyworm/materials/solids.toml`).

        Args:
            material: Such as "16MnCr5" or "CuSn12Ni2-C-GZ".
            roughness: Root mean square height of its surface [m], or its `Roughness`; smooth where it is not
                given.
            bulk_temperature: Temperature far below the surface [K]; that of the oil's inlet where it is not
                given.

        Raises:
            ValueError: No such material, or a value that there is not.
        """
        try:
            name = solids.named_material(text("material", material))
        except ValueError as error:
            raise ValueError(f'material "{material}": {error}') from None
        constants: dict[str, Any] = {**solids.constants(name)}
        constants |= {"roughness": roughness, "bulk_temperature": bulk_temperature}
        return cls(**constants)

    @property
    def layer(self) -> Layer | None:
        """The coating on the body; None of a bare one."""
        if self.coating is None:
            return None
        moduli = self.coating.youngs_modulus, self.youngs_modulus
        return Layer(
            self.coating.thickness, moduli, (self.coating.poisson_ratio, self.poisson_ratio)
        )

    @property
    def heat_capacity(self) -> float:
        """Heat capacity for each volume [J/(m3 K)]; ValueError of a solid without thermal constants."""
        return present(self.density, "density") * present(self.specific_heat, "specific_heat")

    @property
    def thermal_inertia(self) -> float:
        """Square of the thermal effusivity, k rho c [J2/(m4 K2 s)]; ValueError likewise."""
        conductivity = present(self.conductivity, "conductivity")
        density = present(self.density, "density")
        return conductivity * density * present(self.specific_heat, "specific_heat")

    @property
    def diffusivity(self) -> float:
        """Thermal diffusivity [m2/s]; ValueError likewise."""
        return present(self.conductivity, "conductivity") / self.heat_capacity

    def warm_at(self, inlet: WithUnit) -> "Body":
        """The solid under oil that enters at a temperature [K]: as warm where it has none of its own."""
        inlet = in_si("inlet", inlet, units.Temperature)
        return replace(self, bulk_temperature=inlet) if self.bulk_temperature is None else self


_POSITIVE = {
    "density": "kg/m3",
    "conductivity": "W/(m K)",
    "specific_heat": "J/(kg K)",
    "bulk_temperature": "K",
    "temperature_limit": "K",
    "thermal_expansion": "1/K",
    "roughness": "m",
    "roughness_slope": "",
    "roughness_aspect": "",
    "asperity_sharpness": "",
    "asperity_density": "",
    "hardness": "Pa",
    "boundary_friction_factor": "",
}


def reduced_modulus(body_1: Body, body_2: Body) -> float:
    """Reduced modulus E' [Pa], 2/E' = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 (Dowson and Higginson)."""
    compliance = sum((1 - body.poisson_ratio**2) / body.youngs_modulus for body in (body_1, body_2))
    return 2 / compliance


def composite_roughness(body_1: Body, body_2: Body) -> float | None:
    """Root mean square of both surfaces' heights [m]; None if not known, ValueError if none."""
    if body_1.roughness is None or body_2.roughness is None:
        return None
    return wear_distress.composite_roughness(body_1.roughness, body_2.roughness)
