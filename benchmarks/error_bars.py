"""Whether error bars hold: random scenes at 1 %, against finer grids in a wider window.

Moes' parameters and the ratio of the radii are drawn log-uniformly, the angle of the entrainment and the spin
uniformly; the window has twice the reach. Run from the repository's root (it takes minutes):

    python benchmarks/error_bars.py [COUNT [SEED]]
"""

import sys
from dataclasses import replace
from math import cos, exp, log, pi, sin

import numpy as np

import pyworm
from pyworm.bodies import Body
from pyworm.formulas.film import radii_at_angle
from pyworm.formulas.hertz import hertz
from pyworm.oils import Density, Oil, Roelands
from pyworm.scene import Paraboloid, RigidMotion, Scene

STEEL = Body(205.66e9, 0.3)
OIL = Oil(Roelands.from_alpha(0.04, 22e-9), Density.dowson_higginson(870.0))
RADIUS = 0.01
ACCURACY = 0.01
MOST_NODES = 5_000_000


def random_scene(random: np.random.Generator) -> Scene:
    """A point contact: M 5 to 500, L 1 to 15, ratio of radii 1/10 to 10, any angle, spin up to rolling."""
    m, lubricant, ratio = (
        exp(random.uniform(log(a), log(b))) for a, b in ((5, 500), (1, 15), (0.1, 10))
    )
    angle = random.uniform(0, pi / 2)
    radii = (RADIUS, RADIUS / ratio)
    along, _ = radii_at_angle(*radii, angle)
    modulus = STEEL.youngs_modulus / (1 - STEEL.poisson_ratio**2)
    speed_group = (lubricant / (OIL.viscosity.alpha * modulus)) ** 4 / 2
    speed = speed_group * modulus * along / OIL.viscosity.eta0
    load = m * (2 * speed_group) ** 0.75 * modulus * along**2
    contact = hertz(*radii, load, modulus)
    spin = random.uniform(-1, 1) * speed / max(contact.semi_axis_x, contact.semi_axis_y)
    motion = RigidMotion(speed * cos(angle), speed * sin(angle), spin)
    return Scene(
        name=f"M {m:.3g} L {lubricant:.3g} Rx/Ry {ratio:.3g} at {np.degrees(angle):.0f} deg",
        gap=Paraboloid(*radii),
        radii=radii,
        motions=(motion, motion),
        load=load,
        bodies=(STEEL, STEEL),
        oil=OIL,
    )


def truth(scene: Scene, spacing: float) -> pyworm.Solution:
    """The scene in a window of twice the reach, on grids down to a quarter of a spacing [m]."""
    plan = pyworm.plan(scene, 1e-5, "all")
    finest = plan.wider_grids[-1]
    while finest.dx > 0.3 * spacing and finest.finer().nodes < MOST_NODES:
        finest = finest.finer()
    return pyworm.solve(
        scene,
        replace(
            plan, grids=plan.wider_grids, wider_grids=(), tolerance=1e-5, largest_grid=finest.nodes
        ),
    )


def main() -> None:
    count, seed = (int(word) for word in (*sys.argv[1:], *("20", "1")[len(sys.argv) - 1 :]))
    random = np.random.default_rng(seed)
    print(f"seed {seed}; true error over error bar, for the central and the minimum film")
    missed, worst = 0, 0.0
    for number in range(count):
        scene = random_scene(random)
        rough = pyworm.solve(scene, pyworm.plan(scene, ACCURACY, "all"))
        x = rough.fields.x.values
        exact = truth(scene, float(x[1] - x[0]))
        shares = []
        for name in ("film_central", "film_min"):
            bar, value = getattr(rough.figures, name), getattr(exact.figures, name).value
            shares.append(abs(bar.value / value - 1) / bar.error)
        missed += max(shares) > 1
        worst = max(worst, *shares)
        refined = (x[1] - x[0]) / float(exact.fields.x[1] - exact.fields.x[0])
        print(
            f"{number:3} {scene.name:44} {'' if rough.converged else rough.stop_reason} "
            f"{shares[0]:5.2f} {shares[1]:5.2f}  ({refined:.0f} times finer)",
            flush=True,
        )
    print(f"{count - missed} of {count} bars hold; the worst true error is {worst:.2f} of its bar")


if __name__ == "__main__":
    main()
