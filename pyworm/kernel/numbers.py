"""Oils and bodies as the numbers that the kernel takes."""

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.formulas.layered_half_space import Layer
from pyworm.io.present import present
from pyworm.kernel import core
from pyworm.materials.body import Body
from pyworm.materials.flow_laws import SHAPED, FlowLaw
from pyworm.materials.oil import Oil
from pyworm.materials.tabulated import TabulatedDensity, TabulatedViscosity
from pyworm.materials.thermal_properties import OilHeat

_FLOW_LAWS = {
    "newtonian": 0, "eyring": 1, "bair-winer": 2, "eyring-limited": 3, "carreau": 4,
    "carreau-yasuda": 5, "tabulated": 5,
}  # fmt: skip
"""Numbers of the laws in `fortran/oil/flow_laws.f90`."""


def oil_numbers(oil: Oil) -> tuple[float, ...]:
    """The oil for the kernel: law, eta0, exponent, pole pressure, d1, d2 (`viscosity_density`)."""
    law, density = oil.viscosity, oil.density
    compressed = (0.0, 0.0) if isinstance(density, TabulatedDensity) else (density.d1, density.d2)
    if isinstance(law, TabulatedViscosity):
        return 3, law.eta0, law.alpha, 1.0, *compressed
    return law.KERNEL_NUMBER, law.eta0, *law.kernel_constants, *compressed


def layer_numbers(layers: Sequence[Layer | None]) -> Array:
    """Layers on both bodies for the kernel (`fortran/elastic/coated_surface.f90`); zeros of a bare body."""
    numbers = np.zeros((5, 2), order="F")
    for body, layer in enumerate(layers):
        if layer is not None:
            numbers[:, body] = layer.thickness, *layer.moduli, *layer.poisson_ratios
    return numbers


def flow_numbers(law: FlowLaw) -> tuple[float | Array, ...]:
    """A flow law for the kernel: law, stress and its courses, limit and its rise, exponent, tables."""
    shaped = law.law in SHAPED
    tables = _shape_tables(law) if shaped else (*(np.zeros((4, 1), order="F"),) * 2, 1.0)
    return (
        _FLOW_LAWS[law.law] + (shaped and law.limited),
        law.stress or 1.0,
        law.stress_pressure,
        law.stress_temperature,
        law.limit,
        law.limit_pressure,
        1.0 if shaped else law.exponent,
        *tables,
    )


def heat_numbers(oil: Oil) -> Array:
    """Thermal properties of an oil as arguments of the kernel (`bindings.f90`, point_film_heat)."""
    heat = oil.thermal
    return np.array(
        [
            heat.inlet_temperature,
            heat.viscosity_exponent,
            heat.expansivity,
            heat.expansivity_decay,
            heat.conductivity,
            heat.conductivity_c1,
            heat.conductivity_c2,
            oil.density.rho0 * heat.specific_heat,
            heat.heat_capacity_k1,
            heat.heat_capacity_k2,
            heat.heat_capacity_b0,
            heat.heat_capacity_b1,
            heat.heat_capacity_b2,
        ]
    )


def bodies_numbers(bodies: Sequence[Body], heat: OilHeat) -> Array:
    """Thermal properties of both bodies as arguments of the kernel, a column each."""
    columns = [
        (
            body.conductivity,
            body.heat_capacity,
            present(body.bulk_temperature, "bulk_temperature") - heat.inlet_temperature,
        )
        for body in bodies
    ]
    return np.array(columns).T


@lru_cache(maxsize=8)
def _shape_tables(law: FlowLaw) -> tuple[Array, Array, float]:
    """Tables of eta rate/tau over (tau/G)^2 and (eta rate/G)^2, and cells for each unit of ln(1 + s)."""
    newtonian = np.geomspace(1e-6, 1e16, 8000)
    tables: tuple[Array, Array, float] = core.bindings.flow_tables(
        newtonian, law.shape_at(newtonian), LOG_CELLS
    )
    return tables


LOG_CELLS = 600
"""Cells of a table of thinning (`fortran/oil/flow_table.f90`)."""
