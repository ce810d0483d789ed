"""Pictures of a rough surface: its heights and Abbott curve, its contact and the flow over it."""

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.formulas.flow_factors import pressure_flow_factor, shear_flow_factor
from pyworm.materials.rough_surfaces import RoughPair, RoughSurface
from pyworm.materials.roughness_assumptions import RoughSurfaces
from pyworm.materials.topography import Topography
from pyworm.plots.layout import MEGA, MICRO, joined, new_figure
from pyworm.surfaces.cell_table import CellTable
from pyworm.surfaces.parameters import Texture, abbott

STATE_COLOURS = "tab:blue", "tab:orange"
"""Colours of surfaces as measured and run in."""

LEAST_DRAWN, MOST_HEIGHTS = 0.3, 4.0
"""Ends of the axis of gaps over the composite roughness: pressed together, and far apart."""

PRESSURES = 1e-2, 1e4
"""Ends of the axis of asperity pressures [MPa]."""

MOST_DRAWN = 600
"""Points of the map along its longer side."""

EXTREME_FRACTION = 0.001
"""Fraction of heights beyond either end of the map's colours."""


def draw_heights(name: str, surface: Topography, texture: Texture) -> Figure:
    """Map of heights, and the Abbott curve with its core."""
    heading = (
        f"Heights of {name}  ·  Sq {texture.rq * MICRO:.3g} µm, slope {texture.slope:.3g}, "
        f"Peklenik number {texture.aspect:.3g}"
    )
    figure = new_figure(11, 5, heading)
    map_axes, curve_axes = figure.subplots(1, 2, width_ratios=(1.25, 1))
    stride = max(1, -(-max(surface.height.shape) // MOST_DRAWN))
    low, high = np.quantile(surface.height, (EXTREME_FRACTION, 1 - EXTREME_FRACTION)) * MICRO
    x_side, y_side = (side * MICRO for side in surface.extent)
    mapped = map_axes.imshow(
        np.where(surface.known, surface.height, np.nan)[::stride, ::stride].T * MICRO,
        origin="lower",
        extent=(0, x_side, 0, y_side),
        cmap="viridis",
        vmin=low,
        vmax=high,
        aspect="auto" if not 0.4 < x_side / y_side < 2.5 else "equal",
    )
    figure.colorbar(mapped, ax=map_axes, label="height / µm", extend="both", shrink=0.9)
    map_axes.set_xlabel("x / µm")
    map_axes.set_ylabel("y / µm")
    stretched = "" if map_axes.get_aspect() == 1 else ", scales of x and y differ"
    map_axes.set_title(f"heights{stretched}", fontsize="medium")
    draw_abbott(curve_axes, surface.measured_heights, texture.mr1, texture.rk, "Sk")
    return figure


def draw_abbott(axes: Axes, heights: np.ndarray, begin: float, core: float, symbol: str) -> None:
    """Distribution of heights [m] and their Abbott curve with its core, by its lower end and height [m]."""
    part, height = abbott(heights)
    count, edges = np.histogram(heights, bins=60)
    axes.stairs(
        count / count.max() * 40,
        edges * MICRO,
        orientation="horizontal",
        color="0.85",
        fill=True,
        label="heights, frequency",
    )
    axes.plot(100 * part, height * MICRO, color="tab:blue", label="Abbott curve")
    top = float(np.interp(begin, part, height)) * MICRO
    bottom = top - core * MICRO
    axes.plot(
        (0, 100),
        (top, bottom),
        color="tab:red",
        lw=1,
        label=f"core, {symbol} {core * MICRO:.3g} µm",
    )
    for edge in (top, bottom):
        axes.axhline(edge, color="tab:red", lw=0.8, ls=":")
    axes.set_xlim(0, 100)
    axes.set_xlabel("material ratio / %")
    axes.set_ylabel("height / µm")
    axes.set_title("Abbott curve", fontsize="medium")
    axes.legend(frameon=False, fontsize="small")


def draw_curves(
    name: str, table: CellTable, texture: Texture, modulus: float, hardness: float | None
) -> Figure:
    """Contact and flow factors over the gap, beside closed forms for a surface of the same figures.

    `modulus` is E' [Pa], `hardness` the largest pressure [Pa], None of a surface that does not yield.
    """
    yields = "elastic" if hardness is None else f"hardness {hardness * MEGA:.4g} MPa"
    given = f"E' {modulus / 1e9:.4g} GPa, {yields}"
    heading = f"Contact and flow factors of {name} against a smooth surface"
    figure = new_figure(13.6, 4.8, joined(heading, given))
    # room beside the first panel, whose axis on the right is its own
    figure.set_layout_engine("constrained", w_pad=0.15)
    contact, flow, shear = figure.subplots(1, 3)
    gap = table.separation / table.height
    rough = RoughSurface(table.height, texture.slope, hardness=hardness)
    smooth = RoughSurface(1e-6 * table.height, 1e-12, hardness=hardness)
    closed, area = RoughPair((rough, smooth), modulus / 2).contact(gap)
    _draw_contact(contact, gap, table, closed, area)
    factors, dragged = table.conducted / table.flowing**3, table.dragged / table.height
    fitted = gap[gap >= 0.5]
    along_x = float(np.clip(texture.slope_y / texture.slope_x, 1 / 9, 9.0))
    for k, (axes_name, colour) in enumerate((("x", "tab:blue"), ("y", "tab:orange"))):
        aspect = along_x if k == 0 else 1 / along_x
        flow.plot(gap, factors[k], "o-", ms=3, color=colour, label=f"along {axes_name}")
        shear.plot(gap, dragged[k], "o-", ms=3, color=colour, label=f"along {axes_name}")
        label = f"Patir and Cheng, {axes_name}"
        flow.plot(
            fitted, pressure_flow_factor(fitted, aspect), "--", color=colour, lw=1, label=label
        )
        shear.plot(fitted, shear_flow_factor(fitted, aspect), "--", color=colour, lw=1, label=label)
    flow.set_title("pressure flow", fontsize="medium")
    shear.set_title("shear flow", fontsize="medium")
    flow.set_ylabel(r"pressure flow factor (of $h_T^3$)")
    shear.set_ylabel(r"shear flow factor $\phi_s$")
    for axes in (contact, flow, shear):
        axes.set_xlabel("gap between mean planes $h/R_q$")
        axes.set_xlim(min(0.0, gap.min()) if axes is contact else 0, 6)
        axes.grid(True, color="0.9")
    for axes in (flow, shear):
        axes.set_ylim(bottom=0)
        axes.legend(frameon=False, fontsize="small")
    return figure


def _draw_contact(
    axes: Axes, gap: np.ndarray, table: CellTable, closed: np.ndarray, area: np.ndarray
) -> None:
    touched = table.area > 0
    axes.semilogy(gap[touched], table.pressure[touched] * MEGA, "o-", ms=3, label="pressure")
    axes.semilogy(gap, closed * MEGA, "--", color="tab:blue", lw=1, label="closed form")
    axes.set_ylabel("asperity pressure $p_a$ / MPa")
    axes.set_ylim(table.pressure[touched].min() * MEGA / 3, table.pressure.max() * MEGA * 3)
    axes.set_title("asperity contact", fontsize="medium")
    right = axes.twinx()
    right.plot(gap, 100 * table.area, "o-", ms=3, color="tab:green", label="real area")
    right.plot(gap, 100 * area, "--", color="tab:green", lw=1)
    right.set_ylabel("real area of contact / %", color="tab:green")
    right.set_ylim(0, 100)
    handles, labels = (
        a + b
        for a, b in zip(
            axes.get_legend_handles_labels(), right.get_legend_handles_labels(), strict=True
        )
    )
    axes.legend(handles, labels, frameon=False, fontsize="small", loc="upper right")


def draw_states(states: Mapping[str, tuple[RoughSurfaces, float]]) -> Figure:
    """Averages of two surfaces together over the gap between mean planes, for each state of them.

    Each state comes with its mean central film thickness [m], which is marked.
    """
    figure = new_figure(13.6, 4.8, "Two surfaces together: asperity contact and flow factors")
    contact, flow, shear = figure.subplots(1, 3)
    for colour, state in zip(STATE_COLOURS, states, strict=True):
        pair, film = states[state]
        curves = pair.curves()
        gap = curves.gaps * MICRO
        rows = curves.values
        contact.semilogy(gap, np.exp(rows[0]) * MEGA, color=colour, label=state)
        for axes, first in ((flow, 3), (shear, 6)):
            size = 1.0 if axes is flow else MICRO
            axes.plot(gap, rows[first] * size, color=colour, label=f"{state}, along x")
            axes.plot(gap, rows[first + 1] * size, "--", color=colour, label=f"{state}, along y")
        place = float(np.interp(film, curves.thicknesses, curves.gaps)) * MICRO
        for axes in (contact, flow, shear):
            axes.axvline(place, color=colour, lw=0.8, ls=":")
    heights = [pair.height * MICRO for pair, _ in states.values()]
    narrowest, widest = LEAST_DRAWN * min(heights), MOST_HEIGHTS * max(heights)
    for axes in (contact, flow, shear):
        axes.set_xlim(narrowest, widest)
        axes.set_xlabel("gap between mean planes / µm")
        axes.grid(True, color="0.9")
        axes.legend(frameon=False, fontsize="small")
    contact.set_ylim(*PRESSURES)
    contact.set_ylabel("asperity pressure $p_a$ / MPa")
    contact.set_title("asperity contact; dotted: central film thickness", fontsize="medium")
    flow.set_ylabel(r"pressure flow factor (of $h_T^3$)")
    flow.set_title("pressure flow", fontsize="medium")
    shear.set_ylabel(r"shear flow $\sigma\phi_s$ / µm")
    shear.set_title("shear flow", fontsize="medium")
    return figure
