"""Kernels of a wheel for levels of x86-64, side by side: speeds, bits from run to run, figures.

    python benchmarks/cost/levels.py

In an environment with a wheel (`make wheel`), not an installation from source, which has a single kernel.
Each level that this processor runs solves the cases in a process of its own, twice, in turns.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

from pyworm.kernel.levels import BASE, LEVEL_VARIABLE, built, processor, supported

CASES = Path(__file__).parents[2] / "cases"

SCENES = {
    "point contact, isothermal": ("point_m20_l10.toml", None, "2 %", "isothermal"),
    "worm teeth, thermal": ("zi_sharif_2001.toml", 0.5, "5 %", ("auto", "-squeeze")),
}
"""What is solved: case, phase, accuracy and effects."""

SOLVE = """
import json, sys, time
from hashlib import sha256
import pyworm
path, phase, accuracy, effects = json.loads(sys.argv[1])
case = pyworm.load(path)
scene = case.scene() if phase is None else case.scene(phase=phase)
plan = pyworm.plan(scene, accuracy, effects)
begun = time.process_time()
solution = pyworm.solve(scene, plan)
seconds = time.process_time() - begun
digest = sha256(b"".join(of.values.tobytes() for of in solution.fields.data_vars.values())).hexdigest()
figures = {name: (of.value, of.bar) for name, of in vars(solution.figures).items() if hasattr(of, "bar")}
print(json.dumps({"seconds": seconds, "digest": digest, "figures": figures}))
"""


def solved(level: str, what: tuple) -> dict:
    """Seconds, digest of the fields and figures of one solve with the kernel for a level."""
    case, *how = what
    one_thread = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    done = subprocess.run(
        [sys.executable, "-c", SOLVE, json.dumps([str(CASES / case), *how])],
        env=os.environ | one_thread | {LEVEL_VARIABLE: level},
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(done.stdout)


def farthest(one: dict, other: dict) -> float:
    """Largest difference of the figures, over both error bars."""
    return max(
        abs(value - other["figures"][name][0]) / (bar + other["figures"][name][1])
        for name, (value, bar) in one["figures"].items()
    )


def main() -> None:
    """Print a table for each scene."""
    levels = [level for level in supported(processor()) if level == BASE or level in built()]
    for name, what in SCENES.items():
        runs = [{level: solved(level, what) for level in levels} for _ in range(2)]
        print(f"{name}\n{'level':10} {'s':>6} {'times':>6}  same bits  difference over the bars")
        base = min(run[BASE]["seconds"] for run in runs)
        for level in levels:
            seconds = min(run[level]["seconds"] for run in runs)
            same = runs[0][level]["digest"] == runs[1][level]["digest"]
            off = farthest(runs[0][level], runs[0][BASE])
            print(
                f"{level:10} {seconds:6.2f} {base / seconds:6.2f}  {'yes' if same else 'NO':9}  {off:.1e}"
            )


if __name__ == "__main__":
    main()
