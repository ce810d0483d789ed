"""Linear theory of a wave on one surface of a ball contact, as one linear system of complex amplitudes.

All is proportional to exp(-i w t), w = k u_r, about a steady smooth film p0, h0: Reynolds' equation

    -div(dm grad p0 + m grad dp) + u d(dq)/dx - i w dq = 0,   m = rho h^3/(12 eta),  q = rho h,

with dh = dh_0 + K dp - r exp(i k x), K being the deflection of a half-space under rectangles of even pressure
(Love 1929), and no change of load. The domain is half the contact, y >= 0; pressure stays zero where the
smooth film has none. There are no time steps; of a resolved patch nothing is taken but its smooth film.
"""

from dataclasses import dataclass

import numpy as np
import scipy

from pyworm.materials.oil import Oil
from pyworm.planning.grid import Grid
from pyworm.solver.patch.rough_patch import RoughPatch

PRESSURE_STEP = 1e5
"""Step of pressure by which slopes of the oil's laws are found [Pa]."""


@dataclass(frozen=True)
class SmoothContact:
    """The film between smooth surfaces and its oil, on the nodes y >= 0."""

    grid: Grid
    pressure: np.ndarray
    film: np.ndarray
    entrainment: float
    modulus: float
    """Modulus E* of the pair: 1/E* is the sum of (1 - nu^2)/E of both [Pa]."""
    oil: Oil

    @classmethod
    def of(cls, found: RoughPatch, entrainment: float, modulus: float, oil: Oil) -> "SmoothContact":
        """That of a resolved patch."""
        half = found.grid.ny // 2
        return cls(
            found.grid,
            found.smooth_pressure[:, half:],
            found.smooth_film[:, half:],
            entrainment,
            modulus,
            oil,
        )


def deflections(grid: Grid, modulus: float, active: np.ndarray) -> np.ndarray:
    """Deflection [m/Pa] of all nodes y >= 0 by pressure at the active ones and at their images y <= 0."""
    nx, half = active.shape
    table = _by_distance(grid, modulus)
    i, j = np.nonzero(active)
    rows = np.arange(nx)[:, None], np.arange(half)[None, :]
    matrix = np.empty((nx, half, len(i)), dtype=np.float32)
    for place, (a, b) in enumerate(zip(i, j, strict=True)):
        along = np.abs(rows[0] - a)
        known = table[along, np.abs(rows[1] - b)]
        if b > 0:
            known = known + table[along, rows[1] + b]
        matrix[:, :, place] = known
    return matrix.reshape(nx * half, len(i))


def _by_distance(grid: Grid, modulus: float) -> np.ndarray:
    """Love's deflection under a rectangle of unit pressure at distances of whole nodes [m/Pa]."""

    def part(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return x * np.arcsinh(y / np.abs(x)) + y * np.arcsinh(x / np.abs(y))

    x = (np.arange(grid.nx)[:, None]) * grid.dx
    y = (np.arange(grid.ny + 1)[None, :]) * grid.dy
    a, b = grid.dx / 2, grid.dy / 2
    summed = part(x + a, y + b) + part(x - a, y - b) - part(x + a, y - b) - part(x - a, y + b)
    return np.asarray(summed / (np.pi * modulus))


@dataclass(frozen=True)
class Eyring:
    """Shear of an Eyring oil by sliding along x."""

    sliding: float
    stress: float
    tangent: bool
    """Whether pressure along the sliding meets the viscosity of a small change of shear, not of all of it."""

    def thinned(self, newtonian: np.ndarray, along: bool) -> tuple[np.ndarray, np.ndarray]:
        """Mobility over that without shear, and its logarithm's slope by that of the Newtonian stress."""
        x = newtonian / self.stress
        root = np.sqrt(1 + x**2)
        if along and self.tangent:
            return root, (x / root) ** 2
        return x / np.arcsinh(x), 1 - x / (root * np.arcsinh(x))


def film_wave(
    contact: SmoothContact, number: float, pace: float, shear: Eyring | None = None
) -> np.ndarray:
    """Change of the film at y = 0 by a wave exp(i k x) of the surface, complex.

    `number` is the wave number k [rad/m], `pace` the surface's speed over the entrainment.
    """
    grid, oil, p, h = contact.grid, contact.oil, contact.pressure, contact.film
    active = p > 0
    active[[0, -1], :] = active[:, -1] = False
    rho, rho_p = _with_slope(oil.density, p)
    eta, eta_p = _with_slope(oil.eta, p)
    m = rho * h**3 / (12 * eta)
    by_film = _transport(contact, number * pace, rho)
    by_pressure = _transport(contact, number * pace, rho_p * h)
    for faces, along in zip(_differences(grid, p.shape), (True, False), strict=True):
        factor, slope = np.ones_like(m), np.zeros_like(m)
        if shear is not None:
            factor, slope = shear.thinned(eta * shear.sliding / h, along)
        mobility = m * factor
        by_film += _flow_by(faces, p, mobility * (3 - slope) / h)
        by_pressure += _flow(faces, mobility)
        by_pressure += _flow_by(faces, p, mobility * (rho_p / rho + (slope - 1) * eta_p / eta))
    free = active.ravel()
    bent = deflections(grid, contact.modulus, active)
    lifted = by_film[free]
    count = int(free.sum())
    system = np.zeros((count + 1, count + 1), dtype=complex)
    system[:count, :count] = lifted @ bent
    system[:count, :count] += by_pressure[free][:, free].toarray()
    system[:count, count] = lifted @ np.ones(len(free))
    weight = np.where(np.nonzero(active)[1] > 0, 2.0, 1.0)
    scale = np.abs(system[:count, :count]).max()
    system[count, :count] = weight * scale / count
    rough = np.broadcast_to(np.exp(1j * number * grid.x)[:, None], p.shape).ravel()
    given = np.append(lifted @ rough, 0.0)
    found = scipy.linalg.solve(system, given, overwrite_a=True, check_finite=False)
    change = bent @ found[:count] + found[count] - rough
    return np.asarray(change.reshape(p.shape)[:, 0])


def _with_slope(law, p: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    values = np.vectorize(law)
    here = values(p)
    return here, (values(p + PRESSURE_STEP) - here) / PRESSURE_STEP


def _differences(grid: Grid, shape: tuple[int, int]) -> tuple:
    """Differences and means at faces along x and along y, and their outflow from nodes, over spacings."""
    nx, ny = shape

    def pair(n: int, first: float, second: float):
        return scipy.sparse.diags([first, second], [0, 1], shape=(n - 1, n))

    one_x, one_y = scipy.sparse.identity(nx), scipy.sparse.identity(ny)
    diff_x = scipy.sparse.kron(pair(nx, -1, 1), one_y) / grid.dx
    diff_y = scipy.sparse.kron(one_x, pair(ny, -1, 1)) / grid.dy
    mean_x = scipy.sparse.kron(pair(nx, 0.5, 0.5), one_y)
    mean_y = scipy.sparse.kron(one_x, pair(ny, 0.5, 0.5))
    # nodes of y = 0 have the flow of their upper face on both sides
    mirrored = scipy.sparse.diags(np.where(np.arange(ny) == 0, 2.0, 1.0))
    out_y = scipy.sparse.kron(one_x, mirrored) @ diff_y.T
    return (diff_x, mean_x, diff_x.T), (diff_y, mean_y, out_y)


def _flow(faces: tuple, m: np.ndarray):
    """-div(m grad dp) along an axis at the nodes by dp."""
    diff, mean, out = faces
    return (out @ scipy.sparse.diags(mean @ m.ravel()) @ diff).tocsr()


def _flow_by(faces: tuple, p: np.ndarray, slope: np.ndarray):
    """-div(dm grad p0) along an axis by what m grows with."""
    diff, mean, out = faces
    gradient = scipy.sparse.diags(diff @ p.ravel())
    return (out @ gradient @ mean @ scipy.sparse.diags(slope.ravel())).tocsr()


def _transport(contact: SmoothContact, frequency: float, slope: np.ndarray):
    """u dq/dx - i w q by what q grows with, by backward differences of second order along x - u t.

    `frequency` is w/u [rad/m].
    """
    nx, ny = slope.shape
    turn = np.exp(1j * frequency * contact.grid.dx)
    back = scipy.sparse.diags(
        [1.5, -2 * turn, 0.5 * turn**2], [0, -1, -2], shape=(nx, nx), format="lil"
    )
    back[1, 0], back[1, 1] = -turn, 1.0
    known = scipy.sparse.kron(back, scipy.sparse.identity(ny)) * (
        contact.entrainment / contact.grid.dx
    )
    return (known @ scipy.sparse.diags(slope.ravel())).tocsr()
