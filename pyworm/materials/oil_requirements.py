"""What a drive asks of its oil."""

from dataclasses import dataclass

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
