"""Efficiency of a worm mesh both ways as a function of one mean friction coefficient.

With the normal loads F of the tooth pairs, their levers a about the wheel's axis and b of their sliding, and
the sliding speed v over that of the worm, all averaged over a pitch (`tooth_loss`, equation 1),

    T2 = <F a> + mu <F b>,    P = mu <F v>,    eta = T2 w2 / (T2 w2 + P),                                 (1)

and with the power in the other direction, eta' = 1 - P / (T2' w2) with
T2' = <F a> - mu <F b>. Where eta' is not positive the wheel cannot drive the worm: the gear set locks.
"""

from dataclasses import dataclass

import numpy as np

from pyworm.io.on_demand import xarray as xr


@dataclass(frozen=True)
class MeshAtTorque:
    """Loss and yielding of a mesh under its torque."""

    speed: float
    """Speed of the worm [rad/s]."""
    torque: float
    """Torque of the wheel [N m]."""
    ratio: float
    """Speed of the worm over that of the wheel [-]."""
    balance: "TorqueBalance"
    """Balance of torques by friction."""
    transmission_error: float
    """Mean loaded transmission error, turn of the wheel [rad]."""
    transmission_error_range: float
    """Range of that turn over a pitch, peak to peak [rad]."""
    stiffness: float
    """Mean mesh stiffness, torque of the wheel for each of its turn [N m/rad]."""


@dataclass(frozen=True)
class TorqueBalance:
    """Balance of torques and power of the teeth in mesh, the worm driving."""

    drag: float
    """<F b> / <F a>, what friction adds to the torque of the wheel [-]."""
    rubbing: float
    """<F v> / (<F a> w2), what friction takes of the power [-]."""

    def efficiency(self, friction: np.ndarray) -> np.ndarray:
        """Efficiency with the worm driving [-]."""
        turning: np.ndarray = 1 + friction * self.drag
        return turning / (turning + friction * self.rubbing)

    def reverse_efficiency(self, friction: np.ndarray) -> np.ndarray:
        """Efficiency with the wheel driving, at the same loads [-]; negative where the gear set locks."""
        return 1 - friction * self.rubbing / (1 - friction * self.drag)

    def friction(self, efficiency: float) -> float:
        """The mean friction coefficient that gives an efficiency with the worm driving [-]."""
        return (1 - efficiency) / (efficiency * (self.drag + self.rubbing) - self.drag)


def torque_balance(cycle: "xr.Dataset") -> TorqueBalance:
    """The balance of a mesh cycle under load with the worm driving, whichever drives there."""
    turn = -1.0 if cycle.attrs["driver"] == "wheel" else 1.0
    phases, load = cycle["load_phase"].values, cycle["tooth_load"].values

    def whole(values: np.ndarray) -> float:
        return float(np.trapezoid(load * values, phases))

    turning = whole(cycle["lever"].values)
    sliding = whole(cycle["sliding_speed"].values)
    return TorqueBalance(
        drag=turn * whole(cycle["sliding_lever"].values) / turning,
        rubbing=sliding / (turning * float(cycle.attrs["wheel_speed"])),
    )
