"""Angle of a roller about the wheel's axis over time, while the drive runs steadily, starts, or reverses."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
import scipy

from pyworm.drives.roller_worm.envelope import Array


@dataclass(frozen=True)
class WheelMotion:
    """Motion of the wheel and its load; factors are straight between the times, and constant outside."""

    begin: float
    """Wheel angle of the roller at time zero [rad]."""
    turning: float
    """Speed of the wheel about -Z at a factor of one [rad/s], signed."""
    times: tuple[float, ...] = (0.0,)
    """Times of the factors [s]; the first is zero."""
    speed: tuple[float, ...] = (1.0,)
    """Factors of the speed [-], negative while the drive runs the other way."""
    torque: tuple[float, ...] = (1.0,)
    """Factors of the worm's torque [-], negative while the other section carries it."""

    @cached_property
    def _angles(self) -> Array:
        """Wheel angle at each of the times [rad]."""
        steps = np.diff(self.times) * (np.array(self.speed[:-1]) + np.array(self.speed[1:])) / 2
        return self.begin + self.turning * np.concatenate([[0.0], np.cumsum(steps)])

    def speed_factor(self, seconds: float) -> float:
        """Factor of the speed [-] at a time [s]."""
        return float(np.interp(seconds, self.times, self.speed))

    def torque_factor(self, seconds: float) -> float:
        """Factor of the torque [-] at a time [s]."""
        return float(np.interp(seconds, self.times, self.torque))

    def wheel_angle(self, seconds: float) -> float:
        """Wheel angle of the roller [rad] at a time [s]."""
        number = max(int(np.searchsorted(self.times, seconds, side="right")) - 1, 0)
        since = seconds - self.times[number]
        mean = (self.speed[number] + self.speed_factor(seconds)) / 2
        return float(self._angles[number] + self.turning * mean * since)

    def passages(self, wheel_angles: Sequence[float], until: float) -> list[float]:
        """Times up to `until` at which the roller passes wheel angles [rad], or a factor has a kink [s]."""
        ends = sorted({time for time in (*self.times, *self._turned(), until) if time < until})
        found = {*ends, until}
        for low, high in pairwise((*ends, until)):
            first, last = self.wheel_angle(low), self.wheel_angle(high)
            for angle in wheel_angles:
                if min(first, last) < angle < max(first, last):
                    found.add(self._passage(angle, low, high))
        return sorted(time for time in found if 0 <= time <= until)

    def _turned(self) -> list[float]:
        """Times at which the wheel reverses [s]."""
        found = []
        for (t0, t1), (v0, v1) in zip(pairwise(self.times), pairwise(self.speed), strict=True):
            if v0 * v1 < 0:
                found.append(t0 + (t1 - t0) * v0 / (v0 - v1))
        return found

    def _passage(self, wheel_angle: float, low: float, high: float) -> float:
        """Time between two at which the roller passes a wheel angle [s]; its motion there is monotone."""
        return float(
            scipy.optimize.brentq(
                lambda seconds: self.wheel_angle(seconds) - wheel_angle, low, high, xtol=1e-15
            )
        )
