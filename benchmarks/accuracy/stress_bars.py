"""Whether uncertainties of the maximum von Mises stress hold: random contacts against much finer grids.

Point contacts of `tests/hard/draws.py`, COUNT isothermal ones or COUNT with heat and thermal stress, solved
to 10 %. The truth is Richardson's limit of the maximum at a half and a quarter of the solution's spacing in
its window (whose errors `error_bars.py` judges), with a tenth of its residual, over a scan of depths of its
own. It may be off by the limit's own uncertainty;
a contact is judged where that is below half of the uncertainty. Contacts whose finest grid would exceed
MOST_NODES are passed over. From the repository's root:

    python benchmarks/accuracy/stress_bars.py isothermal|thermal [COUNT [SEED]]
"""

import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

import pyworm
from pyworm.case.case import case_of
from pyworm.formulas.stress_invariants import von_mises
from pyworm.planning.grid import Grid
from pyworm.precision.extrapolation import limit
from pyworm.scene.any_contact import AnyContact
from pyworm.solver.stress.subsurface import inputs_of_scene, stress_below, with_stress
from pyworm.solver.stress.thermal import why_no_heat

sys.path.append(str(Path(__file__).parents[2] / "tests" / "hard"))
from draws import JUDGED_DRAWS

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

ACCURACY = 0.1
COUNT, SEED = 20, 5454
MOST_NODES = 800_000
KNOWN = 0.5
"""Uncertainty of the truth over that of the stress up to which a contact is judged."""

EXPANSION = 11.5e-6
"""Thermal expansion of steel [1/K]."""

SCAN = np.concatenate([[0.0], np.geomspace(0.05, 1.2, 40)])
"""Depths over the half-width."""

SCANNED = 2
"""Halvings of the spacing from the grid of the first scan to the finest one."""

Row = tuple[object, ...]


def finer(grids: tuple[Grid, ...], spacing: float) -> tuple[Grid, ...]:
    """Nested grids refined alike until the last has a spacing."""
    while grids and grids[-1].dx > 1.01 * spacing:
        grids = tuple(grid.finer() for grid in grids)
    return grids


def truth(scene: AnyContact, solution: pyworm.Solution, heated: bool) -> list[np.ndarray]:
    """Maximum in both bodies on grids of a half and a quarter of the spacing; fewer where one has no film."""
    plan = pyworm.plan(scene, accuracy=ACCURACY)
    x = solution.fields.x.values
    windows = [grids for grids in (plan.grids, plan.wider_grids) if grids]
    window = min(windows, key=lambda grids: abs(np.ptp(grids[-1].x) / np.ptp(x) - 1))
    found = []
    for part in (2, 4):
        # uncertainties need two grids, of which the second is the wanted one
        grids = finer(window, 2 * float(x[1] - x[0]) / part)
        if grids[-1].finer().nodes > MOST_NODES:
            return found
        exact = replace(plan, grids=grids, wider_grids=(), tolerance=plan.tolerance / 10)
        fine = pyworm.solve(scene, exact)
        there = fine.fields.x.values
        if not (fine.converged and np.isclose(part * (there[1] - there[0]), x[1] - x[0])):
            return found
        inputs = inputs_of_scene(scene, heated)
        found.append(np.array([scanned(fine, body, inputs) for body in (1, 2)]))
    return found


def scanned(solution: pyworm.Solution, body: int, inputs: object) -> float:
    """Largest value on the finest grid near the best of a scan of depths, between them by a parabola [Pa]."""
    below = stress_below(solution, body, inputs)
    coarse = [below.highest(von_mises, depth * below.half_width, SCANNED)[0] for depth in SCAN]
    place = int(np.argmax(coarse))
    if place == 0:
        return below.highest(von_mises, 0.0, 0)[0]
    depths = SCAN[place] * below.half_width * np.geomspace(0.85, 1.15, 5)
    values = [below.highest(von_mises, depth, 0)[0] for depth in depths]
    middle = min(max(int(np.argmax(values)), 1), 3)
    before, here, behind = values[middle - 1 : middle + 2]
    return here - (behind - before) ** 2 / 8 / (before - 2 * here + behind)


def judged(kind: str, number: int, seed: int) -> Iterator[Row]:
    """A row for each body of a drawn contact; none of one that is too large or has no film."""
    scene = case_of(JUDGED_DRAWS[kind](number, seed).tables, kind, Path()).scene()
    bodies = tuple(replace(body, thermal_expansion=EXPANSION) for body in scene.bodies)
    scene = replace(scene, bodies=bodies)
    solution = pyworm.solve(scene, accuracy=ACCURACY)
    heated = kind != "isothermal"
    unfit = not solution.converged or 12 * solution.fields.pressure.size > MOST_NODES
    if unfit or (heated and why_no_heat(solution, scene)):
        return
    real = truth(scene, solution, heated)
    if len(real) < 2:
        return
    stress = with_stress(solution, inputs_of_scene(scene, heated)).figures.stress
    for body, found in enumerate((stress.von_mises_max_body_1, stress.von_mises_max_body_2)):
        exact = limit([float(values[body]) for values in real])
        error, unsure = abs(found.value / exact.value - 1), exact.error / exact.value
        yield (
            kind, number, body + 1, f"{exact.value / 1e6:.4g}", f"{found.error:.2%}", f"{error:.2%}",
            f"{unsure:.2%}", "yes" if unsure <= KNOWN * found.error else "no", f"{error / found.error:.2f}",
        )  # fmt: skip


COLUMNS = (
    "kind", "number", "body", "maximum / MPa", "uncertainty", "error", "uncertainty of the truth", "judged",
    "error / uncertainty",
)  # fmt: skip


def rows(kind: str, count: int, seed: int) -> Iterator[Row]:
    """Rows of the first contacts of a kind that can be judged by grids so fine."""
    numbers: set[int] = set()
    number = 0
    while len(numbers) < count:
        for row in judged(kind, number, seed):
            print(*row, flush=True)
            numbers |= {number} if row[-2] == "yes" else set()
            yield row
        number += 1


if __name__ == "__main__":
    kind, *given = sys.argv[1:]
    count, seed = (*map(int, given), *(COUNT, SEED)[len(given) :])
    record("stress_bars", COLUMNS, rows(kind, count, seed), key=("kind", "number", "body"))
