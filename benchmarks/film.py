"""What a film costs: whole solves to a residual of 1e-6 on 257 x 257 nodes, in padded FFT convolutions.

A convolution on the finest grid, timed in the same run, is the unit; coarser and outer grids are included,
and so is the sampling of the scene. Run from the repository's root:

    python benchmarks/film.py [CASE.toml ...]
"""

import sys
from dataclasses import replace
from pathlib import Path

import pyworm
from pyworm.effects import Plan
from pyworm.grid import nest
from pyworm.scales import scales
from pyworm.scene import Scene
from pyworm.solution import Solution
from pyworm.window import FAR, near_reach, window

COARSEST = 64
TOLERANCE = 1e-6
CASES = (
    "point_m20_l10",
    "point_m100_l10",
    "point_m200_l10",
    "mourier_2006",
    "ellipse10_across",
    "ellipse10_along",
    "ellipse10_oblique",
    "point_m1000_l10",
    "point_m200_l20",
    "ellipse30_along",
    "spin_zi_like",
)


def on_window(scene: Scene) -> Plan:
    """Grids of the scene's own window, from COARSEST cells along each direction; the window is not judged."""
    size = scales(scene)
    inner, outer = (window(scene, size, reach) for reach in (near_reach(size), FAR))
    spacing = ((inner[1] - inner[0]) / COARSEST, (inner[3] - inner[2]) / COARSEST)
    return replace(
        pyworm.plan(scene),
        grids=nest(inner, outer, *spacing),
        wider_grids=(),
        tolerance=TOLERANCE,
    )


def solved(case: Path) -> Solution:
    """The case's scene on grids that climb to four times COARSEST cells a side over its window."""
    scene = pyworm.load(case).scene()
    plan = on_window(scene)
    first = plan.grids[-1]
    return pyworm.solve(scene, replace(plan, largest_grid=first.finer().finer().nodes))


def main() -> None:
    cases = [Path(name) for name in sys.argv[1:]] or [Path(f"cases/{name}.toml") for name in CASES]
    print(
        f"{'case':20} {'grid':>11} {'seconds':>8} {'convolutions':>12} {'residual':>9} {'krylov':>6}"
    )
    for case in cases:
        solution = solved(case)
        nx, ny = solution.fields.sizes["x"], solution.fields.sizes["y"]
        on_finest = (solution.history.points_x == nx) & (solution.history.points_y == ny)
        print(
            f"{case.stem:20} {nx:>5} x {ny:<3} {solution.cost.seconds:8.2f} "
            f"{solution.cost.convolutions:12.0f} {solution.figures.residual:9.1e} "
            f"{int(solution.history.krylov[on_finest].sum()):6}"
        )


if __name__ == "__main__":
    main()
