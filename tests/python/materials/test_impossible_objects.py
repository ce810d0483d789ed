"""Objects that no oil, solid or contact is: refused when they are made, since a solve may well converge."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from folders import CASES

import pyworm
from pyworm.materials.body import Body
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil
from pyworm.materials.thermal_properties import OilHeat
from pyworm.materials.viscosity_density import Barus, Density, Roelands
from pyworm.scene.point import Paraboloid

VISCOSITY, DENSITY = Roelands(0.04, 0.6), Density.dowson_higginson(870.0)
HEAT = {"inlet_temperature": 333.15, "viscosity_exponent": 1.1, "conductivity": 0.14}


@pytest.fixture(scope="module")
def scene():
    return pyworm.load(CASES / "point_m20_l10.toml").scene()


@pytest.fixture(scope="module")
def line():
    return pyworm.load(CASES / "line_m20_l10.toml").scene()


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (
            lambda: FlowLaw("carreau", stress=6e6, exponent=5.0),
            "exponent = 5: Carreau's n is above 0",
        ),
        (lambda: FlowLaw("carreau", stress=6e6, exponent=-1.0), "exponent = -1: Carreau's n"),
        (
            lambda: FlowLaw("carreau", stress=0.0, exponent=0.5),
            "stress = 0 Pa: must be finite and gr",
        ),
        (lambda: FlowLaw("eyring", stress=-3e6), "stress = -3e.06 Pa: must be finite and greater"),
        (lambda: FlowLaw("eyring", stress=float("nan")), "stress = nan Pa"),
        (lambda: FlowLaw("bair-winer"), "the larger of limit and limit_pressure = 0"),
        (lambda: FlowLaw("bair-winer", limit=-1e6), "limit = -1e.06 Pa: must lie between 0"),
        (
            lambda: FlowLaw("eyring-limited", stress=3e6, limit=1e8, exponent=0.0),
            "exponent = 0: must be fin",
        ),
        (
            lambda: FlowLaw("ering", stress=3e6),
            'law = "ering": must be one of "newtonian", "eyring"',
        ),
        (lambda: Barus(0.0, 2e-8), "eta0 = 0 Pa s"),
        (lambda: Barus(0.04, -2e-8), "alpha = -2e-08 1/Pa: must lie between 0"),
        (lambda: Barus(0.04, 22.0), "alpha = 22 1/Pa"),
        (lambda: Roelands(1e-6, 0.6), "eta0 = 1e-06 Pa s: must be above 6.3e-05 Pa s, the pole"),
        (lambda: Roelands(0.04, -0.6), "z = -0.6"),
        (lambda: Roelands(0.04, 0.6, 0.0), "p0 = 0 Pa"),
        (lambda: Density(-870.0, 0.0, 0.0), "rho0 = -870 kg/m3"),
        (lambda: Density(870.0, -1e-9, 0.0), "d1, d2 = -1e-09 1/Pa"),
        (lambda: OilHeat(**HEAT, specific_heat=0.0), "specific_heat = 0 J"),
        (
            lambda: OilHeat(**HEAT, specific_heat=2e3, expansivity=-1e-4),
            "expansivity = -0.0001 1/K",
        ),
        (
            lambda: Oil(
                VISCOSITY,
                DENSITY,
                heat=OilHeat(**HEAT | {"inlet_temperature": 60.0}, specific_heat=2e3),
            ),
            "inlet_temperature = 60 K: must be a temperature between .*; did you mean .60.0 degC",
        ),
        (lambda: Oil(VISCOSITY, DENSITY, supply=0.0), "supply = 0 m"),
        (lambda: Body(207e9, 0.6), "poisson_ratio = 0.6: must lie above -1 and be at most 0.5"),
        (lambda: Body(-207e9, 0.3), "youngs_modulus = -2.07e.11 Pa"),
        (lambda: Body(207e9, 0.3, conductivity=0.0), "conductivity = 0 W"),
    ],
)
def test_an_impossible_constant_is_refused(make, sentence):
    with pytest.raises(ValueError, match=sentence):
        make()


def test_constants_that_a_law_does_not_read_are_not_judged():
    assert FlowLaw("newtonian", stress=-1.0, exponent=7.0).law == "newtonian"
    assert FlowLaw("eyring", stress=3e6, limit=-1.0).stress == 3e6


class Thicker(Roelands):
    """A law of one's own, of which the kernel would see the constants only."""

    def __call__(self, pressure):
        return 2 * super().__call__(pressure)


@dataclass(frozen=True)
class Sticky(FlowLaw):
    def stress_at(self, newtonian, pressure):
        return 3 * newtonian


class Squeezed(Density):
    def __call__(self, pressure):
        return 2 * self.rho0


class Cold(Oil):
    def eta(self, pressure, rise=0.0):
        return 1.0


class Odd(Body):
    pass


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (
            lambda: Oil(Thicker(0.04, 0.6), DENSITY),
            "viscosity is a Thicker: the kernel computes Barus or",
        ),
        (lambda: Oil(lambda pressure: 0.04, DENSITY), "viscosity is a function"),
        (lambda: Oil(VISCOSITY, Squeezed(870.0, 0.0, 0.0)), "density is a Squeezed"),
        (lambda: Oil(VISCOSITY, DENSITY, flow=Sticky("eyring", stress=3e6)), "flow is a Sticky"),
    ],
)
def test_a_law_unknown_to_the_kernel_is_refused(make, sentence):
    with pytest.raises(ValueError, match=sentence):
        make()


def test_a_subclass_of_oil_or_body_is_refused_by_every_scene(scene, line):
    for one in (scene, line):
        with pytest.raises(
            ValueError, match="oil is a Cold: the kernel computes Oil from its const"
        ):
            replace(one, oil=Cold(VISCOSITY, DENSITY))
        with pytest.raises(ValueError, match="a body is a Odd"):
            replace(one, bodies=(one.bodies[0], Odd(207e9, 0.3)))


@pytest.mark.parametrize(
    ("gap", "radii"),
    [((0.01, 0.01), (0.02, 0.02)), ((0.02, 0.01), (0.01, 0.02)), ((0.01, 0.01), (0.01, 0.0102))],
)
def test_radii_that_contradict_the_gap_are_refused(scene, gap, radii):
    with pytest.raises(
        ValueError, match=f"contradict the gap, whose radii are {gap[0]}, {gap[1]} m"
    ):
        replace(scene, gap=Paraboloid(*gap), radii=radii)


def test_radii_of_a_line_and_of_a_sampled_gap_must_be_its_own(line):
    with pytest.raises(
        ValueError, match=r"radii 0.02 m contradict the gap, whose radii are 0.01 m"
    ):
        replace(line, radius=0.02)
    sampled = pyworm.load(CASES / "gap_example.toml").scene()
    with pytest.raises(ValueError, match="contradict the gap"):
        replace(sampled, radii=sampled.radii[::-1])


def test_a_gap_without_radii_takes_those_given(scene):
    def gap(x, y):
        return (x**2 + y**2) / 0.02, np.ones(x.shape, dtype=bool)

    assert replace(scene, gap=gap, radii=(0.01, 0.01)).radii == (0.01, 0.01)
