"""What finer grids about the minimum film thickness of starved contacts leave of its error.

Random starved scenes without heat (even numbers; `tests/hard/draws.py`) whose layer is thinner than THINNEST
of the flooded film are solved on grids of halving spacing up to MOST_NODES. For each grid: the minimum on it,
that by finer grids about it (`pyworm.solver.point.local_grids`) with its error, and its deviation from
that by the finest grid over the errors of both. From the repository's root:

    python benchmarks/accuracy/local_grids.py [COUNT [SEED]]
"""

import sys
from pathlib import Path

import pyworm
from pyworm.case.case import case_of
from pyworm.solver.error_estimate import Reading
from pyworm.solver.point.contact import PointContactSolver

sys.path.append(str(Path(__file__).parents[2] / "tests" / "hard"))
from draws import SEED, starved

ACCURACY = 0.05
MOST_NODES = 4_000_000
THINNEST = 0.4


def readings(number: int, seed: int) -> list[tuple[int, float, Reading]]:
    """Nodes, minimum and reading of each grid of a scene; none of a thicker layer."""
    drawn = starved(number, seed)
    if drawn.traits["supply_ratio"] > THINNEST:
        return []
    scene = case_of(drawn.tables, "starved", Path()).scene()
    plan = pyworm.plan(scene, ACCURACY, ("isothermal", "starvation"))
    solver = PointContactSolver(plan.simplified(scene), plan)
    level, _ = solver.begin(plan.grids)
    found = []
    while True:
        reading = solver.converged(level, plan, ACCURACY).reading
        found.append((level.grid.nodes, level.read().film_min, reading))
        if level.grid.finer().nodes > MOST_NODES:
            return found
        level, _ = solver.refined(level)


def main(count: int, seed: int) -> None:
    """Print the table."""
    print("scene      nodes   on grid / finest   finer grids / finest   error   deviation / errors")
    for number in range(0, 2 * count, 2):
        found = readings(number, seed)
        for nodes, on_grid, reading in found[:-1]:
            (*_, (_, _, finest)) = found
            error, finest_error = (one.left.get("film_min", 0.0) for one in (reading, finest))
            off = reading.film_min / finest.film_min - 1
            print(
                f"{seed}:{number:<4} {nodes:8} {on_grid / finest.film_min:12.3f} "
                f"{1 + off:20.3f} {error:14.1%} {abs(off) / max(error + finest_error, 1e-9):12.2f}",
                flush=True,
            )


if __name__ == "__main__":
    main(*(int(text) for text in (*sys.argv[1:], *("50", str(SEED))[len(sys.argv) - 1 :])))
