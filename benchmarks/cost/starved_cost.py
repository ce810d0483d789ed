"""What a limited supply of oil costs: processor time of starved films over that of flooded ones.

Each contact at 1 %, with plenty of oil and with layers of some times the flooded film: whole solves, with
all grids and windows that the accuracy asks for and the flooded film that a starved one is compared with.
Run from the repository's root:

    python benchmarks/cost/starved_cost.py
"""

import sys
from dataclasses import replace
from pathlib import Path
from time import process_time

import pyworm

sys.path.append(str(Path(__file__).parents[1] / "validation"))

from starvation import CONTACTS, scene_of

RATIOS = (0.3, 1.0, 3.0)
ACCURACY = 0.01


def sliding(scene: pyworm.Scene) -> pyworm.Scene:
    """The contact with heat and shear thinning, at half as much sliding as rolling."""
    oil = pyworm.named_oil("PAO VG 220").oil(333.15)
    return replace(
        scene, oil=oil, motions=(pyworm.RigidMotion(0.625, 0), pyworm.RigidMotion(0.375, 0))
    )


def solved(scene: pyworm.Scene, effects: tuple[str, ...]) -> tuple[pyworm.Solution, float]:
    """A solution and the processor time of its solve [s]."""
    plan = pyworm.plan(scene, ACCURACY, effects)
    started = process_time()
    return pyworm.solve(scene, plan), process_time() - started


def compare(name: str, scene: pyworm.Scene, effects: tuple[str, ...]) -> None:
    """Print the cost of one contact at each supply over that with plenty of oil."""
    solved(scene, effects)  # imports and tables
    flooded, seconds = solved(scene, effects)
    film = flooded.figures.film_central.value
    print(f"| {name} | flooded | {flooded.history.sizes['iteration']} | {seconds:.2f} | | |")
    for ratio in RATIOS:
        fed = replace(scene, oil=replace(scene.oil, supply=1.1 * ratio * film))
        starved, own = solved(fed, (*effects, "starvation"))
        steps = starved.history.sizes["iteration"]
        left = "" if starved.converged else starved.stop_reason
        print(
            f"| {name} | {ratio:g} | {steps} | {own:.2f} | {own / seconds:.2f} | {left} |",
            flush=True,
        )


def main() -> None:
    """Measure and print all."""
    print("| contact | supply | Newton steps | s | over flooded | |")
    print("|---|---|---|---|---|---|")
    for name in CONTACTS:
        compare(name, scene_of(name), ("isothermal",))
    compare(
        "sliding ball with heat",
        sliding(scene_of("ball")),
        ("all", "-squeeze", "-roughness", "-starvation"),
    )


if __name__ == "__main__":
    main()
