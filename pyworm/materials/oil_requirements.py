"""What a drive asks of its oil."""

from dataclasses import dataclass

from pyworm.formulas.lubricant_type import Enclosure
from pyworm.formulas.oil_life import UsedOil
from pyworm.io import units
from pyworm.io.plain_values import Count, PositiveNumber
from pyworm.materials.base_stock import Base


@dataclass(frozen=True, kw_only=True)
class OilRequirements:
    """Requirements of an oil that do not follow from the drive's teeth."""

    base: Base
    """Base stock to choose a grade of."""
    specific_film: PositiveNumber
    """Specific film lambda that is wanted [-]."""
    ambient_temperature: units.Temperature
    """Ambient temperature [K]."""
    sump_temperature: units.Temperature
    """Sump temperature [K]."""
    sump_grade: Count
    """Grade with which the sump temperature is measured or expected."""
    bulk_excess: units.TemperatureDifference
    """How far the teeth are hotter than the sump [K]."""
    churning_share: units.Share
    """Fraction of the heat in the sump that churning makes with that grade [-], 0 to 0.9."""
    sump_limit: units.Temperature
    """Highest sump temperature allowed [K]."""
    coldest_start: units.Temperature | None = None
    """Lowest temperature at which the drive starts [K], if the pour point is to be given."""
    enclosure: Enclosure = "oil-tight"
    """Housing: "oil-tight" with shaft seals, "leaking", "open", or in "vacuum"."""
    loss: units.Power | None = None
    """Loss of the whole unit with that grade [W], if losses are to be compared."""
    yearly_operation: units.Duration | None = None
    """Time in operation in a year [s], for energy and change interval."""
    energy_price: PositiveNumber | None = None
    """Price of a kilowatt hour, in any currency."""
    motor_torque: units.Torque | None = None
    """Torque that the motor has at the fast shaft to start with [N m]."""
    used_oil: UsedOil | None = None
    """Analysis of the oil in the sump."""
