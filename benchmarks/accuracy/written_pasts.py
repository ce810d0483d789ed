"""Error bars of films after a written past, against one more transient solve on finer grids.

Contacts are the `past` of `tests/hard/draws.py`: blow, parting, start, reversal and swing in turn, solved to
5 % as `make hard SCENE=past` does. The truth has one transient solve more, of half the spacing and time step,
and 2 %; a bar is judged where the truth's own is below half of it. Solutions of four solves are not judged:
a fifth takes an hour. From the repository's root (half an hour):

    python benchmarks/accuracy/written_pasts.py [--seed 1] [NUMBER ...]
"""

import sys
from argparse import ArgumentParser
from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import inf
from pathlib import Path
from unittest.mock import patch

import pyworm
from pyworm.planning.plan import with_accuracy
from pyworm.solver.transient import transient
from pyworm.solver.transient.transient import MAX_SOLVES, finer, rates_at_present

sys.path.append(str(Path(__file__).parents[2] / "tests" / "hard"))
from draws import past
from trial import trial

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

COUNT, TRUTH_ACCURACY = 10, 0.02
FIGURES = "film_min", "film_central", "pressure_max"


def judged(number: int, seed: int) -> Iterator[tuple[str, float, float]]:
    """Figure, its deviation from the truth, and its bar, of those that are judged."""
    one = trial(past(number, seed).tables, f"past {number}", Path(), ("isothermal", "squeeze"))
    rates = rates_at_present(one.scene, one.plan)
    solution = pyworm.solve(one.scene, one.plan, rates=rates)
    solves = solution.cost.transient_solves
    print(f"{one.case.title}, {solves} transient solves: {solution.stop_reason}", flush=True)
    if not solution.converged or solves >= MAX_SOLVES:
        return
    with patch.object(transient, "MOST_WORK", inf):
        while len(rates.found) <= solves and not rates.finest:
            rates = finer(one.scene, one.plan, rates)
    if rates.finest:
        return
    plan = with_accuracy(one.scene, one.plan, TRUTH_ACCURACY)
    truth = pyworm.solve(one.scene, plan, rates=replace(rates, finest=True))
    for name in FIGURES:
        found, known = (getattr(of.figures, name) for of in (solution, truth))
        if known.error < found.error / 2:
            yield name, abs(found.value / known.value - 1), found.error


def main(numbers: Sequence[int], seed: int) -> None:
    """Rows for each past; then how many bars hold."""
    ratios = []
    for number in numbers:
        for name, deviation, bar in judged(number, seed):
            ratios.append(deviation / bar)
            print(f"{name:>24} {deviation:7.2%} of {bar:6.2%}", flush=True)
    held = sum(ratio <= 1 for ratio in ratios)
    print(f"{held} of {len(ratios)} hold")
    if len(numbers) == COUNT:
        columns = "seed", "judged", "hold", "largest ratio"
        row = seed, len(ratios), held, f"{max(ratios):.2f}"
        record("error_written_pasts", columns, [row], key=("seed",))


if __name__ == "__main__":
    parser = ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("number", type=int, nargs="*", default=range(COUNT))
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    main(asked.number, asked.seed)
