"""The dry contact of a worm drive under a load, at an edge where misaligned flanks touch there."""

from dataclasses import dataclass
from math import nan

import numpy as np

from pyworm.drives.answers import DryContact
from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.loads.mesh import WormMesh
from pyworm.drives.worm.loads.tooth_compliance import CONTACT_POINT, LONGEST_RATIO, placed_gap
from pyworm.drives.worm.teeth.mesh_cycle import ToothContact
from pyworm.formulas.film import nijenbanning_venner_moes
from pyworm.formulas.hertz import hertz
from pyworm.materials.body import reduced_modulus
from pyworm.scene.scales import scales

EDGE_SHARE = 0.3
"""Pressure beside the end of a tooth over the largest from which a contact rests on that edge [-]."""


HERTZIAN = 1.25
"""Largest pressure over Hertz's up to which formulas of Hertzian contacts apply [-]; tip relief and the ends
of the teeth make 1.1 of contacts that lie well on the flank."""


CONTACT = (
    "contact_face",
    "contact_radius_on_wheel",
    "radius_long",
    "radius_short",
    "dry_pressure_max",
    "formula_film",
    "contact_ratio",
)
"""What is told of a contact at mid-mesh."""


@dataclass(frozen=True)
class DryToothContact(DryContact):
    """The dry contact of a tooth pair; at an edge, too, where it is not Hertzian for another reason."""

    contact: ToothContact
    """The contact without load."""
    x: float
    """Middle of its pressure along x on the tangent plane [m]."""
    y: float
    """Middle of its pressure along y on the tangent plane [m]."""


def dry_contact_of(mesh: WormMesh, load: float, phase: float = 0.5) -> DryToothContact:
    """The dry contact at a phase under a normal load [N]; ValueError if worm and wheel do not meet."""
    contact = mesh.contact(phase)
    modulus = reduced_modulus(*mesh.bodies)
    touch = None if mesh.aligned else mesh.first_touch(contact)
    middle = CONTACT_POINT if touch is None else (touch.x, touch.y)
    gap, longest = mesh.gap(contact), mesh.wheel.face_width
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


def mid_mesh_contact(mesh: WormMesh, load: float) -> dict[str, float]:
    """The contact at mid-mesh under a load [N]: the variables `CONTACT`.

    Place and pressure are those of the dry contact on the flanks as they are, edges included. The film is by
    formula, NaN where the contact rests on an edge, for which formulas of smooth flanks mean nothing.
    """
    dry = dry_contact_of(mesh, load)
    contact = dry.contact
    face, radius = mesh.flank_place(contact, np.array([dry.x]), np.array([dry.y]))
    film = nan
    if not dry.at_edge:
        # of errors of these contacts, whose spin is beyond the atlas, the change of this film tells more
        film = nijenbanning_venner_moes(scales(mesh.scene_under(load, 0.5)).groups).central_number
    return {
        "contact_face": float(face[0]),
        "contact_radius_on_wheel": float(radius[0]),
        "radius_long": contact.radii[0],
        "radius_short": contact.radii[1],
        "dry_pressure_max": dry.pressure_max,
        "formula_film": film,
        "contact_ratio": 1 / mesh.pitch,
    }


def _beside_ends(covered: Array) -> Array:
    """Nodes of both teeth beside those where one of them has ended."""
    padded = np.pad(covered, 1, mode="edge")
    around = [padded[:-2, 1:-1], padded[2:, 1:-1], padded[1:-1, :-2], padded[1:-1, 2:]]
    return covered & ~np.logical_and.reduce(around)
