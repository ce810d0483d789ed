"""The line of action of a pair of gears, over the roll angle of the pinion."""

from collections.abc import Iterable, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.bounded_number import read_json
from pyworm.io.on_demand import xarray as xr
from pyworm.io.present import present
from pyworm.io.quantities import QUANTITIES
from pyworm.plots.drives.picture import CyclePicture
from pyworm.plots.error_bars import draw_figure
from pyworm.plots.layout import MEGA, MICRO, MILLI, broken, mark_gaps, new_figure, result_heading
from pyworm.ratings.flank_damage import hotter_flank
from pyworm.result.headline import of_all
from pyworm.result.mesh_cycle import phase_of
from pyworm.result.result import Result
from pyworm.solver.solution import Solution

ROOM = 0.22
"""Room above the curves for a legend, as a fraction of their height."""

DIRECTIONS = {
    "pinion": "pinion drives, contact runs to the right",
    "gear": "gear drives, contact runs to the left",
}
"""Driving member -> how the line of action is run through."""

MIN_MARK_DISTANCE = 0.05
"""Distance of two marks, as a fraction of the axis, below which the second one's name stands higher."""

STEEP_SLIDING = 5.0
"""Specific sliding beyond which a curve leaves the picture: near its base circle it has no bound."""


def draw_film_and_temperature(result: Result) -> Figure:
    """Film and contact temperature by closed forms, with what was simulated, along the line of action."""
    cycle = result.cycle_data
    solved = sorted(result.solutions, key=phase_of)
    hot = "closed_form_contact_temperature" in cycle or any(map(_heated, solved))
    figure = new_figure(8, 3.7 * (1 + hot) + 1.0, _heading(result))
    panels = np.atleast_1d(figure.subplots(1 + hot, sharex=True))
    _draw_film(panels[0], cycle, solved)
    if hot:
        _draw_temperature(panels[1], cycle, solved)
    return _finished(figure, panels, cycle)


def draw_line_of_action(result: Result) -> Figure:
    """Load, pressure, velocities and specific sliding along the line of action."""
    cycle = result.cycle_data
    roll = _roll(cycle)
    figure = new_figure(8, 10.0, _heading(result))
    panels = figure.subplots(4, sharex=True)
    unit_load = cycle["unit_load"] / MILLI
    panels[0].plot(roll, unit_load, color="black", label="without friction")
    if "friction_load_factor" in cycle:
        coefficient = cycle.attrs["friction_coefficient"]
        friction = f"with friction {coefficient:g}, same torque of the driver"
        rubbed = unit_load * cycle["friction_load_factor"]
        panels[0].plot(roll, rubbed, color="tab:purple", linestyle="--", label=friction)
    panels[0].set_ylabel("load per length\n/ (N/mm)")
    panels[0].set_ylim(bottom=0)
    _legend(panels[0], 2)
    panels[1].plot(roll, cycle["closed_form_hertz_pressure"] * MEGA, color="tab:red")
    panels[1].set_ylabel(broken(QUANTITIES["hertz_pressure_max"].axis()))
    panels[1].set_ylim(bottom=0)
    for name, colour in (("pinion", "tab:blue"), ("gear", "tab:orange")):
        panels[2].plot(roll, cycle[f"{name}_velocity"], color=colour, label=name)
        sliding = cycle[f"{name}_specific_sliding"]
        panels[3].plot(roll, sliding, color=colour, label=name)
    panels[2].set_ylabel("surface velocity\n/ (m/s)")
    panels[2].set_ylim(bottom=0)
    panels[3].set_ylabel("specific sliding")
    panels[3].axhline(0, color="0.4", linewidth=0.8)
    low, high = panels[3].get_ylim()
    panels[3].set_ylim(max(low, -STEEP_SLIDING), high)
    for panel in panels[2:]:
        _legend(panel, 2)
    return _finished(figure, panels, cycle)


def _draw_film(axes: Axes, cycle: "xr.Dataset", solved: Sequence[Solution]) -> None:
    """Films in micrometres; where roughness is known the specific film on the right."""
    for name, colour in (("film_central", "tab:blue"), ("film_min", "tab:green")):
        label = QUANTITIES[name].words()
        formula = "Dowson-Toyoda" if name == "film_central" else "Dowson-Higginson"
        curve = cycle[f"closed_form_{name}"] * MICRO
        axes.plot(_roll(cycle), curve, color=colour, label=f"{label}, {formula}")
        if solved:
            style = {"fmt": "o", "color": colour, "capsize": 3, "label": f"{label}, simulated"}
            draw_figure(axes, _rolls(cycle, solved), solved, name, style)
    mark_gaps(axes, _rolls(cycle, solved), solved)
    axes.set_ylabel(QUANTITIES["film"].axis())
    axes.set_ylim(bottom=0)
    _legend(axes, 2)
    if "closed_form_specific_film" in cycle:
        # a copy of the left axis: film over composite roughness
        film, specific = (cycle[f"closed_form_{name}"] for name in ("film_min", "specific_film"))
        roughness = float((film / specific)[0]) * MICRO
        scales = (
            lambda values: np.asarray(values) / roughness,
            lambda values: np.asarray(values) * roughness,
        )
        axes.secondary_yaxis("right", functions=scales).set_ylabel(
            QUANTITIES["specific_film"].axis()
        )


def _draw_temperature(axes: Axes, cycle: "xr.Dataset", solved: Sequence[Solution]) -> None:
    """Blok's contact temperature and the largest of the simulated surfaces.

    Blok's rise goes with the coefficient of friction, so that it is drawn with the simulated one too.
    """
    heated = [solution for solution in solved if solution.converged and _heated(solution)]
    rolls = _rolls(cycle, heated)
    if "closed_form_contact_temperature" in cycle:
        friction = cycle.attrs["friction_coefficient"]
        contact = cycle["closed_form_contact_temperature"] - ZERO_CELSIUS
        axes.plot(_roll(cycle), contact, color="tab:red", label=f"Blok, friction {friction:g}")
        if heated:
            flash = cycle["closed_form_flash_temperature"]
            bulk = float((cycle["closed_form_contact_temperature"] - flash)[0]) - ZERO_CELSIUS
            found = [
                present(solution.figures.friction_coefficient, "friction") for solution in heated
            ]
            ratios = np.array([coefficient.value for coefficient in found]) / friction
            rise = np.interp([phase_of(solution) for solution in heated], cycle["phase"], flash)
            axes.plot(
                rolls, bulk + ratios * rise, "s", color="tab:red", fillstyle="none", markersize=9,
                label=of_all(heated).qualified("Blok, simulated friction"),
            )  # fmt: skip
    if heated:
        hottest = [present(hotter_flank(solution), "temperature").value for solution in heated]
        simulated = np.array(hottest) - ZERO_CELSIUS
        axes.plot(rolls, simulated, "o", color="black", label="simulated surface")
    if "scuffing_temperature_K" in cycle.attrs:
        scuffing = cycle.attrs["scuffing_temperature_K"] - ZERO_CELSIUS
        axes.axhline(scuffing, color="tab:purple", ls="--", label="mean scuffing temperature")
    axes.set_ylabel("contact temperature / °C")
    _legend(axes, 2)


def _legend(axes: Axes, columns: int) -> None:
    """A legend in separate room above the curves."""
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + ROOM * (high - low))
    axes.legend(frameon=False, ncols=columns, loc="upper left")


def _finished(figure: Figure, panels: Iterable[Axes], cycle: "xr.Dataset") -> Figure:
    """Marks of the line of action on every panel, named above the first one."""
    marks = read_json(cycle.attrs["marks"])
    panels = list(panels)
    places = {name: float(_at(cycle, phase)) for name, phase in marks.items()}
    for panel in panels:
        panel.grid(True, color="0.92")
        for place in places.values():
            panel.axvline(place, color="0.6", linewidth=0.9, linestyle=":")
        panel.set_xlim(places["SAP"], places["EAP"])
    names: list[str] = []
    before = -np.inf
    for name, place in sorted(places.items(), key=lambda mark: mark[1]):
        near = place - before < MIN_MARK_DISTANCE * (places["EAP"] - places["SAP"])
        names.append(f"{name}\n" if near and not names[-1].endswith("\n") else name)
        before = place
    top = panels[0].secondary_xaxis("top")
    top.set_xticks(sorted(places.values()), names)
    top.tick_params(length=0, labelsize="small")
    panels[-1].set_xlabel("roll angle of the pinion / °")
    return figure


def _heading(result: Result) -> str:
    return result_heading(result, DIRECTIONS[result.cycle_data.attrs["driver"]])


def _heated(solution: Solution) -> bool:
    return solution.figures.temperature_max_film is not None


def _roll(cycle: "xr.Dataset") -> np.ndarray:
    """Roll angles of the cycle [degrees]."""
    return np.degrees(cycle["roll_angle"].values)


def _at(cycle: "xr.Dataset", phase: float | Sequence[float]) -> np.ndarray:
    """Roll angle [degrees] at phases: it is linear in them."""
    first, last = _roll(cycle)[[0, -1]]
    return first + np.asarray(phase, float) * (last - first)


def _rolls(cycle: "xr.Dataset", solved: Sequence[Solution]) -> np.ndarray:
    return _at(cycle, [phase_of(solution) for solution in solved])


CYCLE_PICTURES = {
    "film_and_temperature": CyclePicture(
        "Film and contact temperature along the line of action", draw_film_and_temperature, True
    ),
    "line_of_action": CyclePicture(
        "Load, pressure, speeds and sliding along the line of action", draw_line_of_action
    ),
}
"""File name -> picture of the mesh cycle."""
