"""A periodic cell of a topography, or of two together, as the cell solver takes it."""

import numpy as np
import scipy

from pyworm.materials.topography import Topography
from pyworm.surfaces.parameters import PEKLENIK, correlation_lengths

Array = np.ndarray

NODES = 512
"""Most nodes along each side of a cell that is cut from a measured area."""

LENGTHS = 24.0
"""Correlation lengths, down to 0.5, along each side of a cell, as far as the area has them: the pressure of
its highest summits scatters by a tenth at a gap of twice the roughness."""

PARTS_PER_BLEND = 8
"""One part in so many of a cell, at its low sides, is blended with what lies beyond its high sides."""


def periodic_cell(surface: Topography) -> Topography:
    """A cell that repeats itself: the surface if it does, else the middle of it with blended sides.

    Cells have the points of the surface, or every second, third or so of them where `NODES` would not hold
    `LENGTHS`. Heights keep their root mean square.
    """
    if surface.periodic:
        return surface
    lengths = correlation_lengths(surface, np.array([0.0, np.pi / 2]), (PEKLENIK,))[0]
    nodes, spacing = [], []
    for count, step, length in zip(surface.height.shape, surface.spacing, lengths, strict=True):
        held = int(count / (1 + 1 / PARTS_PER_BLEND))
        wanted = min(held, max(NODES, round(LENGTHS * length / step)))
        stride = -(-wanted // NODES)
        nodes.append(_even(min(held // stride, NODES)))
        spacing.append(stride * step)
    return _sampled(surface, (nodes[0], nodes[1]), (spacing[0], spacing[1]))


def common_cell(surfaces: tuple[Topography, Topography]) -> Topography:
    """Sum of two surfaces' heights in one cell, with their x axes alongside."""
    cells = [periodic_cell(surface) for surface in surfaces]
    if cells[0].height.shape == cells[1].height.shape and cells[0].spacing == cells[1].spacing:
        total = cells[0].height + cells[1].height
        return Topography(total, cells[0].spacing, periodic=True)
    sides = [min(pair) for pair in zip(*(cell.extent for cell in cells), strict=True)]
    finest = [min(pair) for pair in zip(*(cell.spacing for cell in cells), strict=True)]
    nx, ny = (
        _even(min(NODES, round(side / step))) for side, step in zip(sides, finest, strict=True)
    )
    spacing = sides[0] / nx, sides[1] / ny
    first, second = (_sampled(surface, (nx, ny), spacing).height for surface in surfaces)
    return Topography(first + second, spacing, periodic=True)


def _even(nodes: int) -> int:
    """The largest number of nodes up to this that the solver's grids can halve at least four times."""
    return nodes // 16 * 16


def _sampled(
    surface: Topography, nodes: tuple[int, int], spacing: tuple[float, float]
) -> Topography:
    """Heights of a surface at the nodes of a periodic cell in its middle."""
    if surface.periodic:
        margins, mode = (0, 0), "grid-wrap"
        whole = [
            abs(n * a - b) < 1e-9 * b
            for n, a, b in zip(nodes, spacing, surface.extent, strict=True)
        ]
        if not all(whole):
            margins = nodes[0] // PARTS_PER_BLEND, nodes[1] // PARTS_PER_BLEND
    else:
        margins, mode = (nodes[0] // PARTS_PER_BLEND, nodes[1] // PARTS_PER_BLEND), "nearest"
    places = []
    for n, margin, step, surface_step, count in zip(
        nodes, margins, spacing, surface.spacing, surface.height.shape, strict=True
    ):
        start = (count - (n + margin) * step / surface_step) // 2
        places.append(start + np.arange(n + margin) * step / surface_step)
    exact = all(np.allclose(axis_places, np.round(axis_places)) for axis_places in places)
    height = scipy.ndimage.map_coordinates(
        surface.height,
        np.meshgrid(
            *(np.round(axis_places) if exact else axis_places for axis_places in places),
            indexing="ij",
        ),
        order=1 if exact else 3,
        mode=mode,
    )
    for axis, margin in enumerate(margins):
        height = _blended(height, axis, margin)
    height -= height.mean()
    return Topography(height * (surface.rms / height.std()), spacing, periodic=True)


def _blended(height: Array, axis: int, margin: int) -> Array:
    """Heights whose first rows turn into those beyond the last: shares whose squares add to one."""
    if margin == 0:
        return height
    height = np.moveaxis(height, axis, 0)
    angle = np.pi / 2 * (np.arange(margin) + 0.5) / margin
    cell = height[:-margin].copy()
    before, beyond = np.sin(angle)[:, None], np.cos(angle)[:, None]
    cell[:margin] = before * cell[:margin] + beyond * height[-margin:]
    return np.moveaxis(cell, 0, axis)
