"""Loss table of a worm drive over speed, torque and oil temperature, for simulators of drive trains."""

import csv
import io
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from pyworm.formulas.arrays import Array, Flags
from pyworm.formulas.unit_factors import RPM, ZERO_CELSIUS


@dataclass(frozen=True)
class LossTable:
    """Losses and yielding of the mesh of a worm drive; arrays over (speeds, torques, temperatures)."""

    name: str
    """Name of the case."""
    title: str
    """Its title."""
    ratio: float
    """Speed of the worm over that of the wheel [-]."""
    speeds: Array
    """Speeds of the worm, rising [rad/s]."""
    torques: Array
    """Torques of the wheel, rising [N m]."""
    temperatures: Array
    """Temperatures of the oil at the inlet, rising [K]."""
    friction: Array
    """Mean friction coefficient of the teeth [-]."""
    efficiency: Array
    """Efficiency of the teeth with the worm driving [-]."""
    reverse_efficiency: Array
    """Efficiency of the teeth with the wheel driving [-]; not positive where the gear set locks."""
    other_torque: Array
    """Torque of bearings, seals and churning on the worm [N m]; zero where `[cooling]` gives none."""
    transmission_error: Array
    """Mean loaded transmission error, turn of the wheel, by torque [rad]."""
    transmission_error_range: Array
    """Range of that turn over a pitch, by torque [rad]."""
    stiffness: Array
    """Mean mesh stiffness about the wheel's axis, by torque [N m/rad]."""
    solved: Flags
    """Which points were solved; the others are emulated."""
    emulation_error: float
    """Relative error of friction and loss at points that were not solved [-]."""
    solution_error: float
    """Largest relative numerical error of the loss of the solved points [-]."""

    @property
    def locked(self) -> Flags:
        """Where the wheel cannot drive the worm."""
        return self.reverse_efficiency <= 0

    @property
    def worm_torque(self) -> Array:
        """Torque of the worm that drives, for the teeth alone [N m]."""
        found: Array = self.torques[None, :, None] / (self.ratio * self.efficiency)
        return found

    @property
    def friction_torque(self) -> Array:
        """Friction torque of the teeth on the worm [N m]."""
        found: Array = self.worm_torque * (1 - self.efficiency)
        return found

    @property
    def efficiency_error(self) -> Array:
        """Error of the efficiency by the interpolation [-], none at solved points.

        Near locking that of the efficiency with the wheel driving is up to twice as large.
        """
        found: Array = np.where(self.solved, 0.0, self.emulation_error) * (1 - self.efficiency)
        return found

    def rows(self) -> Iterator[dict[str, float | bool]]:
        """Rows of the table by name and unit; the temperature changes fastest."""
        for place in np.ndindex(self.efficiency.shape):
            speed, torque, temperature = place
            yield {
                "worm_speed_rpm": float(self.speeds[speed] * RPM),
                "wheel_torque_N_m": float(self.torques[torque]),
                "oil_temperature_C": float(self.temperatures[temperature] - ZERO_CELSIUS),
                "efficiency": float(self.efficiency[place]),
                "reverse_efficiency": float(self.reverse_efficiency[place]),
                "efficiency_error": float(self.efficiency_error[place]),
                "locked": bool(self.locked[place]),
                "friction_coefficient": float(self.friction[place]),
                "worm_torque_N_m": float(self.worm_torque[place]),
                "friction_torque_N_m": float(self.friction_torque[place]),
                "other_torque_N_m": float(self.other_torque[place]),
                "transmission_error_rad": float(self.transmission_error[torque]),
                "transmission_error_range_rad": float(self.transmission_error_range[torque]),
                "mesh_stiffness_N_m_rad": float(self.stiffness[torque]),
                "solved": bool(self.solved[place]),
            }

    def as_csv(self) -> str:
        """The table as comma-separated values."""
        text = io.StringIO()
        rows = list(self.rows())
        writer = csv.DictWriter(text, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow(
                {
                    key: int(value) if isinstance(value, bool) else f"{value:.9g}"
                    for key, value in row.items()
                }
            )
        return text.getvalue()
