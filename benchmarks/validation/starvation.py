"""Films of starved contacts over flooded ones, against the law of Chevalier et al. (1998).

    python benchmarks/validation/starvation.py

For each contact and supply: film over flooded film, and the exponent g with which r/(1 + r^g)^(1/g) gives it.
A minute or two of one processor.
"""

from dataclasses import replace

from scipy.optimize import brentq

import pyworm
from pyworm.formulas.starvation import film_over_flooded

RATIOS = 0.3, 0.5, 1.0, 2.0, 5.0, 10.0
CONTACTS = {
    "ball": ((12.7e-3, 12.7e-3), 40.0),
    "ten times as wide as long": ((12.7e-3, 0.381), 200.0),
    "longer than wide": ((0.127, 12.7e-3), 100.0),
}
"""Name -> relative radii along and across the entrainment [m], load [N]."""


def scene_of(name: str) -> pyworm.Scene:
    """A steel contact that rolls at 0.5 m/s in an oil of one temperature."""
    steel = pyworm.Body.from_name("16MnCr5", bulk_temperature="60 degC")
    oil = replace(pyworm.named_oil("PAO VG 220").oil(333.15), flow=None, heat=None)
    radii, load = CONTACTS[name]
    return pyworm.Scene(
        name=name,
        gap=pyworm.Paraboloid(*radii),
        load=load,
        motions=(pyworm.RigidMotion(0.5, 0),) * 2,
        bodies=(steel, steel),
        oil=oil,
    )


def exponent(ratio: float, share: float) -> float:
    """Exponent with which the law gives a share; NaN where none does."""
    low, high = 0.3, 100.0
    if not film_over_flooded(ratio, low) < share < film_over_flooded(ratio, high):
        return float("nan")
    return brentq(lambda g: film_over_flooded(ratio, g) - share, low, high)


def main() -> None:
    """Solve and print all."""
    for name in CONTACTS:
        scene = scene_of(name)
        flooded = pyworm.solve(scene, pyworm.plan(scene, 0.005, "isothermal")).figures
        density = scene.oil.density
        squeezed = density(flooded.pressure_max.value) / density(0.0)
        print(f"{name}: M {flooded.moes_m:.0f}, L {flooded.moes_l:.1f}, {flooded.film_central} m")
        for ratio in RATIOS:
            supply = ratio * squeezed * flooded.film_central.value
            starved = replace(scene, oil=replace(scene.oil, supply=supply))
            solution = pyworm.solve(starved, pyworm.plan(starved, 0.005, "isothermal"))
            if solution.figures.supply is None:
                print(f"  r {ratio:4.1f}  counts as flooded")
                continue
            share = solution.figures.film_central / flooded.film_central
            told = (
                f"g {exponent(ratio, share.value):5.2f}" if solution.converged else "not converged"
            )
            print(f"  r {ratio:4.1f}  film {share}  {told}")


if __name__ == "__main__":
    main()
