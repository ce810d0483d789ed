"""What a transient solve finds at each of its instants, and curves with error bars from several solves."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pyworm.formulas.arrays import Array
from pyworm.io.plain_dataset import PlainDataset, described
from pyworm.planning.expected_work import Kind
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.target import FILMS, HEAT_FIGURES
from pyworm.solver.level import Level
from pyworm.solver.transient.moving_grid import at_places
from pyworm.solver.transient.unresolved_films import least_error, unresolved

AXES = "xy"

FOR_EACH_LENGTH = ("life_load", "life_power_loss")
"""Variables that are for each length of a line contact."""

MIN_FIGURE = 1e-300
"""Least size of a figure to which its change is relative."""

MAX_CORRECTION = 2.0
"""Largest ratio by which a figure of a coarser solve is corrected."""

CORRECTED_CHANGE_RATIO = 2.0
"""Change by which the error of a figure beyond a stretch is told, over its correction: that changes by as
much as it is from one stretch to the next."""


@dataclass(frozen=True)
class Frame:
    """Fields at one instant on the nodes of the coarsest moving grid of the contact."""

    places: tuple[Array, ...]
    """Places of the nodes along each direction [m]."""
    pressure: NDArray[np.float32]
    """Pressure [Pa], in single precision."""
    film: NDArray[np.float32]
    """Film [m], in single precision."""
    rubbing: NDArray[np.float32] | None = None
    """Pressure that asperities bear times the sliding [W/m2], likewise; None between smooth surfaces."""


@dataclass(frozen=True)
class TimeRecord:
    """Figures of the film at one time, and its fields at some."""

    seconds: float
    """Time since the life began [s]."""
    phase: float | None
    """Place in the mesh cycle."""
    load: float
    """Load that the film carries."""
    entrainment: tuple[float, ...]
    """Mean velocity of the surfaces at the contact point along each direction [m/s]."""
    figures: Mapping[str, float]
    """Figures on the moving grid, temperatures above the colder body's bulk temperature [K]."""
    frame: Frame | None = None
    """Its fields; kept at the instants of the coarsest transient solve."""
    corrected: bool = False
    """Whether its figures are those of the solve before, corrected."""


def time_record(level: Level, seconds: float, frame: Grid | LineGrid | None) -> TimeRecord:
    """What is kept of a film, with its fields at nodes of a grid, if of one."""
    contact = level.scene  # seen from a moving grid, whose contact point rests
    origin = [np.zeros(1) for _ in level.grid.spacing]
    return TimeRecord(
        seconds,
        contact.phase,
        level.carried(),
        tuple(float(component.item()) for component in contact.entrainment_at(*origin)),
        level.read().figures,
        None if frame is None else _frame(level, frame),
    )


def _frame(level: Level, grid: Grid | LineGrid) -> Frame:
    fields = [level.film.pressure, level.film.thickness()]
    if level.film.rough:
        sliding = np.linalg.norm(level.scene.sliding_at(*level.grid.mesh()), axis=0)
        fields.append(level.film.asperities().pressure * sliding)
    pressure, film, *rubbing = (at_places(level.grid, field, grid) for field in fields)
    # between nodes cubics may dip below zero, and so do films that the grid does not resolve
    kept = [np.maximum(values, 0.0) for values in (pressure, film, *rubbing)]
    places = (grid.x, grid.y) if isinstance(grid, Grid) else (grid.x,)
    return Frame(places, *(values.astype(np.float32) for values in kept))


def until(records: Sequence[TimeRecord], seconds: float) -> tuple[TimeRecord, ...]:
    """The moments not later than a time [s]."""
    return tuple(record for record in records if record.seconds <= seconds)


def completed(
    solves: Sequence[tuple[Sequence[TimeRecord], float]],
) -> tuple[tuple[TimeRecord, ...], ...]:
    """Moments of each of some solves of a life, of which later ones go through a stretch of it alone.

    Beyond its stretch a solve has the moments of the one before, their figures times what the nearest moment
    of the stretch has over that of the solve before.

    Args:
        solves: Moments of each, the finest last, and the time from which they no longer depend on how it
            began [s].
    """
    whole: list[tuple[TimeRecord, ...]] = []
    for records, memory_end in solves:
        whole.append(_completed(records, whole[-1], memory_end) if whole else tuple(records))
    return tuple(whole)


def _completed(
    records: Sequence[TimeRecord], coarser: Sequence[TimeRecord], memory_end: float
) -> tuple[TimeRecord, ...]:
    late = [record for record in records if record.seconds >= memory_end]
    known = {record.seconds: record.figures for record in coarser}
    both = [record for record in late if record.seconds in known]
    if not both:
        return tuple(late)
    first, last = late[0].seconds, late[-1].seconds
    before, after = (
        _ratios(record.figures, known[record.seconds]) for record in (both[0], both[-1])
    )
    beyond = (record for record in coarser if not first <= record.seconds <= last)
    corrected = [
        replace(
            record,
            figures=_times(record.figures, before if record.seconds < first else after),
            corrected=True,
        )
        for record in beyond
    ]
    return tuple(sorted([*corrected, *late], key=lambda record: record.seconds))


def _ratios(figures: Mapping[str, float], coarser: Mapping[str, float]) -> dict[str, float]:
    """Figures over those of a coarser solve, between a half and two; one where either is none."""
    least, most = 1 / MAX_CORRECTION, MAX_CORRECTION
    return {
        name: min(max(figure / coarser[name], least), most)
        if min(figure, coarser[name]) > MIN_FIGURE
        else 1.0
        for name, figure in figures.items()
    }


def _times(figures: Mapping[str, float], ratios: Mapping[str, float]) -> dict[str, float]:
    """Figures times their ratios."""
    return {name: figure * ratios[name] for name, figure in figures.items()}


def as_arrays(records: Sequence[TimeRecord]) -> dict[str, Array]:
    """Moments as arrays by names, from which `from_arrays` makes them again."""
    framed = [(record.seconds, record.frame) for record in records if record.frame is not None]
    frames = [frame for _, frame in framed]
    names = list(records[0].figures) if records else []
    return {
        "seconds": np.array([record.seconds for record in records]),
        "phases": np.array([nan if record.phase is None else record.phase for record in records]),
        "loads": np.array([record.load for record in records]),
        "entrainments": np.array([record.entrainment for record in records]),
        "names": np.array(names, dtype=np.str_),
        "figures": np.array([[record.figures[name] for name in names] for record in records]),
        "framed": np.array([record.frame is not None for record in records], dtype=bool),
        **{name: np.array([getattr(frame, name) for frame in frames]) for name in _fields(frames)},
    } | {
        f"places_{axis}": np.array([frame.places[number] for frame in frames])
        for number, axis in enumerate(AXES[: len(frames[0].places)] if frames else ())
    }


def _fields(frames: Sequence[Frame]) -> tuple[str, ...]:
    """Names of the fields that some frames have."""
    rough = bool(frames) and frames[0].rubbing is not None
    return ("pressure", "film", "rubbing") if rough else ("pressure", "film")


OF_EACH = ("seconds", "phases", "loads", "entrainments", "figures", "framed")
"""Arrays with an entry for each moment."""


def from_arrays(arrays: Mapping[str, Array]) -> tuple[TimeRecord, ...]:
    """Moments from `as_arrays`."""
    axes = [f"places_{axis}" for axis in AXES if f"places_{axis}" in arrays]
    fields = [name for name in ("pressure", "film", "rubbing") if name in arrays]
    frames = iter(
        Frame(tuple(columns[: len(axes)]), *columns[len(axes) :])
        for columns in zip(*(arrays[name] for name in (*axes, *fields)), strict=True)
    )
    names = [str(name) for name in arrays["names"]]
    return tuple(
        TimeRecord(
            float(seconds),
            None if np.isnan(phase) else float(phase),
            float(load),
            tuple(map(float, entrainment)),
            dict(zip(names, map(float, figures), strict=True)),
            next(frames) if framed else None,
        )
        for seconds, phase, load, entrainment, figures, framed in zip(
            *(arrays[name] for name in OF_EACH), strict=True
        )
    )


def curves(
    solves: Sequence[Sequence[TimeRecord]],
    since: float,
    kind: Kind,
    share: float,
    least: float,
    present_seconds: float,
    present: Mapping[str, float],
    coldest: float | None,
    reach: float,
) -> PlainDataset:
    """Figures over time with their error bars, and frames of pressure and film.

    A bar is never less than what the curve is off from the present film on the finer grid of the figures, nor
    of films than what others nearby are below zero. Films at a time whose minimum is, are NaN.
    Figures that the present film does not have, whose heat is not simulated though other times of its life
    call for it, have no curve.

    Args:
        solves: Moments of each transient solve, the finest last.
        since: Time after which they are kept [s].
        share: Error of the finest over its change from the one before [-].
        least: Least relative error.
        present_seconds: Time of the present film [s], beyond which the curves of the last scene of a life go
            on.
        present: Figures of that film, on the first grid of the figures.
        coldest: Bulk temperature of the colder body [K]; None where heat was not simulated.
        reach: Distance that oil goes until films have forgotten a time [m].
    """
    records = [record for record in solves[-1] if record.seconds > since]
    thin, least_of_films = _unresolved(solves[-1], reach, len(records))
    variables: dict[str, Any] = {
        "life_load": (("instant",), np.array([record.load for record in records]))
    }
    if records[0].phase is not None:
        variables["life_phase"] = (("instant",), np.array([record.phase for record in records]))
    entrainment = tuple(zip(*(record.entrainment for record in records), strict=True))
    for axis, component in zip(AXES[: len(entrainment)], entrainment, strict=True):
        variables[f"life_entrainment_{axis}"] = ("instant",), np.array(component)
    for name in (name for name in records[0].figures if name in present):
        values = np.array([record.figures[name] for record in records])
        then = float(np.interp(present_seconds, [record.seconds for record in records], values))
        off = abs(present[name] - then) / max(abs(then), MIN_FIGURE)
        error = np.abs(values) * np.maximum(
            max(least, off), share * _changes(solves, records, name)
        )
        if name in FILMS:
            error = np.where(thin, nan, np.maximum(error, least_of_films))
            values = np.where(thin, nan, values)
        base = coldest if name in HEAT_FIGURES else 0.0
        variables[f"life_{name}"] = ("instant",), base + values
        variables[f"life_{name}_error"] = ("instant",), error
    seconds = np.array([record.seconds for record in records])
    found = described(variables | _frames(records), {"life_seconds": (("instant",), seconds)})
    return found if kind == "point" else _for_each_length(found)


def _unresolved(records: Sequence[TimeRecord], reach: float, count: int) -> tuple[Array, Array]:
    """Which of the last times have films that are not resolved, and the least error of films there [m]."""
    figures = [record.figures for record in records]
    seconds = np.array([record.seconds for record in records])
    speed = np.array([np.linalg.norm(record.entrainment) for record in records])
    thin, least = unresolved(figures), least_error(figures, seconds, speed, reach)
    return thin[-count:], least[-count:]


def _for_each_length(dataset: PlainDataset) -> PlainDataset:
    """The dataset of a line contact, whose loads and losses are for each length."""
    variables = {
        name: replace(variable, attrs={**variable.attrs, "units": f"{variable.attrs['units']}/m"})
        if name.startswith(FOR_EACH_LENGTH)
        else variable
        for name, variable in dataset.variables.items()
    }
    return replace(dataset, variables=variables)


def _changes(
    solves: Sequence[Sequence[TimeRecord]], records: Sequence[TimeRecord], name: str
) -> Array:
    """Relative change of a figure by the last solve at some moments of it, straight between those of both."""
    seconds = [record.seconds for record in records]
    if len(solves) == 1:
        return np.zeros(len(seconds))
    before = {record.seconds: record.figures[name] for record in solves[-2]}
    both = [record for record in solves[-1] if record.seconds in before]
    if not both:
        return np.full(len(seconds), np.inf)
    changes = [
        abs(record.figures[name] - before[record.seconds])
        / max(abs(record.figures[name]), MIN_FIGURE)
        for record in both
    ]
    beyond = np.array([record.corrected for record in records], dtype=bool)
    found = np.interp(seconds, [record.seconds for record in both], changes)
    return np.where(beyond, CORRECTED_CHANGE_RATIO, 1.0) * found


def _frames(records: Sequence[TimeRecord]) -> dict[str, tuple[tuple[str, ...], Array]]:
    """Frames as variables over frame and nodes."""
    framed = [(record.seconds, record.frame) for record in records if record.frame is not None]
    if not framed:
        return {}
    frames = [frame for _, frame in framed]
    axes = AXES[: len(frames[0].places)]
    over = ("frame", *(f"node_{axis}" for axis in axes))
    return {
        "frame_seconds": (("frame",), np.array([seconds for seconds, _ in framed])),
        **{
            f"frame_{axis}": (
                ("frame", f"node_{axis}"),
                np.array([frame.places[number] for frame in frames]),
            )
            for number, axis in enumerate(axes)
        },
        **{
            f"frame_{name}": (over, np.array([getattr(frame, name) for frame in frames]))
            for name in _fields(frames)
        },
    }
