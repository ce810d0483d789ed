"""Stability: small causes have small effects, and neither the start, the grid nor the side matters.

Each check takes what to tell its rows to and returns what is wrong, nothing if all is well.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import islice
from math import log
from pathlib import Path
from typing import Any

import numpy as np
from draws import DRAWS
from named import ISOTHERMAL, contact

import pyworm
from pyworm.case.case import case_of
from pyworm.planning.plan import Plan
from pyworm.scene.point import Paraboloid, Scene
from pyworm.scene.scales import scales
from pyworm.solver.error_estimate import Reading, grid_errors
from pyworm.solver.newton import converge
from pyworm.solver.point.contact import ORDERS, PointContactSolver
from pyworm.solver.point.level import PointLevel, restart
from pyworm.solver.solution import Solution

Tell = Callable[[str], None]

FILMS = ("film_min", "film_central")

NUDGE = 1e-3
"""Relative change of an input that must not move a film by a jump."""

STEEPEST = 2.0
"""Largest response: relative change of a film over that of an input."""

CURVED = (0.1, 0.01)
"""Largest second difference of the minimum and of the central film between three neighbouring solves, over
the relative change of the input: by how much the response may differ from one to the next."""

RESOLVED = 0.05
"""Relative error by the grid from which a film's responses are its own, and not the grid's."""

SETTLED = 1e-7
"""Relative error of films by unfinished algebra, where solves are compared on one grid."""

ALIKE = 1e-6
"""Relative difference that first guesses may leave on one grid."""

BENT = 0.3
"""Largest kink of a curve: by how much more the slope, in decades over decades, may change at one point than
on average beside it. Where it changes by more it is looked at more closely, since a kink stays what it is."""

CLOSER = 8
"""By how much more closely."""


def scene_of(tables: dict[str, Any], name: str = "stability") -> Scene:
    """The scene of a case file's content."""
    return case_of(tables, name, Path()).scene()


def nudges(scene: Scene) -> dict[str, Callable[[float], Scene]]:
    """What makes a scene with one input times a factor."""

    law = scene.oil.viscosity

    def oil(**changes: float) -> Scene:
        return replace(scene, oil=replace(scene.oil, viscosity=replace(law, **changes)))

    def moving(factor: float) -> Scene:
        return replace(
            scene,
            motions=tuple(
                replace(motion, u=factor * motion.u, v=factor * motion.v)
                for motion in scene.motions
            ),
        )

    def curved(factor_x: float, factor_y: float) -> Scene:
        radii = factor_x * scene.radii[0], factor_y * scene.radii[1]
        return replace(scene, radii=radii, gap=Paraboloid(*radii))

    def elastic(factor: float) -> Scene:
        return replace(
            scene,
            bodies=tuple(
                replace(body, youngs_modulus=factor * body.youngs_modulus) for body in scene.bodies
            ),
        )

    return {
        "load": lambda factor: replace(scene, load=factor * scene.load),
        "speed": moving,
        "viscosity": lambda factor: oil(eta0=factor * law.eta0),
        "pressure-viscosity": lambda factor: oil(z=factor * law.z),
        "radius x": lambda factor: curved(factor, 1.0),
        "radius y": lambda factor: curved(1.0, factor),
        "Young's modulus": elastic,
    }


def films(solution: Solution) -> np.ndarray:
    """Minimum and central film [m]."""
    return np.array([getattr(solution.figures, name).value for name in FILMS])


def bars(solution: Solution) -> np.ndarray:
    """Their relative error bars."""
    return np.array([getattr(solution.figures, name).error for name in FILMS])


def steady(scene: Scene, accuracy: float = 0.02) -> Plan:
    """A plan with its first window only, solved so tightly that the error of the algebra is negligible."""
    return replace(pyworm.plan(scene, accuracy, "isothermal"), wider_grids=(), tolerance=1e-6)


HARD = ("M1000-L10", "M200-L20", "coarse-grid-lost", "alpha-p-60", "ellipse-30-oblique", "M2-L0.5")
"""Named scenes that are looked at closely; the last one's film is too thick to be found from a dry contact
on a fine grid."""


def grid_sequence(
    scene: Scene, plan: Plan, start: Callable[[PointLevel], None] | None = None
) -> Iterator[Reading]:
    """Readings of a scene on the plan's last grid and on ever finer ones; `start` changes the first guess."""
    solver = PointContactSolver(scene, plan)
    level, _ = solver.begin(plan.grids)
    if start is not None:
        start(level)
    while True:
        yield converge(level, plan.tolerance, plan.target, SETTLED).reading
        level, _ = solver.refined(level)


def resolved(scene: Scene, plan: Plan) -> list[Reading]:
    """Readings on the plan's last grid and on finer ones, up to the first that resolves both films."""
    readings: list[Reading] = []
    for reading in grid_sequence(scene, plan):
        readings.append(reading)
        errors = grid_errors(readings, ORDERS)
        if max(errors[name] for name in FILMS) < RESOLVED:
            break
    return readings


def fixed(
    scene: Scene, plan: Plan, grids: int, start: Callable[[PointLevel], None] | None = None
) -> np.ndarray:
    """Films on the last of so many grids [m]: the same grids whatever the scene."""
    reading = next(islice(grid_sequence(scene, plan, start), grids - 1, None))
    return np.array([reading.figures[name] for name in FILMS])


def small_changes(tell: Tell, names: tuple[str, ...] = HARD) -> Iterator[str]:
    """Any input 0.1 % larger or smaller: films change smoothly and by a bounded amount."""
    for name in names:
        scene = scene_of(ISOTHERMAL[name])
        plan = steady(scene)
        readings = resolved(scene, plan)
        base = np.array([readings[-1].figures[film] for film in FILMS])
        for what, nudged in nudges(scene).items():
            more, less = (fixed(nudged(1 + side * NUDGE), plan, len(readings)) for side in (1, -1))
            slope = (more - less) / (2 * NUDGE * base)
            bend = np.abs(more - 2 * base + less) / base / NUDGE
            tell(
                f"{name:20} {what:20} response {slope[0]:6.3f} {slope[1]:6.3f}, "
                f"bend {bend[0]:.4f} {bend[1]:.4f}"
            )
            if not (np.abs(slope) < STEEPEST).all() or not (bend < CURVED).all():
                yield f"{name}: {what} changed by 0.1 % moves films by a jump"


def first_guesses(tell: Tell, names: tuple[str, ...] = HARD) -> Iterator[str]:
    """A dry contact, half the pressure under a thicker film, a film of twice the speed: the same answer.

    Each is made on the plan's last grid, from which films go on to finer ones as in a solve.
    """
    for name in names:
        scene = scene_of(ISOTHERMAL[name])
        plan = steady(scene)
        grids = len(resolved(scene, plan))
        reached = [fixed(scene, plan, grids, start) for start in guesses(scene, plan)]
        spread = np.ptp(reached, axis=0) / np.mean(reached, axis=0)
        tell(f"{name:20} three first guesses differ by {spread[0]:.1e} {spread[1]:.1e}")
        if not (spread < ALIKE).all():
            yield f"{name}: three first guesses lead to films of {np.array(reached).tolist()} m"


def guesses(scene: Scene, plan: Plan) -> Iterator[Callable[[PointLevel], None]]:
    """What starts a level from each guess."""
    size = scales(scene)
    here, fast = (
        PointContactSolver(of, plan).begin(plan.grids)[0]
        for of in (scene, nudges(scene)["speed"](2.0))
    )
    for level in (here, fast):
        converge(level, plan.tolerance, plan.target, SETTLED)

    def started(pressure: np.ndarray, rigid_film: float) -> Callable[[PointLevel], None]:
        # on the outline it is the grid's boundary value, the same for all
        guess, met = pressure.copy(order="F"), here.film.pressure
        guess[[0, -1], :], guess[:, [0, -1]] = met[[0, -1], :], met[:, [0, -1]]
        return lambda level: level.film.start(guess, rigid_film)

    yield lambda level: restart(scene, size, level)
    yield started(here.film.pressure / 2, here.film.rigid_film + 2 * size.film)
    yield started(fast.film.pressure, fast.film.rigid_film)


SWEEPS: dict[str, Callable[[float], dict[str, Any]]] = {
    "load": lambda share: contact("sweep", 0.2 * share, (0.5, 0.0)),
    "speed": lambda share: contact("sweep", 20.0, (0.01 * share, 0.0)),
    "pressure-viscosity": lambda share: contact("sweep", 20.0, (0.5, 0.0), alpha=4e-11 * share),
    "ellipticity": lambda share: contact("sweep", 20.0, (0.5, 0.0), radii=(0.01, 4e-4 * share)),
}
"""What is swept -> the case file at a share from 1 to 1000."""


def sweeps(tell: Tell, points: int = 25) -> Iterator[str]:
    """Films over three decades of load, speed, pressure-viscosity and ellipticity: curves without kinks."""
    shares = np.geomspace(1, 1000, points)
    step = log(shares[1] / shares[0])
    for what, case in SWEEPS.items():
        solutions = []
        for share in shares:
            scene = scene_of(case(float(share)))
            solutions.append(pyworm.solve(scene, pyworm.plan(scene, 0.02, "isothermal")))
        if not all(solution.converged for solution in solutions):
            yield f"sweep of {what}: not all converged"
        curves = np.log([films(solution) for solution in solutions])
        slopes, kinks = np.diff(curves, axis=0) / step, kinks_of(curves, step)
        tell(
            f"sweep of {what:20} slope of the central film {slopes[0, 1]:6.3f} to {slopes[-1, 1]:6.3f}, "
            f"largest kink {kinks[:, 0].max():.3f} {kinks[:, 1].max():.3f}"
        )
        for at in np.flatnonzero(kinks.max(axis=1) >= BENT):
            middle = shares[at + 2]
            closely = closer(case, middle, step).max(axis=0)
            tell(
                f"{'':9}at {middle:.3g} of it, {CLOSER} times as closely, largest kink "
                f"{closely[0]:.3f} {closely[1]:.3f}"
            )
            if not (closely < BENT).all():
                yield f"sweep of {what}: a kink of {closely.max():.2f} in slope at {middle:.3g}"


def kinks_of(curves: np.ndarray, step: float) -> np.ndarray:
    """Kinks at all but two points at each end of logarithmic curves, shape (points, curves)."""
    bends = np.diff(curves, 2, axis=0) / step
    return np.abs(bends[1:-1] - (bends[:-2] + bends[2:]) / 2)


def closer(case: Callable[[float], dict[str, Any]], middle: float, step: float) -> np.ndarray:
    """Kinks of the films about a point of a sweep, all points solved on the same grids."""
    scene = scene_of(case(float(middle)))
    plan = steady(scene)
    grids = len(resolved(scene, plan))
    near = middle * np.exp(step * np.linspace(-1.5, 1.5, 3 * CLOSER + 1))
    curves = [fixed(scene_of(case(float(share))), plan, grids) for share in near]
    return kinks_of(np.log(curves), step / CLOSER)


MIRRORED = range(0, 40, 8)
"""Random scenes that are mirrored."""


def mirrors(tell: Tell, numbers: range = MIRRORED) -> Iterator[str]:
    """Scenes mirrored at the x axis have mirrored films."""
    for number in numbers:
        scene = scene_of(DRAWS["isothermal"](number).tables, f"isothermal:{number}")
        mirrored = replace(
            scene,
            motions=tuple(
                replace(motion, v=-motion.v, spin=-motion.spin) for motion in scene.motions
            ),
        )
        one, other = (
            pyworm.solve(of, pyworm.plan(of, 0.05, "isothermal")) for of in (scene, mirrored)
        )
        apart = np.abs(films(one) / films(other) - 1)
        tell(f"{scene.name:20} and its mirror image differ by {apart[0]:.1e} {apart[1]:.1e}")
        if not (apart <= bars(one) + bars(other)).all():
            yield f"{scene.name}: its mirror image has another film"


def limits(tell: Tell, names: tuple[str, ...] = HARD) -> Iterator[str]:
    """Finer grids move figures towards one limit: each bar holds the next ones' films."""
    for name in names:
        scene = scene_of(ISOTHERMAL[name])
        solved = [
            pyworm.solve(scene, pyworm.plan(scene, accuracy, "isothermal"))
            for accuracy in (0.05, 0.02, 0.01)
        ]
        best = films(solved[-1])
        off = [np.abs(films(one) / best - 1) for one in solved[:-1]]
        tell(
            f"{name:20} at 5 and 2 % off the films at 1 % by "
            + ", ".join(f"{of[0]:.1e} {of[1]:.1e}" for of in off)
        )
        for one, distance in zip(solved[:-1], off, strict=True):
            if not one.converged or not (distance <= bars(one) + bars(solved[-1])).all():
                yield f"{name}: an error bar does not hold the film of finer grids"


CHECKS = (small_changes, first_guesses, sweeps, mirrors, limits)
