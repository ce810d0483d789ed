"""The mesh cycle of a drive over phase."""

from collections.abc import Callable
from functools import partial

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullLocator

from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import QUANTITIES
from pyworm.plots.drives.picture import CyclePicture
from pyworm.plots.drives.worm_flank import draw_flank
from pyworm.plots.drives.worm_pattern import draw_pattern
from pyworm.plots.drives.worm_thread import draw_thread
from pyworm.plots.error_bars import draw_figure, draw_largest_temperatures, estimates_of
from pyworm.plots.layout import (
    KILO,
    MICRO,
    MILLI,
    add_grids,
    broken,
    mark_gaps,
    placed_panels,
    result_heading,
    scale_from_zero,
)
from pyworm.ratings.standard_loss import StandardLoss, standard_of_result
from pyworm.result.headline import of_all
from pyworm.result.mesh_cycle import phase_of
from pyworm.result.result import Result
from pyworm.solver.neglected_effects import AS_IF_SMOOTH
from pyworm.solver.solution import Solution

DIRECTIONS = {"x": "to the wheel", "y": "along the wheel's axis", "z": "along the worm's axis"}
"""Axis of the drive frame -> its direction."""

LEAST_TRANSMISSION_ERROR = 0.01
"""Range of the transmission error to either side of zero that is drawn at least [µrad]: flanks that
transmit without error have that of rounding."""


def draw_cycle(result: Result) -> Figure:
    """Transmission error, radii, contact point, load; what was solved: films, friction, temperatures."""
    cycle = result.cycle_data
    in_mesh = [solution for solution in result.solutions if solution.phase is not None]
    solved = sorted(in_mesh, key=phase_of)
    sheared = [solution for solution in solved if solution.figures.friction_coefficient is not None]
    heated = [solution for solution in solved if solution.figures.temperature_max_film is not None]
    drawn: list[Callable[[Axes], None]] = [
        partial(_draw_transmission_error, cycle=cycle),
        partial(_draw_radii, cycle=cycle),
        partial(_draw_contact_point, cycle=cycle),
    ]
    if "tooth_load" in cycle:
        drawn.append(partial(_draw_tooth_load, cycle=cycle))
    if solved:
        drawn.append(partial(_draw_solutions, solved=solved))
    if sheared:
        drawn.append(partial(_draw_friction, sheared=sheared, standard=_beside(result, sheared)))
    if heated:
        drawn.append(partial(_draw_temperatures, heated=heated))
    size, room = (8, 2.3 * len(drawn) + 0.6), (1.0, 1.0, 0.5, 0.1)
    words = result_heading(result, "mesh cycle")
    figure, axes = placed_panels(size, words, room, len(drawn), space=0.07, sharex=True)
    for panel, draw in zip(axes, drawn, strict=True):
        draw(panel)
    add_grids(axes)
    axes[-1].set_xlabel("mesh phase (0: first contact, 1: last contact)")
    return figure


def _draw_transmission_error(axes: Axes, cycle: "xr.Dataset") -> None:
    error = cycle["transmission_error"] * MICRO
    axes.plot(cycle["phase"], error, color="black")
    if abs(error).max() < LEAST_TRANSMISSION_ERROR:
        axes.set_ylim(-LEAST_TRANSMISSION_ERROR, LEAST_TRANSMISSION_ERROR)
    axes.set_ylabel("transmission\nerror / µrad")


def _draw_radii(axes: Axes, cycle: "xr.Dataset") -> None:
    """Both radii, whose ratio is large, on a logarithmic scale."""
    for name, label, colour in (
        ("radius_x", "along the contact (x)", "tab:blue"),
        ("radius_y", "across it (y)", "tab:orange"),
    ):
        axes.semilogy(cycle["phase"], cycle[name] * MILLI, color=colour, label=label)
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_minor_locator(NullLocator())
    axes.set_ylabel("radius of relative\ncurvature / mm")
    axes.legend(frameon=False, ncols=2)


def _draw_contact_point(axes: Axes, cycle: "xr.Dataset") -> None:
    """The contact point less its mean, so that its three components share a scale."""
    mean = cycle["point"].mean("phase")
    for axis in cycle["axis"].values:
        here = mean.sel(axis=axis).item() * MILLI
        place = cycle["point"].sel(axis=axis) * MILLI - here
        label = f"{axis}, {DIRECTIONS[axis]}, from {here:.1f} mm"
        axes.plot(cycle["phase"], place, label=label)
    axes.set_ylabel("contact point\n/ mm")
    axes.legend(frameon=False, fontsize="small")


def _draw_tooth_load(axes: Axes, cycle: "xr.Dataset") -> None:
    """Normal load of a tooth pair, also beyond the unloaded cycle, and the turn of the wheel."""
    phase, load = cycle["load_phase"], cycle["tooth_load"]
    carrying = phase.values[load.values > 0]
    axes.plot(phase, load * KILO, color="tab:brown")
    axes.set_xlim(min(carrying[0], 0) - 0.02, max(carrying[-1], 1) + 0.02)
    axes.set_ylim(0, 1.15 * float(load.max()) * KILO)
    axes.set_ylabel("load of a\ntooth pair / kN", color="tab:brown")
    if float(cycle["wheel_turn"].max()) > 0:
        turn_axes = axes.twinx()
        turn_axes.plot(phase, cycle["wheel_turn"] * MICRO, "--", color="0.3")
        turn_axes.set_ylabel(f"{broken(QUANTITIES['wheel_turn'].axis())} (dashed)")


def _draw_temperatures(axes: Axes, heated: list[Solution]) -> None:
    phases = [phase_of(solution) for solution in heated]
    draw_largest_temperatures(axes, phases, heated, ("worm", "wheel"))


def _draw_solutions(axes: Axes, solved: list[Solution]) -> None:
    """Films with their error bars, and the largest pressure on its own scale."""
    phase = np.array([phase_of(solution) for solution in solved])
    for name, colour in (("film_central", "tab:blue"), ("film_min", "tab:green")):
        style = {"fmt": "o-", "color": colour, "capsize": 3, "label": QUANTITIES[name].words()}
        draw_figure(axes, phase, solved, name, style)
    mark_gaps(axes, phase, solved)
    axes.set_ylim(0, 1.25 * axes.get_ylim()[1])  # room for the legend
    axes.set_ylabel(broken(QUANTITIES["film"].axis()))
    _draw_beside(axes, phase, solved, "pressure_max", broken(QUANTITIES["pressure_max"].axis()))
    axes.legend(frameon=False, ncols=2, loc="upper center")


def _draw_beside(
    axes: Axes, phase: np.ndarray, solved: list[Solution], name: str, label: str
) -> None:
    """A figure on its own scale on the right, from zero on."""
    right = axes.twinx()
    _, values, _ = estimates_of(solved, name)
    right.plot(phase, values, "s--", color="tab:red", markersize=4)
    scale_from_zero(right, values, 1.3)
    right.set_ylabel(label, color="tab:red")


def _beside(result: Result, sheared: list[Solution]) -> StandardLoss | None:
    """The standard's friction, to be drawn beside that of teeth as if smooth; None where there is none."""
    standard = standard_of_result(result) if sheared and of_all(sheared).as_if_smooth else None
    return standard if isinstance(standard, StandardLoss) else None


def _draw_friction(axes: Axes, sheared: list[Solution], standard: StandardLoss | None) -> None:
    """Friction coefficient with its error bars, and power loss on its own scale; a standard's friction."""
    phase = np.array([phase_of(solution) for solution in sheared])
    style = {"fmt": "o-", "color": "tab:purple", "capsize": 3}
    scaled = draw_figure(axes, phase, sheared, "friction_coefficient", style)
    mark_gaps(axes, phase, sheared)
    if standard is not None:
        label = f"rough teeth by the standard: {standard.friction:.3g}"
        axes.axhline(standard.friction, color="tab:purple", linestyle=":", label=label)
        axes.legend(frameon=False, loc="upper center")
        scaled = np.append(scaled, standard.friction)
    scale_from_zero(axes, scaled, 1.3)
    labels = [QUANTITIES[name].axis() for name in ("friction_coefficient", "power_loss")]
    rough = of_all(sheared).as_if_smooth
    coefficient, loss = (f"{label}\n{AS_IF_SMOOTH}" if rough else broken(label) for label in labels)
    axes.set_ylabel(coefficient, color="tab:purple")
    _draw_beside(axes, phase, sheared, "power_loss", loss)


CYCLE_PICTURES = {
    "mesh_cycle": CyclePicture("Mesh cycle", draw_cycle),
    "contact_pattern": CyclePicture("Contact pattern", draw_pattern, signed=True),
    "mesh_cycle_flank": CyclePicture("The wheel's flank after a mesh cycle", draw_flank, True),
    "mesh_cycle_thread": CyclePicture("Fatigue of the worm's thread", draw_thread, True),
}
"""File name -> picture of the mesh cycle."""
