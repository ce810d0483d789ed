"""What mixed lubrication costs: Newton steps and processor time of rough films over those of smooth ones.

The worm at mid-mesh and steel on steel, thermal, on the same grids with the same tolerance, with a roughness
by which the expected film over it is each of some lambda ratios. Times are processor times of one run: of
the kernel in its Newton steps, and of whole solves, which contain the bar of the roughness model, some Newton
steps of each of its variations on one grid. Run from the repository's root:

    python benchmarks/cost/rough_cost.py
"""

import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from time import process_time

from film import refined
from heat_cost import SCENES, cost, remembering

import pyworm
from pyworm.scene.point import Scene
from pyworm.scene.scales import scales

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

LAMBDAS = (0.3, 0.5, 1.0, 2.0, 3.0)
HALVINGS = 1
TOLERANCE = 1e-3


def rough(scene: Scene, ratio: float) -> Scene:
    """The scene between surfaces of equal roughness with a lambda ratio."""
    each = scales(replace(scene, smooth=True)).film / ratio / 2**0.5
    return replace(scene, bodies=tuple(replace(body, roughness=each) for body in scene.bodies))


def solved(scene: Scene, effects: str | tuple[str, ...]) -> tuple[int, float, float]:
    """Newton steps, processor time of the kernel in them and of the whole solve [s]."""
    plan = replace(refined(scene, HALVINGS, effects), tolerance=TOLERANCE)
    started = process_time()
    solution = pyworm.solve(scene, plan)
    whole = process_time() - started
    kernel = sum(cost(solution)[1][:-1])
    return solution.history.sizes["iteration"], kernel, whole


def compare(name: str) -> Iterator[tuple[str, ...]]:
    """Steps and time of one contact at each lambda over those without roughness."""
    scene = remembering(SCENES[name]())
    smooth = solved(scene, ("all", "-squeeze", "-roughness"))  # samples the scene
    smooth = solved(scene, ("all", "-squeeze", "-roughness"))
    yield name, "smooth", f"{smooth[0]}", "", f"{smooth[1]:.2f}", "", f"{smooth[2]:.2f}", ""
    for ratio in LAMBDAS:
        found = solved(rough(scene, ratio), ("all", "-squeeze"))
        over = [f"{value / base:.2f}" for value, base in zip(found, smooth, strict=True)]
        steps, seconds, whole = found
        times = f"{seconds:.2f}", over[1], f"{whole:.2f}", over[2]
        yield name, f"{ratio:g}", f"{steps}", over[0], *times


def main() -> None:
    steps = "Newton steps", "steps / smooth"
    times = "kernel / s", "kernel / smooth", "whole / s", "whole / smooth"
    rows = [row for name in SCENES for row in compare(name)]
    record("rough_cost", ("contact", "lambda", *steps, *times), rows)


if __name__ == "__main__":
    main()
