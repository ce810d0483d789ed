"""Entry of a roller into a section of the worm: how it is spun up, how far it slides, and what that loses."""

from bisect import bisect_left
from dataclasses import dataclass
from itertools import pairwise
from math import nan

import numpy as np
import scipy

from pyworm.drives.roller_worm.roller_rotation import RollerRotation, Spun

GAUSS_POINTS = 5
"""Points at which energies are summed over each step of the integration (Gauss and Legendre)."""

SPUN_UP = 0.01
"""What a roller lacks to the balance of moments, over what it lacks to rolling at entry, at which it counts
as spun up [-]."""

SAMPLES = 400
"""Times at which a passage is sampled, beside the steps of the integration."""

_POINTS, _WEIGHTS = np.polynomial.legendre.leggauss(GAUSS_POINTS)


@dataclass(frozen=True)
class Energies:
    """Energies over a time, by quadrature of powers of film, asperities and pin [J]."""

    worm: float
    """Work of the worm's surface on a roller that does not turn about its axis."""
    shear: float
    """Work of the shear on the roller's rotation."""
    sliding: float
    """Loss by sliding."""
    pin: float
    """Loss in the pin."""
    kinetic: float
    """Change of the kinetic energy of rotation."""

    @property
    def residual(self) -> float:
        """Imbalance of the energies over the largest of them [-]."""
        left = self.worm - self.sliding - self.pin - self.kinetic
        return abs(left) / max(abs(self.worm), self.sliding, abs(self.kinetic), 1e-300)


@dataclass(frozen=True)
class SpinUp:
    """Entry of a roller into a section."""

    entry_speed: float
    """Rotation at the first touch [rad/s]."""
    rolling_speed: float
    """Rotation without sliding there [rad/s]."""
    seconds: float
    """Time until its moments balance (`SPUN_UP`) [s]; NaN if they do not within the section."""
    wheel_angle: float
    """Angle that the wheel turns meanwhile [rad]."""
    sliding_distance: float
    """Distance that the worm slides over the roller's circumference meanwhile [m], the load's mean."""
    sliding_speed: float
    """Largest sliding speed round the roller [m/s], the load's mean."""
    entrainment_min: float
    """Least size of the mean velocity of both surfaces across the line [m/s], the load's mean; none where it
    passes through zero."""
    energies: Energies
    """Energies meanwhile."""


def energies(rotation: RollerRotation, begin: float, end: float) -> Energies:
    """Energies between two times [s]."""
    spun = rotation.spun
    steps = [begin, *(time for time in rotation.steps if begin < time < end), end]
    worm = shear = sliding = pin = 0.0
    for low, high in pairwise(steps):
        for point, weight in zip(_POINTS.tolist(), _WEIGHTS.tolist(), strict=True):
            seconds, share = (low + high + point * (high - low)) / 2, weight * (high - low) / 2
            speed = rotation.speed(seconds)
            found = spun.shear_at(seconds, speed)
            worm += share * found.worm_power
            sliding += share * found.sliding_power
            shear += share * found.moment * speed
            pin += share * abs(speed) * spun.braking(found.force, seconds)
    before, after = rotation.speed(begin), rotation.speed(end)
    kinetic = spun.body.inertia / 2 * (after**2 - before**2)
    return Energies(*map(float, (worm, shear, sliding, pin, kinetic)))


def balanced_speed(spun: Spun, seconds: float) -> float:
    """Rotation at which shear and pin friction balance at a time [rad/s]; 0 where the pin holds."""
    at_rest = spun.shear_at(seconds, 0.0)
    drag, sense = spun.braking(at_rest.force, seconds), float(np.sign(at_rest.moment))
    if abs(at_rest.moment) <= drag:
        return 0.0
    ideal = [slices.ideal for _, slices in spun.slices(seconds)]
    fastest = max(float(np.max(sense * speeds)) for speeds in ideal)
    found: float = scipy.optimize.brentq(
        lambda speed: sense * spun.shear_at(seconds, sense * speed).moment - drag,
        0.0,
        fastest,
        xtol=1e-6 * fastest,
    )
    return sense * found


def spin_up(rotation: RollerRotation, section: str) -> SpinUp:
    """The entry of a roller into a section, while the wheel runs steadily."""
    spun, (begin, leave) = rotation.spun, rotation.passages(section)
    inside = [time for time in rotation.steps if begin < time < leave]
    times = np.unique([*np.linspace(begin, leave, SAMPLES + 2)[1:-1], *inside])
    first = dict(spun.slices(float(times[0])))[section]
    lacks = rotation.speed(begin) - first.rolling

    def excess(seconds: float) -> float:
        return (rotation.speed(seconds) - balanced_speed(spun, seconds)) / lacks - SPUN_UP

    last = bisect_left(times.tolist(), True, key=lambda seconds: excess(seconds) <= 0)
    rolls, last = last < len(times), min(last, len(times) - 1)
    if rolls and last > 0:
        times[last] = scipy.optimize.brentq(excess, times[last - 1], times[last], xtol=1e-9)
    slid, entrained = [], []
    for seconds in times[: last + 1].tolist():
        slices, speed = dict(spun.slices(seconds))[section], rotation.speed(seconds)
        slid.append(abs(speed - slices.rolling) * slices.mean(slices.radius))
        entrained.append(slices.mean(slices.entrainment(speed)))
    until, turned = float(times[last]), min(entrained) < 0 < max(entrained)
    return SpinUp(
        entry_speed=rotation.speed(begin),
        rolling_speed=first.rolling,
        seconds=until - begin if rolls else nan,
        wheel_angle=abs(spun.wheel.turning) * (until - begin) if rolls else nan,
        sliding_distance=float(np.trapezoid(slid, times[: last + 1])),
        sliding_speed=max(slid),
        entrainment_min=0.0 if turned else min(map(abs, entrained)),
        energies=energies(rotation, begin, until),
    )
