"""The transient term of a contact that changes while oil passes through it.

The Reynolds equation has d(rho h)/dt. Oil under pressure at present entered the contact some time ago, under
other load, curvature and edges, and its film is that of its entry. The equation is therefore integrated in
time, over the transit time of the oil. The result is the rate of change at present, which the films on all
grids of the figures take. Integrating from farther back, on grids of half the spacing and in shorter time
steps, gives the error of that rate.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import cos, inf, isfinite, sin

import numpy as np
import scipy

from pyworm.kernel.core import NO_MEMORY, NO_SENSE, NOT_FINITE, KernelError
from pyworm.planning.expected_work import TIME_STEPS
from pyworm.planning.grid import Grid, coarsened
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.plan import Plan, first_grids_of
from pyworm.planning.prediction import Prediction, predicted
from pyworm.scene.contact import Array
from pyworm.scene.line import LineScene
from pyworm.scene.past import Earlier
from pyworm.scene.point import Scene
from pyworm.solver.contact import ContactSolver
from pyworm.solver.error_estimate import Reading, grid_errors
from pyworm.solver.level import Level
from pyworm.solver.memory import shortage
from pyworm.solver.newton import ALGEBRA_FRACTION, lead, settle

TRANSITS = 1.5, 2.0, 2.7
"""Start of the integration at each refinement, before the present, in transit times of oil through the
middle of the contact."""

LEAST = 4
"""Least number of time steps where the past is shorter."""

FRACTION = 0.5
"""Error of the figures by the integration in time at which it is not refined, as a fraction of the
accuracy."""

SHORTENING = 1.5
"""Power by which time steps shorten towards the present: oil that entered late is everywhere in the contact,
oil that entered early has nearly left it."""

ORDER = 3
"""Order of the rates of change. At second order, notches that an edge leaves in the film and that travel with
the oil need four times as many time steps."""

TOLERANCE, WARMING = 1e-3, 5e-3
"""Residual of the films at earlier times, and last change of their temperatures over the largest rise, both
over the shortest time step in transits, since their errors count as rates of change."""

LOST = 1e-2
"""Residual above which the film of a time step is lost."""

OUTGROWN = 1.6
"""Size of a contact, over the present one's, above which it needs wider grids."""


@dataclass(frozen=True)
class TimeLevel:
    """rho h of a film at one time.

    Attributes
    ----------
    seconds, angle : float
        Time before the present [s], and angle of its x axis [rad], as of `past.Earlier`.
    held : callable
        rho h [m] at places; constant beyond its grid.
    """

    seconds: float
    angle: float
    held: Callable[..., Array]

    def content(self, grid: Grid | LineGrid, angle: float) -> Array:
        """rho h [m] at nodes of a grid in axes whose x axis has an angle [rad]."""
        return self.held(*_places(grid, angle - self.angle))


@dataclass(frozen=True)
class RateOfChange:
    """d(rho h)/dt of a film at one time, a `solver.level.TransientTerm`.

    Attributes
    ----------
    implicit : float
        Weight of rho h at present [1/s].
    films : tuple
        Weights [1/s] and rho h at earlier times.
    angle : float
        Angle of its x axis [rad], as of `past.Earlier`.
    """

    implicit: float
    films: tuple[tuple[float, TimeLevel], ...]
    angle: float = 0.0

    def on(self, grid: Grid | LineGrid) -> tuple[float, Array]:
        """Implicit [1/s] and explicit part [m/s] at nodes of a grid."""
        return self.implicit, sum(
            weight * film.content(grid, self.angle) for weight, film in self.films
        )


@dataclass(frozen=True)
class Transient:
    """The transient term of a contact at present.

    Attributes
    ----------
    rate : RateOfChange or None
        d(rho h)/dt at present; None where a film at an earlier time was not found.
    level : Level
        The film with that rate, on the plan's first grid of the figures.
    errors : dict
        Relative error of its figures by the grids, the time steps and the start of the integration.
    flaw : str or None
        Reason why the rate is not to be trusted.
    """

    rate: RateOfChange | None
    level: Level
    errors: dict[str, float]
    flaw: str | None


class LostError(Exception):
    """No converged film at some time before the present; the message gives the time and the reason."""


def transient(
    scene: Scene | LineScene, plan: Plan, solver_type: Callable[..., ContactSolver]
) -> Transient:
    """Integrate a contact's film in time, ever more finely until the error is small enough.

    Parameters
    ----------
    scene : Scene or LineScene
        The contact, with a past.
    plan : Plan
        Its plan.
    solver_type : callable
        Solver of this kind of contact: scene, plan, transient term -> `contact.ContactSolver`.
    """
    solver = solver_type(scene, plan)
    level, _ = solver.begin(plan.grids)
    errors = dict.fromkeys(level.read().figures, inf)
    readings: list[Reading] = []
    rate = flaw = None
    try:
        for refinement in range(len(TIME_STEPS)):
            rate = _integrated(scene, plan, solver_type, refinement)
            level = solver_type(scene, plan, rate).at_next_time((level,), 0.0)
            # at least two steps: a rate that changes little leaves less than the tolerance, but not nothing
            settled = settle(level, plan.tolerance, plan.aim, ALGEBRA_FRACTION * plan.accuracy)
            readings.append(settled.reading)
            errors = grid_errors(readings, solver.convergence.orders)
            left = plan.aim.worst(errors, settled.reading.figures)
            if left <= FRACTION * plan.accuracy:
                break
        if not left <= plan.accuracy:  # finer grids of the present film would not mend that
            flaw = f"the transient solve through the contact's past leaves an error of {left:.1%}"
    except LostError as lost:
        flaw = str(lost)
        errors = dict.fromkeys(errors, inf)
    return Transient(rate, level, errors, flaw)


def _integrated(
    scene: Scene | LineScene,
    plan: Plan,
    solver_type: Callable[..., ContactSolver],
    refinement: int,
) -> RateOfChange:
    """Integrate to the present at one refinement; raises LostError where a film is not found."""
    moments, shortest = _moments(scene, refinement)
    nest = _nest(moments, plan, refinement)
    short = shortage(nest[-1], plan.model)
    if short is not None:
        raise LostError(short)
    films: list[TimeLevel] = []
    levels: list[Level] = []
    for moment in reversed(moments):
        try:
            level = _levelat(moment, plan, solver_type, nest, films, levels, shortest)
        except KernelError as error:
            if error.status not in (NO_SENSE, NOT_FINITE, NO_MEMORY):
                raise
            raise LostError(f"{_failed(moment)}: {error}") from error
        if not level.film.balance.worst <= LOST:
            raise LostError(_failed(moment))
        levels = [level, *levels[:1]]
        films = [_time_level(moment, level), *films[:ORDER]]
    weights = _rate([film.seconds for film in films])
    return RateOfChange(0.0, tuple(zip(weights, films, strict=True)))


def _moments(scene: Scene | LineScene, refinement: int) -> tuple[list[Earlier], float]:
    """The contact at the time levels, the present first, and the shortest time step in transits."""
    transit = predicted(scene).transit
    whole = TRANSITS[refinement] * transit
    span = min(whole, scene.past.seconds)
    count = max(LEAST, round(TIME_STEPS[refinement] * (span / whole) ** (1 / SHORTENING)))
    times = [span * (k / count) ** SHORTENING for k in range(count + 1)]
    return [Earlier(0.0, scene), *scene.past.back(times[1:])], times[1] / transit


def _levelat(
    moment: Earlier,
    plan: Plan,
    solver_type: Callable[..., ContactSolver],
    nest: Sequence[Grid | LineGrid],
    films: Sequence[TimeLevel],
    levels: Sequence[Level],
    shortest: float,
) -> Level:
    """The film at one time, from those at earlier times, the latest first; the first one is steady."""
    solver = solver_type(moment.contact, plan, _backwards(moment, films))
    tolerances = TOLERANCE * shortest, WARMING * shortest
    if levels:
        level = solver.at_next_time(levels, _onward(films, moment))
        lead(level, *tolerances)
        if level.film.balance.worst <= LOST:
            return level
    # steady at first: on the way to these grids nothing is known of what the film held
    level, _ = solver_type(moment.contact, plan).begin(nest)
    if levels:
        level = solver.at_next_time((level,), 0.0)
    lead(level, *tolerances)
    return level


def _failed(moment: Earlier) -> str:
    if moment.seconds == 0:
        return "the transient solve found no converged film at present"
    return f"the transient solve found no converged film {moment.seconds:.2g} s before the present"


def _backwards(moment: Earlier, films: Sequence[TimeLevel]) -> RateOfChange | None:
    """d(rho h)/dt at one time by its film and earlier ones; None of the first, which is steady."""
    if not films:
        return None
    before = films[:ORDER]
    weights = _rate([moment.seconds, *(film.seconds for film in before)])
    return RateOfChange(weights[0], tuple(zip(weights[1:], before, strict=True)), moment.angle)


def _onward(films: Sequence[TimeLevel], moment: Earlier) -> float:
    """Time step over the one before; 0 where there is only one earlier film."""
    if len(films) == 1:
        return 0.0
    latest, before = films[0].seconds, films[1].seconds
    return (latest - moment.seconds) / (before - latest)


def _nest(moments: Sequence[Earlier], plan: Plan, refinement: int) -> tuple[Grid | LineGrid, ...]:
    """Grids of the integration: the plan's, or those of the largest contact where it outgrows them."""
    now, *earlier = (predicted(moment.contact) for moment in moments)
    largest = max(earlier, key=_size, default=now)
    grids = plan.grids
    if _size(largest) > OUTGROWN * _size(now):
        grids = first_grids_of(largest.scene, plan)
    if isinstance(grids[-1], Grid):  # those of lines cost next to nothing
        grids = coarsened(grids)
    for _ in range(refinement):
        grids = *grids, grids[-1].finer()
    return grids


def _size(contact: Prediction) -> float:
    """Area of a contact [m2], or width [m] of one along a line."""
    return contact.half_width * (contact.half_length if isfinite(contact.half_length) else 1.0)


def _rate(times: Sequence[float]) -> list[float]:
    """Weights [1/s] of values at times before the present, the latest first, in the rate of change there.

    The rate is that of the interpolating polynomial.
    """
    latest, *before = times
    weights = []
    for time in before:
        others = [other for other in before if other != time]
        weights.append(-1 / (time - latest) * np.prod([(o - latest) / (o - time) for o in others]))
    return [-sum(weights), *weights]


def _time_level(moment: Earlier, level: Level) -> TimeLevel:
    film, density, _ = level.film.fields()
    return TimeLevel(moment.seconds, moment.angle, _between(level.grid, density * film))


def _between(grid: Grid | LineGrid, field: Array) -> Callable[..., Array]:
    """Interpolate a field between nodes; beyond the grid it is constant."""
    if isinstance(grid, LineGrid):
        spline = scipy.interpolate.CubicSpline(grid.x, field)
        return lambda x: spline(np.clip(x, grid.x[0], grid.x[-1]))
    spline = scipy.interpolate.RectBivariateSpline(grid.x, grid.y, field)
    return lambda x, y: spline(x, y, grid=False)


def _places(grid: Grid | LineGrid, turn: float = 0.0) -> tuple[Array, ...]:
    """Nodes of a grid in axes from which its own are rotated by an angle [rad]."""
    if isinstance(grid, LineGrid):
        return (grid.x,)
    x, y = grid.mesh()
    return x * cos(turn) - y * sin(turn), y * cos(turn) + x * sin(turn)
