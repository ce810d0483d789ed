"""The film of a contact that changes while oil passes through it.

Reynolds' equation has d(rho h)/dt. Oil that is under pressure now came to the contact some time ago, when
load, curvature and edges were others, and the film is what it was there then: it has to be marched through
the past, as far back as oil stays. That is done on the first grid of the figures, with a Newtonian film of
one temperature; how fast that film changes at the present tells what the film in question stores, as thick
as it is.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import cos, sin

import numpy as np
from scipy.interpolate import RectBivariateSpline

from pyworm.effects.sketch import sketch
from pyworm.grid import Grid
from pyworm.ladder import Ladder, Rung, lead
from pyworm.line.grid import LineGrid
from pyworm.line.scene import LineScene
from pyworm.past import Earlier
from pyworm.planning import Model, Plan
from pyworm.reading import carrying_film
from pyworm.scene import Array, Scene

TRANSITS = 2.0
"""How far back films are marched from, in the time that oil takes to pass through the contact's middle."""

STEPS = 12
"""Steps of time in it."""

MARCH_TOLERANCE = 1e-5
"""Residual to which the film of each step is solved; with 1e-4 films at the end were off by 0.3 %."""

NEST = 2
"""Grids of a nest that are climbed at each step; from one alone films at the end were off by 0.7 %."""

LOST = 1e-2
"""Residual from which the film of a step is none."""

BACKWARD = ((1.0, -1.0), (1.5, -2.0, 0.5))
"""Weights of the present and of the steps before it, the latest first, in a rate of change: Euler's for the
first step, then Gear's of second order."""


@dataclass(frozen=True)
class Instant:
    """A film at one time.

    Attributes
    ----------
    angle : float
        Angle of its x axis [rad], as of `past.Earlier`.
    gap, lift : callable
        The undeformed gap, and what rho h is more than that [m], at places; the latter beyond the film's own
        grid as at its edge.
    film : float
        Mean film by the load that it carries [m].
    """

    angle: float
    gap: Callable[..., Array]
    lift: Callable[..., Array]
    film: float

    def content(self, grid: Grid | LineGrid, angle: float = 0.0) -> Array:
        """rho h [m] at nodes of a grid in axes whose x axis has an angle [rad]."""
        places = _places(grid, angle - self.angle)
        return self.gap(*places) + self.lift(*places)


@dataclass(frozen=True)
class Remembered:
    """What a film stores of which only the past is known.

    Attributes
    ----------
    films : sequence of Instant
        What it was, the latest first.
    angle : float
        Angle of the present x axis [rad], as of `past.Earlier`.
    step : float
        Time between them [s].
    """

    films: Sequence[Instant]
    angle: float
    step: float

    def on(self, grid: Grid | LineGrid, film: float | None) -> tuple[float, Array]:
        """Renewal [1/s] and squeeze [m/s] on a grid, as of `kernels.PointFilm.store`."""
        present, *past = BACKWARD[len(self.films) - 1]
        known = (
            weight * of.content(grid, self.angle)
            for weight, of in zip(past, self.films, strict=True)
        )
        return present / self.step, sum(known) / self.step


@dataclass(frozen=True)
class Changing:
    """What a film stores that changes as a similar one does, of which past and present are known.

    Attributes
    ----------
    films : sequence of Instant
        The similar film, the latest first.
    step : float
        Time between them [s].
    flaw : str or None
        Why it is not to be trusted.
    """

    films: Sequence[Instant]
    step: float
    flaw: str | None = None

    def on(self, grid: Grid | LineGrid, film: float | None) -> tuple[float, Array]:
        """Renewal [1/s] and squeeze [m/s] on a grid, as of `kernels.PointFilm.store`.

        Where gaps are wide they change by themselves. Where there is hardly more than the film of the load
        they change as thick as it is: `film` [m], where that is known, over the similar one's.
        """
        contents = [of.content(grid) for of in self.films]
        weights = BACKWARD[len(contents) - 2]
        rate = sum(w * content for w, content in zip(weights, contents, strict=True)) / self.step
        similar = self.films[0].film
        scale = 1.0 if film is None else film / similar
        return 0.0, rate * (1 - (1 - scale) * similar / np.maximum(contents[0], similar))


Storage = Remembered | Changing


def changing(
    scene: Scene | LineScene, plan: Plan, ladder: Callable[..., Ladder]
) -> Changing | None:
    """How the film of a scene that has a past changes at the present; None where the past holds nothing.

    Parameters
    ----------
    scene : Scene or LineScene
        The contact.
    plan : Plan
        Its plan.
    ladder : callable
        The climb of this kind of contact: scene, plan, storage -> `ladder.Ladder`.
    """
    step = TRANSITS * sketch(scene).transit / STEPS
    past = scene.past.back(step, STEPS)
    if not past:
        return None
    plain = replace(plan, model=Model())
    wide = (plan.wider_grids or plan.grids)[0]
    films: list[Instant] = []
    flaw = None
    for moment in (*reversed(past), Earlier(scene)):
        storage = Remembered(films[:2], moment.angle, step) if films else None
        rung, _ = ladder(moment.contact, plain, storage).enter(plan.grids[-NEST:])
        lead(rung, MARCH_TOLERANCE)
        if not rung.film.balance.worst <= LOST:
            flaw = f"the film was not found at {moment.contact.name}, through which it came"
        films = [_instant(moment, rung, wide), *films[:2]]
    return Changing(films, step, flaw)


def _instant(moment: Earlier, rung: Rung, wide: Grid | LineGrid) -> Instant:
    film, density, _ = rung.film.fields()
    gap = _between(wide, moment.contact.gap(*_places(wide))[0])
    lift = density * film - gap(*_places(rung.grid))
    return Instant(
        moment.angle, gap, _between(rung.grid, lift), carrying_film(film, rung.film.pressure)
    )


def _between(grid: Grid | LineGrid, field: Array) -> Callable[..., Array]:
    """A field between nodes; outside the grid as at its edge."""
    if isinstance(grid, LineGrid):
        return lambda x: np.interp(x, grid.x, field)
    spline = RectBivariateSpline(grid.x, grid.y, field)
    return lambda x, y: spline(x, y, grid=False)


def _places(grid: Grid | LineGrid, turn: float = 0.0) -> tuple[Array, ...]:
    """Nodes of a grid in axes turned by less than it, by an angle [rad]."""
    if isinstance(grid, LineGrid):
        return (grid.x,)
    x, y = grid.mesh()
    return x * cos(turn) - y * sin(turn), y * cos(turn) + x * sin(turn)
