"""Films of line contacts against those of an independent solver in tests/data, and what they cost.

Run from the repository's root:

    python benchmarks/validation/line.py
"""

import csv
import sys
from pathlib import Path

import numpy as np

import pyworm
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import Barus, Density, Roelands
from pyworm.scene.line import LineScene, Parabola
from pyworm.scene.scales import line_scales

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

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
    """Films beside the independent ones."""
    with open(Path("tests/data/line_films.csv")) as file:
        known = list(csv.DictReader(row for row in file if not row.startswith("#")))
    rows = []
    for name, oil in OILS.items():
        for row in known:
            scene = line(float(row["M"]), float(row["L"]), oil)
            rough, fine = (
                pyworm.solve(scene, pyworm.plan(scene, accuracy, "all")) for accuracy in ACCURACIES
            )
            unit, figures = line_scales(scene).groups.moes_film, fine.figures
            cells = [name, row["M"], row["L"]]
            for film in ("central", "minimum"):
                value = (
                    getattr(figures, "film_min" if film == "minimum" else "film_central").value
                    / unit
                )
                cells += [
                    f"{value:.3f}",
                    f"{(value / float(row[f'{name}_{film}']) - 1) * 100:+.2f} %",
                ]
            rows.append((*cells, rough.fields.sizes["x"], fine.fields.sizes["x"]))
    titles = "oil", "M", "L", "h_c", "difference of h_c", "h_min", "difference of h_min"
    record("line_films", (*titles, "nodes at 1 %", "nodes at 0.05 %"), rows)


def judge_error_bars() -> None:
    """How many error bars of random scenes at 1 % hold the film at 0.1 %."""
    random = np.random.default_rng(11)
    bars = misses = converged = 0
    for _ in range(SCENES):
        m, lubricant = 10 ** random.uniform(-2, 3.5), random.uniform(0, 25)
        scene = line(m, lubricant, OILS[random.choice(list(OILS))])
        rough, fine = (
            pyworm.solve(scene, pyworm.plan(scene, error, "all")) for error in (0.01, 0.001)
        )
        converged += rough.converged
        for name in ("film_central", "film_min"):
            estimate, truth = getattr(rough.figures, name), getattr(fine.figures, name)
            bars += 1
            misses += abs(estimate.value / truth.value - 1) > estimate.error + truth.error
    held = bars - misses
    columns = "contacts", "converged", "error estimates", "hold"
    record("line_errors", columns, [(SCENES, converged, bars, f"{held} ({held / bars:.1%})")])


def main() -> None:
    compare()
    judge_error_bars()


if __name__ == "__main__":
    main()
