"""Sharing of the torque among rollers: rigid worm and wheel, elastic contacts in slices.

The wheel turns by Theta against the worm beyond the unloaded mesh. At a slice of a contact line with the
lever r = (P x n) . e_z about the wheel's axis the surfaces then approach by

    delta = Theta r - relief - F / k,                                                            (1)

relief being that of the crown and F / k the deflection of pin and thread under the roller's whole load F.
Slices are independent of each other; the load w for each length of one follows from

    delta = w (1 - nu_1^2) / (pi E_1) [1 + 2 ln(2 l / b)]                                        (2)
          + 2 w (1 - nu_2^2) / (pi E_2) [ln(4 rho / b) - 1/2],   b^2 = 8 w / (pi E' k_v),

the first line being a strip of the contact's length l on a half-space (the thread), the second the part of a
cylinder between its contact and its axis (the roller; K. L. Johnson, Contact Mechanics (1985), equation
5.57). Theta is where the moments of all slices about the wheel's axis balance the torque. By the meshing
equation the moment about the worm's axis is then smaller by the ratio, slice by slice.
"""

from dataclasses import dataclass, replace
from math import pi

import numpy as np

from pyworm.drives.roller_worm.envelope import Array, LineContact, cross
from pyworm.drives.roller_worm.section import WormSection
from pyworm.drives.torque_sharing import Sharing, rising_root
from pyworm.materials.body import Body, reduced_modulus

SLICES = 25
"""Slices of a contact line (Gauss and Legendre's points)."""

_POINTS, _WEIGHTS = np.polynomial.legendre.leggauss(SLICES)

POINTS = (_POINTS + 1) / 2
"""Fractions of the contact line at which slices are."""

ROUNDS = 30
"""Largest number of Newton steps for a load, and of steps for the deflection of the pins."""

RELATIVE_TOLERANCE = 1e-12
"""Relative change at which the iteration ends."""


@dataclass(frozen=True)
class Compliance:
    """Compliance of rollers, pins and thread."""

    bodies: tuple[Body, Body]
    """Worm and rollers."""
    stiffness: float = float("inf")
    """Stiffness of a roller's pin and the thread behind it together [N/m]; infinite if rigid."""

    def half_width(self, load: Array, curvature: Array) -> Array:
        """Hertz's half-width b of slices [m] under a load for each length [N/m]."""
        return np.sqrt(8 * load / (pi * reduced_modulus(*self.bodies) * curvature))

    def approach(self, load: Array, curvature: Array, radius: Array, length: Array) -> Array:
        """Approach of slices [m] under a load for each length [N/m], equation 2."""
        with np.errstate(divide="ignore", invalid="ignore"):
            per_load, _ = self._per_load(load, curvature, radius, length)
            return np.where(load > 0, load * per_load, 0.0)

    def load(self, approach: Array, curvature: Array, radius: Array, length: Array) -> Array:
        """Load for each length of slices [N/m] at an approach [m]; zero where they are apart."""
        # the approach is concave over the load: each step ends below the root, the first one above zero
        pressed = np.maximum(approach, 0.0)
        load: Array = pressed * reduced_modulus(*self.bodies) / 5
        with np.errstate(divide="ignore", invalid="ignore"):
            for _ in range(ROUNDS):
                per_load, fall = self._per_load(load, curvature, radius, length)
                new = (pressed - fall * load) / (per_load - fall)
                change = np.max(np.abs(new - load)[pressed > 0] / new[pressed > 0], initial=0.0)
                load = np.where(pressed > 0, new, 0.0)
                if change < RELATIVE_TOLERANCE:
                    break
        return load

    def _per_load(
        self, load: Array, curvature: Array, radius: Array, length: Array
    ) -> tuple[Array, Array]:
        """Approach for each load, and its fall with the logarithm of the load [m2/N].

        The bracket of a line shorter than its width is held at 1.
        """
        thread, roller = (
            (1 - body.poisson_ratio**2) / (pi * body.youngs_modulus) for body in self.bodies
        )
        half_width = self.half_width(load, curvature)
        strip = np.maximum(1 + 2 * np.log(2 * length / half_width), 1.0)
        cylinder = np.maximum(2 * np.log(4 * radius / half_width) - 1, 1.0)
        fall = thread * (strip > 1) + roller * (cylinder > 1)
        return thread * strip + roller * cylinder, fall


@dataclass(frozen=True)
class SharedLoad:
    """Loads of the rollers of one section at one instant."""

    section: WormSection
    """The section."""
    compliance: Compliance
    """Compliance of rollers, pins and thread."""
    wheel_angles: Array
    """Wheel angles of the rollers that touch [rad], (rollers,)."""
    turn: float
    """Theta, the wheel's turn by the load [rad]; 0 with equal shares."""
    yielding: Array
    """Deflection of pin and thread [m], (rollers,)."""
    uniform: float | None
    """The load for each length with equal shares [N/m]; else None."""
    lengths: Array
    """Lengths of the rollers' contact lines [m], (rollers,)."""
    forces: Array
    """Normal load of each roller [N], (rollers,)."""

    def roller(self, wheel_angle: float) -> int:
        """Index of the roller at a wheel angle [rad]."""
        return int(np.argmin(np.abs(self.wheel_angles - wheel_angle)))

    def load(self, contact: LineContact, roller: int) -> Array:
        """Load for each length of the contact line [N/m] at contacts of one roller."""
        if self.uniform is not None:
            return np.full(contact.place.shape, self.uniform)
        return _load(self, contact, self.turn, self.yielding[roller], self.lengths[roller])


def slices(section: WormSection, wheel_angles: Array) -> tuple[LineContact, Array]:
    """Slices of contact lines, (SLICES, ...) at wheel angles (...), and their lengths [m]."""
    low, high = span = section.span(wheel_angles)
    shape = (SLICES,) + (1,) * np.ndim(wheel_angles)
    contact = section.within(span, wheel_angles, (_POINTS.reshape(shape) + 1) / 2)
    return contact, _WEIGHTS.reshape(shape) / 2 * (high - low) * contact.stretch


def lever(contact: LineContact) -> Array:
    """Lever of the normal load about the wheel's axis [m], positive where it drives the wheel."""
    return cross(contact.point, contact.normal)[2]


def worm_lever(section: WormSection, contact: LineContact) -> Array:
    """Lever of the normal load about the worm's axis [m], positive where it resists the worm."""
    envelope = section.envelope
    arm = contact.point - envelope.worm_centre.reshape((3,) + (1,) * contact.place.ndim)
    return -envelope.hand * cross(arm, contact.normal)[0]


def share(
    section: WormSection,
    compliance: Compliance,
    wheel_angle: float,
    torque: float,
    sharing: Sharing = "elastic",
) -> SharedLoad:
    """Share a torque among the rollers of a section, one of which is at a wheel angle [rad].

    The torque is absolute, between worm section and wheel, about the wheel's axis [N m]; 0 leaves no load.
    Shared equally the load for each length is the same everywhere.
    """
    angles = section.in_mesh(wheel_angle)
    contact, lengths = slices(section, angles)
    arm = np.abs(lever(contact))
    none, length = np.zeros(angles.shape), lengths.sum(axis=0)
    if sharing == "equal":
        uniform = torque / float(np.sum(arm * lengths))
        return SharedLoad(section, compliance, angles, 0.0, none, uniform, length, uniform * length)
    shared = SharedLoad(section, compliance, angles, 0.0, none, None, length, none)
    if torque == 0:
        return shared

    def shared_loads(turn: float, yielding: Array) -> tuple[Array, Array]:
        """Loads of the slices, and deflection of pin and thread, at Theta."""
        if np.isinf(compliance.stiffness):
            return _load(shared, contact, turn, none, length), none
        for _ in range(ROUNDS):
            loads = _load(shared, contact, turn, yielding, length)
            yields = np.sum(loads * lengths, axis=0) / compliance.stiffness
            # a slice's load goes nearly with its approach, of which the yielding is a part
            pressed = np.where(loads > 0, turn * arm - yielding, np.inf)
            slope = np.sum(loads / pressed * lengths, axis=0) / compliance.stiffness
            step = (yields - yielding) / (1 + slope)
            yielding = yielding + step
            if np.max(np.abs(step)) < RELATIVE_TOLERANCE * turn * np.max(arm):
                break
        return _load(shared, contact, turn, yielding, length), yielding

    def excess_torque(turn: float) -> float:
        return float(np.sum(arm * shared_loads(turn, none)[0] * lengths)) - torque

    turn = rising_root(excess_torque, torque / (np.sum(arm**2 * lengths) * _stiffness(compliance)))
    loads, yielding = shared_loads(turn, none)
    forces = np.sum(loads * lengths, axis=0)
    return replace(shared, turn=turn, yielding=yielding, forces=forces)


def _stiffness(compliance: Compliance) -> float:
    """Approximate load of a slice for each length and approach [N/m2], an initial guess."""
    return reduced_modulus(*compliance.bodies) / 5


def _load(
    shared: SharedLoad, contact: LineContact, turn: float, yielding: Array, length: Array
) -> Array:
    """Loads of slices at Theta, equations 1 and 2."""
    relief = shared.section.envelope.profile.relief(contact.place)
    approach = turn * np.abs(lever(contact)) - relief - yielding
    return shared.compliance.load(approach, contact.curvature, contact.radius, length)
