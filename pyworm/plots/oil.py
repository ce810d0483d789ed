"""Charts of oils over temperature: viscosity and pressure-viscosity coefficient."""

from collections.abc import Sequence

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, NullFormatter, ScalarFormatter

from pyworm.formulas.oil_properties import double_log
from pyworm.formulas.unit_factors import SQUARE_METRE, SQUARE_MILLIMETRE, ZERO_CELSIUS
from pyworm.materials.library import NamedOil
from pyworm.plots.layout import drawn_into, new_figure

GIGA = 1e9
"""From 1/Pa to 1/GPa."""

VISCOSITIES = (3, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000)
"""Ticks of the Walther axis [mm2/s]."""

THINNEST = 2.0
"""Viscosity [mm2/s] below which curves end, where the law of the axis no longer holds."""

THICKEST = 9000.0
"""Viscosity [mm2/s] above which curves end, where oils hardly flow."""

COLDEST, HOTTEST = 0.0, 120.0
"""Ends of the axes of temperature [degC]."""

POINTS = 200
"""Points on a curve."""


def draw_viscosity(
    oils: Sequence[NamedOil], marked: float | None = None, ax: Axes | None = None
) -> Figure:
    """Viscosity of oils on Walther's axes, where they are straight, and dynamic viscosity on plain ones.

    Args:
        oils: The oils.
        marked: A temperature [K] to mark.
        ax: Axes whose place the picture takes.
    """
    with drawn_into(ax):
        return _viscosity(oils, marked)


def _viscosity(oils: Sequence[NamedOil], marked: float | None) -> Figure:
    """Both pictures of viscosity."""
    figure = new_figure(11, 5.6, "Viscosity of oils at ambient pressure")
    walther, plain = figure.subplots(1, 2)
    for oil, colour in zip(oils, _colours(oils), strict=True):
        celsius, nu = _flowing(oil)
        look = {"color": colour, "linestyle": _LINES[oil.stock.name], "label": oil.name}
        walther.plot(np.log10(celsius + ZERO_CELSIUS), _on_walther_axis(nu), **look)
        plain.semilogy(celsius, oil.viscosity(celsius + ZERO_CELSIUS) * 1e3, **look)
    _walther_axes(walther)
    _temperature_axis(plain)
    plain.set_title("plain axis of temperature", fontsize="medium")
    plain.set_ylabel("dynamic viscosity / (mPa s)")
    plain.yaxis.set_major_formatter(ScalarFormatter())
    if marked is not None:
        walther.axvline(np.log10(marked), color="0.4", linewidth=0.9, linestyle=":")
        _mark(plain, marked)
    _legend(figure, walther)
    return figure


def draw_pressure_viscosity(oils: Sequence[NamedOil], marked: float | None = None) -> Figure:
    """Pressure-viscosity coefficient by Gold's law, and AGMA's if known; as of `draw_viscosity`."""
    figure = new_figure(11, 5.4, "Pressure-viscosity coefficient of oils")
    gold, agma = figure.subplots(1, 2, sharey=True)
    for oil, colour in zip(oils, _colours(oils), strict=True):
        celsius, _ = _flowing(oil)
        kelvin = celsius + ZERO_CELSIUS
        look = {"color": colour, "linestyle": _LINES[oil.stock.name], "label": oil.name}
        gold.plot(celsius, oil.alpha(kelvin) * GIGA, **look)
        if oil.stock.agma_k is not None:
            agma.plot(celsius, oil.agma_alpha(kelvin) * GIGA, **look)
    for axes, law in ((gold, "Gold"), (agma, "AGMA 925")):
        axes.set_title(law, fontsize="medium")
        axes.set_ylim(bottom=0)
        _temperature_axis(axes)
        if marked is not None:
            _mark(axes, marked)
    gold.set_ylabel("pressure-viscosity coefficient / (1/GPa)")
    _legend(figure, gold)
    return figure


_LINES = {"mineral": "-", "PAO": "--", "ester": "-.", "PAG": (0, (1, 1))}
"""How the lines of each base stock look."""


def _colours(oils: Sequence[NamedOil]) -> np.ndarray:
    """Colours that darken with the viscosity at 40 degC, alike for like grades."""
    thickness = np.log([float(oil.kinematic_viscosity(ZERO_CELSIUS + 40)) for oil in oils])
    span = np.ptp(thickness)
    fraction = (thickness - thickness.min()) / span if span > 0 else np.full(len(oils), 0.5)
    return colormaps["viridis"](0.8 * (1 - fraction))


def _flowing(oil: NamedOil) -> tuple[np.ndarray, np.ndarray]:
    """Temperatures [degC] at which an oil flows and its laws hold, and its viscosity there [mm2/s]."""
    celsius = np.linspace(COLDEST, HOTTEST, POINTS)
    nu = oil.kinematic_viscosity(celsius + ZERO_CELSIUS) * SQUARE_METRE
    flows = (nu >= THINNEST) & (nu <= THICKEST)
    return celsius[flows], nu[flows]


def _on_walther_axis(nu: Sequence[float] | np.ndarray) -> np.ndarray:
    """Where viscosities [mm2/s] lie on the axis on which the Walther law is straight."""
    return np.asarray(double_log(np.asarray(nu) * SQUARE_MILLIMETRE))


def _walther_axes(axes: Axes) -> None:
    """Axes on which the Walther law is straight, marked in mm2/s and degC."""
    ticks = np.arange(COLDEST, HOTTEST + 1, 20)
    axes.set_xticks(np.log10(ticks + ZERO_CELSIUS), [f"{tick:.0f}" for tick in ticks])
    axes.set_xlim(*np.log10(np.array([COLDEST, HOTTEST]) + ZERO_CELSIUS))
    axes.set_yticks(_on_walther_axis(VISCOSITIES), [str(nu) for nu in VISCOSITIES])
    axes.set_ylim(*_on_walther_axis((THINNEST + 0.5, THICKEST)))
    axes.set_xlabel("temperature / °C")
    axes.set_ylabel("kinematic viscosity / (mm²/s)")
    axes.set_title("Walther's axes (ASTM D341)", fontsize="medium")
    axes.grid(True, color="0.9")


def _temperature_axis(axes: Axes) -> None:
    axes.set_xlim(COLDEST, HOTTEST)
    axes.xaxis.set_major_locator(FixedLocator(np.arange(COLDEST, HOTTEST + 1, 20).tolist()))
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel("temperature / °C")
    axes.grid(True, color="0.9")


def _mark(axes: Axes, kelvin: float) -> None:
    axes.axvline(kelvin - ZERO_CELSIUS, color="0.4", linewidth=0.9, linestyle=":")


def _legend(figure: Figure, axes: Axes) -> None:
    handles, labels = axes.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside right upper", frameon=False, fontsize="small")
