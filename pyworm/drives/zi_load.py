"""How the tooth pairs of a ZI worm drive share its torque.

Worm and wheel are rigid but for their contacts and, if a stiffness is given, thread and tooth. The load turns
the wheel by Theta behind its ideal angle, threads / teeth times that of the worm. Every flank normal has the
same lever about the wheel's axis, so the pair k approaches by

    delta_k = lever (Theta + ahead_k),     delta_k = delta_dry(F_k, phase_k) + F_k / stiffness - lift_k,  (1)

ahead_k being how far the wheel would be ahead if pair k alone led it, without load (the transmission error),
lift_k how much farther its film holds the bodies apart than they would be under the same load without oil.
The load F_k follows from dry contacts of the loaded gap, which at the ends of the mesh cycle, and a
little beyond, rest on a tooth's edge; lifts from solved films, once there are some: film formulas are not
made for a contact entrained along its length, and got the difference of two lifts wrong by as much as it is
(docs/drives/zi-worm.md). Theta is where the moments of all pairs balance the torque, friction
included: the sliding drags the wheel's tooth along with the worm by friction F_k, so that about an axis

    torque = sum over k of F_k [arm of the normal + friction (arm of the sliding)].                       (2)
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from math import inf
from typing import Literal

import numpy as np
from scipy.interpolate import PchipInterpolator

from pyworm import kernels
from pyworm.drives.torque_balance import Sharing, rising_root
from pyworm.formulas.hertz import hertz
from pyworm.scene import Array, Gap

Shaft = Literal["worm", "wheel"]

BEYOND = 0.24
"""Phases before and after the mesh cycle in which a loaded pair may still touch at an edge of a tooth."""

_END = np.array([-BEYOND, -0.18, -0.12, -0.08, *np.arange(-0.06, 0.09, 0.02)])

SPRING_PHASES = np.array([*_END, *np.arange(0.1, 0.95, 0.1), *(1 - _END[::-1])])
"""Phases at which dry contacts are solved: dense where an edge comes into the contact."""

LOAD_SHARES = np.array([2e-3, 0.02, 0.1, 0.3, 0.6, 1.0])
"""Loads at which they are, as shares of the whole."""

CELLS = 96, 48
"""Cells of their grid along and across the contact: leaves 0.5 % in a load, less in shares of it."""

SEARCH_CELLS = 48, 24
"""The same of the first look for the least gap, on which their window is centred."""

LONGEST_RATIO = 1e3
"""Ratio of the radii beyond which a contact counts as that long: a line contact ends with the teeth."""

HALF_SIDES = 1.7, 2.2
"""Half sides of their window in Hertz's semi-axes under the whole load."""

DRY_TOLERANCE = 1e-4


@dataclass(frozen=True)
class Transmission:
    """What the teeth carry together.

    Attributes
    ----------
    torque : float
        Torque [N m].
    shaft : str
        Whose it is: "worm" or "wheel".
    sharing : str
        "elastic", or "equal": the same load on each pair whose contact point lies on both teeth.
    friction : float
        Friction by which the forces are balanced: the teeth's loss over load times sliding [-].
    stiffness : float
        Of a thread and a wheel's tooth together beyond their contact [N/m]; inf where they are rigid.
    lifts : tuple of tuple of float
        Phases, rising, and how far films lift the bodies there [m]; none where no film has been solved.
    """

    torque: float
    shaft: Shaft
    sharing: Sharing = "elastic"
    friction: float = 0.0
    stiffness: float = inf
    lifts: tuple[tuple[float, float], ...] = ()

    def lift(self, phases: Array) -> Array:
        """How far films lift the bodies [m], beyond the first and the last phase known as far as there."""
        if len(self.lifts) < 2:
            return np.full(np.shape(phases), self.lifts[0][1] if self.lifts else 0.0)
        known, lifts = zip(*self.lifts, strict=True)
        return PchipInterpolator(known, lifts)(np.clip(phases, known[0], known[-1]))


@dataclass(frozen=True)
class ToothSprings:
    """Approach of one tooth pair over phase and load.

    Attributes
    ----------
    phases : ndarray
        Where the pair touches under load at all, (phases,).
    loads : ndarray
        Normal loads [N], (loads,).
    separations : ndarray
        Least gap between the teeth without load when the flanks beyond their ends would touch [m], (phases,).
    approaches : ndarray
        Approach [m] from that instant, (phases, loads).
    """

    phases: Array
    loads: Array
    separations: Array
    approaches: Array

    @cached_property
    def _separation(self) -> PchipInterpolator:
        return PchipInterpolator(self.phases, self.separations, extrapolate=False)

    @cached_property
    def _pressed(self) -> PchipInterpolator:
        """Logarithm of the approach beyond the first touch."""
        pressed = self.approaches - self.separations[:, None]
        return PchipInterpolator(self.phases, np.log(pressed), extrapolate=False)

    def at(self, phase: float) -> "ToothSpring":
        """The pair at a phase; beyond the last ones it never touches."""
        if not self.phases[0] <= phase <= self.phases[-1]:
            return ToothSpring(inf, None)
        # splines go through the loads solved, and on along the power that holds there
        pressed, loads = self._pressed(phase), np.log(self.loads)
        step = np.array([-20.0, 20.0])
        powers = np.diff(loads)[[0, -1]] / np.diff(pressed)[[0, -1]]
        far = loads[[0, -1]] + powers * step
        pressed = np.concatenate(([pressed[0] - 20], pressed, [pressed[-1] + 20]))
        curve = PchipInterpolator(pressed, np.concatenate((far[:1], loads, far[1:])))
        return ToothSpring(float(self._separation(phase)), curve)


@dataclass(frozen=True)
class ToothSpring:
    """Normal load of one tooth pair at one phase over its approach.

    Attributes
    ----------
    separation : float
        Approach at which it touches [m]; inf where it never does.
    curve : callable or None
        Logarithm of the approach from there [ln m] -> logarithm of the load [ln N].
    """

    separation: float
    curve: PchipInterpolator | None

    def load(self, approach: float) -> float:
        """Normal load [N] at an approach [m]."""
        pressed = approach - self.separation
        return float(np.exp(self.curve(np.log(pressed)))) if pressed > 0 else 0.0


@dataclass(frozen=True)
class SharedLoad:
    """How the tooth pairs share the torque at one instant.

    Attributes
    ----------
    phases : ndarray
        Of the pairs, one pitch apart, (pairs,); beyond 0 and 1 they touch at an edge.
    forces : ndarray
        Normal load of each [N], (pairs,).
    turn : float
        Theta, how far the wheel is behind its ideal angle [rad]; 0 with equal shares.
    """

    phases: Array
    forces: Array
    turn: float

    def force(self, phase: float) -> float:
        """Normal load of the pair at a phase [N]."""
        return float(self.forces[np.argmin(np.abs(self.phases - phase))])


def tooth_springs(
    gap_at: Callable[[float], Gap],
    radii_at: Callable[[float], tuple[float, float]],
    reduced_modulus: float,
    whole_load: float,
    stiffness: float,
    longest: float,
) -> ToothSprings:
    """Dry contacts of one tooth pair over its mesh cycle and a little beyond.

    Parameters
    ----------
    gap_at, radii_at : callable
        Phase -> undeformed gap over the tangent plane, and relative radii of curvature [m].
    reduced_modulus, whole_load, stiffness : float
        E' [Pa], load of all pairs together [N], stiffness beyond the contact [N/m].
    longest : float
        Half side of the window that no contact exceeds [m].
    """
    loads = LOAD_SHARES * whole_load
    phases, separations, approaches = [], [], []
    for phase in SPRING_PHASES:
        radii = radii_at(float(np.clip(phase, 0, 1)))
        placed = placed_gap(gap_at(float(phase)), radii, whole_load, reduced_modulus, longest)
        if placed is None:
            continue
        phases.append(phase)
        separations.append(max(float(placed.gap[placed.covered].min()), 0.0))
        pressure = placed.covered.astype(float)
        row = []
        for load in loads[::-1]:
            dry = placed.pressed(load, reduced_modulus, pressure)
            pressure = dry.pressure
            row.append(dry.approach + load / stiffness)
        approaches.append(row[::-1])
    return ToothSprings(np.array(phases), loads, np.array(separations), np.array(approaches))


@dataclass(frozen=True)
class PlacedGap:
    """A tooth pair's gap on a grid about the place where it is least.

    Attributes
    ----------
    x, y : ndarray
        Nodes along the axes of the tangent plane [m].
    gap, covered : ndarray
        Undeformed gap [m] and where both teeth exist, (x, y).
    """

    x: Array
    y: Array
    gap: Array
    covered: Array

    def pressed(self, load: float, reduced_modulus: float, guess: Array) -> kernels.DryContact:
        """The dry contact under a load [N], from a first guess of the pressure."""
        steps = self.x[1] - self.x[0], self.y[1] - self.y[0]
        return kernels.dry_contact(
            self.gap, self.covered, *steps, reduced_modulus, load, guess, DRY_TOLERANCE
        )


def placed_gap(
    gap: Gap, radii: tuple[float, float], load: float, reduced_modulus: float, longest: float
) -> PlacedGap | None:
    """A gap where a load [N] presses it, arguments as of `tooth_springs`; None where no teeth are."""
    size = hertz(min(radii[0], LONGEST_RATIO * radii[1]), radii[1], load, reduced_modulus)
    sides = [
        min(share * axis, longest)
        for share, axis in zip(HALF_SIDES, (size.semi_axis_x, size.semi_axis_y), strict=True)
    ]
    x, y = _window((0.0, 0.0), sides, SEARCH_CELLS)
    height, covered = gap(*np.meshgrid(x, y, indexing="ij"))
    if not covered.any():
        return None
    i, j = np.unravel_index(np.argmin(np.where(covered, height, inf)), height.shape)
    x, y = _window((x[i], y[j]), sides, CELLS)
    return PlacedGap(x, y, *gap(*np.meshgrid(x, y, indexing="ij")))


def _window(middle: tuple[float, float], sides: list[float], cells: tuple[int, int]) -> list[Array]:
    """Nodes along x and y."""
    return [
        at + np.linspace(-side, side, count + 1)
        for at, side, count in zip(middle, sides, cells, strict=True)
    ]


@dataclass(frozen=True)
class Arms:
    """Moment arms [m] of the forces on tooth pairs at some phases.

    Attributes
    ----------
    worm_normal, wheel_normal : ndarray
        Of the normal load about the worm's and the wheel's axis, positive where it resists the worm and
        drives the wheel in the sense in which the worm turns them.
    worm_sliding, wheel_sliding : ndarray
        Of a force along the sliding of the worm against the wheel, likewise.
    """

    worm_normal: Array
    wheel_normal: Array
    worm_sliding: Array
    wheel_sliding: Array

    def of(self, shaft: Shaft, friction: float) -> Array:
        """Torque of a shaft for each normal load [m], equation 2."""
        normal, sliding = (
            (self.worm_normal, self.worm_sliding)
            if shaft == "worm"
            else (self.wheel_normal, self.wheel_sliding)
        )
        return normal + friction * sliding


def share(
    transmission: Transmission,
    phases: Array,
    arms: Array,
    lever: float,
    ahead: Array,
    springs: ToothSprings | None,
) -> SharedLoad:
    """Share a torque among tooth pairs.

    Parameters
    ----------
    transmission : Transmission
        The torque.
    phases : ndarray
        Of the pairs that may touch, (pairs,).
    arms : ndarray
        Torque for each normal load [m], (pairs,): `Arms.of`.
    lever : float
        Of every flank normal about the wheel's axis [m].
    ahead : ndarray
        How far the wheel would be ahead of its ideal angle if each pair alone led it [rad], (pairs,).
    springs : ToothSprings or None
        The pairs' compliance; None with equal shares.
    """
    if transmission.sharing == "equal":
        on_teeth = (phases >= 0) & (phases <= 1)
        forces = on_teeth * transmission.torque / np.sum(arms * on_teeth)
        return SharedLoad(phases, forces, 0.0)

    pairs = [springs.at(phase) for phase in phases]

    lifts = transmission.lift(phases)

    def forces(turn: float) -> Array:
        approaches = lever * (turn + ahead) + lifts
        return np.array([pair.load(of) for pair, of in zip(pairs, approaches, strict=True)])

    first_touch = -float((ahead + lifts / lever).max())

    def excess(further: float) -> float:
        return float(np.sum(arms * forces(first_touch + further))) - transmission.torque

    guess = float(springs.approaches[:, -1].min()) / lever
    turn = first_touch + rising_root(excess, guess)
    return SharedLoad(phases, forces(turn), turn)
