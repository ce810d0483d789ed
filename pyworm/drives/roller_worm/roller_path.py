"""Contact lines of one roller along its path through a section, tabulated over the wheel's angle.

Loads repeat with the pitch of the rollers, so that the load sharing at some positions of the wheel within one
pitch has all rollers at as many places. Between the tabulated angles the slices of a contact line are
interpolated by piecewise cubics without overshoot.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
import scipy

from pyworm.drives.roller_worm.envelope import Array, LineContact, dot
from pyworm.drives.roller_worm.load_sharing import SharedLoad, slices
from pyworm.drives.roller_worm.motion import line_motion
from pyworm.drives.roller_worm.section import WormSection

PLACES_PER_PITCH, PLACES_PER_FACE = 32, 12
"""Positions of the wheel within a pitch at which loads are shared, and further ones while a roller comes to a
face of the section or leaves it; with twice as many spin-up times of `cases/roller_ref.toml` change by
1 %."""

LEAST_LOAD = 1.0
"""Load [N/m] added to the weights of slices, so that lines that just touch have means."""

COLUMNS = (
    *("load", "length", "radius", "curvature"),
    *("rel_across", "rel_along", "sum_across", "round_across", "round_along"),
)
"""What is tabulated of each slice (`Slices`)."""

Loads = Callable[[float], SharedLoad]
"""Wheel angle [rad] -> loads of all rollers of a section while one of them is there."""


@dataclass(frozen=True)
class Slices:
    """Slices of one roller's contact line at one wheel angle; arrays over the slices (`COLUMNS`)."""

    load: Array
    """Load for each length [N/m]."""
    length: Array
    """Length along the line [m]."""
    radius: Array
    """Radius of the roller [m]."""
    curvature: Array
    """Induced curvature across the line [1/m]."""
    rel_across: Array
    """Velocity across the line of the worm relative to a roller that does not turn about its axis [m/s]."""
    rel_along: Array
    """Its component along the line [m/s]."""
    sum_across: Array
    """Sum of both velocities across the line, of such a roller [m/s]."""
    round_across: Array
    """Component across the line of the unit vector round the roller [-]."""
    round_along: Array
    """Component along the line [-]."""

    @property
    def force(self) -> float:
        """Normal load of the roller [N]."""
        return float(np.sum(self.load * self.length))

    def mean(self, values: Array) -> float:
        """Mean of values of the slices, weighted with their loads."""
        return float(np.average(values, weights=self.load + LEAST_LOAD))

    @property
    def ideal(self) -> Array:
        """Speed about its axis at which the roller does not slide round it at each slice [rad/s]."""
        round_ = self.rel_across * self.round_across + self.rel_along * self.round_along
        return round_ / self.radius

    @property
    def rolling(self) -> float:
        """Speed about its axis at which the roller does not slide in the mean of its load [rad/s]."""
        return self.mean(self.ideal * self.radius) / self.mean(self.radius)

    def sliding(self, speed: float) -> tuple[Array, Array]:
        """Velocity of the worm relative to the roller across and along the line [m/s]."""
        surface = speed * self.radius
        return (
            self.rel_across - surface * self.round_across,
            self.rel_along - surface * self.round_along,
        )

    def scaled(self, load: Array, speed: float) -> "Slices":
        """The slices under other loads for each length [N/m], and with all velocities times a factor."""
        return replace(
            self,
            load=load,
            rel_across=speed * self.rel_across,
            rel_along=speed * self.rel_along,
            sum_across=speed * self.sum_across,
        )

    def entrainment(self, speed: float) -> Array:
        """Mean surface velocity across the line [m/s], positive where the worm alone would take it."""
        sense = np.where(self.rel_across < 0, -1.0, 1.0)
        return sense * (self.sum_across + speed * self.radius * self.round_across) / 2


@dataclass(frozen=True)
class RollerPath:
    """A roller's contact line over the wheel angles at which it touches a section."""

    wheel_angles: Array
    """Tabulated wheel angles [rad], rising from the first touch to the last, or the other way about."""
    between: Callable[[float], Array]
    """Wheel angle [rad] -> slices, (`COLUMNS`, slices)."""

    @property
    def touched(self) -> tuple[float, float]:
        """Wheel angles between which the roller touches [rad]."""
        return float(self.wheel_angles[0]), float(self.wheel_angles[-1])

    def at(self, wheel_angle: float) -> Slices:
        """Slices of the contact line at a wheel angle [rad]."""
        return Slices(*self.between(wheel_angle))


def faces_passed(section: WormSection) -> Array:
    """Wheel angles at which a roller begins to touch, touches all along, no longer does, and leaves [rad]."""
    ends = np.array([section.lowest, section.highest])
    before, after = section.faces

    def angle(extreme: Callable[[Array], float], face: float, guess: float) -> float:
        def beyond(wheel_angle: float) -> float:
            return float(extreme(section.along(ends, wheel_angle))) - face

        low, high = guess - section.pitch, guess + section.pitch
        return float(scipy.optimize.brentq(beyond, low, high, xtol=1e-12))

    return np.array(
        [
            angle(np.max, before, section.first),
            angle(np.min, before, section.first),
            angle(np.max, after, section.last),
            angle(np.min, after, section.last),
        ]
    )


def roller_path(section: WormSection, loads: Loads, turning: float) -> RollerPath:
    """The path of a roller through a section while the wheel turns at a speed about -Z [rad/s]."""
    passed = faces_passed(section)
    rows: dict[float, Array] = {}

    def tabulate(shared: SharedLoad, roller: int, contact: LineContact, lengths: Array) -> None:
        angle = float(shared.wheel_angles[roller])
        load = shared.load(contact, roller)
        rows[angle] = _columns(section, contact, lengths, load, turning)

    middle = (section.first + section.last) / 2  # so that a mirrored section has mirrored places
    for offset in np.linspace(0, section.pitch, PLACES_PER_PITCH, endpoint=False).tolist():
        shared = loads(middle + offset)
        contact, lengths = slices(section, shared.wheel_angles)
        for roller in range(len(shared.wheel_angles)):
            tabulate(shared, roller, _roller(contact, roller), lengths[:, roller])
    for begin, end in passed.reshape(2, 2):
        for angle in np.linspace(begin, end, PLACES_PER_FACE + 1)[1:-1].tolist():
            shared = loads(angle)
            tabulate(shared, shared.roller(angle), *slices(section, np.array(angle)))
    inside = [angle for angle in sorted(rows) if passed[0] < angle < passed[-1]]
    table = np.array([rows[angle] for angle in (inside[0], *inside, inside[-1])])
    table[[0, -1], COLUMNS.index("length")] = 0.0
    angles = np.array([passed[0], *inside, passed[-1]])
    return RollerPath(angles, scipy.interpolate.PchipInterpolator(angles, table, axis=0))


def _roller(contact: LineContact, number: int) -> LineContact:
    return LineContact(**{name: part[..., number] for name, part in vars(contact).items()})


def _columns(
    section: WormSection,
    contact: LineContact,
    lengths: Array,
    load: Array,
    turning: float,
) -> Array:
    """The columns of one roller's slices."""
    motion = line_motion(section.envelope, contact, turning, 0.0)
    worm, at_rest = (x * motion.x_axis + y * motion.y_axis for x, y in (motion.worm, motion.roller))
    return np.array(
        [
            load,
            lengths,
            contact.radius,
            contact.curvature,
            dot(worm - at_rest, contact.across),
            dot(worm - at_rest, contact.along),
            dot(worm + at_rest, contact.across),
            dot(contact.around, contact.across),
            dot(contact.around, contact.along),
        ]
    )
