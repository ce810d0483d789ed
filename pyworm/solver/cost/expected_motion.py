"""Expected work of the transient solves of a life: its time steps are those of its time grid, counted."""

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import chain

from pyworm.planning.effects.squeeze import SQUEEZE
from pyworm.planning.expected_work import solves_of_life
from pyworm.planning.model import Model
from pyworm.planning.plan import Plan
from pyworm.scene.life import Past
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.transient.time_grid import TimeGrid, time_grid_of
from pyworm.solver.transient.time_steps import (
    FIRST_TRANSITS,
    Step,
    in_stretches,
    restart_place,
    steps_of,
    steps_on,
)
from pyworm.solver.transient.transient import (
    MAX_ALONE_TRANSITS,
    USUAL_SOLVES,
    Part,
    begin_of_further,
    part_at,
    recent,
)

FURTHER = 0.08, 0.06
"""Weights of one, and two, more transient solves than the accuracy asks for, of those that are usual.

Half of the share of contacts that have them, 4 and 3 of 24 phases of worm gear sets at 10 % (`tests/hard`,
drives 0 and 3 of seed 98001, 1 of 98002, 0 and 1 of 99002): most have none, and times are to be within a
factor of two too. One in the first transit of a life that begins under load (`FIRST_TRANSITS`) has one."""


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
class Stretch:
    """A finer transient solve for one contact, through a stretch of its life that others may share."""

    begin: float
    """Where it begins [transits]."""
    end: float
    """The contact's own place [transits]."""
    steps: tuple[TimeSteps, ...]
    """Its time steps."""


@dataclass(frozen=True)
class Motion:
    """Expected transient solves of the life of one contact."""

    model: Model
    """What its life simulates: effects that any of its contacts calls for."""
    up_to_present: tuple[TimeSteps, ...]
    """Time steps up to its own time, of solves that begin with its life."""
    stretches: tuple[Stretch, ...]
    """Finer solves that go on from films of these."""
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
    solves = solves_of_life(plan.accuracy)
    stretches = tuple(_stretches(time_grid, past, begin, solves))
    whole = range(solves - len(stretches))
    return Motion(
        time_grid.plan.model,
        _time_steps(time_grid, whole, begin, past.seconds),
        stretches,
        tuple(_further(time_grid, past.seconds, solves)),
        _time_steps(time_grid, whole, part.begin, time_grid.time_at(part.last)),
        None if lone else part,
    )


def _stretches(time_grid: TimeGrid, past: Past, begin: float, solves: int) -> Iterator[Stretch]:
    """Finer ones of some solves for a contact, of which the first begins at a place [transits]."""
    if past.until is not None or not in_stretches(time_grid):
        return
    for refinement in range(1, solves):
        place = restart_place(time_grid, past.seconds, solves - refinement)
        if place is None or place < begin:
            place, steps = begin, steps_of(time_grid, refinement, begin, past.seconds)
        else:
            steps = steps_on(time_grid, refinement, begin, place, past.seconds)[1:]
        yield Stretch(place, time_grid.place(past.seconds), _by_grid(time_grid, steps))


def _further(
    time_grid: TimeGrid, seconds: float, solves: int
) -> Iterator[tuple[float, tuple[TimeSteps, ...]]]:
    """Chance and time steps of each more solve for a contact at a time [s], after the usual ones."""
    under_load = time_grid.approach is None and time_grid.transits(seconds) < FIRST_TRANSITS
    for number, chance in enumerate(FURTHER, solves):
        begin = begin_of_further(time_grid, seconds, number)
        if begin is None or (number > solves and number >= USUAL_SOLVES):
            return
        steps = _time_steps(time_grid, range(number, number + 1), begin, seconds)
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
    """Time steps of several transient solves from a place [transits] up to a time [s], by their grids."""
    steps = (steps_of(time_grid, refinement, begin, last) for refinement in refinements)
    return _by_grid(time_grid, chain.from_iterable(steps))


def _by_grid(time_grid: TimeGrid, steps: Iterable[Step]) -> tuple[TimeSteps, ...]:
    """Some time steps by their grids."""
    counts = Counter((step.refinement, time_grid.come_together(step.seconds)) for step in steps)
    grids = {True: time_grid.grid, False: time_grid.grid_of_contact}
    return tuple(
        TimeSteps(
            grids[together](time_grid.begin, on).nodes,
            grids[together](time_grid.begin, 0).nodes,
            count,
        )
        for (on, together), count in counts.items()
    )
