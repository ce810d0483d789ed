"""The life of a contact whose film is in motion: its figures over time, their extremes and integrals.

Each solution holds what transient solves found since the contact solved before it; together they are the life
of a tooth pair from its first touch to the last phase that was solved, or the past of a contact.
"""

from collections import defaultdict
from collections.abc import Sequence
from csv import writer
from dataclasses import dataclass, replace
from io import StringIO

import numpy as np

from pyworm.io.on_demand import xarray as xr
from pyworm.io.plain_dataset import PlainDataset
from pyworm.io.quantities import OVER_LIFE
from pyworm.result.result import Result
from pyworm.scene.index import ContactIndex
from pyworm.solver.solution import Solution

Array = np.ndarray

VELOCITIES = "life_entrainment_x", "life_entrainment_y"

FRAMED = "frame_pressure", "frame_film", "frame_rubbing"
"""Fields over the life, the last between rough surfaces only."""

LARGEST_STEP = 3.0
"""Step from one instant to the next, over both steps beside it, from which a part of the life counts as not
solved: a curve has a gap there."""


@dataclass(frozen=True)
class Fields:
    """Fields at one instant."""

    seconds: float
    """Time since the life began [s]."""
    x: Array
    """Places of the nodes along x [m]."""
    y: Array | None
    """Places of the nodes along y [m]; None of a line contact."""
    pressure: Array
    """Pressure over (x, y) [Pa]."""
    film: Array
    """Film over (x, y) [m]."""
    rubbing: Array | None = None
    """Pressure that asperities bear times the sliding [W/m2]; None between smooth surfaces."""


@dataclass(frozen=True)
class ContactLife:
    """Figures of a contact over its life."""

    place: ContactIndex
    """Which contact of the case it is, without a phase."""
    kind: str
    """Kind of contact: "point" or "line"."""
    seconds: Array
    """Times since the life began [s]."""
    phases: Array | None
    """Place in the mesh cycle at each time; None of a contact that is not one of a drive."""
    load: Array
    """Load [N], of a line contact for each length [N/m]."""
    entrainment: Array
    """Mean velocity of the surfaces at the contact point, along the last one [m/s]."""
    figures: dict[str, Array]
    """Figures by name (`io.quantities.OVER_LIFE`), in SI; films that the grid does not resolve are NaN."""
    errors: dict[str, Array]
    """Numerical error bars of the figures, in SI."""
    frames: tuple[Fields, ...]
    """Fields at some of the times."""
    solutions: tuple[Solution, ...]
    """The contacts of this life that were solved on the grids of the figures."""

    @property
    def span(self) -> float:
        """Time from the first instant to the last [s]."""
        return float(self.seconds[-1] - self.seconds[0])

    @property
    def gaps(self) -> Array:
        """Numbers of the instants before which part of the life was not solved."""
        steps = np.diff(self.seconds)
        beside = np.maximum(np.append(0.0, steps[:-1]), np.append(steps[1:], 0.0))
        return np.flatnonzero(steps > LARGEST_STEP * beside) + 1

    def work(self) -> tuple[float, float] | None:
        """Work of friction [J], of a line contact for each length [J/m], and its error bar."""
        if "power_loss" not in self.figures:
            return None
        work, error = (
            float(np.trapezoid(values["power_loss"], self.seconds))
            for values in (self.figures, self.errors)
        )
        return work, error

    def extreme(self, name: str) -> tuple[float, float, float]:
        """The least film, or the largest value of another figure, its error bar and its time [s].

        Films that the grid does not resolve, NaN, do not count; without any other the first is given.
        """
        values = self.figures[name]
        known = np.nan_to_num(values, nan=np.inf)
        index = int(np.argmin(known) if name.startswith("film") else np.argmax(values))
        return float(values[index]), float(self.errors[name][index]), float(self.seconds[index])

    def summary(self) -> dict:
        """Extremes and work of friction as one object, units in the keys."""
        told = {
            f"{name}_{SUFFIX[name]}".rstrip("_"): dict(
                zip(("value", "error", "seconds"), self.extreme(name), strict=True)
            )
            for name in EXTREMES
            if name in self.figures
        }
        work = self.work()
        unit = "J" if self.kind == "point" else "J_m"
        return {
            **self.place.given,
            "instants": len(self.seconds),
            "from_s": float(self.seconds[0]),
            "to_s": float(self.seconds[-1]),
            **told,
            **(
                {}
                if work is None
                else {f"friction_work_{unit}": work[0], f"friction_work_error_{unit}": work[1]}
            ),
        }


EXTREMES = ("film_min", "pressure_max", "friction_coefficient", "temperature_max_film")
SUFFIX = {"film_min": "m", "pressure_max": "Pa", "temperature_max_film": "K"} | {
    "friction_coefficient": ""
}


def lives(result: Result) -> tuple[ContactLife, ...]:
    """The lives of the contacts of a result whose films are in motion, in the order of its solutions."""
    by_place = defaultdict(list)
    for solution in result.solutions:
        if solution.held("life") is not None:
            by_place[replace(ContactIndex.of(solution), phase=None)].append(solution)
    return tuple(_life(place, solutions) for place, solutions in by_place.items())


def life_names(result: Result) -> dict[str, ContactLife]:
    """The lives by the names of their files: "life", and the place where there are several."""
    found = lives(result)
    words = (["life", *str(life.place).replace(",", "").split()] for life in found)
    return {"_".join(parts): life for parts, life in zip(words, found, strict=True)}


def _life(place: ContactIndex, solutions: Sequence[Solution]) -> ContactLife:
    held = [solution.dataset("life") for solution in solutions]
    times = np.concatenate([dataset["life_seconds"].values for dataset in held])
    seconds, first = np.unique(times, return_index=True)

    def over_life(name: str) -> Array:
        return np.concatenate([dataset[name].values for dataset in held])[first]

    names = [name for name in OVER_LIFE if all(f"life_{name}" in dataset for dataset in held)]
    frames = {frame.seconds: frame for dataset in held for frame in _frames(dataset)}
    return ContactLife(
        place,
        solutions[0].kind,
        seconds,
        over_life("life_phase") if all("life_phase" in dataset for dataset in held) else None,
        over_life("life_load"),
        _along_last(
            [over_life(name) for name in VELOCITIES if all(name in dataset for dataset in held)]
        ),
        {name: over_life(f"life_{name}") for name in names},
        {name: over_life(f"life_{name}_error") for name in names},
        tuple(frames[seconds_of_frame] for seconds_of_frame in sorted(frames)),
        tuple(solutions),
    )


def _along_last(components: Sequence[Array]) -> Array:
    """The part of a velocity along its last value; its size where that is zero."""
    velocity = np.stack(components)
    last = velocity[:, -1]
    speed = np.linalg.norm(last)
    return velocity.T @ last / speed if speed > 0 else np.linalg.norm(velocity, axis=0)


def _frames(dataset: "PlainDataset | xr.Dataset") -> list[Fields]:
    if "frame_seconds" not in dataset:
        return []
    columns = zip(
        dataset["frame_seconds"].values,
        dataset["frame_x"].values,
        dataset["frame_y"].values if "frame_y" in dataset else dataset["frame_seconds"].values,
        *(dataset[name].values for name in FRAMED if name in dataset),
        strict=True,
    )
    return [
        Fields(float(seconds), x, y if np.ndim(y) else None, *fields)
        for seconds, x, y, *fields in columns
    ]


def as_csv(all_lives: Sequence[ContactLife]) -> str:
    """A table of all instants: place, time, phase, load, and each figure with its error bar, in SI."""
    names = [name for name in OVER_LIFE if any(name in life.figures for life in all_lives)]
    places = list({name: None for life in all_lives for name in life.place.given})
    text = StringIO()
    table = writer(text, lineterminator="\n")
    of_figures = [column for name in names for column in (name, f"{name}_error")]
    table.writerow([*places, "seconds", "phase", "load", "entrainment", *of_figures])
    for life in all_lives:
        place = [life.place.given.get(name, "") for name in places]
        columns = [
            values_of.get(name, np.full(len(life.seconds), np.nan))
            for name in names
            for values_of in (life.figures, life.errors)
        ]
        phases = np.full(len(life.seconds), np.nan) if life.phases is None else life.phases
        for values in zip(life.seconds, phases, life.load, life.entrainment, *columns, strict=True):
            table.writerow(
                [*place, *("" if np.isnan(value) else f"{value:.8g}" for value in values)]
            )
    return text.getvalue()
