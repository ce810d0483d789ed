"""Errors left in figures extrapolated from two grids, over the changes from the coarser to the finer one.

Random scenes with heat, smooth and rough (`tests/hard/draws.py`), are solved on grids of halving spacing up
to MOST_NODES in one window. The limit over all of them is the truth for the first two, where it is known to
KNOWN times the change. The change is the largest of a figure's own and, in turn, of both films' (as error
bars have it) or of all figures' but the minimum film's. From the repository's root:

    python benchmarks/accuracy/two_grids.py [COUNT [SEED ...]]
"""

import sys
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product
from pathlib import Path

import numpy as np
from accuracy_page import markdown
from error_bars import FIGURES, refined

import pyworm
from pyworm.case.case import case_of
from pyworm.kernel.core import KernelError
from pyworm.planning.target import FILMS, HEAT_FIGURES
from pyworm.precision.extrapolation import limit
from pyworm.solver.error_estimate import Reading, changes
from pyworm.solver.grid_limit import second_order_limit
from pyworm.solver.point.contact import CONVERGENCE

sys.path.append(str(Path(__file__).parents[2] / "tests" / "hard"))
from draws import DRAWS

ACCURACY, EXACT = 0.02, 0.1
"""Accuracy whose first grid is taken, and that of the algebra over it."""

MOST_NODES = 600_000
KINDS = ("thermal", "rough")

KNOWN = 0.25
"""Uncertainty of the truth over the change up to which an error is judged."""

BESIDE = {
    "films": FILMS,
    "all but the minimum": ("film_central", "friction_coefficient", *HEAT_FIGURES),
}
"""What the change of a figure is the largest of, besides its own."""

SHARES = (1 / 4, 1 / 3)
"""Shares of the change that an error bar may leave."""


@dataclass(frozen=True)
class Left:
    """Error left in a figure on two grids.

    Attributes
    ----------
    figure, beside : str
        The figure, and the changes that count besides its own.
    ratio : float
        Error over the largest of these changes.
    """

    figure: str
    beside: str
    ratio: float


def left(readings: list[Reading]) -> Iterator[Left]:
    """What is left of each figure on the first two of some grids, as all of them tell."""
    moved = {name: abs(of) for name, of in changes(*readings[:2]).items()}
    for name, (beside, others) in product(CONVERGENCE.left, BESIDE.items()):
        values = [reading.figures[name] for reading in readings]
        truth, change = limit(values), max(moved[one] for one in (name, *others))
        if truth.error <= KNOWN * change * abs(truth.value):
            error = abs(second_order_limit(*values[:2]) / truth.value - 1)
            yield Left(name, beside, error / change)


def read(kind: str, number: int, seed: int) -> Iterator[Left]:
    """What is left of the figures of a random scene; nothing where fewer than three grids have a film."""
    scene = case_of(DRAWS[kind](number, seed).tables, kind, Path()).scene()
    grids = pyworm.plan(scene, ACCURACY, "all").grids
    exact = pyworm.plan(scene, EXACT * ACCURACY, "all")
    # temperatures of films that hardly warm are settled too
    exact = replace(exact, aim=replace(exact.aim, warmth=0.0))
    try:
        readings = refined(exact.simplified(scene), exact, grids, 0.0, MOST_NODES)
    except KernelError:
        return
    if len(readings) > 2:
        yield from left(list(readings.values()))


def table(found: list[Left]) -> str:
    """How many of the errors stay below each of `SHARES` of the change, by figure."""
    words = [f"{beside}: below {share:.2f}" for beside, share in product(BESIDE, SHARES)]
    rows = [["figure", "pairs", *words]]
    for name in CONVERGENCE.left:
        of = {
            beside: np.array(
                [one.ratio for one in found if (one.figure, one.beside) == (name, beside)]
            )
            for beside in BESIDE
        }
        held = [f"{np.mean(of[beside] <= share):.0%}" for beside, share in product(BESIDE, SHARES)]
        rows.append([FIGURES[name], str(len(of["films"])), *held])
    return markdown(rows)


def main() -> None:
    number, *seeds = (int(word) for word in sys.argv[1:] or ("16", "11", "12", "13"))
    found: list[Left] = []
    for seed, place, kind in product(seeds, range(number), KINDS):
        found += read(kind, place, seed)
        print(f"{kind}:{place} of {seed}", file=sys.stderr, flush=True)
    print(table(found))


if __name__ == "__main__":
    main()
