"""Roots of the worm's thread and the rollers' pins under the loads of the rollers in both sections."""

from math import pi

import numpy as np

from pyworm.drives.loaded_root import LoadedRoot
from pyworm.drives.roller_worm.mesh import RollerMesh

PHASES = np.linspace(0, 1, 7)
"""Phases of each section."""

PIN_WORDS = (
    "Roller pin: a round beam held at one end of its roller, bent and sheared by the roller's load at its "
    "middle; without notch effects, and without help from the other end."
)

THREAD_WORDS = (
    "Worm thread: a plate held at the outer end of the rollers, as thick as the pitch less the rollers at "
    "their middles, bent and sheared by each roller; the width that bears is that of a load at a point."
)


def roller_roots(drive: RollerMesh) -> tuple[LoadedRoot, ...]:
    """The thread, and the pins where their radius is given."""
    lines = [
        (phase, drive.state(section, float(phase), [0.5]).force)
        for section in drive.sections
        for phase in PHASES
    ]
    phase, force = (np.array(column) for column in zip(*lines, strict=True))
    profile = drive.rollers.profile
    pitch = 2 * pi * drive.pitch_radius / drive.rollers.count
    same = np.ones(len(force))
    thread = LoadedRoot(
        "worm thread", 1, phase, force, drive.worm.dedendum * same, 0 * same,
        pitch - 2 * profile.radius, 2 * pi * drive.throat_radius, THREAD_WORDS,
    )  # fmt: skip
    pin = drive.rollers.pin
    if not pin.radius > 0:
        return (thread,)
    arm = profile.length / 2 * same
    return (
        thread,
        LoadedRoot("roller pin", 2, phase, force, arm, 0 * same, 2 * pin.radius, 0.0, PIN_WORDS),
    )
