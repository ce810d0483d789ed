"""One transient solve through a part of a contact's life.

It begins with a steady film, or where the surfaces are still apart with the oil that fills their gap. The
Reynolds equation with d(rho h)/dt is integrated by backward differences of variable step (Hairer, Norsett
and Wanner 1993, section III.5; `differences.backward_weights`) on a grid that moves with the contact. The
films of all instants of that part, and the rates of change that films on other grids take, follow from it.
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from pyworm import kernel
from pyworm.formulas.arrays import Array
from pyworm.io.present import present
from pyworm.kernel.core import NO_MEMORY, NO_SENSE, NOT_FINITE, KernelError
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.plan import first_grids_of
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.contact import UNUSABLE_START_RESIDUAL, ContactSolver
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.level import InitialGuess, Level
from pyworm.solver.memory import shortage
from pyworm.solver.newton import iterate, newton_step
from pyworm.solver.transient.backward_term import BackwardTerm
from pyworm.solver.transient.differences import backward_weights
from pyworm.solver.transient.heat_memory import (
    HeatedTimeLevel,
    residual_rise,
    velocities_at_origin,
)
from pyworm.solver.transient.moving_grid import (
    at_places,
    each_at_places,
    means_about,
    seen_from,
    slopes,
)
from pyworm.solver.transient.time_grid import TimeGrid
from pyworm.solver.transient.time_level import TimeLevel, content_of, extrapolated, time_level_of
from pyworm.solver.transient.time_records import TimeRecord, time_record
from pyworm.solver.transient.time_steps import Step, steps_of

EARLIER_FILMS = 3
"""Films before an instant from which its rate of change follows."""

TOLERANCE = 0.06
"""Residual of the films over the square of the time step in transits: half the step halves what Newton's
iteration leaves in a rate of change."""

TOLERANCE_RATIO_WITHOUT_APPROACH = 0.1
"""Tolerance of other courses over that where surfaces come together.

A film with a given rate of change sums up along the flow what that is off by, and the residual is a share of
the flow far out, where gaps are tens of films high. Under a load that rises fourfold and falls back within a
transit (M = 1000) such films were off by 5 % with the whole tolerance, by 0.5 % with a tenth, at a fifth more
time. Where surfaces come together films are thick for long, and tell no difference beyond their bars: up to
phase 0.3 the first solve of `cases/zi_drive.toml` moves by 6 %."""

TEMPERATURE_CHANGE = 1e-2
"""Last change of their temperatures over the largest rise. The heat of the instants is steady and keeps no
errors; in a rate of change they are divided by a time step, but the oil follows within microseconds."""

REST_PRESSURE = 1.0
"""Pressure of oil at rest [Pa], by which the velocities of surfaces are weighted in their conduction."""

MAX_TRANSIENT_RESIDUAL = 1e-2
"""Residual above which the film of an instant is lost."""

MAX_TEMPERATURE_RESIDUAL = 0.1
"""Largest residual of the temperatures of a film that is found. Where films are thick, as surfaces come
together and part, one node's may swing by some per cent of the largest rise from step to step, while flow and
load balance to the last digit."""

MEMORY_TRANSITS = 2.0
"""Transits after which films no longer depend on how the life began."""

MOST_STEPS, TRIAL_STEPS = 15, 4
"""Largest number of Newton steps of an instant whose film begins with the extrapolated ones, and the number
after which its residual makes sense, or it begins with the steady film: steps in a lost film cost most."""

EACH_TRIED = 4
"""Number of steps from each of which a solve is tried to begin with a steady film; beyond, each is twice as
far: a contact without steady films costs a few solves of them, not one a step."""

MOST_HALVINGS = 4
"""Largest number of halvings of a time step whose film is not found."""


class NoFilmError(Exception):
    """No converged film at some time; the message gives the time and the reason."""


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

    def on(self, grid: Grid | LineGrid) -> tuple[float, Array]:
        """Implicit [1/s] and explicit part [m/s] at nodes of a grid, a `solver.level.TransientTerm`."""
        return 0.0, means_about(self.grid, self.rate, grid)

    def remembered(self, grid: Grid | LineGrid) -> Array | None:
        """What both surfaces are warmer by at nodes of a grid [K]."""
        return None if self.rise is None else each_at_places(self.grid, self.rise, grid)

    def stored(self, grid: Grid | LineGrid) -> kernel.HeatStorage | None:
        """Rates of change of the oil's temperature and pressure at nodes of a grid."""
        if self.warming is None:
            return None
        warming = each_at_places(self.grid, self.warming, grid)
        pressing = present(self.pressing, "rate of change of the pressure")
        return kernel.HeatStorage(warming, at_places(self.grid, pressing, grid))


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


def integrate_in_time(
    time_grid: TimeGrid,
    refinement: int,
    begin: float,
    wanted: Sequence[float],
    until: float = 0.0,
) -> TimeIntegration:
    """Integrate a contact's film in time.

    Args:
        refinement: Halvings of the spacing and of the time step.
        begin: Where it begins, with a steady film [transits].
        wanted: Times at which the rate of change is wanted [s], later than that.
        until: Time up to which the films are wanted, where that is later than these [s].

    Raises:
        NoFilmError: No film was found from which to begin.
    """
    _require_memory(time_grid, refinement)
    asked = steps_of(time_grid, refinement, begin, max(*wanted, until))
    return _resumed(time_grid, asked, wanted, _from_first_touch(time_grid, asked, wanted))


def _from_first_touch(
    time_grid: TimeGrid, asked: Sequence[Step], wanted: Sequence[float]
) -> TimeIntegration:
    """The films of some steps; begun at the first touch where the approach before it loses them."""
    later = [step for step in asked if step.seconds >= time_grid.life.touched]
    if len(later) == len(asked):
        return _through(time_grid, asked, wanted)
    try:
        found = _through(time_grid, asked, wanted)
    except NoFilmError:
        found = None
    if found is not None and (len(found.rates) == len(wanted) or _long_after(time_grid, found)):
        return found
    try:
        again = _through(time_grid, later, wanted)
    except NoFilmError:
        if found is None:
            raise
        return found
    return again if found is None or len(again.rates) > len(found.rates) else found


def _resumed(
    time_grid: TimeGrid, asked: Sequence[Step], wanted: Sequence[float], found: TimeIntegration
) -> TimeIntegration:
    """What was found, and where films were lost those of a steady beginning after that.

    They are kept from `MEMORY_TRANSITS` after it, when they no longer depend on it.
    """
    last = found.records[-1].seconds
    left = [step for step in asked if step.seconds > last][1:]
    if found.failure is None or not left:
        return found
    first_place = time_grid.place(left[0].seconds) + MEMORY_TRANSITS
    later = [seconds for seconds in wanted if time_grid.place(seconds) >= first_place]
    if not later:
        return found
    try:
        again = _through(time_grid, left, later)
    except NoFilmError:
        return found
    if again.rates:
        again = _resumed(time_grid, left, later, again)
    first_place = time_grid.place(again.records[0].seconds) + MEMORY_TRANSITS
    kept = [seconds for seconds in again.rates if time_grid.place(seconds) >= first_place]
    records = [record for record in again.records if time_grid.place(record.seconds) >= first_place]
    return replace(
        found,
        rates=found.rates | {seconds: again.rates[seconds] for seconds in kept},
        rigid_films=found.rigid_films | {seconds: again.rigid_films[seconds] for seconds in kept},
        records=(*found.records, *records),
        newton_steps=found.newton_steps + again.newton_steps,
    )


def _long_after(time_grid: TimeGrid, found: TimeIntegration) -> bool:
    """Whether films were found for so long after the first touch that another beginning changes nothing."""
    return _since_touch(time_grid, found.records[-1].seconds) > MEMORY_TRANSITS


def _since_touch(time_grid: TimeGrid, seconds: float) -> float:
    """Transits from the first touch to a time."""
    return time_grid.transits(seconds) - time_grid.transits(time_grid.life.touched)


def _through(
    time_grid: TimeGrid, asked: Sequence[Step], wanted: Sequence[float]
) -> TimeIntegration:
    """The films of some steps, of which those of the finest grid are kept; as of `integrate_in_time`."""
    refinement = asked[-1].refinement
    finest = [step.seconds for step in asked if step.refinement == refinement]
    framed = set(finest[:: 2**refinement])
    steps, level, before, taken_of_all = _begun(time_grid, asked, min(wanted))
    turns = _turns([step.seconds for step in steps if step.refinement == refinement], wanted)
    rates: dict[float, RateOfChange] = {}
    rigid_films: dict[float, float] = {}
    heat: list[HeatedTimeLevel] = []
    records, failure, held = [], None, True
    on = steps[0]
    for step in steps:
        before, heat = _led_on(time_grid, on, step, before, heat)
        on = step
        try:
            if before:
                level, before, heat, taken = _reached(time_grid, step, before, heat, held)
                taken_of_all += taken
                if held and level.carried() > time_grid.life.touch:
                    held = False
                    level, before, heat, taken = _reached(time_grid, step, before, heat, held)
                    taken_of_all += taken
            level = present(level, "the first film")
            now = time_level_of(level, step.seconds)
            heat = [*_heated(level, step.seconds), *heat]
            before = [now, *before[: EARLIER_FILMS - 1]]
            if on.refinement < refinement:
                continue
            frame = time_grid.grid_of_contact(step.seconds, 0) if step.seconds in framed else None
            records.append(time_record(level, step.seconds, frame))
            for time in turns.get(step.seconds, ()):
                then, known, taken = level, before, 0
                if time > step.seconds:
                    turn = Step(time, refinement)
                    past = _led_on(time_grid, step, turn, before, heat)
                    then, known, _, taken = _reached(time_grid, turn, *past, held)
                    known = [time_level_of(then, time), *known]
                taken_of_all += taken
                rates[time] = replace(_rate_of(time_grid, then, known), limited=_limited(then))
                rigid_films[time] = then.film.rigid_film
        except NoFilmError as error:
            failure = str(error)
            break
    if not records:
        raise NoFilmError(failure)
    return TimeIntegration(rates, rigid_films, tuple(records), taken_of_all, failure)


def _led_on(
    time_grid: TimeGrid,
    last: Step,
    step: Step,
    before: list[TimeLevel],
    heat: list[HeatedTimeLevel],
) -> tuple[list[TimeLevel], list[HeatedTimeLevel]]:
    """Films and heat up to a last step on the kind of grid of the next."""
    if step.refinement > last.refinement:
        before, heat = [film.finer() for film in before], [film.finer() for film in heat]
    if time_grid.come_together(last.seconds) and not time_grid.come_together(step.seconds):
        grids = time_grid.grid, time_grid.grid_of_contact
        large, small = (grid(last.seconds, step.refinement) for grid in grids)
        if isinstance(large, Grid) and isinstance(small, Grid):  # lines do not come together
            window = large.window_of(small)
            before, heat = (
                [film.finer(window) for film in before],
                [film.finer(window) for film in heat],
            )
    return before, heat


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
    if time_grid.life.at(steps[0].seconds).separation is not None:
        return steps[1:], None, [_at_rest(time_grid, steps[0])], 0
    for number in _beginnings([step.seconds for step in steps], wanted):
        try:
            level, taken = steady_level(time_grid, steps[number])
        except NoFilmError:
            if steps[number].seconds >= wanted:
                raise
        else:
            return steps[number:], level, [], taken
    raise NoFilmError(_failed(wanted))


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


def steady_level(time_grid: TimeGrid, step: Step) -> tuple[Level, int]:
    """The steady film at a time on the moving grid, and its Newton steps there."""
    seconds = step.seconds
    contact = contact_at(time_grid, seconds)
    grid = time_grid.grid(seconds, step.refinement)
    with _told(seconds):
        level = _beside(contact, time_grid, grid, SOLVERS[type(contact)](contact, time_grid.plan))
        taken = len(iterate(level, *_tolerances(time_grid, step)))
    return _sound(level, seconds), taken


Reached = tuple[Level, list[TimeLevel], list[HeatedTimeLevel], int]
"""A film, films and heat before it, and the Newton steps to it."""


def _reached(
    time_grid: TimeGrid,
    step: Step,
    before: list[TimeLevel],
    heat: list[HeatedTimeLevel],
    held: bool,
) -> Reached:
    """The film at a time.

    Where its rate of change is limited under pressure the time step is halved once: the end of the contact
    moves over the grid faster than the step resolves.

    NoFilmError if no film was found after `MOST_HALVINGS`.
    """
    whole = _found(time_grid, step, before, heat, held)
    level, known, _, taken = whole
    if not _limited(level) or known is not before:
        return whole
    try:
        level, before, heat, further = _in_halves(time_grid, step, before, heat, held, 1)
    except NoFilmError:
        return whole
    return level, before, heat, taken + further


def _found(
    time_grid: TimeGrid,
    step: Step,
    before: list[TimeLevel],
    heat: list[HeatedTimeLevel],
    held: bool,
    halvings: int = 0,
) -> Reached:
    """The film at a time, from the last film alone by halves, and halves of these, where none is found.

    A load that jumps, or an edge that enters the contact, leaves films from which neither a first guess nor a
    difference of higher order follows.
    """
    try:
        level, taken = _onward(time_grid, step, before, heat, held)
    except NoFilmError:
        if halvings == MOST_HALVINGS:
            raise
        return _in_halves(time_grid, step, before[:1], heat, held, halvings + 1)
    return level, before, heat, taken


def _in_halves(
    time_grid: TimeGrid,
    step: Step,
    before: list[TimeLevel],
    heat: list[HeatedTimeLevel],
    held: bool,
    halvings: int,
) -> Reached:
    """The film at a time by the one in the middle of the step.

    Films before it are on the grid of the contact already: the middle is no earlier than where it begins.
    """
    seconds, approach = (before[0].seconds + step.seconds) / 2, time_grid.approach
    if approach is not None and not time_grid.come_together(step.seconds):
        seconds = max(seconds, approach.until)
    if not seconds < step.seconds:
        raise NoFilmError(_failed(step.seconds))
    middle = Step(seconds, step.refinement)
    level, before, heat, first = _found(time_grid, middle, before, heat, held, halvings)
    before = [time_level_of(level, middle.seconds), *before[: EARLIER_FILMS - 1]]
    heat = [*_heated(level, middle.seconds), *heat]
    level, before, heat, second = _found(time_grid, step, before, heat, held, halvings)
    return level, before, heat, first + second


def _onward(
    time_grid: TimeGrid,
    step: Step,
    before: Sequence[TimeLevel],
    heat: Sequence[HeatedTimeLevel],
    held: bool,
) -> tuple[Level, int]:
    """The film at a time, from those before and their heat, the latest first, and its Newton steps.

    Where a separation is given but its surfaces are no longer held there the load is given in its place.
    """
    seconds = step.seconds
    contact, mesh = contact_at(time_grid, seconds), time_grid.mesh(seconds)
    if not held:
        contact = replace(contact, separation=None)
    grid = time_grid.grid(seconds, step.refinement)
    used = _differenced(time_grid, seconds, before)
    rise = None
    if heat:
        rise = residual_rise(heat, contact, grid, time_grid.grid(seconds, 0), seconds, mesh.turning)
    term = BackwardTerm(seconds, used, mesh.divergence, rise)
    solver = SOLVERS[type(contact)](seen_from(contact, mesh), time_grid.plan, term)
    tolerances = _tolerances(time_grid, step)
    with _told(seconds):
        level = _begun_from(time_grid, solver, grid, contact, before, seconds)
        taken = _followed(level, term, tolerances)
        if level.film.balance.residual <= UNUSABLE_START_RESIDUAL:
            taken += len(iterate(level, *tolerances, most=MOST_STEPS - TRIAL_STEPS))
        if contact.separation is None and not level.film.balance.within(
            MAX_TRANSIENT_RESIDUAL, MAX_TEMPERATURE_RESIDUAL
        ):
            level = _beside(contact, time_grid, grid, solver)
            taken += _followed(level, term, tolerances)
            taken += len(iterate(level, *tolerances))
    return _sound(level, seconds), taken


def _followed(level: Level, term: BackwardTerm, tolerances: tuple[float, float]) -> int:
    """First Newton steps of a film, in which its rate of change is limited; their number."""
    # one step at least: a film that is only extrapolated would follow no equation until it is far from it
    _limit(level, term)
    newton_step(level)
    taken = 1
    for most in (1, TRIAL_STEPS - 2):
        _limit(level, term)
        taken += len(iterate(level, *tolerances, most=most))
    return taken


def _limit(level: Level, term: BackwardTerm) -> None:
    """Limit the rate of change of a point's film in its present state; lines take five times the steps."""
    if isinstance(level.grid, Grid) and term.limit(content_of(level)):
        level.film.set_transient_term(*term.on(level.grid))
        level.film.restart()


def _limited(level: Level) -> bool:
    """Whether the rate of change of a film is limited anywhere under pressure."""
    term = level.transient_term
    return isinstance(term, BackwardTerm) and bool(np.any(term.limited[level.film.pressure > 0]))


def _begun_from(
    time_grid: TimeGrid,
    solver: ContactSolver,
    grid: Grid | LineGrid,
    contact: Scene | LineScene,
    before: Sequence[TimeLevel],
    seconds: float,
) -> Level:
    """The level of a time that begins with the films before, the latest first.

    Where an edge moves through the contact its pressure moves over the nodes, and no film follows from
    extrapolated pressures; the last film, or its pressure as that of the oil, is nearer then. Soon after
    surfaces came together a film that does not follow asks for shorter time steps instead.
    """
    latest, guesses = before[0].state, [extrapolated(before, seconds)]
    if time_grid.approach is None or _since_touch(time_grid, seconds) > MEMORY_TRANSITS:
        guesses += [latest, replace(latest, oil=None)]
    levels: list[Level] = []
    for guess in guesses:
        if contact.separation is not None:
            guess = replace(guess, rigid_film=contact.separation)
        levels.append(solver.on_grid(grid, guess))
        if levels[-1].film.balance.residual <= UNUSABLE_START_RESIDUAL:
            break
    return min(levels, key=lambda level: level.film.balance.residual)


def _differenced(
    time_grid: TimeGrid, seconds: float, before: Sequence[TimeLevel]
) -> Sequence[TimeLevel]:
    """Films from which the rate of change at a time follows: the last alone while films form (`FORMING`)."""
    return before[:1] if time_grid.come_together(seconds) else before


def contact_at(time_grid: TimeGrid, seconds: float) -> Scene | LineScene:
    """The contact at a time with the effects of the plan, and no past."""
    return time_grid.plan.simplified(replace(time_grid.life.at(seconds), past=None))


def _tolerances(time_grid: TimeGrid, step: Step) -> tuple[float, float]:
    """Residual and warming to which films are solved."""
    share = 1.0 if time_grid.approach is not None else TOLERANCE_RATIO_WITHOUT_APPROACH
    return share * TOLERANCE * time_grid.step(step.refinement) ** 2, TEMPERATURE_CHANGE


def _beside(
    contact: Scene | LineScene, time_grid: TimeGrid, grid: Grid | LineGrid, solver: ContactSolver
) -> Level:
    """A level of a solver on a grid that begins with the steady film on the contact's own first grids."""
    steady = SOLVERS[type(contact)](contact, time_grid.plan)
    level, _ = steady.begin(first_grids_of(contact, time_grid.plan))
    guess = _moved(level, grid)
    beside: Level = solver.on_grid(grid, guess)
    if level.film.rough and not beside.film.balance.residual <= UNUSABLE_START_RESIDUAL:
        # asperities multiply what the film of an interpolated pressure is off by
        beside = solver.on_grid(grid, replace(guess, oil=None))
    return beside


def _sound(level: Level, seconds: float) -> Level:
    """The level, if its film is found, its temperatures up to a share of the largest rise."""
    if not level.film.balance.within(MAX_TRANSIENT_RESIDUAL, MAX_TEMPERATURE_RESIDUAL):
        raise NoFilmError(_failed(seconds))
    return level


@contextmanager
def _told(seconds: float) -> Iterator[None]:
    """Tell at which time the kernel gave up a film."""
    try:
        yield
    except ValueError as error:  # surfaces that stand still have no steady film
        raise NoFilmError(f"{_failed(seconds)}: {error}") from error
    except KernelError as error:
        if error.status not in (NO_SENSE, NOT_FINITE, NO_MEMORY):
            raise
        raise NoFilmError(f"{_failed(seconds)}: {error}") from error


def _moved(level: Level, grid: Grid | LineGrid) -> InitialGuess:
    """The film of a level as an initial guess on another grid in the same axes."""
    state = level.state()

    def there(field: Array) -> Array:
        return at_places(level.grid, field, grid)

    rise = None if state.rise is None else each_at_places(level.grid, state.rise, grid)
    pressure, oil = (
        np.maximum(there(values), 0.0)
        for values in (state.pressure, present(state.oil, "pressure of the oil"))
    )
    return InitialGuess(pressure, level.rigid_film_on(grid, pressure), rise, oil)


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

    storing = _prompt(level, time_levels[0].seconds - time_levels[1].seconds)
    levels = (
        at_place(*fields)
        for fields in zip(
            *(np.moveaxis(field, -1, 0) for field in (changing("rise"), rise)), strict=True
        )
    )
    warming = np.stack([storing * field for field in levels], axis=-1)
    pressing = storing * at_place(changing("oil"), oil)
    return RateOfChange(grid, rate, now.rise, warming, pressing)


def _prompt(level: Level, step: float) -> Array:
    """How promptly the oil at the nodes follows its heat, 1 where it does in far less than a time step [s].

    Between walls it is late by rho c h^2 / (10 k), the second term of a slow change. Where that is not short
    against the step, far from the contact, what Newton's iteration left in two temperatures counts for more
    than their difference: a roller's film, whose load hardly changes, lost half its thickness by it.
    """
    heat, film = level.scene.oil.thermal, level.film.thickness()
    late = level.scene.oil.density.rho0 * heat.specific_heat * film**2 / (10 * heat.conductivity)
    return 1 / (1 + (late / step) ** 2)


def _heated(level: Level, seconds: float) -> list[HeatedTimeLevel]:
    """Heat of a level's surfaces, where it is simulated."""
    if not level.film.heated:
        return []
    flux = level.film.heat_fields().flux
    return [HeatedTimeLevel(seconds, level.grid, flux, velocities_at_origin(level.scene))]


def _failed(seconds: float) -> str:
    return f"the transient solve found no converged film {seconds:.3g} s after the first touch"
