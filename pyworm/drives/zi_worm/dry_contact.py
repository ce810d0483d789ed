"""The dry contact of a worm drive under a load, at an edge where misaligned flanks touch there."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pyworm.drives.misalignment import DryContact
from pyworm.drives.zi_worm.helicoid import Array
from pyworm.drives.zi_worm.mesh_cycle import ToothContact
from pyworm.drives.zi_worm.tooth_compliance import CONTACT_POINT, LONGEST_RATIO, placed_gap
from pyworm.formulas.hertz import hertz
from pyworm.materials.body import reduced_modulus

if TYPE_CHECKING:
    from pyworm.drives.zi_worm.drive import ZiWormDrive

EDGE_SHARE = 0.3
"""Pressure beside the end of a tooth over the largest from which a contact rests on that edge [-]."""


HERTZIAN = 1.25
"""Largest pressure over Hertz's up to which formulas of Hertzian contacts apply [-]; tip relief and the ends
of the teeth make 1.1 of contacts that lie well on the flank."""


@dataclass(frozen=True)
class DryToothContact(DryContact):
    """The dry contact of a tooth pair; at an edge, too, where it is no Hertzian contact for another reason.

    Attributes
    ----------
    contact : ToothContact
        The contact without load.
    x, y : float
        Middle of its pressure on the tangent plane [m].
    """

    contact: ToothContact
    x: float
    y: float


def dry_contact_of(drive: "ZiWormDrive", load: float, phase: float = 0.5) -> DryToothContact:
    """The dry contact at a phase under a normal load [N].

    Raises
    ------
    ValueError
        Worm and wheel do not reach each other there.
    """
    contact = drive.contact(phase)
    modulus = reduced_modulus(*drive.bodies)
    touch = None if drive.aligned else drive.first_touch(contact)
    middle = CONTACT_POINT if touch is None else (touch.x, touch.y)
    gap, longest = drive.gap(contact), drive.wheel.face_width
    placed = placed_gap(gap, contact.radii, load, modulus, longest, middle=middle)
    if placed is None or not placed.covered.any():
        raise ValueError(f"assembly: worm and wheel do not reach each other at phase {phase:g}")
    dry = placed.pressed(load, modulus, placed.covered.astype(float))
    weights = dry.pressure / dry.pressure.sum()
    x, y = (
        float((weights * axis).sum()) for axis in np.meshgrid(placed.x, placed.y, indexing="ij")
    )
    largest = float(dry.pressure.max())
    beside = dry.pressure[_beside_ends(placed.covered)]
    at_edge = bool(beside.size and beside.max() > EDGE_SHARE * largest)
    radius_x, radius_y = contact.radii
    size = hertz(min(radius_x, LONGEST_RATIO * radius_y), radius_y, load, modulus)
    at_edge |= largest > HERTZIAN * size.pressure_max
    return DryToothContact(largest, at_edge, contact, x, y)


def _beside_ends(covered: Array) -> Array:
    """Nodes of both teeth beside those where one of them has ended."""
    padded = np.pad(covered, 1, mode="edge")
    around = [padded[:-2, 1:-1], padded[2:, 1:-1], padded[1:-1, :-2], padded[1:-1, 2:]]
    beside_ends: Array = covered & ~np.logical_and.reduce(around)
    return beside_ends
