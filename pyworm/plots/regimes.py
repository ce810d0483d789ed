"""The chart of regimes for a contact's own shape and entrainment, and the contacts of a result on it."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
import scipy
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.patheffects import withStroke
from matplotlib.ticker import FuncFormatter, NullLocator

from pyworm.formulas.arrays import Values
from pyworm.formulas.film import LineGroups, radii_at_angle
from pyworm.formulas.film_atlas import AtlasGroups, films, regime_measures
from pyworm.formulas.hertz import ellipticity
from pyworm.formulas.regime_charts import (
    POINT_RANGE,
    in_point_range,
    line_chart,
    line_parameters,
    point_chart,
    point_parameters,
)
from pyworm.formulas.regimes import (
    ISOVISCOUS_ELASTIC,
    ISOVISCOUS_RIGID,
    PIEZOVISCOUS_ELASTIC,
    PIEZOVISCOUS_RIGID,
    REGIMES,
    Regime,
    line_measures,
    regime_number,
)
from pyworm.plots.layout import drawn_into, placed_panels, power_of_ten, result_heading
from pyworm.result.result import Result
from pyworm.scene.index import ContactIndex

Numbers = Callable[[np.ndarray, np.ndarray], tuple[Values, Values]]
"""Deflection and thickening at arrays of Moes' M and L."""

SHORT = {
    ISOVISCOUS_RIGID: "rigid,\nisoviscous",
    PIEZOVISCOUS_RIGID: "rigid,\npiezoviscous",
    ISOVISCOUS_ELASTIC: "elastic,\nisoviscous",
    PIEZOVISCOUS_ELASTIC: "elastic,\npiezoviscous",
}
"""Regime -> what it is called in charts."""

SHADES = ["0.96", "#dfe9d8", "#e6e0ee", "#f6ecd6"]
DOTS = ["0.6", "#5b9b3c", "#7a5bb0", "#d79a1e"]
"""Colours of regimes in the order of `REGIMES`: of areas, and of contacts."""

LEAST_FRACTION = 0.02
"""Fraction of the chart below which a regime is not named in it."""

RIGHT_PART = 0.65
"""Part of a chart's width beyond which the name of a contact stands on its left."""

MARGIN_FACTOR = 10.0
"""Factor by which a chart reaches beyond the places of its contacts."""

USUAL = (0.1, 300.0), (0.1, 30.0)
"""What a chart shows at least of M and of L, so that all four regimes are in it."""

CLEAR = 0.05
"""Distance of the names of regimes from lines of either number, in decades of it."""

SIDE_CLEARANCE = 0.09
"""Part of a chart's width at each side that the middle of a name stays clear of."""

LEGEND = 0.5, 0.28
"""Part of the width and height of a chart that its legend takes, in the lower left."""

NODES = 181
"""Places of a chart along each axis."""


def draw_regimes(result: Result, ax: Axes | None = None) -> Figure:
    """Every contact of a result on the chart of its kind, one for lines and one for points.

    With `ax` they take the place of these axes.
    """
    with drawn_into(ax):
        return _drawn(result)


def _drawn(result: Result) -> Figure:
    """The charts."""
    regimes = [solution.regime for solution in result.solutions]
    kinds = sorted({regime.ratio is None for regime in regimes})
    size, room = (6.4 * len(kinds), 5.4), (0.8, 0.1, 0.6, 0.5)
    words = result_heading(result, "regimes of lubrication")
    figure, panels = placed_panels(size, words, room, columns=len(kinds), space=0.17)
    for axes, line in zip(panels, kinds, strict=True):
        shown = [
            (str(ContactIndex.of(solution)) or solution.name, solution.regime)
            for solution in result.solutions
            if (solution.regime.ratio is None) == line
        ]
        _draw_contacts(axes, shown)
    return figure


def draw_chart(axes: Axes, middle: Regime, moes_m: np.ndarray, moes_l: np.ndarray) -> list:
    """The four regimes around places in Moes' M and L [-], by the numbers of `pyworm.formulas.regimes`.

    The chart is that of the shape, entrainment and oil of the contact `middle`. Returns entries of a legend:
    published borders, where the chart has them, and the band of doubt.
    """
    ends = [
        (min(low, np.nanmin(values) / MARGIN_FACTOR), max(high, np.nanmax(values) * MARGIN_FACTOR))
        for values, (low, high) in zip((moes_m, moes_l), USUAL, strict=True)
    ]
    m, el = np.meshgrid(*(np.geomspace(low, high, NODES) for low, high in ends))
    deflection, thickening = numbers_of(middle)(m, el)
    number = regime_number(deflection, thickening)
    _shade(axes, number)
    grey: dict[str, Any] = {"colors": "0.4", "linewidths": 0.8}
    taken = _near(m[0], moes_m)[None, :] & _near(el[:, 0], moes_l)[:, None]
    for measure, error, style in (
        (deflection, middle.deflection_error, ":"),
        (thickening, middle.thickening_error, "-."),
    ):
        distance = np.log10(measure)
        band = np.log10(1 + error)
        axes.contourf(m, el, distance, levels=[-band, band], colors="0.5", alpha=0.15)
        axes.contour(m, el, distance, levels=[0.0], **grey)
        levels = [level for level in (-2, -1, 1, 2, 3) if distance.min() < level < distance.max()]
        lines = axes.contour(m, el, distance, levels=levels, linestyles=style, **grey)
        taken = taken | np.any([np.abs(distance - level) < CLEAR for level in (0, *levels)], axis=0)
        axes.clabel(lines, fmt=lambda level: f"{10.0**level:g}", fontsize=7)
    for index, name in enumerate(SHORT.values()):
        area = number == index
        if np.mean(area) > LEAST_FRACTION:
            row, column = _roomiest(area & ~taken)
            look: dict[str, Any] = {"size": 10, "ha": "center", "va": "center", "color": "0.35"}
            outline = [withStroke(linewidth=2.5, foreground=SHADES[index])]
            axes.text(m[0, column], el[row, 0], name, **look, path_effects=outline)
    axes.set(xscale="log", yscale="log", xlim=ends[0], ylim=ends[1])
    for axis in (axes.xaxis, axes.yaxis):
        # minor ticks, and powers set as formulas, take long to draw
        axis.set_minor_locator(NullLocator())
        axis.set_major_formatter(FuncFormatter(power_of_ten))
    axes.set_xlabel("load parameter M (Moes)")
    axes.set_ylabel("lubricant parameter L (Moes)")
    band = Patch(facecolor="0.5", alpha=0.3, label="border within its uncertainty")
    return [band, *_draw_published(axes, middle, m, el)]


def numbers_of(middle: Regime) -> Numbers:
    """Deflection and thickening over M and L for the shape, entrainment and oil of a contact."""
    if middle.shape is None:
        return partial(_line_numbers, alpha_ratio=middle.alpha_ratio)
    return partial(_point_numbers, middle=middle)


def _line_numbers(m: np.ndarray, el: np.ndarray, alpha_ratio: float) -> tuple[Values, Values]:
    # any speed serves, as both numbers depend on M and L alone
    return line_measures(LineGroups(1.0, 0.5, m, el), alpha_ratio)


def _point_numbers(m: np.ndarray, el: np.ndarray, middle: Regime) -> tuple[Values, Values]:
    groups = AtlasGroups(
        m.ravel(),
        el.ravel(),
        np.full(m.size, middle.ratio),
        np.full(m.size, middle.angle),
        np.full(m.size, middle.spin),
        middle.alpha_ratio,
        middle.compression,
    )
    deflection, thickening = regime_measures(groups, films(groups).minimum)
    return np.reshape(deflection, m.shape), np.reshape(thickening, m.shape)


def _near(axis: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Nodes of an axis within a twentieth of it from any of some values, on its logarithmic scale."""
    distance = np.log(axis[:, None] / np.ravel(values))
    return np.any(np.abs(distance) < 0.05 * np.log(axis[-1] / axis[0]), axis=1)


def _roomiest(area: np.ndarray) -> tuple[int, int]:
    """Row and column of an area that are farthest from its outside, names being wider than high."""
    padded = np.pad(area, 1)
    padded[: int(LEGEND[1] * len(padded)), : int(LEGEND[0] * len(padded))] = False
    side = int(SIDE_CLEARANCE * len(padded))
    padded[:, :side] = padded[:, -side:] = False
    distance = scipy.ndimage.distance_transform_edt(padded, sampling=(1.0, 0.5))
    row, column = np.unravel_index(int(np.argmax(distance)), padded.shape)
    return int(row) - 1, int(column) - 1


def _shade(axes: Axes, number: np.ndarray) -> None:
    """The areas of the regimes, over the whole panel."""
    shades: dict[str, Any] = {"cmap": ListedColormap(SHADES), "vmin": 0, "vmax": 3}
    # places are even on both scales, as those of an image, whose outermost stand on the sides of the panel
    low, high = -0.5 / (len(number) - 1), 1 + 0.5 / (len(number) - 1)
    place: dict[str, Any] = {"extent": (low, high) * 2, "transform": axes.transAxes}
    axes.imshow(number, origin="lower", interpolation="nearest", aspect="auto", **place, **shades)


def _draw_published(axes: Axes, middle: Regime, m: np.ndarray, el: np.ndarray) -> list[Line2D]:
    """Borders of the published chart, if it was made for such a contact."""
    if middle.shape is None:
        number, source = line_chart(*line_parameters(m, el)), "Johnson and Hooke"
    else:
        ratio = _ratio_along(*middle.shape)
        if objection := _beyond_chart(*middle.shape):
            return [Line2D([], [], ls="", label=f"no published chart: {objection}")]
        number, source = point_chart(*point_parameters(m, el), ratio), "Hamrock and Dowson"
    look: dict[str, Any] = {"colors": "tab:blue", "linestyles": "--", "linewidths": 0.9}
    for half in (number // 2, number % 2):  # elastic bodies, piezoviscous oil
        axes.contour(m, el, half, levels=[0.5], **look)
    return [Line2D([], [], color="tab:blue", ls="--", lw=0.9, label=source)]


OBLIQUE = np.radians(5), 1.05
"""Angle to an axis, and ratio of radii, from which entrainment counts as oblique."""


def _beyond_chart(ratio: float, angle: float) -> str:
    """Reason why Hamrock and Dowson's chart was not made for a shape (`Regime.shape`); empty where it was."""
    least_angle, oval = OBLIQUE
    if ratio > oval and least_angle < angle < np.pi / 2 - least_angle:
        return "entrained along no axis"
    least, most = POINT_RANGE
    along = _ratio_along(ratio, angle)
    if in_point_range(along):
        return ""
    return f"ellipticity {ellipticity(1 / along):.2g}, charted {least} to {most}"


def _ratio_along(ratio: float, angle: float) -> float:
    """D of a shape (`Regime.shape`), relative radius along the entrainment over that across [-]."""
    along, across = radii_at_angle(1.0, ratio, angle)
    return float(along / across)


def _draw_contacts(axes: Axes, shown: Sequence[tuple[str, Regime]]) -> None:
    """Contacts of one kind on the chart of the middle one's shape; each has the colour of its own regime."""
    m, el = (
        np.array([getattr(regime, name) for _, regime in shown]) for name in ("moes_m", "moes_l")
    )
    middle = shown[len(shown) // 2][1]
    entries = draw_chart(axes, middle, m, el)
    axes.plot(m, el, "-", color="tab:red", lw=1)
    numbers = np.array([REGIMES.index(regime.name) for _, regime in shown])
    for number in np.unique(numbers):
        which = numbers == number
        look: dict[str, Any] = {"ls": "", "marker": "o", "mec": "tab:red", "ms": 7}
        look["mfc"] = DOTS[number]
        axes.plot(m[which], el[which], **look)
        entries.append(Line2D([], [], label=REGIMES[number], **look))
    for end in {0, len(shown) - 1}:
        right = axes.transLimits.transform(np.log10((m[end], el[end])))[0] > RIGHT_PART
        offset, ha = ((-8, -12), "right") if right else ((8, -12), "left")
        place: dict[str, Any] = {"xytext": offset, "textcoords": "offset points", "ha": ha}
        axes.annotate(shown[end][0], (m[end], el[end]), fontsize=9, **place)
    axes.legend(handles=entries, fontsize=7, loc="lower left", framealpha=0.8)
    axes.set_title(_title(middle, len(shown)), fontsize=9, y=1)


def _title(middle: Regime, contacts: int) -> str:
    """What the chart is of, and what its lines are."""
    if middle.shape is None:
        kind = "line contact"
    elif middle.shape[0] < 1.001:
        kind = "circular contact"
    else:
        ratio, angle = middle.shape
        kind = f"radii 1 : {ratio:.3g}, entrained at {np.degrees(angle):.0f}° to the smaller one"
    whose = f" (the middle one of {contacts})" if contacts > 1 else ""
    lines = "dotted: deflection over film, dash-dotted: αp in the inlet, borders at 1"
    return f"{kind}{whose}\n{lines}"
