"""The film at a time of a transient solve, from those before it.

The Reynolds equation with d(rho h)/dt by backward differences (`backward_term`) is solved on the moving grid
of that time, in time steps that are halved where no film is found or the end of a contact moves too far.
"""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import partial

import numpy as np

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
from pyworm.solver.newton import newton_step
from pyworm.solver.point.level import PointLevel
from pyworm.solver.transient.backward_term import BackwardTerm
from pyworm.solver.transient.heat_memory import (
    HeatedTimeLevel,
    residual_rise,
    velocities_at_origin,
)
from pyworm.solver.transient.moving_grid import at_places, each_at_places, seen_from
from pyworm.solver.transient.settling import JUDGED_PRESSURE, Settling, settling_of
from pyworm.solver.transient.time_grid import TimeGrid
from pyworm.solver.transient.time_level import (
    TimeLevel,
    content_of,
    extrapolated,
    is_limited,
    time_level_of,
)
from pyworm.solver.transient.time_steps import Step

EARLIER_FILMS = 3
"""Films before an instant from which its rate of change follows."""

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

WARMING_STEPS = 20
"""Largest number of further ones of a film whose flow balances while its temperatures still move: those of a
spot that loses its load move on for up to thirty sweeps, and other beginnings come to the same."""

MOST_HALVINGS = 4
"""Largest number of halvings of a time step whose film is not found."""


class NoFilmError(Exception):
    """No converged film at some time; the message gives the time and the reason."""


class NoLoadError(NoFilmError):
    """Surfaces that carry no load at a time amid their life, when neighbouring teeth carry all."""

    def __init__(self, seconds: float, reason: object) -> None:
        super().__init__(f"{lost_at(seconds)}: {reason}")
        self.seconds = seconds
        """The time [s]."""


def since_touch(time_grid: TimeGrid, seconds: float) -> float:
    """Transits from the first touch to a time."""
    return time_grid.transits(seconds) - time_grid.transits(time_grid.life.touched)


def steady_level(time_grid: TimeGrid, step: Step) -> tuple[Level, int]:
    """The steady film at a time on the moving grid, and its Newton steps there."""
    seconds = step.seconds
    contact = contact_at(time_grid, seconds)
    grid = time_grid.grid(seconds, step.refinement)
    with _told(seconds):
        level = _beside(contact, time_grid, grid, SOLVERS[type(contact)](contact, time_grid.plan))
        settling = settling_of(time_grid, step)
        taken = settling.iterated(level)
        if level.film.heated and not _is_found(level):
            # heat that the first steps lost begins anew, as cold as the bodies
            taken += settling.iterated(level)
    return _sound(level, seconds), taken


Reached = tuple[Level, list[TimeLevel], list[HeatedTimeLevel], int]
"""A film, films and heat before it, and the Newton steps to it."""


def reached(
    time_grid: TimeGrid,
    step: Step,
    before: list[TimeLevel],
    heat: list[HeatedTimeLevel],
    held: bool,
) -> Reached:
    """The film at a time.

    Where its rate of change is limited under pressure the time step is halved once: the end of the contact
    moves over the grid faster than the step resolves. Where that of the last film is, the halves come first.

    NoFilmError if no film was found after `MOST_HALVINGS`.
    """
    if before[0].limited:
        with suppress(NoFilmError):
            return _in_halves(time_grid, step, before, heat, held, 1)
    whole = _found(time_grid, step, before, heat, held)
    level, known, _, taken = whole
    if before[0].limited or not is_limited(level) or known is not before:
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
    """The film at a time; where none is found by halves of the step, and halves of these.

    A load that jumps, or an edge that enters the contact, leaves films from which neither a first guess nor a
    difference of higher order follows: halves of halves follow from the last film alone.
    """
    try:
        level, taken = _onward(time_grid, step, before, heat, held, halvings)
    except NoLoadError:
        raise
    except NoFilmError:
        if halvings == MOST_HALVINGS:
            raise
        known = before if halvings == 0 else before[:1]
        level, before, heat, taken = _in_halves(time_grid, step, known, heat, held, halvings + 1)
        taken += MOST_STEPS  # those to the film that was not found, at most
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
        raise NoFilmError(lost_at(step.seconds))
    middle = Step(seconds, step.refinement)
    level, before, heat, first = _found(time_grid, middle, before, heat, held, halvings)
    before = [time_level_of(level, middle.seconds), *before[: EARLIER_FILMS - 1]]
    heat = [*heated_levels(time_grid, level, middle.seconds), *heat]
    level, before, heat, second = _found(time_grid, step, before, heat, held, halvings)
    return level, before, heat, first + second


def _onward(
    time_grid: TimeGrid,
    step: Step,
    before: Sequence[TimeLevel],
    heat: Sequence[HeatedTimeLevel],
    held: bool,
    halvings: int,
) -> tuple[Level, int]:
    """The film at a time, from those before and their heat, the latest first, and its Newton steps.

    Where a separation is given but its surfaces are no longer held there the load is given in its place.
    A film that is not found begins again, by the number of halvings of the step (`_beginnings`).
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
    settling = settling_of(time_grid, step)
    with _told(seconds):
        level = _begun_from(time_grid, solver, grid, contact, before, seconds, settling)
        taken = _followed(level, term, settling)
        if level.film.balance.residual <= UNUSABLE_START_RESIDUAL:
            taken += settling.iterated(level, MOST_STEPS - TRIAL_STEPS)
            balance = level.film.balance
            if (
                balance.within(MAX_TRANSIENT_RESIDUAL, np.inf)
                and balance.warming > MAX_TEMPERATURE_RESIDUAL
            ):
                taken += settling.iterated(level, WARMING_STEPS)
        if contact.separation is None and not _is_found(level):
            for beginning in _beginnings(level, contact, time_grid, solver, halvings):
                level = beginning()
                taken += _followed(level, term, settling) + settling.iterated(level)
                if _is_found(level):
                    break
    return _sound(level, seconds), taken


def _beginnings(
    level: Level,
    contact: Scene | LineScene,
    time_grid: TimeGrid,
    solver: ContactSolver,
    halvings: int,
) -> Iterator[Callable[[], Level]]:
    """What a film that is not found from those before it begins with, on the grid of a level.

    Between rough surfaces it is the pressure of the dry contact, left to the oil: it costs no more than a
    Newton step and is as near as the steady film. That costs as much as ten films, and comes with halves of
    the step only; after the dry contact with the last halves.
    """
    dry = solver.dry_guesses(level) if level.film.rough else []
    for guess in dry:
        yield partial(solver.on_grid, level.grid, guess)
    if halvings >= (MOST_HALVINGS if dry else 1):
        yield partial(_beside, contact, time_grid, level.grid, solver)


def _followed(level: Level, term: BackwardTerm, settling: Settling) -> int:
    """First Newton steps of a film, in which its rate of change is limited; their number."""
    if settling.exact:
        level.film.judge(JUDGED_PRESSURE)
    # one step at least: a film that is only extrapolated would follow no equation until it is far from it
    _limit(level, term)
    newton_step(level, settling.forcing)
    taken = 1
    for most in (1, TRIAL_STEPS - 2):
        _limit(level, term)
        taken += settling.iterated(level, most)
    return taken


def _limit(level: Level, term: BackwardTerm) -> None:
    """Limit the rate of change of a point's film in its present state; lines take five times the steps."""
    if isinstance(level, PointLevel) and term.limit(content_of(level)):
        level.film.limit_rate(term.explicit)


def _begun_from(
    time_grid: TimeGrid,
    solver: ContactSolver,
    grid: Grid | LineGrid,
    contact: Scene | LineScene,
    before: Sequence[TimeLevel],
    seconds: float,
    settling: Settling,
) -> Level:
    """The level of a time that begins with the films before, the latest first.

    Where an edge moves through the contact its pressure moves over the nodes, and no film follows from
    extrapolated pressures; the last film, or its pressure as that of the oil, is nearer then. Soon after
    surfaces came together it is the extrapolated pressure as that of the oil: asperities, whose pressure is
    an exponential of the gap, would bear up to 1e25 times the load where that is a little too narrow.
    """
    onward, latest = extrapolated(before, seconds, settling.exact), before[0].state
    guesses = [onward, latest, replace(latest, oil=None)]
    if time_grid.approach is not None and since_touch(time_grid, seconds) <= MEMORY_TRANSITS:
        guesses = [onward, replace(onward, oil=None), latest]
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
    """The contact at a time with the effects of the plan, and no past; NoLoadError where it carries none."""
    try:
        contact = time_grid.life.at(seconds)
    except ValueError as reason:
        raise NoLoadError(seconds, reason) from reason
    return time_grid.plan.simplified(replace(contact, past=None))


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
    if not _is_found(level):
        raise NoFilmError(lost_at(seconds))
    return level


def _is_found(level: Level) -> bool:
    return level.film.balance.within(MAX_TRANSIENT_RESIDUAL, MAX_TEMPERATURE_RESIDUAL)


@contextmanager
def _told(seconds: float) -> Iterator[None]:
    """Tell at which time the kernel gave up a film."""
    try:
        yield
    except ValueError as error:  # surfaces that stand still have no steady film
        raise NoFilmError(f"{lost_at(seconds)}: {error}") from error
    except KernelError as error:
        if error.status not in (NO_SENSE, NOT_FINITE, NO_MEMORY):
            raise
        raise NoFilmError(f"{lost_at(seconds)}: {error}") from error


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


def heated_levels(time_grid: TimeGrid, level: Level, seconds: float) -> list[HeatedTimeLevel]:
    """Heat of a level's surfaces, where it is simulated.

    Surfaces remember the flux as far as the oil follows its heat within a transit. Between walls millimetres
    apart, far from the contact, it does not: flux and remembered rise of a wall at 17 m/s there drove each
    other, by a factor of 2.5 in each time step, to 260 K below the oil.
    """
    if not level.film.heated:
        return []
    share = prompt(level, time_grid.transit(seconds))[..., np.newaxis]
    flux = share * level.film.heat_fields().flux
    return [HeatedTimeLevel(seconds, level.grid, flux, velocities_at_origin(level.scene))]


def prompt(level: Level, time: float) -> Array:
    """How promptly the oil at the nodes follows its heat, 1 where it does in far less than a time [s].

    Between walls it is late by rho c h^2 / (10 k), the second term of a slow change. Where that is not short
    against a time step, far from the contact, what Newton's iteration left in two temperatures counts for
    more than their difference: a roller's film, whose load hardly changes, lost half its thickness by it.
    """
    heat, film = level.scene.oil.thermal, level.film.thickness()
    late = level.scene.oil.density.rho0 * heat.specific_heat * film**2 / (10 * heat.conductivity)
    return 1 / (1 + (late / time) ** 2)


def lost_at(seconds: float) -> str:
    """Say that the film of a time was not found."""
    return f"the transient solve found no converged film {seconds:.3g} s after the first touch"
