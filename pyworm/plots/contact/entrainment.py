"""Streamlines of the entrainment."""

import numpy as np
from matplotlib.figure import Figure

from pyworm.plots.layout import (
    colour_bar,
    contact_window,
    field,
    heading,
    in_window,
    nodes,
    panels,
)
from pyworm.plots.overlays import draw_contact_point, draw_dry_outline, draw_tooth
from pyworm.solver.solution import Solution

LINES = 20
"""Streamlines in a picture."""

UNIFORM = 1e-3
"""Relative range of speed below which a map would show rounding, not motion."""


def draw_entrainment(case_name: str, solution: Solution) -> Figure:
    """Streamlines of the mean surface velocity over its speed, and the dry contact.

    Equal flow enters the picture between neighbouring lines.
    """
    window = contact_window(solution.fields)
    fields = in_window(solution.fields, window)
    u, v = (field(fields, f"entrainment_{axis}") for axis in "xy")
    speed = np.hypot(u, v)
    uniform = np.ptp(speed) <= UNIFORM * speed.max()
    title = f"entrainment, {speed.mean():.3g} m/s all over" if uniform else "entrainment"
    figure, (axes,) = panels(window, [title], heading(case_name, solution))
    x, y = nodes(fields)
    if not uniform:
        bands = axes.contourf(x, y, speed, levels=24, cmap="cividis")
        colour_bar(axes, bands, "entrainment speed / (m/s)")
    # Streamlines want exactly even spacing, which the coordinates have but for rounding.
    axes.streamplot(
        np.linspace(x[0], x[-1], x.size),
        np.linspace(y[0], y[-1], y.size),
        u,
        v,
        color="tab:blue" if uniform else "white",
        linewidth=0.8,
        arrowsize=0.9,
        density=4,
        start_points=inflow_points(x, y, u, v),
        integration_direction="forward",
        broken_streamlines=False,
    )
    draw_tooth(axes, fields)
    draw_dry_outline(axes, fields, "tab:red")
    draw_contact_point(axes)
    axes.set_xlim(window.left, window.right)
    axes.set_ylim(window.bottom, window.top)
    return figure


def inflow_points(x: np.ndarray, y: np.ndarray, u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Points (x, y) of the border with equal flow into the picture between them."""
    left, right = np.full(y.size, x[0]), np.full(y.size, x[-1])
    bottom, top = np.full(x.size, y[0]), np.full(x.size, y[-1])
    # Once around: bottom, right, top, left, with the velocity into the picture on each side.
    around_x = np.concatenate([x, right, x[::-1], left])
    around_y = np.concatenate([bottom, y, top, y[::-1]])
    inward = np.concatenate([v[0], -u[:, -1], -v[-1, ::-1], u[::-1, 0]])
    length = np.hypot(np.diff(around_x), np.diff(around_y))
    inflow = np.maximum(inward, 0)
    flow = np.append(0, np.cumsum(length * (inflow[1:] + inflow[:-1]) / 2))
    fraction = flow[-1] * (np.arange(LINES) + 0.5) / LINES
    around = (np.interp(fraction, flow, side) for side in (around_x, around_y))
    points = np.stack([*around], axis=1)
    # A hair inside, since rounding would put some of them outside.
    centre = np.array([x[0] + x[-1], y[0] + y[-1]]) / 2
    return points + 1e-6 * (centre - points)
