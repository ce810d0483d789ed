"""Maps of a contact's fields: pressure, temperature, shear stress and frictional power, lubricant supply."""

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from pyworm.io.plain_dataset import AnyDataset
from pyworm.io.present import present
from pyworm.io.quantities import BODIES, QUANTITIES
from pyworm.plots.layout import (
    MILLI,
    Style,
    colour_bar,
    contact_window,
    field,
    heading,
    in_window,
    nodes,
    panels,
    whole_window,
)
from pyworm.plots.overlays import draw_arrows, draw_dry_outline, draw_tooth, signed_square
from pyworm.solver.neglected_effects import AS_IF_SMOOTH
from pyworm.solver.solution import Solution

BANDS = 12
"""Bands of a map between its ends."""

PRESSURE_BANDS = 10
"""Bands of a map of pressure between its ends."""

LEAST_RANGE = 0.1
"""Least range of the scale of temperatures [K]: below it a map would show rounding, not heat."""

THICKEST = 2.5
"""Thickest layer of oil shown, over the central film thickness."""


def draw_pressure(case_name: str, solution: Solution) -> Figure:
    """Dry and film pressure, and the asperities', on one scale, each with the outline of the dry contact."""
    window = contact_window(solution.fields)
    fields = in_window(solution.fields, window)
    names = {"dry contact": "dry_pressure", "oil film": "pressure"}
    if "asperity_pressure" in fields:
        names = {"dry contact": "dry_pressure", "oil and asperities": "pressure"}
        names["asperities"] = "asperity_pressure"
    pressure = QUANTITIES["pressure"]
    shown = {title: _values(fields, name) for title, name in names.items()}
    titles = [
        f"{title}: at most {pressure.with_unit(f'{values.max():.4g}')}"
        for title, values in shown.items()
    ]
    figure, axes = panels(window, titles, heading(case_name, solution))
    levels = _levels(0, max(float(values.max()) for values in shown.values()), PRESSURE_BANDS)
    # Nearly no pressure is left white, so that the reach of the pressure can be seen.
    bounds = np.append(levels[1] / 10, levels[1:])
    for panel, values in zip(axes, shown.values(), strict=True):
        # Squared, a dry pressure is linear at its boundary, where contours of it would be stepped.
        scale = _scale(bounds**2, pressure.colours, 0.15)
        _draw_map(panel, fields, signed_square(values), bounds**2, scale, bounds[1:] ** 2)
        colour_bar(panel, _scale(bounds, pressure.colours, 0.15), pressure.axis(), bounds)
    return figure


def draw_temperature(
    case_name: str, solution: Solution, bodies: tuple[str, str] = BODIES
) -> Figure:
    """Both surfaces, with the direction in which each moves, and the middle of the film, on one scale."""
    whole = solution.dataset("fields")
    window = contact_window(whole)
    fields = in_window(whole, window)
    parts = ("body_1", "body_2", "middle")
    maps = [_values(fields, f"temperature_{part}") for part in parts]
    figures, maximum = solution.figures, QUANTITIES["temperature_max"]
    titles = [
        f"{name}: at most {maximum.text(estimate.value)}{note}"
        for name, estimate, note in (
            (f"surface of {bodies[0]}", figures.temperature_max_body_1, " (arrows: its motion)"),
            (f"surface of {bodies[1]}", figures.temperature_max_body_2, " (arrows: its motion)"),
            ("film", figures.temperature_max_film, " (map: its middle)"),
        )
        if estimate is not None
    ]
    figure, axes = panels(window, titles, heading(case_name, solution))
    coldest = min(values.min() for values in maps)
    hottest = max(coldest + LEAST_RANGE, max(values.max() for values in maps))
    bounds = _levels(coldest, hottest, BANDS)
    scale = _scale(bounds, maximum.colours, 0.05)
    for panel, values in zip(axes, maps, strict=True):
        _draw_map(panel, fields, values, bounds, scale, bounds)
        colour_bar(panel, scale, maximum.axis("temperature"), bounds)
    mean, sliding = (
        [field(fields, f"{motion}_{axis}") for axis in "xy"]
        for motion in ("entrainment", "sliding")
    )
    for panel, sign in zip(axes[:2], (1, -1), strict=True):
        motion = (u + sign / 2 * du for u, du in zip(mean, sliding, strict=True))
        draw_arrows(panel, fields, *motion)
    _mark_profile(axes[2], solution)
    return figure


def draw_friction(case_name: str, solution: Solution, bodies: tuple[str, str] = BODIES) -> Figure:
    """Shear stress, its direction on the first body and where it reaches the limit, and frictional power."""
    whole = solution.dataset("fields")
    window = contact_window(whole)
    fields = in_window(whole, window)
    figures = solution.figures
    friction = present(figures.friction_coefficient, "friction_coefficient")
    loss = present(figures.power_loss, "power_loss")
    stress, power, coefficient = (
        QUANTITIES[name] for name in ("shear_stress", "friction_power", "friction_coefficient")
    )
    components = [field(fields, f"shear_stress_{axis}") for axis in "xy"]
    maps = stress.number(np.hypot(*components)), _values(fields, power.name)
    smooth = f" {AS_IF_SMOOTH}" if solution.neglected_effects.as_if_smooth else ""
    most, highest = (
        quantity.with_unit(f"{values.max():.3g}")
        for quantity, values in zip((stress, power), maps, strict=True)
    )
    titles = [
        f"{stress.words()} (arrows: on {bodies[0]}): at most {most}, "
        f"{coefficient.words()} {friction.value:.3g}{smooth}",
        f"{power.words()}: at most {highest}, in all {_power(loss.value)}{smooth}",
    ]
    figure, axes = panels(window, titles, heading(case_name, solution))
    for panel, quantity, values in zip(axes, (stress, power), maps, strict=True):
        levels = _levels(0, values.max(), BANDS)
        scale = _scale(levels, quantity.colours, 0.0)
        _draw_map(panel, fields, values, levels, scale, levels[:0])
        colour_bar(panel, scale, quantity.axis(), levels)
    draw_arrows(axes[0], fields, *components)
    _draw_slip(axes[0], fields)
    return figure


def draw_supply(case_name: str, solution: Solution) -> Figure:
    """Fraction of the gap that oil fills, and the thickness of the oil, in the whole window."""
    fields = solution.dataset("fields")
    figures, film = solution.figures, QUANTITIES["film"]
    titles = [
        "fraction of the gap that oil fills",
        f"oil thickness; supplied: {present(figures.supply, 'supply').supply_ratio:.2g} of the flooded film",
    ]
    figure, axes = panels(whole_window(fields), titles, heading(case_name, solution))
    fraction = field(fields, "oil_fraction")
    thickest = THICKEST * film.number(figures.film_central.value)
    oil = np.minimum(fraction * _values(fields, "film"), thickest)
    maps = (
        (fraction, 1.0, "fraction filled", "cividis", "neither"),
        (oil, thickest, film.axis("oil thickness"), film.colours, "max"),
    )
    for panel, (values, top, label, colours, extend) in zip(axes, maps, strict=True):
        look: Style = {"vmin": 0.0, "vmax": top, "cmap": colours, "shading": "nearest"}
        shown = panel.pcolormesh(*nodes(fields), values, rasterized=True, **look)
        draw_tooth(panel, fields)
        draw_dry_outline(panel, fields, "white")
        colour_bar(panel, shown, label, extend=extend)
    return figure


def _values(fields: AnyDataset, name: str) -> np.ndarray:
    """A field (y, x) in the unit in which it is shown."""
    return QUANTITIES[name].number(field(fields, name))


def _levels(low: float, high: float, count: int) -> np.ndarray:
    """Round numbers from one value to another."""
    top = high if high > low else low + 1
    return np.asarray(MaxNLocator(count).tick_values(low, top), float)


def _scale(bounds: np.ndarray, name: str, first: float) -> ScalarMappable:
    """One colour for each band, from a place in a colour map on, 0 to 1."""
    colours = ListedColormap(colormaps[name](np.linspace(first, 1, bounds.size - 1)))
    return ScalarMappable(BoundaryNorm(bounds, colours.N), colours)


def _draw_map(
    axes: Axes,
    fields: AnyDataset,
    values: np.ndarray,
    levels: np.ndarray,
    scale: ScalarMappable,
    lines: np.ndarray,
) -> None:
    """Bands of a field with lines between some of them, the tooth and the outline of the dry contact."""
    places = nodes(fields)
    axes.contourf(*places, values, levels=levels, cmap=scale.cmap, norm=scale.norm)
    within = lines[(lines > values.min()) & (lines < values.max())]
    if within.size:
        axes.contour(*places, values, levels=within, colors="white", linewidths=0.4, alpha=0.6)
    draw_tooth(axes, fields)
    draw_dry_outline(axes, fields, "tab:cyan")


def _mark_profile(axes: Axes, solution: Solution) -> None:
    """A circle where the profile across the film is taken."""
    profile = solution.dataset("profile")
    place = [float(profile[f"profile_{axis}"].values) * MILLI for axis in "xy"]
    axes.plot(*place, "o", mec="tab:cyan", ms=8, mfc="none", mew=1.5)


def _draw_slip(axes: Axes, fields: AnyDataset) -> None:
    """Hatches where the limiting stress is reached at a surface."""
    slip = field(fields, "slip")
    if slip.max() == 0:
        return
    axes.contourf(*nodes(fields), slip, levels=[0.5, 3.5], colors="none", hatches=["xxx"])
    axes.legend(handles=[Patch(facecolor="none", edgecolor="black", hatch="xxx", label="slip")])


def _power(watts: float) -> str:
    return f"{watts / 1e3:.3g} kW" if watts >= 1e3 else f"{watts:.3g} W"
