"""Minimum film, asperity load ratio and temperature of a gear set over speed and load."""

import numpy as np
from matplotlib.figure import Figure

from pyworm.formulas.unit_factors import RPM
from pyworm.io.quantities import QUANTITIES
from pyworm.plots.layout import new_figure
from pyworm.ratings.operating_map import MAPPED_QUANTITIES, OperatingMap


def draw_operating_map(name: str, found: OperatingMap) -> Figure:
    """A map for each quantity, with its values."""
    figure = new_figure(10.5, 7.2, f"{name} · extremes over the engagement, closed forms")
    speeds, torques = np.array(found.speeds) * RPM, np.array(found.torques)
    for axes, quantity in zip(figure.subplots(2, 2).flat, MAPPED_QUANTITIES, strict=True):
        shown = QUANTITIES[quantity]
        numbers = shown.number(found.values[quantity]).T
        colours = "viridis" if shown.extreme == "minimum" else "inferno"
        mesh = axes.pcolormesh(
            np.arange(speeds.size), np.arange(torques.size), numbers, cmap=colours
        )
        figure.colorbar(mesh, ax=axes, label=shown.axis(shown.worst()))
        middle = np.nanmin(numbers) + 0.55 * np.ptp(numbers[np.isfinite(numbers)])
        for (row, column), number in np.ndenumerate(numbers):
            ink = "white" if number < middle else "black"
            axes.text(column, row, f"{number:.3g}", ha="center", va="center", color=ink, size=8)
        axes.set_xticks(np.arange(speeds.size), [f"{speed:.4g}" for speed in speeds])
        axes.set_yticks(np.arange(torques.size), [f"{torque:.4g}" for torque in torques])
        axes.set_xlabel("speed of the first shaft / rpm")
        axes.set_ylabel("torque of the second shaft / (N m)")
    return figure
