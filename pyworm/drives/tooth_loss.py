"""Loss and efficiency of tooth pairs that share a torque, over their mesh cycle.

A tooth pair's loss at a phase is its friction times load times sliding. Load and sliding are known over the
whole cycle; friction is known at the solved phases, interpolated between them and constant beyond them.
Where films are transient the ratio to the friction of the transient solve, known at some two hundred phases,
is interpolated instead. All pairs together lose, on average over a pitch,

    P = (1 / pitch) integral of friction load sliding over phase,                                          (1)

and likewise turn the wheel by T2 = (1 / pitch) integral of load (lever + friction lever of the sliding).
Where the torque of a shaft is given, loads are those that make it with the friction found: those of the
cycle, which were shared with an assumed one, are all changed by the same factor.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import scipy

from pyworm.drives.mesh_loss import ContactLoss
from pyworm.io.on_demand import xarray as xr

Array = np.ndarray

FEWEST_PHASES = 3
"""Least number of solved phases for figures of a cycle."""


@dataclass(frozen=True)
class Loss:
    """Loss and efficiency of the teeth, averaged over a pitch."""

    power: float
    """Power lost between all teeth in mesh [W]."""
    scene_error: float
    """Error bar of the power lost by those of the scenes [W]."""
    phase_error: float
    """Error bar of the power lost by the phases, from leaving out every other one [W]."""
    end_error: float
    """Error bar of the power lost before the first and after the last phase, by its range else [W]."""
    friction: float
    """Mean coefficient: loss over load times sliding [-]."""
    wheel_torque: float
    """Mean torque of the wheel [N m]."""
    worm_torque: float
    """Mean torque of the worm [N m]."""
    efficiency: float
    """Power out over power in, as the drive runs [-]."""
    reverse_efficiency: float
    """Efficiency with the power in the other direction, at the same loads and friction [-]."""
    model_error: float | None = None
    """Uncertainty of the power lost by the model of roughness [W]; None where not simulated."""

    @property
    def error(self) -> float:
        """Numerical error bar of the power lost, the sum of all origins [W]."""
        return self.scene_error + self.phase_error + self.end_error

    @property
    def efficiency_error(self) -> float:
        """Error bar of either efficiency [-]: the fraction of loss in the power, times its relative error."""
        return (1 - self.efficiency) * self.error / self.power

    @property
    def efficiency_model_error(self) -> float | None:
        """Uncertainty of either efficiency by the model of roughness [-]; None likewise."""
        if self.model_error is None:
            return None
        return (1 - self.efficiency) * self.model_error / self.power


def cycle_loss(cycle: "xr.Dataset", contacts: Sequence[ContactLoss]) -> Loss:
    """Loss of all teeth, equation 1, from a mesh cycle under load and some contacts by phase."""
    phases = cycle["load_phase"].values
    load, sliding = cycle["tooth_load"].values, cycle["sliding_speed"].values

    def over_pitch(values: Array) -> float:
        return float(np.trapezoid(values, phases) / cycle.attrs["pitch"])

    found, of_half, spread = _friction(phases, sliding, contacts)
    lost_power = found * load * sliding
    power = over_pitch(lost_power)
    turn = -1.0 if cycle.attrs["driver"] == "wheel" else 1.0
    levers = cycle["lever"].values, cycle["sliding_lever"].values
    wheel, reversed_ = (
        over_pitch(load * (levers[0] + sign * found * levers[1])) for sign in (1.0, -1.0)
    )
    worm_speed, wheel_speed = cycle.attrs["worm_speed"], cycle.attrs["wheel_speed"]
    worm = (wheel * wheel_speed + turn * power) / worm_speed
    scale = _to_torque(cycle, wheel, worm)
    power, wheel, worm, reversed_ = (scale * value for value in (power, wheel, worm, reversed_))
    lost_power, load = scale * lost_power, scale * load
    forward = wheel if turn > 0 else reversed_
    back = reversed_ if turn > 0 else wheel
    efficiencies = (
        forward * wheel_speed / (forward * wheel_speed + power),
        1 - power / (back * wheel_speed),
    )
    return Loss(
        power=power,
        scene_error=over_pitch(_uncertain(lost_power, _interpolated(phases, contacts, "error"))),
        phase_error=abs(over_pitch(of_half * load * sliding) - power),
        end_error=over_pitch(lost_power * spread),
        friction=power / over_pitch(load * sliding),
        wheel_torque=wheel,
        worm_torque=worm,
        efficiency=efficiencies[0 if turn > 0 else 1],
        reverse_efficiency=efficiencies[1 if turn > 0 else 0],
        model_error=(
            None
            if all(contact.model is None for contact in contacts)
            else over_pitch(_uncertain(lost_power, _interpolated(phases, contacts, "model")))
        ),
    )


def _to_torque(cycle: "xr.Dataset", wheel: float, worm: float) -> float:
    """Factor of the loads for the torque that is given [-]; 1 where none is."""
    if "torque" not in cycle.attrs:
        return 1.0
    found = wheel if cycle.attrs["torque_shaft"] == "wheel" else worm
    return float(cycle.attrs["torque"]) / found


def _friction(
    phases: Array, sliding: Array, contacts: Sequence[ContactLoss]
) -> tuple[Array, Array, Array]:
    """Friction at all phases; the same by every other contact; its relative range where it is constant."""
    solved = np.array([contact.phase for contact in contacts])
    friction = np.array([contact.power / contact.load for contact in contacts])
    friction /= np.interp(solved, phases, sliding)
    reference, known = _friction_history(contacts, phases, sliding)
    ratio = friction / reference(solved)

    def along(chosen: Array) -> Array:
        inside = np.clip(phases, solved[chosen][0], solved[chosen][-1])
        between = scipy.interpolate.PchipInterpolator(solved[chosen], ratio[chosen])(inside)
        return between * reference(phases)

    all_of_them = np.arange(len(solved))
    half = np.unique([*all_of_them[::2], all_of_them[-1]])
    beyond = (phases < solved[0]) | (phases > solved[-1])
    spread = np.where(known, ratio.max() / ratio.min(), friction.max() / friction.min()) - 1
    return along(all_of_them), along(half), beyond * spread


def _friction_history(
    contacts: Sequence[ContactLoss], phases: Array, sliding: Array
) -> tuple[Callable[[Array], Array], Array]:
    """Friction over phase by transient solves, 1 where there are none, and at which phases it is known."""
    loss_history = np.array(sorted(pair for contact in contacts for pair in contact.loss_history))
    if not len(loss_history):
        return np.ones_like, np.zeros(len(phases), bool)
    phase, over_load = loss_history.T
    friction = over_load / np.interp(phase, phases, sliding)
    return lambda here: np.interp(here, phase, friction), (phases >= phase[0]) & (
        phases <= phase[-1]
    )


def _interpolated(phases: Array, contacts: Sequence[ContactLoss], part: str) -> Array:
    """A relative error of the contacts, or zero, at all phases; infinite ones as far as their neighbours."""
    solved_phases = [contact.phase for contact in contacts]
    errors = np.array([getattr(contact, part) or 0.0 for contact in contacts])
    unknown = np.interp(phases, solved_phases, np.isinf(errors).astype(float)) > 0
    known = np.interp(phases, solved_phases, np.where(np.isinf(errors), 0.0, errors))
    return np.where(unknown, np.inf, known)


def _uncertain(lost_power: Array, error: Array) -> Array:
    """Power lost times its relative error; nothing where no power is lost."""
    uncertain = np.zeros_like(lost_power)
    np.multiply(lost_power, error, out=uncertain, where=lost_power != 0)
    return uncertain
