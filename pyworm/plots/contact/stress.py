"""Stress below the surface of the more stressed body: sections through its maximum, and over depth."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from pyworm.formulas.arrays import Array
from pyworm.formulas.stress_invariants import max_shear_stress, von_mises
from pyworm.io.present import present
from pyworm.io.quantities import BODIES, QUANTITIES
from pyworm.plots.layout import (
    MEGA,
    MICRO,
    MILLI,
    add_grids,
    figure_of,
    heading,
    joined,
    placed_panels,
)
from pyworm.solver.estimate import in_words
from pyworm.solver.solution import Solution
from pyworm.solver.stress.subsurface import StressMaximum, maximum_below, stress_below

DEPTHS_SHOWN, DEPTH_REACH = 40, 1.8
"""Number of depths, and the largest over the half-width of the contact."""

CELLS_SHOWN = 14
"""Least number of cells of the grid to the half-width, as far as that of the film has them."""

SHOWN_PRESSURE, SHOWN_MARGIN = 0.02, 0.2
"""Pressure over the largest up to which sections reach, and what they reach beyond over that."""

BANDS = 14
"""Bands of colour at most."""


def draw_stress(case_name: str, solution: Solution, bodies: tuple[str, str] = BODIES) -> Figure:
    """Von Mises stress on sections through its maximum, and the largest at each depth, of one body."""
    stress = present(solution.figures.stress, "stress")
    largest = stress.von_mises_max_body_1, stress.von_mises_max_body_2
    body = 1 if largest[0] >= largest[1] else 2
    below = stress_below(solution, body)
    depth = (stress.depth_body_1, stress.depth_body_2)[body - 1]
    position = maximum_below(below, von_mises, solution, depth).position
    peak = StressMaximum(largest[body - 1], depth, position)
    grid = below.grid(below.level_for(below.half_width, CELLS_SHOWN)).widened(SHOWN_MARGIN)
    depths = np.linspace(0, max(DEPTH_REACH * below.half_width, 1.2 * peak.depth), DEPTHS_SHOWN)
    components = below.stress(grid, depths)
    field = von_mises(components)
    axes = grid.axes()
    what = joined(heading(case_name, solution), f"stress below the surface of {bodies[body - 1]}")
    figure, panels = placed_panels(
        (5.2 * len(axes) + 3.6, 5.0), what, (0.8, 0.3, 1.45, 0.65), columns=len(axes) + 1, space=0.3
    )
    levels = MaxNLocator(BANDS).tick_values(0, peak.value.value * MEGA)
    for number, (panel, axis) in enumerate(zip(panels[:-1], axes, strict=True)):
        _section(panel, number, axes, depths, field, peak, levels)
        panel.set_xlim(*_reach(grid.pressure, axis, number))
    _profile(panels[-1], depths, field, max_shear_stress(components), peak)
    for panel in panels:
        panel.set_ylim(depths[-1] * MICRO, 0)
        panel.set_ylabel("depth / µm")
    return figure


def _section(
    panel: Axes,
    number: int,
    axes: tuple[Array, ...],
    depths: Array,
    field: Array,
    peak: StressMaximum,
    levels: Sequence[float],
) -> None:
    """Stress over depth and one direction through the maximum."""
    nodes = [
        int(np.abs(axis - place).argmin()) for axis, place in zip(axes, peak.position, strict=True)
    ]
    others = tuple(slice(None) if axis == number else node for axis, node in enumerate(nodes))
    section = field[(slice(None), *others)] * MEGA
    colours = panel.contourf(
        axes[number] * MILLI, depths * MICRO, section, levels, cmap=QUANTITIES["von_mises"].colours
    )
    panel.plot(
        peak.position[number] * MILLI, peak.depth * MICRO, "+", color="tab:cyan", markersize=12
    )
    panel.set_xlabel(f"{'xy'[number]} / mm")
    if len(axes) > 1:
        through = round(peak.position[1 - number] * MILLI, 3) + 0.0
        panel.set_title(f"through {'yx'[number]} = {through:g} mm", fontsize="medium")
    figure_of(panel).colorbar(
        colours,
        cax=panel.inset_axes((0, -0.3, 1, 0.05)),
        orientation="horizontal",
        label=QUANTITIES["von_mises"].axis(),
        ticks=levels[::2],
    )


def _profile(panel: Axes, depths: Array, field: Array, shear: Array, peak: StressMaximum) -> None:
    """Largest equivalent and shear stress at each depth, and the maximum with its uncertainty."""
    for values, label in ((field, "von Mises"), (shear, "maximum shear")):
        largest = values.reshape(len(depths), -1).max(axis=1)
        panel.plot(largest * MEGA, depths * MICRO, label=label)
    value = peak.value
    text = in_words(value, QUANTITIES["von_mises"])
    panel.set_title(
        f"von Mises at most {text}\n{peak.depth * MICRO:.3g} µm below the surface",
        fontsize="medium",
    )
    panel.errorbar(
        value.value * MEGA,
        peak.depth * MICRO,
        xerr=value.bar * MEGA,
        fmt="+",
        color="black",
        markersize=10,
    )
    panel.set_xlim(left=0)
    panel.set_xlabel("largest stress at a depth / MPa")
    panel.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2), ncols=2, frameon=False)
    add_grids([panel])


def _reach(pressure: Array, axis: Array, number: int) -> tuple[float, float]:
    """Ends of a section [mm]: of the part that bears pressure, and more."""
    others = tuple(other for other in range(pressure.ndim) if other != number)
    bearing = axis[(pressure > SHOWN_PRESSURE * pressure.max()).any(axis=others)] * MILLI
    more = SHOWN_MARGIN * (bearing[-1] - bearing[0])
    return (
        max(bearing[0] - more, axis[0] * MILLI),
        min(bearing[-1] + more, axis[-1] * MILLI),
    )
