"""Oil that arrives between bodies warmer or colder than its supply."""

from dataclasses import replace
from math import erf, sqrt

import pytest
from contacts import INLET, ball, roller, steel

from pyworm.scene.oil_arrival import nearer_to_supply


def between(contact, *rises):
    """A contact whose bodies are warmer than the oil's supply by some kelvin."""
    return contact(bodies=tuple(replace(steel(), bulk_temperature=INLET + of) for of in rises))


@pytest.mark.parametrize("contact", [ball, roller])
def test_oil_arrives_at_the_mean_of_the_bodies(contact):
    oil, warm = contact().oil, between(contact, 20.0, 5.0)
    assert warm.oil.heat.inlet_temperature == pytest.approx(INLET + 12.5)
    assert warm.oil.heat.supply_temperature == pytest.approx(INLET)
    assert warm.oil.viscosity.eta0 == pytest.approx(oil.eta(0.0, 12.5))
    assert warm.coldest == pytest.approx(-7.5)
    again = replace(warm, name="again")
    assert again.oil == warm.oil


def test_oil_as_warm_as_its_bodies_stays_as_it_is():
    assert between(ball, 0.0, 0.0).oil == ball().oil
    assert ball().oil.heat.supply_temperature is None


def test_a_layer_from_a_bath_is_nearer_to_its_supply():
    """As half-spaces in contact, and by the error function; oil that met its body long ago is as warm."""
    scene = between(roller, 10.0, 10.0)
    oil, (body, _) = scene.oil, scene.bodies
    capacity = oil.density.rho0 * oil.heat.specific_heat
    own = sqrt(oil.heat.conductivity * capacity)
    its = sqrt(body.conductivity * body.density * body.specific_heat)
    touching = own / (own + its)
    assert 0.03 < touching < 0.05
    far = nearer_to_supply(oil, body, speed=1.0, film=1e-6, distance=1e6)
    assert far == pytest.approx(-10 * touching, rel=1e-3)
    # where the layer is half as thick as heat spreads
    distance = (0.5e-6 / 2 / 0.5) ** 2 * capacity / oil.heat.conductivity
    near = nearer_to_supply(oil, body, speed=1.0, film=1e-6, distance=distance)
    assert near == pytest.approx(-10 * (touching + (1 - touching) * erf(0.5)), rel=1e-6)
    assert nearer_to_supply(roller().oil, body, 1.0, 1e-6, 0.01) == 0.0
