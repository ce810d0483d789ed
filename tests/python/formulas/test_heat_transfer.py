"""Heat transfer of a gear unit's surfaces, against worked examples of textbooks and of another library."""

import pytest

from pyworm.formulas.heat_transfer import (
    Fluid,
    air,
    forced_along,
    free_below,
    free_on_top,
    free_on_wall,
    long_fin,
    mixed,
    radiation,
    rotating_disc,
    rotating_shaft,
    spreading,
)


def fluid(prandtl, conductivity=1.0):
    """A fluid whose Rayleigh number is the cube of the length, at an excess of 1 K."""
    diffusivity = 1e-5
    expansion = prandtl * diffusivity**2 / 9.81
    return Fluid(conductivity, prandtl * diffusivity, diffusivity, expansion)


def test_air_is_that_of_incropera_s_table():
    """Incropera et al. (2011), table A.4: 300 and 400 K at 1 bar."""
    for temperature, conductivity, viscosity, prandtl in (
        (300, 26.3e-3, 15.89e-6, 0.707),
        (400, 33.8e-3, 26.41e-6, 0.690),
    ):
        found = air(temperature)
        assert found.conductivity == pytest.approx(conductivity, rel=0.02)
        assert found.viscosity == pytest.approx(viscosity, rel=0.02)
        assert found.prandtl == pytest.approx(prandtl, rel=0.02)


def test_a_firescreen_loses_what_the_worked_example_has():
    """Incropera et al. (2011), example 9.2: 0.71 m at 232 degC in 23 degC: Ra 1.813e9, Nu 147, h 7.0, 1060 W.

    The library ht has 147.16185223770603 at Pr 0.69 and Gr 2.63e9.
    """
    hot = Fluid(33.8e-3, 26.4e-6, 38.3e-6, 0.0025)
    assert hot.rayleigh(0.71, 209) == pytest.approx(1.813e9, rel=2e-3)
    coefficient = free_on_wall(hot, 0.71, 209)
    assert coefficient == pytest.approx(7.0, abs=0.05)
    assert coefficient * 0.71 * 1.02 * 209 == pytest.approx(1060, rel=5e-3)
    rayleigh = 0.69 * 2.63e9
    length = rayleigh ** (1 / 3)
    assert free_on_wall(fluid(0.69), length, 1.0) * length == pytest.approx(147.16185, rel=1e-6)


def test_horizontal_plates_are_mcadams_s():
    """The library ht at Ra 3.21e6: 22.857041558492334 above, 11.428520779246167 below a warm plate."""
    length = 3.21e6 ** (1 / 3)
    assert free_on_top(fluid(1.0), length, 1.0) * length == pytest.approx(22.857041558492334)
    assert free_below(fluid(1.0), length, 1.0) * length == pytest.approx(11.428520779246167)
    # 1e9: 0.15 times 1000
    assert free_on_top(fluid(1.0), 1e3, 1.0) * 1e3 == pytest.approx(150)


def test_flow_along_a_plate_is_that_of_the_worked_example():
    """Incropera et al. (2011), example 7.1: Re 9597, Pr 0.687, Nu 57.4, h 4.18 W/(m2 K)."""
    thin = Fluid(36.4e-3, 5.21e-4, 5.21e-4 / 0.687, 1 / 437)
    assert 10 * 0.5 / thin.viscosity == pytest.approx(9597, rel=1e-3)
    assert forced_along(thin, 0.5, 10.0) == pytest.approx(4.18, abs=0.01)
    turbulent = (0.037 * 1e6**0.8 - 871) * 0.687 ** (1 / 3)
    fast = forced_along(thin, 1.0, 1e6 * thin.viscosity)
    assert fast == pytest.approx(turbulent * thin.conductivity)
    assert mixed(3.0, 4.0) == pytest.approx(91 ** (1 / 3))


@pytest.mark.parametrize(("conductivity", "heat"), [(398, 8.3), (180, 5.6), (14, 1.6)])
def test_long_rods_are_those_of_the_worked_example(conductivity, heat):
    """Incropera et al. (2011), example 3.9: 5 mm rods at 100 degC in 25 degC, h = 100 W/(m2 K)."""
    assert long_fin(100, conductivity, 5e-3) * 75 == pytest.approx(heat, abs=0.05)


def test_radiation_turning_bodies_and_footprint():
    # between equal temperatures 4 eps sigma T^3; over a difference eps sigma (T^4 - T0^4)
    assert radiation(0.9, 300, 300) == pytest.approx(0.9 * 4 * 5.670374e-8 * 300**3)
    heat = 0.8 * 5.670374e-8 * (400**4 - 300**4)
    assert radiation(0.8, 400, 300) * 100 == pytest.approx(heat)
    # Levich's thickness of the layer is 1.61 D^(1/3) nu^(1/6) w^(-1/2)
    oil = Fluid(0.14, 80e-6, 8e-8, 7e-4)
    layer = 1.61 * oil.diffusivity ** (1 / 3) * oil.viscosity ** (1 / 6) * 157**-0.5
    assert rotating_disc(oil, 157) == pytest.approx(0.14 / layer, rel=3e-3)
    shaft = 0.133 * (100 * 0.05**2 / 1e-5) ** (2 / 3)
    assert rotating_shaft(fluid(1.0), 0.05, 100) == pytest.approx(shaft / 0.05)
    # a disc of 0.2 m on concrete: S = 2 D
    assert spreading(1.4, 0.01 * 3.14159265) == pytest.approx(2 * 1.4 * 0.2)
