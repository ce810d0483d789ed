"""What a case file may say: one table, one model; text with units comes in, SI comes out.

Each model answers for the values of its own table only. Whether worm, wheel and hob make a drive is the
drive's to say.
"""

from typing import Annotated, Any, Literal

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    field_validator,
    model_validator,
)

from pyworm import units
from pyworm.bodies import Body
from pyworm.oils import (
    ROELANDS_POLE_TEMPERATURE,
    ROELANDS_PRESSURE,
    Barus,
    Density,
    FlowLaw,
    Oil,
    OilHeat,
    Roelands,
)
from pyworm.scene import RigidMotion

Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
PositiveNumber = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0)]
NumberOrZero = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0)]
Count = Annotated[int, Field(strict=True, gt=0)]
Phase = Annotated[float, Field(strict=True, ge=0, le=1)]
Text = Annotated[str, Field(min_length=1)]


class Table(BaseModel):
    """A table of a case file: no key beyond its own, nothing changed after reading."""

    model_config = ConfigDict(extra="forbid", frozen=True)


# ------------------------------------------------------------------------------------------ bodies


class BodyTable(Table):
    """`[bodies.NAME]`: one solid; the thermal constants are needed where the oil has `[oil.heat]`.

    Without a bulk temperature of its own a body is as warm as the oil at the inlet.
    """

    youngs_modulus: units.Pressure
    poisson_ratio: Annotated[float, Field(strict=True, ge=0, lt=0.5)]
    density: units.MassDensity | None = None
    conductivity: units.Conductivity | None = None
    specific_heat: units.SpecificHeat | None = None
    bulk_temperature: units.Temperature | None = None

    def body(self, oil: Oil) -> Body:
        """The solid under an oil."""
        constants = dict(self)
        if oil.heat is not None and self.bulk_temperature is None:
            constants["bulk_temperature"] = oil.heat.inlet_temperature
        return Body(**constants)


class _Bodies(Table):
    """`[bodies]`: two solids, body 1 first."""

    def pair(self, oil: Oil) -> tuple[Body, Body]:
        """Body 1 and body 2 under an oil."""
        body_1, body_2 = (getattr(self, name).body(oil) for name in type(self).model_fields)
        return body_1, body_2


class ToothBodies(_Bodies):
    """`[bodies]` of a drive."""

    worm: BodyTable
    wheel: BodyTable


class ContactBodies(_Bodies):
    """`[bodies]` of a contact written directly."""

    body_1: BodyTable
    body_2: BodyTable


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


class NewtonianTable(Table):
    """`[oil.shear]`, law = "newtonian": the stress grows with the shear rate without end."""

    law: Literal["newtonian"]


class _ThinningStress(Table):
    """The stress at which an oil begins to thin, and how it follows pressure and temperature."""

    stress: units.Stress
    stress_pressure: units.PressureCoefficientAnySign = 0.0
    stress_temperature: units.TemperatureCoefficientAnySign = 0.0


class _LimitingStress(Table):
    """The stress that an oil cannot exceed: constant, proportional to pressure, or both."""

    limit: units.StressOrZero = 0.0
    limit_pressure: NumberOrZero = 0.0

    @model_validator(mode="after")
    def _some_limit(self):
        if self.limit == self.limit_pressure == 0:
            raise ValueError('give limit, such as "100 MPa", or limit_pressure, such as 0.05')
        return self


class EyringTable(_ThinningStress):
    """`[oil.shear]`, law = "eyring"; stress is Eyring's."""

    law: Literal["eyring"]


class BairWinerTable(_LimitingStress):
    """`[oil.shear]`, law = "bair-winer"."""

    law: Literal["bair-winer"]


class LimitedEyringTable(_ThinningStress, _LimitingStress):
    """`[oil.shear]`, law = "eyring-limited"; stress is Eyring's, exponent the paper's lambda."""

    law: Literal["eyring-limited"]
    exponent: PositiveNumber = 1.0


class CarreauTable(_ThinningStress):
    """`[oil.shear]`, law = "carreau"; stress is Carreau's modulus G, exponent his n."""

    law: Literal["carreau"]
    exponent: Annotated[float, Field(strict=True, gt=0, le=1)]


ShearTable = NewtonianTable | EyringTable | BairWinerTable | LimitedEyringTable | CarreauTable
"""`[oil.shear]`: how the oil shears; the laws are those of `FlowLaw`."""


class HeatTable(Table):
    """`[oil.heat]`: how the oil takes heat; the laws are those of `OilHeat`.

    How viscosity falls with temperature is given by the exponent `s0` of Roelands' law or by its slope `beta`
    at the inlet; for Barus' law by `beta`. What is left out does not depend on pressure or temperature.
    """

    inlet_temperature: units.Temperature
    s0: PositiveNumber | None = None
    beta: units.TemperatureCoefficient | None = None
    conductivity: units.Conductivity
    specific_heat: units.SpecificHeat
    expansivity: units.TemperatureCoefficientOrZero = 0.0
    expansivity_decay: units.PressureCoefficientOrZero = 0.0
    conductivity_c1: units.PressureCoefficientOrZero = 0.0
    conductivity_c2: units.PressureCoefficientOrZero = 0.0
    heat_capacity_b0: units.TemperatureCoefficientAnySign = 0.0
    heat_capacity_b1: units.PressureCoefficientAnySign = 0.0
    heat_capacity_b2: units.SquaredPressureCoefficient = 0.0
    heat_capacity_k1: units.PressureCoefficientOrZero = 0.0
    heat_capacity_k2: units.PressureCoefficientOrZero = 0.0

    @field_validator("inlet_temperature")
    @classmethod
    def _above_the_pole(cls, kelvin: float) -> float:
        if kelvin <= ROELANDS_POLE_TEMPERATURE:
            raise ValueError('must be above -135.15 degC, the pole of viscosity, such as "60 degC"')
        return kelvin

    def heat(self, viscosity: Barus | Roelands) -> OilHeat:
        """The laws of an oil of this viscosity."""
        constants = self.model_dump(exclude={"s0", "beta"})
        if isinstance(viscosity, Barus):
            exponent = self.beta
        elif self.s0 is not None:
            exponent = self.s0
        else:
            exponent = viscosity.s0(self.beta, self.inlet_temperature)
        return OilHeat(viscosity_exponent=exponent, **constants)


class OilTable(Table):
    """`[oil]`: the oil at its inlet temperature."""

    name: Text
    viscosity: Annotated[BarusTable | RoelandsTable, Field(discriminator="law")]
    density: Annotated[DensityTable | GeneralDensityTable, Field(discriminator="law")]
    shear: Annotated[ShearTable, Field(discriminator="law")] | None = None
    heat: HeatTable | None = None

    @model_validator(mode="after")
    def _one_exponent_of_temperature(self):
        if self.heat is None:
            return self
        if self.viscosity.law == "barus" and (self.heat.beta is None or self.heat.s0 is not None):
            raise ValueError("heat needs beta, and no s0, where viscosity.law is barus")
        if (self.heat.s0 is None) == (self.heat.beta is None):
            raise ValueError("heat needs either s0 or beta, one of the two")
        return self

    def oil(self) -> Oil:
        """The oil as the kernel sees it."""
        viscosity = self.viscosity.viscosity()
        return Oil(
            viscosity=viscosity,
            density=self.density.density(),
            flow=None if self.shear is None else FlowLaw(**dict(self.shear)),
            heat=None if self.heat is None else self.heat.heat(viscosity),
        )


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
    """`[motion]`: both surfaces' velocity (along x and y) and spin at the contact point.

    Instead of both velocities their mean may be given, with the slide-roll ratios at which the contact is to
    be solved: a traction curve.
    """

    velocity_1: tuple[units.Velocity, units.Velocity] | None = None
    velocity_2: tuple[units.Velocity, units.Velocity] | None = None
    mean_velocity: tuple[units.Velocity, units.Velocity] | None = None
    slide_roll_ratios: Annotated[tuple[Number, ...], Field(min_length=1)] | None = None
    spin_1: units.Spin = 0.0
    spin_2: units.Spin = 0.0

    @field_validator("mean_velocity")
    @classmethod
    def _what_sliding_is_compared_with(cls, velocity: tuple[float, float]) -> tuple[float, float]:
        if velocity == (0, 0):
            raise ValueError("must not be zero; give velocity_1 and velocity_2 of opposite sliding")
        return velocity

    @field_validator("slide_roll_ratios")
    @classmethod
    def _each_once(cls, ratios: tuple[float, ...]) -> tuple[float, ...]:
        if len(set(ratios)) < len(ratios):
            raise ValueError("must not name a ratio twice")
        return ratios

    @model_validator(mode="after")
    def _one_of_both_forms(self):
        given = {
            name
            for name in ("velocity_1", "velocity_2", "mean_velocity", "slide_roll_ratios")
            if getattr(self, name) is not None
        }
        if given not in ({"velocity_1", "velocity_2"}, {"mean_velocity", "slide_roll_ratios"}):
            raise ValueError(
                "give either velocity_1 and velocity_2, or mean_velocity and slide_roll_ratios"
            )
        return self

    def motions(self, slide_roll_ratio: float | None = None) -> tuple[RigidMotion, RigidMotion]:
        """Velocity fields of body 1 and body 2.

        Parameters
        ----------
        slide_roll_ratio : float, optional
            Velocity of body 1 less that of body 2, over their mean [-]; where the mean velocity is given.
        """
        if slide_roll_ratio is None:
            velocities = self.velocity_1, self.velocity_2
        else:
            shares = 1 + slide_roll_ratio / 2, 1 - slide_roll_ratio / 2
            velocities = tuple(tuple(share * of for of in self.mean_velocity) for share in shares)
        spins = self.spin_1, self.spin_2
        first, second = (
            RigidMotion(*velocity, spin) for velocity, spin in zip(velocities, spins, strict=True)
        )
        return first, second


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
    """What all case files say; each kind has its own `bodies` besides."""

    title: Text
    source: Text
    accuracy: units.Share = 0.01
    oil: OilTable
    published: Published = {}

    @model_validator(mode="after")
    def _bodies_take_heat_with_the_oil(self):
        for name, body in self.bodies:
            for key in ("density", "conductivity", "specific_heat"):
                if self.oil.heat is not None and getattr(body, key) is None:
                    raise ValueError(f"bodies.{name}.{key} is missing; [oil.heat] asks for it")
            if self.oil.heat is None and body.bulk_temperature is not None:
                raise ValueError(f"bodies.{name}.bulk_temperature means nothing without [oil.heat]")
        return self


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
