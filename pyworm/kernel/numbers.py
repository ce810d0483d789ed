"""Oils and bodies as the numbers that the kernel takes."""

import numpy as np

from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil
from pyworm.materials.thermal_properties import OilHeat
from pyworm.materials.viscosity_density import Barus

_FLOW_LAWS = {"newtonian": 0, "eyring": 1, "bair-winer": 2, "eyring-limited": 3, "carreau": 4}
"""Numbers of the laws in `fortran/oil/flow_laws.f90`."""


def oil_numbers(oil: Oil) -> tuple:
    """The oil for the kernel: law, eta0, exponent, pole pressure, d1, d2 (`viscosity_density`)."""
    law, density = oil.viscosity, oil.density
    if isinstance(law, Barus):
        return 1, law.eta0, law.alpha, 1.0, density.d1, density.d2
    return 2, law.eta0, law.z, law.p0, density.d1, density.d2


def flow_numbers(law: FlowLaw) -> tuple:
    """A flow law as the kernel takes it: law, stress and its courses, limit and its rise, exponent."""
    return (
        _FLOW_LAWS[law.law],
        law.stress or 1.0,
        law.stress_pressure,
        law.stress_temperature,
        law.limit,
        law.limit_pressure,
        law.exponent,
    )


def heat_numbers(oil: Oil) -> np.ndarray:
    """Thermal properties of an oil as arguments of the kernel (`bindings.f90`, point_film_heat)."""
    heat = oil.heat
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


def bodies_numbers(bodies, heat: OilHeat) -> np.ndarray:
    """Thermal properties of both bodies as arguments of the kernel, a column each."""
    columns = [
        (
            body.conductivity,
            body.density * body.specific_heat,
            body.bulk_temperature - heat.inlet_temperature,
        )
        for body in bodies
    ]
    return np.array(columns).T
