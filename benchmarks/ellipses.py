"""Elliptic contacts at M = 200, L = 10 against an independent dense solver, compressible Roelands oil.

D is the radius along over that across the entrainment. Run from the repository's root:

    python benchmarks/ellipses.py
"""

from dataclasses import replace

import pyworm
from pyworm.bodies import Body
from pyworm.oils import Density, Oil, Roelands
from pyworm.scales import scales
from pyworm.scene import Paraboloid, RigidMotion, Scene

STEEL = Body(205.66e9, 0.3)
OIL = Oil(Roelands.from_alpha(0.04, 22e-9), Density.dowson_higginson_pole(870.0))
RADIUS = 0.01
M, L = 200.0, 10.0
ACCURACY = 0.003
LARGEST_GRID = 4_500_000
# D -> central and minimum film in Moes' units, large inlet (docs/validation.md); None: not found by it
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


def main() -> None:
    print("     D   central   ± %  reference    diff   minimum   ± %  reference    diff  grid")
    for ratio, reference in REFERENCE.items():
        contact = scene(ratio)
        plan = replace(pyworm.plan(contact, ACCURACY), largest_grid=LARGEST_GRID)
        solution = pyworm.solve(contact, plan)
        unit = scales(contact).groups.moes_film
        cells = [f"{ratio:6.3g}"]
        for name, wanted in zip(("film_central", "film_min"), reference, strict=True):
            film = getattr(solution.figures, name)
            cells.append(f"{film.value / unit:9.4f} {100 * film.error:5.2f}")
            cells.append(
                f"{'':>9} {'':>8}"
                if wanted is None
                else f"{wanted:9.3f} {film.value / unit / wanted - 1:+8.2%}"
            )
        size = f"{solution.fields.sizes['x']} x {solution.fields.sizes['y']}"
        print(*cells, size, "" if solution.converged else solution.stop_reason, flush=True)


if __name__ == "__main__":
    main()
