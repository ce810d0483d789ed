"""What a second thread and finer grids do to a whole solve of (M, L) = (200, 10), to a residual of 1e-6.

Run from the repository's root, once for each number of threads:

    OMP_NUM_THREADS=2 python benchmarks/cost/threads.py

Equal digests mean equal pressures to the last bit.
"""

import hashlib
import os
import resource
import sys
from dataclasses import replace
from pathlib import Path

from film import on_window

import pyworm

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

NODES = (129, 257, 513, 1025)


def main() -> None:
    scene = pyworm.load(Path("cases/point_m200_l10.toml")).scene()
    rows = []
    for nodes in NODES:
        plan = replace(on_window(scene, "all"), largest_grid=nodes**2)
        solution = pyworm.solve(scene, plan)
        shape = solution.fields.sizes["x"], solution.fields.sizes["y"]
        # kilobytes, of the process at its largest so far: Python's own share counts most on the first grids
        arrays = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / 8 / shape[0] / shape[1]
        digest = hashlib.sha256(solution.fields.pressure.values.tobytes()).hexdigest()[:12]
        rows.append(
            (
                os.environ["OMP_NUM_THREADS"],
                f"{shape[0]} x {shape[1]}",
                f"{solution.cost.seconds:.2f}",
                f"{solution.cost.convolutions:.0f}",
                f"{arrays:.0f}",
                digest,
            )
        )
    columns = "time / s", "convolutions", "arrays of the grid", "digest"
    record("threads", ("threads", "nodes", *columns), rows, key=("threads",))


if __name__ == "__main__":
    main()
