"""What heat and rheology cost: the full model against the isothermal Newtonian film of one scene and grid.

Whole solves up to about 257 x 257 nodes, on the grids of `film.py` and one thread, with the levels that 1 %
needs; at the residual of 1 % and at 1e-6. Times are processor times without the sampling of the
scene, which both models share; the parts are those that the kernel counts, the flow with its rheology and the
sweeps of heat among them, and all else, which is Python and the setting up. Then the full model up
the grids to 1e-3 on one and on two threads, by the clock: the whole, and on the finest grid a sweep of heat,
and a residual without its convolution, which is rheology; that says something only while the machine has two
cores to spare. Run from the repository's root:

    python benchmarks/cost/heat_cost.py
"""

import hashlib
import json
import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from time import perf_counter

import numpy as np
from film import PARTS, refined

import pyworm
from pyworm.scene.point import Scene
from pyworm.solver.newton import iterate
from pyworm.solver.point.contact import PointContactSolver
from pyworm.solver.solution import Solution

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

HALVINGS = 2
TOLERANCES = (1e-3, 1e-6)
REPEATS = 15
"""Times that a part is timed on the finest grid; the least is shown, since others use the machine too."""


def worm() -> Scene:
    """The worm at mid-mesh."""
    return pyworm.load(Path("cases/zi_sharif_2001.toml")).scene(phase=0.5)


def steel(ratio: float) -> Scene:
    """Steel on steel at 1 GPa."""
    return pyworm.load(Path("cases/traction_steel.toml")).scene(slide_roll_ratio=ratio)


SCENES: dict[str, Callable[[], Scene]] = {
    "worm, phase 0.5": worm,
    "steel, ratio 0.5": lambda: steel(0.5),
    "steel, ratio 2": lambda: steel(2.0),
}


def remembering(scene: Scene) -> Scene:
    """The scene, its gap and motions sampled once on each grid."""

    def once(sample: Callable) -> Callable:
        known = {}

        def recall(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
            places = np.asarray(x).tobytes(), np.asarray(y).tobytes()
            if places not in known:
                known[places] = sample(x, y)
            return known[places]

        return recall

    first, second = scene.motions
    return replace(scene, gap=once(scene.gap), motions=(once(first), once(second)))


def cost(solution: Solution) -> tuple[float, list[float]]:
    """Processor time [s], and its parts."""
    whole = solution.cost.convolutions * solution.cost.unit_seconds
    parts = [float(solution.history[part].sum()) for part in (*PARTS, "heat_seconds")]
    return whole, [*parts, whole - sum(parts)]


COLUMNS = (
    "contact",
    "residual",
    "isothermal",
    "thermal",
    "ratio",
    "FFT / s",
    "flow and rheology / s",
    "cycle and vectors / s",
    "heat / s",
    "rest / s",
    "steps",
)


def compare(name: str, tolerance: float) -> tuple[str, ...]:
    """What both models cost and how many times the thermal one is dearer, under `COLUMNS`."""
    scene = remembering(SCENES[name]())
    plans = {
        effects: replace(refined(scene, HALVINGS, effects), tolerance=tolerance)
        for effects in ("isothermal", ("all", "-roughness", "-squeeze"))
    }
    pyworm.solve(scene, plans["isothermal"])  # samples the scene
    cold, _ = cost(pyworm.solve(scene, plans["isothermal"]))
    solution = pyworm.solve(scene, plans[("all", "-roughness", "-squeeze")])
    whole, (convolutions, flow, cycle, vectors, heat, rest) = cost(solution)
    parts = (f"{part:.2f}" for part in (convolutions, flow, cycle + vectors, heat, rest))
    times = f"{cold:.2f} s", f"{whole:.2f} s", f"{whole / cold:.1f}"
    return name, f"{tolerance:.0e}", *times, *parts, f"{solution.history.sizes['iteration']}"


def least(work: Callable[[], object]) -> float:
    """Least elapsed time [s] of a piece of work."""
    times = []
    for _ in range(REPEATS):
        started = perf_counter()
        work()
        times.append(perf_counter() - started)
    return min(times)


def refine(name: str) -> dict[str, float | str]:
    """Elapsed times [s] with this process's threads, and a digest of pressure and temperature."""
    scene = remembering(SCENES[name]())
    plan = refined(scene, HALVINGS)
    PointContactSolver(scene, plan).begin(plan.grids)  # samples the scene, most of it
    solver = PointContactSolver(scene, plan)
    started = perf_counter()
    level, _ = solver.begin(plan.grids)
    for _ in range(HALVINGS):
        iterate(level, TOLERANCES[0])
        level, _ = solver.refined(level)
    iterate(level, TOLERANCES[0])
    whole = perf_counter() - started
    film = level.film
    held = np.concatenate([film.pressure.ravel(), film.rise().ravel()])
    digest = hashlib.sha256(held.tobytes()).hexdigest()
    convolution = least(film.convolve)
    residual = least(film.restart)
    return {
        "whole": whole,
        "rheology": residual - convolution,
        "sweep of heat": least(film.warm),
        "digest": digest,
    }


def with_threads(name: str, threads: int) -> dict[str, float | str]:
    """The same in a process of its own."""
    done = subprocess.run(
        [sys.executable, __file__, "refine", name],
        env=os.environ | {"OMP_NUM_THREADS": str(threads)},
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(done.stdout)


def main() -> None:
    if sys.argv[1:2] == ["refine"]:
        print(json.dumps(refine(sys.argv[2])))
        return
    record("heat_cost", COLUMNS, [compare(name, of) for of in TOLERANCES for name in SCENES])
    for name in SCENES:
        one, two = (with_threads(name, threads) for threads in (1, 2))
        times = ", ".join(
            f"{part} {one[part]:.3g} s, {one[part] / two[part]:.2f} times as fast on two"
            for part in ("whole", "rheology", "sweep of heat")
        )
        same = "the same bits" if one["digest"] == two["digest"] else "OTHER BITS"
        print(f"{name:18} {times}; {same}", flush=True)


if __name__ == "__main__":
    main()
