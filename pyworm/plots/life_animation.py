"""An animation of pressure and film while a contact lives."""

from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.animation import FFMpegWriter, FuncAnimation, PillowWriter
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh

from pyworm.io.present import present
from pyworm.io.quantities import QUANTITIES
from pyworm.plots.layout import MILLI, joined, placed_panels
from pyworm.result.headline import of_all
from pyworm.result.life import ContactLife, Fields
from pyworm.result.result import Result

PRESSURE, FILM = QUANTITIES["pressure"], QUANTITIES["film"]

WRITERS = {"gif": PillowWriter, "mp4": FFMpegWriter}
"""Suffix of the file -> writer of matplotlib."""

RATE = 12
"""Frames a second: oil passes through a point contact in one second."""

DOTS_PER_INCH = 90

SHOWN_PRESSURE_RATIO = 0.01
"""Pressure, over the largest of all, down to which places are within the picture."""

THICKEST = 3.0
"""Thickest film shown, over the median central one."""

MARGIN_FRACTION = 0.15
"""Room around them, over their extent."""


def animate(result: Result, life: ContactLife, path: Path) -> Path:
    """Write an animation of a life; its kind follows from the file's suffix (`WRITERS`).

    ValueError if the life has no fields, the suffix is another one, or no program writes such a file here.
    """
    if not life.frames:
        raise ValueError("this result has no fields over time; only transient solutions have")
    kind = path.suffix.removeprefix(".")
    if kind not in WRITERS:
        raise ValueError(f"{path}: an animation ends with .{' or .'.join(WRITERS)}")
    writer: Any = WRITERS[kind]
    if not writer.isAvailable():
        other = "install ffmpeg, or ask for --animate gif"
        raise ValueError(f"no program writes {kind} files here; {other}")
    drawing = Points(result, life) if life.frames[0].y is not None else Lines(result, life)
    animation = FuncAnimation(drawing.figure, drawing.show, len(life.frames), blit=False)
    animation.save(path, writer(fps=RATE), dpi=DOTS_PER_INCH)
    return path


class Points:
    """Maps of pressure and film of a point contact."""

    def __init__(self, result: Result, life: ContactLife):
        self._life = life
        self._pressure = PRESSURE.number(max(float(frame.pressure.max()) for frame in life.frames))
        self._film = _thickest(life)
        left, right, low, high = _window(life)
        wide = (right - left) > 1.3 * (high - low)
        size, rows, columns, space = ((8, 6.4), 2, 1, 0.3) if wide else ((9, 5.2), 1, 2, 0.4)
        room = (0.85, 0.4, 0.85, 0.3)
        self.figure, panels = placed_panels(
            size, _heading(result, life), room, rows, columns, space
        )
        self._note = self.figure.text(0.02, 0.01, "")
        self._maps = []
        labels = (
            (PRESSURE.axis(), PRESSURE.colours, self._pressure),
            (FILM.axis(), FILM.colours, self._film),
        )
        for panel, (label, colours, top) in zip(panels, labels, strict=True):
            panel.set_xlim(left, right)
            panel.set_ylim(low, high)
            panel.set_xlabel("x / mm")
            panel.set_ylabel("y / mm")
            panel.set_facecolor("0.8")
            frame = life.frames[0]
            drawn = self._drawn(panel, frame, np.zeros(frame.pressure.shape), colours, top)
            self.figure.colorbar(drawn, ax=panel, label=label)
            self._maps.append((panel, colours, top))

    def _drawn(
        self, panel: Axes, frame: Fields, values: np.ndarray, colours: str, top: float
    ) -> QuadMesh:
        return panel.pcolormesh(
            frame.x * MILLI,
            present(frame.y, "y") * MILLI,
            np.clip(values, 0, top).T,
            cmap=colours,
            vmin=0,
            vmax=top,
            shading="gouraud",
        )

    def show(self, number: int) -> None:
        """Draw one frame."""
        frame = self._life.frames[number]
        fields = PRESSURE.number(frame.pressure), FILM.number(frame.film)
        for (panel, colours, top), values in zip(self._maps, fields, strict=True):
            for old in list(panel.collections):
                old.remove()
            self._drawn(panel, frame, values, colours, top)
            x, y = frame.x * MILLI, present(frame.y, "y") * MILLI
            outline = SHOWN_PRESSURE_RATIO * self._pressure
            if fields[0].max() > outline:
                panel.contour(x, y, fields[0].T, levels=[outline], colors="white", linewidths=0.8)
        self._note.set_text(_told(self._life, frame))


class Lines:
    """Pressure and film of a line contact across the line."""

    def __init__(self, result: Result, life: ContactLife):
        self._life = life
        left, right, _, _ = _window(life)
        room = (0.8, 0.8, 0.85, 0.1)
        self.figure, (axes,) = placed_panels((8, 4.5), _heading(result, life), room)
        axes.set_xlim(left, right)
        axes.set_xlabel("x / mm")
        axes.set_ylabel(PRESSURE.axis(), color="tab:red")
        highest = max(float(frame.pressure.max()) for frame in life.frames)
        axes.set_ylim(0, 1.1 * PRESSURE.number(highest))
        (self._pressure,) = axes.plot([], [], color="tab:red")
        films = axes.twinx()
        films.set_ylabel(FILM.axis(), color="tab:blue")
        films.set_ylim(0, _thickest(life))
        (self._film,) = films.plot([], [], color="tab:blue")
        self._note = self.figure.text(0.02, 0.01, "")

    def show(self, number: int) -> None:
        """Draw one frame."""
        frame = self._life.frames[number]
        self._pressure.set_data(frame.x * MILLI, PRESSURE.number(frame.pressure))
        self._film.set_data(frame.x * MILLI, FILM.number(frame.film))
        self._note.set_text(_told(self._life, frame))


def _thickest(life: ContactLife) -> float:
    """Upper end of the scale of films [um]."""
    return FILM.number(THICKEST * float(np.nanmedian(life.figures["film_central"])))


def _heading(result: Result, life: ContactLife) -> str:
    return joined(result.case_name, str(life.place), of_all(life.solutions).note)


def _told(life: ContactLife, frame: Fields) -> str:
    """Time, phase, load and minimum film thickness of a frame."""
    index = int(np.argmin(np.abs(life.seconds - frame.seconds)))
    parts = [f"{frame.seconds / 1e-3:.3f} ms"]
    if life.phases is not None:
        parts.append(f"phase {life.phases[index]:.3f}")
    load = f"{life.load[index]:.4g} {'N' if life.kind == 'point' else 'N/m'}"
    thin = QUANTITIES["film_min"]
    value = life.figures["film_min"][index]
    film = "not resolved" if np.isnan(value) else thin.with_unit(f"{thin.number(value):.3f}")
    return "   ".join([*parts, load, f"{thin.words()} {film}"])


def _window(life: ContactLife) -> tuple[float, float, float, float]:
    """Ends of the picture along x and y [mm]: wherever there is pressure at any time."""
    least = SHOWN_PRESSURE_RATIO * max(float(frame.pressure.max()) for frame in life.frames)
    ends = []
    for frame in life.frames:
        axes = (frame.x,) if frame.y is None else (frame.x, frame.y)
        nodes = np.nonzero(frame.pressure > least)
        if len(nodes[0]):
            ends.append(
                [
                    (axis[node.min()], axis[node.max()])
                    for axis, node in zip(axes, nodes, strict=True)
                ]
            )
    spans = []
    for direction in range(len(ends[0])):
        low = min(end[direction][0] for end in ends) * MILLI
        high = max(end[direction][1] for end in ends) * MILLI
        room = MARGIN_FRACTION * (high - low)
        spans += [low - room, high + room]
    return (*spans, 0.0, 0.0)[:4]
