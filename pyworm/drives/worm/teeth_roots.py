"""Roots of the worm's thread and the wheel's teeth under the loads of the mesh cycle."""

from math import atan, cos, pi, tan

import numpy as np

from pyworm.drives.loaded_root import LoadedRoot
from pyworm.drives.worm.loads.mesh import WormMesh
from pyworm.drives.worm.teeth.tooth import wheel_radius
from pyworm.drives.worm.teeth.tooth_form import wheel_thickness, worm_thickness
from pyworm.formulas.hertz import hertz
from pyworm.formulas.worm_gear import WormGear
from pyworm.formulas.worm_root import DEDENDUM
from pyworm.materials.body import reduced_modulus

MAX_LINES = 7
"""Contact lines of the mesh cycle at most."""

WORDS = (
    "a plate held at its root, bent and sheared by the force of each contact line at its middle, without "
    "notch effects; the width that bears is that of the dry contact and 1.96 times the arm."
)


def worm_roots(drive: WormMesh, gear: WormGear) -> tuple[LoadedRoot, LoadedRoot]:
    """The thread and the tooth; ValueError where the worm has no thread on its root."""
    phases = [float(phase) for phase in np.linspace(0, 1, MAX_LINES)]
    phases = [phase for phase in phases if not drive.idle(phase)]
    scenes = [drive.scene_at(phase) for phase in phases]
    contacts = [drive.contact(phase) for phase in phases]
    across = np.array([scene.load for scene in scenes]) * cos(gear.pressure_angle)
    modulus = reduced_modulus(*drive.bodies)
    lines = np.array([2 * max(_axes(scene.radii, scene.load, modulus)) for scene in scenes])
    on_worm = np.array([float(drive.worm_flank.radius(contact.point)) for contact in contacts])
    on_wheel = np.array([float(wheel_radius(contact.point)) for contact in contacts])
    thread = drive.worm.root_radius
    tooth = drive.wheel_reference_radius - DEDENDUM * gear.module
    slope = cos(atan(drive.worm.lead / (2 * pi * thread)))
    widened = 2 * tan(gear.pressure_angle) * DEDENDUM * gear.module
    width = drive.wheel.face_width / cos(gear.lead_angle)
    return (
        LoadedRoot(
            name="worm thread",
            body=1,
            phase=np.array(phases),
            force=across,
            arm=np.maximum(on_worm - thread, 0.0),
            line=lines,
            thickness=worm_thickness(drive, thread) * slope,
            width=width,
            words=f"Worm thread: {WORDS}",
        ),
        LoadedRoot(
            name="wheel tooth",
            body=2,
            phase=np.array(phases),
            force=across,
            arm=np.maximum(on_wheel - tooth, 0.0),
            line=lines,
            thickness=(wheel_thickness(drive) + widened) * cos(gear.lead_angle),
            width=width,
            words=f"Wheel tooth, its root {DEDENDUM:g} modules deep and as steep as its flanks: {WORDS}",
        ),
    )


def _axes(radii: tuple[float, float], load: float, modulus: float) -> tuple[float, float]:
    """Semi-axes of the dry contact [m]."""
    contact = hertz(*radii, load, modulus)
    return contact.semi_axis_x, contact.semi_axis_y
