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
(docs/theory/zi-worm.md). Theta is where the moments of all pairs balance the torque, friction
included: the sliding drags the wheel's tooth along with the worm by friction F_k, so that about an axis

    torque = sum over k of F_k [arm of the normal + friction (arm of the sliding)].                       (2)
"""

from dataclasses import dataclass
from math import inf
from typing import Literal

import numpy as np
from scipy.interpolate import PchipInterpolator

from pyworm.drives.torque_sharing import Sharing, rising_root
from pyworm.drives.zi_worm.tooth_compliance import ToothSprings
from pyworm.scene.contact import Array

Shaft = Literal["worm", "wheel"]


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
