"""What squeeze does over a drive's mesh cycle: what plans tell of it, and what marched films show.

Each contact's film, isothermal and Newtonian, is marched through the two transits of oil before it, in steps
that shorten towards the present and with rates of change of third order, from a steady film on. Loads are
shared dry. Steps of time and grids are not refined by themselves; half the steps and a finer grid show how
good the changes are. Run from the repository's root (it takes ten minutes):

    python benchmarks/squeeze.py [CASE] [--phase PHASE ...] [--steps 24] [--finer 0]
"""

from argparse import ArgumentParser
from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, prod, sin

import numpy as np
from scipy.interpolate import RectBivariateSpline

import pyworm
from pyworm import climb
from pyworm.effects.sketch import sketch
from pyworm.effects.unsimulated import SQUEEZE, lag, spread
from pyworm.grid import Grid
from pyworm.ladder import lead
from pyworm.line.scene import LineScene
from pyworm.past import Earlier
from pyworm.scales import scales
from pyworm.scene import Array, Scene

TRANSITS = 2.0
"""How far back films are marched from, in the time that oil takes to pass through the contact's middle."""

SHORTENING, ORDER = 1.5, 3
"""Power by which steps of time shorten, and the order of rates of change."""

ACCURACY, TOLERANCE = 0.05, 1e-6
"""Accuracy of the plan whose first grids are taken, and residual to which films are solved."""


@dataclass(frozen=True)
class Instant:
    """What the films of a nest of grids held at one time."""

    moment: Earlier
    rungs: Sequence[climb.Rung]

    def content(self, level: int, angle: float) -> Array:
        """rho h [m] on a grid of the nest in axes whose x axis has an angle [rad]."""
        rung = self.rungs[level]
        film, density, _ = rung.film.fields()
        lift = RectBivariateSpline(rung.grid.x, rung.grid.y, density * film - rung.gap)
        x, y = rung.grid.mesh()
        turn = angle - self.moment.angle
        places = x * cos(turn) - y * sin(turn), y * cos(turn) + x * sin(turn)
        return self.moment.contact.gap(*places)[0] + lift(*places, grid=False)


def rate(times: Sequence[float]) -> list[float]:
    """Weights [1/s] of values at times before the present, the latest first, in the rate of change then."""
    latest, *before = times
    weights = [
        prod((other - latest) / (other - time) for other in before if other != time)
        / (latest - time)
        for time in before
    ]
    return [-sum(weights), *weights]


def solved(moment: Earlier, nest: Sequence[Grid], films: Sequence[Instant]) -> Instant:
    """The film of a moment, steady if none is known of before."""
    scene, rungs = moment.contact, []
    size = scales(scene)
    for level, grid in enumerate(nest):
        if rungs:
            rung = climb.next_rung(scene, size, rungs[-1], grid, climb.entry(rungs[-1], grid))
        else:
            rung = climb.first_rung(scene, scene, size, grid)
        if films:
            renewal, *weights = rate([of.seconds for of in (moment, *(f.moment for f in films))])
            past = (f.content(level, moment.angle) for f in films)
            rung.film.store(renewal, sum(w * p for w, p in zip(weights, past, strict=True)))
            rung.film.restart()
        lead(rung, TOLERANCE)
        rungs.append(rung)
    return Instant(moment, rungs)


def marched(scene: Scene, nest: Sequence[Grid], steps: int) -> Instant:
    """The film of a scene as it came to be."""
    span = min(TRANSITS * sketch(scene).transit, scene.past.seconds)
    times = [span * (k / steps) ** SHORTENING for k in range(1, steps + 1)]
    films: list[Instant] = []
    for moment in (*reversed(scene.past.back(times)), Earlier(0.0, scene)):
        films = [solved(moment, nest, films), *films[: ORDER - 1]]
    return films[0]


def nest_of(scene: Scene, finer: int) -> Sequence[Grid]:
    """Grids that hold the contact now and as it was, the last of them refined some times."""
    span = min(TRANSITS * sketch(scene).transit, scene.past.seconds)
    moments = [Earlier(0.0, scene), *scene.past.back([span / 2, span])]
    largest = max((moment.contact for moment in moments), key=lambda contact: contact.load)
    nest = list(pyworm.plan(largest, ACCURACY, "isothermal", ("film",)).grids)
    for _ in range(finer):
        nest.append(nest[-1].finer())
    return nest


def main(path: str, phases: Sequence[float] | None, steps: int, finer: int) -> None:
    """A row for each contact that the case lists, or at some of its phases."""
    heads = ("ms", "lag", "spread", "told", "central", "least")
    print(f"{'':>32} " + " ".join(f"{head:>8}" for head in heads))
    for scene in pyworm.load(path).scenes(phase=phases):
        lacking = SQUEEZE.lacking(scene)
        if lacking is not None:
            print(f"{scene.name:>32} {lacking}")
            continue
        of = sketch(scene)
        shares = [lag(of), spread(of), SQUEEZE.influence(of).film]
        if not isinstance(scene, LineScene):
            nest = nest_of(scene, finer)
            films = marched(scene, nest, steps), solved(Earlier(0.0, scene), nest, ())
            after, steady = (film.rungs[-1].read() for film in films)
            shares.append(after.film_central / steady.film_central - 1)
            shares.append(after.film_min / steady.film_min - 1)
            if max(film.rungs[-1].film.balance.worst for film in films) > TOLERANCE:
                shares[-2:] = [np.nan, np.nan]
        told = " ".join(f"{share:8.1%}" for share in shares)
        print(f"{scene.name:>32} {of.transit * 1e3:8.2f} {told}", flush=True)


if __name__ == "__main__":
    parser = ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", nargs="?", default="cases/zi_drive.toml")
    parser.add_argument("--phase", type=float, nargs="+")
    parser.add_argument("--steps", type=int, default=24)
    parser.add_argument("--finer", type=int, default=0)
    asked = parser.parse_args()
    main(asked.case, asked.phase, asked.steps, asked.finer)
