"""Observed order of circular films on one window, and their extrapolation against an independent solver.

Run from the repository's root: python benchmarks/validation/convergence.py
"""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

import pyworm
from pyworm.planning.grid import Grid
from pyworm.scene.point import Scene
from pyworm.scene.scales import scales

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

COARSEST = 48
TOLERANCE = 1e-6
# Window in half-widths of the contact; central and minimum film in Moes' units of an independent dense
# solver, extrapolated and corrected to a large domain (docs/evidence/validation.md).
CASES = {
    "point_m20_l10": ((-4.5, 1.5, 3.0), (4.208, 2.856)),
    "point_m100_l10": ((-3.0, 1.5, 2.25), (3.875, 2.069)),
    "point_m200_l10": ((-2.5, 1.5, 2.0), (3.690, 1.739)),
}


def films(scene: Scene, box: tuple[float, float, float]) -> np.ndarray:
    """Central and minimum film in Moes' units on three grids of halving spacing.

    Args:
        scene: A circular contact entrained along x.
        box: West, east and north side of the window, in half-widths of the contact.
    """
    size = scales(scene)
    a, unit = size.hertz.semi_axis_x, size.groups.moes_film
    spacing = (box[1] - box[0]) * a / COARSEST
    nodes_y = round(2 * box[2] * a / spacing) + 1
    grids = [Grid(box[0] * a, -box[2] * a, spacing, spacing, COARSEST + 1, nodes_y)]
    rows = []
    for _ in range(3):
        grids.append(grids[-1].finer())
        plan = replace(
            pyworm.plan(scene, effects="all"),
            grids=tuple(grids),
            wider_grids=(),
            largest_grid=grids[-1].nodes,
            tolerance=TOLERANCE,
        )
        figures = pyworm.solve(scene, plan).figures
        if figures.residual > TOLERANCE:
            raise RuntimeError(f"{scene.name}: the residual stayed at {figures.residual:.1e}")
        rows.append([figures.film_central.value / unit, figures.film_min.value / unit])
    return np.array(rows)


COLUMNS = (
    "case",
    "film",
    "first grid",
    "second grid",
    "third grid",
    "order",
    "extrapolated",
    "independent",
    "difference",
)


def main() -> None:
    rows = []
    for case, (box, reference) in CASES.items():
        scene = pyworm.load(Path("cases") / f"{case}.toml").scene()
        coarse, middle, fine = films(scene, box)
        order = np.log2((middle - coarse) / (fine - middle))
        limit = fine + (fine - middle) / 3
        for place, name in enumerate(("central", "minimum")):
            grids = (f"{row[place]:.4f}" for row in (coarse, middle, fine))
            wanted = reference[place]
            deviation = f"{(limit[place] / wanted - 1) * 100:+.2f} %"
            rows.append(
                (
                    case,
                    name,
                    *grids,
                    f"{order[place]:.2f}",
                    f"{limit[place]:.4f}",
                    wanted,
                    deviation,
                )
            )
    record("circular_films", COLUMNS, rows)


if __name__ == "__main__":
    main()
