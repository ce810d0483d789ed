"""Maps of a limited supply: how far the gap is filled, and the layer of oil that is carried."""

import numpy as np
from matplotlib.figure import Figure

from pyworm.io.present import present
from pyworm.plots.layout import (
    MICRO,
    MILLI,
    colour_bar,
    heading,
    panels,
    whole_window,
)
from pyworm.plots.overlays import draw_dry_outline, draw_tooth
from pyworm.solver.solution import Solution

THICKEST = 2.5
"""Thickest layer shown, over the central film."""


def draw_supply(case_name: str, solution: Solution) -> Figure:
    """Fraction of the gap that oil fills, and the thickness of the oil, in the whole window."""
    fields = solution.dataset("fields")
    figures = solution.figures
    titles = [
        "oil over gap: 1 where the gap is full",
        f"oil in the gap: {present(figures.supply, 'supply').supply_ratio:.2g} of the flooded film supplied",
    ]
    figure, axes = panels(whole_window(fields), titles, heading(case_name, solution))
    x, y = (fields[axis].values * MILLI for axis in "xy")
    fraction = fields["oil_fraction"].transpose("y", "x").values
    film = fields["film"].transpose("y", "x").values
    thickest = THICKEST * figures.film_central.value * MICRO
    maps = (
        (fraction, 1.0, "fraction filled", "cividis"),
        (np.minimum(fraction * film * MICRO, thickest), thickest, "oil / µm", "viridis"),
    )
    for panel, (field, top, label, colours) in zip(axes, maps, strict=True):
        shown = panel.pcolormesh(
            x, y, field, vmin=0.0, vmax=top, cmap=colours, shading="nearest", rasterized=True
        )
        draw_tooth(panel, fields)
        draw_dry_outline(panel, fields, "white")
        colour_bar(panel, shown, label)
    return figure
