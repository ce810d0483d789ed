"""How the film of a contact changes while oil passes through it.

Reynolds' equation has d(rho h)/dt. Oil that is under pressure now came to the contact some time ago, when
load, curvature and edges were others, and the film is what it was there then: it has to be marched through
the past, as far back as oil stays. What a march tells is the rate of change at present, which films on all
grids of the figures then take. A march from farther back, on grids of half the spacing and in shorter steps
of time, shows how good that is.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import cos, inf, isfinite, sin

import numpy as np
from scipy.interpolate import CubicSpline, RectBivariateSpline

from pyworm.kernel.core import NO_MEMORY, NO_SENSE, NOT_FINITE, KernelError
from pyworm.planning.expected_work import INSTANTS
from pyworm.planning.grid import Grid, coarsened
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.plan import Plan, first_grids_of
from pyworm.planning.prediction import Sketch, sketch
from pyworm.scene.line import LineScene
from pyworm.scene.past import Earlier
from pyworm.scene.point import Array, Scene
from pyworm.solver.contact import Ladder
from pyworm.solver.error_estimate import Reading, grid_errors
from pyworm.solver.level import Rung
from pyworm.solver.memory import shortage
from pyworm.solver.newton import ALGEBRA_SHARE, lead, settle

TRANSITS = 1.5, 2.0, 2.7
"""How far back films are marched from at each level, in the time that oil takes to pass through the contact's
middle."""

LEAST = 4
"""Least steps of time in a shorter past."""

SHARE = 0.5
"""Error of the figures by a march that asks for no finer one, as a share of the accuracy."""

SHORTENING = 1.5
"""Power by which steps shorten towards the present: oil that came late is all over the contact, and what came
early has nearly left it."""

ORDER = 3
"""Order of rates of change. Of second order, notches that an edge leaves in the film and that travel with the
oil took four times as many steps."""

TOLERANCE, WARMING = 1e-3, 5e-3
"""Residual to which films are solved on the way, and last change of their temperatures over the largest rise,
both over the shortest step of time in transits: what is left unsolved counts as change."""

LOST = 1e-2
"""Residual from which the film of a step is none."""

OUTGROWN = 1.6
"""Size of a contact, over the present one's, that the present one's grids do not hold."""


@dataclass(frozen=True)
class Instant:
    """What a film held at one time.

    Attributes
    ----------
    seconds, angle : float
        Time before the present [s], and angle of its x axis [rad], as of `past.Earlier`.
    held : callable
        rho h [m] at places; beyond its grid as at the edge.
    """

    seconds: float
    angle: float
    held: Callable[..., Array]

    def content(self, grid: Grid | LineGrid, angle: float) -> Array:
        """rho h [m] at nodes of a grid in axes whose x axis has an angle [rad]."""
        return self.held(*_places(grid, angle - self.angle))


@dataclass(frozen=True)
class Change:
    """d(rho h)/dt of a film at one time, a `ladder.Storage`.

    Attributes
    ----------
    renewal : float
        Its change by what the film holds [1/s].
    films : tuple
        Weights [1/s] of what it held at other times, and that.
    angle : float
        Angle of its x axis [rad], as of `past.Earlier`.
    """

    renewal: float
    films: tuple[tuple[float, Instant], ...]
    angle: float = 0.0

    def on(self, grid: Grid | LineGrid) -> tuple[float, Array]:
        """Renewal [1/s] and squeeze [m/s] at nodes of a grid."""
        return self.renewal, sum(
            weight * film.content(grid, self.angle) for weight, film in self.films
        )


@dataclass(frozen=True)
class History:
    """What a contact's past makes of its film.

    Attributes
    ----------
    storage : Change or None
        How what the film stores changes at present; None where that was not found.
    rung : Rung
        The film that changes so, on the plan's first grid of the figures.
    errors : dict
        Relative error of its figures by the grids, the steps and the start of the march.
    flaw : str or None
        Why none of it is to be trusted.
    """

    storage: Change | None
    rung: Rung
    errors: dict[str, float]
    flaw: str | None


class LostError(Exception):
    """A film on the way was not found; the message says which, and why if that is known."""


def marched(scene: Scene | LineScene, plan: Plan, climb: Callable[..., Ladder]) -> History:
    """March a film through its past, ever more finely until that changes it little enough.

    Parameters
    ----------
    scene : Scene or LineScene
        The contact, with a past.
    plan : Plan
        Its plan.
    climb : callable
        The climb of this kind of contact: scene, plan, storage -> `ladder.Ladder`.
    """
    ladder = climb(scene, plan)
    rung, _ = ladder.enter(plan.grids)
    errors = dict.fromkeys(rung.read().figures, inf)
    readings: list[Reading] = []
    storage = flaw = None
    try:
        for level in range(len(INSTANTS)):
            storage = _march(scene, plan, climb, level)
            rung, now = _changing(scene, plan, climb, storage, rung)
            readings.append(now)
            errors = grid_errors(readings, ladder.convergence.orders)
            left = plan.aim.worst(errors, now.figures)
            if left <= SHARE * plan.accuracy:
                break
        if not left <= plan.accuracy:  # finer grids of the present film would not mend that
            flaw = f"the march through the contact's past leaves an error of {left:.1%}"
    except LostError as lost:
        flaw = str(lost)
        errors = dict.fromkeys(errors, inf)
    return History(storage, rung, errors, flaw)


def _changing(
    scene: Scene | LineScene, plan: Plan, climb: Callable[..., Ladder], storage: Change, rung: Rung
) -> tuple[Rung, Reading]:
    """The film that changes so, on the grid of a rung and from its film, and its figures."""
    rung = climb(scene, plan, storage).follow((rung,), 0.0)
    # at least two steps: a march that changes little leaves less than the tolerance, but not nothing
    settled = settle(rung, plan.tolerance, plan.aim, ALGEBRA_SHARE * plan.accuracy)
    return rung, settled.reading


def _march(
    scene: Scene | LineScene, plan: Plan, climb: Callable[..., Ladder], level: int
) -> Change:
    """How a film changes at present, from as far back and as finely as the level says; else LostError."""
    transit = sketch(scene).transit
    whole = TRANSITS[level] * transit
    span = min(whole, scene.past.seconds)
    steps = max(LEAST, round(INSTANTS[level] * (span / whole) ** (1 / SHORTENING)))
    times = [span * (k / steps) ** SHORTENING for k in range(steps + 1)]
    shortest = times[1] / transit
    tolerances = TOLERANCE * shortest, WARMING * shortest
    moments = [Earlier(0.0, scene), *scene.past.back(times[1:])]
    nest = _nest(moments, plan, level)
    short = shortage(nest[-1], plan.model)
    if short is not None:
        raise LostError(short)
    films: list[Instant] = []
    rungs: list[Rung] = []
    for moment in reversed(moments):
        ladder = climb(moment.contact, plan, _backwards(moment, films))
        where = f"the film of {moment.seconds:.2g} s before, which it comes from, was not found"
        try:
            if rungs:
                rung = ladder.follow(rungs, _onward(films, moment))
                lead(rung, *tolerances)
            if not rungs or not rung.film.balance.worst <= LOST:
                # steady at first: on the way to these grids nothing is known of what the film held
                rung, _ = climb(moment.contact, plan).enter(nest)
                if rungs:
                    rung = ladder.follow((rung,), 0.0)
                lead(rung, *tolerances)
        except KernelError as error:
            if error.status not in (NO_SENSE, NOT_FINITE, NO_MEMORY):
                raise
            raise LostError(f"{where}: {error}") from error
        if not rung.film.balance.worst <= LOST:
            raise LostError(where)
        rungs = [rung, *rungs[:1]]
        films = [_instant(moment, rung), *films[:ORDER]]
    weights = _rate([film.seconds for film in films])
    return Change(0.0, tuple(zip(weights, films, strict=True)))


def _backwards(moment: Earlier, films: Sequence[Instant]) -> Change | None:
    """What the film of a moment stores, by itself and those before it; None of the first, which is steady."""
    if not films:
        return None
    before = films[:ORDER]
    weights = _rate([moment.seconds, *(film.seconds for film in before)])
    return Change(weights[0], tuple(zip(weights[1:], before, strict=True)), moment.angle)


def _onward(films: Sequence[Instant], moment: Earlier) -> float:
    """Time from the last film to a moment over that between the last two; 0 where there is but one."""
    if len(films) == 1:
        return 0.0
    latest, before = films[0].seconds, films[1].seconds
    return (latest - moment.seconds) / (before - latest)


def _nest(moments: Sequence[Earlier], plan: Plan, level: int) -> tuple[Grid | LineGrid, ...]:
    """Grids to march on at a level: the plan's, or those of the largest contact if they do not hold it."""
    now, *earlier = (sketch(moment.contact) for moment in moments)
    largest = max(earlier, key=_size, default=now)
    grids = plan.grids
    if _size(largest) > OUTGROWN * _size(now):
        grids = first_grids_of(largest.scene, plan)
    if isinstance(grids[-1], Grid):  # those of lines cost next to nothing
        grids = coarsened(grids)
    for _ in range(level):
        grids = *grids, grids[-1].finer()
    return grids


def _size(contact: Sketch) -> float:
    """Area of a contact [m2], or width [m] of one along a line."""
    return contact.half_width * (contact.half_length if isfinite(contact.half_length) else 1.0)


def _rate(times: Sequence[float]) -> list[float]:
    """Weights [1/s] of values at times before the present, the latest first, in the rate of change at that.

    That of a parabola, or of a line through two.
    """
    latest, *before = times
    weights = []
    for time in before:
        others = [other for other in before if other != time]
        weights.append(-1 / (time - latest) * np.prod([(o - latest) / (o - time) for o in others]))
    return [-sum(weights), *weights]


def _instant(moment: Earlier, rung: Rung) -> Instant:
    film, density, _ = rung.film.fields()
    return Instant(moment.seconds, moment.angle, _between(rung.grid, density * film))


def _between(grid: Grid | LineGrid, field: Array) -> Callable[..., Array]:
    """A field between nodes; beyond the grid as at its edge."""
    if isinstance(grid, LineGrid):
        spline = CubicSpline(grid.x, field)
        return lambda x: spline(np.clip(x, grid.x[0], grid.x[-1]))
    spline = RectBivariateSpline(grid.x, grid.y, field)
    return lambda x, y: spline(x, y, grid=False)


def _places(grid: Grid | LineGrid, turn: float = 0.0) -> tuple[Array, ...]:
    """Nodes of a grid in axes out of which its own are turned by an angle [rad]."""
    if isinstance(grid, LineGrid):
        return (grid.x,)
    x, y = grid.mesh()
    return x * cos(turn) - y * sin(turn), y * cos(turn) + x * sin(turn)
