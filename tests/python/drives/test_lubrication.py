"""Oil of drives from a bath or from jets: the layer at the mesh, what is assumed, and rules of practice."""

import tomllib

import pytest
from folders import CASES

import pyworm
from pyworm.case.case import case_of
from pyworm.io.input_error import CaseError
from pyworm.planning.effects.starvation import STARVATION

BATH = {"method": "bath", "body": "wheel", "depth": "40 mm"}
JETS = {"method": "jets", "flow": "1 l/min"}


def lubricated(lubrication, name="zi_drive", phases=(0.5,), **changes):
    """A case with one phase and a `[lubrication]`."""
    tables = tomllib.loads((CASES / f"{name}.toml").read_text())
    tables["operation"]["phases"] = list(phases)
    tables |= {"lubrication": lubrication} | changes
    return case_of(tables, name, CASES)


def layer(lubrication, name="zi_drive"):
    return lubricated(lubrication, name).drive.oil_supply.layer


def test_wheel_in_a_bath_floods_its_contacts():
    case = lubricated(BATH)
    scene = case.scene(0.5)
    assert scene.oil.supply == case.drive.oil_supply.layer
    assert 100e-6 < scene.oil.supply < 1e-3
    assert STARVATION.lacking(scene).startswith("flooded: the supply is")
    assert any("dips 40 mm" in sentence for sentence in case.drive.all_assumptions)
    assert not case.drive.oil_supply.warnings


def test_jets_that_are_too_small_starve_it():
    case = lubricated(JETS | {"flow": "0.01 l/min"})
    scene = case.scene(0.5)
    assert STARVATION.lacking(scene) is None
    plan = pyworm.plan(scene, 0.05, ("auto", "-squeeze"))
    assert any(effect.name == "starvation" and effect.on for effect in plan.effects)
    (warning,) = case.drive.oil_supply.warnings
    assert warning.startswith("lubrication.flow is 0.01 l/min for 31.9 kW, less than starved;")
    assert warning.endswith("adequate are 0.405 l/min (Errichello)")


def test_layers_follow_their_causes():
    """More flow, a thicker layer; on the outgoing side it drains; a faster body keeps less of a bath."""
    few, many = (layer(JETS | {"flow": f"{flow} l/min"}) for flow in (1, 2))
    assert many == pytest.approx(2 * few)
    assert layer(JETS | {"side": "outgoing"}) < few
    assert layer(BATH | {"body": "worm", "depth": "20 mm"}) < layer(BATH)
    assert layer(BATH | {"depth": "60 mm"}) == layer(BATH)


@pytest.mark.parametrize(
    ("name", "body"),
    [("errichello_speed_increaser", "gear"), ("roller_ref", "rollers"), ("roller_ref", "worm")],
)
def test_every_drive_has_its_oil(name, body):
    case = lubricated({"method": "bath", "body": body, "depth": "20 mm"}, name)
    assert 1e-6 < case.drive.oil_supply.layer < 5e-3
    assert case.scene().oil.supply == case.drive.oil_supply.layer


def test_without_lubrication_a_drive_says_what_it_assumes():
    tables = tomllib.loads((CASES / "zi_drive.toml").read_text())
    drive = case_of(tables, "zi_drive", CASES).drive
    assert drive.oil_supply is None
    assert "the oil supply to the teeth is not given" in drive.all_assumptions[-1]


def test_rules_of_practice_are_told():
    shallow = lubricated(BATH | {"depth": "5 mm"}).warnings
    assert any("gears should dip about twice that" in words for words in shallow)
    assert any("flanks below the level stay dry" in words for words in shallow)
    outgoing = lubricated(JETS | {"side": "outgoing"}).warnings
    assert any("practice is the incoming side" in words for words in outgoing)


@pytest.mark.parametrize(
    ("lubrication", "changes", "words"),
    [
        (BATH | {"body": "gear"}, {}, 'lubrication.body = "gear": must be one of worm, wheel'),
        (BATH | {"depth": "1 m"}, {}, "lubrication.depth is 1000 mm, but the wheel is"),
        ({"depth": "5 mm"}, {}, "lubrication.method is missing"),
        (JETS | {"flow": "1 mm"}, {}, "must be a flow of oil"),
        (JETS | {"depth": "1 mm"}, {}, "lubrication.depth: no such key"),
        (
            JETS,
            {"worm_rating": {"oil": "PAG VG 460", "lubrication": "bath"}},
            'contradicts lubrication.method = "jets"',
        ),
    ],
)
def test_impossible_lubrication_is_refused(lubrication, changes, words):
    with pytest.raises(CaseError) as refused:
        lubricated(lubrication, **changes)
    assert words in str(refused.value)


def test_a_drive_takes_one_supply():
    tables = tomllib.loads((CASES / "zi_drive.toml").read_text())
    tables["oil"]["supply"] = "1 um"
    tables["lubrication"] = BATH
    with pytest.raises(CaseError, match=r"either oil.supply or \[lubrication\]"):
        case_of(tables, "zi_drive", CASES)
