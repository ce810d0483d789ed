"""Pressure maps of the dry and of the lubricated contact."""

import numpy as np
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from pyworm.plots.contact.outline import signed_square
from pyworm.plots.layout import MEGA, MILLI, colour_bar, contact_window, heading, in_window, panels
from pyworm.plots.overlays import draw_dry_outline, draw_tooth
from pyworm.solver.solution import Solution


def draw_pressure(case_name: str, solution: Solution) -> Figure:
    """Dry and film pressure, and the asperities', on one scale, each with the outline of the dry contact."""
    window = contact_window(solution.fields)
    fields = in_window(solution.fields, window)
    maps = {"dry contact": fields["dry_pressure"], "oil film": fields["pressure"]}
    if "asperity_pressure" in fields:
        maps = {
            "dry contact": fields["dry_pressure"],
            "oil and asperities": fields["pressure"],
            "asperities": fields["asperity_pressure"],
        }
    shown = {title: field.transpose("y", "x").values * MEGA for title, field in maps.items()}
    titles = [f"{title}: at most {values.max():.4g} MPa" for title, values in shown.items()]
    figure, axes = panels(window, titles, heading(case_name, solution))
    top = max(float(values.max()) for values in shown.values())
    levels = np.asarray(MaxNLocator(10).tick_values(0, top if top > 0 else 1), float)
    # Nearly no pressure is left white, so that the reach of the pressure can be seen.
    lowest = levels[1] / 10
    bounds = np.append(lowest, levels[1:])
    colours = ListedColormap(colormaps["inferno"](np.linspace(0.15, 1, levels.size - 1)))
    scale = ScalarMappable(BoundaryNorm(bounds, colours.N), colours)
    for panel, values in zip(axes, shown.values(), strict=True):
        x, y = fields["x"].values * MILLI, fields["y"].values * MILLI
        # Squared, a dry pressure is linear at its boundary, where contours of it would be stepped.
        squares, levels_squared = signed_square(values), bounds**2
        panel.contourf(x, y, squares, levels=levels_squared, colors=colours.colors)
        panel.contour(
            x, y, squares, levels=levels_squared[1:], colors="white", linewidths=0.4, alpha=0.6
        )
        draw_tooth(panel, fields)
        draw_dry_outline(panel, fields, "tab:cyan")
        colour_bar(panel, scale, "pressure / MPa", bounds)
    return figure
