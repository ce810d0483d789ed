"""What squeeze does to a drive's films: as plans estimate it, and by transient films through a tooth's life.

Loads are shared dry. Every phase is solved twice, steady and in motion; then the overlap of the parts of the
life is compared. The last column tells whether the least film agrees, within both bars, with that of a
transient solve of its phase alone, where `separate_pasts.csv` has one. Run from the repository's root (it
takes two minutes):

    python benchmarks/drives/squeeze.py [CASE] [--phase PHASE ...] [--accuracy 0.05] [--effects auto]
        [--solves 2]
"""

from argparse import ArgumentParser
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time

import numpy as np

import pyworm
from pyworm.batch.case_run import run
from pyworm.batch.task import Task
from pyworm.case.case import Case
from pyworm.planning.effects.squeeze import SQUEEZE, lag, spread
from pyworm.planning.prediction import predicted
from pyworm.result.result import Result
from pyworm.solver.solution import Estimate
from pyworm.solver.transient.time_grid import time_grid_of
from pyworm.solver.transient.time_integration import integrate_in_time
from pyworm.solver.transient.transient import MAX_ALONE_TRANSITS, parts_of

FIGURES = ("film_central", "film_min", "friction_coefficient")
HEADS = ("ms", "lag", "spread", "estimate", "central", "least", "friction", "agrees")

PASTS = Path(__file__).with_name("separate_pasts.csv")
"""Phase, change of the least film by its motion, and the bar of that."""


def changed(after: Estimate, before: Estimate) -> tuple[float, float]:
    """A figure over what it was, less one, and the error of that by both error bars."""
    ratio = after.value / before.value
    return ratio - 1, ratio * (after.error + before.error)


def agreement(phase: float, change: float, bar: float) -> str:
    """Whether the change of a least film agrees with that of a past of its own."""
    for at, alone, its_bar in np.loadtxt(PASTS, delimiter=",", skiprows=4):
        if at == phase:
            return "yes" if abs(change - alone) <= bar + its_bar else "NO"
    return "-"


def solved(case: Case, tasks: Sequence[Task]) -> tuple[Result, float]:
    """The result of some tasks, and its processor time [s]."""
    started = process_time()
    with TemporaryDirectory() as directory:
        return run(case, tasks, Path(directory)), process_time() - started


def overlap(scene: pyworm.Scene, accuracy: float) -> None:
    """Largest difference of the films of both parts of a life where they overlap, beyond the warm-up."""
    time_grid = time_grid_of(scene.past.life, pyworm.plan(scene, accuracy))
    parts = parts_of(time_grid, MAX_ALONE_TRANSITS)
    if len(parts) < 2:
        print("the life is solved in one part")
        return
    before, after = parts[:2]
    at = time_grid.time_at(after.first)
    worst = 0.0
    curves = [integrate_in_time(time_grid, 0, part.begin, [at]).records for part in (before, after)]
    for name in FIGURES:
        one, other = (
            np.interp(at, [one.seconds for one in curve], [one.figures[name] for one in curve])
            for curve in curves
        )
        worst = max(worst, abs(one / other - 1))
    print(f"where the second part of the life takes over, films and friction differ by {worst:.2%}")


def work_of_life(scene: pyworm.Scene, accuracy: float, solves: int) -> None:
    """Work of friction over the whole life by each of several transient solves, and over that of the next."""
    time_grid = time_grid_of(scene.past.life, pyworm.plan(scene, accuracy))
    works = []
    for refinement in range(solves):
        records = integrate_in_time(time_grid, refinement, 0.0, [time_grid.end]).records
        losses = [one.figures["power_loss"] for one in records]
        works.append(np.trapezoid(losses, [one.seconds for one in records]))
    told = ", ".join(f"{work:.4g}" for work in works)
    over_next = ", ".join(f"{one / after - 1:+.2%}" for one, after in pairwise(works))
    print(f"work of friction over the life by each solve: {told} J, over the next {over_next}")


def main(
    path: str, phases: Sequence[float] | None, accuracy: float, effects: Sequence[str], solves: int
) -> None:
    """A row for each contact that the case lists, or at some of its phases."""
    case = pyworm.load(path)
    places = case.places(phase=phases)
    steady, moving = (
        solved(case, [Task(case, place, accuracy, (*effects, more)) for place in places])
        for more in ("-squeeze", "squeeze")
    )
    print(f"{'':>32} " + " ".join(f"{head:>12}" for head in HEADS))
    for place, before, after in zip(places, steady[0].solutions, moving[0].solutions, strict=True):
        scene = case.scene(**place.given)
        lacking = SQUEEZE.lacking(scene)
        if lacking is not None:
            print(f"{scene.name:>32} {lacking}")
            continue
        of = predicted(scene)
        row = [f"{of.transit * 1e3:.2f}"]
        row += [f"{part:.1%}" for part in (lag(of), spread(of), SQUEEZE.influence(of).film)]
        changes = [
            changed(getattr(after.figures, name), getattr(before.figures, name)) for name in FIGURES
        ]
        row += [f"{change:+.1%}±{bar:.1%}" for change, bar in changes]
        alone = agreement(scene.phase, *changes[FIGURES.index("film_min")])
        row.append(alone if Path(path).stem == "zi_drive" else "-")
        failed = "" if before.converged and after.converged else " not converged"
        print(f"{scene.name:>32} " + " ".join(f"{cell:>12}" for cell in row) + failed, flush=True)
    ratio = moving[1] / steady[1]
    print(f"processor time {moving[1]:.0f} s, steady {steady[1]:.0f} s: {ratio:.2f} times")
    overlap(scene, accuracy)
    work_of_life(scene, accuracy, solves)


if __name__ == "__main__":
    parser = ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", nargs="?", default="cases/zi_drive.toml")
    parser.add_argument("--phase", type=float, nargs="+")
    parser.add_argument("--accuracy", type=float, default=0.05)
    parser.add_argument("--effects", type=lambda text: tuple(text.split(",")), default=("auto",))
    parser.add_argument(
        "--solves", type=int, default=2, help="of the life, for the work of friction"
    )
    asked = parser.parse_args()
    main(asked.case, asked.phase, asked.accuracy, asked.effects, asked.solves)
