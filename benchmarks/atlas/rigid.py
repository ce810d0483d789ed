"""Rigid paraboloids with Reynolds' exit condition: what the films of light loads tend to.

Without that condition the pressure of an isoviscous oil is p = 4 eta (u x/(1 + 2D/3) + v y/(1 + 2/(3D)))/h^2
at any angle of entrainment, D = Rx/Ry; with it the load and the largest pressure are larger by factors that
this script finds by finite differences on a stretched grid, for the formula to carry:

    python benchmarks/atlas/rigid.py
"""

from dataclasses import dataclass
from math import atan2, cos, exp, pi, radians, sin, sqrt

import numpy as np
from scipy.sparse import diags, identity, kron
from scipy.sparse.linalg import spsolve

from pyworm.formulas.hertz import ellipticity
from pyworm.formulas.regime_charts import point_films
from pyworm.formulas.regimes import ISOVISCOUS_RIGID, PIEZOVISCOUS_RIGID

NODES = 91, 181
REACH, STRETCH = 60.0, 4.5


def axis(nodes: int) -> np.ndarray:
    """Places [sqrt(2 R h0)]: fine in the middle, out to `REACH`."""
    return REACH * np.sinh(STRETCH * np.linspace(-1, 1, nodes)) / np.sinh(STRETCH)


def differences(x: np.ndarray):
    """Matrices from nodes to faces: derivative and mean; and from faces to inner nodes: divergence."""
    step = np.diff(x)
    count = len(x)
    slope = diags([-1 / step, 1 / step], [0, 1], shape=(count - 1, count))
    mean = diags([0.5 * np.ones(count - 1)] * 2, [0, 1], shape=(count - 1, count))
    cell = (x[2:] - x[:-2]) / 2
    return slope, mean, diags([-1 / cell, 1 / cell], [0, 1], shape=(count - 2, count - 1))


@dataclass(frozen=True)
class RigidFilm:
    """Pressure of an isoviscous oil between rigid paraboloids, over 12 eta u (2 Rx/h^3)^(1/2)."""

    pressure: np.ndarray
    """Pressure at the inner nodes with the exit condition."""
    closed: np.ndarray
    """p above where it is positive."""
    area: np.ndarray
    """Area of each node over 2 h (Rx Ry)^(1/2)."""


def solved(ratio: float, angle: float, nodes: int) -> RigidFilm:
    """Solve Reynolds' equation with the exit condition.

    In x/sqrt(2 Rx h0) and y/sqrt(2 Ry h0) the gap is round; D stands before the flow along y, and the
    entrainment along each axis is carried over its own length.
    """
    place = axis(nodes)
    x, y = np.meshgrid(place, place, indexing="ij")
    gap = 1 + x**2 + y**2
    slope, mean, divergence = differences(place)
    inner = slice(1, -1)
    keep = identity(nodes, format="csr")[inner]
    matrix = 0
    for first, weight in (("x", 1.0), ("y", ratio)):
        wide = kron(mean, keep) if first == "x" else kron(keep, mean)
        flow = diags(wide @ (gap**3).ravel())
        gradient = kron(slope, keep) if first == "x" else kron(keep, slope)
        back = (
            kron(divergence, identity(nodes - 2))
            if first == "x"
            else kron(identity(nodes - 2), divergence)
        )
        matrix = matrix + weight * (back @ flow @ gradient)
    free_nodes = np.arange(nodes**2).reshape(nodes, nodes)[inner, inner].ravel()
    matrix = matrix.tocsc()[:, free_nodes]
    u, v = cos(angle), sin(angle) * sqrt(ratio)  # v sqrt(Rx) / sqrt(Ry)
    wedge = (2 * u * x + 2 * v * y)[inner, inner].ravel()
    free = np.ones(len(free_nodes), bool)
    for _ in range(100):
        pressure = np.zeros(len(free_nodes))
        pressure[free] = spsolve(matrix[free][:, free], wedge[free])
        residual = matrix @ pressure - wedge
        again = np.where(free, pressure > 0, residual > 0)
        if (again == free).all():
            break
        free = again
    closed = -(u * x / (3 + 2 * ratio) + v * y / (3 * ratio + 2))[inner, inner].ravel()
    closed = np.maximum(closed, 0) / gap[inner, inner].ravel() ** 2
    area = np.outer(*[(place[2:] - place[:-2]) / 2] * 2).ravel()
    return RigidFilm(pressure, closed, area)


def factors(ratio: float, angle: float, nodes: int) -> tuple[float, float]:
    """Load and largest pressure with the exit condition, over those of p above where it is positive."""
    film = solved(ratio, angle, nodes)
    pressure, closed, area = film.pressure, film.closed, film.area
    return pressure @ area / (closed @ area), pressure.max() / closed.max()


@dataclass(frozen=True)
class RigidLimits:
    """Minimum films of rigid paraboloids along x, H = (h/R) (W/U)^2, and where they pass into each other."""

    isoviscous: float
    """Film without pressure-viscosity [-]."""
    piezoviscous: float
    """The film at which alpha times the largest isoviscous pressure is 1, over g_V^(2/3) [-]; no thinner one
    holds oil of Barus' law, whatever the load."""
    viscosity: float
    """The g_V from which this film holds [-]."""
    film: float
    """The film there [-]."""


def rigid_limits(ratio: float, nodes: tuple[int, int] = NODES) -> RigidLimits:
    """The limits, extrapolated from two grids; ratio is D.

    int eta0/eta dp = (1 - e^(-alpha p))/alpha of Barus' law is the isoviscous pressure q, so that the load at
    the limit is the integral of -ln(1 - q/max(q))/alpha.
    """
    rows = []
    for count in nodes:
        film = solved(ratio, 0.0, count)
        peak = film.pressure.max()
        share = film.pressure / peak
        load = share @ film.area
        # the logarithm is unbounded at the maximum, but its integral over the area of that node is not
        thick = -np.log1p(-np.minimum(share, (1 + np.sort(share)[-2]) / 2))
        rows.append((peak, load * peak, thick @ film.area / load))
    coarse, fine = np.array(rows)
    peak, load, more = 2 * fine - coarse  # first order
    isoviscous = (24 * sqrt(2 / ratio) * load) ** 2
    piezoviscous = (12 * sqrt(2) * peak) ** (2 / 3)
    film = isoviscous * more**2
    return RigidLimits(isoviscous, piezoviscous, (film / piezoviscous) ** 1.5, film)


def print_published() -> None:
    """Published films of rigid bodies over the solved ones, where the piezoviscous limit begins."""
    print(
        "\nD; H isoviscous, published/solved; g_V and H where alpha p diverges; both published films there"
    )
    for ratio in (1.0, 1 / 3, 0.1, 1 / 30):
        found = rigid_limits(ratio)
        films = point_films(found.viscosity, 1.0, ratio)
        first = 1.66 * found.viscosity ** (2 / 3) * (1 - exp(-0.68 * ellipticity(1 / ratio)))
        print(
            f"{ratio:8.4f} {found.isoviscous:10.4g} {films[ISOVISCOUS_RIGID] / found.isoviscous:7.3f} "
            f"{found.viscosity:10.3g} {found.film:10.4g} 1979: {first / found.film:6.3f}  "
            f"1991: {films[PIEZOVISCOUS_RIGID] / found.film:6.3f}",
            flush=True,
        )


def main() -> None:
    for ratio in (1 / 30, 0.1, 1 / 3, 1.0):
        for angle in (0, 45, 75, 85, 90):
            coarse, fine = (np.array(factors(ratio, radians(angle), nodes)) for nodes in NODES)
            load, peak = 2 * fine - coarse  # first order
            u, v = cos(radians(angle)), sin(radians(angle)) * sqrt(ratio)
            turned = atan2(abs(v) / (3 * ratio + 2), abs(u) / (3 + 2 * ratio))
            print(
                f"{ratio:8.4f} {angle:4d} {180 * turned / pi:7.2f} {load:8.4f} {peak:8.4f}",
                flush=True,
            )
    print_published()


if __name__ == "__main__":
    main()
