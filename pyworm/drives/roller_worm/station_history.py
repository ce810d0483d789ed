"""A station of a roller's contact line over time: what a transient film of it needs, and its friction.

The rotation of the roller gives load, velocities and curvature over time, as `pyworm.transient` takes them.
The friction of that film can take the place of the closed form's in the equation of motion, by `Factor`.
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pyworm.drives.roller_worm.envelope import Array
from pyworm.drives.roller_worm.load_sharing import POINTS
from pyworm.drives.roller_worm.roller_path import Slices
from pyworm.drives.roller_worm.roller_rotation import Factor, RollerRotation, no_factor

KNOTS = 81
"""Times at which a station is given."""

LEAST_SLIDING = 0.2
"""Sliding over the entrainment below which friction by two methods is not compared [-]."""

FACTORS = 0.05, 5.0
"""Range of the factor of the closed-form shear [-]."""


@dataclass(frozen=True)
class StationHistory:
    """A station of a roller's contact line over time."""

    times: Array
    """Times from the beginning of the window [s]."""
    wheel_angles: Array
    """Wheel angle of the roller at each [rad]."""
    speeds: Array
    """Rotation of the roller about its axis [rad/s]."""
    load: Array
    """Load for each length [N/m]."""
    radius: Array
    """Radius of relative curvature [m]."""
    entrainment: Array
    """Entrainment velocity [m/s]."""
    sliding: Array
    """Velocity of the worm relative to the roller across the line [m/s]."""
    friction: Array
    """Friction coefficient by closed forms of that sliding [-]."""

    @property
    def laws(self) -> dict[str, Any]:
        """Arguments of `pyworm.transient` over its times."""
        return {
            "load": self.load,
            "speed": self.entrainment,
            "sliding": self.sliding,
            "radii": [self.radius],
        }

    def friction_of(self, seconds: Array, power_loss: Array, load: Array) -> Array:
        """Friction coefficient of a film at times [s] by its loss [W/m] and load [N/m].

        NaN where the film hardly slides.
        """
        sliding = np.interp(seconds, self.times, np.abs(self.sliding))
        entrained = np.interp(seconds, self.times, np.abs(self.entrainment))
        slides = sliding > LEAST_SLIDING * entrained
        friction = power_loss / (load * np.where(slides, sliding, 1.0))
        return np.where(slides, friction, np.nan)

    def factor(self, section: str, seconds: Array, friction: Array) -> Factor:
        """Friction of a film at times [s] over that of the closed form, by the speed of the roller."""
        closed = np.interp(seconds, self.times, self.friction)
        known = np.isfinite(friction) & (closed > 0)
        if not known.any():
            return no_factor
        ratio = np.clip(friction[known] / closed[known], *FACTORS)
        angles = np.interp(seconds[known], self.times, self.wheel_angles)
        speeds = np.interp(seconds[known], self.times, self.speeds)
        low, high, order = angles.min(), angles.max(), np.argsort(speeds)

        def factor(name: str, angle: float, speed: float) -> float:
            inside = name == section and low <= angle <= high
            return float(np.interp(speed, speeds[order], ratio[order])) if inside else 1.0

        return factor


def station_history(
    rotation: RollerRotation, section: str, station: float, window: tuple[float, float]
) -> StationHistory:
    """A station of a contact line between two times of a rotation [s]; ValueError without load."""
    spun = rotation.spun
    times, sense = np.linspace(*window, KNOTS), 0.0
    columns: list[tuple[float, ...]] = []
    for seconds in times.tolist():
        found = dict(spun.slices(seconds)).get(section)
        if found is None:
            raise ValueError(f"the {section} section carries no load at {seconds:.4g} s")
        speed = rotation.speed(seconds)
        slices = _at(found, station)
        sense = sense or float(np.sign(slices.rel_across[0])) or 1.0  # that of the first time
        mean = slices.sum_across + speed * slices.radius * slices.round_across
        across, _ = slices.sliding(speed)
        along_left_out = replace(
            slices, rel_along=speed * slices.radius * slices.round_along, length=np.ones(1)
        )
        shear = spun.shear.at(along_left_out, speed)
        slid = abs(float(across[0])) * float(slices.load[0])
        columns.append(
            (
                speed,
                float(slices.load[0]),
                1 / float(slices.curvature[0]),
                sense * float(mean[0]) / 2,
                sense * float(across[0]),
                shear.sliding_power / slid if slid > 0 else 0.0,
            )
        )
    angles = np.array([spun.wheel.wheel_angle(seconds) for seconds in times.tolist()])
    speeds, load, radius, entrainment, sliding, friction = np.array(columns).T
    return StationHistory(
        times - times[0], angles, speeds, load, radius, entrainment, sliding, friction
    )


def _at(slices: Slices, station: float) -> Slices:
    """The slice at a fraction of the contact line."""
    return Slices(
        **{
            name: np.array([np.interp(station, POINTS, values)])
            for name, values in vars(slices).items()
        }
    )
