"""What a film costs: whole solves in padded FFT convolutions, where the time goes, how that grows.

A convolution on the finest grid, timed in the same run, is the unit; coarser and outer grids are included, so
is the sampling of the scene. The split is of processor time: convolutions; fields and flows; the
preconditioner; the vectors of GMRES; all else, which is Python, sampling and setting up. Beside it is what no
clock can change: the convolutions counted on the finest grid, and those on all grids in units of that, by
their nodes. Run from the repository's root:

    python benchmarks/cost/film.py                      the cases at 1 %, and to 1e-6 on about 257 x 257 nodes
    python benchmarks/cost/film.py growth [CASE ...]    to 1e-6 on about 129, 257, 513 and 1025 nodes a side
"""

import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from statistics import median

import pyworm
from pyworm.planning.grid import nest
from pyworm.planning.plan import Plan
from pyworm.planning.window import OUTERMOST_REACH, near_reach, windows
from pyworm.scene.point import Scene
from pyworm.scene.scales import scales
from pyworm.solver.solution import Solution

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

COARSEST = 64
TOLERANCE = 1e-6
UNREACHED = 1e-4
"""Accuracy that no grid of these reaches, so that the last one is solved."""
CASES = (
    "point_m20_l10",
    "point_m100_l10",
    "point_m200_l10",
    "point_m1000_l10",
    "point_m200_l20",
    "mourier_2006",
    "ellipse10_across",
    "ellipse10_along",
    "ellipse10_oblique",
    "ellipse30_along",
    "spin_zi_like",
)
REPEATS = 3
"""Solves of which the median is told, on up to ONCE_NODES nodes; beyond them one."""
ONCE_NODES = 300_000
PARTS = ("convolution_seconds", "flow_seconds", "cycle_seconds", "vector_seconds")


def on_window(scene: Scene, effects: str) -> Plan:
    """Grids of the scene's own window, from COARSEST cells along each direction; the window is not judged."""
    size = scales(scene)
    inner, outer = windows(scene, size, near_reach(size), OUTERMOST_REACH)
    spacing = ((inner[1] - inner[0]) / COARSEST, (inner[3] - inner[2]) / COARSEST)
    return replace(
        pyworm.plan(scene, effects=effects),
        grids=nest(inner, outer, *spacing),
        wider_grids=(),
        tolerance=TOLERANCE,
        accuracy=UNREACHED,
    )


def refined(scene: Scene, times: int, effects: str = "all") -> Plan:
    """The same, the first grid of the figures halved so often."""
    plan = on_window(scene, effects)
    finest = plan.grids[-1]
    for _ in range(times):
        finest = finest.finer()
    return replace(plan, largest_grid=finest.nodes)


def row(to: str, name: str, scene: Scene, plan: Plan) -> tuple[str, ...]:
    """A row under `COLUMNS`."""
    solutions = [pyworm.solve(scene, plan)]
    nodes = solutions[0].fields.sizes["x"] * solutions[0].fields.sizes["y"]
    if nodes <= ONCE_NODES:
        solutions += [pyworm.solve(scene, plan) for _ in range(REPEATS - 1)]
    solution = solutions[0]
    history = solution.history
    size = history.points_x * history.points_y
    on_finest = int(history.convolutions[size == nodes].sum())
    on_all = float((history.convolutions * size).sum()) / nodes
    costs = [solution.cost for solution in solutions]
    whole = median(cost.convolutions for cost in costs)
    shape = f"{solution.fields.sizes['x']} x {solution.fields.sizes['y']}"
    return (
        to,
        name,
        shape,
        f"{median(cost.seconds for cost in costs):.2f}",
        f"{whole:.0f}",
        *(f"{part * whole:.0f}" for part in split(solution)),
        f"{on_finest}",
        f"{on_all:.0f}",
        f"{int(history.krylov[size == nodes].sum())}",
    )


def split(solution: Solution) -> Iterator[float]:
    """Shares of the processor time: the parts, and all else."""
    total = solution.cost.convolutions * solution.cost.unit_seconds
    shares = [float(solution.history[part].sum()) / total for part in PARTS]
    yield from shares
    yield 1 - sum(shares)


COLUMNS = (
    "to",
    "case",
    "grid",
    "seconds",
    "convolutions",
    "FFT",
    "flow",
    "preconditioner",
    "vectors",
    "rest",
    "counted on the finest grid",
    "counted on all grids",
    "Krylov iterations",
)
GROWTH = "case", "nodes on a side", "convolutions", "counted on all grids"


def main() -> None:
    words = sys.argv[1:]
    cases = words[1:] or CASES[:5] if words[:1] == ["growth"] else CASES
    scenes = {case: pyworm.load(Path(f"cases/{case}.toml")).scene() for case in cases}
    rows = []
    if words[:1] == ["growth"]:
        for case, scene in scenes.items():
            for times, nodes in zip((1, 2, 3, 4), (129, 257, 513, 1025), strict=True):
                found = row("", case, scene, refined(scene, times))
                rows.append((case, nodes, found[4], found[11]))
                print(*rows[-1], flush=True)
        record("film_growth", GROWTH, rows)
        return
    for case, scene in scenes.items():
        rows.append(row("1 %", case, scene, pyworm.plan(scene, effects="all")))
        rows.append(row(f"residual {TOLERANCE:g}", case, scene, refined(scene, 2)))
        print(*rows[-2], flush=True)
    record("film_cost", COLUMNS, sorted(rows))


if __name__ == "__main__":
    main()
