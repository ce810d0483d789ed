"""Films and heat up to one time of a transient solve, from which one of half the spacing goes on."""

from collections.abc import Mapping
from dataclasses import astuple, dataclass
from itertools import count, takewhile

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.planning.grid import Grid
from pyworm.solver.level import InitialGuess
from pyworm.solver.transient.heat_memory import HeatedTimeLevel
from pyworm.solver.transient.time_level import TimeLevel
from pyworm.solver.transient.time_steps import Step


@dataclass(frozen=True)
class Restart:
    """Films and heat up to one time of a transient solve of a point contact."""

    step: Step
    """The time, and the grid."""
    before: tuple[TimeLevel, ...]
    """Films up to that time, the latest first."""
    heat: tuple[HeatedTimeLevel, ...]
    """Heat of the surfaces up to it as far as it is remembered, the latest first."""
    held: bool
    """Whether the separation of the surfaces is given, rather than their load."""


def restart_arrays(restart: Restart) -> dict[str, Array]:
    """A restart as arrays by names, from which `restart_from` makes it again."""
    step = restart.step
    arrays = {"restart": np.array([step.seconds, step.refinement, restart.held])}
    for number, film in enumerate(restart.before):
        state = film.state
        arrays[f"film {number}"] = np.array([film.seconds, state.rigid_film, film.limited])
        fields = {
            "content": film.content,
            "pressure": state.pressure,
            "oil": state.oil,
            "temperature": state.rise,
            "rise": film.rise,
        }
        arrays |= {f"{name} {number}": field for name, field in fields.items() if field is not None}
    for number, heated in enumerate(restart.heat):
        arrays[f"heat {number}"] = np.array([heated.seconds, *astuple(heated.grid)])
        arrays[f"flux {number}"] = heated.flux
        arrays[f"velocities {number}"] = np.array(heated.velocities)
    return arrays


def restart_from(arrays: Mapping[str, Array]) -> Restart:
    """A restart from `restart_arrays`."""
    seconds, refinement, held = arrays["restart"].tolist()
    return Restart(
        Step(seconds, int(refinement)),
        tuple(_film(arrays, number) for number in _numbers(arrays, "film")),
        tuple(_heated(arrays, number) for number in _numbers(arrays, "heat")),
        bool(held),
    )


def _numbers(arrays: Mapping[str, Array], name: str) -> list[int]:
    """Numbers from zero on under which arrays have a name."""
    return list(takewhile(lambda number: f"{name} {number}" in arrays, count()))


def _film(arrays: Mapping[str, Array], number: int) -> TimeLevel:
    seconds, rigid_film, limited = arrays[f"film {number}"].tolist()
    temperature, oil = (arrays.get(f"{name} {number}") for name in ("temperature", "oil"))
    return TimeLevel(
        seconds,
        arrays[f"content {number}"],
        InitialGuess(arrays[f"pressure {number}"], rigid_film, temperature, oil),
        arrays.get(f"rise {number}"),
        bool(limited),
    )


def _heated(arrays: Mapping[str, Array], number: int) -> HeatedTimeLevel:
    seconds, west, south, dx, dy, columns, rows = arrays[f"heat {number}"].tolist()
    velocities = tuple(map(tuple, arrays[f"velocities {number}"].tolist()))
    grid = Grid(west, south, dx, dy, int(columns), int(rows))
    return HeatedTimeLevel(seconds, grid, arrays[f"flux {number}"], velocities)
