"""What mixed lubrication costs: Newton steps and processor time of rough films over those of smooth ones.

The worm at mid-mesh and steel on steel, thermal, on the same grids with the same tolerance, with a roughness
by which the expected film over it is each of some lambda ratios. Times are processor times of one run: of
the kernel in its Newton steps, and of whole solves, which contain the bar of the roughness model, some Newton
steps of each of its variations on one grid. Run from the repository's root:

    python benchmarks/cost/rough_cost.py
"""

from dataclasses import replace
from time import process_time

from film import refined
from heat_cost import SCENES, cost, remembering

import pyworm
from pyworm.scene.point import Scene
from pyworm.scene.scales import scales

LAMBDAS = (0.3, 0.5, 1.0, 2.0, 3.0)
HALVINGS = 1
TOLERANCE = 1e-3


def rough(scene: Scene, ratio: float) -> Scene:
    """The scene between surfaces of equal roughness with a lambda ratio."""
    each = scales(replace(scene, smooth=True)).film / ratio / 2**0.5
    return replace(scene, bodies=tuple(replace(body, roughness=each) for body in scene.bodies))


def solved(scene: Scene, effects: str) -> tuple[int, float, float]:
    """Newton steps, processor time of the kernel in them and of the whole solve [s]."""
    plan = replace(refined(scene, HALVINGS, effects), tolerance=TOLERANCE)
    started = process_time()
    solution = pyworm.solve(scene, plan)
    whole = process_time() - started
    kernel = sum(cost(solution)[1][:-1])
    return solution.history.sizes["iteration"], kernel, whole


def compare(name: str) -> None:
    """Print steps and time of one contact at each lambda over those without roughness."""
    scene = remembering(SCENES[name]())
    smooth = solved(scene, "all,-squeeze,-roughness")  # samples the scene
    smooth = solved(scene, "all,-squeeze,-roughness")
    print(f"| {name} | smooth | {smooth[0]} | | {smooth[1]:.2f} | | {smooth[2]:.2f} | |")
    for ratio in LAMBDAS:
        steps, seconds, whole = solved(rough(scene, ratio), "all,-squeeze")
        print(
            f"| {name} | {ratio:g} | {steps} | {steps / smooth[0]:.2f} | {seconds:.2f} | "
            f"{seconds / smooth[1]:.2f} | {whole:.2f} | {whole / smooth[2]:.2f} |",
            flush=True,
        )


def main() -> None:
    print(
        "| contact | lambda | Newton steps | over smooth | s | over smooth | with the model's bar |"
    )
    print("|---|---|---|---|---|---|---|")
    for name in SCENES:
        compare(name)


if __name__ == "__main__":
    main()
