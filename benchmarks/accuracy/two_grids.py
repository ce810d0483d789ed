"""How often the discretisation errors of figures hold that two and three grids tell.

Random scenes, isothermal, with heat, and with heat and roughness (`tests/hard/draws.py`), are solved on
grids of halving spacing up to MOST_NODES in one window. The limit over all of them is the truth for the first
two and three, where it is known to KNOWN times the error told (`pyworm.solver.grid_limit`). From the
repository's root:

    python benchmarks/accuracy/two_grids.py [COUNT [SEED ...]]
"""

import sys
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product
from pathlib import Path
from statistics import median

from error_bars import FIGURES, refined

import pyworm
from pyworm.case.case import case_of
from pyworm.kernel.core import KernelError
from pyworm.precision.extrapolation import limit
from pyworm.solver.error_estimate import Reading
from pyworm.solver.grid_limit import grid_limits
from pyworm.solver.point.contact import CONVERGENCE

sys.path.append(str(Path(__file__).parents[2] / "tests" / "hard"))
from draws import DRAWS

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

ACCURACY, EXACT = 0.02, 0.1
"""Accuracy whose first grid is taken, and that of the algebra over it."""

MOST_NODES = {"isothermal": 1_000_000, "thermal": 400_000, "rough": 400_000}

KNOWN = 0.25
"""Uncertainty of the truth over the error told up to which that is judged."""

GRIDS = 2, 3


@dataclass(frozen=True)
class Left:
    """Error left in a figure."""

    figure: str
    """The figure."""
    grids: int
    """Number of grids."""
    ratio: float
    """True error over the one told."""


def left(readings: list[Reading]) -> Iterator[Left]:
    """What is left of each figure on the first grids, as all of them tell."""
    for name in FIGURES.keys() & readings[0].figures.keys():
        truth = limit([reading.figures[name] for reading in readings])
        for grids in GRIDS:
            told = grid_limits(readings[:grids], CONVERGENCE)[name]
            bar = told.error * abs(told.value)
            if grids < len(readings) and truth.error <= KNOWN * bar:
                yield Left(name, grids, abs(told.value - truth.value) / bar)


def read(kind: str, number: int, seed: int) -> list[Reading]:
    """Figures of a random scene on grids of halving spacing; none where one has no film."""
    scene = case_of(DRAWS[kind](number, seed).tables, kind, Path()).scene()
    effects = "isothermal" if kind == "isothermal" else "all"
    grids = pyworm.plan(scene, ACCURACY, effects).grids
    exact = pyworm.plan(scene, EXACT * ACCURACY, effects)
    # temperatures of films that hardly warm are settled too
    exact = replace(exact, target=replace(exact.target, warmth=0.0))
    try:
        return list(refined(exact.simplified(scene), exact, grids, 0.0, MOST_NODES[kind]).values())
    except KernelError:
        return []


HEADS = "estimates on {} grids", "hold on {} grids", "median error / estimate on {} grids"


def rows_of(found: list[Left]) -> Iterator[list[str]]:
    """How many of the estimated errors hold, and the true ones over them, by quantity."""
    for name, words in FIGURES.items():
        row = [words]
        for grids in GRIDS:
            of = [one.ratio for one in found if (one.figure, one.grids) == (name, grids)]
            held = sum(ratio <= 1 for ratio in of) / max(len(of), 1)
            row += [str(len(of)), f"{held:.0%}", f"{median(of or [0.0]):.2f}"]
        yield row


def main() -> None:
    number, *seeds = (int(word) for word in sys.argv[1:] or ("16", "11", "12", "13"))
    found: list[Left] = []
    for seed, place, kind in product(seeds, range(number), MOST_NODES):
        readings = read(kind, place, seed)
        if len(readings) > GRIDS[0]:
            found += left(readings)
        print(f"{kind}:{place} of {seed}", file=sys.stderr, flush=True)
    heads = [head.format(grids) for grids in GRIDS for head in HEADS]
    record("two_grids", ("quantity", *heads), rows_of(found))


if __name__ == "__main__":
    main()
