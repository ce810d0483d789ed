"""Rotation of a roller about its own axis over a turn of the wheel, as an equation of motion.

    I d(omega)/dt = M(t, omega) - M_pin sgn(omega)

with the moment M of the shear of film and asperities (`slice_shear`) in both sections, and the friction of
the pin under the roller's load; between the sections, and round the rest of the wheel, under its weight and
centrifugal force. A roller at rest stays so until M exceeds the pin's friction. Stiff where the film carries
load, the equation is integrated by the implicit method Radau IIA of order 5 (Hairer and Wanner 1996, IV.8) as
scipy has it, from one end of a section to the next.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise
from math import pi
from typing import Any

import numpy as np
import scipy

from pyworm.drives.roller_worm.envelope import Array
from pyworm.drives.roller_worm.roller_body import RollerBody
from pyworm.drives.roller_worm.roller_path import RollerPath, Slices
from pyworm.drives.roller_worm.slice_shear import Shear, SliceShear
from pyworm.drives.roller_worm.wheel_motion import WheelMotion

RELATIVE_TOLERANCE = 1e-5
"""Relative error of a step of the integration [-]: energies balance to 0.1 %, to 1e-7 with a thousandth."""

ABSOLUTE_SHARE = 0.1
"""Absolute error of a step, over the relative one times the fastest rolling speed [-]."""

LOOKS = 400
"""Times at which a roller at rest is looked at for the moment that turns it."""

RELEASE = 1e-3
"""Part of the time between two looks by which a roller is let go after the moment exceeds the pin's."""

Factor = Callable[[str, float, float], Array | float]
"""Section, wheel angle [rad], rotation of the roller [rad/s] -> factor of the closed-form shear stress of
each slice."""


def no_factor(section: str, wheel_angle: float, speed: float) -> float:
    """Shear as the closed forms have it."""
    return 1.0


@dataclass(frozen=True)
class LoadedPath:
    """A roller's path through a section, under the preload alone and with the worm's torque."""

    idle: RollerPath | None
    """The path under the preload; None without one."""
    driving: RollerPath | None
    """The path with the worm's torque too; None where it never has that."""
    sense: float
    """Sign of the torque's factor with which this section carries it."""

    @property
    def touched(self) -> tuple[float, float]:
        """Wheel angles between which the roller touches [rad]."""
        path = self.driving or self.idle
        return path.touched if path is not None else (np.inf, -np.inf)

    def at(self, wheel_angle: float, torque: float, speed: float) -> Slices | None:
        """Slices at a wheel angle [rad] under factors of torque and speed; None where nothing presses."""
        low, high = self.touched
        share = max(self.sense * torque, 0.0)
        if not low <= wheel_angle <= high or (share == 0 and self.idle is None):
            return None
        if share == 0 or self.driving is None:
            slices = self.idle.at(wheel_angle) if self.idle is not None else None
            return slices if slices is None else slices.scaled(slices.load, speed)
        slices = self.driving.at(wheel_angle)
        load = share * slices.load
        if share != 1 and self.idle is not None:
            load = load + (1 - share) * self.idle.at(wheel_angle).load
        return slices.scaled(load, speed)


@dataclass(frozen=True)
class Piece:
    """A part of the motion without a change of the pin's sense."""

    times: Array
    """Times of the steps [s]."""
    speed: Callable[[float], float]
    """Time [s] -> rotation of the roller [rad/s]."""


@dataclass(frozen=True)
class Spun:
    """A roller on its wheel: what turns it, what brakes it."""

    paths: Mapping[str, LoadedPath]
    """Its contact lines in each section."""
    shear: SliceShear
    """Shear of film and asperities."""
    body: RollerBody
    """The roller."""
    wheel: WheelMotion
    """Motion of the wheel."""
    factor: Factor = no_factor
    """Factor of the closed-form shear."""

    def slices(self, seconds: float) -> Iterator[tuple[str, Slices]]:
        """Sections that the roller touches at a time [s], with its slices there."""
        angle = self.wheel.wheel_angle(seconds)
        angle = (angle + pi) % (2 * pi) - pi
        factors = self.wheel.torque_factor(seconds), self.wheel.speed_factor(seconds)
        for name, path in self.paths.items():
            slices = path.at(angle, *factors)
            if slices is not None:
                yield name, slices

    def shear_at(self, seconds: float, speed: float) -> Shear:
        """Shear in all sections at a time [s] and a speed of the roller about its axis [rad/s]."""
        angle, found = self.wheel.wheel_angle(seconds), Shear()
        for name, slices in self.slices(seconds):
            found = found + self.shear.at(slices, speed, self.factor(name, angle, speed))
        return found

    def braking(self, force: float, seconds: float) -> float:
        """Friction moment of the pin [N m] under a load [N]."""
        turning = self.wheel.turning * self.wheel.speed_factor(seconds)
        return self.body.pin_friction(force, turning)


@dataclass(frozen=True)
class RollerRotation:
    """Rotation of one roller over time."""

    spun: Spun
    """What turns and brakes it."""
    pieces: tuple[Piece, ...]
    """What was integrated, in order of time."""

    def speed(self, seconds: float) -> float:
        """Rotation about the roller's axis [rad/s] at a time, towards growing theta."""
        ends = [piece.times[-1] for piece in self.pieces]
        number = min(int(np.searchsorted(ends, seconds)), len(self.pieces) - 1)
        return self.pieces[number].speed(seconds)

    @property
    def steps(self) -> Array:
        """Times of all steps of the integration [s]."""
        return np.unique(np.concatenate([piece.times for piece in self.pieces]))

    @property
    def end(self) -> float:
        """Time up to which the rotation is known [s]."""
        return float(self.pieces[-1].times[-1])

    def passages(self, section: str) -> tuple[float, float]:
        """Times at which the roller first and last touches a section [s], while the wheel runs steadily."""
        low, high = self.spun.paths[section].touched
        wheel = self.spun.wheel
        both = sorted(
            ((angle - wheel.begin) / wheel.turning) % (2 * pi / abs(wheel.turning))
            if abs(angle - wheel.begin) > 1e-12
            else 0.0
            for angle in (low, high)
        )
        return both[0], both[1]

    def at(self, wheel_angle: float) -> float:
        """Rotation about the roller's axis [rad/s] at a wheel angle [rad], while the wheel runs steadily."""
        wheel = self.spun.wheel
        turned = (wheel_angle - wheel.begin) / wheel.turning
        return self.speed(turned % (2 * pi / abs(wheel.turning)))


def over_a_turn(
    spun: Spun, entry_speed: float | None = None, tolerance: float = RELATIVE_TOLERANCE
) -> RollerRotation:
    """The rotation of a roller over a turn of the wheel from its first touch on.

    Args:
        spun: The roller; its wheel runs steadily from the first touch of the first section.
        entry_speed: Rotation then [rad/s]; by default that of a turn of the wheel before, which the last
            section and the way back leave.
        tolerance: Relative error of a step.
    """
    period = 2 * pi / abs(spun.wheel.turning)
    if entry_speed is None:
        late = _late(spun)
        (_, slices), *_ = spun.slices(late)
        *_, last = _pieces(spun, late, period, slices.rolling, tolerance)
        entry_speed = last.speed(period)
    return RollerRotation(spun, tuple(_pieces(spun, 0.0, period, entry_speed, tolerance)))


def over_times(
    spun: Spun, until: float, start: float | None = None, tolerance: float = RELATIVE_TOLERANCE
) -> RollerRotation:
    """The rotation of a roller up to a time [s], from a speed [rad/s], by default without sliding."""
    if start is None:
        touching = [slices.rolling for _, slices in spun.slices(0.0)]
        start = touching[0] if touching else 0.0
    return RollerRotation(spun, tuple(_pieces(spun, 0.0, until, start, tolerance)))


def _late(spun: Spun) -> float:
    """Time in the middle of the last section that the roller touches within a turn of the wheel [s]."""
    ends = spun.wheel.passages(_ends(spun), 2 * pi / abs(spun.wheel.turning))
    return max((low + high) / 2 for low, high in pairwise(ends) if [*spun.slices((low + high) / 2)])


def _ends(spun: Spun) -> list[float]:
    """Wheel angles at which the roller begins or ends to touch a section [rad], also a turn later."""
    ends = {end for path in spun.paths.values() for end in path.touched}
    return [end + turn for end in ends for turn in (-2 * pi, 0.0, 2 * pi)]


def _pieces(
    spun: Spun, begin: float, end: float, speed: float, tolerance: float
) -> Iterator[Piece]:
    """The motion between two times [s], from a speed [rad/s]."""
    scale = _fastest(spun)
    passages = [time for time in spun.wheel.passages(_ends(spun), end) if time > begin]
    for low, high in pairwise([begin, *passages]):
        time = low
        while time < high:
            piece = _piece(spun, (time, high), speed, scale, tolerance)
            yield piece
            time = float(piece.times[-1])
            speed = piece.speed(time)


def _fastest(spun: Spun) -> float:
    """Fastest rolling of what is tabulated [rad/s], the scale of speeds."""
    paths = [path for loaded in spun.paths.values() for path in (loaded.idle, loaded.driving)]
    return max(
        abs(path.at(angle).rolling)
        for path in paths
        if path is not None
        for angle in path.wheel_angles[1:-1:8].tolist()
    )


def _piece(
    spun: Spun, times: tuple[float, float], speed: float, scale: float, tolerance: float
) -> Piece:
    """The motion until the roller stops, or to the end."""
    begin, end = times
    sense = float(np.sign(speed)) or _sense_from_rest(spun, begin)
    if sense == 0 and spun.body.pin_arm > 0:
        return Piece(np.array([begin, _stays_until(spun, begin, end)]), lambda seconds: 0.0)

    def acceleration(seconds: float, scaled: Array) -> Array:
        shear = spun.shear_at(seconds, scale * float(scaled[0]))
        drag = sense * spun.braking(shear.force, seconds)
        return np.array([(shear.moment - drag) / (spun.body.inertia * scale)])

    def stops(seconds: float, scaled: Array) -> float:
        return sense * float(scaled[0])

    stops.terminal, stops.direction = True, -1.0  # type: ignore[attr-defined]  # read by scipy
    found = scipy.integrate.solve_ivp(
        acceleration,
        times,
        [speed / scale],
        method="Radau",
        dense_output=True,
        events=stops if spun.body.pin_arm > 0 else None,
        rtol=tolerance,
        atol=ABSOLUTE_SHARE * tolerance,
    )
    if found.status < 0:
        raise ValueError(f"the rotation of a roller could not be integrated: {found.message}")
    return Piece(found.t, _dense(found, scale))


def _sense_from_rest(spun: Spun, seconds: float) -> float:
    """Sense in which a roller at rest begins to turn; 0 where the pin holds it."""
    shear = spun.shear_at(seconds, 0.0)
    holds = abs(shear.moment) <= spun.braking(shear.force, seconds)
    return 0.0 if holds else float(np.sign(shear.moment))


def _stays_until(spun: Spun, begin: float, end: float) -> float:
    """Time up to which the pin holds a roller at rest [s]."""

    def excess(seconds: float) -> float:
        shear = spun.shear_at(seconds, 0.0)
        return abs(shear.moment) - spun.braking(shear.force, seconds)

    for low, high in pairwise(np.linspace(begin, end, LOOKS).tolist()):
        if excess(high) > 0:
            found = scipy.optimize.brentq(excess, low, high) if excess(low) < 0 else low
            # beyond rounding, so that the pin does not hold it at once again
            return float(found + RELEASE * (high - found))
    return end


def _dense(found: Any, scale: float) -> Callable[[float], float]:
    """Time [s] -> speed [rad/s] of an integration, none where it ends as the roller stops."""
    last = float(found.t[-1])
    final = 0.0 if found.status == 1 else scale * float(found.y[0, -1])

    def speed(seconds: float) -> float:
        return final if seconds >= last else scale * float(found.sol(seconds)[0])

    return speed
