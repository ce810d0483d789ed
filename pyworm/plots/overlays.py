"""Overlays of a contact's fields: dry outline, tooth edges, arrows, marked points; fields between nodes."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.formulas.whole_numbers import whole
from pyworm.io.plain_dataset import AnyDataset
from pyworm.plots.layout import MILLI, Style, field, nodes, panel_size


def draw_dry_outline(axes: Axes, fields: AnyDataset, colour: str) -> None:
    """The boundary of the dry contact."""
    pressure = field(fields, "dry_pressure")
    if pressure.max() > 0:
        squares = *nodes(fields), signed_square(pressure)
        axes.contour(*squares, levels=[0], colors=colour, linewidths=1.2)


def dry_outline(fields: AnyDataset) -> list[np.ndarray]:
    """Lines of the boundary of the dry contact, each over point and axis [mm]; none without a contact."""
    pressure = field(fields, "dry_pressure")
    if not pressure.max() > 0:
        return []
    drawn = Figure().add_subplot().contour(*nodes(fields), signed_square(pressure), levels=[0])
    return list(drawn.allsegs[0])


def signed_square(pressure: np.ndarray) -> np.ndarray:
    """Square of a dry pressure over a regular grid, continued to negative values outside the contact.

    The square of a dry pressure falls to zero linearly, so it is continued linearly by one point past the
    boundary; contours are then free of the steps of the grid. Where the pressure does not fall (at the edge
    of a tooth) the boundary is put half-way to the next point.
    """
    square = np.square(pressure)
    padded = np.pad(square, 2)
    total, count = np.zeros_like(square), np.zeros_like(square)
    for axis in (0, 1):
        for step in (1, -1):
            next_in, second_in = (
                np.roll(padded, distance * step, axis)[2:-2, 2:-2] for distance in (1, 2)
            )
            reached = (square == 0) & (next_in > 0)
            first, second = next_in[reached], second_in[reached]
            continued = np.where(second > first, 2 * first - second, -first)
            # The continuation may still be positive where the pressure is not that of a parabola.
            total[reached] += np.minimum(continued, -1e-3 * first)
            count[reached] += 1
    signed: np.ndarray = np.where(square > 0, square, -square.max())
    beside = count > 0
    signed[beside] = total[beside] / count[beside]
    return signed


def draw_tooth(axes: Axes, fields: AnyDataset) -> None:
    """Where a surface is missing, hatched, and the outline and contact path where given."""
    covered = *nodes(fields), field(fields, "covered")
    if covered[-1].min() < 0.5:
        look: Style = {"colors": "0.85", "hatches": ["////"], "alpha": 0.75}
        axes.contourf(*covered, levels=[-0.5, 0.5], **look)
        if "tooth_outline_x" not in fields:
            axes.contour(*covered, levels=[0.5], colors="0.25", linewidths=1.0)
    if "tooth_outline_x" in fields:
        outline = [fields[f"tooth_outline_{axis}"].values * MILLI for axis in "xy"]
        axes.plot(*outline, color="0.25", linewidth=1.5)
        _name_sides(axes, outline)


def _name_sides(axes: Axes, outline: list[np.ndarray]) -> None:
    """Names of the sides of a wheel's tooth; at the panel's edges where it shows a part of the tooth."""
    side = (outline[0].size - 1) / len(TOOTH_SIDES)
    middles: dict[str, tuple[float, float]] = {}
    for number, name in enumerate(TOOTH_SIDES):
        index = round((number + 0.5) * side)
        x, y = (float(along[index] + INWARDS * (along.mean() - along[index])) for along in outline)
        middles[name] = x, y
    limits = axes.get_xlim(), axes.get_ylim()
    if all(
        low < coordinate < high
        for middle in middles.values()
        for coordinate, (low, high) in zip(middle, limits, strict=True)
    ):
        for name, middle in middles.items():
            axes.annotate(name, middle, ha="center", va="center", fontsize="small", bbox=_BEHIND)
        return
    sides, heights = (
        sorted(pair, key=lambda name: middles[name][axis])
        for axis, pair in enumerate((TOOTH_SIDES[1::2], TOOTH_SIDES[::2]))
    )
    for name, place, ha, va, turn in (
        (sides[0], (0.01, 0.5), "left", "center", 90),
        (sides[1], (0.99, 0.5), "right", "center", 90),
        (f"wheel's {heights[0]}", (0.5, 0.03), "center", "bottom", 0),
        (f"wheel's {heights[1]}", (0.5, 0.97), "center", "top", 0),
    ):
        axes.text(
            *place,
            f"to the {name}",
            ha=ha,
            va=va,
            rotation=turn,
            fontsize="small",
            transform=axes.transAxes,
            bbox=_BEHIND,
        )


_BEHIND = {"boxstyle": "round,pad=0.15", "fc": "white", "ec": "none", "alpha": 0.8}
"""What lies behind the name of a side."""

INWARDS = 0.14
"""Part of the way from a side to the middle of the tooth at which the side is named."""

TOOTH_SIDES = "tip", "leaving side", "root", "entering side"
"""Sides of the outline of a wheel's tooth, in its order; threads leave there as the worm drives."""

ARROWS = 24
"""Arrows on a panel, about."""

STANDSTILL = 1e-3
"""Fraction of the largest value below which a vector has no arrow."""


def draw_arrows(axes: Axes, fields: AnyDataset, u: np.ndarray, v: np.ndarray) -> None:
    """Arrows of one length along a vector field over (y, x), where both surfaces exist and it moves."""
    width, height = panel_size(axes)
    step = np.sqrt(width * height / ARROWS)
    sides = ((axes.get_xlim(), width), (axes.get_ylim(), height))
    x, y = (
        low + (high - low) * (np.arange(count) + 0.5) / count
        for (low, high), count in ((limits, max(1, round(side / step))) for limits, side in sides)
    )
    covered = field(fields, "covered") > 0.5
    u, v = (at_places(fields, np.where(covered, part, np.nan), x, y).ravel() for part in (u, v))
    size = np.hypot(u, v)
    moving = size > STANDSTILL * np.nanmax(size, initial=0)
    # As long as this looks where the panel is stretched along y.
    stretched = np.stack([u, v * axes.get_aspect()])[:, moving]
    origins = [part.ravel()[moving] for part in np.meshgrid(x, y)]
    axes.quiver(
        *origins,
        *(stretched / np.hypot(*stretched)),
        pivot="middle",
        units="inches",
        scale=2.5 / step,
        width=0.022,
        color="white",
        edgecolor="black",
        linewidth=0.5,
        zorder=3,
    )


def at_places(fields: AnyDataset, values: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Values over the nodes of fields, (y, x), at places x and y [mm] between them."""
    for axis, (known, places) in enumerate(zip(nodes(fields)[::-1], (y, x), strict=True)):
        values = _between_nodes(known, values, places, axis)
    return values


def draw_contact_point(axes: Axes) -> None:
    """A cross at the contact point, the origin of the tangent plane."""
    axes.plot(0, 0, "+", color="black", markersize=9, markeredgewidth=2.6)
    axes.plot(0, 0, "+", color="white", markersize=8, markeredgewidth=1.2)


def _between_nodes(
    known: np.ndarray, values: np.ndarray, places: np.ndarray, axis: int
) -> np.ndarray:
    """Values along one of their axes at places between nodes, linearly; the outermost beyond them."""
    position = np.interp(places, known, np.arange(known.size))
    first = np.minimum(whole(position), known.size - 2)
    weight = (position - first).reshape(-1, *[1] * (1 - axis))
    before, behind = (np.take(values, first + step, axis) for step in (0, 1))
    return before + weight * (behind - before)
