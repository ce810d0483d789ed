"""Pressure and film on the two lines through the contact point."""

from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.formulas.hertz import HertzContact, hertz
from pyworm.io.plain_dataset import AnyDataset
from pyworm.io.quantities import QUANTITIES
from pyworm.plots.contact.film import thickest_shown
from pyworm.plots.layout import MEGA, MICRO, MILLI, Style, contact_window, heading, placed_panels
from pyworm.solver.solution import Solution

PRESSURE_COLOUR, FILM_COLOUR = "tab:red", "tab:blue"


def draw_profiles(case_name: str, solution: Solution) -> Figure:
    """Film pressure, dry pressure, Hertz pressure (dashed) and film along x and along y."""
    size, room = (9, 7.5), (0.7, 0.72, 0.85, 0.1)
    figure, panels = placed_panels(size, heading(case_name, solution), room, rows=2, space=0.18)
    window = contact_window(solution.fields)
    contact = _hertz_of(solution.fields)
    fields = solution.fields[["pressure", "dry_pressure", "film", "covered"]]
    ideal = {"x": lambda x: contact.pressure(x, 0.0), "y": lambda y: contact.pressure(0.0, y)}
    top = thickest_shown(solution) * MICRO
    sides = {"x": (window.left, window.right), "y": (window.bottom, window.top)}
    for axes, (along, across) in zip(panels, (("x", "y"), ("y", "x")), strict=True):
        line = fields.interp({across: 0.0}, assume_sorted=True)
        handles = draw_profile(axes, line, along, ideal[along], top)
        axes.set_xlim(*sides[along])
        axes.set_xlabel(f"{along} / mm   (at {across} = 0)")
    figure.legend(handles=handles, loc="lower center", ncols=4, frameon=False)
    return figure


def draw_profile(
    axes: Axes, line: AnyDataset, along: str, hertz_pressure: Callable, top: float
) -> list:
    """Pressure and film on one line through the contact; returns what its legend names.

    `hertz_pressure` gives the Hertz pressure [Pa] at places along the line [m], `top` ends the film's scale
    [µm]; the dry pressure is drawn if it is among the fields.
    """
    place = line[along].values
    fine = np.linspace(place[0], place[-1], 2001)
    place, thin = place * MILLI, Style(linewidth=1.0)
    pressure = line["pressure"].values * MEGA
    curves = axes.plot(place, pressure, color=PRESSURE_COLOUR, label="film pressure")
    if "dry_pressure" in line:
        dry = line["dry_pressure"].values * MEGA
        curves += axes.plot(place, dry, color="0.4", label="dry pressure", **thin)
    hertz = hertz_pressure(fine) * MEGA
    curves += axes.plot(fine * MILLI, hertz, "--", color="black", label="Hertz pressure", **thin)
    axes.set_ylim(bottom=0)
    axes.set_ylabel(QUANTITIES["pressure"].axis(), color=PRESSURE_COLOUR)
    missing = line["covered"].values < 0.5
    if missing.any():
        look: Style = {"color": "0.85", "hatch": "////", "edgecolor": "0.6"}
        height = axes.get_xaxis_transform()
        axes.fill_between(place, 0, 1, where=missing, transform=height, **look)
    film, film_axes = line["film"].values * MICRO, axes.twinx()
    curves += film_axes.plot(place, film, color=FILM_COLOUR, label="film")
    film_axes.set_ylim(0, top)
    film_axes.set_ylabel(QUANTITIES["film"].axis(), color=FILM_COLOUR)
    return curves


def _hertz_of(fields: AnyDataset) -> HertzContact:
    """The Hertz contact of the scene that the fields belong to."""
    scene = fields.attrs
    return hertz(
        scene["radius_x_m"], scene["radius_y_m"], scene["load_N"], scene["reduced_modulus_Pa"]
    )
