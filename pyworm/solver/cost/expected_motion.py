"""Expected work of the transient solves of a life: its time steps are those of its time grid, counted."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

from pyworm.planning.effects.squeeze import SQUEEZE
from pyworm.planning.expected_work import solves_of_life
from pyworm.planning.model import Model
from pyworm.planning.plan import Plan
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.transient.time_grid import TimeGrid, time_grid_of
from pyworm.solver.transient.time_steps import FIRST_TRANSITS, places_of
from pyworm.solver.transient.transient import (
    MAX_ALONE_TRANSITS,
    MIN_SOLVES,
    Part,
    begin_of_further,
    part_at,
    recent,
)

FURTHER = 0.17, 0.13
"""Chances that a contact has one, and two, more transient solves than its accuracy asks for, of those that
are made whatever they cost (`MIN_SOLVES`): 4 and 3 of 24 phases of worm gear sets at 10 % had (`tests/hard`,
drives 0 and 3 of seed 98001, 1 of 98002, 0 and 1 of 99002). One in the first transit of a life that begins
under load (`FIRST_TRANSITS`) has one."""


@dataclass(frozen=True)
class TimeSteps:
    """Time steps on one grid."""

    nodes: int
    """Number of nodes of the grid."""
    coarse: int
    """Number of those of the first transient solve, on which the heat that surfaces remember is found."""
    count: int
    """Number of time steps."""


@dataclass(frozen=True)
class Motion:
    """Expected transient solves of the life of one contact."""

    model: Model
    """What its life simulates: effects that any of its contacts calls for."""
    up_to_present: tuple[TimeSteps, ...]
    """Time steps up to its own time."""
    further: tuple[tuple[float, tuple[TimeSteps, ...]], ...]
    """Chance and time steps of each more solve, for it alone; empty where there is none to be had."""
    shared: tuple[TimeSteps, ...]
    """Those of the whole part of its life, which serve contacts of other times as well."""
    part: Part | None
    """That part; None where the contact shares it with none."""


def motion(
    scene: Scene | LineScene, plan: Plan, time_grid: TimeGrid | None = None
) -> Motion | None:
    """Expected transient solves of a contact; None of a steady film and where none can begin.

    The time grid of its whole life costs as much to find as several plans, and is passed if known.
    """
    if SQUEEZE.name not in plan.on:
        return None
    past = recent(scene)
    lone = past is not scene.past
    if time_grid is None or lone:
        time_grid = time_grid_if_any(scene, plan)
    if time_grid is None:
        return None
    try:
        part = part_at(time_grid, past.seconds)
    except ValueError:  # no load at present
        return None
    begin = part_at(time_grid, past.seconds, MAX_ALONE_TRANSITS).begin
    solves, place = solves_of_life(plan.accuracy), time_grid.transits(past.seconds)
    last = min(part.last, time_grid.transits(time_grid.end))
    return Motion(
        time_grid.plan.model,
        _time_steps(time_grid, range(solves), begin, place),
        tuple(_further(time_grid, past.seconds, solves)),
        _time_steps(time_grid, range(solves), part.begin, last),
        None if lone else part,
    )


def _further(
    time_grid: TimeGrid, seconds: float, solves: int
) -> Iterator[tuple[float, tuple[TimeSteps, ...]]]:
    """Chance and time steps of each more solve for a contact at a time [s], after the usual ones."""
    place = time_grid.transits(seconds)
    under_load = time_grid.approach is None and place < FIRST_TRANSITS
    for number, chance in enumerate(FURTHER, solves):
        begin = begin_of_further(time_grid, seconds, number)
        if begin is None or (number > solves and number >= MIN_SOLVES):
            return
        steps = _time_steps(time_grid, range(number, number + 1), begin, place)
        yield 1.0 if under_load and number == solves else chance, steps


def time_grid_if_any(scene: Scene | LineScene, plan: Plan) -> TimeGrid | None:
    """The time grid of the life of a contact that is solved; None where it carries no load in motion."""
    try:
        return time_grid_of(recent(scene).life, plan)
    except ValueError:  # the reason that the solve will give
        return None


def _time_steps(
    time_grid: TimeGrid, refinements: range, begin: float, last: float
) -> tuple[TimeSteps, ...]:
    """Time steps of several transient solves between two places of a life [transits], by their grids."""
    counts = Counter(
        (on, time_grid.come_together(time_grid.time_at(place)))
        for refinement in refinements
        for on, place in places_of(time_grid, refinement, begin, last)
    )
    grids = {True: time_grid.grid, False: time_grid.grid_of_contact}
    return tuple(
        TimeSteps(
            grids[together](time_grid.begin, on).nodes,
            grids[together](time_grid.begin, 0).nodes,
            count,
        )
        for (on, together), count in counts.items()
    )
