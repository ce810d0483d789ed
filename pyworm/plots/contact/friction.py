"""Maps of the shear stress in the middle of the film and of the heat that its shear makes."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from pyworm.io.plain_dataset import AnyDataset
from pyworm.io.present import present
from pyworm.io.quantities import BODIES
from pyworm.plots.layout import (
    MEGA,
    MILLI,
    colour_bar,
    contact_window,
    heading,
    in_window,
    panels,
)
from pyworm.plots.overlays import draw_arrows, draw_dry_outline, draw_tooth
from pyworm.solver.left_out import AS_IF_SMOOTH
from pyworm.solver.solution import Solution

BANDS = 12
"""Bands between nothing and the largest value."""


def draw_friction(case_name: str, solution: Solution, bodies: tuple[str, str] = BODIES) -> Figure:
    """Shear stress, its direction on the first body and where it reaches the limit, and friction power."""
    whole = solution.dataset("fields")
    window = contact_window(whole)
    fields = in_window(whole, window)
    figures = solution.figures
    friction = present(figures.friction_coefficient, "friction_coefficient")
    loss = present(figures.power_loss, "power_loss")
    stresses = [fields[f"shear_stress_{axis}"].transpose("y", "x").values for axis in "xy"]
    stress = np.hypot(*stresses) * MEGA
    power = fields["friction_power"].transpose("y", "x").values * MEGA
    smooth = f" {AS_IF_SMOOTH}" if solution.left_out.as_if_smooth else ""
    titles = [
        f"shear stress in the middle (arrows: on {bodies[0]}): at most {stress.max():.3g} MPa, "
        f"friction coefficient {friction.value:.3g}{smooth}",
        f"friction power: at most {power.max():.3g} W/mm², in all {_power(loss.value)}{smooth}",
    ]
    figure, (stress_axes, power_axes) = panels(window, titles, heading(case_name, solution))
    _draw_map(stress_axes, fields, stress, "viridis", "shear stress / MPa")
    draw_arrows(stress_axes, fields, *stresses)
    _draw_slip(stress_axes, fields)
    _draw_map(power_axes, fields, power, "inferno", "friction power / (W/mm²)")
    return figure


def _draw_map(axes: Axes, fields: AnyDataset, values: np.ndarray, colours: str, label: str) -> None:
    x, y = fields["x"].values * MILLI, fields["y"].values * MILLI
    top = values.max()
    levels = np.asarray(MaxNLocator(BANDS).tick_values(0, top if top > 0 else 1))
    bands = axes.contourf(x, y, values, levels=levels, cmap=colours)
    draw_tooth(axes, fields)
    draw_dry_outline(axes, fields, "tab:cyan")
    colour_bar(axes, bands, label, levels)


def _draw_slip(axes: Axes, fields: AnyDataset) -> None:
    """Hatches where the limiting stress is reached at a surface."""
    slip = fields["slip"].transpose("y", "x").values
    if slip.max() == 0:
        return
    x, y = fields["x"].values * MILLI, fields["y"].values * MILLI
    axes.contourf(x, y, slip, levels=[0.5, 3.5], colors="none", hatches=["xxx"])
    axes.legend(handles=[Patch(facecolor="none", edgecolor="black", hatch="xxx", label="slip")])


def _power(watts: float) -> str:
    return f"{watts / 1e3:.3g} kW" if watts >= 1e3 else f"{watts:.3g} W"
