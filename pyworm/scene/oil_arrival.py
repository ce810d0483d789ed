"""Temperature of the oil that arrives at a contact between bodies of other temperatures than its supply's.

The oil that a film is made of comes in layers on both surfaces, each about half a film thick. They have been
with their surface for longer than heat takes to cross them, h^2 / (pi^2 a) with the diffusivity a of the oil:
1.3 us for 1 um, 0.13 ms for 10 um. So each has taken its body's temperature, which gear standards take, too
(DIN 3996 and ISO/TR 15144-1 have the film's viscosity at the bulk temperature of the teeth). Between them
temperature changes as by conduction, and its mean is that of both bodies.

It would be another one if the bodies met a bath of fresh oil a short way before the contact: two half-spaces
of different temperatures touch at the mean of both by their effusivities (k rho c)^(1/2), which does not
change with time, and from there temperature falls with the error function (Carslaw and Jaeger 1959, sections
2.4 and 2.10). By how much the oil that enters is nearer to its supply then is the uncertainty of its
temperature.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import erf, sqrt

from pyworm.io.present import present
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil


def bulk_temperature(body: Body) -> float:
    """Bulk temperature of a body where heat is simulated [K]; ValueError of one without."""
    return present(body.bulk_temperature, "bulk_temperature")


def arriving(oil: Oil, bodies: Sequence[Body]) -> Oil:
    """The oil as it arrives between two bodies: at the mean of their bulk temperatures."""
    supply, known = oil.thermal.inlet_temperature, oil.thermal.supply_temperature
    warmer = sum(bulk_temperature(body) for body in bodies) / 2 - supply
    if warmer == 0:
        return oil
    warmed = oil.warmed(warmer)
    heat = replace(warmed.thermal, supply_temperature=supply if known is None else known)
    return replace(warmed, heat=heat)


def nearer_to_supply(oil: Oil, body: Body, speed: float, film: float, distance: float) -> float:
    """How much nearer a layer is to its supply [K] if it met its body only a distance [m] before the contact.

    Negative of oil supplied colder than the body; the layer is half of the central film [m] and moves with
    the surface, at a speed [m/s] that is not zero.
    """
    heat = oil.thermal
    if heat.supply_temperature is None:
        return 0.0
    capacity = oil.density.rho0 * heat.specific_heat
    oil_effusivity = sqrt(heat.conductivity * capacity)
    body_effusivity = sqrt(body.thermal_inertia)
    touching = oil_effusivity / (oil_effusivity + body_effusivity)
    spread = 2 * sqrt(heat.conductivity / capacity * distance / speed)
    share = touching + (1 - touching) * erf(film / 2 / spread)
    return share * (heat.supply_temperature - bulk_temperature(body))
