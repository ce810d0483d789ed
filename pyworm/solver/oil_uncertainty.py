"""Uncertainty of films by a pressure-viscosity coefficient that was not measured.

The coefficient of an oil from the library is its base stock's, from which measured oils lie off by
`Oil.alpha_spread`. How films follow is told by the closed forms of the plan, whose exponents are right where
their films are some per cent off: nothing is solved anew.
"""

from dataclasses import replace

from pyworm.materials.tabulated import TabulatedViscosity
from pyworm.planning.prediction import predicted
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene

FILMS = ("film_central", "film_min")
"""Figures that have this uncertainty."""


def oil_uncertainty(scene: Scene | LineScene) -> dict[str, float]:
    """Relative uncertainty of films [-]; empty for an oil whose coefficient is known.

    The change from a coefficient smaller by the spread to the one assumed: most measured ones are larger.
    """
    oil = scene.oil
    law = oil.viscosity
    if oil.alpha_spread == 0 or isinstance(law, TabulatedViscosity):
        return {}
    less = law.with_alpha_times(1 / (1 + oil.alpha_spread))
    other = predicted(replace(scene, oil=replace(oil, viscosity=less)))
    assumed = predicted(scene)
    return {name: abs(getattr(assumed, name) / getattr(other, name) - 1) for name in FILMS}
