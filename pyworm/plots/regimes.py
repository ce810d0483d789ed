"""The chart of regimes of lubrication, and the contacts of a result on it."""

from collections.abc import Callable
from functools import partial

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.ticker import NullLocator

from pyworm.formulas.film import ellipticity
from pyworm.formulas.regimes import (
    ISOVISCOUS_ELASTIC,
    ISOVISCOUS_RIGID,
    PIEZOVISCOUS_ELASTIC,
    PIEZOVISCOUS_RIGID,
    POINT_RANGE,
    Regime,
    line_films,
    point_films,
)
from pyworm.plots.layout import placed_panels, power_of_ten, result_heading
from pyworm.result.result import Result
from pyworm.scene.index import Place

SHORT = {
    ISOVISCOUS_RIGID: "rigid,\nisoviscous",
    PIEZOVISCOUS_RIGID: "rigid,\npiezoviscous",
    ISOVISCOUS_ELASTIC: "elastic,\nisoviscous",
    PIEZOVISCOUS_ELASTIC: "elastic,\npiezoviscous",
}
"""Regime -> what it is called in charts."""

SHADES = ["0.96", "#dfe9d8", "#e6e0ee", "#f6ecd6"]

LEAST_FRACTION = 0.02
"""Fraction of the chart below which a regime is not named in it."""

MARGIN = 30.0
"""Factor by which a chart reaches beyond the places of its contacts."""


def draw_regimes(result: Result) -> Figure:
    """Every contact of a result on the chart of its kind, one for lines and one for points."""
    regimes = [solution.regime for solution in result.solutions]
    kinds = [kind for kind in (False, True) if any((one.ratio is None) == kind for one in regimes)]
    size, room = (6.4 * len(kinds), 5.2), (0.8, 0.1, 0.6, 0.35)
    spaced = {"ncols": len(kinds), "squeeze": False, "gridspec_kw": {"wspace": 0.17}}
    words = result_heading(result, "regimes of lubrication")
    figure, panels = placed_panels(size, words, room, **spaced)
    for axes, line in zip(panels[0], kinds, strict=True):
        shown = [
            (str(Place.of(solution)) or solution.name, solution.regime)
            for solution in result.solutions
            if (solution.regime.ratio is None) == line
        ]
        _draw_contacts(axes, shown)
    return figure


def draw_chart(
    axes: Axes,
    films: Callable[[np.ndarray, np.ndarray], dict[str, np.ndarray | float]],
    elastic,
    viscous,
) -> None:
    """The four regimes around given places.

    Parameters
    ----------
    axes : Axes
        Where to draw.
    films : callable
        Film of each regime at arrays of g_V and g_E.
    elastic, viscous : array
        The places, g_E and g_V [-].
    """
    ends = [
        (min(0.5, np.nanmin(values) / MARGIN), np.nanmax(values) * MARGIN)
        for values in (elastic, viscous)
    ]
    ge, gv = np.meshgrid(*(np.geomspace(low, high, 300) for low, high in ends))
    film = {name: np.broadcast_to(of, ge.shape) for name, of in films(gv, ge).items()}
    # a rigid film is surpassed by the elastic isoviscous one, and caps the elastic piezoviscous one
    thin = np.log(film[ISOVISCOUS_ELASTIC] / film[ISOVISCOUS_RIGID])
    thick = np.log(film[PIEZOVISCOUS_RIGID] / film[PIEZOVISCOUS_ELASTIC])
    isoviscous = np.maximum(film[ISOVISCOUS_RIGID], film[ISOVISCOUS_ELASTIC])
    piezoviscous = np.minimum(film[PIEZOVISCOUS_RIGID], film[PIEZOVISCOUS_ELASTIC])
    gain = np.log(piezoviscous / isoviscous)
    number = np.where(gain > 0, np.where(thick > 0, 3, 1), np.where(thin > 0, 2, 0))
    shades = {"cmap": ListedColormap(SHADES), "vmin": 0, "vmax": 3}
    # places are even on both scales, as those of an image, whose outermost stand on the sides of the panel
    low, high = -0.5 / (len(number) - 1), 1 + 0.5 / (len(number) - 1)
    place = {"extent": (low, high) * 2, "transform": axes.transAxes, "aspect": "auto"}
    axes.imshow(number, origin="lower", interpolation="nearest", **place, **shades)
    for boundary in (
        gain,
        np.ma.masked_where(gain < 0, thick),
        np.ma.masked_where(gain > 0, thin),
    ):
        axes.contour(ge, gv, boundary, levels=[0.0], colors="0.4", linewidths=0.8)
    for index, name in enumerate(SHORT.values()):
        rows, columns = np.nonzero(number == index)
        if len(rows) > LEAST_FRACTION * number.size:
            middle = int(np.median(rows))
            place = ge[0, int(np.median(columns[rows == middle]))], gv[middle, 0]
            axes.text(*place, name, color="0.35", size=10, ha="center", va="center")
    axes.set(xscale="log", yscale="log", xlim=ends[0], ylim=ends[1])
    for axis in (axes.xaxis, axes.yaxis):
        # minor ticks, and powers set as formulas, take long to draw
        axis.set_minor_locator(NullLocator())
        axis.set_major_formatter(power_of_ten)
    axes.set_xlabel("elasticity parameter $g_E$")
    axes.set_ylabel("viscosity parameter $g_V$")


def _draw_contacts(axes: Axes, shown: list[tuple[str, Regime]]) -> None:
    """Contacts of one kind; the boundaries of points are those of the middle one's shape."""
    elastic, viscous = (
        np.array([regime.parameters[name] for _, regime in shown])
        for name in ("elasticity", "viscosity")
    )
    if shown[0][1].ratio is None:
        films, title = line_films, "line contacts (Johnson, Hooke)"
    else:
        ratio = sorted(regime.ratio for _, regime in shown)[len(shown) // 2]
        films = partial(point_films, ratio=ratio)
        shape = f"{ellipticity(1 / ratio):.3g}"
        title = f"points of ellipticity {shape} (Hamrock and Dowson: {POINT_RANGE[0]} to {POINT_RANGE[1]})"
    draw_chart(axes, films, elastic, viscous)
    axes.plot(elastic, viscous, "o-", color="tab:red", mec="black", lw=1, ms=6)
    for end in {0, len(shown) - 1}:
        axes.annotate(
            shown[end][0],
            (elastic[end], viscous[end]),
            xytext=(8, -12),
            textcoords="offset points",
            fontsize=9,
        )
    axes.set_title(title, fontsize=10, y=1)
