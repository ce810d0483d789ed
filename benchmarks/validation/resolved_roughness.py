"""Averaged against resolved roughness: one small contact with the rough surface at rest.

A smooth surface slides over a rough one that stands still, so that the film between them is steady and the
heights of the rough surface can be part of the gap. Its mean over the middle of the contact is set beside the
film by averaged flow, which knows the height of the roughness alone. Isothermal and Newtonian, as thick as
surfaces must be for that not to touch. Run from the repository's root (a few minutes):

    python benchmarks/validation/resolved_roughness.py
"""

import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import scipy

import pyworm
from pyworm.scene.point import Scene
from pyworm.scene.scales import scales
from pyworm.solver.solution import Solution
from pyworm.surfaces.generated import gaussian

sys.path.append(str(Path(__file__).parents[1] / "accuracy"))
from plan_scenes import STEEL, mineral, point

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

RADIUS, LOAD, SPEED = 0.02, 50.0, 1.0
LAMBDAS = (8.0, 5.0)
SEEDS = range(6)
WAVES = 5
"""Hertz radius over the distance at which the autocorrelation of the heights has fallen to 0.1."""

ROUGHEST_SMOOTH = 2e-10
"""Roughness of the surface that is as good as smooth [m]."""

ACCURACY = 0.05
MIDDLE = 0.5
"""Radius of the part of the contact over which films are averaged, over Hertz's."""


def contact() -> Scene:
    """A smooth ball that slides over a disc at rest."""
    moving, resting = (2 * SPEED, 0.0), (0.0, 0.0)
    oil = mineral(0.09, 2e-8)
    return point("disc at rest", (RADIUS,) * 2, LOAD, (moving, resting), (STEEL, STEEL), oil)


def rough_gap(heights: Callable) -> Callable:
    """The gap with heights of the resting surface [m] in it."""

    def gap(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return (x**2 + y**2) / (2 * RADIUS) + heights(x, y), np.ones(np.shape(x), dtype=bool)

    return gap


def surface(roughness: float, length: float, seed: int) -> Callable:
    """Heights [m] at places [m] of a generated surface that repeats itself."""
    made = gaussian(roughness, length, seed=seed)
    extent = [n * step for n, step in zip(made.height.shape, made.spacing, strict=True)]
    around = np.pad(made.height, 4, mode="wrap")
    axes = [(np.arange(n) - 4) * step for n, step in zip(around.shape, made.spacing, strict=True)]
    spline = scipy.interpolate.RectBivariateSpline(*axes, around)
    return lambda x, y: spline(np.mod(x, extent[0]), np.mod(y, extent[1]), grid=False)


def resolved(scene: Scene, heights: Callable) -> Solution:
    """The film with the heights in its gap."""
    rough = replace(scene, gap=rough_gap(heights))
    return pyworm.solve(rough, pyworm.plan(rough, ACCURACY, "isothermal", ("film",)))


def middle_film(solution: Solution, radius: float) -> float:
    """Mean film [m] within a radius [m]."""
    fields = solution.fields
    return float(fields.film.where(fields.x**2 + fields.y**2 < radius**2).mean())


def averaged(scene: Scene, roughness: float) -> tuple[float, float]:
    """Central film [m] by averaged flow, and the bar of its model [-]."""
    first, second = scene.bodies
    bodies = replace(first, roughness=ROUGHEST_SMOOTH), replace(second, roughness=roughness)
    rough = replace(scene, bodies=bodies)
    solution = pyworm.solve(rough, pyworm.plan(rough, 0.01, ("isothermal", "roughness"), ("film",)))
    found = solution.figures.film_central
    return found.value, found.model


def main() -> None:
    scene = contact()
    sizes = scales(scene)
    hertz = sizes.hertz.semi_axis_x
    length = hertz / WAVES
    smooth = pyworm.solve(scene, pyworm.plan(scene, ACCURACY, "isothermal", ("film",)))
    base = middle_film(smooth, MIDDLE * hertz)
    rows = []
    for ratio in LAMBDAS:
        roughness = sizes.film / ratio
        film, model = averaged(scene, roughness)
        solutions = [resolved(scene, surface(roughness, length, seed)) for seed in SEEDS]
        found = [one for one in solutions if one.converged]
        changes = [middle_film(one, MIDDLE * hertz) / base - 1 for one in found]
        lost = len(solutions) - len(found)
        least = min(one.figures.film_min.value for one in found) / roughness
        change = film / smooth.figures.film_central.value - 1
        rows.append(
            (
                f"{ratio:g}",
                f"{change * 100:+.1f} %",
                f"{model * 100:.1f} %",
                f"{np.mean(changes) * 100:+.1f} %",
                f"{min(changes) * 100:+.1f} to {max(changes) * 100:+.1f} %",
                lost,
                f"{least:.2f}",
            )
        )
    averaged_columns = "averaged flow", "model uncertainty of it"
    resolved_columns = "resolved: mean", "resolved: range", "not found", "h_min / roughness"
    record("resolved_roughness", ("lambda", *averaged_columns, *resolved_columns), rows)


if __name__ == "__main__":
    main()
