"""Loss between the teeth by the file of a loss table (`pyworm table`)."""

import csv
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
import scipy

from pyworm.formulas.arrays import Array
from pyworm.formulas.unit_factors import RPM, ZERO_CELSIUS

COLUMNS = "worm_speed_rpm", "wheel_torque_N_m", "oil_temperature_C", "friction_torque_N_m"
"""Columns of the file that are read."""


@dataclass(frozen=True)
class TabulatedLoss:
    """Loss between the teeth over speed, torque and temperature."""

    speeds: Array
    """Speeds of the worm, rising [rad/s]."""
    torques: Array
    """Torques of the wheel, rising [N m]."""
    temperatures: Array
    """Temperatures of the oil, rising [K]."""
    losses: Array
    """Loss at each, (speeds, torques, temperatures) [W]."""

    def at(self, speed: float, torque: float, temperature: float) -> float:
        """The loss [W], its logarithm interpolated; ValueError beyond the speeds and torques.

        Beyond the temperatures it is that at the nearest one.
        """
        for name, value, axis, unit in (
            ("speed", speed * RPM, self.speeds * RPM, "rpm"),
            ("torque", torque, self.torques, "N m"),
        ):
            if not axis[0] * (1 - 1e-6) <= value <= axis[-1] * (1 + 1e-6):
                raise ValueError(
                    f"{name} {value:.6g} {unit} is not between the {axis[0]:.6g} and {axis[-1]:.6g} {unit} "
                    "of the loss table"
                )
        place = np.log(speed), np.log(torque), temperature
        kept = [
            np.clip(each, axis[0], axis[-1]) for each, axis in zip(place, self._axes, strict=True)
        ]
        return float(np.exp(self._curve([kept])[0]))

    @property
    def _axes(self) -> tuple[Array, Array, Array]:
        return np.log(self.speeds), np.log(self.torques), self.temperatures

    @cached_property
    def _curve(self) -> scipy.interpolate.RegularGridInterpolator:
        """Logarithm of the loss; an axis of one value is doubled."""
        axes, losses = [], np.log(self.losses)
        for number, axis in enumerate(self._axes):
            wide = (
                axis if len(axis) > 1 else np.array([axis[0], axis[0] + 1e-9 + 1e-9 * abs(axis[0])])
            )
            losses = losses if len(axis) > 1 else np.repeat(losses, 2, axis=number)
            axes.append(wide)
        return scipy.interpolate.RegularGridInterpolator(axes, losses)


def read_loss_table(path: Path) -> TabulatedLoss:
    """The table of a file; ValueError of another file."""
    if not path.is_file():
        raise ValueError("no such file")
    with path.open(newline="", encoding="utf-8-sig", errors="replace") as file:
        lines = csv.DictReader(file)
        missing = [name for name in COLUMNS if name not in (lines.fieldnames or ())]
        if missing:
            raise ValueError(f"has no column {missing[0]}, as pyworm table writes it")
        try:
            rows = np.array([[float(line[name]) for name in COLUMNS] for line in lines])
        except (TypeError, ValueError):
            raise ValueError("has a cell that is no number") from None
    if not len(rows) or not (np.isfinite(rows).all() and (rows[:, [0, 1, 3]] > 0).all()):
        raise ValueError("speeds, torques and losses must be above 0")
    speeds, torques, temperatures = (np.unique(rows[:, column]) for column in range(3))
    shape = len(speeds), len(torques), len(temperatures)
    if len(rows) != np.prod(shape):
        raise ValueError("has no whole grid of speeds, torques and temperatures")
    order = np.lexsort(rows[:, 2::-1].T)
    losses = (rows[:, 3] * rows[:, 0] / RPM)[order].reshape(shape)
    return TabulatedLoss(speeds / RPM, torques, temperatures + ZERO_CELSIUS, losses)
