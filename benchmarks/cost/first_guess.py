"""What the formula of the atlas saves the solver against Nijenbanning, Venner and Moes' film.

    python benchmarks/cost/first_guess.py [SET ...]

The expected film is the first guess of the solver's film, and sets the reach of windows and the spacing of
first grids. Contacts that no fit has seen are planned and solved with either formula, at 5 %: Newton steps on
the outermost grid and in all, convolutions, films that converged, windows that had to be widened, nodes of
the last grid; and the expected central and least film over the solved one.
"""

import sys
import warnings
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).parents[1]))
sys.path.append(str(Path(__file__).parents[2] / "tests" / "hard"))

from atlas.contacts import contact, order
from draws import DRAWS

import pyworm
from pyworm.case.case import case_of
from pyworm.formulas.film import nijenbanning_venner_moes
from pyworm.planning.prediction import predicted
from pyworm.scene import scales
from pyworm.scene.point import Scene

ROOT = Path(__file__).parents[2]

ACCURACY = 0.05

BY_ATLAS = scales._flooded

PHASES = 0.1, 0.3, 0.5, 0.7, 0.9


def by_nijenbanning(scene, groups, at_rest) -> tuple[float, float, bool]:
    """Central film, and a typical least one over it, as of `scales._flooded`."""
    return float(nijenbanning_venner_moes(groups).central), scales.LEAST_TO_CENTRAL, False


FORMULAS = {"Nijenbanning": by_nijenbanning, "atlas": BY_ATLAS}


def drawn(kind: str, count: int) -> Iterator[Scene]:
    """Scenes of the suite of hard ones."""
    for number in range(count):
        yield case_of(DRAWS[kind](number).tables, kind, Path()).scene()


def worms() -> Iterator[Scene]:
    """Contacts of worms with ZI flanks and of a crowned roller, without their past."""
    for name in ("zi_sharif_2001", "zi_drive", "worm_drawing", "roller_crowned"):
        case = pyworm.load(ROOT / "cases" / f"{name}.toml")
        for phase in PHASES:
            yield replace(case.scene(phase=phase), past=None)


SETS = {
    "atlas": (lambda: map(contact, order()[-60:]), "isothermal"),
    "isothermal": (lambda: drawn("isothermal", 60), "isothermal"),
    "worms": (worms, ("isothermal", "-real-gap")),
    "thermal": (lambda: drawn("thermal", 10), "all"),
}
"""Contacts and the effects simulated, by name."""


@dataclass(frozen=True)
class Solved:
    """What a solve took."""

    first: float
    """Newton steps on the outermost grid."""
    steps: float
    """Newton steps in all."""
    convolutions: float
    """Convolutions."""
    converged: float
    """Whether the film converged, 1 or 0."""
    widened: float
    """Whether the window had to be widened, 1 or 0."""
    nodes: float
    """Nodes of the last grid."""
    central: float
    """Expected central film over the solved one."""
    least: float
    """Expected least film over the solved one."""


def solved(scene: Scene, effects: str | tuple[str, ...], formula: str) -> Solved:
    """A contact by the expected film of one formula."""
    scales._flooded = FORMULAS[formula]
    try:
        plan = pyworm.plan(scene, ACCURACY, effects)
        expected = predicted(plan.simplified(scene))
        solution = pyworm.solve(scene, plan)
    finally:
        scales._flooded = BY_ATLAS
    counts = solution.history.points_x.values, solution.history.points_y.values
    outermost = (counts[0] == plan.grids[0].nx) & (counts[1] == plan.grids[0].ny)
    films = solution.figures.film_central.value, solution.figures.film_min.value
    good = solution.converged
    return Solved(
        int(outermost.sum()),
        len(outermost),
        solution.cost.convolutions,
        good,
        float(solution.fields.x.min()) < 1.01 * plan.grids[-1].west,
        solution.fields.x.size * solution.fields.y.size,
        expected.film_central / films[0] if good else np.nan,
        expected.film_min / films[1] if good else np.nan,
    )


def main(names: list[str]) -> None:
    """Print sums over each set, and the ratios of its films."""
    warnings.simplefilter("ignore", pyworm.UnusualWarning)
    for name in names or SETS:
        make, effects = SETS[name]
        found = [[solved(of, effects, which) for which in FORMULAS] for of in make()]
        print(f"{name}: {len(found)} contacts", flush=True)
        for formula, rows in zip(FORMULAS, zip(*found, strict=True), strict=True):
            sums = {key: sum(getattr(of, key) for of in rows) for key in list(vars(rows[0]))[:6]}
            print(f"  {formula:13}" + ", ".join(f"{key} {of:.0f}" for key, of in sums.items()))
            for film in ("central", "least"):
                ratios = np.array([getattr(of, film) for of in rows])
                low, middle, high = np.nanquantile(ratios, (0.05, 0.5, 0.95))
                print(f"    {film:8} {middle:.2f} ({low:.2f} to {high:.2f}) of the solved film")


if __name__ == "__main__":
    main(sys.argv[1:])
