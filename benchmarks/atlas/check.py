"""Solve a seeded choice of the atlas' contacts again, more accurately, and compare with their bars.

    python benchmarks/atlas/check.py atlas/films.csv [--share 0.1] [--limit 40]

A bar holds if the stored film and the new one differ by no more than both bars together. New films without
bars, such as of solves that did not converge, tell nothing and are named.
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
from pyworm.scene.scales import scales

SEED, FINER = 5, 0.0015
"""Of the choice; the accuracy of the second solution [-]."""

UNKNOWN = 0.02
"""Bar of a new film from which it is no check."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("table", type=Path)
    parser.add_argument("--share", type=float, default=0.1)
    parser.add_argument("--limit", type=int, default=None, help="contacts at most")
    given = parser.parse_args()
    rows = {number: of for number, of in read(given.table).items() if of["certified"] == "1"}
    count = round(given.share * len(rows))
    chosen = np.random.default_rng(SEED).permutation(sorted(rows))[:count][: given.limit].tolist()
    held, differences = [], []
    for number in chosen:
        scene = contact(number)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", pyworm.UnusualWarning)
            plan = pyworm.plan(scene, FINER, "isothermal", ("film",))
        figures = pyworm.solve(scene, plan).figures
        unit = scales(scene).groups.moes_film
        for name in ("film_central", "film_min"):
            film = getattr(figures, name)
            if not film.error < UNKNOWN:
                print(f"{number} {name}: no new film within {UNKNOWN:.0%}", flush=True)
                continue
            stored, bar = float(rows[number][name]), float(rows[number][f"{name}_error"])
            difference = abs(stored * unit / film.value - 1)
            differences.append(difference)
            held.append(difference <= bar + film.error)
            if not held[-1]:
                print(
                    f"{number} {name}: {difference:.3%}, bars {bar:.3%} and {film.error:.3%}",
                    flush=True,
                )
    middle, most = np.percentile(differences, [50, 95])
    print(
        f"{len(chosen)} contacts, {len(held)} films: {sum(held)} within their bars; differences "
        f"{middle:.3%} (median), {most:.3%} (95 of 100), {max(differences):.3%} (largest)"
    )


if __name__ == "__main__":
    main()
