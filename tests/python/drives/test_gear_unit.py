"""Thermal network of gear units: a given conductance, sizes of a housing, a measured point, time."""

import json
import re
import tomllib

import numpy as np
import pytest
from folders import CASES, DATA, ROOT
from refusals import changed

from pyworm.batch import drive_iteration
from pyworm.batch.task import Task
from pyworm.case.case import case_of
from pyworm.cli.main import main
from pyworm.drives.heat_network import ThermalStep
from pyworm.drives.mesh_loss import MeshLoss
from pyworm.formulas import heat_transfer as ht
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.input_error import CaseError
from pyworm.ratings.rate import rate
from pyworm.ratings.standard_loss import standard_loss
from pyworm.ratings.temperatures import rate_temperatures

SIZES = """
[cooling.housing]
length = "1000 mm"
width = "500 mm"
height = "700 mm"
"""

COOLING = """
[cooling]
ambient_temperature = "25 degC"
other_loss = "{}"
"""

HALF_LOAD = COOLING.format("300 W") + SIZES


def pair(cooling=HALF_LOAD, *changes):
    """The speed increaser of Errichello at half load."""
    text = (CASES / "errichello_speed_increaser.toml").read_text()
    text = changed(text, ('power = "346 hp"', 'power = "173 hp"'), *changes)
    return case_of(tomllib.loads(text + cooling), "half", CASES)


def worm(*changes):
    text = (CASES / "zi_cooled.toml").read_text()
    return case_of(tomllib.loads(changed(text, *changes)), "worm", CASES)


BY_SIZES = (
    ('conductance = "40 W/K"\nother_loss = "500 W"\nworm_excess = "15 K"', ""),
    (
        "[bodies.worm]",
        '[cooling.housing]\nlength = "600 mm"\nwidth = "350 mm"\nheight = "800 mm"\n[bodies.worm]',
    ),
)


def unit_of(case):
    return case.tables.unit_of(case.drive)


@pytest.fixture(scope="module")
def half_load():
    return pair()


def test_a_given_conductance_is_the_network_by_hand():
    cooled = worm(('worm_excess = "15 K"\n', ""))
    unit = unit_of(cooled)
    found = unit.temperatures
    assert found.sump == pytest.approx(cooled.drive.oil.heat.inlet_temperature, rel=1e-12)
    bodies = [body.bulk_temperature for body in cooled.drive.bodies]
    assert found.bodies == pytest.approx(bodies, rel=1e-12)
    assert unit.conductance == 40
    assert unit.uncertainty["oil"] == pytest.approx(0, abs=1e-9)


def test_a_housing_s_heat_is_that_of_its_surfaces(half_load):
    """Sum of sides, top, bottom, radiation and foot, each by its formula."""
    state = unit_of(half_load).steady
    wall, room = state.temperatures["housing"], 298.15
    fluid, excess = ht.air((wall + room) / 2), wall - room
    sides, top = 2 * 1.5 * 0.7, 0.5
    flows = {path.name: flow for path, flow in state.flows if path.first == "housing"}
    convected = sides * ht.free_on_wall(fluid, 0.7, excess)
    convected += top * ht.free_on_top(fluid, 0.5 / 3, excess)
    convected += 0.7 * top * ht.free_below(fluid, 0.5 / 3, excess)
    assert flows["convection"] == pytest.approx(convected * excess)
    radiated = (sides + top) * 0.9 * 5.670374e-8 * (wall**4 - room**4)
    assert flows["radiation"] == pytest.approx(radiated)
    assert flows["foot"] == pytest.approx(2 * 1.4 * (4 * 0.3 * top / np.pi) ** 0.5 * excess)
    assert abs(state.imbalance) < 1e-6
    assert state.given_off == pytest.approx(state.power)


def test_the_case_history_at_half_load_is_as_warm_as_was_measured(half_load):
    """Errichello (1991): 200 degF of the sump at half load in 50 to 125 degF, teeth 30 degF hotter assumed.

    Sizes of the housing, other losses and friction (0.1 by his surface finish rule) are assumed.
    """
    case = half_load.with_found({"cooling": {"tooth_loss": 129.0e3 * 0.1782 * 0.1}})
    unit = unit_of(case)
    oil, pinion = (unit.steady.temperatures[node] for node in ("oil", "pinion"))
    measured = (200 - 32) / 1.8 + ZERO_CELSIUS
    assert abs(oil - measured) < unit.uncertainty["oil"]
    assert abs(pinion - oil - 30 / 1.8) < unit.uncertainty["pinion"]
    # the oil of the contacts is that of the sump, by its own law
    assert case.drive.oil.heat.inlet_temperature == pytest.approx(oil)
    pinion_body, _ = case.drive.bodies
    assert pinion_body.bulk_temperature == pytest.approx(pinion)
    assert unit.conductance == pytest.approx(unit.loss / (oil - 298.15))


@pytest.mark.parametrize(("power", "column"), [("173 hp", 0), ("346 hp", 1)])
def test_the_page_has_the_temperatures_of_its_tables(power, column):
    page = (ROOT / "docs/how-to/temperatures.md").read_text()
    tables = "\n".join(re.findall("^    (.*)", page.split("|key")[0], re.M))
    if column:
        tables = tables.replace("2.3 kW", "4.6 kW")
    unit = unit_of(pair(f"\n{tables}\n", ('power = "173 hp"', f'power = "{power}"')))
    for node, *cells in re.findall(r"^\|(oil|pinion|housing) \|(.*?) \|(.*?) \|$", page, re.M):
        value, spread = map(float, cells[column].split(" ± "))
        assert unit.steady.temperatures[node] - ZERO_CELSIUS == pytest.approx(value, abs=0.051)
        assert unit.uncertainty[node] == pytest.approx(spread, abs=0.51 if spread > 10 else 0.051)


MEASURED = """
[cooling.measured]
loss = "2.6 kW"
sump_temperature = "200 degF"
ambient_temperature = "80 degF"
"""


def test_a_measured_point_fixes_the_housing():
    case = pair(
        changed(HALF_LOAD, ('"300 W"', '"300 W"\ntooth_loss = "2.3 kW"')).replace(
            "25 degC", "80 degF"
        )
        + MEASURED
    )
    unit = unit_of(case)
    assert unit.steady.temperatures["oil"] == pytest.approx((200 - 32) / 1.8 + ZERO_CELSIUS)
    assert 0.5 < unit.fit < 2 and unit.uncertainty["oil"] < 1e-3 < unit.uncertainty["pinion"]
    words = " ".join(rate_temperatures(unit).words)
    assert f"{unit.fit:.3g} times" in words and "93.3 °C at 2600 W" in words
    with pytest.raises(ValueError, match="no factor from"):
        _ = pair(HALF_LOAD + MEASURED.replace("200 degF", "81 degF")).drive


def test_time_ends_in_the_steady_state_and_its_heat_is_kept(half_load):
    unit = unit_of(half_load)
    network, hour = unit.network(), 3600.0
    steps = [ThermalStep(60 * hour), ThermalStep(60 * hour, running=False)]
    history = network.history(steps, 298.15, points=50)
    middle = np.searchsorted(history.time, 60 * hour)
    for node, temperature in unit.steady.temperatures.items():
        assert history.temperatures[node][middle] == pytest.approx(temperature, abs=0.01)
        assert history.temperatures[node][-1] == pytest.approx(298.15, abs=2)
    assert history.stored == pytest.approx(history.supplied, rel=1e-4)


def test_a_worm_s_network_has_the_standard_s_wheel():
    """Half of c_k (1940 + 15 n1) b2 d_m2 from worm and wheel each; the standard's losses in their places."""
    case = worm(*BY_SIZES).with_found({"cooling": {"tooth_loss": 1100.0}})
    unit = unit_of(case)
    rim = 59 * 28.73e-3 / np.pi * 60.33e-3
    assert unit.to_oil == pytest.approx((1940 + 15 * 1500) * rim / 2)
    losses = unit.cooling.other.standard
    assert unit.steady.sources == pytest.approx(
        {
            "worm": 550,
            "wheel": 550,
            "worm bearings": losses.bearings / 2,
            "wheel bearings": losses.bearings / 2,
            "worm shaft": losses.seals,
            "oil": losses.churning,
        }
    )
    assert drive_iteration.tooth_loss_of(case) == pytest.approx(1100)
    duty = case.tables.rated_duty(case.drive)
    assert duty.conductance == pytest.approx(unit.conductance)
    worm_shaft, oil = (unit.steady.temperatures[node] for node in ("worm shaft", "oil"))
    assert worm_shaft > oil > unit.steady.temperatures["housing"]


def test_a_housing_is_first_warmed_by_the_loss_of_the_standard_where_it_has_one():
    """The oil of Sharif et al. has no name of the standard: 3 % of the power, as with a given conductance."""
    unnamed = unit_of(worm(*BY_SIZES)).tooth_loss
    assert unnamed == pytest.approx(0.03 * 4000 * 50 * np.pi * 3 / 59)
    text = (DATA / "worm_rated.toml").read_text() + COOLING.format("60 W") + SIZES
    named = case_of(tomllib.loads(text), "named", DATA)
    assert unit_of(named).tooth_loss == pytest.approx(standard_loss(named).power)


@pytest.mark.parametrize("fall", (-0.2, -1.0))
def test_the_loss_of_a_gear_pair_agrees_with_its_temperatures(
    half_load, monkeypatch, tmp_path, fall
):
    """Found = 2500 W + fall (assumed - 2300 W)."""
    ran, said = [], []

    def run(case, tasks, directory, **rest):
        assumed = drive_iteration.tooth_loss_of(tasks[0].case)
        ran.append((assumed, 2500 + fall * (assumed - 2300)))

    monkeypatch.setattr(drive_iteration, "run", run)
    monkeypatch.setattr(drive_iteration, "drive_cycle", lambda result: None)
    monkeypatch.setattr(
        drive_iteration,
        "mesh_loss",
        lambda drive, result: MeshLoss(129e3, ran[-1][1], 0.1, 0.0, ""),
    )
    monkeypatch.setattr(
        drive_iteration,
        "mesh_heating_loss",
        lambda loss, result, standard: drive_iteration.HeatingLoss(loss.loss, "simulation", "so"),
    )
    tasks = [Task(half_load, place, 0.03) for place in half_load.places()]
    _, solved = drive_iteration.run_balanced(half_load, tasks, tmp_path, print_message=said.append)
    assumed, found = ran[-1]
    assert abs(found - assumed) <= 0.5 * unit_of(solved[0].case).conductance
    assert solved[0].case.tables.cooling.tooth_loss == pytest.approx(assumed)
    assert len(said) >= 1 and len(ran) <= 6


@pytest.mark.parametrize(
    ("cooling", "said"),
    [
        (COOLING.format("1 W"), "cooling: give either conductance or housing"),
        (
            COOLING.format("1 W") + 'conductance = "40 W/K"\n' + MEASURED,
            "measured has no effect with conductance",
        ),
        (HALF_LOAD + "foot = 1.5", "cooling.housing.foot"),
    ],
)
def test_cooling_that_says_too_little_or_too_much_is_refused(cooling, said):
    with pytest.raises(CaseError, match=said):
        pair(cooling)


def test_temperatures_that_are_given_beside_cooling_are_refused():
    with pytest.raises(CaseError, match=r"bodies.gear.bulk_temperature has no effect"):
        pair(HALF_LOAD, ("[bodies.gear]", '[bodies.gear]\nbulk_temperature = "90 degC"'))
    with pytest.raises(CaseError, match="worm_excess has no effect with housing"):
        worm(*BY_SIZES, ("[cooling]", '[cooling]\nworm_excess = "15 K"'))


def test_roller_worms_have_the_same_table():
    text = (CASES / "roller_crowned.toml").read_text()
    case = case_of(tomllib.loads(text + HALF_LOAD), "roller", CASES)
    unit = unit_of(case)
    assert unit.steady.temperatures.keys() >= {"worm", "wheel", "oil", "housing"}
    worm_, wheel = unit.rotors
    assert worm_.torque * worm_.speed == pytest.approx(wheel.torque * wheel.speed)


def test_a_rating_shows_temperatures_and_heat_flows(half_load):
    rating = next(of for of in rate(half_load) if of.key == "temperatures")
    figures = rating.summary()["computed"]
    assert figures["oil_temperature_C"] > figures["housing_temperature_C"] > 25
    outward = [value for key, value in figures.items() if key.startswith("heat_")]
    assert figures["pinion_loss_W"] + figures["gear_loss_W"] + figures["oil_loss_W"] < sum(outward)
    assert abs(figures["imbalance"]) < 1e-6


def test_rate_shows_temperatures_over_time_with_a_picture(tmp_path, capsys):
    text = (CASES / "errichello_speed_increaser.toml").read_text()
    case = tmp_path / "half.toml"
    case.write_text(
        text.replace("346 hp", "173 hp")
        + HALF_LOAD.replace('"300 W"', '"300 W"\nambient_swing = "5 K"')
    )
    assert (
        main(["rate", str(case), "--hours", "8", "16", "--out", str(tmp_path / "a"), "--json"]) == 0
    )
    found = json.loads(capsys.readouterr().out)["history"]
    hours, oil = np.array(found["time_h"]), np.array(found["oil_temperature_C"])
    assert hours[-1] == pytest.approx(24) and abs(hours[oil.argmax()] - 8) < 0.1
    assert oil[0] == pytest.approx(25) and 25 < oil[-1] < oil.max()
    assert found["ambient_temperature_C"][len(hours) // 4] > 25
    assert found["heat_stored_J"] == pytest.approx(found["heat_supplied_J"], rel=1e-3)
    assert (tmp_path / "a/half_temperatures.png").stat().st_size > 1e4
    case.write_text(text)
    assert main(["rate", str(case), "--hours", "8"]) == 2
    assert "half.toml: temperatures need [cooling]" in capsys.readouterr().err
    case.write_text(text + COOLING.format("1 W") + 'conductance = "40 W/K"')
    assert main(["rate", str(case), "--hours", "8"]) == 2
    assert "need [cooling.housing], for its heat capacity" in capsys.readouterr().err


@pytest.mark.parametrize("hours", ["a", "-3", "nan"])
def test_hours_that_are_none_are_refused_in_one_sentence(hours, capsys):
    with pytest.raises(SystemExit) as refused:
        main(["rate", str(CASES / "worm_drawing.toml"), "--hours", hours])
    assert refused.value.code == 2
    assert f"{hours}: must be a number of hours" in capsys.readouterr().err


OPEN = COOLING.replace('other_loss = "{}"\n', "") + SIZES


def test_losses_besides_the_teeth_follow_the_oil_where_they_are_not_given():
    unit = unit_of(pair(OPEN))
    other, state = unit.cooling.other.standard, unit.steady
    assert unit.loss == pytest.approx(state.power, rel=1e-9)
    assert abs(state.imbalance) < 1e-6
    assert state.sources["pinion bearings"] == pytest.approx(other.bearings / 2)
    assert state.sources["pinion shaft"] == pytest.approx(other.seals)
    assert state.sources["oil"] == pytest.approx(other.churning)
    assert unit.dips == (0.0, 0.15 * unit.rotors[1].diameter)
    cold, hot = unit.other_at(290.0), unit.other_at(370.0)
    assert cold.bearings > other.bearings > hot.bearings and cold.churning > hot.churning
    # f_1 P d_m of the load, P = 2 T/(d cos 20 deg) on both bearings of a shaft, whatever the oil
    loads = [rotor.speed * 4e-4 * 2 * rotor.torque / rotor.diameter / np.cos(np.radians(20))
             * 1.4 * rotor.shaft_diameter for rotor in unit.rotors]  # fmt: skip
    assert hot.bearings > sum(loads)
    assert "within a factor of 2" in unit.cooling.other.words
    assert unit.cooling.other.summary()["other_by"] == "closed forms"


def test_a_bath_s_depth_and_jets_decide_how_deep_gears_dip():
    bath = '\n[lubrication]\nmethod = "bath"\nbody = "gear"\ndepth = "80 mm"\n'
    jets = '\n[lubrication]\nmethod = "jets"\nflow = "20 l/min"\n'
    assert unit_of(pair(OPEN + bath)).dips == (0.0, pytest.approx(0.08))
    splashed = unit_of(pair(OPEN + jets))
    assert splashed.dips == (0.0, 0.0)
    assert splashed.cooling.other.standard.churning == 0
