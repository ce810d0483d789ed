"""Films of line contacts against those of an independent solver in tests/data, and what they cost.

Run from the repository's root:

    python benchmarks/validation/line.py
"""

import csv
from pathlib import Path

import numpy as np

import pyworm
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import Barus, Density, Roelands
from pyworm.scene.line import LineScene, Parabola
from pyworm.scene.scales import line_scales

ETA0, ALPHA, RADIUS = 0.04, 22e-9, 0.01
STEEL = Body(205.66e9, 0.3)
OILS = {
    "incompressible": Oil(Barus(ETA0, ALPHA), Density.incompressible(870.0)),
    "compressible": Oil(Roelands.from_alpha(ETA0, ALPHA), Density.dowson_higginson_pole(870.0)),
}
SCENES = 150
"""Random scenes for the error bars."""

ACCURACIES = (0.01, 0.0005)
"""What a user asks for as a rule, and what the comparison takes."""


def line(m: float, lubricant: float, oil: Oil) -> LineScene:
    """A line contact of given Moes parameters."""
    modulus = STEEL.youngs_modulus / (1 - STEEL.poisson_ratio**2)
    speed_group = (lubricant / (ALPHA * modulus)) ** 4 / 2
    speed = speed_group * modulus * RADIUS / ETA0
    return LineScene(
        name=f"({m:g}, {lubricant:g})",
        gap=Parabola(RADIUS),
        radius=RADIUS,
        velocities=(speed, speed),
        load=m * (2 * speed_group) ** 0.5 * modulus * RADIUS,
        bodies=(STEEL, STEEL),
        oil=oil,
    )


def compare() -> None:
    """Print films beside the independent ones."""
    print(
        f"{'oil':15} {'(M, L)':>10} {'central':>8} {'to independent':>14} {'minimum':>8} {'':>14}"
        f" {'nodes':>6} {'ms':>5}   {'1 %: nodes':>10} {'ms':>5}"
    )
    with open(Path("tests/data/line_films.csv")) as file:
        rows = list(csv.DictReader(row for row in file if not row.startswith("#")))
    for name, oil in OILS.items():
        for row in rows:
            scene = line(float(row["M"]), float(row["L"]), oil)
            rough, fine = (
                pyworm.solve(scene, pyworm.plan(scene, accuracy, "all")) for accuracy in ACCURACIES
            )
            unit, figures = line_scales(scene).groups.moes_film, fine.figures
            central, minimum = figures.film_central.value / unit, figures.film_min.value / unit
            print(
                f"{name:15} {scene.name:>10} "
                f"{central:8.3f} {central / float(row[f'{name}_central']) - 1:+14.2%} "
                f"{minimum:8.3f} {minimum / float(row[f'{name}_minimum']) - 1:+14.2%} "
                f"{fine.fields.sizes['x']:6} {fine.cost.seconds * 1e3:5.0f}   "
                f"{rough.fields.sizes['x']:10} {rough.cost.seconds * 1e3:5.0f}"
            )


def judge_error_bars() -> None:
    """Print how many error bars of random scenes at 1 % miss the film at 0.1 %, and what the solves took."""
    random = np.random.default_rng(11)
    bars = misses = converged = 0
    seconds = []
    for _ in range(SCENES):
        m, lubricant = 10 ** random.uniform(-2, 3.5), random.uniform(0, 25)
        scene = line(m, lubricant, OILS[random.choice(list(OILS))])
        rough, fine = (
            pyworm.solve(scene, pyworm.plan(scene, error, "all")) for error in (0.01, 0.001)
        )
        converged += rough.converged
        seconds.append(rough.cost.seconds)
        for name in ("film_central", "film_min"):
            estimate, truth = getattr(rough.figures, name), getattr(fine.figures, name)
            bars += 1
            misses += abs(estimate.value / truth.value - 1) > estimate.error + truth.error
    print(
        f"{SCENES} random scenes, M 0.01 to 3200, L to 25, at 1 %: {converged} converged, {misses} of {bars} "
        f"error bars miss; {np.median(seconds) * 1e3:.0f} ms in the middle, {max(seconds) * 1e3:.0f} at most"
    )


def main() -> None:
    compare()
    judge_error_bars()


if __name__ == "__main__":
    main()
