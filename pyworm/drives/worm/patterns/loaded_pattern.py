"""The contact pattern of worm and wheel under load: what a marking compound shows after a slow turn.

Each place of the wheel's flank is followed over the mesh as without load (`contact_pattern`). While its pair
bears its share of the torque, the separation is the gap, plus the elastic deflection of both flanks there,
less their approach, both of the dry contact under that share; it is zero in the contact. While the pair
bears none, the wheel's turn under the load of the others brings it nearer by lever x (turn + ahead)
(`load_sharing`). Films, which lift the flanks by a tenth of the compound's thickness, are left out.
"""

import numpy as np
import scipy

from pyworm import kernel
from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.loads.load_sharing import SharedLoad
from pyworm.drives.worm.loads.mesh import WormMesh
from pyworm.drives.worm.loads.tooth_compliance import EDGE_CONTACT_PHASES, PlacedGap, placed_gap
from pyworm.drives.worm.patterns.contact_pattern import ContactPattern, PointsInMesh, points_in_mesh
from pyworm.drives.worm.teeth.flank_grid import FlankGrid
from pyworm.drives.worm.teeth.mesh_cycle import ToothContact
from pyworm.materials.body import reduced_modulus

PHASES = np.linspace(-EDGE_CONTACT_PHASES, 1 + EDGE_CONTACT_PHASES, 38)
"""Phases at which the pair is looked at; contacts under load are wider than what they move between two."""

CELLS = 48, 24
"""Cells of the dry contact along and across it; its approach is right to 2 %."""

LUMP = 6
"""Cells along each side whose pressure acts as one force on places beyond the window of the contact."""


def loaded_pattern(mesh: WormMesh, grid: FlankGrid) -> ContactPattern:
    """The pattern under load of the flank that the worm drives, at places of its wheel."""
    least = np.full(grid.found.shape, np.inf)
    for phase in PHASES:
        contact, shared = mesh.cycle.contact(float(phase)), mesh.shared(float(phase))
        points = points_in_mesh(mesh, grid, contact)
        nearer = _nearer(mesh, contact, shared, points)
        least[points.which] = np.minimum(least[points.which], points.gap - nearer)
    return ContactPattern.of_least(grid, least)


def _nearer(
    mesh: WormMesh, contact: ToothContact, shared: SharedLoad, points: PointsInMesh
) -> Array:
    """How much nearer the flanks are at places than without load [m]; -inf where they do not approach."""
    load, modulus = shared.force(contact.phase), reduced_modulus(*mesh.bodies)
    if load > 0:
        radii = mesh.cycle.contact(float(np.clip(contact.phase, 0, 1))).radii
        whole, face = float(shared.forces.sum()), mesh.wheel.face_width
        middle = mesh.touching_place(contact)
        placed = placed_gap(mesh.gap(contact), radii, whole, modulus, face, CELLS, middle)
        if placed is None:  # no tooth there to carry it
            return np.full(points.x.shape, -np.inf)
        dry = placed.pressed(load, modulus, placed.covered.astype(float))
        return dry.approach - deflection(placed, dry.pressure, modulus, points.x, points.y)
    if shared.turn == 0:
        return np.full(points.x.shape, -np.inf)
    ahead = mesh.cycle.transmission_error(np.array([contact.phase]))[0]
    lever = mesh.arms(np.array([contact.phase])).wheel_normal[0]
    return np.full(points.x.shape, lever * (shared.turn + ahead))


def deflection(placed: PlacedGap, pressure: Array, modulus: float, x: Array, y: Array) -> Array:
    """Elastic deflection of both flanks together [m], in a window under pressure [Pa] and beyond it.

    There forces P at distances r give 2 P / (pi E' r) each (Boussinesq; K. L. Johnson, Contact Mechanics,
    1985, equation 3.22).
    """
    dx, dy = placed.x[1] - placed.x[0], placed.y[1] - placed.y[0]
    inside = kernel.elastic_deflection(pressure, dx, dy, modulus)
    within: Array = scipy.interpolate.RegularGridInterpolator(
        (placed.x, placed.y), inside, bounds_error=False, fill_value=np.nan
    )(np.stack([x, y], axis=-1))
    unknown_places = np.flatnonzero(np.isnan(within))
    i, j = np.nonzero(pressure > 0)
    lumps, which = np.unique(np.stack([i // LUMP, j // LUMP]), axis=1, return_inverse=True)
    force = np.bincount(which.ravel(), pressure[i, j], lumps.shape[1]) * dx * dy
    at_x, at_y = (
        np.bincount(which.ravel(), pressure[i, j] * side, lumps.shape[1]) * dx * dy / force
        for side in (placed.x[i], placed.y[j])
    )
    away = np.hypot(x[unknown_places, None] - at_x, y[unknown_places, None] - at_y)
    within[unknown_places] = (2 / (np.pi * modulus)) * (force / away).sum(axis=1)
    return within
