"""Starts of worm gear sets: torques by hand, balance of heat, motors too weak, and teeth that lock."""

from math import atan, tan

import pytest
from folders import CASES
from refusals import changed

from pyworm.io.input_error import CaseError
from pyworm.ratings.no_load import worm_no_load
from pyworm.ratings.rated_case import load_rating_request, ratings, thermal_unit
from pyworm.ratings.starting import WormStart, warming
from pyworm.ratings.worm_loads import RatedWormGear

ZI = (CASES / "oil_zi.toml").read_text()


def started(directory, *changes):
    """The ratings "worm" and "starting" of the case with changes: columns of figures, and the latter."""
    path = directory / "case.toml"
    path.write_text(changed(ZI, *changes))
    found = {rating.key: rating for rating in ratings(load_rating_request(path))}
    columns = [
        {figure.key: figure.values[0] for figure in found[key].figures}
        for key in ("worm", "starting")
    ]
    return *columns, found["starting"]


@pytest.fixture(scope="module")
def start(tmp_path_factory):
    return started(tmp_path_factory.mktemp("start"))


def test_torques_by_hand(start):
    """Breakaway: lead angle and friction angle at rest, loaded bearings, seals; warm: all losses."""
    worm, found, _ = start
    speed, ratio, tan_lead = 1500 * 0.10471976, 59 / 3, 3 / 8.5
    load = 6690 / ratio
    dry = (worm["loss_bearings_W"] + worm["loss_seals_W"]) / speed
    rest = tan(atan(tan_lead) + atan(worm["friction_rest"])) / tan_lead
    assert found["breakaway_torque_N_m"] == pytest.approx(load * rest + dry, rel=1e-4)
    warm = load / worm["efficiency_gearbox"]
    assert found["warm_torque_N_m"] == pytest.approx(warm, rel=1e-4)
    oil = found["cold_bearings_torque_N_m"] + found["cold_churning_torque_N_m"]
    assert found["cold_torque_N_m"] - warm == pytest.approx(
        oil - worm["loss_churning_W"] / speed, rel=1e-3
    )
    assert found["start_margin"] == pytest.approx(700 / found["breakaway_torque_N_m"])


def test_oil_warms_towards_its_balance(start):
    _, found, _ = start
    assert -10 < found["oil_after_hour_C"] < found["cold_sump_C"] < 60
    assert 0 < found["warming_time_h"] < 1


def test_teeth_that_do_not_lock_have_to_be_held(start):
    _, found, rating = start
    held = 6690 * 3 / 59 * 0.7293
    assert found["holding_torque_N_m"] == pytest.approx(held, rel=2e-3)
    assert "releasing_torque_N_m" not in found
    assert any("do not lock at rest" in words for words in rating.words)


@pytest.mark.parametrize(
    ("factor", "rpm", "end"), [(14, 1500, "the load runs away"), (25, 20, "by steps")]
)
def test_locked_teeth_are_released_by_vibration(tmp_path, factor, rpm, end):
    """The torque that releases them over the inertia of the worm alone, (pi/32) rho l d^4."""
    distance = (factor + 41) * 2
    _, found, rating = started(
        tmp_path,
        ("304.8 mm", f"{distance} mm"),
        ("9.145 mm", "4 mm"),
        ("60.33 mm", "30 mm"),
        ("6.69 kN m", "0.3 kN m"),
        ("teeth = 59", "teeth = 41"),
        ("starts = 3", "starts = 1"),
        ("diameter_factor = 8.5", f"diameter_factor = {factor}"),
        ("profile_shift = -0.42", "profile_shift = 0.0"),
        ('worm_speed = "1500 rpm"', f'worm_speed = "{rpm} rpm"'),
        ('mass = "450 kg"', 'mass = "50 kg"'),
    )
    assert found["locking_rest"] > 1
    inertia = 3.14159265 / 32 * 7850 * 43 * 4e-3 * (factor * 4e-3) ** 4
    assert found["releasing_acceleration_rad_s2"] == pytest.approx(
        found["releasing_torque_N_m"] / inertia, rel=1e-3
    )
    assert any(end in words for words in rating.words)


def test_a_weak_motor_fails(tmp_path):
    motor = 'temperature = "-10 degC"\nmotor_torque = "700 N m"'
    _, _, rating = started(tmp_path, (motor, 'temperature = "-35 degC"\nmotor_torque = "430 N m"'))
    assert rating.failed[0].startswith("The motor does not start it: 430 N m are less than")
    assert any("hardly flows to the mesh" in words for words in rating.words)


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('loss = "3.88 kW"\n', "", "energy_price needs loss and yearly_operation"),
        ('coldest_start = "-10 degC"\n', "", "motor_torque needs coldest_start"),
        ('mass = "450 kg"', 'mass = "450 l"', "must be a mass"),
    ],
)
def test_starts_and_choices_are_refused_in_part(tmp_path, old, new, sentence):
    (tmp_path / "case.toml").write_text(changed(ZI, (old, new)))
    with pytest.raises(CaseError, match=sentence):
        load_rating_request(tmp_path / "case.toml")


def test_a_start_needs_a_rating(tmp_path):
    text = ZI[: ZI.index("[worm_rating]")] + ZI[ZI.index("[starting]") : ZI.index("[assumed]")]
    (tmp_path / "case.toml").write_text(text)
    with pytest.raises(CaseError, match=r"\[starting\] needs \[worm_rating\]"):
        load_rating_request(tmp_path / "case.toml")


def test_what_does_not_warm_has_no_time(tmp_path):
    """A huge unit in 200 h; a unit whose mass is not given; one that is no warmer than its surroundings."""
    _, found, _ = started(tmp_path, ('mass = "450 kg"', 'mass = "900000 kg"'))
    assert "cold_sump_C" in found and "warming_time_h" not in found
    reason = 'starting.mass = "a cast-iron unit of this size"\n'
    _, found, _ = started(tmp_path, ('mass = "450 kg"\n', ""), (reason, ""))
    assert "cold_sump_C" not in found
    path = tmp_path / "case.toml"
    ambient = 'fan = false\nambient_temperature = "61 degC"\n'
    path.write_text(changed(ZI, ('life = "25000 h"\n', f'life = "25000 h"\n{ambient}')))
    assert "starting" not in [rating.key for rating in ratings(load_rating_request(path))]


def test_a_housing_warms_by_its_network(tmp_path):
    """A small unit at -20 degC: bearings and oil warm by themselves, the balance of heat closes."""
    text = (CASES / "conveyor.toml").read_text()
    cold = '[starting]\ntemperature = "-20 degC"\n\n[worm_rating]'
    (tmp_path / "case.toml").write_text(changed(text, ("[worm_rating]", cold)))
    request = load_rating_request(tmp_path / "case.toml")
    table = request.worm_rating
    resistance = worm_no_load(request.worm_duty, table.bearings, request.mean_diameters)
    gear_set = RatedWormGear(table, request.worm_duty, tmp_path)
    unit = thermal_unit(request)
    start = WormStart(gear_set, request.tables.starting, resistance, unit)
    state = start.network.steady()
    assert abs(state.imbalance) < 1e-6
    assert state.temperatures["oil"] - 253.15 > unit.temperatures.sump - 293.15
    bearings = [state.sources[f"{name} bearings"] for name in ("worm", "wheel")]
    assert sum(bearings) > unit.cooling.other.standard.bearings
    found = warming(start.network, 253.15)
    assert 253.15 < found.after_hour < found.balanced
    assert start.running(253.15) > 2 * start.running(start.sump)
