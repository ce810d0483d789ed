"""Equivalent reduced modulus of coated bodies: of bare ones with the same energy under Hertz's pressure.

Scales, windows and film formulas take it; films and dry contacts are deflected with the layers themselves.
"""

from functools import lru_cache

from pyworm.formulas.hertz import hertz, hertz_line
from pyworm.formulas.layered_half_space import Layer
from pyworm.materials.body import Body

STEPS = 6
"""Steps between the modulus and the half-width of the contact, which changes with its third or half power."""


@lru_cache(maxsize=256)
def coated_modulus(
    layers: tuple[Layer | None, Layer | None],
    compliances: tuple[float, float],
    radii: tuple[float, ...],
    load: float,
) -> float:
    """E' [Pa] of bodies of which at least one is coated, at the smaller half-width of their dry contact.

    Args:
        layers: Layer on each body.
        compliances: (1 - nu^2)/E of each body without it [1/Pa].
        radii: Relative radii of curvature along each direction [m].
        load: Load [N], of a line contact that for each length [N/m].
    """
    modulus = 2 / sum(compliances)
    for _ in range(STEPS):
        size = _half_width(radii, load, modulus)
        modulus = 2 / sum(
            bare if layer is None else layer.contact_compliance(size)
            for layer, bare in zip(layers, compliances, strict=True)
        )
    return modulus


def _half_width(radii: tuple[float, ...], load: float, modulus: float) -> float:
    """Smaller half-width of the dry contact [m]."""
    if len(radii) == 1:
        return hertz_line(radii[0], load, modulus).half_width
    contact = hertz(radii[0], radii[1], load, modulus)
    return min(contact.semi_axis_x, contact.semi_axis_y)


def compliance(body: Body) -> float:
    """(1 - nu^2)/E of a body without its coating [1/Pa]."""
    return (1 - body.poisson_ratio**2) / body.youngs_modulus
