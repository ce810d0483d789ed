"""Closed forms of lubrication and scuffing along a line of action: film, specific film, contact temperature.

Each contact is taken as a steady line contact of its curvature, velocities and load; the oil is that of the
scenes.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from pyworm.drives.duty import LineOfAction
from pyworm.formulas.film import dowson_higginson, dowson_toyoda, line_groups
from pyworm.formulas.scuffing import effusivity, flash_temperature
from pyworm.formulas.wear_distress import specific_film
from pyworm.io import units
from pyworm.io.plain_values import PositiveNumber
from pyworm.io.present import present
from pyworm.materials.body import Body, composite_roughness, reduced_modulus
from pyworm.materials.oil import Oil

Array = np.ndarray


@dataclass(frozen=True)
class Surfaces:
    """Friction and scuffing data of the flanks."""

    friction_coefficient: PositiveNumber
    """Mean coefficient of friction of Blok's flash temperature [-]."""
    scuffing_temperature: units.ScuffingTemperature | None = None
    """Mean scuffing temperature of the oil [K]; None if not known."""


def contact_coefficient(body: Body) -> float:
    """Thermal contact coefficient of a body with heat [N/(m s^0.5 K)]."""
    return float(
        effusivity(
            present(body.conductivity, "conductivity"),
            present(body.density, "density"),
            present(body.specific_heat, "specific_heat"),
        )
    )


def mean_bulk_temperature(bodies: tuple[Body, Body]) -> float:
    """Mean bulk temperature of two bodies with heat [K]."""
    pinion, gear = (present(body.bulk_temperature, "bulk_temperature") for body in bodies)
    return (pinion + gear) / 2


def rate(
    contacts: Any, bodies: tuple[Body, Body], oil: Oil, surfaces: Surfaces | None
) -> LineOfAction:
    """The closed forms at contacts, by the oil as it enters them."""
    modulus = reduced_modulus(*bodies)
    half_width = np.sqrt(8 * contacts.unit_load * contacts.radius / (np.pi * modulus))
    groups = line_groups(
        contacts.radius,
        contacts.unit_load,
        modulus,
        contacts.entrainment,
        oil.viscosity.eta0,
        oil.viscosity.alpha,
    )
    least = dowson_higginson(groups).minima
    rating = {
        name: getattr(contacts, name)
        for name in ("phase", "radius", "unit_load", "pinion_velocity", "gear_velocity")
    } | {
        "hertz_pressure": 2 * contacts.unit_load / (np.pi * half_width),
        "film_central": dowson_toyoda(groups).central,
        "film_min": least,
    }
    roughness = composite_roughness(*bodies)
    if roughness is not None:
        rating["specific_film"] = specific_film(least, roughness)
    if surfaces is None:
        return LineOfAction(**rating)
    rating["scuffing_temperature"] = surfaces.scuffing_temperature
    if oil.heat is not None:
        effusivity_1, effusivity_2 = map(contact_coefficient, bodies)
        flash = flash_temperature(
            surfaces.friction_coefficient,
            contacts.unit_load,
            contacts.pinion_velocity,
            contacts.gear_velocity,
            effusivity_1,
            effusivity_2,
            half_width,
        )
        bulk = mean_bulk_temperature(bodies)
        rating |= {"flash_temperature": flash, "contact_temperature": bulk + flash}
    return LineOfAction(**rating)
