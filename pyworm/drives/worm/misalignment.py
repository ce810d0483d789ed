"""Contacts of a worm drive under errors of mounting, which move them and change their curvature."""

from collections.abc import Sequence

import numpy as np

from pyworm.drives.answers import DryContact, Misalignment, MountingError
from pyworm.drives.worm.loads.dry_contact import dry_contact_of
from pyworm.drives.worm.loads.mesh import WormMesh
from pyworm.drives.worm.teeth.checks import check_play
from pyworm.io.present import present
from pyworm.scene.point import Scene

SHIFT = 0.1e-3
"""Error of a distance [m]."""

TILT = 1e-3
"""Error of the shaft angle [rad]: 0.1 mm over 100 mm."""

ERRORS = (
    ("centre distance {0:+.1f} mm", "assembly.centre_distance", SHIFT),
    ("worm shifted {0:+.1f} mm along the wheel's axis", "assembly.axial_shift", SHIFT),
    ("shaft angle {0:+.1f} mrad", "assembly.shaft_angle", TILT),
)
"""Label with the error in thousandths, its entry (`WormDrive.varied`), its size in both directions."""

METHOD = (
    "Misalignment by the exact geometry of the gears: the contact is found again at the same phases, on "
    "the exact flanks, at an edge where they touch there; pressures are those of dry contacts under the "
    "same load of the tooth. Where a contact comes to rest on an edge no closed form gives its film (run "
    "the case with [drive.assembly]); one that rests on an edge without the error keeps its film."
)


def worm_misalignment(mesh: WormMesh, contacts: Sequence[Scene]) -> Misalignment:
    """The contacts under each error of the assembly, in both directions."""
    errors = tuple(
        _mounted(mesh, label.format(by * 1e3), entry, by, contacts)
        for label, entry, size in ERRORS
        for by in (-size, size)
    )
    return Misalignment(METHOD, errors, _dry(mesh, contacts))


def _dry(mesh: WormMesh, contacts: Sequence[Scene]) -> tuple[DryContact, ...]:
    return tuple(
        dry_contact_of(mesh, contact.load, present(contact.phase, "phase")) for contact in contacts
    )


def _mounted(
    mesh: WormMesh, label: str, entry: str, by: float, contacts: Sequence[Scene]
) -> MountingError:
    try:
        other = mesh.varied(entry, by)
        check_play(other)
        dry = _dry(other, contacts)
        moved = tuple(
            other.scene_under(contact.load, present(contact.phase, "phase")) for contact in contacts
        )
    except ValueError:
        return MountingError(label, (), "the teeth jam, or no longer reach each other")
    note = _movement(mesh, other, moved[0].load)
    edges = [
        f"{contact.phase:g}" for contact, touch in zip(contacts, dry, strict=True) if touch.at_edge
    ]
    if edges:
        note += f"; on an edge at phase {', '.join(edges)}"
    return MountingError(label, moved, note, dry)


def _movement(mesh: WormMesh, other: WormMesh, load: float) -> str:
    """Movement of the contact at mid-mesh under a load [N], in words."""
    before, after = (dry_contact_of(assembled, load) for assembled in (mesh, other))
    faces = [
        float(assembled.flank_place(dry.contact, np.array([dry.x]), np.array([dry.y]))[0][0])
        for assembled, dry in ((mesh, before), (other, after))
    ]
    moved = f"at mid-mesh the contact moves {(faces[1] - faces[0]) * 1e3:+.1f} mm along the wheel's axis"
    if after.at_edge:
        return moved
    long_radius, short_radius = max(after.contact.radii), min(after.contact.radii)
    return f"{moved}; radii {long_radius:.2f} m, {short_radius * 1e3:.1f} mm"
