"""How well formulas tell what an oil one grade thicker changes: least films of isothermal contacts.

    python benchmarks/accuracy/film_sensitivity.py [COUNT]

Random scenes of the suite of hard ones, inside the box of the atlas, are solved at 0.5 % with their oil and
with one of 1.47 times the viscosity (`pyworm.report.page.sensitivity.GRADE_STEP`). The ratio of both least
films is compared with those of Nijenbanning, Venner and Moes' central film and of the atlas's least one.
"""

import sys
import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).parents[2] / "tests" / "hard"))
from draws import DRAWS

import pyworm
from pyworm.case.case import case_of
from pyworm.formulas.film import nijenbanning_venner_moes
from pyworm.report.page.sensitivity import GRADE_STEP, thickened
from pyworm.scene.point import Scene
from pyworm.scene.scales import scales

ACCURACY = 0.005


def solved(scene: Scene) -> float:
    """Least film [m]; not a number where it did not converge."""
    plan = pyworm.plan(scene, ACCURACY, "isothermal", ("film",))
    solution = pyworm.solve(scene, plan)
    return solution.figures.film_min.value if solution.converged else np.nan


def central(scene: Scene) -> float:
    """Central film by Nijenbanning, Venner and Moes [m]."""
    return float(nijenbanning_venner_moes(scales(scene).groups).central)


def least(scene: Scene) -> float:
    """Least film by the atlas [m]."""
    return float(pyworm.film_of(scene).minimum)


def main(count: int) -> None:
    """Print how far both formulas are off, in percent of the film."""
    warnings.simplefilter("ignore", pyworm.UnusualWarning)
    off = []
    for number in range(count):
        before = case_of(DRAWS["isothermal"](number).tables, "drawn", Path()).scene()
        if not scales(before).inside_atlas:
            continue
        after = replace(before, oil=thickened(before.oil, GRADE_STEP))
        true = solved(after) / solved(before)
        off.append([of(after) / of(before) / true - 1 for of in (central, least)])
        print(
            f"{number}: film {true - 1:+.1%}, off by {off[-1][0]:+.1%}, {off[-1][1]:+.1%}",
            flush=True,
        )
    known = np.abs([row for row in off if np.isfinite(row).all()])
    for name, of in zip(("Nijenbanning's central", "the atlas's least"), known.T, strict=True):
        middle, most = np.quantile(of, (0.5, 0.95))
        print(
            f"{name} film: off by {middle:.1%} in the median of {len(of)}, {most:.1%} at most in 95 %"
        )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 40)
