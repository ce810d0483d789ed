"""Temperature and velocity across the film at its hottest point."""

from typing import Any

from matplotlib.figure import Figure

from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.quantities import BODIES
from pyworm.plots.layout import MICRO, MILLI, add_grids, heading, placed_panels
from pyworm.solver.solution import Solution

VELOCITY_COLOURS = {"x": "tab:blue", "y": "tab:orange"}

DOTS: dict[str, Any] = {"markersize": 4, "clip_on": False}
"""Marks at the levels across the film."""


def draw_across_film(
    case_name: str, solution: Solution, bodies: tuple[str, str] = BODIES
) -> Figure:
    """Temperature, and the velocity along each direction, from the first body below to the second above."""
    profile = solution.dataset("profile")
    axes_here = [axis for axis in "xy" if f"profile_{axis}" in profile]
    place = {axis: float(profile[f"profile_{axis}"].values) for axis in axes_here}
    film = float(solution.fields["film"].interp(place, assume_sorted=True))
    height = (profile["level_position"].values + 0.5) * film * MICRO
    point_text = ", ".join(f"{axis} = {along * MILLI:.3g} mm" for axis, along in place.items())
    size, room = (9, 4.6), (0.75, 0.95, 0.55, 0.3)
    figure, panels = placed_panels(
        size, heading(case_name, solution), room, columns=2, space=0.04, sharey=True
    )
    warm_axes, fast_axes = panels
    warmth = profile["profile_temperature"].values - ZERO_CELSIUS
    warm_axes.plot(warmth, height, "o-", color="tab:red", **DOTS)
    warm_axes.set_title(
        f"across the film where it is hottest, {point_text}", fontsize="medium", loc="left", y=1
    )
    warm_axes.set_xlabel("temperature / °C")
    warm_axes.set_ylabel(f"height above {bodies[0]} / µm")
    for axis in axes_here:
        speed, colour = profile[f"profile_velocity_{axis}"].values, VELOCITY_COLOURS[axis]
        fast_axes.plot(speed, height, "o-", color=colour, label=f"along {axis}", **DOTS)
    fast_axes.set_xlabel("velocity / (m/s)")
    if len(axes_here) > 1:
        fast_axes.legend(frameon=False)
    warm_axes.set_ylim(0, film * MICRO if film > 0 else 1)
    add_grids(panels)
    for wall, name in enumerate(bodies):
        fast_axes.annotate(
            name,
            (1, wall),
            (6, 0),
            xycoords="axes fraction",
            textcoords="offset points",
            va="center",
            color="0.3",
        )
    return figure
