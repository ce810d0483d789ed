"""Losses of a worm drive by closed forms, for tests of loss tables and what is made of them."""

import numpy as np

from pyworm.batch.operating_points import Computed
from pyworm.drives.torque_balance import TorqueBalance
from pyworm.result.loss_table import LossTable

BALANCE = TorqueBalance(drag=-0.2, rubbing=5.5)
RATIO = 20.5


def power_law(speed, torque, temperature):
    """Friction that falls with speed and rises with temperature, straight in the table's coordinates."""
    return 0.03 * (speed / 100) ** -0.3 * (torque / 100) ** 0.1 * np.exp(0.01 * (temperature - 333))


def stribeck(speed, torque, temperature):
    """Friction with a transition from boundary to fluid friction."""
    return 0.2 / (1 + (speed / 20) ** 1.5) + 0.4 * power_law(speed, torque, temperature)


class MadeUpSolving:
    """Solving of operating points by a friction law."""

    def __init__(self, friction=power_law):
        self.friction = friction
        self.solved = 0

    def results(self, points):
        found = []
        for point in points:
            operation, content = point.case.tables.operation, point.case.content
            warm = float(content["oil"]["temperature"].split()[0]) + 273.15
            friction = self.friction(operation.worm_speed, operation.wheel_torque, warm)
            efficiency = float(BALANCE.efficiency(friction))
            loss = (1 - efficiency) * 100.0
            found.append(
                {
                    "efficiency": Computed(efficiency, 1e-4),
                    "power_loss": Computed(loss, 0.02 * loss),
                }
            )
        self.solved += len(found)
        return found


def made_up_table(friction=stribeck):
    """A table over 3 speeds, 2 torques and 2 temperatures; at the slowest the wheel cannot drive."""
    speeds, torques = np.array([2.0, 40.0, 150.0]), np.array([50.0, 300.0])
    temperatures = np.array([313.15, 353.15])
    rubbed = friction(speeds[:, None, None], torques[None, :, None], temperatures[None, None])
    return LossTable(
        name="unit-100",
        title='A unit of "100 mm"',
        ratio=RATIO,
        speeds=speeds,
        torques=torques,
        temperatures=temperatures,
        friction=rubbed,
        efficiency=BALANCE.efficiency(rubbed),
        reverse_efficiency=BALANCE.reverse_efficiency(rubbed),
        other_torque=np.broadcast_to(np.array([0.3, 0.4, 0.6])[:, None, None], rubbed.shape),
        transmission_error=np.array([5e-5, 1.5e-4]),
        transmission_error_range=np.array([1e-5, 3e-5]),
        stiffness=np.array([1.6e6, 3.1e6]),
        solved=np.ones(rubbed.shape, bool),
        emulation_error=0.0,
        solution_error=0.02,
    )
