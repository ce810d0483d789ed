"""Contacts of a ZI drive under errors of mounting, which move them and change their curvature."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from pyworm.drives.misalignment import Misalignment, MountingError
from pyworm.scene.point import Scene

if TYPE_CHECKING:
    from pyworm.drives.zi_worm.drive import ZiWormDrive

SHIFT = 0.1e-3
"""Error of a distance [m]."""

TILT = 1e-3
"""Error of the shaft angle [rad]: 0.1 mm over 100 mm."""

ERRORS = (
    ("centre distance {0:+.1f} mm", "assembly.centre_distance", SHIFT),
    ("worm shifted {0:+.1f} mm along the wheel's axis", "assembly.axial_shift", SHIFT),
    ("shaft angle {0:+.1f} mrad", "assembly.shaft_angle", TILT),
)
"""Label with the error in thousandths, its entry (`ZiWormDrive.varied`), its size in both directions."""

METHOD = (
    "Misalignment by the drive's own geometry: the unloaded contact is found again, at the same "
    "phases of its new mesh cycle; the load of the tooth stays."
)


def worm_misalignment(drive: "ZiWormDrive", contacts: Sequence[Scene]) -> Misalignment:
    """The contacts under each error of the assembly, in both directions."""
    return Misalignment(
        METHOD,
        tuple(
            _mounted(drive, label.format(by * 1e3), entry, by, contacts)
            for label, entry, size in ERRORS
            for by in (-size, size)
        ),
    )


def _mounted(
    drive: "ZiWormDrive", label: str, entry: str, by: float, contacts: Sequence[Scene]
) -> MountingError:
    try:
        other = drive.varied(entry, by)
        moved = tuple(other.scene_under(of.load, of.phase) for of in contacts)
    except ValueError:
        return MountingError(label, (), "the teeth no longer touch")
    return MountingError(label, moved, _movement(drive, other))


def _movement(drive: "ZiWormDrive", other: "ZiWormDrive") -> str:
    """Movement of the contact at mid-mesh and its relative radii, in words."""
    before, after = drive.contact(0.5), other.contact(0.5)
    across = (after.point[1] - before.point[1]) * 1e3
    long_radius, short_radius = max(after.radii), min(after.radii)
    return (
        f"at mid-mesh the contact moves {across:+.1f} mm along the wheel's axis; radii "
        f"{long_radius:.2f} m, {short_radius * 1e3:.1f} mm"
    )
