"""Oils of one's own: functions, measurements and shear laws that the kernel has as tables."""

from dataclasses import replace
from math import exp

import numpy as np
import pytest
from contacts import INLET, ball, roller

import pyworm
from pyworm.formulas.liquids import Doolittle, RoelandsFit, Tait, Yasutomi
from pyworm.io.input_error import CaseError
from pyworm.materials.tabulated import TabulatedDensity, TabulatedViscosity

TAIT = Tait(298.0, 864.0, 1.312e9, 0.0, 11.74, 8e-4)
SQUALANE = Doolittle(TAIT, 0.0276, 5.258, 0.6633)


def as_tables(oil):
    """An oil of closed forms by functions of pressure and temperature."""
    heat = oil.heat

    def eta(pressure, temperature):
        return np.vectorize(oil.eta)(pressure, temperature - INLET)

    def rho(pressure, temperature):
        spread = heat.expansivity * np.exp(-heat.expansivity_decay * pressure)
        return oil.density(pressure) * (1 - spread * (temperature - INLET))

    viscosity, density = TabulatedViscosity.of(eta, INLET), TabulatedDensity.of(rho, INLET)
    return replace(oil, viscosity=viscosity, density=density)


def figures(scene, effects):
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.05, effects))
    assert solution.converged
    krylov = int(solution.history["krylov"].sum())
    return solution.figures.values(), krylov


@pytest.mark.parametrize("make", [ball, roller])
@pytest.mark.parametrize("effects", ["isothermal", "all"])
def test_a_table_of_roelands_law_gives_its_film_in_as_many_iterations(make, effects):
    """Newton's iteration takes as many steps only where the derivatives are right."""
    scene = make()
    closed, steps = figures(scene, effects)
    tables, others = figures(replace(scene, oil=as_tables(scene.oil)), effects)
    assert others <= 1.1 * steps + 2
    for name, value in closed.items():
        assert tables[name] == pytest.approx(value, rel=2e-4), name


def test_a_table_of_eyrings_law_gives_its_friction():
    stress = 6e6
    closed = pyworm.FlowLaw("eyring", stress=stress)
    table = pyworm.FlowLaw.of(lambda newtonian: stress * np.arcsinh(newtonian / stress), stress)
    (one, _), (other, _) = (
        figures(replace(ball(), oil=replace(ball().oil, flow=law)), "all")
        for law in (closed, table)
    )
    assert other["friction_coefficient"] == pytest.approx(one["friction_coefficient"], rel=1e-4)
    assert other["film_min"] == pytest.approx(one["film_min"], rel=1e-4)


def test_a_limited_table_is_the_limited_law_of_the_paper():
    """Eyring up to a limiting stress, where the walls slip too: heavier, and sliding."""
    limit = {"limit": 3e6, "limit_pressure": 0.03}
    stress = 4e6
    closed = pyworm.FlowLaw("eyring-limited", stress=stress, **limit)
    table = pyworm.FlowLaw.of(lambda y: stress * np.arcsinh(y / stress), stress, **limit)
    assert table.stress_at(3e7, 5e8) == pytest.approx(closed.stress_at(3e7, 5e8), rel=1e-4)
    (one, _), (other, _) = (
        figures(ball(oil=replace(ball().oil, flow=law), load=60.0), "all")
        for law in (closed, table)
    )
    assert other["friction_coefficient"] == pytest.approx(one["friction_coefficient"], rel=1e-3)
    assert other["film_min"] == pytest.approx(one["film_min"], rel=1e-3)


def test_two_equal_branches_are_one_and_a_second_branch_carries_more():
    one = pyworm.FlowLaw("carreau-yasuda", stress=5e6, exponent=0.5, yasuda=1.6)
    halves = (pyworm.Branch(0.5, 1.0, 0.5, 1.6),) * 2
    two = pyworm.FlowLaw("carreau-yasuda", stress=5e6, branches=halves)
    firm = (pyworm.Branch(0.5, 1.0, 0.5, 1.6), pyworm.Branch(0.5, 1e3, 0.5, 1.6))
    solvent = pyworm.FlowLaw("carreau-yasuda", stress=5e6, branches=firm)
    assert two.stress_at(4e7, 0.0) == pytest.approx(one.stress_at(4e7, 0.0))
    assert solvent.stress_at(4e7, 0.0) > 1.4 * one.stress_at(4e7, 0.0)
    found = [
        figures(ball(oil=replace(ball().oil, flow=law)), "all")[0]["friction_coefficient"]
        for law in (one, two, solvent)
    ]
    assert found[1] == pytest.approx(found[0], rel=1e-6)
    assert found[2] > 1.01 * found[0]


def test_carreau_and_yasudas_law_is_the_published_one():
    law = pyworm.FlowLaw("carreau-yasuda", stress=6e6, exponent=0.42, yasuda=2.0)
    for rate_stress in (1e4, 6e6, 1e9):
        shown = rate_stress * (1 + (rate_stress / 6e6) ** 2) ** ((0.42 - 1) / 2)
        assert law.stress_at(rate_stress, 0.0) == pytest.approx(shown)


def test_measurements_at_a_few_places_are_enough():
    """A table as from a viscometer, at which the spline is exact."""
    law = pyworm.Roelands(0.05, 0.6)
    pressures = np.array([1e5, 1e8, 2e8, 4e8, 6e8, 9e8, 1.2e9])
    temperatures = np.array([INLET])
    measured = TabulatedViscosity(pressures, temperatures, law(pressures)[:, None], INLET)
    assert measured(4e8 - 1e5) == pytest.approx(law(4e8), rel=1e-6)
    assert measured(3e8) == pytest.approx(law(3e8), rel=0.01)
    assert measured.alpha == pytest.approx(law.alpha, rel=0.1)
    scene = ball(oil=pyworm.Oil(measured, pyworm.Density.dowson_higginson(870.0)))
    own, _ = figures(scene, "isothermal")
    exact, _ = figures(replace(scene, oil=replace(scene.oil, viscosity=law)), "isothermal")
    assert own["film_central"] == pytest.approx(exact["film_central"], rel=0.05)


def test_free_volume_is_the_closed_form_at_the_origin():
    """d ln eta/dp = B R0/(1 - R0)^2/K0, and -d ln eta/dT that times K0 aV."""
    tangent = 5.258 * 0.6633 / (1 - 0.6633) ** 2
    eta = SQUALANE(np.array([0.0, 1e3]), 298.0)
    assert eta[0] == pytest.approx(0.0276)
    assert np.log(eta[1] / eta[0]) / 1e3 == pytest.approx(tangent / 1.312e9, rel=1e-4)
    assert TAIT(0.0, 298.0) == pytest.approx(864.0)


def test_yasutomi_has_the_glass_viscosity_at_its_glass():
    law = Yasutomi(1e7, 190.0, 230.0, 0.5e-9, 0.2, 10e-9, 11.5, 40.0)
    glass = 190.0 + 230.0 * np.log1p(0.5)
    assert law(1e9, glass) == pytest.approx(1e7)
    assert law(0.0, 190.0 + 1e9) == pytest.approx(1e7 * 10**-11.5, rel=1e-3)


@pytest.mark.parametrize(
    ("name", "inlet", "law"),
    [
        ("squalane", 298.0, SQUALANE),
        ("PAO-B", 313.15, RoelandsFit(4.57, 1.25, 0.5, -0.071)),
    ],
)
def test_liquids_of_the_literature_are_within_their_published_fit(name, inlet, law):
    oil = pyworm.named_liquid(name, inlet)
    for pressure in (0.0, 1e8, 5e8, 1.2e9):
        for rise in (0.0, 20.0, 60.0):
            assert oil.viscosity(pressure, rise) == pytest.approx(
                law(pressure, inlet + rise), rel=1e-3
            )
    scene = ball(oil=oil, bodies=tuple(replace(of, bulk_temperature=inlet) for of in ball().bodies))
    effects = "all" if oil.flow else "isothermal"
    assert figures(scene, effects)[0]["film_central"] > 0


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: TabulatedViscosity.of(lambda p, t: -p, 313.0), "values = .*greater than zero"),
        (
            lambda: TabulatedViscosity([0, 1], [300], [[1], [2]], 300),
            "pressures: must be 4 or more",
        ),
        (
            lambda: TabulatedViscosity([0, 1, 2, 3], [300, 310], [[1]] * 4, 300),
            "values have the shape",
        ),
        (
            lambda: TabulatedViscosity(np.arange(4) * 1e8, [300, 310], np.ones((4, 2)), 350),
            "reference = 350 K: lies outside the temperatures",
        ),
        (
            lambda: replace(ball().oil, viscosity=TabulatedViscosity.of(SQUALANE, 298.0)),
            "is of 298 K, but the oil enters at 333.15 K",
        ),
        (lambda: pyworm.FlowLaw.of(lambda y: 2 * y, 6e6), "no stress may exceed its Newtonian one"),
        (
            lambda: pyworm.FlowLaw(
                "carreau-yasuda", stress=6e6, branches=(pyworm.Branch(0.5, 1, 0.5),)
            ),
            "add up to 0.5",
        ),
        (lambda: pyworm.named_liquid("squalene", 298.0), "must be one of squalane, PAO-B"),
    ],
)
def test_what_is_no_oil_is_refused(make, sentence):
    with pytest.raises(ValueError, match=sentence):
        make()


def test_a_derived_table_whose_formula_the_kernel_would_ignore_is_refused():
    class Own(TabulatedViscosity):
        def __call__(self, pressure, rise=0.0):
            return 1.0

    oil = ball().oil
    with pytest.raises(
        ValueError, match="viscosity is a Own: the kernel computes Barus or Roelands"
    ):
        replace(oil, viscosity=Own.of(SQUALANE, INLET))


CASE = """title = "own"
source = "test"
accuracy = "10 %"
[contact]
kind = "point-contact"
radii = ["10 mm", "10 mm"]
load = "20 N"
[motion]
velocity_1 = ["1.1 m/s", "0 m/s"]
velocity_2 = ["0.9 m/s", "0 m/s"]
[bodies.body_1]
material = "16MnCr5"
[bodies.body_2]
material = "16MnCr5"
"""

LIQUID = '[oil]\nliquid = "squalane"\ntemperature = "298 K"\n'
MEASURED = """[oil]
name = "measured"
[oil.viscosity]
law = "tabulated"
pressure = ["0 Pa", "100 MPa", "200 MPa", "400 MPa", "800 MPa"]
temperature = ["40 degC"]
viscosity_at = [["40 mPa s"], ["0.2 Pa s"], ["0.8 Pa s"], ["9 Pa s"], ["600 Pa s"]]
[oil.density]
law = "dowson-higginson"
rho0 = "850 kg/m^3"
"""


@pytest.mark.parametrize("oil", [LIQUID, MEASURED])
def test_case_files_have_them_too(tmp_path, oil):
    file = tmp_path / "own.toml"
    file.write_text(CASE + oil)
    case = pyworm.load(file)
    scene = case.scene()
    assert isinstance(scene.oil.viscosity, TabulatedViscosity)
    if oil is LIQUID:
        assert scene.oil == pyworm.named_liquid("squalane", 298.0)
    else:
        assert scene.oil.viscosity(2e8) == pytest.approx(0.8)
    from pyworm.case.case import case_again

    assert case_again(case.resolved).scene().oil == scene.oil


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (('"squalane"', '"squalene"'), "must be one of squalane, PAO-B"),
        (('temperature = "298 K"\n', ""), "temperature is missing, at which squalane enters"),
    ],
)
def test_a_wrong_liquid_of_a_case_is_refused(tmp_path, change, sentence):
    file = tmp_path / "own.toml"
    file.write_text(CASE + LIQUID.replace(*change))
    with pytest.raises(CaseError, match=sentence):
        pyworm.load(file)


def test_density_follows_tait_in_the_kernel():
    oil = pyworm.named_liquid("squalane", 298.0)
    assert oil.density(1e9) == pytest.approx(TAIT(1e9, 298.0), rel=1e-6)
    assert oil.density(1e9, 40.0) == pytest.approx(TAIT(1e9, 338.0), rel=1e-4)
    assert oil.density(0.0) == pytest.approx(864.0)
    assert exp(-oil.beta) < 1
