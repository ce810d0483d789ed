"""Worm and rollers in space, for pictures: flanks that rollers envelop, rollers as surfaces of revolution."""

from collections.abc import Sequence
from math import pi

import numpy as np

from pyworm.drives.answers import Shape, Space
from pyworm.drives.roller_worm.mesh import RollerMesh
from pyworm.drives.roller_worm.section import WormSection
from pyworm.io.present import present
from pyworm.scene.index import ContactIndex

Array = np.ndarray

HEIGHTS = 4
"""Points of a flank along the rollers."""

ANGLES = 30
"""Points in a turn of the worm, or of a roller about its own axis."""

RINGS = 3
"""Circles of a roller along its axis."""

ALONG = 41
"""Points of a line of contact."""

DRAWN_PARTS = (
    "Red: line of contact of this roller. Drawn are the flanks of the worm that rollers touch, and the "
    "rollers on the worm's side, without their crown."
)


def in_space(mesh: RollerMesh, places: Sequence[ContactIndex]) -> Space:
    """Both flanks of the worm and the rollers about it, turned to some sections and phases."""
    sections = [mesh.sections[present(place.section, "section")] for place in places]
    phases = [present(place.phase, "phase") for place in places]
    angles = [
        float(section.wheel_angle(phase)) for section, phase in zip(sections, phases, strict=True)
    ]
    flanks = (_flank(mesh, section, np.array(angles)) for section in mesh.sections.values())
    rows = (_rollers(mesh, section, np.array(angles)) for section in mesh.rows)
    return Space(
        shapes=(*flanks, *rows),
        view=np.eye(3),
        size=1.5 * mesh.centre_distance,
        drawn=DRAWN_PARTS,
        lines=tuple(
            section.line(np.array(angle), np.linspace(0, 1, ALONG)).point.T
            for section, angle in zip(sections, angles, strict=True)
        ),
    )


def _flank(mesh: RollerMesh, section: WormSection, angles: Array) -> Shape:
    envelope, turns = section.envelope, mesh.worm.turn * mesh.ratio * angles
    count = round(ANGLES * mesh.ratio * (section.last - section.first) / (2 * pi)) + 2
    along = np.linspace(section.lowest, section.highest, HEIGHTS)[:, None]
    points = envelope.worm_point(along, np.linspace(section.first, section.last, count))
    threads = mesh.worm.threads
    return Shape(
        body=1,
        axis_point=envelope.worm_centre,
        axis=np.array([1.0, 0.0, 0.0]),
        surface=np.moveaxis(points, 0, -1),
        turns=turns,
        copies=tuple(2 * pi * np.arange(1, threads) / threads),
    )


def _rollers(mesh: RollerMesh, section: WormSection, angles: Array) -> Shape:
    profile = mesh.rollers.profile
    going, side, axis, middle = section.envelope.axes(np.array(0.0))
    ends = np.linspace(-0.5, 0.5, RINGS) * profile.length
    radii = profile(ends)[0]
    # the flat ends are rings of no radius
    rings = zip((ends[0], *ends, ends[-1]), (0.0, *radii, 0.0), strict=True)
    surface = np.stack([_ring(middle + s * axis, radius, going, side) for s, radius in rings])
    about = round(pi / 2 / section.pitch)
    return Shape(
        body=2,
        axis_point=np.zeros(3),
        axis=np.array([0.0, 0.0, 1.0]),
        surface=surface,
        turns=-angles,
        copies=tuple(section.pitch * np.array([step for step in range(-about, about + 1) if step])),
    )


def _ring(centre: Array, radius: float, first: Array, other: Array) -> Array:
    """Points of a circle, the first once more at the end, (ANGLES + 1, 3)."""
    around = np.linspace(0, 2 * pi, ANGLES + 1)[:, None]
    return centre + radius * (np.cos(around) * first + np.sin(around) * other)
