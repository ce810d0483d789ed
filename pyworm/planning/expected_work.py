"""Expected work of a solve: Newton steps and the nodes of their grids.

The time of a step is measured on each machine (`solver.cost.calibration`). Counts and laws are medians and
fits over the shipped cases and the scenes of `benchmarks/accuracy/asked_accuracy.py`;
`docs/evidence/accuracy.md` compares them with solves, and `benchmarks/accuracy/precision.py expected` repeats
the comparison.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import log
from typing import Literal

import numpy as np

Kind = Literal["point", "line"]

CHANGE, SHARPNESS_POWER, LUBRICANT_POWER, LOBES_POWER = 1.0, 2.7, 0.6, 0.16
"""The films' change from the first grid of the figures to the next is 1.0 (s/d)^2.7 (L/10)^0.6 k^0.16.

Here s is the spacing, d = b (h R/b^2)^(2/3) the length over which the gap beside a contact of half-width b
rises by a film h, whichever direction gives more, and k the length of a contact along the entrainment over
its width, or 1 if that is less: slender contacts entrained along have thin side lobes. Powers are a fit to
56 contacts, M 4 to 1000 and L 1 to 20, with a scheme of 2.7 times the error, the factor is the median of
45 random scenes, M 4 to 700; they scatter by 1.7."""

LEAST_CHANGE, AUXILIARY_CHANGE = 2e-3, 0.1
"""The least expected change, and that of a film carried by heat alone, which no formula predicts."""

LOG_CHANGE = tuple(log(ratio) for ratio in (0.8, 4.2, 17.0, 80.0, 500.0, 8000.0))
HALVINGS = (1.0, 1.5, 2.5, 3.5, 4.5, 6.5)
"""Expected change over the accuracy (logarithm), and halvings at which a solve is as likely to stop as not.

There is at least one halving; beyond the last each reduces the error to a quarter.

The error bar on the second grid is a quarter of the change, on each further a fourth to a tenth of the one
before (`solver.grid_limit`); a part is reserved for window and algebra. Up to 3.5 halvings medians of 137
random scenes (16 each of three seeds: isothermal, with heat, and with heat and roughness)."""


SUFFICIENT, SUFFICIENT_OF_HEATED = (3.5, 10.0, 50.0), (1.5, 6.0, 50.0)
"""Expected change over the accuracy up to which one, two and three halvings most probably suffice.

Temperatures move on where films do not, and conduction and levels take their part of the accuracy: with the
ratios of isothermal films two of five worm contacts at 1 % needed a halving more (15 s for 3.3)."""

MOST_BEYOND = 2.5
"""Factor beyond these ratios up to which a finer first grid is cheaper than one more halving."""

MAX_SPACING_FACTOR, MIN_SPACING_SHARE = 2.0, 0.85
"""Factor of the first grid's spacing where little accuracy is asked for, eight cells over the contact's
shorter half-width, and the share of it from which it is worth a try."""

MAX_FILM_ERROR = 0.1
"""Relative error of the films beyond which figures are worthless, whatever accuracy was asked for."""

IN_VAIN = 0.8
"""Halvings needed beyond the largest grid from which no grid is refined: twice the scatter of the expected
change, 1.7, in halvings."""


@dataclass(frozen=True)
class Steps:
    """Newton steps of a solve."""

    outer: float
    """Steps on each grid except the last of a nest."""
    cold: float
    """Steps on the last grid with an isothermal Newtonian oil."""
    full: float
    """Further steps on the last grid with all effects, if there are more."""
    finer: float
    """Steps on each finer grid."""


STEPS: dict[Kind, Steps] = {
    "point": Steps(outer=3.5, cold=4.0, full=8.0, finer=2.8),
    "line": Steps(outer=0.0, cold=12.0, full=12.0, finer=5.0),
}

THICKENING, THICKENING_POWER = 10.0, 0.7
"""Moes' L above which the linear systems of isothermal steps take more iterations, and the exponent of L."""

STIFF, STIFF_POWER = 15.0, 2.5
"""Moes' L above which the linear systems of heated steps take more iterations, and the exponent of L."""

STEPS_A_TRANSIT: dict[Kind, int] = {"point": 9, "line": 48}
"""Time steps of a transit of oil in the first transient solve of a life; each further one doubles them
(`solver.transient.time_integration`)."""

ONE_SOLVE, TWO_SOLVES = 0.09, 0.035
"""Accuracies from which one and two transient solves of a life suffice."""

AUXILIARY_STEPS = Steps(outer=0.0, cold=8.0, full=60.0, finer=5.0)
"""Newton steps of a film carried by heat alone."""


@dataclass(frozen=True)
class Stage:
    """Newton steps on one grid."""

    nodes: float
    """Number of nodes."""
    cold: float
    """Steps with an isothermal Newtonian oil."""
    full: float
    """Steps with all effects; 0 where there are no more."""


@dataclass(frozen=True)
class Work:
    """Expected work of a solve, grid by grid."""

    kind: Kind
    """Kind of contact: "point" or "line"."""
    stages: tuple[Stage, ...]
    """Grids, finer ones last, whose number is the expected one."""
    needed: float = 0.0
    """Expected number of nodes for an error of `MAX_FILM_ERROR`."""
    in_vain: bool = False
    """Whether that number exceeds the largest grid so far that no grid is refined."""

    @property
    def finest(self) -> float:
        """Nodes of the last grid."""
        return self.stages[-1].nodes

    @property
    def steps(self) -> float:
        """Number of all steps."""
        return sum(stage.cold + stage.full for stage in self.stages)


def sharpness(
    spacing: Sequence[float], half_widths: Sequence[float], radii: Sequence[float], film: float
) -> float:
    """Largest spacing over the length of the film's rise [-]; arguments as of `first_change`."""
    return float(
        max(
            step / (half * (film * radius / half**2) ** (2 / 3))
            for step, half, radius in zip(spacing, half_widths, radii, strict=True)
        )
    )


def first_change(
    spacing: Sequence[float],
    half_widths: Sequence[float],
    radii: Sequence[float],
    film: float,
    moes_l: float,
    slenderness: float = 1.0,
) -> float:
    """Expected relative change of the films from the first grid of the figures to the next.

    By spacing, half-widths, radii and central film [m], and the contact's length along the entrainment over
    its width.
    """
    lubricant = max(moes_l, 1.0) / 10
    lobes = max(slenderness, 1.0) ** LOBES_POWER
    sharp = sharpness(spacing, half_widths, radii, film)
    change = CHANGE * sharp**SHARPNESS_POWER * lubricant**LUBRICANT_POWER * lobes
    return float(max(LEAST_CHANGE, change))


def first_refinement(change: float, accuracy: float, heated: bool, rough: bool) -> float:
    """Factor of the first grid's spacing by which the last one most probably just suffices.

    Where the films' expected change is a little too large for a number of halvings, a somewhat finer first
    grid saves the last of them, which has four times the nodes. Where it is far less than one halving needs,
    twice the spacing does between rough surfaces, whose asperities leave no pressure spikes: if not, the last
    grid is what it would have been.
    """
    ratio = change / accuracy
    for enough in SUFFICIENT_OF_HEATED if heated else SUFFICIENT:
        if ratio <= enough * MOST_BEYOND:
            factor = float((enough / ratio) ** (1 / SHARPNESS_POWER))
            coarser = rough and factor >= MIN_SPACING_SHARE * MAX_SPACING_FACTOR
            return MAX_SPACING_FACTOR if coarser else min(1.0, factor)
    return 1.0


def solves_of_life(accuracy: float) -> int:
    """Transient solves of a life, each with half the spacing and time step of the one before."""
    return 1 + (accuracy < ONE_SOLVE) + (accuracy < TWO_SOLVES)


def stiffness(heated: bool, moes_l: float) -> float:
    """Factor by which the Newton steps of a film exceed the usual number."""
    least, power = (STIFF, STIFF_POWER) if heated else (THICKENING, THICKENING_POWER)
    return float(max(1.0, moes_l / least) ** power)


def expected_work(
    kind: Kind,
    nests: Sequence[Sequence[float]],
    change: float,
    accuracy: float,
    largest: float,
    full: bool,
    stiffness: float = 1.0,
    auxiliary: bool = False,
) -> Work:
    """Expected work of a solve, grid by grid.

    `nests` are nodes of the grids of each window, of which the first is refined up to `largest`; `change` is
    that of the films from the first grid to the next. Beyond an isothermal Newtonian oil it is `full`;
    `stiffness` multiplies the work of a step, and `auxiliary` entrainment is needed where heat alone carries
    the film.
    """
    steps = AUXILIARY_STEPS if auxiliary else STEPS[kind]
    cold = 1.0 if full else stiffness
    stages = []
    for nest in nests:
        stages += [Stage(nodes, cold * steps.outer, 0.0) for nodes in nest[:-1]]
        stages.append(Stage(nest[-1], cold * steps.cold, stiffness * steps.full * full))
    growth = 4.0 if kind == "point" else 2.0
    most = max(1.0, log(largest / nests[0][-1]) / log(growth))
    least = _halvings(change / max(accuracy, MAX_FILM_ERROR))
    needed = nests[0][-1] * growth**least
    if least > most + IN_VAIN:
        return Work(kind, tuple(stages), needed, in_vain=True)
    halvings = min(most, _halvings(change / accuracy))
    for number in range(int(halvings)):
        # the last grid is as fine as likely
        nodes = nests[0][-1] * growth ** (halvings - int(halvings) + number + 1)
        stages.append(Stage(nodes, cold * steps.finer * (not full), stiffness * steps.finer * full))
    return Work(kind, tuple(stages), needed)


def _halvings(change: float) -> float:
    """Expected number of halvings for a change of the films over the accuracy."""
    beyond = max(0.0, (log(change) - LOG_CHANGE[-1]) / log(4.0))
    return float(np.interp(log(change), LOG_CHANGE, HALVINGS)) + beyond
