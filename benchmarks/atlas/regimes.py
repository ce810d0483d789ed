"""Regimes against solved limits: contacts of the atlas solved again without one of the two mechanisms.

    python benchmarks/atlas/regimes.py atlas/films.csv [--contacts 60] [--start 0]

An isoviscous twin of each contact shows what pressure-viscosity changes, a rigid twin of those whose bodies
hardly deform what deflection changes. Printed are the thickening that the solved films correspond to beside
that of the formula, both influences of the plan beside the solved changes of the films, and their summary.
"""

import argparse
import sys
import warnings
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

from atlas.contacts import contact
from atlas.table import read

import pyworm
from pyworm.formulas import film_atlas
from pyworm.planning.effects.geometry import ELASTIC_DEFLECTION
from pyworm.planning.effects.rheology import PRESSURE_VISCOSITY
from pyworm.planning.prediction import predicted
from pyworm.scene.scales import scales

SEED, ACCURACY, BAR = 11, 0.02, 0.05
"""Of the choice; accuracy of twins; largest bar of a film that is compared [-]."""

STIFF = 3.0
"""Deflection over film up to which rigid twins are solved: beyond it rigid bodies tell nothing."""


def twin_films(scene: pyworm.Scene, effect) -> tuple[float, float] | None:
    """Central and minimum film [m] of a contact without an effect; None where they are not known."""
    twin = effect.without(scene)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pyworm.UnusualWarning)
        figures = pyworm.solve(twin, pyworm.plan(twin, ACCURACY, "isothermal", ("film",))).figures
    if not max(figures.film_central.error, figures.film_min.error) < BAR:
        return None
    return figures.film_central.value, figures.film_min.value


def thickening_of(gain: float, deflection: float) -> float:
    """The thickening to which a film over the isoviscous one belongs, by the power that joins the limits."""
    power = film_atlas._constants()["joined"]["power"]
    ratio = max(gain**power - 1, 0.0) ** (1 / power)
    return ratio ** (4 / 3 + 1 / 6 / (1 + deflection))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("table", type=Path)
    parser.add_argument("--contacts", type=int, default=60)
    parser.add_argument("--start", type=int, default=0)
    given = parser.parse_args()
    rows = {number: of for number, of in read(given.table).items() if of["certified"] == "1"}
    chosen = np.random.default_rng(SEED).permutation(sorted(rows)).tolist()
    errors, oil, bodies = [], [], []
    for number in chosen[given.start : given.start + given.contacts]:
        scene = contact(number)
        regime, unit = predicted(scene).regime, scales(scene).groups.moes_film
        stored = np.array(
            [float(rows[number][name]) * unit for name in ("film_central", "film_min")]
        )
        words = [f"{number} {regime.words}: deflection {regime.deflection:.3g}"]
        thin = twin_films(scene, PRESSURE_VISCOSITY)
        if thin is not None:
            gains = stored / thin
            solved = thickening_of(gains[0], regime.deflection)
            if regime.deflection > 1:  # of rigid bodies the thickening is exact
                errors.append((regime.thickening, solved))
            oil.append(max(abs(gains - 1)) / PRESSURE_VISCOSITY.influence(predicted(scene)).film)
            words.append(
                f"thickening {regime.thickening:.3g}, solved {solved:.3g}, films x {gains.round(3)}"
            )
        if regime.deflection < STIFF:
            stiff = twin_films(scene, ELASTIC_DEFLECTION)
            if stiff is not None:
                changes = np.array(stiff) / stored - 1
                bodies.append(
                    max(abs(changes)) / ELASTIC_DEFLECTION.influence(predicted(scene)).film
                )
                words.append(f"rigid bodies change films by {changes.round(3)}")
        print("; ".join(words), flush=True)
    told, solved = np.array(errors).T
    off = np.abs(np.log(told / np.maximum(solved, 1e-9)))
    strong = (told > 0.3) | (solved > 0.3)
    print(f"{len(told)} isoviscous twins of elastic bodies; median, 95 of 100 and largest of")
    off = np.exp(np.percentile(off[strong], PERCENTS)).round(3)
    print(f"factor by which the thickening is off, where it is above 0.3: {off}")
    print(f"on the same side of the border: {np.sum((told > 1) == (solved > 1))}")
    print("solved change of films over the influence in the plan:")
    print(f"pressure-viscosity {np.percentile(oil, PERCENTS).round(3)}")
    print(f"deflection, {len(bodies)} rigid twins {np.percentile(bodies, PERCENTS).round(3)}")


PERCENTS = [50, 95, 100]


if __name__ == "__main__":
    main()
