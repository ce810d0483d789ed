"""Comparison of viscosity grades: film, friction loss and viscosity needed."""

from collections.abc import Callable
from dataclasses import dataclass

import scipy

from pyworm.formulas import film as films
from pyworm.formulas import gear_oil
from pyworm.formulas.bearing_life import reference_viscosity
from pyworm.formulas.gear_oil import TableAdvice
from pyworm.formulas.oil_life import HOUR, oil_life
from pyworm.formulas.ranges import positive, within
from pyworm.formulas.unit_factors import RPM, SQUARE_MILLIMETRE
from pyworm.formulas.worm_gear import WormGear
from pyworm.formulas.worm_standard import PRESSURE_VISCOSITY, minimum_film
from pyworm.io.quantities import QUANTITIES
from pyworm.materials.base_stock import Base, base_stock
from pyworm.materials.library import NamedOil, named_oil, oil_from_index
from pyworm.materials.oil_requirements import OilRequirements
from pyworm.ratings.no_load import NoLoad

CHURNING_EXPONENT = 0.5
"""How churning loss grows with viscosity: friction of a laminar boundary layer on a disc goes as its root."""

KILOWATT = 1e3
"""[W]."""

THICKEST = 9e-3
"""Largest viscosity at 40 degC [m2/s] that is looked for."""


@dataclass(frozen=True)
class FilmLaw:
    """A minimum film as a function of the oil alone."""

    film: Callable[[float, float], float]
    """Dynamic viscosity [Pa s] and pressure-viscosity coefficient [1/Pa] -> the minimum film [m]."""
    source: str
    """Source of the formula."""
    words: str
    """The formula, with the numbers of all but the oil."""
    alpha: float | None = None
    """The formula's pressure-viscosity coefficient of the base stock [1/Pa]; None: the oil's own."""

    def of(self, oil: NamedOil, temperature: float) -> float:
        """The film [m] of an oil on teeth of a temperature [K]."""
        return self.film(float(oil.viscosity(temperature)), self.alpha_of(oil, temperature))

    def alpha_of(self, oil: NamedOil, temperature: float) -> float:
        """The pressure-viscosity coefficient [1/Pa] that the formula takes."""
        return float(oil.alpha(temperature)) if self.alpha is None else self.alpha


def line_film(
    radius: float, load_per_length: float, reduced_modulus: float, speed: float
) -> FilmLaw:
    """Dowson and Higginson's film of one contact of a gear pair; arguments in SI units."""

    def film(viscosity: float, alpha: float) -> float:
        groups = films.line_groups(
            radius, load_per_length, reduced_modulus, speed, viscosity, alpha
        )
        return films.dowson_higginson(groups).minimum_number

    return FilmLaw(
        film,
        "minimum film thickness of a line contact, Dowson and Higginson (1968)",
        "h = 2.65 R U^0.70 G^0.54 W^-0.13, U = eta u/(E' R), G = alpha E', W = w/(E' R), at the thinnest "
        f"place of the line of action with R = {radius * 1e3:.3g} mm, u = {speed:.3g} m/s, "
        f"w = {load_per_length * 1e-3:.0f} N/mm, E' = {reduced_modulus * 1e-9:.0f} GPa",
    )


def worm_film(
    gear: WormGear, worm_speed: float, torque: float, reduced_modulus: float, base: Base
) -> FilmLaw:
    """The mean minimum film thickness of a worm gear by the standards; arguments as of `WormConditions`."""

    def film(viscosity: float, alpha: float) -> float:
        return minimum_film(
            gear.film_parameter,
            alpha,
            viscosity,
            worm_speed,
            gear.centre_distance,
            reduced_modulus,
            torque,
        )

    return FilmLaw(
        film,
        "mean minimum film thickness of a worm gear, methods of DIN 3996",
        "h = 21 h* alpha^0.6 eta^0.7 n^0.7 a^1.39 E^0.03/T^0.13 um (alpha in m2/N, eta in Pa s) with h* = "
        f"{gear.film_parameter:.4f}, n = {worm_speed * RPM:.0f} rpm, "
        f"a = {gear.centre_distance * 1e3:.1f} mm, E = {reduced_modulus * 1e-6:.0f} N/mm2, "
        f"T = {torque:.0f} N m",
        alpha=PRESSURE_VISCOSITY.get(base),
    )


@dataclass(frozen=True, kw_only=True)
class GearTeeth:
    """What the teeth ask of type and additives."""

    worm: bool
    """Whether it is a worm gear set."""
    velocity: float
    """Pitch line velocity, or sliding velocity of a worm gear set [m/s]."""
    pressure: float
    """Maximum contact pressure, or the mean one of a worm gear set [Pa]."""
    fast_shaft: float
    """Speed of the fast shaft [rad/s]."""
    fast_torque: float
    """Torque of the fast shaft without losses [N m]."""
    starting_torque: float
    """Torque that starts it under load, with the friction of teeth at rest [N m]."""
    wheel_material: str | None = None
    """Material of the wheel; None where it has no name."""

    @property
    def copper(self) -> bool:
        """Whether a wheel is of a copper alloy; one without a name is taken for bronze."""
        return self.worm and (self.wheel_material or "Cu").startswith("Cu")


@dataclass(frozen=True, kw_only=True)
class OilDuty(OilRequirements):
    """Requirements of an oil."""

    name: str
    """The drive."""
    film: FilmLaw
    """How the film follows the oil."""
    roughness: float
    """Composite rms roughness of the teeth [m]."""
    pitch_line_velocity: float | None = None
    """Pitch line velocity [m/s], by which speed and distress are judged; None for a worm gear."""
    tables: tuple[TableAdvice | None, ...] = ()
    """Grades by tables; None for a table without a row."""
    contact_temperature: float | None = None
    """Largest contact temperature of the teeth [K], if scuffing is to be judged."""
    bearing_speed: float | None = None
    """Speed of the bearing that needs the thickest oil [rad/s]."""
    bearing_diameter: float | None = None
    """Mean diameter of the bearing that needs the thickest oil [m]."""
    teeth: GearTeeth | None = None
    """What they ask of type and additives; None where that is not looked at."""
    no_load: NoLoad | None = None
    """Torque with which oil resists, if starts are looked at."""

    @property
    def hours_per_year(self) -> float | None:
        """Hours of operation in a year [h]; None where not given."""
        return None if self.yearly_operation is None else self.yearly_operation / HOUR

    def __post_init__(self) -> None:
        """Refuse impossible requirements."""
        base_stock(self.base)
        within(QUANTITIES["composite_roughness"].words(), self.roughness, 1e-9, 1e-4, "m")
        within("wanted lambda", self.specific_film, 0.01, 20, "")
        within("ambient temperature", self.ambient_temperature, 220, 340, "K")
        within("sump temperature", self.sump_temperature, 250, 470, "K")
        within("limit of the sump temperature", self.sump_limit, 300, 470, "K")
        within("excess of the teeth's temperature", self.bulk_excess, 0, 150, "K")
        within("share of churning", self.churning_share, 0, 0.9, "")
        if self.sump_temperature <= self.ambient_temperature:
            raise ValueError(
                f"sump temperature = {self.sump_temperature:g} K: must be above the ambient "
                f"{self.ambient_temperature:g} K"
            )
        if (self.bearing_speed is None) != (self.bearing_diameter is None):
            raise ValueError("give bearing_speed and bearing_diameter together")
        if self.pitch_line_velocity is not None:
            positive("pitch line velocity", self.pitch_line_velocity, "m/s")


@dataclass(frozen=True)
class GradeRow:
    """Performance of one grade."""

    grade: int
    """ISO viscosity grade."""
    sump_temperature: float
    """Sump temperature in balance with its own churning [K]."""
    bulk_temperature: float
    """Bulk temperature in balance with its own churning [K]."""
    viscosity: float
    """Kinematic viscosity at the teeth [m2/s]."""
    film: float
    """Minimum film [m]."""
    specific_film: float
    """Specific film lambda [-]."""
    heat: float
    """Heat in the sump over that with the grade of reference [-]."""
    kappa: float | None
    """Viscosity ratio of the bearing at the sump temperature [-]."""
    oil_life: float
    """Life of the oil in the sump by oxidation [h]."""
    loss: float | None = None
    """Loss of the unit [W]; None where that of the grade of reference is not given."""
    energy_cost: float | None = None
    """Cost of that loss in a year, in the currency of the price; None without one."""
    start_torque: float | None = None
    """Torque at the fast shaft with which oil resists at full speed at the coldest start [N m]."""


def grade_row(duty: OilDuty, grade: int) -> GradeRow:
    """Performance of a viscosity grade under some requirements."""
    oil = named_oil(f"{duty.base} VG {grade}")
    reference = named_oil(f"{duty.base} VG {duty.sump_grade}")
    thickness = float(reference.kinematic_viscosity(duty.sump_temperature))
    rise, fraction = duty.sump_temperature - duty.ambient_temperature, duty.churning_share

    def heat(sump: float) -> float:
        ratio = float(oil.kinematic_viscosity(sump)) / thickness
        return 1 - fraction + fraction * ratio**CHURNING_EXPONENT

    # Thinner with every degree, so that there is one balance; the teeth's share alone bounds it from below.
    coldest = duty.ambient_temperature + (1 - fraction) * rise
    sump = scipy.optimize.brentq(
        lambda sump: duty.ambient_temperature + rise * heat(sump) - sump, coldest, 499.0
    )
    bulk = sump + duty.bulk_excess
    film = duty.film.of(oil, bulk)
    return GradeRow(
        grade=grade,
        sump_temperature=sump,
        bulk_temperature=bulk,
        viscosity=float(oil.kinematic_viscosity(bulk)),
        film=film,
        specific_film=film / duty.roughness,
        heat=heat(sump),
        kappa=_kappa(duty, float(oil.kinematic_viscosity(sump))),
        oil_life=oil_life(duty.base, sump),
        loss=None if duty.loss is None else duty.loss * heat(sump),
        energy_cost=_energy_cost(duty, heat(sump)),
        start_torque=_start_torque(duty, oil),
    )


def _energy_cost(duty: OilDuty, heat: float) -> float | None:
    """Cost of the loss in a year."""
    if duty.loss is None or duty.energy_price is None or duty.hours_per_year is None:
        return None
    return duty.energy_price * duty.hours_per_year * duty.loss * heat / KILOWATT


def _start_torque(duty: OilDuty, oil: NamedOil) -> float | None:
    """Torque of the oil at the coldest start [N m]."""
    if duty.coldest_start is None or duty.no_load is None:
        return None
    return duty.no_load.torque(oil, duty.coldest_start)


def _kappa(duty: OilDuty, viscosity: float) -> float | None:
    if duty.bearing_speed is None or duty.bearing_diameter is None:
        return None
    return viscosity / reference_viscosity(duty.bearing_speed, duty.bearing_diameter)


def _film_at(duty: OilDuty, oil: NamedOil) -> float:
    """Film [m] of an oil on teeth of the temperature of reference."""
    return duty.film.of(oil, duty.sump_temperature + duty.bulk_excess)


def viscosity_needed(duty: OilDuty) -> float | None:
    """Viscosity at 40 degC [m2/s] for the wanted film, of the index of the reference; None beyond reach."""
    index = named_oil(f"{duty.base} VG {duty.sump_grade}").viscosity_index

    def surplus(viscosity_40: float) -> float:
        oil = oil_from_index("", duty.base, viscosity_40, index)
        return _film_at(duty, oil) / duty.roughness - duty.specific_film

    thinnest = 15 * SQUARE_MILLIMETRE
    if surplus(THICKEST) < 0:
        return None
    if surplus(thinnest) > 0:
        return thinnest
    return float(scipy.optimize.brentq(surplus, thinnest, THICKEST, rtol=1e-6))


def least_grade(duty: OilDuty) -> int:
    """The thinnest grade that rules of practice allow; 0 without any."""
    least = [min(table.grades) for table in duty.tables if table is not None and table.least]
    return max([min(past_practice(duty), default=0), *least])


def past_practice(duty: OilDuty) -> list[int]:
    """Grades that the rule of speed and the tables name."""
    grades = [
        grade
        for table in duty.tables
        if table is not None and not table.least
        for grade in table.grades
    ]
    if duty.pitch_line_velocity is not None:
        wanted = gear_oil.pitch_line_viscosity(duty.pitch_line_velocity)
        grades.append(gear_oil.nearest_grade(wanted))
    return grades
