"""Running-in programme of a gear unit: stages of load and speed, each with what ends it."""

from dataclasses import dataclass

from pyworm.io import units
from pyworm.io.plain_values import Fraction


@dataclass(frozen=True, kw_only=True)
class RunInStage:
    """A stage of a running-in programme; it ends after its duration, or by a criterion before."""

    torque: units.Torque
    """Torque of the second shaft: wheel, gear [N m]."""
    speed: units.Speed
    """Speed of the first shaft: worm, pinion [rad/s]."""
    duration: units.Span
    """Longest duration [s]."""
    asperity_load_ratio: Fraction | None = None
    """Asperity load ratio to which it falls until the stage ends [-]."""
    oil_temperature: units.Temperature | None = None
    """Oil temperature at which the stage ends [K]."""
