"""Temperature maps of both surfaces and of the middle of the film."""

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.quantities import BODIES
from pyworm.plots.layout import (
    MILLI,
    colour_bar,
    contact_window,
    heading,
    in_window,
    panels,
)
from pyworm.plots.overlays import draw_arrows, draw_dry_outline, draw_tooth
from pyworm.solver.solution import Solution

BANDS = 12
"""Bands of temperature between the coldest and the hottest."""

LEAST_RANGE = 0.1
"""Least range of the scale [K]: below it a map would show rounding, not heat."""


def draw_temperature(
    case_name: str, solution: Solution, bodies: tuple[str, str] = BODIES
) -> Figure:
    """Both surfaces, with the direction in which each moves, and the middle of the film, on one scale."""
    whole = solution.dataset("fields")
    window = contact_window(whole)
    fields = in_window(whole, window)
    parts = ("body_1", "body_2", "middle")
    maps = [
        fields[f"temperature_{part}"].transpose("y", "x").values - ZERO_CELSIUS for part in parts
    ]
    figures = solution.figures
    titles = [
        f"{name}: at most {estimate.value - ZERO_CELSIUS:.1f} °C{note}"
        for name, estimate, note in (
            (f"surface of {bodies[0]}", figures.temperature_max_body_1, " (arrows: its motion)"),
            (f"surface of {bodies[1]}", figures.temperature_max_body_2, " (arrows: its motion)"),
            ("film", figures.temperature_max_film, " (map: its middle)"),
        )
        if estimate is not None
    ]
    figure, axes = panels(window, titles, heading(case_name, solution))
    coldest = min(values.min() for values in maps)
    hottest = max(coldest + LEAST_RANGE, max(values.max() for values in maps))
    bounds = np.asarray(MaxNLocator(BANDS).tick_values(coldest, hottest))
    colours = ListedColormap(colormaps["inferno"](np.linspace(0.05, 1, bounds.size - 1)))
    scale = ScalarMappable(BoundaryNorm(bounds, colours.N), colours)
    for panel, values in zip(axes, maps, strict=True):
        _draw_map(
            panel, fields["x"].values * MILLI, fields["y"].values * MILLI, values, scale, bounds
        )
        draw_tooth(panel, fields)
        draw_dry_outline(panel, fields, "tab:cyan")
        colour_bar(panel, scale, "temperature / °C", bounds)
    mean, sliding = (
        [fields[f"{of}_{axis}"].transpose("y", "x").values for axis in "xy"]
        for of in ("entrainment", "sliding")
    )
    for panel, sign in zip(axes[:2], (1, -1), strict=True):
        motion = (u + sign / 2 * du for u, du in zip(mean, sliding, strict=True))
        draw_arrows(panel, fields, *motion)
    _mark_hottest(axes[2], solution)
    return figure


def _draw_map(
    axes: Axes,
    x: np.ndarray,
    y: np.ndarray,
    values: np.ndarray,
    scale: ScalarMappable,
    boundaries: np.ndarray,
) -> None:
    axes.contourf(x, y, values, levels=boundaries, cmap=scale.cmap, norm=scale.norm)
    lines = boundaries[(boundaries > values.min()) & (boundaries < values.max())]
    if lines.size:
        axes.contour(x, y, values, levels=lines, colors="white", linewidths=0.4, alpha=0.6)


def _mark_hottest(axes: Axes, solution: Solution) -> None:
    """A circle where the profile across the film is taken."""
    profile = solution.dataset("profile")
    place = [float(profile[f"profile_{axis}"].values) * MILLI for axis in "xy"]
    axes.plot(
        *place,
        "o",
        markersize=8,
        markerfacecolor="none",
        markeredgecolor="tab:cyan",
        markeredgewidth=1.5,
    )
