"""Loss between worm and rollers, by the friction of some contacts of both sections.

The phase runs in proportion to the wheel's angle, so that a section of the angle S with rollers a pitch apart
loses on average S / pitch times the mean over the phase of what one roller loses. Between the solved phases
it is interpolated, beyond the last ones constant; likewise between stations along a contact line.
"""

from collections.abc import Sequence

import numpy as np

from pyworm.drives.mesh_loss import ContactLoss, MeshLoss, largest_model
from pyworm.drives.roller_worm.mesh import RollerMesh
from pyworm.drives.roller_worm.pins import pin_bearing
from pyworm.io.present import present

FEWEST_PHASES = 3
"""Least number of solved phases of each section that carries load."""

SAMPLES = np.linspace(0.0, 1.0, 201)
"""Fractions at which what is interpolated is averaged."""


def roller_mesh_loss(mesh: RollerMesh, contacts: Sequence[ContactLoss]) -> MeshLoss | None:
    """Loss of all rollers in mesh; None for too few phases of a section that carries load."""
    loss = 0.0
    for name, section in mesh.sections.items():
        if mesh.wheel_torque(name) == 0:
            continue
        here = [contact for contact in contacts if contact.section == name]
        phases = sorted({contact.phase for contact in here})
        if len(phases) < FEWEST_PHASES:
            return None
        of_a_roller = [
            _of_a_roller(mesh, [contact for contact in here if contact.phase == phase])
            for phase in phases
        ]
        in_mesh = abs(section.last - section.first) * mesh.rollers.count / (2 * np.pi)
        loss += in_mesh * _mean(phases, of_a_roller)
    losses = pin_bearing(mesh).losses
    pins, along = losses["pins"], losses["sliding along the rollers"]
    words = f"{pins:.4g} W on their pins are in it;" if pins else "their pins,"
    lines = any(contact.station is not None for contact in contacts)
    left_along = f"; sliding along the lines would add {along:.3g} W at most" if lines else ""
    braced = ", braced by the preload" if mesh.preload else ""
    return MeshLoss(
        power=mesh.torque * mesh.speed,
        loss=loss + pins,
        friction=float(
            np.average(
                [contact.friction for contact in contacts],
                weights=[contact.load for contact in contacts],
            )
        ),
        error=max(contact.error for contact in contacts),
        words=f"of all rollers in mesh with the thread{braced}; {words} the bearings and what the oil "
        f"drags are not in it{left_along}",
        model=largest_model(contacts),
    )


def _of_a_roller(mesh: RollerMesh, contacts: Sequence[ContactLoss]) -> float:
    """Power that a roller loses at a phase [W], from its whole contact or from stations of its line."""
    if contacts[0].station is None:
        return contacts[0].power
    line = mesh.state(present(contacts[0].section, "section"), contacts[0].phase, [0.5])
    along = sorted((contact.station, contact.power) for contact in contacts)
    return line.length * _mean(*zip(*along, strict=True))


def _mean(places: Sequence[float], values: Sequence[float]) -> float:
    """Mean from 0 to 1 of values interpolated between places."""
    return float(np.trapezoid(np.interp(SAMPLES, places, values), SAMPLES))
