"""The film of a contact that changes while oil passes through it.

Reynolds' equation has d(rho h)/dt. Oil that is under pressure now came to the contact some time ago, when
load, curvature and edges were others, and the film is what it was there then: it has to be marched through
the past, as far back as oil stays. That is done on the first grid of the figures, and tells how fast the film
changes at the present; finer grids take that rate as it is.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import cos, isfinite, sin
from typing import Any

import numpy as np
from scipy.interpolate import RectBivariateSpline

from pyworm.accuracy import change
from pyworm.effects.sketch import Sketch, sketch
from pyworm.grid import Grid
from pyworm.ladder import Ladder, Rung, lead
from pyworm.line.grid import LineGrid
from pyworm.line.scene import LineScene
from pyworm.past import Earlier
from pyworm.planning import Plan, first_grids_of
from pyworm.scene import Array, Scene

TRANSITS = 2.0
"""How far back films are marched from, in the time that oil takes to pass through the contact's middle."""

STEPS, LEAST = 12, 4
"""Steps of time in it to begin with, and the least in a shorter past."""

SHORTEST = 0.006
"""Shortest step of time, in transits: over shorter ones what films are off by on their grids counts as
change."""

SHORTENING = 1.5
"""Power by which steps shorten towards the present: oil that came late is all over the contact, and what came
early has nearly left it."""

ORDER = 3
"""Order of rates of change. Of second order, notches that an edge leaves in the film and that travel with the
oil took four times as many steps."""

WANTED, BORNE = 0.4, 0.5
"""Error of the figures by steps of time beyond which there are more of these, and beyond which the figures
are not to be trusted, as shares of the accuracy."""

TOLERANCE = 2e-3
"""Residual to which films are solved on the way, over the shortest step of time in transits: what is left
unsolved counts as change."""

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
class Storage:
    """How the oil that a film stores changes: d(rho h)/dt, as `kernels.PointFilm.store` takes it.

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
    """A film marched to the present.

    Attributes
    ----------
    storage : Storage
        How what it stores changes.
    rung : Rung
        It, on its grid.
    errors : dict
        Relative error of its figures by the steps of time.
    flaw : str or None
        Why it is not to be trusted.
    """

    storage: Storage
    rung: Rung
    errors: dict[str, float]
    flaw: str | None

    def start(self, grids: Sequence[Grid | LineGrid]) -> Any:
        """Where a film on such grids may begin; None where this one has others."""
        return self.rung.end() if self.rung.grid == grids[-1] and not self.flaw else None


def marched(scene: Scene | LineScene, plan: Plan, climb: Callable[..., Ladder]) -> History | None:
    """The film of a scene as it came to be, in steps of time that accuracy calls for.

    None where the scene has no past.

    Parameters
    ----------
    scene : Scene or LineScene
        The contact.
    plan : Plan
        Its plan.
    climb : callable
        The climb of this kind of contact: scene, plan, storage -> `ladder.Ladder`.
    """
    if scene.past is None:
        return None
    transit = sketch(scene).transit
    span = min(TRANSITS * transit, scene.past.seconds)
    most = (span / (SHORTEST * transit)) ** (1 / SHORTENING)
    steps = max(LEAST, round(STEPS * span / (TRANSITS * transit)))
    while True:
        times = [span * (k / steps) ** SHORTENING for k in range(steps + 1)]
        history = _march(scene, plan, climb, times, TOLERANCE * times[1] / transit)
        error = plan.aim.worst(history.errors, history.rung.read().figures)
        wanted = error / (WANTED * plan.accuracy)
        if history.flaw or wanted <= 1:
            return history
        further = steps * (2 if wanted <= 2**ORDER else 4)
        if further > most:
            flaw = f"{steps} steps of time leave an error of {error:.1%}"
            return history if error <= BORNE * plan.accuracy else replace(history, flaw=flaw)
        steps = further


def _march(
    scene: Scene | LineScene,
    plan: Plan,
    climb: Callable[..., Ladder],
    times: Sequence[float],
    tolerance: float,
) -> History:
    """The same through times before the present, the latest first, as far back as the contact carried."""
    moments = [Earlier(0.0, scene), *scene.past.back(times[1:])]
    nest = _nest(moments, plan)
    films: list[Instant] = []
    ends: list[Any] = []
    rung, flaw = None, None
    for moment in reversed(moments):
        storage = None
        if films:
            weights = _rate([moment.seconds, *(film.seconds for film in films[:ORDER])])
            past = zip(weights[1:], films, strict=False)
            storage = Storage(weights[0], tuple(past), moment.angle)
        ladder = climb(moment.contact, plan, storage)
        if rung is not None:
            rung = ladder.follow(rung, _ahead(ends, films, moment))
            lead(rung, tolerance)
        if rung is None or not rung.film.balance.worst <= LOST:
            rung, _ = ladder.enter(nest)
            lead(rung, tolerance)
        if not rung.film.balance.worst <= LOST:
            flaw = f"the film was not found at {moment.contact.name}, through which it came"
        ends = [rung.end(), *ends[:1]]
        films = [_instant(moment, rung), *films[: 2 * ORDER]]
    rougher = climb(scene, plan, _changing(films[::2])).follow(rung, ends[0])
    lead(rougher, tolerance)
    return History(_changing(films[: ORDER + 1]), rung, change(rougher.read(), rung.read()), flaw)


def _ahead(ends: Sequence[Any], films: Sequence[Instant], moment: Earlier) -> Any:
    """Where the film of a moment may begin, by the ends of the two before."""
    if len(ends) == 1:
        return ends[0]
    first, second, third = films[1].seconds, films[0].seconds, moment.seconds
    return ends[0].onward(ends[1], (second - third) / (first - second))


def _nest(moments: Sequence[Earlier], plan: Plan) -> tuple[Grid | LineGrid, ...]:
    """The plan's grids, or those of the largest contact if they do not hold it."""
    now, *earlier = (sketch(moment.contact) for moment in moments)
    largest = max(earlier, key=_size, default=now)
    if _size(largest) <= OUTGROWN * _size(now):
        return plan.grids
    return first_grids_of(largest.scene, plan)


def _changing(films: Sequence[Instant]) -> Storage:
    """What a film stores, of which the present and the past are known."""
    weights = _rate([film.seconds for film in films])
    return Storage(0.0, tuple(zip(weights, films, strict=True)))


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
        return lambda x: np.interp(x, grid.x, field)
    spline = RectBivariateSpline(grid.x, grid.y, field)
    return lambda x, y: spline(x, y, grid=False)


def _places(grid: Grid | LineGrid, turn: float = 0.0) -> tuple[Array, ...]:
    """Nodes of a grid in axes out of which its own are turned by an angle [rad]."""
    if isinstance(grid, LineGrid):
        return (grid.x,)
    x, y = grid.mesh()
    return x * cos(turn) - y * sin(turn), y * cos(turn) + x * sin(turn)
