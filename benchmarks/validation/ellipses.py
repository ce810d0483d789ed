"""Elliptic contacts at M = 200, L = 10 against an independent dense solver, compressible Roelands oil.

D is the radius along over that across the entrainment. Afterwards D = 5 and 10 on three grids of one window,
with the order observed: their side lobes are narrow, and the independent solver had no films there that its
grids agreed on. Run from the repository's root:

    python benchmarks/validation/ellipses.py [order]
"""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

import pyworm
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import Density, Roelands
from pyworm.scene.point import Paraboloid, RigidMotion, Scene
from pyworm.scene.scales import scales

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

STEEL = Body(205.66e9, 0.3)
OIL = Oil(Roelands.from_alpha(0.04, 22e-9), Density.dowson_higginson_pole(870.0))
RADIUS = 0.01
M, L = 200.0, 10.0
ACCURACY = 0.003
LARGEST_GRID = 5_500_000
# D -> central and minimum film in Moes' units, large inlet (docs/evidence/validation.md); None: not found
REFERENCE = {
    1 / 30: (5.355, 4.456),
    1 / 10: (4.945, 4.167),
    1 / 5: (4.642, 3.702),
    1 / 2: (4.147, 2.681),
    1: (3.690, 1.739),
    2: (3.14, 0.99),
    5: (2.38, 0.40),
    10: (1.8, None),
}


def scene(ratio: float) -> Scene:
    """The contact whose radius across the entrainment is RADIUS / ratio."""
    modulus = STEEL.youngs_modulus / (1 - STEEL.poisson_ratio**2)
    speed_group = (L / (OIL.viscosity.alpha * modulus)) ** 4 / 2
    motion = RigidMotion(speed_group * modulus * RADIUS / OIL.viscosity.eta0, 0.0)
    radii = (RADIUS, RADIUS / ratio)
    return Scene(
        name=f"D = {ratio:.3g}",
        gap=Paraboloid(*radii),
        radii=radii,
        motions=(motion, motion),
        load=M * (2 * speed_group) ** 0.75 * modulus * RADIUS**2,
        bodies=(STEEL, STEEL),
        oil=OIL,
    )


SLENDER = (5, 10)
"""D of which the order is observed."""
TOLERANCE = 1e-6


def orders() -> None:
    """Central and minimum film on three grids of halving spacing over one window."""
    table = []
    for ratio in SLENDER:
        contact = scene(ratio)
        unit = scales(contact).groups.moes_film
        plan = replace(
            pyworm.plan(contact, effects="all"), wider_grids=(), tolerance=TOLERANCE, accuracy=1e-5
        )
        finest = plan.grids[-1]
        rows = []
        while finest.finer().nodes < LARGEST_GRID:
            finest = finest.finer()
            figures = pyworm.solve(contact, replace(plan, largest_grid=finest.nodes)).figures
            rows.append([figures.film_central.value / unit, figures.film_min.value / unit])
        coarse, middle, fine = np.array(rows[-3:])
        order = np.log2((middle - coarse) / (fine - middle))
        limit = fine + (fine - middle) / 3
        for number, name in enumerate(("central", "minimum")):
            grids = (f"{row[number]:.4f}" for row in (coarse, middle, fine))
            found = f"{order[number]:.2f}", f"{limit[number]:.4f}", f"{finest.nx} x {finest.ny}"
            table.append((ratio, name, *grids, *found))
    grids = "first grid", "second grid", "third grid"
    record("ellipse_orders", ("D", "film", *grids, "order", "extrapolated", "finest grid"), table)


def compare() -> None:
    """Films beside the independent ones."""
    rows = []
    for ratio, reference in REFERENCE.items():
        contact = scene(ratio)
        plan = replace(pyworm.plan(contact, ACCURACY, "all"), largest_grid=LARGEST_GRID)
        solution = pyworm.solve(contact, plan)
        unit = scales(contact).groups.moes_film
        cells = [f"{ratio:g}" if ratio >= 1 else f"1/{round(1 / ratio)}"]
        for name, wanted in zip(("film_central", "film_min"), reference, strict=True):
            film = getattr(solution.figures, name)
            value = film.value / unit
            off = "" if wanted is None else f"{(value / wanted - 1) * 100:+.2f} %"
            cells += [f"{value:.3f}", f"{100 * film.error:.2f} %", wanted or "", off]
        rows.append(cells)
    titles = "{}", "uncertainty of {}", "independent {}", "difference of {}"
    columns = [title.format(film) for film in ("h_c", "h_min") for title in titles]
    record("ellipse_films", ("D", *columns), rows)


def main() -> None:
    if sys.argv[1:] != ["order"]:
        compare()
    orders()


if __name__ == "__main__":
    main()
