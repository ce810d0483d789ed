"""Whether sweeps whose films come by formula keep the accuracy asked for, and what they save.

    python benchmarks/accuracy/films_by_formula.py [COUNT]

Contacts of steel and a mineral oil with heat and a flow law are drawn at random until films of COUNT of them
need no solve at 10 % (`pyworm.planning.by_formula`). Each is solved at 1 %, with the effects that this asks
for; a film is within the accuracy if it is off by no more, to the solve's own bar.
"""

import sys
import warnings
from math import cos, exp, log, pi, sin
from time import process_time

import numpy as np
from plan_scenes import STEEL, mineral

import pyworm
from pyworm.formulas.hertz import hertz
from pyworm.planning.by_formula import films_by_formula
from pyworm.scene.point import Paraboloid, RigidMotion, Scene

ACCURACIES, EXACT = (0.05, 0.07, 0.1), 0.01

FILM = ("film",)

SEED = 28

RANGES = {
    "radius": (0.003, 0.05),
    "ratio": (1.0, 20.0),
    "pressure": (0.3e9, 1.5e9),
    "speed": (0.02, 1.0),
    "viscosity": (0.01, 0.3),
    "alpha": (10e-9, 25e-9),
}
"""Smaller radius [m], larger over smaller radius, Hertz's pressure [Pa], speed [m/s], viscosity [Pa s] and
its pressure coefficient [1/Pa], evenly in the logarithm."""

MOST_SLIP = 0.1
"""Largest ratio of sliding to entrainment."""


def drawn(random: np.random.Generator) -> Scene:
    """A contact entrained at any angle."""
    of = {name: exp(random.uniform(log(low), log(high))) for name, (low, high) in RANGES.items()}
    angle, slip = random.uniform(0, pi / 2), random.uniform(0, MOST_SLIP)
    radii = of["radius"], of["ratio"] * of["radius"]
    modulus = STEEL.youngs_modulus / (1 - STEEL.poisson_ratio**2)
    motions = tuple(
        RigidMotion(
            *(of["speed"] * (1 + side * slip / 2) * part for part in (cos(angle), sin(angle)))
        )
        for side in (1, -1)
    )
    return Scene(
        name=f"{of['pressure'] / 1e9:.2g} GPa, {of['speed']:.2g} m/s, {of['ratio']:.2g}, {angle:.2g}",
        gap=Paraboloid(*radii),
        radii=radii,
        motions=motions,
        load=(of["pressure"] / hertz(*radii, 1.0, modulus).pressure_max) ** 3,
        bodies=(STEEL, STEEL),
        oil=mineral(of["viscosity"], of["alpha"]),
    )


def main(count: int) -> None:
    """Print how many films by formula are within each accuracy, and the times of both ways."""
    warnings.simplefilter("ignore", pyworm.UnusualWarning)
    random = np.random.default_rng(SEED)
    rows, seconds, tried = [], np.zeros(3), 0
    while len(rows) < count:
        scene = drawn(random)
        tried += 1
        started = process_time()
        enough = [
            films_by_formula(scene, pyworm.plan(scene, accuracy, "auto", FILM))
            for accuracy in ACCURACIES
        ]
        planned = process_time()
        if enough[-1] is None:
            continue
        pyworm.solve(scene, pyworm.plan(scene, ACCURACIES[-1], "auto", FILM))
        coarse = process_time()
        exact = pyworm.solve(scene, pyworm.plan(scene, EXACT, "auto", FILM))
        if not exact.converged:
            print(f"{scene.name}: no reference, {exact.stop_reason}")
            continue
        seconds += (planned - started) / len(ACCURACIES), coarse - planned, process_time() - coarse
        films = exact.figures.film_central, exact.figures.film_min
        off = [
            max(abs(float(by) / of.value - 1) - of.error, 0.0)
            for by, of in zip((enough[-1].central, enough[-1].minimum), films, strict=True)
        ]
        rows.append((*off, [of is not None for of in enough]))
        print(f"{scene.name}: off by {off[0]:.1%} and {off[1]:.1%}, {rows[-1][2]}", flush=True)
    print(f"{len(rows)} of {tried} contacts need no solve at {ACCURACIES[-1]:.0%}")
    for which, accuracy in enumerate(ACCURACIES):
        of = np.array([row[:2] for row in rows if row[2][which]])
        if of.size:
            within = (of <= accuracy).mean(axis=0)
            middle, most = np.median(of, axis=0), of.max(axis=0)
            print(f"{accuracy:.0%}: {len(of)} by formula; h_c, h_min within it:", *within)
            print(
                f"  medians {middle[0]:.1%}, {middle[1]:.1%}, largest {most[0]:.1%}, {most[1]:.1%}"
            )
    each = seconds / len(rows)
    print(f"processor a contact: plan and formula {each[0] * 1e3:.0f} ms, solve at ", end="")
    print(f"{ACCURACIES[-1]:.0%} {each[1]:.2f} s, at {EXACT:.0%} {each[2]:.2f} s")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 60)
