"""Cases from Python: tables, numbers in SI, oils and solids as objects; checked as case files are."""

import tomllib

import numpy as np
import pytest
from folders import ROOT

import pyworm
from pyworm.case.python_input import oil_table

WORM = {
    "profile": "ZI",
    "centre_distance": "100 mm",
    "threads": 2,
    "teeth": 41,
    "module": "4 mm",
    "diameter_factor": 9,
    "hob": {"swivel": "0.3 deg"},
    "worm_speed": "1500 rpm",
    "wheel_torque": "500 N m",
    "sharing": "equal",
    "oil": {"name": "PAG VG 220", "temperature": "80 degC"},
    "bodies": ("16MnCr5", "CuSn12Ni2-C-GZ"),
}
"""A worm gear set that takes little time to check."""


def written(name):
    return tomllib.loads((ROOT / "cases" / f"{name}.toml").read_text())


def spur_pair(**changes):
    tables = written("spur_pair")
    drive = {key: value for key, value in tables["drive"].items() if key != "kind"}
    further = {key: tables[key] for key in ("oil", "bodies", "surfaces")}
    return pyworm.GearPair(**drive | tables["operation"] | further | changes)


@pytest.mark.parametrize("name", ["spur_pair", "line_thermal", "starved_ball"])
def test_a_dictionary_is_the_case_of_its_file(name):
    from_file, tables = pyworm.load(ROOT / f"cases/{name}.toml"), written(name)
    assert pyworm.load(tables, name).resolved == from_file.resolved


def test_keys_as_arguments_are_the_case_of_the_file():
    tables = pyworm.load(ROOT / "cases/spur_pair.toml").tables
    gears = spur_pair(name="spur pair")
    assert gears.name == "spur pair"
    for table in ("drive", "operation", "oil", "bodies", "surfaces"):
        assert getattr(gears.tables, table) == getattr(tables, table)


def test_numbers_in_si_are_as_good_as_texts():
    by_number = spur_pair(
        centre_distance=np.float64(0.0915),
        pinion_speed=50 * np.pi,
        power=31416,
        pressure_angle=np.deg2rad(20),
        phases=np.array([0.2, 0.35, 0.5, 0.65, 0.8]),
    )
    one, other = spur_pair().tables, by_number.tables
    assert other.drive.centre_distance == one.drive.centre_distance
    assert other.drive.pressure_angle == pytest.approx(one.drive.pressure_angle, rel=1e-14)
    assert other.operation.pinion_speed == pytest.approx(one.operation.pinion_speed, rel=1e-14)
    assert other.operation.power == one.operation.power
    assert other.operation.phases == one.operation.phases


@pytest.mark.parametrize(
    "oil",
    [
        pyworm.named_oil("PAG VG 220").oil("80 degC"),
        pyworm.Oil(
            pyworm.Barus("0.05 Pa s", "18 1/GPa"),
            pyworm.Density.dowson_higginson(860.0),
            heat=pyworm.OilHeat("60 degC", 0.03, 0.14, 1900.0),
            supply=pyworm.OilLayer(("-1 mm", "1 mm"), ("2 um", "3 um")),
        ),
        pyworm.Oil(
            pyworm.TabulatedViscosity.of(
                lambda p, t: 0.05 * np.exp(18e-9 * p) + 0 * t, 313.15, largest_pressure=6e8
            ),
            pyworm.Density.incompressible(860.0),
            pyworm.FlowLaw("carreau-yasuda", stress="5 MPa", exponent=0.6, yasuda=1.5),
        ),
    ],
    ids=["library", "own", "tabulated"],
)
def test_an_oil_is_the_same_in_the_tables_of_a_case(oil):
    contact = written("starved_ball") | {"oil": oil, "bodies": ("16MnCr5", "16MnCr5")}
    again = pyworm.load(contact).tables.oil.oil()
    assert again.density == oil.density
    assert again.heat == oil.heat
    assert again.supply == oil.supply
    assert (again.flow and again.flow.stress) == (oil.flow and oil.flow.stress)
    pressures = np.array([0.0, 1e8, 5e8])
    assert again.viscosity(pressures) == pytest.approx(oil.viscosity(pressures), rel=1e-12)


def test_solids_are_objects_names_or_tables():
    steel = pyworm.Body.from_name("16MnCr5", roughness="0.2 um")
    gears = spur_pair(bodies=(steel, "16MnCr5"), oil=pyworm.named_oil("PAO VG 220").oil("60 degC"))
    first, second = gears.drive.bodies
    assert first.roughness == 2e-7
    assert second.roughness is None
    assert first.youngs_modulus == second.youngs_modulus == steel.youngs_modulus


WRONG = {
    "a misspelt key": (
        lambda: pyworm.WormDrive(**WORM, worm_sped="1500 rpm"),
        r"^worm_sped: no such key; did you mean worm_speed or",
    ),
    "a key of another kind": (
        lambda: spur_pair(threads=2),
        "threads: no such key; valid keys are",
    ),
    "a size in millimetres as a number": (
        lambda: pyworm.WormDrive(**WORM | {"centre_distance": 100}),
        r'drive.centre_distance = "100 m": must be .*did you mean "100 mm"',
    ),
    "another dimension": (
        lambda: pyworm.WormDrive(**WORM | {"wheel_torque": "500 N"}),
        'operation.wheel_torque = "500 N": must be a torque',
    ),
    "one body": (
        lambda: pyworm.WormDrive(**WORM | {"bodies": ("16MnCr5",)}),
        "bodies: must be two, body 1 first",
    ),
    "a table for a density": (
        lambda: oil_table(
            pyworm.Oil(
                pyworm.Barus(0.05, 2e-8),
                pyworm.TabulatedDensity.of(lambda p, t: 860 * (1 + 1e-10 * p), 313.15),
            )
        ),
        "oil.density is a table",
    ),
    "a kind that there is not": (
        lambda: pyworm.gear_set("hypoid"),
        'drive.kind = "hypoid": must be one of "worm"|drive.kind = "hypoid": must be "worm"',
    ),
    "no subject": (
        lambda: pyworm.load({"title": "x"}),
        r"give either a \[drive\] or a \[contact\]",
    ),
}


@pytest.mark.parametrize("use", WRONG)
def test_wrong_input_is_refused_as_of_a_file(use):
    make, sentence = WRONG[use]
    with pytest.raises(pyworm.CaseError, match=sentence) as refused:
        make()
    assert "\n" not in str(refused.value)
