"""Types of the dimensional keys of case files, each with the ranges of its values.

Inside, every number is a plain float in SI: angles in radians, speeds of rotation in rad/s, temperatures
in kelvin.
"""

from dataclasses import asdict, dataclass
from typing import Annotated, TypedDict

from pydantic import GetCoreSchemaHandler, PlainValidator, ValidationInfo
from pydantic_core import CoreSchema

from pyworm.io.quantity import SHARE_KIND, Kind, Range, parse

SI = "SI"
"""Context of validation in which values are plain numbers in SI, as a checked case leaves them."""


@dataclass(frozen=True)
class Quantity(Kind):
    """A kind of quantity as pydantic reads its values: texts with units, or SI numbers in a checked case."""

    def read(self, value: object, info: ValidationInfo) -> float:
        """The value in SI; ValueError of what is no such quantity."""
        if info.context != SI:
            return parse(value, self)  # which refuses what is no text
        if not isinstance(value, float | int):
            raise ValueError(f"must be {self.noun} as a number in SI")
        return value

    def __get_pydantic_core_schema__(
        self, source: type, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return PlainValidator(self.read).__get_pydantic_core_schema__(source, handler)


class _Sizes(TypedDict, total=False):
    """Ranges shared by kinds of one size."""

    possible: Range
    usual: Range


# fmt: off
# Of machines and their parts, from watches to mills.
_BUILT: _Sizes = {"possible": ("10 um", "20 m"), "usual": ("0.1 mm", "5 m")}
_SET: _Sizes = {"possible": ("1e-24 m", "20 m"), "usual": ("", "1 m")}
Length = Annotated[float, Quantity("a length", "m", "305 mm", **_BUILT)]
LengthOrZero = Annotated[float, Quantity("a length", "m", "20 mm", sign="not negative", **_BUILT)]
Offset = Annotated[float, Quantity("a length", "m", "-0.5 mm", "any", **_SET)]
FaceWidth = Annotated[float, Quantity(
    "a face width", "m", "60 mm", possible=("10 um", "5 m"), usual=("1 mm", "1.5 m"))]
Relief = Annotated[float, Quantity(
    "a relief", "m", "20 um", "not negative", ("1 nm", "5 mm"), usual=("0.5 um", "0.3 mm"))]
Radius = Annotated[float, Quantity(
    "a radius", "m", "10 mm", possible=("1 um", "100 km"), usual=("0.1 mm", "100 m"))]
Film = Annotated[float, Quantity(
    "a film", "m", "1 um", possible=("0.1 nm", "10 mm"), usual=("1 nm", "1 mm"))]
FilmOrZero = Annotated[float, Quantity(
    "a film", "m", "1 um", "not negative", ("0.1 nm", "10 mm"), usual=("1 nm", "1 mm"))]
"""Layer of oil, which may be missing at some places."""

Separation = Annotated[float, Quantity(
    "a separation", "m", "10 um", "not negative", ("0.1 nm", "10 mm"), usual=("10 nm", "1 mm"))]
Roughness = Annotated[float, Quantity(
    "a root mean square height", "m", "0.4 um", possible=("0.1 nm", "0.1 mm"), usual=("1 nm", "5 um"))]
"""Root mean square height Rq of a surface; 5 um is a hobbed or milled one."""

CoatingThickness = Annotated[float, Quantity(
    "a thickness of a coating", "m", "3 um", possible=("1 nm", "10 mm"), usual=("0.1 um", "1 mm"))]
DepthOrZero = Annotated[float, Quantity(
    "a depth", "m", "50 um", "not negative", ("1 nm", "1 m"), usual=("0.1 um", "20 mm"))]

Wave = Annotated[float, Quantity(
    "a length along a surface", "m", "20 um", possible=("1 nm", "100 mm"), usual=("0.1 um", "10 mm"))]
"""Length of a wave of roughness, distance of points, nesting index of a filter."""

PlaceInArea = Annotated[float, Quantity(
    "a place in a measured area", "m", "0.2 mm", "not negative", ("0.1 nm", "1 m"))]
"""Distance from the first point of a measured area."""

_TURN: _Sizes = {"possible": ("1e-24 deg", "360 deg")}
Angle = Annotated[float, Quantity("an angle", "rad", "27.5 deg", **_TURN)]
AngleOrZero = Annotated[float, Quantity("an angle", "rad", "12 deg", sign="not negative", **_TURN)]
Tilt = Annotated[float, Quantity("an angle", "rad", "-0.4 deg", "any", **_TURN)]

_TWIST: _Sizes = {
    "possible": ("1e-9 N m", "1e9 N m"),
    "usual": ("1 N mm", "100 kN m"),
}
Torque = Annotated[float, Quantity("a torque", "N m", "30 N m", **_TWIST)]
TorqueOrZero = Annotated[float, Quantity("a torque", "N m", "30 N m", "not negative", **_TWIST)]
Stiffness = Annotated[float, Quantity(
    "a stiffness", "N/m", "200 N/um", possible=("1e-6 N/um", "1e9 N/um"), usual=("0.1 N/um", "1e5 N/um"))]
Force = Annotated[float, Quantity(
    "a force", "N", "14 kN", possible=("1e-12 N", "1e12 N"), usual=("0.01 N", "10 MN"))]
ForcePerLength = Annotated[float, Quantity(
    "a force per length", "N/m", "100 kN/m", possible=("1e-3 N/m", "1e6 kN/m"),
    usual=("10 N/m", "5000 kN/m"))]
_DRIVEN: _Sizes = {"possible": ("1e-12 W", "1e12 W"), "usual": ("0.01 W", "100 MW")}
Power = Annotated[float, Quantity("a power", "W", "250 kW", **_DRIVEN)]
PowerOrZero = Annotated[float, Quantity("a power", "W", "400 W", "not negative", **_DRIVEN)]

_ROTATED: _Sizes = {"possible": ("1e-9 rpm", "1e7 rpm"), "usual": ("0.01 rpm", "1e5 rpm")}
Speed = Annotated[float, Quantity("a speed of rotation", "rad/s", "1500 rpm", **_ROTATED)]
SpeedOrZero = Annotated[float, Quantity(
    "a speed of rotation", "rad/s", "1500 rpm", "not negative", **_ROTATED)]
Spin = Annotated[float, Quantity(
    "a speed of rotation", "rad/s", "-20 rad/s", "any", ("1e-24 rad/s", "1e12 rad/s"), ("", "1e4 rad/s"))]
Velocity = Annotated[float, Quantity(
    "a velocity", "m/s", "1.2 m/s", "any", ("1e-24 m/s", "3e8 m/s"), ("", "300 m/s"))]

OilFlow = Annotated[float, Quantity(
    "a flow of oil", "m^3/s", "2 l/min", possible=("1e-9 l/min", "1e6 l/min"),
    usual=("0.01 l/min", "1000 l/min"))]
Modulus = Annotated[float, Quantity(
    "a modulus of elasticity", "Pa", "207 GPa", possible=("0.1 MPa", "1500 GPa"),
    usual=("0.5 GPa", "700 GPa"))]
"""From rubber to diamond; as a rule from polymers to carbides."""

Hardness = Annotated[float, Quantity(
    "an indentation hardness", "Pa", "1.1 GPa", possible=("1 MPa", "200 GPa"), usual=("0.1 GPa", "20 GPa"))]
"""95 HB are 0.93 GPa: bronze about 1, hardened steel about 7."""

Pressure = Annotated[float, Quantity(
    "a pressure", "Pa", "196 MPa", possible=("1 Pa", "1000 GPa"), usual=("1 kPa", "10 GPa"))]
PressureCoordinate = Annotated[float, Quantity(
    "a pressure", "Pa", "400 MPa", "not negative", ("1 Pa", "1000 GPa"), usual=("", "10 GPa"))]
"""A pressure of a measurement, zero for ambient."""

_SHEAR: _Sizes = {"possible": ("1 Pa", "1000 GPa"), "usual": ("0.01 MPa", "2 GPa")}
Stress = Annotated[float, Quantity("a stress", "Pa", "3 MPa", **_SHEAR)]
ResidualStress = Annotated[float, Quantity("a residual stress", "Pa", "-400 MPa", "any", **_SHEAR)]
StressOrZero = Annotated[float, Quantity("a stress", "Pa", "100 MPa", sign="not negative", **_SHEAR)]
_ALPHA: _Sizes = {"possible": ("1e-6 1/GPa", "1000 1/GPa"), "usual": ("0.1 1/GPa", "60 1/GPa")}
PressureViscosity = Annotated[float, Quantity(
    "a pressure-viscosity coefficient", "1/Pa", "9.5 1/GPa", **_ALPHA)]
PressureViscosityOrZero = Annotated[float, Quantity(
    "a pressure-viscosity coefficient", "1/Pa", "9.5 1/GPa", "not negative", **_ALPHA)]
_COMPRESSED: _Sizes = {"possible": ("1e-15 1/GPa", "1e6 1/GPa")}
PressureCoefficient = Annotated[float, Quantity(
    "a pressure coefficient", "1/Pa", "9.5 1/GPa", **_COMPRESSED)]
PressureCoefficientOrZero = Annotated[float, Quantity(
    "a pressure coefficient", "1/Pa", "9.5 1/GPa", "not negative", **_COMPRESSED)]
PressureCoefficientAnySign = Annotated[float, Quantity(
    "a pressure coefficient", "1/Pa", "3.3 1/GPa", "any", **_COMPRESSED)]
SquaredPressureCoefficient = Annotated[float, Quantity(
    "a squared pressure coefficient", "1/Pa^2", "-2.3 1/GPa^2", "any", ("1e-12 1/GPa^2", "1e12 1/GPa^2"))]

Viscosity = Annotated[float, Quantity(
    "a dynamic viscosity", "Pa s", "0.23 Pa s", possible=("1e-6 Pa s", "1e6 Pa s"),
    usual=("0.2 mPa s", "100 Pa s"))]
KinematicViscosity = Annotated[float, Quantity(
    "a kinematic viscosity", "m^2/s", "220 mm^2/s", possible=("0.01 mm^2/s", "1e8 mm^2/s"),
    usual=("0.5 mm^2/s", "1e4 mm^2/s"))]
MassDensity = Annotated[float, Quantity(
    "a density of a solid", "kg/m^3", "7850 kg/m^3", possible=("100 kg/m^3", "25000 kg/m^3"),
    usual=("800 kg/m^3", "20000 kg/m^3"))]
OilDensity = Annotated[float, Quantity(
    "a density of an oil", "kg/m^3", "870 kg/m^3", possible=("100 kg/m^3", "5000 kg/m^3"),
    usual=("600 kg/m^3", "2200 kg/m^3"))]
Mass = Annotated[float, Quantity(
    "a mass", "kg", "450 kg", possible=("1e-3 kg", "1e6 kg"), usual=("0.1 kg", "1e5 kg"))]

Inertia = Annotated[float, Quantity(
    "a moment of inertia", "kg m^2", "0.31 kg mm^2", possible=("1e-18 kg m^2", "1e6 kg m^2"),
    usual=("1e-5 kg mm^2", "1 kg m^2"))]

Conductivity = Annotated[float, Quantity(
    "a thermal conductivity", "W/(m K)", "47 W/(m K)", possible=("1 mW/(m K)", "3000 W/(m K)"),
    usual=("0.1 W/(m K)", "450 W/(m K)"))]
OilConductivity = Annotated[float, Quantity(
    "a thermal conductivity of an oil", "W/(m K)", "0.14 W/(m K)", possible=("1 mW/(m K)", "100 W/(m K)"),
    usual=("0.05 W/(m K)", "1 W/(m K)"))]
SpecificHeat = Annotated[float, Quantity(
    "a specific heat", "J/(kg K)", "477 J/(kg K)", possible=("20 J/(kg K)", "20000 J/(kg K)"),
    usual=("100 J/(kg K)", "5000 J/(kg K)"))]

ThermalExpansion = Annotated[float, Quantity(
    "a linear thermal expansion", "1/K", "11.5e-6 1/K", possible=("1e-8 1/K", "1e-3 1/K"),
    usual=("1e-6 1/K", "2e-4 1/K"))]

Temperature = Annotated[float, Quantity(
    "a temperature", "K", "60 degC", possible=("-110 degC", "400 degC"), usual=("-40 degC", "160 degC"))]
"""From the glass of thin oils to where the hottest ones decompose; as a rule where oils flow and last."""

MaterialTemperature = Annotated[float, Quantity(
    "a temperature of a material", "K", "120 degC", possible=("-110 degC", "1500 degC"),
    usual=("-60 degC", "600 degC"))]
"""At which a solid has some property, or up to which it is used: solids bear more than oils do."""

ScuffingTemperature = Annotated[float, Quantity(
    "a scuffing temperature", "K", "250 degC", possible=("0 degC", "1500 degC"),
    usual=("80 degC", "700 degC"))]
_DIFFERENCE_SIZES: _Sizes = {"possible": ("1e-12 K", "1000 K"), "usual": ("0.01 K", "150 K")}
TemperatureDifference = Annotated[float, Quantity(
    "a temperature difference", "delta_degC", "15 K", "not negative", **_DIFFERENCE_SIZES)]
"""15 degrees are 15 kelvin, however they are written."""
TemperatureRise = Annotated[float, Quantity(
    "a temperature difference", "delta_degC", "15 K", "any", **_DIFFERENCE_SIZES)]
"""A temperature above or below another one."""
ThermalConductance = Annotated[float, Quantity(
    "a thermal conductance", "W/K", "40 W/K", possible=("1e-6 W/K", "1e9 W/K"),
    usual=("0.1 W/K", "1e4 W/K"))]
_BETA: _Sizes = {"possible": ("1e-12 1/K", "10 1/K")}
TemperatureCoefficient = Annotated[float, Quantity("a temperature coefficient", "1/K", "0.05 1/K", **_BETA)]
TemperatureCoefficientOrZero = Annotated[float, Quantity(
    "a temperature coefficient", "1/K", "7.1e-4 1/K", "not negative", **_BETA)]
TemperatureCoefficientAnySign = Annotated[float, Quantity(
    "a temperature coefficient", "1/K", "3.4e-4 1/K", "any", **_BETA)]
Duration = Annotated[float, Quantity(
    "a duration", "s", "25000 h", possible=("1e-6 s", "1e7 h"), usual=("1 h", "3e5 h"))]
Span = Annotated[float, Quantity(
    "a duration", "s", "90 min", possible=("1 ms", "1e6 h"), usual=("1 s", "1e4 h"))]
"""A span of a duty, such as an hour of a day."""

TimeOrZero = Annotated[float, Quantity(
    "a time", "s", "2 ms", "not negative", possible=("1e-12 s", "1 h"), usual=("1 us", "10 s"))]
# fmt: on
Share = Annotated[float, Quantity(**asdict(SHARE_KIND))]
