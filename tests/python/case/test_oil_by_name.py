"""Oils of case files by name and temperature: the tables they fill in, what is given beside, refusals."""

import json
from dataclasses import astuple

import pytest
from folders import CASES
from hypothesis import given, settings
from hypothesis import strategies as st

import pyworm
from pyworm.case.oil import OilTable
from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.library import named_oil, names
from pyworm.materials.viscosity_density import Barus

CASE = CASES / "ball_pag_460.toml"
OIL = CASE.read_text().partition("[oil]")[0]
"""The shipped case without its oil."""


def oil(**tables):
    return OilTable.model_validate(
        {"name": "PAG VG 460", "temperature": "60 degC"} | tables, strict=True
    ).oil()


def loaded(tmp_path, text):
    path = tmp_path / "case.toml"
    path.write_text(f"{OIL}[oil]\n{text}")
    return pyworm.load(path)


@settings(max_examples=25, deadline=None)
@given(st.sampled_from(names()), st.floats(30, 110))
def test_a_case_has_the_named_oil_to_the_last_digit(name, celsius):
    kelvin = celsius + 273.15
    table = OilTable.model_validate({"name": name, "temperature": f"{kelvin!r} K"})
    assert table.oil() == named_oil(name).oil(kelvin)


def test_any_spelling_of_the_name_becomes_the_oil_s_own():
    table = OilTable.model_validate({"name": "pag ISO VG 460", "temperature": "140 degF"})
    assert table.name == "PAG VG 460"
    assert table.heat.inlet_temperature == pytest.approx(333.15)


def test_spread_of_alpha_is_the_base_stock_s_unless_alpha_is_given():
    assert oil(name="mineral VG 220").alpha_spread == 0.28
    assert oil(name="mineral VG 220", viscosity={"eta0": "0.1 Pa s"}).alpha_spread == 0.28
    assert oil(name="mineral VG 220", viscosity={"alpha": "20 1/GPa"}).alpha_spread == 0
    assert oil(name="mineral VG 220", viscosity={"z": 0.6}).alpha_spread == 0
    assert oil(name="mineral VG 220", alpha_spread=0.1).alpha_spread == 0.1


def test_boundary_friction_is_the_base_stock_s_unless_it_is_given():
    rubbing = [oil(name=f"{base} VG 220").boundary_friction for base in ("mineral", "PAO", "PAG")]
    assert rubbing == sorted(rubbing, reverse=True)
    assert all(0.05 < one < 0.08 for one in rubbing)
    assert oil(boundary_friction=0.07).boundary_friction == 0.07


def test_a_table_with_its_law_stands_as_it_is():
    whole, other = oil(), oil(shear={"law": "newtonian"})
    assert other.flow == FlowLaw("newtonian")
    assert (other.viscosity, other.density, other.heat) == (
        whole.viscosity,
        whole.density,
        whole.heat,
    )
    barus = oil(viscosity={"law": "barus", "eta0": "0.2 Pa s", "alpha": "9.5 1/GPa"})
    assert isinstance(barus.viscosity, Barus)
    assert barus.viscosity.eta0 == 0.2
    assert barus.viscosity.alpha == pytest.approx(9.5e-9, rel=1e-15)
    slope = named_oil("PAG VG 460").viscosity_slope(333.15)
    assert barus.heat.viscosity_exponent == pytest.approx(slope, rel=1e-15)


def test_keys_without_law_go_in_place_of_the_oil_s_own():
    whole = oil()
    assert oil(viscosity={"alpha": "9.5 1/GPa"}).viscosity.alpha == pytest.approx(9.5e-9)
    by_exponent = oil(viscosity={"z": 0.227}).viscosity
    assert (by_exponent.z, by_exponent.eta0) == (0.227, whole.viscosity.eta0)
    assert oil(density={"rho0": "1 g/cm^3"}).density.rho0 == pytest.approx(1000)
    assert oil(density={"rho0": "1 g/cm^3"}).density.d1 == whole.density.d1
    assert oil(shear={"limit": "80 MPa"}).flow.limit == pytest.approx(80e6)
    warm = oil(heat={"conductivity": "0.16 W/(m K)", "s0": 0.782}).heat
    assert (warm.conductivity, warm.viscosity_exponent) == (0.16, 0.782)
    assert astuple(warm)[3:6] == astuple(whole.heat)[3:6]
    assert oil(supply="2 um").supply == pytest.approx(2e-6)


def test_the_resolved_case_holds_the_numbers_and_makes_the_same_oil():
    case = pyworm.load(CASE)
    kept = json.loads(json.dumps(case.resolved))["oil"]
    assert "temperature" not in kept
    assert kept["name"] == "PAG VG 460"
    scene, table = case.scene(), named_oil("PAG VG 460")
    assert kept["viscosity"]["eta0"] == scene.oil.viscosity.eta0 == table.viscosity(333.15)
    assert kept["viscosity"]["alpha"] == pytest.approx(9.5e-9)  # given beside
    assert kept["density"]["rho0"] == table.density(333.15)
    assert kept["heat"]["inlet_temperature"] == 333.15
    assert kept["heat"]["beta"] == table.viscosity_slope(333.15)
    assert kept["shear"]["limit"] == scene.oil.flow.limit == 100e6
    assert scene.bodies[0].bulk_temperature == 333.15
    assert case.physics["oil"] == case.resolved["oil"]


def test_without_a_temperature_a_name_is_only_a_name(tmp_path):
    spelled = (
        'name = "PAG VG 460"\nviscosity = {law = "barus", eta0 = "0.3 Pa s", alpha = "1 1/GPa"}'
    )
    case = loaded(tmp_path, spelled + '\ndensity = {law = "incompressible", rho0 = "1 g/cm^3"}\n')
    assert case.scene().oil.viscosity.eta0 == 0.3
    assert case.scene().oil.heat is None


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (
            'name = "PGA VG 460"\ntemperature = "60 degC"',
            'oil.name = "PGA VG 460": must be a base stock (mineral, PAO, ester, PAG) and a grade',
        ),
        ('name = "PGA VG 460"\ntemperature = "60 degC"', '"PAG VG 460" or "PAO VG 46"?'),
        ('name = "PAG VG 461"\ntemperature = "60 degC"', 'did you mean "PAG VG 46'),
        ('name = "water"\ntemperature = "60 degC"', 'such as "PAG VG 460"\n'),
        ('temperature = "60 degC"', "oil.name is missing"),
        ('name = "PAG VG 460"', "oil.temperature is missing"),
        (
            'name = "PAG VG 460"\ntemprature = "60 degC"',
            "oil.temprature: no such key; did you mean t",
        ),
        (
            'name = "PAG VG 460"\ntemperature = 60',
            "oil.temperature = 60: must be a temperature with",
        ),
        (
            'name = "PAG VG 460"\ntemperature = "-105 degC"',
            'oil.temperature = "-105 degC": too far from what is known of PAG VG 460, give one',
        ),
        (
            'name = "PAG VG 460"\ntemperature = "60 degC"\nviscosty.alpha = "9 1/GPa"',
            "oil.viscosty: no such key; did you mean viscosity?",
        ),
        (
            'name = "PAG VG 460"\ntemperature = "60 degC"\nviscosity.alfa = "9 1/GPa"',
            "oil.viscosity.alfa: no such key; did you mean alpha?",
        ),
        (
            'name = "PAG VG 460"\ntemperature = "60 degC"\nviscosity.alpha = "9 mm"',
            'oil.viscosity.alpha = "9 mm": must be a pressure-viscosity coefficient with its unit',
        ),
        (
            'name = "PAG VG 460"\ntemperature = "60 degC"\nviscosity = {alpha = "9 1/GPa", z = 0.2}',
            "oil.viscosity: give either z or alpha, one of the two",
        ),
        ('name = "PAG VG 460"\ntemperature = "60 degC"\nheat = 5', "oil.heat = 5: must be a table"),
        (
            'name = "PAG VG 460"\ntemperature = "60 degC"\nheat.inlet_temperature = "50 degC"',
            "oil: give either temperature or heat.inlet_temperature",
        ),
    ],
)
def test_one_sentence_for_bad_input(tmp_path, capsys, text, sentence):
    path = tmp_path / "case.toml"
    path.write_text(f"{OIL}[oil]\n{text}\n")
    assert main(["check", str(path)]) == BAD_INPUT
    said = capsys.readouterr().err
    assert sentence in said
    assert said.count("\n") == 1


def test_bodies_need_thermal_constants_for_a_named_oil(tmp_path, capsys):
    text = CASE.read_text().replace('conductivity = "52 W/(m K)"\n', "", 1)
    (tmp_path / "case.toml").write_text(text)
    assert main(["check", str(tmp_path / "case.toml")]) == BAD_INPUT
    said = capsys.readouterr().err
    assert "bodies.body_2.conductivity is missing; [oil.heat] of PAG VG 460 asks for it" in said


def test_a_sweep_may_go_over_oils_and_temperatures(tmp_path):
    from pyworm.batch.sweep import load_sweep

    (tmp_path / "sweep.toml").write_text(
        f'title = "Oils"\ncase = "{CASE}"\n[[vary]]\n"oil.name" = ["PAO VG 220", "PAG VG 460"]\n'
        '[[vary]]\n"oil.temperature" = ["40 degC", "80 degC"]\n'
    )
    sweep = load_sweep(tmp_path / "sweep.toml")
    for values, task in zip(sweep.values, sweep.tasks, strict=True):
        kelvin = float(values["oil.temperature"].split()[0]) + 273.15
        viscosity = named_oil(values["oil.name"]).viscosity(kelvin)
        assert task.scene.oil.viscosity.eta0 == pytest.approx(float(viscosity), rel=1e-12)
