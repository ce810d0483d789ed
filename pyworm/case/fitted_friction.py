"""Fitted friction of asperities: worm gears of the standard's materials under oils of the library."""

from dataclasses import replace

from pyworm.case.bodies import BodyTable
from pyworm.case.oil import OilTable
from pyworm.formulas.unknown import Unknown
from pyworm.formulas.worm_curves import OIL_KINDS
from pyworm.formulas.worm_wheel_material import Family, wheel_material
from pyworm.materials.base_stock import base_stock
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil

FITTED_SPREADS: dict[Family, float] = {
    "tin bronze": 0.196,
    "aluminium bronze": 0.131,
    "cast iron": 0.134,
}
"""Group of wheel materials -> relative uncertainty of the boundary friction that was fitted to the worm
standard's friction: 19 of 20 rows left out of the fit need one within it
(`benchmarks/validation/boundary_friction.py`)."""


def with_fitted_friction(oil: Oil, table: OilTable, worm: BodyTable, wheel: BodyTable) -> Oil:
    """The oil of a worm drive, with the spread of the fit where its boundary friction is the library's.

    An own coefficient or factor of a material, or a material or oil that the standard does not have, is no
    part of the fit.
    """
    base = table.base
    if base is None or base not in OIL_KINDS:
        return oil
    if table.boundary_friction != base_stock(base).boundary_friction:
        return oil
    if wheel.material is None or worm.boundary_friction_factor not in (None, 1.0):
        return oil
    family = wheel_material(wheel.material).family
    if isinstance(family, Unknown):
        return oil
    factor = Body.from_name(wheel.material).boundary_friction_factor
    if wheel.boundary_friction_factor not in (None, factor):
        return oil
    return replace(oil, boundary_friction_spread=FITTED_SPREADS[family])
