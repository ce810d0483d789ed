"""Sharing of the torque among the tooth pairs of a worm drive.

Worm and wheel are rigid except for their contacts and, if a stiffness is given, thread and tooth. The load
turns the wheel by Theta behind its ideal angle, threads / teeth times that of the worm. The normal of the
pair k has lever_k about the wheel's axis (of involute worms all have the same), so it approaches by

    delta_k = lever_k (Theta + ahead_k),    delta_k = delta_dry(F_k, phase_k) + F_k / stiffness - lift_k,  (1)

ahead_k being the transmission error of pair k, the angle of the wheel ahead of its ideal one if that pair
alone led it without load, and lift_k the increase of the bodies' separation by its film under the same load.
The load F_k follows from dry contacts of the loaded gap, which at the ends of the mesh cycle, and a little
beyond, rest on a tooth's edge. Lifts are those of solved films, where there are any; film formulas do not
apply to a contact entrained along its length, and had errors of 100 % in the difference of two lifts
(docs/theory/zi-worm.md). Theta is where the moments of all pairs balance the torque, friction included: the
sliding drags the wheel's tooth along with the worm by friction F_k, so that about an axis

    torque = sum over k of F_k [arm of the normal + friction (arm of the sliding)].                       (2)
"""

from dataclasses import dataclass
from math import inf
from typing import Literal

import numpy as np
import scipy

from pyworm.drives.torque_sharing import Sharing, rising_root
from pyworm.drives.worm.loads.tooth_compliance import ToothSprings
from pyworm.formulas.arrays import Array

Shaft = Literal["worm", "wheel"]

SHAFTS: tuple[Shaft, ...] = ("worm", "wheel")


@dataclass(frozen=True)
class Transmission:
    """Torque carried by the teeth in mesh, and its sharing."""

    torque: float
    """Torque [N m]."""
    shaft: Shaft
    """Shaft of that torque: "worm" or "wheel"."""
    sharing: Sharing = "elastic"
    """Rule: "elastic", or "equal" loads of pairs whose contact points lie on both teeth."""
    friction: float = 0.0
    """Coefficient of friction in the balance of forces: the teeth's loss over load times sliding [-]."""
    stiffness: float = inf
    """Stiffness of thread and wheel tooth together, beyond their contact [N/m]; infinite if rigid."""
    lifts: tuple[tuple[float, float], ...] = ()
    """Phases, rising, and the lift of the bodies by the film there [m]; empty where no film is solved."""

    def lift(self, phases: Array) -> Array:
        """Lift of the bodies by the film [m], constant beyond the first and the last known phase."""
        if len(self.lifts) < 2:
            return np.full(np.shape(phases), self.lifts[0][1] if self.lifts else 0.0)
        known, lifts = zip(*self.lifts, strict=True)
        return scipy.interpolate.PchipInterpolator(known, lifts)(
            np.clip(phases, known[0], known[-1])
        )


@dataclass(frozen=True)
class SharedLoad:
    """Loads of the tooth pairs at one instant."""

    phases: Array
    """Phases of the pairs, one pitch apart, (pairs,); beyond 0 and 1 they touch at an edge."""
    forces: Array
    """Normal load of each [N], (pairs,)."""
    turn: float
    """Theta, angle of the wheel behind its ideal one [rad]; 0 with equal shares."""

    def force(self, phase: float) -> float:
        """Normal load of the pair at a phase [N]."""
        return float(self.forces[np.argmin(np.abs(self.phases - phase))])


@dataclass(frozen=True)
class Arms:
    """Moment arms [m] of the forces on tooth pairs at some phases."""

    worm_normal: Array
    """Arm of the normal load about the worm's axis, positive where it resists the turning worm."""
    wheel_normal: Array
    """Arm of the normal load about the wheel's axis, positive where it drives the turning wheel."""
    worm_sliding: Array
    """Arm about the worm's axis of a force along the sliding of the worm against the wheel, likewise."""
    wheel_sliding: Array
    """Arm about the wheel's axis of a force along the sliding of the worm against the wheel, likewise."""

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
    levers: Array,
    ahead: Array,
    springs: ToothSprings | None,
) -> SharedLoad:
    """Share a torque among tooth pairs.

    Arguments are arrays over the pairs that may touch: `arms` torque for each normal load [m], `levers` of
    their normals about the wheel's axis [m], `ahead` the transmission error if each alone led the wheel
    [rad]; without springs the shares are equal.
    """
    if transmission.sharing == "equal":
        on_teeth = (phases >= 0) & (phases <= 1)
        shares = on_teeth * transmission.torque / np.sum(arms * on_teeth)
        return SharedLoad(phases, shares, 0.0)

    if springs is None:
        raise ValueError("elastic sharing needs the compliance of the pairs")
    pairs = [springs.at(phase) for phase in phases]

    lifts = transmission.lift(phases)

    def forces(turn: float) -> Array:
        approaches = levers * (turn + ahead) + lifts
        return np.array(
            [pair.load(approach) for pair, approach in zip(pairs, approaches, strict=True)]
        )

    touching = np.array([pair.separation for pair in pairs])
    first_touch = -float((ahead + (lifts - touching) / levers).max())

    def excess(further: float) -> float:
        return float(np.sum(arms * forces(first_touch + further))) - transmission.torque

    pressed = springs.approaches[:, -1] - springs.separations
    guess = float(pressed.min() / np.max(levers))
    turn = first_touch + rising_root(excess, guess)
    return SharedLoad(phases, forces(turn), turn)
