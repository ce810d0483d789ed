"""Common parts of all pictures: window, panels, headings."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from math import ceil, log10
from pathlib import Path
from textwrap import fill
from typing import Any, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.figure import Figure
from matplotlib.gridspec import GridSpec

from pyworm.io.plain_dataset import AnyDataset
from pyworm.result.headline import of_all
from pyworm.result.result import Result
from pyworm.scene.index import ContactIndex
from pyworm.solver.solution import Solution

Style = dict[str, Any]
"""How something looks, as arguments of matplotlib."""

MILLI, MICRO, KILO, MEGA = 1e3, 1e6, 1e-3, 1e-6
"""From SI to what the axes show: mm, um, kN and MPa."""

MAX_PANEL_ASPECT = 4.5
"""Panels longer than this many times their height are stretched across."""

LONG_SIDE = 7.0
"""Length of the longer side of a panel [inch]."""

SHORTEST_SIDE = 1.7
"""Least length of the shorter side of a panel [inch], for its labels' sake."""


LEFT_ROOM, RIGHT_ROOM, BOTTOM_ROOM, TOP_ROOM = 0.9, 1.1, 0.6, 0.4
"""Room around a panel for its labels, its colour bar and its title [inch]."""

LINE = 0.22
"""Height of a line of the heading [inch]."""

LETTERS_PER_INCH = 10
"""Letters of a heading that fit into an inch."""

TITLE_LINE, TITLE_LETTERS_PER_INCH = 0.17, 13
"""Height of a line of a panel's title [inch], and letters of it that fit into an inch."""


DOTS_PER_INCH = 150

SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

LOAD_UNITS = {"point": "N", "line": "N/m"}
"""Unit of the load of each kind of contact."""


@dataclass(frozen=True)
class Window:
    """A rectangle of the tangent plane [mm]."""

    left: float
    """Least x [mm]."""
    right: float
    """Largest x [mm]."""
    bottom: float
    """Least y [mm]."""
    top: float
    """Largest y [mm]."""

    @property
    def width(self) -> float:
        """Extent along x [mm]."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """Extent along y [mm]."""
        return self.top - self.bottom

    @property
    def stretch(self) -> float:
        """Scale of y over scale of x: 1, or a whole number or its inverse for slender windows."""
        ratio = self.width / self.height
        if ratio >= 1:
            return float(ceil(ratio / MAX_PANEL_ASPECT))
        return 1 / ceil(1 / ratio / MAX_PANEL_ASPECT)

    @property
    def panel_size(self) -> tuple[float, float]:
        """Width and height of a panel that shows the window [inch]."""
        ratio = self.width / (self.height * self.stretch)
        size = LONG_SIDE if ratio >= 1.3 else 0.75 * LONG_SIDE
        return (size, size / ratio) if ratio >= 1 else (max(size * ratio, SHORTEST_SIDE), size)

    def with_margins(self, along_x: float, along_y: float) -> "Window":
        """The window with margins [mm] on both sides along each direction."""
        left, right = self.left - along_x, self.right + along_x
        return Window(left, right, self.bottom - along_y, self.top + along_y)


def whole_window(fields: AnyDataset) -> Window:
    """The grid and, where given, the outline of the tooth, with a narrow margin."""
    x, y = fields["x"].values, fields["y"].values
    if "tooth_outline_x" in fields:
        x = np.append(x, fields["tooth_outline_x"].values)
        y = np.append(y, fields["tooth_outline_y"].values)
    window = _window(x, y)
    return window.with_margins(0.02 * window.width, 0.02 * window.height)


def contact_window(fields: AnyDataset) -> Window:
    """The dry contact with margins that show its inlet and outlet, within the grid."""
    x, y = fields["x"].values, fields["y"].values
    loaded = field(fields, "dry_pressure") > 0
    columns, rows = loaded.any(axis=0), loaded.any(axis=1)
    if min(columns.sum(), rows.sum()) < 2:
        return _window(x, y)
    contact = _window(x[columns], y[rows])
    short = min(contact.width, contact.height)
    sides = (max(0.08 * side, 0.4 * short) for side in (contact.width, contact.height))
    grid, shown = _window(x, y), contact.with_margins(*sides)
    return Window(
        max(grid.left, shown.left),
        min(grid.right, shown.right),
        max(grid.bottom, shown.bottom),
        min(grid.top, shown.top),
    )


def _window(x: np.ndarray, y: np.ndarray) -> Window:
    sides = (float(end(axis)) * MILLI for axis in (x, y) for end in (np.nanmin, np.nanmax))
    return Window(*sides)


def nodes(fields: AnyDataset) -> tuple[np.ndarray, np.ndarray]:
    """Places of the nodes of fields along x and y [mm]."""
    return fields["x"].values * MILLI, fields["y"].values * MILLI


def field(fields: AnyDataset, name: str) -> np.ndarray:
    """A field over (y, x) in SI."""
    values: np.ndarray = fields[name].transpose("y", "x").values
    return values


def in_window(fields: AnyDataset, window: Window) -> AnyDataset:
    """The part of the fields inside the window, with one more grid line on each side."""
    x, y = nodes(fields)
    return fields.isel(
        x=_slice(x, window.left, window.right), y=_slice(y, window.bottom, window.top)
    )


def _slice(coordinate: np.ndarray, low: float, high: float) -> slice:
    first = int(np.searchsorted(coordinate, low, side="right")) - 1
    last = int(np.searchsorted(coordinate, high, side="left"))
    return slice(max(first, 0), last + 1)


_TARGET: ContextVar[Axes | None] = ContextVar("target", default=None)
"""Axes whose place the pictures take that are drawn meanwhile."""


@contextmanager
def drawn_into(axes: Axes | None) -> Iterator[None]:
    """Let pictures take the place of axes in their figure; each has a figure of its own where None."""
    token = _TARGET.set(axes)
    try:
        yield
    finally:
        _TARGET.reset(token)


def canvas(width: float, height: float, **layout: Any) -> Figure:
    """An empty figure [inch] with a layout, or the place of the axes of `drawn_into`, as large as that is."""
    axes = _TARGET.get()
    if axes is None:
        return Figure(figsize=(width, height), **layout)
    axes.set_axis_off()
    whole = cast(Figure, axes.get_figure(root=True))
    cell = axes.get_subplotspec()
    figure = whole.add_subfigure(GridSpec(1, 1, figure=whole)[0] if cell is None else cell)
    if cell is None:
        figure.bbox_relative.set(axes.get_position())
    return cast(Figure, figure)  # both are a `FigureBase`, whose methods pictures call


def panels(window: Window, titles: list[str], heading: str) -> tuple[Figure, list[Axes]]:
    """Panels of one window, side by side or, if it is wide, stacked; more than two are smaller.

    Placed by hand: automatic layouts lose labels where the aspect of a panel is fixed.
    """
    width, height = window.panel_size
    columns = 1 if width >= 1.3 * height else len(titles)
    shrunk = min(1, 1.5 * LONG_SIDE / (columns * width)) if columns > 1 else 1
    width, height = width * shrunk, height * shrunk
    cell_width = LEFT_ROOM + width + RIGHT_ROOM
    titles = [fill(title, int(TITLE_LETTERS_PER_INCH * cell_width)) for title in titles]
    top = TOP_ROOM + TITLE_LINE * max(title.count("\n") for title in titles)
    cell_height = BOTTOM_ROOM + height + top
    rows = len(titles) // columns
    heading = fill(heading, int(LETTERS_PER_INCH * columns * cell_width))
    head = LINE * (heading.count("\n") + 1) + 0.1
    total_width, total_height = columns * cell_width, rows * cell_height + head
    figure = canvas(total_width, total_height)
    figure.suptitle(heading, y=1 - 0.1 / total_height, verticalalignment="top")
    panels = []
    for number, title in enumerate(titles):
        row, column = divmod(number, columns)
        left = (column * cell_width + LEFT_ROOM) / total_width
        bottom = ((rows - 1 - row) * cell_height + BOTTOM_ROOM) / total_height
        panel = figure.add_axes((left, bottom, width / total_width, height / total_height))
        panel.set_title(title, fontsize="medium", y=1)  # given, or it is sought among the ticks
        panel.set_xlim(window.left, window.right)
        panel.set_ylim(window.bottom, window.top)
        panel.set_aspect(window.stretch)
        panel.set_xlabel(f"x / mm{_stretch_note('y', window.stretch)}")
        panel.set_ylabel(f"y / mm{_stretch_note('x', 1 / window.stretch)}")
        panels.append(panel)
    return figure, panels


def colour_bar(
    axes: Axes,
    mappable: ScalarMappable,
    label: str,
    ticks: np.ndarray | None = None,
    extend: str | None = None,
) -> None:
    """A colour bar beside a panel, as tall as it; `extend` names ends beyond which there are values."""
    width, _ = panel_size(axes)
    bar_axes = axes.inset_axes((1 + 0.1 / width, 0, 0.18 / width, 1))
    figure_of(axes).colorbar(mappable, cax=bar_axes, label=label, ticks=ticks, extend=extend)


def figure_of(axes: Axes) -> Figure:
    """The figure that a panel belongs to, or the place that it has in a figure of several pictures."""
    return cast(Figure, axes.get_figure())


def panel_size(axes: Axes) -> tuple[float, float]:
    """Width and height of a panel [inch]."""
    figure, place = figure_of(axes), axes.get_position()
    box, dots = figure.bbox, figure.dpi
    return place.width * box.width / dots, place.height * box.height / dots


def new_figure(width: float, height: float, heading: str) -> Figure:
    """An empty figure [inch] with its heading, in as many lines as it takes."""
    figure = canvas(width, height, layout="constrained")
    figure.suptitle(fill(heading, int(LETTERS_PER_INCH * width)))
    return figure


def placed_panels(
    size: tuple[float, float],
    heading: str,
    room: tuple[float, float, float, float],
    rows: int = 1,
    columns: int = 1,
    space: float = 0.0,
    **share: bool,
) -> tuple[Figure, list[Axes]]:
    """A figure [inch] and its panels by hand, as to find their places takes as long as drawing them.

    `room` is left of the panels, right of them, below, and between them and the heading [inch]; `space` is
    between panels, in parts of one; `share` are axes that they share, as of `Figure.subplots`.
    """
    (width, height), (left, right, below, above) = size, room
    heading = fill(heading, int(LETTERS_PER_INCH * width))
    above += LINE * (heading.count("\n") + 1)
    figure = canvas(*size)
    figure.suptitle(heading, y=1 - 0.03 / height, verticalalignment="top")
    figure.subplots_adjust(left / width, below / height, 1 - right / width, 1 - above / height)
    kind: Style = {"gridspec_kw": {"hspace": space, "wspace": space}, **share}
    panels = figure.subplots(rows, columns, squeeze=False, **kind)
    return figure, list(panels.flat)


def add_grids(panels: Sequence[Axes]) -> None:
    """Pale lines at the ticks of panels."""
    for panel in panels:
        panel.grid(True, color="0.9")


def power_of_ten(value: float, _: int) -> str:
    """Label of a tick at a power of ten."""
    return "10" + str(round(log10(value))).translate(SUPERSCRIPTS)


def _stretch_note(axis: str, stretch: float) -> str:
    """On the long axis, where there is room: by how much the scale of the other is stretched."""
    return f"  (scales differ: {axis} stretched {stretch:.0f} times)" if stretch > 1 else ""


def heading(case_name: str, solution: Solution) -> str:
    """Heading: case, phase or scene, load; a warning where it did not converge; effects left out."""
    parts = [case_name]
    if solution.phase is not None:
        parts.append(str(ContactIndex.of(solution)))
    elif solution.name != case_name:
        parts.append(solution.name)
    load, unit = solution.load, LOAD_UNITS[solution.kind]
    parts.append(f"{load / 1e3:.4g} k{unit}" if load >= 1e3 else f"{load:.4g} {unit}")
    if not solution.converged:
        parts.append(f"NOT CONVERGED ({solution.stop_reason.partition(';')[0]})")
    elif not solution.accurate:
        parts.append(solution.stop_reason.partition(":")[0])
    return joined(*parts, solution.neglected_effects.words)


def result_heading(result: Result, what: str) -> str:
    """Heading: case, subject of the picture, effects left out."""
    return joined(result.case_name, what, of_all(result.solutions).note)


def joined(*parts: str) -> str:
    """The parts of a heading; no line of it begins with a unit of per cent."""
    return "  ·  ".join(filter(None, parts)).replace(" %", "\N{NO-BREAK SPACE}%")


def broken(label: str) -> str:
    """A label of an axis on two lines, broken where they are nearest to equal lengths."""
    words = label.split(" ")
    halves = [(" ".join(words[:n]), " ".join(words[n:])) for n in range(1, len(words))]
    fitting = [half for half in halves if not half[0].endswith("/")]
    return "\n".join(min(fitting, key=lambda half: max(map(len, half)))) if fitting else label


def mark_gaps(
    axes: Axes, places: Sequence[float] | np.ndarray, solutions: Sequence[Solution]
) -> None:
    """Dotted lines where solutions did not converge, named in the legend."""
    gaps = [
        place for place, solution in zip(places, solutions, strict=True) if not solution.converged
    ]
    label: str | None = f"not converged: {', '.join(f'{place:g}' for place in gaps)}"
    for place in gaps:
        axes.axvline(place, color="black", ls=":", lw=1.2, label=label)
        label = None


def scale_from_zero(axes: Axes, values: np.ndarray, room: float) -> None:
    """The vertical scale from zero to the largest value times some room; as it is without a value."""
    if np.isfinite(values).any():
        axes.set_ylim(0, room * float(np.nanmax(values)))


def write(figure: Figure, path: str | Path) -> Path:
    """Write a picture to a file; returns that."""
    path = Path(path)
    # little compressed, a PNG takes less time and some more room
    options: dict[str, Any] = {}
    if path.suffix == ".png":
        options = {"pil_kwargs": {"compress_level": 1}}
    figure.savefig(path, dpi=DOTS_PER_INCH, **options)
    return path
