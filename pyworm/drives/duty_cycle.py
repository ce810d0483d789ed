"""Duty of a gear unit: blocks of torque, speed, time and ambient temperature, one after the other."""

from dataclasses import dataclass
from math import isclose

from pyworm.io import units


@dataclass(frozen=True, kw_only=True)
class DutyBlock:
    """A span of time at one load; at rest where the speed is zero."""

    torque: units.TorqueOrZero
    """Torque of the second shaft: wheel, gear [N m]."""
    speed: units.SpeedOrZero
    """Speed of the first shaft: worm, pinion [rad/s]; zero: at rest."""
    duration: units.Span
    """Length [s]."""
    ambient: units.Temperature | None = None
    """Temperature of the surroundings [K]; None: that of the cooling, over a day."""

    @property
    def running(self) -> bool:
        """Whether the gears turn."""
        return self.speed > 0

    @property
    def load(self) -> tuple[float, float]:
        """Speed [rad/s] and torque [N m]."""
        return self.speed, self.torque


@dataclass(frozen=True)
class DutyCycle:
    """Blocks of a duty."""

    blocks: tuple[DutyBlock, ...]
    """Blocks in order."""
    names: tuple[str, ...]
    """Name of each."""
    periodic: bool = True
    """Whether it repeats for ever; else it begins once, as cold as the surroundings."""

    @property
    def duration(self) -> float:
        """Length of all blocks [s]."""
        return sum(block.duration for block in self.blocks)

    @property
    def loads(self) -> tuple[tuple[float, float], ...]:
        """Each different speed [rad/s] and torque [N m] at which the gears turn, in order."""
        return tuple(dict.fromkeys(block.load for block in self.blocks if block.running))

    def is_days(self, day: float) -> bool:
        """Whether it lasts a whole number of days [s]."""
        days = self.duration / day
        return days >= 1 and isclose(days, round(days), rel_tol=1e-9)
