"""What a case file may say: one table, one model; text with units comes in, SI comes out.

Each model answers for the values of its own table only. Whether worm, wheel and hob make a drive is the
drive's to say.
"""

from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, model_validator

from pyworm import units
from pyworm.bodies import Body
from pyworm.oils import ROELANDS_PRESSURE, Barus, Density, Oil, Roelands
from pyworm.scene import RigidMotion

Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
PositiveNumber = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0)]
Count = Annotated[int, Field(strict=True, gt=0)]
Phase = Annotated[float, Field(strict=True, ge=0, le=1)]
Text = Annotated[str, Field(min_length=1)]


class Table(BaseModel):
    """A table of a case file: no key beyond its own, nothing changed after reading."""

    model_config = ConfigDict(extra="forbid", frozen=True)


# ------------------------------------------------------------------------------------------ bodies


class BodyTable(Table):
    """`[bodies.NAME]`: one solid; the thermal constants are for when heat is simulated."""

    youngs_modulus: units.Pressure
    poisson_ratio: Annotated[float, Field(strict=True, ge=0, lt=0.5)]
    density: units.MassDensity | None = None
    conductivity: units.Conductivity | None = None
    specific_heat: units.SpecificHeat | None = None

    def body(self) -> Body:
        """The solid."""
        return Body(**dict(self))


class ToothBodies(Table):
    """`[bodies]` of a drive."""

    worm: BodyTable
    wheel: BodyTable


class ContactBodies(Table):
    """`[bodies]` of a contact written directly."""

    body_1: BodyTable
    body_2: BodyTable

    def pair(self) -> tuple[Body, Body]:
        """Body 1 and body 2."""
        return self.body_1.body(), self.body_2.body()


# --------------------------------------------------------------------------------------------- oil


class BarusTable(Table):
    """`[oil.viscosity]`, law = "barus"."""

    law: Literal["barus"]
    eta0: units.Viscosity
    alpha: units.PressureCoefficientOrZero

    def viscosity(self) -> Barus:
        """The law."""
        return Barus(self.eta0, self.alpha)


class RoelandsTable(Table):
    """`[oil.viscosity]`, law = "roelands".

    The exponent is given as `z` or by the slope `alpha`; the pole as a pressure (1.96e8 Pa in its usual
    rounding, which is what is taken if nothing is said) or as its reciprocal (5.1e-9 1/Pa).
    """

    law: Literal["roelands"]
    eta0: units.Viscosity
    z: PositiveNumber | None = None
    alpha: units.PressureCoefficient | None = None
    pole_pressure: units.Pressure | None = None
    pole_coefficient: units.PressureCoefficient | None = None

    @model_validator(mode="after")
    def _one_of_each(self):
        if (self.z is None) == (self.alpha is None):
            raise ValueError("give either z or alpha, one of the two")
        if self.pole_pressure is not None and self.pole_coefficient is not None:
            raise ValueError("give either pole_pressure or pole_coefficient, one of the two")
        return self

    def viscosity(self) -> Roelands:
        """The law."""
        if self.pole_coefficient is not None:
            pole = 1 / self.pole_coefficient
        else:
            pole = self.pole_pressure or ROELANDS_PRESSURE
        if self.z is not None:
            return Roelands(self.eta0, self.z, pole)
        return Roelands.from_alpha(self.eta0, self.alpha, pole)


class DensityTable(Table):
    """`[oil.density]` with a published set of coefficients."""

    law: Literal["dowson-higginson", "dowson-higginson-pole", "incompressible"]
    rho0: units.MassDensity

    def density(self) -> Density:
        """The law."""
        makers = {
            "dowson-higginson": Density.dowson_higginson,
            "dowson-higginson-pole": Density.dowson_higginson_pole,
            "incompressible": Density.incompressible,
        }
        return makers[self.law](self.rho0)


class GeneralDensityTable(Table):
    """`[oil.density]`, law = "general": rho0 [1 + d1 p / (1 + d2 p)] with its own coefficients."""

    law: Literal["general"]
    rho0: units.MassDensity
    d1: units.PressureCoefficientOrZero
    d2: units.PressureCoefficientOrZero

    def density(self) -> Density:
        """The law."""
        return Density(self.rho0, self.d1, self.d2)


class ThermalOilTable(Table):
    """`[oil.thermal]`: what heat and shear will need of an oil; read and kept, not simulated yet.

    The laws are those of the Appendix of Sharif et al. (2001), T0 being the inlet temperature:
    expansivity eps = expansivity * exp(-expansivity_decay p);
    conductivity k = conductivity [1 + conductivity_c1 p / (1 + conductivity_c2 p)];
    heat capacity rho c = rho0 specific_heat [1 + b0 (1 + b1 p + b2 p^2)(T - T0)] [1 + k1 p / (1 + k2 p)].
    """

    inlet_temperature: units.Temperature
    s0: PositiveNumber
    eyring_stress: units.Pressure
    limiting_stress: units.Pressure
    expansivity: units.TemperatureCoefficient
    expansivity_decay: units.PressureCoefficientOrZero
    conductivity: units.Conductivity
    conductivity_c1: units.PressureCoefficientOrZero
    conductivity_c2: units.PressureCoefficientOrZero
    specific_heat: units.SpecificHeat
    heat_capacity_b0: units.TemperatureCoefficient
    heat_capacity_b1: units.PressureCoefficientAnySign
    heat_capacity_b2: units.SquaredPressureCoefficient
    heat_capacity_k1: units.PressureCoefficientOrZero
    heat_capacity_k2: units.PressureCoefficientOrZero


class OilTable(Table):
    """`[oil]`: the oil at its inlet temperature."""

    name: Text
    viscosity: Annotated[BarusTable | RoelandsTable, Field(discriminator="law")]
    density: Annotated[DensityTable | GeneralDensityTable, Field(discriminator="law")]
    thermal: ThermalOilTable | None = None

    def oil(self) -> Oil:
        """The oil as the kernel sees it."""
        return Oil(self.viscosity.viscosity(), self.density.density())


# ------------------------------------------------------------------------------------------- drive


class _Helicoid(Table):
    """What worm and hob share: the involute helicoid between its cylinders."""

    tip_radius: units.Length
    root_radius: units.Length
    base_radius: units.Length
    axial_pitch: units.Length
    lead: units.Length
    base_lead_angle: units.Angle


class WormTable(_Helicoid):
    """`[drive.worm]`."""

    threads: Count


class WheelTable(Table):
    """`[drive.wheel]`."""

    teeth: Count
    face_width: units.Length
    tip_radius: units.Length
    throat_radius: units.Length


class HobTable(_Helicoid):
    """`[drive.hob]`: the cutter and how it was set up when it cut the wheel."""

    centre_distance: units.Length
    swivel: units.Tilt
    axial_shift: units.Offset


class ZiWormTable(Table):
    """`[drive]`, kind = "zi-worm"."""

    kind: Literal["zi-worm"]
    centre_distance: units.Length
    worm: WormTable
    wheel: WheelTable
    hob: HobTable


class OperationTable(Table):
    """`[operation]`: how the drive runs, and which phases of its mesh cycle are to be solved."""

    worm_speed: units.Speed
    load: units.Force
    phases: Annotated[tuple[Phase, ...], Field(min_length=1)]


# ----------------------------------------------------------------------------------------- contact


class PointContactTable(Table):
    """`[contact]`, kind = "point-contact": a paraboloid on a plane."""

    kind: Literal["point-contact"]
    radii: tuple[units.Length, units.Length]
    load: units.Force


class LineContactTable(Table):
    """`[contact]`, kind = "line-contact": a parabolic cylinder on a plane."""

    kind: Literal["line-contact"]
    radius: units.Length
    load: units.ForcePerLength


class GapTable(Table):
    """`[contact]`, kind = "gap": a sampled undeformed gap, its file named relative to the case file."""

    kind: Literal["gap"]
    file: Text
    load: units.Force


class MotionTable(Table):
    """`[motion]`: both surfaces' velocity (along x and y) and spin at the contact point."""

    velocity_1: tuple[units.Velocity, units.Velocity]
    velocity_2: tuple[units.Velocity, units.Velocity]
    spin_1: units.Spin = 0.0
    spin_2: units.Spin = 0.0

    def motions(self) -> tuple[RigidMotion, RigidMotion]:
        """Velocity fields of body 1 and body 2."""
        return (
            RigidMotion(*self.velocity_1, self.spin_1),
            RigidMotion(*self.velocity_2, self.spin_2),
        )


class LineMotionTable(Table):
    """`[motion]` of a line contact: both surfaces' velocity across the line at the contact point."""

    velocity_1: units.Velocity
    velocity_2: units.Velocity


# ------------------------------------------------------------------------------------------- cases


class PublishedValue(Table):
    """A number that the source prints."""

    text: str
    value: float
    unit: str


def _published(value: Any) -> PublishedValue:
    if isinstance(value, float | int) and not isinstance(value, bool):
        return PublishedValue(text=f"{value:g}", value=value, unit="")
    number, unit = units.parse_any(value)
    return PublishedValue(text=value, value=number, unit=unit)


Published = dict[str, Annotated[PublishedValue, BeforeValidator(_published)]]
"""`[published]`: free names; those that a result has too are shown beside it."""


class _CaseTable(Table):
    title: Text
    source: Text
    accuracy: units.Share = 0.01
    oil: OilTable
    published: Published = {}


class DriveCase(_CaseTable):
    """A case file about a machine that makes contacts."""

    drive: ZiWormTable
    operation: OperationTable
    bodies: ToothBodies


class _ContactCase(_CaseTable):
    bodies: ContactBodies


class PointCase(_ContactCase):
    """A case file about a point contact written directly."""

    contact: PointContactTable
    motion: MotionTable


class GapCase(_ContactCase):
    """A case file about a sampled gap."""

    contact: GapTable
    motion: MotionTable


class LineCase(_ContactCase):
    """A case file about a line contact written directly."""

    contact: LineContactTable
    motion: LineMotionTable


ContactCase = PointCase | GapCase | LineCase

CONTACT_CASES = {"point-contact": PointCase, "line-contact": LineCase, "gap": GapCase}
"""Kind of a contact written directly -> what its file may say."""


class _AnyContactTable(BaseModel):
    kind: Literal["point-contact", "line-contact", "gap"]


class AnyContactCase(BaseModel):
    """As much of a case file about one contact as tells its kind."""

    contact: _AnyContactTable
