"""Rigid paraboloids with Reynolds' exit condition: what the films of light loads tend to.

Without that condition the pressure of an isoviscous oil is p = 4 eta (u x/(1 + 2D/3) + v y/(1 + 2/(3D)))/h^2
at any angle of entrainment, D = Rx/Ry; with it the load and the largest pressure are larger by factors that
this script finds by finite differences on a stretched grid, for the formula to carry:

    python benchmarks/atlas/rigid.py
"""

from math import atan2, cos, pi, radians, sin, sqrt

import numpy as np
from scipy.sparse import diags, identity, kron
from scipy.sparse.linalg import spsolve

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


def factors(ratio: float, angle: float, nodes: int) -> tuple[float, float]:
    """Load and largest pressure with the exit condition, over those of p above where it is positive.

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
    return pressure @ area / (closed @ area), pressure.max() / closed.max()


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


if __name__ == "__main__":
    main()
