"""One transient solve through a part of a contact's life.

It begins with a steady film, or where the surfaces are still apart with the oil that fills their gap. The
Reynolds equation with d(rho h)/dt is integrated by backward differences of variable step (Hairer, Norsett
and Wanner 1993, section III.5; `differences.backward_weights`) on a grid that moves with the contact. The
films of all instants of that part, and the rates of change that films on other grids take, follow from it.
"""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import pairwise
from math import inf

import numpy as np

from pyworm import kernel
from pyworm.formulas.arrays import Array
from pyworm.io.present import present
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.solver.level import InitialGuess, Level
from pyworm.solver.memory import shortage
from pyworm.solver.transient.differences import backward_weights
from pyworm.solver.transient.film_series import FilmSeries
from pyworm.solver.transient.moving_grid import (
    at_places,
    each_at_places,
    means_about,
    reaches_to,
    slopes,
)
from pyworm.solver.transient.next_film import (
    MEMORY_TRANSITS,
    NoFilmError,
    NoLoadError,
    contact_at,
    lost_at,
    prompt,
    since_touch,
    steady_level,
)
from pyworm.solver.transient.restart import Restart
from pyworm.solver.transient.time_grid import TimeGrid
from pyworm.solver.transient.time_level import TimeLevel, is_limited
from pyworm.solver.transient.time_records import TimeRecord, time_record
from pyworm.solver.transient.time_steps import Step, restart_place, steps_of, steps_on

REST_PRESSURE = 1.0
"""Pressure of oil at rest [Pa], by which the velocities of surfaces are weighted in their conduction."""

EACH_TRIED = 4
"""Number of steps from each of which a solve is tried to begin with a steady film; beyond, each is twice as
far: a contact without steady films costs a few solves of them, not one a step."""


MEMORY_SHARE = 0.75
"""Share of the way to the first wanted time after which films no longer depend on those from which a solve
goes on."""


@dataclass(frozen=True)
class RateOfChange:
    """d(rho h)/dt of a film at one time at places that move with the contact point, in its own axes."""

    grid: Grid | LineGrid
    """The grid on which it was found."""
    rate: Array
    """Rate of change at its nodes [m/s]."""
    rise: Array | None = None
    """What both surfaces are warmer by than in steady conduction (`heat_memory`), body along the last axis
    [K]; None where heat is not simulated."""
    warming: Array | None = None
    """Rate of change of the oil's temperature, level along the last axis [K/s]; None likewise."""
    pressing: Array | None = None
    """Rate of change of the oil's pressure [Pa/s]; None likewise."""
    limited: bool = False
    """Whether it is limited anywhere in the contact (`backward_term`)."""
    content: Array | None = None
    """Oil of the film itself at its nodes, as of `time_level.TimeLevel` [m]; None where it is not known."""

    def on(self, grid: Grid | LineGrid) -> tuple[float, Array]:
        """Implicit [1/s] and explicit part [m/s] at nodes of a grid, a `solver.level.TransientTerm`."""
        return 0.0, means_about(self.grid, self.rate, grid)

    def remembered(self, grid: Grid | LineGrid) -> Array | None:
        """What both surfaces are warmer by at nodes of a grid [K]."""
        return None if self.rise is None else each_at_places(self.grid, self.rise, grid)

    def stored(self, grid: Grid | LineGrid) -> kernel.HeatStorage | None:
        """Rates of change of the oil's temperature and pressure at nodes of a grid.

        Beyond their own they are zero: gaps are wide there, and the last rates would heat them without end.
        """
        if self.warming is None:
            return None
        known = reaches_to(self.grid, grid)
        warming = known[..., np.newaxis] * each_at_places(self.grid, self.warming, grid)
        pressing = present(self.pressing, "rate of change of the pressure")
        return kernel.HeatStorage(warming, known * at_places(self.grid, pressing, grid))


@dataclass(frozen=True)
class TimeIntegration:
    """What a transient solve through a part of a life found."""

    rates: dict[float, RateOfChange]
    """Time [s] -> `RateOfChange` there; without times to which no films lead."""
    rigid_films: dict[float, float]
    """Time [s] -> rigid film there [m], at the times of `rates`."""
    records: tuple[TimeRecord, ...]
    """Figures of the film on the moving grid at each instant, and fields at those of the coarsest solve."""
    newton_steps: int
    """Newton steps of all instants."""
    failure: str | None = None
    """Reason why films of some times are missing, if they are."""
    unloaded: float | None = None
    """Time at which they are missing since surfaces carry no load [s]; None where films were lost."""
    restarts: dict[float, Restart] = field(default_factory=dict)
    """Time -> films from which the next solve goes on to it."""
    memory_end: float = -inf
    """Time from which its films no longer depend on those from which it goes on [s]."""


@dataclass(frozen=True)
class Request:
    """What is asked of a transient solve."""

    wanted: Sequence[float]
    """Times at which the rate of change is wanted [s]."""
    solves_after: int = 0
    """Number of solves that go on from films of this one, each from those of the one before."""
    most_work: float = inf
    """Newton steps times nodes after which it is given up."""

    def at(self, wanted: Sequence[float]) -> "Request":
        """What is asked for other times [s]."""
        return replace(self, wanted=wanted)


def integrate_in_time(
    time_grid: TimeGrid,
    refinement: int,
    begin: float,
    wanted: Sequence[float],
    until: float = 0.0,
    solves_after: int = 0,
    most_work: float = inf,
) -> TimeIntegration:
    """Integrate a contact's film in time.

    Args:
        refinement: Halvings of the spacing and of the time step.
        begin: Where it begins, with a steady film [transits].
        wanted: Times at which the rate of change is wanted [s], later than that.
        until: Time up to which the films are wanted, where that is later than these [s].
        solves_after, most_work: As of `Request`.

    Raises:
        NoFilmError: No film was found from which to begin.
        TooMuchWorkError: It takes more than the largest work.
    """
    _require_memory(time_grid, refinement)
    asked = steps_of(time_grid, refinement, begin, max(*wanted, until))
    return _through_loads(time_grid, asked, Request(wanted, solves_after, most_work))


def integrate_on(
    time_grid: TimeGrid,
    restart: Restart,
    begin: float,
    wanted: Sequence[float],
    solves_after: int = 0,
) -> TimeIntegration:
    """Integrate a contact's film from those of the solve before, with half its spacing and time step.

    Args:
        restart: Films of that solve up to the time from which it goes on.
        begin: Where that solve began [transits].
        wanted, solves_after: As of `integrate_in_time`.

    Raises:
        NoFilmError: No film was found.
    """
    refinement = restart.step.refinement + 1
    _require_memory(time_grid, refinement)
    place = time_grid.place(restart.step.seconds)
    asked = steps_on(time_grid, refinement, begin, place, max(wanted))
    series = FilmSeries(time_grid, restart.step, [*restart.before], [*restart.heat], restart.held)
    found = _along(series, asked, asked[1:], Request(wanted, solves_after))
    first = restart.step.seconds
    return replace(found, memory_end=first + MEMORY_SHARE * (min(wanted) - first))


def _through_loads(time_grid: TimeGrid, asked: Sequence[Step], request: Request) -> TimeIntegration:
    """The films of some steps; those after a time without load where coarse steps before led to it."""
    try:
        found = _from_first_touch(time_grid, asked, request)
    except NoLoadError as reason:
        left = _loaded_after(time_grid, asked, reason.seconds)
        later = [seconds for seconds in request.wanted if left and seconds >= left[0].seconds]
        if not later:
            raise
        return _through_loads(time_grid, left, request.at(later))
    return _resumed(time_grid, asked, request, found)


def _loaded_after(time_grid: TimeGrid, asked: Sequence[Step], seconds: float) -> Sequence[Step]:
    """Those of some steps from the first that carries load again after a time that carries none [s]."""
    for number, step in enumerate(asked):
        if step.seconds > seconds:
            with suppress(NoLoadError):
                contact_at(time_grid, step.seconds)
                return asked[number:]
    return ()


def _from_first_touch(
    time_grid: TimeGrid, asked: Sequence[Step], request: Request
) -> TimeIntegration:
    """The films of some steps; begun at the first touch where the approach before it loses them."""
    later = [step for step in asked if step.seconds >= time_grid.life.touched]
    if len(later) == len(asked):
        return _through(time_grid, asked, request)
    try:
        found = _through(time_grid, asked, request)
    except NoFilmError:
        found = None
    if found is not None and (
        len(found.rates) == len(request.wanted) or _long_after(time_grid, found)
    ):
        return found
    try:
        again = _through(time_grid, later, request)
    except NoFilmError:
        if found is None:
            raise
        return found
    return again if found is None or len(again.rates) > len(found.rates) else found


def _resumed(
    time_grid: TimeGrid,
    asked: Sequence[Step],
    request: Request,
    found: TimeIntegration,
) -> TimeIntegration:
    """What was found, and where films were lost those of a steady beginning after that.

    They are kept from `MEMORY_TRANSITS` after it, when they no longer depend on it; where surfaces carried no
    load in between all are, as in a life that begins under load.
    """
    last = found.records[-1].seconds
    left: Sequence[Step] = [step for step in asked if step.seconds > last][1:]
    memory = MEMORY_TRANSITS
    if found.unloaded is not None:
        left, memory = _loaded_after(time_grid, asked, found.unloaded), 0.0
    if found.failure is None or not left:
        return found
    first_place = time_grid.place(left[0].seconds) + memory
    later = [seconds for seconds in request.wanted if time_grid.place(seconds) >= first_place]
    if not later:
        return found
    try:
        if found.unloaded is not None:
            again = _through_loads(time_grid, left, request.at(later))
        else:
            again = _through(time_grid, left, request.at(later))
            if again.rates:
                again = _resumed(time_grid, left, request.at(later), again)
    except NoFilmError:
        return found
    first_place = time_grid.place(again.records[0].seconds) + memory
    kept = [seconds for seconds in again.rates if time_grid.place(seconds) >= first_place]
    records = [record for record in again.records if time_grid.place(record.seconds) >= first_place]
    return replace(
        found,
        rates=found.rates | {seconds: again.rates[seconds] for seconds in kept},
        rigid_films=found.rigid_films | {seconds: again.rigid_films[seconds] for seconds in kept},
        records=(*found.records, *records),
        newton_steps=found.newton_steps + again.newton_steps,
        restarts=found.restarts | again.restarts,
    )


def _long_after(time_grid: TimeGrid, found: TimeIntegration) -> bool:
    """Whether films were found for so long after the first touch that another beginning changes nothing."""
    return since_touch(time_grid, found.records[-1].seconds) > MEMORY_TRANSITS


def _through(time_grid: TimeGrid, asked: Sequence[Step], request: Request) -> TimeIntegration:
    """The films of some steps, of which those of the finest grid are kept; as of `integrate_in_time`."""
    steps, level, before, taken = _begun(time_grid, asked, min(request.wanted))
    series = FilmSeries(
        time_grid, steps[0], before, level=level, newton_steps=taken, most_work=request.most_work
    )
    return _along(series, asked, steps, request)


def _along(
    series: FilmSeries,
    asked: Sequence[Step],
    steps: Sequence[Step],
    request: Request,
) -> TimeIntegration:
    """The films of some of the steps that were asked for, from those before them."""
    time_grid, refinement = series.time_grid, asked[-1].refinement
    finest = [step.seconds for step in asked if step.refinement == refinement]
    framed = finest[:: 2**refinement]
    known = [seconds for seconds in framed if seconds >= steps[0].seconds]
    marks = _marks(time_grid, known, request.wanted, request.solves_after)
    turns = _turns(
        [step.seconds for step in steps if step.refinement == refinement], request.wanted
    )
    rates: dict[float, RateOfChange] = {}
    rigid_films: dict[float, float] = {}
    restarts: dict[float, Restart] = {}
    records: list[TimeRecord] = []
    reason: NoFilmError | None = None
    unloaded = None
    for step in steps:
        try:
            level = series.reach(step)
            if step.refinement < refinement:
                continue
            frame = time_grid.grid_of_contact(step.seconds, 0) if step.seconds in framed else None
            records.append(time_record(level, step.seconds, frame))
            for time in marks.get(step.seconds, ()):
                restarts[time] = series.restart()
            for time in turns.get(step.seconds, ()):
                then, levels = series.turned(time)
                rate = _rate_of(time_grid, then, levels)
                rates[time] = replace(rate, limited=is_limited(then), content=levels[0].content)
                rigid_films[time] = then.film.rigid_film
        except NoLoadError as error:
            reason, unloaded = error, error.seconds
            break
        except NoFilmError as error:
            reason = error
            break
    if not records:
        raise present(reason, "reason")
    return TimeIntegration(
        rates,
        rigid_films,
        tuple(records),
        series.newton_steps,
        None if reason is None else str(reason),
        unloaded,
        restarts,
    )


def _marks(
    time_grid: TimeGrid, step_times: Sequence[float], wanted: Sequence[float], solves_after: int
) -> dict[float, list[float]]:
    """Wanted times by the instant from whose films the next solve begins for them."""
    marks: dict[float, list[float]] = {}
    if solves_after == 0:
        return marks
    places = [time_grid.place(seconds) for seconds in step_times]
    for time in wanted:
        place = restart_place(time_grid, time, solves_after)
        if place is not None and places[0] <= place:
            number = int(np.searchsorted(places, place, side="right")) - 1
            marks.setdefault(step_times[number], []).append(time)
    return marks


def _turns(step_times: Sequence[float], wanted: Sequence[float]) -> dict[float, list[float]]:
    """Wanted times by the instant from which a step of their own leads to them; none before the first.

    It is half a step long at least, if it can be: shorter ones make much of what Newton's iteration left.
    """
    turns: dict[float, list[float]] = {}
    halfway = [(earlier + later) / 2 for earlier, later in pairwise(step_times)]
    for time in wanted:
        if time < step_times[0]:
            continue
        number = max(int(np.searchsorted(halfway, time, side="right")) - 1, 0)
        turns.setdefault(step_times[number], []).append(time)
    return turns


def _require_memory(time_grid: TimeGrid, refinement: int) -> None:
    """NoFilmError where memory will not hold the grid."""
    short = shortage(time_grid.grid(time_grid.begin, refinement), time_grid.plan.model)
    if short is not None:
        raise NoFilmError(short)


def _begun(
    time_grid: TimeGrid, steps: Sequence[Step], wanted: float
) -> tuple[Sequence[Step], Level | None, list[TimeLevel], int]:
    """The steps to solve, the film of the first or those before it, and Newton steps taken.

    They begin with the first that has a steady film, or after the first where its surfaces are apart. A tooth
    that is touched at its tip has no steady film yet; NoFilmError where there is none before a wanted time.
    """
    with suppress(NoLoadError):
        if contact_at(time_grid, steps[0].seconds).separation is not None:
            return steps[1:], None, [_at_rest(time_grid, steps[0])], 0
    for number in _beginnings([step.seconds for step in steps], wanted):
        try:
            level, taken = steady_level(time_grid, steps[number])
        except NoFilmError:
            if steps[number].seconds >= wanted:
                raise
        else:
            return steps[number:], level, [], taken
    raise NoFilmError(lost_at(wanted))


def _beginnings(step_times: Sequence[float], wanted: float) -> Iterator[int]:
    """Numbers of the instants at which to begin, in turn: twice as far each, up to the first one wanted."""
    last = next(
        (number for number, seconds in enumerate(step_times) if seconds >= wanted),
        len(step_times) - 1,
    )
    yield from range(min(EACH_TRIED, last))
    number = EACH_TRIED
    while number < last:
        yield number
        number *= 2
    yield last


def _at_rest(time_grid: TimeGrid, step: Step) -> TimeLevel:
    """The oil that fills the gap between surfaces that are apart, hardly under pressure: its density is 1."""
    seconds = step.seconds
    contact, grid = contact_at(time_grid, seconds), time_grid.grid(seconds, step.refinement)
    gap, _ = contact.gap(*grid.mesh())
    separation = present(contact.separation, "separation")
    film = separation + gap
    pressure = np.full(film.shape, REST_PRESSURE)
    return TimeLevel(seconds, film, InitialGuess(pressure, separation, None, pressure))


def _rate_of(time_grid: TimeGrid, level: Level, time_levels: Sequence[TimeLevel]) -> RateOfChange:
    """Rate of change of the film of a time, of which some instants are known, its own first."""
    now, grid, mesh = time_levels[0], level.grid, time_grid.mesh(time_levels[0].seconds)
    if level.transient_term is None:  # a life that begins at that time, with a steady film
        return RateOfChange(grid, np.zeros_like(now.content))
    velocity = mesh(*grid.mesh())

    def at_place(at_node: Array, field: Array) -> Array:
        """Equation 1 of `moving_grid`."""
        parts = zip(velocity, slopes(grid, field), strict=True)
        return at_node - sum(component * slope for component, slope in parts)

    implicit, explicit = level.transient_term.on(grid)
    rate = at_place((implicit - mesh.divergence) * now.content + explicit, now.content)
    warm = [time_level for time_level in time_levels if time_level.state.rise is not None]
    oil, rise = now.state.oil, now.state.rise
    if len(warm) < 2 or oil is None or rise is None:
        return RateOfChange(grid, rate, now.rise)
    coefficients = backward_weights([time_level.seconds for time_level in warm])

    def changing(name: str) -> Array:
        parts = zip(coefficients, warm, strict=True)
        return sum(weight * getattr(time_level.state, name) for weight, time_level in parts)

    storing = prompt(level, time_levels[0].seconds - time_levels[1].seconds)
    levels = (
        at_place(*fields)
        for fields in zip(
            *(np.moveaxis(field, -1, 0) for field in (changing("rise"), rise)), strict=True
        )
    )
    warming = np.stack([storing * field for field in levels], axis=-1)
    pressing = storing * at_place(changing("oil"), oil)
    return RateOfChange(grid, rate, now.rise, warming, pressing)
