"""Film maps: contours up to three central films, and a synthetic interferogram."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from pyworm.io.plain_dataset import AnyDataset
from pyworm.io.quantities import QUANTITIES
from pyworm.plots.layout import (
    MILLI,
    Window,
    colour_bar,
    contact_window,
    field,
    heading,
    in_window,
    nodes,
    panels,
)
from pyworm.plots.overlays import at_places, draw_dry_outline, draw_tooth
from pyworm.solver.solution import Solution

CLIP = 3.0
"""Thickest film shown, in central films: a linear map of the whole gap would hide the contact."""

WAVELENGTHS = np.array([0.650e-6, 0.532e-6, 0.460e-6])
"""Red, green and blue light of the interferogram [m]."""

REFRACTIVE_INDEX = 1.47
"""Refractive index of a mineral oil."""

PIXELS_PER_INCH = 150
"""Pixels of the interferogram."""


def draw_film(case_name: str, solution: Solution) -> Figure:
    """Film contours with the place of the minimum, and a synthetic interferogram."""
    whole = solution.dataset("fields")
    window = contact_window(whole)
    fields = in_window(whole, window)
    figures, quantity = solution.figures, QUANTITIES["film"]
    central, thin = QUANTITIES["film_central"], QUANTITIES["film_min"]
    titles = [
        f"{central.symbol} {central.text(figures.film_central.value)}, "
        f"{thin.symbol} {thin.text(figures.film_min.value)} (circle)"
        if solution.converged
        else f"{quantity.words()}, not converged",
        "interferogram in red, green and blue light",
    ]
    figure, (film_axes, light_axes) = panels(window, titles, heading(case_name, solution))

    film = *nodes(fields), quantity.number(field(fields, "film"))
    top = quantity.number(thickest_shown(solution))
    levels = np.linspace(0, top, 41)
    bands = film_axes.contourf(*film, levels=levels, cmap=quantity.colours, extend="max")
    lines = np.asarray(MaxNLocator(12).tick_values(0, top))
    lines = lines[lines <= top]
    film_axes.contour(*film, levels=lines, colors="white", linewidths=0.5, alpha=0.8)
    draw_tooth(film_axes, fields)
    draw_dry_outline(film_axes, fields, "black")
    if solution.converged:
        place = [coordinate * MILLI for coordinate in figures.film_min_at]
        film_axes.plot(*place, "o", mfc="none", mec="tab:red", mew=1.5)
    colour_bar(film_axes, bands, quantity.axis(), lines)

    light_axes.imshow(
        interferogram(fields, window),
        extent=(window.left, window.right, window.bottom, window.top),
        origin="lower",
        aspect=window.stretch,
        interpolation="nearest",
    )
    draw_tooth(light_axes, fields)
    return figure


def interferogram(fields: AnyDataset, window: Window) -> np.ndarray:
    """Intensity (row, column, colour), 0 to 1, of a camera image of the window.

    The reflections of two surfaces a film h apart differ in phase by 4 pi n h / wavelength, with
    half a turn at one of them, so no film is dark. A pixel averages the fringes within it, which
    therefore fade where the gap opens.
    """
    columns, rows = (round(PIXELS_PER_INCH * side) for side in window.panel_size)
    x = np.linspace(window.left, window.right, columns)
    y = np.linspace(window.bottom, window.top, rows)
    film = at_places(fields, field(fields, "film"), x, y)
    phase = 4 * np.pi * REFRACTIVE_INDEX * film[..., None] / WAVELENGTHS
    along_y, along_x = np.gradient(phase, axis=(0, 1))
    contrast = _pixel_average(along_x) * _pixel_average(along_y)
    return (1 - contrast * np.cos(phase)) / 2


def _pixel_average(phase_step: np.ndarray) -> np.ndarray:
    """Contrast of fringes whose phase changes across a pixel; zero from a full period on."""
    return np.sinc(np.minimum(np.abs(phase_step) / (2 * np.pi), 1))


def thickest_shown(solution: Solution) -> float:
    """Upper end of film scales [m]; the thickest film of all if the central one is not positive."""
    central = solution.figures.film_central.value
    return CLIP * central if central > 0 else float(solution.dataset("fields")["film"].values.max())
