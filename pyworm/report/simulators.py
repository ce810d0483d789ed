"""A loss table as files of other simulators: Modelica's loss tables, parameters for MuJoCo and URDF.

Modelica Standard Library 4, `Modelica.Mechanics.Rotational.Components.LossyGear`: its `lossTable` has the
columns speed, eta_mf1, eta_mf2, tau_bf1, tau_bf2. MuJoCo and URDF know a gear ratio, viscous damping and dry
friction of a joint only: both are fitted to the friction torque over speed, at one torque and temperature.
"""

from dataclasses import dataclass
from xml.etree import ElementTree

import numpy as np
import scipy

from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.report.fmu import identifier
from pyworm.result.loss_table import LossTable

LEAST_EFFICIENCY = 1e-6
"""Efficiency with the wheel driving where the teeth lock, by which the Modelica model divides [-]."""


def modelica_rows(table: LossTable, torque: int, temperature: int) -> np.ndarray:
    """Rows of `lossTable` at one torque and temperature, by their numbers, (speeds + 1, 5).

    Speeds are those of flange a, the worm [rad/s]. The torque of bearings, seals and churning, on the worm,
    is multiplied as `LossyGear` defines its columns: tau_bf1 = eta_mf1 tau, tau_bf2 = tau/eta_mf2 [N m].
    From rest on the first row holds. Where the teeth lock nothing passes from the wheel.
    """
    efficiency, reverse, other = (
        values[:, torque, temperature]
        for values in (table.efficiency, table.reverse_efficiency, table.other_torque)
    )
    locked = reverse < LEAST_EFFICIENCY
    passed = np.where(locked, LEAST_EFFICIENCY, reverse)
    columns = [
        table.speeds,
        efficiency,
        passed,
        efficiency * other,
        np.where(locked, other, other / passed),
    ]
    rows = np.stack(columns, axis=1)
    return np.vstack([[0.0, *rows[0, 1:]], rows])


def modelica(table: LossTable) -> str:
    """A Modelica package with a `LossyGear` for each torque and temperature."""
    name = identifier(table.name)
    models = []
    for torque, newton_metres in enumerate(table.torques):
        for temperature, kelvin in enumerate(table.temperatures):
            rows = modelica_rows(table, torque, temperature)
            listed = ";\n      ".join(", ".join(f"{value:.9g}" for value in row) for row in rows)
            called = identifier(f"T{newton_metres:g}Nm_{kelvin - ZERO_CELSIUS:g}degC")
            models.append(
                f'  model {called} "Torque of the wheel {newton_metres:g} N.m, oil at '
                f'{kelvin - ZERO_CELSIUS:g} degC"\n'
                "    extends Modelica.Mechanics.Rotational.Components.LossyGear(\n"
                f"      ratio={table.ratio:.9g},\n"
                f"      lossTable=[{listed}]);\n"
                f"  end {called};\n"
            )
    title = table.title.replace('"', "'")
    return (
        f'package {name} "{title}: flange_a is the worm"\n' + "\n".join(models) + f"end {name};\n"
    )


@dataclass(frozen=True)
class JointFriction:
    """Friction of the wheel's joint at one torque and temperature."""

    torque: float
    """Torque of the wheel [N m]."""
    temperature: float
    """Temperature of the oil [K]."""
    efficiency: float
    """Mean efficiency with the worm driving [-]."""
    dry: float
    """Dry friction [N m]."""
    damping: float
    """Viscous damping [N m s/rad]."""
    deviation: float
    """Largest deviation of the friction torque so fitted [N m]."""
    locked: bool
    """Whether the wheel cannot drive the worm at some of the speeds."""


def joint_friction(table: LossTable) -> JointFriction:
    """Dry friction and damping at the middle torque and temperature, by least squares over speed."""
    torque, temperature = len(table.torques) // 2, len(table.temperatures) // 2
    worm = table.friction_torque + table.other_torque
    # power lost over the speed of the wheel
    loss_torque = worm[:, torque, temperature] * table.ratio
    speeds = table.speeds / table.ratio
    rows = np.stack([np.ones_like(speeds), speeds], axis=1)
    (dry, damping), _ = scipy.optimize.nnls(rows, loss_torque)
    return JointFriction(
        torque=float(table.torques[torque]),
        temperature=float(table.temperatures[temperature]),
        efficiency=float(table.efficiency[:, torque, temperature].mean()),
        dry=float(dry),
        damping=float(damping),
        deviation=float(np.abs(rows @ [dry, damping] - loss_torque).max()),
        locked=bool(table.locked[:, torque, temperature].any()),
    )


def _about(table: LossTable, found: JointFriction) -> str:
    """What the parameters hold for, as a comment."""
    locks = (
        "; the wheel cannot drive the worm here, which friction of a joint does not show"
        if found.locked
        else ""
    )
    return (
        f" {table.name}: at {found.torque:g} N m on the wheel and {found.temperature - ZERO_CELSIUS:g} degC, "
        f"efficiency {found.efficiency:.4f}; friction torque fitted within {found.deviation:.3g} N m{locks} "
    )


def mujoco(table: LossTable) -> str:
    """A MuJoCo model of the wheel on its joint, driven by the worm; its inertia is a placeholder."""
    found, name = joint_friction(table), identifier(table.name)
    root = ElementTree.Element("mujoco", model=name)
    root.append(ElementTree.Comment(_about(table, found)))
    body = ElementTree.SubElement(ElementTree.SubElement(root, "worldbody"), "body", name="wheel")
    joint = {"name": "wheel", "type": "hinge", "axis": "0 0 1"}
    joint |= {"frictionloss": f"{found.dry:.9g}", "damping": f"{found.damping:.9g}"}
    ElementTree.SubElement(body, "joint", joint)
    ElementTree.SubElement(body, "geom", type="cylinder", size="0.1 0.01", mass="1")
    actuator = ElementTree.SubElement(root, "actuator")
    ElementTree.SubElement(actuator, "motor", name="worm", joint="wheel", gear=f"{table.ratio:.9g}")
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode") + "\n"


def urdf(table: LossTable) -> str:
    """A URDF robot of two links, joined by the wheel's joint with its transmission."""
    found, name = joint_friction(table), identifier(table.name)
    root = ElementTree.Element("robot", name=name)
    root.append(ElementTree.Comment(_about(table, found)))
    for link in ("housing", "wheel"):
        ElementTree.SubElement(root, "link", name=link)
    joint = ElementTree.SubElement(root, "joint", name="wheel_joint", type="continuous")
    ElementTree.SubElement(joint, "parent", link="housing")
    ElementTree.SubElement(joint, "child", link="wheel")
    ElementTree.SubElement(joint, "axis", xyz="0 0 1")
    dynamics = {"damping": f"{found.damping:.9g}", "friction": f"{found.dry:.9g}"}
    ElementTree.SubElement(joint, "dynamics", dynamics)
    transmission = ElementTree.SubElement(root, "transmission", name="worm_transmission")
    ElementTree.SubElement(transmission, "type").text = "transmission_interface/SimpleTransmission"
    ends = (("joint", "wheel_joint"), ("actuator", "worm_motor"))
    for kind, end in ends:
        part = ElementTree.SubElement(transmission, kind, name=end)
        ElementTree.SubElement(
            part, "hardwareInterface"
        ).text = "hardware_interface/EffortJointInterface"
        if kind == "actuator":
            ElementTree.SubElement(part, "mechanicalReduction").text = f"{table.ratio:.9g}"
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode") + "\n"
