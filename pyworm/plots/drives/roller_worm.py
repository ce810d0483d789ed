"""Film, load and motion along a roller's path through both sections, and sensitivities of its film."""

from collections.abc import Iterator

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.formulas.lubrication import BOUNDARY, FULL_FILM
from pyworm.formulas.unit_factors import RPM
from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import QUANTITIES
from pyworm.plots.drives.picture import CyclePicture
from pyworm.plots.drives.roller_worm_drive import SECTION_COLOURS, draw_roller_drive
from pyworm.plots.drives.roller_worm_fatigue import draw_roller_fatigue
from pyworm.plots.drives.roller_worm_regimes import draw_roller_regimes
from pyworm.plots.drives.roller_worm_rotation import draw_roller_rotation
from pyworm.plots.error_bars import draw_figure
from pyworm.plots.layout import (
    MICRO,
    MILLI,
    Style,
    add_grids,
    broken,
    mark_gaps,
    placed_panels,
    result_heading,
)
from pyworm.result.mesh_cycle import phase_of
from pyworm.result.result import Result
from pyworm.solver.solution import Solution


def draw_roller_cycle(result: Result) -> Figure:
    """Film, load, velocities and specific film over the wheel angle of a roller."""
    cycle = result.cycle_data
    words, room = result_heading(result, "path of a roller through both sections"), ROOM
    figure, axes = placed_panels((9, 11), words, room, rows=4, space=0.08, sharex=True)
    _draw_film(axes[0], cycle, result.solutions)
    _draw_load(axes[1], cycle)
    _draw_motion(axes[2], cycle)
    _draw_lambda(axes[3], cycle)
    add_grids(axes)
    first, last = throat(cycle)
    for panel in axes if first < last else ():
        panel.axvspan(first, last, color="0.93", zorder=0)
    axes[-1].set_xlabel("wheel angle of the roller / ° (motion from left to right)")
    return figure


ROOM = 0.8, 0.85, 0.5, 0.1
"""Room left of panels with two axes, right of them, below and above [inch]."""


def throat(cycle: "xr.Dataset") -> tuple[float, float]:
    """Wheel angles between the sections [deg]."""
    angle = cycle["wheel_angle"] * (180 / np.pi)
    return float(angle.sel(section="right")[-1]), float(angle.sel(section="left")[0])


def _sections(cycle: "xr.Dataset") -> Iterator[tuple[str, "xr.Dataset", np.ndarray]]:
    """Colour of each section, its part of the cycle, and the wheel angles there [deg]."""
    for section, colour in SECTION_COLOURS.items():
        cycle_part = cycle.sel(section=section)
        yield colour, cycle_part, np.degrees(cycle_part["wheel_angle"])


def _draw_film(axes: Axes, cycle: "xr.Dataset", solutions: tuple[Solution, ...]) -> None:
    """Closed forms as lines, solved films with their error bars, and every roller of one instant."""
    for colour, cycle_part, angle in _sections(cycle):
        least = cycle_part["formula_film_min"].min("station") * MICRO
        most = cycle_part["formula_film_min"].max("station") * MICRO
        axes.fill_between(angle, least, most, color=colour, alpha=0.25, lw=0)
        middle = cycle_part.isel(station=cycle_part.sizes["station"] // 2)
        axes.plot(angle, middle["formula_film_min"] * MICRO, color=colour, lw=1.5)
        axes.plot(angle, middle["printed_film_min"] * MICRO, color=colour, lw=1.2, ls=":")
        section = cycle_part["section"].item()
        if solved := [solution for solution in solutions if solution.section == section]:
            phases = [phase_of(solution) for solution in solved]
            angles = np.interp(phases, cycle_part["phase"], angle)
            style = {"fmt": "k.", "ms": 5, "capsize": 2, "lw": 0.8}
            draw_figure(axes, angles, solved, "film_min", style)
            mark_gaps(axes, angles, solved)
        pitch = np.degrees(cycle.attrs["roller_pitch"])
        mesh = np.arange(np.ceil(angle[0] / pitch), np.floor(angle[-1] / pitch) + 1) * pitch
        film = np.interp(mesh, angle, middle["formula_film_min"] * MICRO)
        axes.plot(mesh, film, "o", mfc="none", mec=colour, ms=9)
    for kind, label in (
        ({"color": "0.3", "lw": 1.5}, "Dowson and Higginson, middle of the line"),
        ({"color": "0.3", "lw": 6, "alpha": 0.25}, "all along the line"),
        ({"color": "0.3", "lw": 1.2, "ls": ":"}, "the source's formula"),
        ({"color": "black", "marker": ".", "ls": ""}, "solved"),
        ({"mec": "0.3", "marker": "o", "mfc": "none", "ms": 9, "ls": ""}, "rollers of one instant"),
    ):
        axes.plot([], [], label=label, **kind)
    axes.set_ylim(bottom=0)
    axes.set_ylabel(QUANTITIES["film_min"].axis())
    axes.legend(frameon=False, ncols=2, fontsize=8, loc="upper center")
    driving = cycle.attrs.get("driving", "left")
    ends = (
        (section, "driving" if section == driving else "idling", place, ha)
        for section, place, ha in (("right", 0.02, "left"), ("left", 0.98, "right"))
    )
    for section, runs, place, ha in ends:
        look: Style = {"color": SECTION_COLOURS[section], "transform": axes.transAxes, "ha": ha}
        axes.text(place, 0.06, f"{section} section, {runs}", **look)


def _draw_load(axes: Axes, cycle: "xr.Dataset") -> None:
    """Load of the roller, and for each length in the middle of its line."""
    other = axes.twinx()
    for colour, cycle_part, angle in _sections(cycle):
        axes.plot(angle, cycle_part["roller_force"], color=colour)
        middle = cycle_part["load_per_length"].isel(station=cycle_part.sizes["station"] // 2)
        other.plot(angle, middle / 1e3, color=colour, ls="--")
    axes.set_ylim(bottom=0)
    other.set_ylim(bottom=0)
    axes.set_ylabel("load of a roller / N")
    other.set_ylabel("load per length / (kN/m) (dashed)")


def _draw_motion(axes: Axes, cycle: "xr.Dataset") -> None:
    """Velocities across the line at its ends and in its middle, and the roller's own speed."""
    other = axes.twinx()
    for colour, cycle_part, angle in _sections(cycle):
        worm, roller = cycle_part["worm_velocity"], cycle_part["roller_velocity"]
        ends = worm.min("station"), worm.max("station")
        axes.fill_between(angle, *ends, color=colour, alpha=0.3, lw=0)
        axes.plot(angle, roller.mean("station"), color=colour)
        other.plot(angle, abs(cycle_part["roller_speed"]) * RPM / 1e3, color=colour, ls="--")
    axes.fill_between([], [], [], color="0.3", alpha=0.3, lw=0, label="worm, all along the line")
    axes.plot([], [], color="0.3", label="roller")
    axes.set_ylim(bottom=0)
    other.set_ylim(bottom=0)
    axes.set_ylabel("velocity across\nthe line / (m/s)")
    other.set_ylabel("roller about its axis\n/ 1000 rpm (dashed)")
    axes.legend(frameon=False, fontsize=8, loc="upper center")


def _draw_lambda(axes: Axes, cycle: "xr.Dataset") -> None:
    """Specific film of the closed form along the whole line, and what heat takes from the film."""
    other = axes.twinx()
    for colour, cycle_part, angle in _sections(cycle):
        ratio = cycle_part["specific_film"]
        ends = ratio.min("station"), ratio.max("station")
        axes.fill_between(angle, *ends, color=colour, alpha=0.4, lw=0)
        other.plot(angle, cycle_part["heated_share"].mean("station"), color=colour, ls="--")
    if np.isnan(cycle["specific_film"]).all():
        axes.set_yticks([])
        axes.text(0.01, 0.05, "roughness not given", color="0.4", transform=axes.transAxes)
    else:
        for limit, name in ((FULL_FILM, "full film above"), (BOUNDARY, "boundary below")):
            axes.axhline(limit, color="0.4", lw=0.8)
            height = axes.get_yaxis_transform()
            axes.text(0.01, limit, name, size=8, color="0.4", va="bottom", transform=height)
    axes.set_ylim(bottom=0)
    other.set_ylim(0, 1.05)
    axes.set_ylabel(QUANTITIES["specific_film"].words())
    other.set_ylabel("film left by heat\n(Wilson and Sheu, dashed)")


PARAMETERS = (
    ("roller radius R / mm", MILLI),
    ("throat coefficient k", 1.0),
    ("tilt of the rollers' axes / deg", 180 / np.pi),
)
"""What is varied, in the order of the data: label and factor from SI."""


def draw_roller_sensitivity(result: Result) -> Figure:
    """Minimum film thickness at entry and exit of both sections over roller radius, throat and tilt."""
    cycle = result.cycle_data
    words, room = f"{result.case_name}  ·  sensitivity of the film", (0.8, 0.1, 0.55, 0.1)
    figure, panels = placed_panels((11, 4.2), words, room, columns=3, space=0.05, sharey=True)
    add_grids(panels)
    for number, axes in enumerate(panels):
        label, factor = PARAMETERS[number]
        value = cycle["varied_value"].isel(parameter=number) * factor
        for section, colour in SECTION_COLOURS.items():
            for end, style in (("entry", "o-"), ("exit", "s--")):
                film = cycle["varied_film"].isel(parameter=number).sel(section=section, end=end)
                axes.plot(value, film * MICRO, style, color=colour, label=f"{section}, {end}")
        axes.set_xlabel(label)
        axes.set_ylim(bottom=0)
        if number == 0:
            axes.set_ylabel(f"{broken(QUANTITIES['film_min'].axis())}\n(Dowson and Higginson)")
            axes.legend(frameon=False, fontsize=8)
    return figure


def draw_roller_indices(result: Result) -> Figure:
    """Lubrication and self-rotation angle, induced curvature and loads of the pin over the wheel angle."""
    cycle = result.cycle_data
    words, room = (
        result_heading(result, "indices of the mesh and loads of the pins"),
        (1.0, *ROOM[1:]),
    )
    figure, axes = placed_panels((9, 8), words, room, rows=3, space=0.08, sharex=True)
    thrust = axes[2].twinx()
    for colour, cycle_part, angle in _sections(cycle):
        for panel, name, factor in INDICES:
            along = cycle_part[name] * factor
            ends = along.min("station"), along.max("station")
            axes[panel].fill_between(angle, *ends, color=colour, alpha=0.3, lw=0)
            middle = along.isel(station=cycle_part.sizes["station"] // 2)
            style = "--" if name == "self_rotation_angle" else "-"
            axes[panel].plot(angle, middle, style, color=colour)
        axes[2].plot(angle, cycle_part["pin_radial"], color=colour)
        thrust.plot(angle, cycle_part["pin_axial"], "--", color=colour)
        axes[2].plot([], [], color=colour, label=f"{cycle_part['section'].item()} section")
    axes[0].set_ylim(top=91)
    axes[0].set_ylabel("lubrication angle / °\n(self-rotation angle dashed)")
    axes[1].set_ylabel("induced curvature\n/ (1/mm)")
    axes[2].set_ylim(bottom=0)
    axes[2].set_ylabel("radial load\nof the pin / N")
    thrust.set_ylabel("thrust along the pin / N\n(dashed)")
    thrust.set_ylim(bottom=min(0.0, thrust.get_ylim()[0]))
    axes[2].legend(frameon=False, fontsize=8, loc="center left")
    axes[2].set_xlabel("wheel angle of the roller / ° (motion from left to right)")
    add_grids(axes)
    return figure


INDICES = (
    (0, "lubrication_angle", 180 / np.pi),
    (0, "self_rotation_angle", 180 / np.pi),
    (1, "induced_curvature", 1e-3),
)
"""Panel, variable along the line of contact, factor from SI to the shown unit."""


CYCLE_PICTURES = {
    "mesh_cycle_drive": CyclePicture(
        "Gear set: rollers, worm flanks and contact lines", draw_roller_drive
    ),
    "mesh_cycle_regimes": CyclePicture(
        "Regimes of lubrication over the mesh cycle", draw_roller_regimes
    ),
    "mesh_cycle": CyclePicture("Mesh cycle", draw_roller_cycle),
    "mesh_cycle_indices": CyclePicture(
        "Indices of the mesh and loads of the pins", draw_roller_indices
    ),
    "mesh_cycle_rotation": CyclePicture("Rotation of a roller", draw_roller_rotation),
    "mesh_cycle_sensitivity": CyclePicture("Sensitivity of the film", draw_roller_sensitivity),
    "mesh_cycle_fatigue": CyclePicture("Fatigue of worm thread and rollers", draw_roller_fatigue),
}
"""File name -> picture of the mesh cycle."""
