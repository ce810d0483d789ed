"""Surface velocities at a roller's contact line, and the speed of the roller about its own axis.

Velocities are relative to the moving contact line. With t across the line in the tangent plane (t x along =
-n, so that z of a contact frame points from the worm to the roller) the oil is entrained by the components
along t.

A free roller turns at the speed at which the moments about its axis balance: that of the film's shear and
that of its pin's friction. The shear stress of a slice is the oil's flow law at Hertz's mean pressure and at
the rate that sliding in both directions gives across Moes' central film; it acts over Hertz's width.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
import scipy

from pyworm.drives.roller_worm.envelope import (
    Array,
    LineContact,
    RollerEnvelope,
    about_z,
    cross,
    dot,
)
from pyworm.formulas.film import line_groups, moes_line
from pyworm.io import units
from pyworm.io.plain_values import NumberOrZero
from pyworm.io.present import present
from pyworm.materials.body import Body, reduced_modulus
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil

Spinning = Literal["free", "dynamic", "locked", "rolling"]
"""Rotation of the rollers: by the balance of moments, by their equation of motion (`roller_rotation`), none,
or without sliding in the mean."""

MOST_STEPS, ROUNDING = 60, 1e-14
"""Largest number of Newton steps or bisections of a stress, and the relative change at which they end."""


@dataclass(frozen=True)
class LineMotion:
    """Motion of both surfaces at contacts, relative to the contact line."""

    x_axis: Array
    """Unit vector across the contact line, where the worm sweeps to, (3, ...)."""
    y_axis: Array
    """Unit vector along the line: x, y and that from worm to roller are right-handed, (3, ...)."""
    worm: Array
    """Velocity of the worm along x and y, (2, ...) [m/s]."""
    roller: Array
    """Velocity of the roller along x and y, (2, ...) [m/s]."""
    spin: Array
    """Angular velocity of worm and roller about the direction from worm to roller, (2, ...) [rad/s]."""
    round_worm: Array
    """Component of the worm's velocity round the roller's axis, towards growing theta [m/s]."""
    round_roller: Array
    """Component of the roller's velocity round its axis, towards growing theta [m/s]."""
    roller_speed: Array
    """The roller's rotation about its own axis [rad/s]."""

    @property
    def entrainment(self) -> Array:
        """Mean velocity across the contact line [m/s]."""
        return (self.worm[0] + self.roller[0]) / 2

    @property
    def sliding(self) -> Array:
        """Velocity of the worm relative to the roller across and along the line, (2, ...) [m/s]."""
        return self.worm - self.roller


def line_motion(
    envelope: RollerEnvelope, contact: LineContact, wheel_speed: float, roller_speed: Array | float
) -> LineMotion:
    """Motion at contacts by the speeds of the wheel and of rollers about their own axes [rad/s]."""
    wide = (3,) + (1,) * contact.place.ndim
    arm = contact.point - envelope.worm_centre.reshape(wide)
    turn = envelope.worm_turn.reshape(wide) * wheel_speed * np.ones(contact.point.shape)
    worm = cross(turn, arm) - wheel_speed * contact.advance
    roller_speed = np.broadcast_to(roller_speed, contact.place.shape)
    rounding = roller_speed * contact.radius
    roller = (
        -wheel_speed * about_z(contact.point)
        - wheel_speed * contact.advance
        + rounding * contact.around
    )
    side = np.where(dot(worm, contact.across) < 0, -1.0, 1.0)
    # x, y and -n, from the worm to the roller, are right-handed whichever way x points
    x_axis, y_axis = side * contact.across, side * contact.along
    _, _, axis, _ = envelope.axes(contact.wheel_angle)
    wheel_turn = np.zeros(contact.point.shape)
    wheel_turn[2] = -wheel_speed
    return LineMotion(
        x_axis=x_axis,
        y_axis=y_axis,
        worm=np.array([dot(worm, x_axis), dot(worm, y_axis)]),
        roller=np.array([dot(roller, x_axis), dot(roller, y_axis)]),
        spin=np.array(
            [-dot(turn, contact.normal), -dot(wheel_turn + roller_speed * axis, contact.normal)]
        ),
        round_worm=dot(worm, contact.around),
        round_roller=dot(roller, contact.around),
        roller_speed=roller_speed,
    )


@dataclass(frozen=True)
class FilmTraction:
    """Shear of a line contact's film in closed form."""

    oil: Oil
    """The oil."""
    bodies: tuple[Body, Body]
    """Worm and rollers."""

    def film(self, load: Array, curvature: Array, entrainment: Array) -> Array:
        """Moes' central film [m] of slices."""
        viscosity = self.oil.viscosity
        groups = line_groups(
            1 / curvature,
            load,
            reduced_modulus(*self.bodies),
            np.abs(entrainment),
            viscosity.eta0,
            viscosity.alpha,
        )
        return np.asarray(moes_line(groups).central)

    def slices(self, load: Array, curvature: Array) -> tuple[Array, Array, Array]:
        """Hertz's width [m] of slices, their mean pressure [Pa] and the viscosity at that [Pa s]."""
        width = 2 * np.sqrt(8 * load / (np.pi * reduced_modulus(*self.bodies) * curvature))
        viscosity = np.vectorize(self.oil.viscosity, otypes=[float])(load / width)
        return width, load / width, viscosity


def flow_stress(flow: FlowLaw, viscosity: Array, pressure: Array, rate: Array) -> Array:
    """The stress [Pa] at which oil of a viscosity [Pa s] shears at a rate [1/s]; see `FlowLaw`."""
    stress = flow.stress * np.exp(flow.stress_pressure * pressure)
    limit = np.maximum(flow.limit + flow.limit_pressure * pressure, 1e5)
    newtonian: Array = viscosity * rate
    if flow.law == "newtonian":
        return newtonian
    if flow.law == "eyring":
        return stress * np.arcsinh(newtonian / stress)
    if flow.law == "bair-winer":
        return limit * -np.expm1(-newtonian / limit)
    if flow.law == "carreau":
        return newtonian * (1 + (newtonian / stress) ** 2) ** ((flow.exponent - 1) / 2)
    if flow.law == "eyring-limited":
        return _limited_eyring_stress(newtonian, stress, limit, 2 * flow.exponent)
    return np.vectorize(flow.stress_at, otypes=[float])(newtonian, pressure)


def _limited_eyring_stress(newtonian: Array, onset: Array, limit: Array, power: float) -> Array:
    """The stress tau with onset sinh(tau/onset) = newtonian [1 - (tau/limit)^power], all in Pa.

    Newton's method from above, where the difference is mostly convex; bisections where a step leaves the
    bracket.
    """
    low = np.zeros_like(newtonian)
    high = np.minimum(limit, onset * np.arcsinh(newtonian / onset))
    stress: Array = high
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        for _ in range(MOST_STEPS):
            held = (stress / limit) ** power
            excess = onset * np.sinh(stress / onset) - newtonian * (1 - held)
            slope = np.cosh(stress / onset) + newtonian * power * held / stress
            fast = excess > 0
            low, high = np.where(fast, low, stress), np.where(fast, stress, high)
            before, stress = stress, stress - excess / slope
            inside = (low <= stress) & (stress <= high)
            stress = np.where(inside, stress, (low + high) / 2)
            if np.all(np.abs(stress - before) <= ROUNDING * before):
                break
    return stress


@dataclass(frozen=True)
class Pin:
    """The pin that a roller turns on."""

    radius: units.Length
    """Radius of the pin [m]."""
    friction: NumberOrZero
    """Friction coefficient between pin and roller [-]."""

    def moment(self, force: Array) -> Array:
        """Largest friction moment [N m] under a load [N]."""
        return self.friction * self.radius * force


FREE_OF_FRICTION = Pin(0.0, 0.0)
"""A pin that does not brake its roller."""


def roller_speed(
    envelope: RollerEnvelope,
    contact: LineContact,
    lengths: Array,
    loads: Array,
    wheel_speed: float,
    spinning: Spinning,
    traction: FilmTraction,
    pin: Pin = FREE_OF_FRICTION,
) -> float:
    """Speed of a roller about its own axis [rad/s], towards growing theta.

    By slices of its contact line, with their lengths [m] and loads for each length [N/m], and the wheel's
    speed [rad/s]; the film's traction moves a free roller only.
    """
    if spinning == "locked":
        return 0.0
    at_rest = line_motion(envelope, contact, wheel_speed, 0.0)
    rolling = (at_rest.round_worm - at_rest.round_roller) / contact.radius
    arms = loads * lengths * contact.radius
    if spinning == "rolling":
        return float(np.sum(arms * rolling) / np.sum(arms))

    pressed = loads > 0
    contact = LineContact(**{name: part[..., pressed] for name, part in vars(contact).items()})
    lengths, loads, rolling = lengths[pressed], loads[pressed], rolling[pressed]
    width, pressure, viscosity = traction.slices(loads, contact.curvature)
    drag, flow = pin.moment(np.sum(loads * lengths)), present(traction.oil.flow, "oil.shear")

    def moment(speed: float) -> float:
        """Moment of the film on the roller [N m]."""
        motion = line_motion(envelope, contact, wheel_speed, speed)
        slide, total = motion.round_worm - motion.round_roller, np.hypot(*motion.sliding)
        film = traction.film(loads, contact.curvature, motion.entrainment)
        stress = flow_stress(flow, viscosity, pressure, total / film)
        along = np.divide(slide, total, out=np.zeros_like(slide), where=total > 0)
        return float(np.sum(stress * along * width * contact.radius * lengths))

    push = moment(0.0)
    if abs(push) <= drag:
        return 0.0
    sign = np.sign(push)
    # beyond the fastest slice's rolling the film brakes all along
    limit = float(np.max(sign * rolling))
    speed = scipy.optimize.brentq(lambda u: sign * moment(sign * u) - drag, 0.0, limit, rtol=1e-10)
    return float(sign * speed)
