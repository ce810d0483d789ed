"""Figures of a sweep against the varied quantities: lines, maps or, for random or many values, clouds."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.axis import Axis as MatplotlibAxis
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

from pyworm.io.quantities import listed
from pyworm.plots.attempts import Attempts
from pyworm.plots.layout import Style, drawn_into, joined, new_figure
from pyworm.result.sweep_result import SweepResult, columns, distinguishing
from pyworm.scene.index import INDEX_NAMES

COLOURS = colormaps["viridis"]

MOST_LINES = 6
"""Largest number of values of a second axis drawn as lines of one picture."""

LOGARITHMIC_RATIO = 4.0
"""Ratio of largest to smallest value beyond which a scale is logarithmic."""

MOST_DECADES = 4
"""Decades that are still written as plain numbers."""

MOST_COLUMNS = 6
"""Columns of clouds that one picture takes."""


@dataclass(frozen=True)
class _Axis:
    """One varied quantity."""

    label: str
    """What it is, with its unit."""
    values: np.ndarray
    """Values of each scene; places 0, 1, ... where they are texts."""
    names: tuple[str, ...] = ()
    """The texts; none where they are numbers."""

    @property
    def distinct(self) -> np.ndarray:
        """Its values, ascending."""
        return np.unique(self.values)

    @property
    def logarithmic(self) -> bool:
        """Whether its range asks for a logarithmic scale."""
        return _is_wide(self.values)


@dataclass(frozen=True)
class _Shown:
    """A figure of all scenes in the unit shown, its errors, and whether its scale begins at zero."""

    label: str
    values: np.ndarray
    errors: np.ndarray
    has_zero: bool


def write_sweep(result: SweepResult, path: Path) -> list[Path]:
    """Write the picture of a sweep as PNG; PicturesError if that fails."""
    attempts = Attempts()
    attempts.draw(path, partial(draw_sweep, result))
    return attempts.result()


def draw_sweep(result: SweepResult, ax: Axes | None = None) -> Figure:
    """Films, pressure, and friction and temperature where simulated, over all that varies.

    With `ax` it takes the place of these axes. ValueError where no contact converged.
    """
    with drawn_into(ax):
        return _drawn(result)


def _drawn(result: SweepResult) -> Figure:
    """The picture by the number of quantities that vary."""
    axes, figures = _axes(result), _shown(result)
    if not result.converged.any():
        raise ValueError("no scene of the sweep converged, there is nothing to draw")
    if len(axes) == 1 and _crossed(axes):
        return _draw_lines(result, axes[0], None, figures)
    if len(axes) == 2 and _crossed(axes):
        few, many = sorted(axes, key=lambda axis: axis.distinct.size)
        if few.distinct.size <= MOST_LINES:
            return _draw_lines(result, many, few, figures)
        return _draw_maps(result, many, few, figures)
    return _draw_clouds(result, axes, figures)


def _axes(result: SweepResult) -> list[_Axis]:
    """Varied quantities: the sweep's axes, and the places of its cases."""
    table = result.table
    axes = []
    for keys in result.axes:
        names = distinguishing(result, keys)
        labels = names if len(names) > 1 else [_joint(columns(result, keys))]
        for name, label in zip(names, labels, strict=True):
            unit = table[name].attrs.get("units", "")
            axes.append(_axis(f"{label} / {unit}" if unit else label, table[name].values))
    for name in INDEX_NAMES:
        if name in table:
            axes.append(_axis(name.replace("_", " "), table[name].values))
    varying = [axis for axis in axes if axis.distinct.size > 1]
    return varying or axes[:1]


def _joint(names: Sequence[str]) -> str:
    """Common name of variables that vary together."""
    first, *others = names
    return f"{first} and {len(others)} more" if len(others) > 1 else " and ".join(names)


def _axis(label: str, values: np.ndarray) -> _Axis:
    if values.dtype.kind == "f":
        return _Axis(label, values)
    names = list(dict.fromkeys(values.tolist()))
    return _Axis(label, np.array([float(names.index(name)) for name in values]), tuple(names))


def _shown(result: SweepResult) -> list[_Shown]:
    table = result.table
    shown = []
    for quantity in listed("picture"):
        key = quantity.key
        if key in table and np.isfinite(table[key]).any():
            relative = quantity.unit != "K"
            values = np.where(result.converged, quantity.by_key(table[key].values), np.nan)
            errors = table[quantity.error_key].values * (abs(values) if relative else 1.0)
            label = quantity.axis()
            if quantity.name == "friction_coefficient":
                label = result.neglected_effects.qualified(label)
            shown.append(_Shown(label, values, errors, relative))
    return shown


def _crossed(axes: Sequence[_Axis]) -> bool:
    """Whether every combination of values is there once."""
    count = int(np.prod([axis.distinct.size for axis in axes]))
    return (
        count == axes[0].values.size == len(set(zip(*(axis.values for axis in axes), strict=True)))
    )


def _draw_lines(
    result: SweepResult, along: _Axis, family: _Axis | None, figures: list[_Shown]
) -> Figure:
    """One panel for each figure, one line for each value of the second axis."""
    picture = new_figure(8, 2.8 * len(figures) + 0.8, _heading(result))
    panels = picture.subplots(len(figures), sharex=True, squeeze=False)[:, 0]
    members = [(None, "")]
    if family is not None:
        members = [(family.values == value, _name(family, value)) for value in family.distinct]
    # as an ordered family; the palest yellow end would not show on white
    colours = COLOURS(np.linspace(0, 0.85, len(members)))
    for panel, figure in zip(panels, figures, strict=True):
        for (member, name), colour in zip(members, colours, strict=True):
            chosen = np.ones(along.values.size, bool) if member is None else member
            chosen = np.flatnonzero(chosen)[np.argsort(along.values[chosen])]
            errors = _finite_errors(figure)[chosen]
            look: Style = {"color": colour, "capsize": 3, "markersize": 4, "label": name or None}
            look["fmt"] = "o" if along.names else "o-"
            panel.errorbar(along.values[chosen], figure.values[chosen], errors, **look)
        _cross_out(panel, along.values, result)
        _scale(panel, along, figure)
        panel.set_ylabel(figure.label)
    panels[-1].set_xlabel(along.label)
    if family is not None:
        picture.legend(
            *panels[0].get_legend_handles_labels(),
            title=family.label,
            loc="outside right center",
            frameon=False,
        )
    elif not result.converged.all():
        panels[0].legend(frameon=False)
    return picture


def _draw_maps(result: SweepResult, along: _Axis, across: _Axis, figures: list[_Shown]) -> Figure:
    """One panel for each figure, one cell for each scene."""
    rows, failed = -(-len(figures) // 2), ~result.converged
    note = "  ·  crosses: not converged" if failed.any() else ""
    picture = new_figure(10.5, 3.6 * rows + 0.8, _heading(result) + note)
    panels = picture.subplots(rows, 2, squeeze=False)
    columns_, lines = along.distinct, across.distinct
    place = np.searchsorted(lines, across.values), np.searchsorted(columns_, along.values)
    for panel, figure in zip(panels.flat[: len(figures)], figures, strict=True):
        cells = np.full((lines.size, columns_.size), np.nan)
        cells[place] = figure.values
        mesh = panel.pcolormesh(
            _edges(columns_, along.logarithmic),
            _edges(lines, across.logarithmic),
            cells,
            cmap=COLOURS,
            norm="log" if _is_wide(figure.values) else "linear",
        )
        bar = picture.colorbar(mesh, ax=panel, label=figure.label)
        if _is_wide(figure.values):
            _plain_decades(bar.ax.yaxis, figure.values)
        panel.plot(along.values[failed], across.values[failed], "x", color="red", markersize=7)
        for axis, side in ((along, panel.xaxis), (across, panel.yaxis)):
            if axis.logarithmic:
                getattr(panel, f"set_{side.axis_name}scale")("log")
            _ticks(side, axis)
        panel.set_xlabel(along.label)
        panel.set_ylabel(across.label)
    for panel in panels.flat[len(figures) :]:
        panel.remove()
    return picture


def _draw_clouds(result: SweepResult, axes: list[_Axis], figures: list[_Shown]) -> Figure:
    """One row for each figure, one column for each varied quantity, one dot for each scene."""
    axes = axes[:MOST_COLUMNS]
    picture = new_figure(max(3.0 * len(axes) + 1, 6), 2.5 * len(figures) + 0.8, _heading(result))
    panels = picture.subplots(len(figures), len(axes), sharex="col", sharey="row", squeeze=False)
    for row, figure in zip(panels, figures, strict=True):
        for panel, axis in zip(row, axes, strict=True):
            panel.plot(axis.values, figure.values, "o", color="tab:blue", markersize=4, alpha=0.7)
            _cross_out(panel, axis.values, result)
            _scale(panel, axis, figure)
        row[0].set_ylabel(figure.label)
    for panel, axis in zip(panels[-1], axes, strict=True):
        panel.set_xlabel(axis.label)
    if not result.converged.all():
        panels[0, 0].legend(frameon=False)
    return picture


def _cross_out(panel: Axes, x: np.ndarray, result: SweepResult) -> None:
    """A cross on the lower edge of the panel where a scene did not converge, which has no value."""
    places = x[~result.converged]
    if places.size:
        look: Style = {"color": "black", "markersize": 10, "clip_on": False}
        look |= {"transform": panel.get_xaxis_transform(), "label": "not converged"}
        panel.plot(places, np.zeros(places.size), "x", **look)


def _scale(panel: Axes, axis: _Axis, figure: _Shown) -> None:
    if axis.logarithmic:
        panel.set_xscale("log")
    if _is_wide(figure.values):
        panel.set_yscale("log")
        _plain_decades(panel.yaxis, figure.values)
    elif figure.has_zero:
        panel.set_ylim(0, 1.05 * np.nanmax(figure.values + _finite_errors(figure)))
    _ticks(panel.xaxis, axis)
    panel.grid(True, color="0.9")


def _finite_errors(figure: _Shown) -> np.ndarray:
    """Errors of a figure, zero where they have no bound."""
    return np.where(np.isfinite(figure.errors), figure.errors, 0.0)


def _ticks(side: MatplotlibAxis, axis: _Axis) -> None:
    """Tick labels: names for texts, plain numbers on a logarithmic axis."""
    if axis.names:
        side.set_ticks(range(len(axis.names)), axis.names)
    elif axis.logarithmic:
        _plain_decades(side, axis.values)


def _plain_decades(side: MatplotlibAxis, values: np.ndarray) -> None:
    """Numbers at 1, 2 and 5 of each decade of a logarithmic axis, while there are few decades."""
    decades = np.log10(np.nanmax(values) / np.nanmin(values))
    if decades <= MOST_DECADES:
        side.set_major_locator(LogLocator(subs=(1, 2, 5) if decades <= 2 else (1,)))
        side.set_major_formatter("{x:g}")
        side.set_minor_formatter(NullFormatter())


def _edges(centres: np.ndarray, logarithmic: bool) -> np.ndarray:
    """Edges of cells around values, half-way between neighbours."""
    values = np.log(centres) if logarithmic else centres
    middles = (values[1:] + values[:-1]) / 2
    edges = np.concatenate([[2 * values[0] - middles[0]], middles, [2 * values[-1] - middles[-1]]])
    return np.exp(edges) if logarithmic else edges


def _is_wide(values: np.ndarray) -> bool:
    """Whether values are better seen on a logarithmic scale."""
    finite = values[np.isfinite(values)]
    return bool(finite.min() > 0 and finite.max() > LOGARITHMIC_RATIO * finite.min())


def _name(axis: _Axis, value: float) -> str:
    return axis.names[int(value)] if axis.names else f"{value:.3g}"


def _heading(result: SweepResult) -> str:
    return joined(result.name, result.title, result.neglected_effects.note)
