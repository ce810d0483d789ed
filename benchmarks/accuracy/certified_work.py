"""The error of films on one grid, and the work of an accuracy that the error bars certify.

Isothermal contacts of `film.CASES`. First table: errors of the central and the minimum film on about 257 x
257 nodes, and of what is extrapolated from that grid and the coarser one, against the limit of grids of 513
and 1025 nodes a side, itself extrapolated; without the bars' wider windows. Second table: convolutions times
nodes on all grids, in millions, to accuracies of 1 and 0.1 %. Run from the repository's root:

    python benchmarks/accuracy/certified_work.py [CASE ...]
"""

import sys
from pathlib import Path

import pyworm
from pyworm.scene.point import Scene
from pyworm.solver.grid_limit import second_order_limit

sys.path.append(str(Path(__file__).parents[1] / "cost"))
from film import CASES, refined

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

FILMS = ("film_central", "film_min")
HALVINGS = 1, 2, 3, 4
"""Halvings of the first grid of 64 cells a side; the last two grids are the truth of the first two."""

ACCURACIES = 0.01, 0.001


def films_on_grids(scene: Scene) -> dict[str, list[float]]:
    """Central and minimum film [m] on grids of halving spacing."""
    solutions = [pyworm.solve(scene, refined(scene, times, "isothermal")) for times in HALVINGS]
    return {
        name: [getattr(solution.figures, name).on_grid for solution in solutions] for name in FILMS
    }


def errors(values: list[float]) -> tuple[float, float]:
    """Relative error on the second grid, and of the limit from the first two."""
    coarse, fine, *finest = values
    truth = second_order_limit(*finest)
    return abs(fine / truth - 1), abs(second_order_limit(coarse, fine) / truth - 1)


def work(scene: Scene, accuracy: float) -> str:
    """Convolutions times nodes [millions] to an accuracy, and whether it is reached."""
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy, "isothermal"))
    history = solution.history
    done = float((history.convolutions * history.points_x * history.points_y).sum()) / 1e6
    return f"{done:.1f}" + ("" if solution.converged else ", not reached")


def main() -> None:
    scenes = {
        case: pyworm.load(Path(f"cases/{case}.toml")).scene() for case in sys.argv[1:] or CASES
    }
    for case, scene in scenes.items():
        found = [error for values in films_on_grids(scene).values() for error in errors(values)]
        print(case, *(f"{error:.2g}" for error in found), flush=True)
    works = []
    for case, scene in scenes.items():
        works.append((case, *(work(scene, accuracy) for accuracy in ACCURACIES)))
        print(*works[-1], flush=True)
    record("certified_work", ("case", *(f"work to {of:.1%}" for of in ACCURACIES)), works)


if __name__ == "__main__":
    main()
