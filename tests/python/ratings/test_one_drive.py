"""A drive and its rating: one material, one oil, one sump; every figure by itself; locking of the gearbox."""

import tomllib
from math import atan, pi, tan
from pathlib import Path

import pytest
from folders import DATA
from refusals import changed
from zi_drives import coarse_springs

from pyworm.case.case import case_of
from pyworm.io.input_error import CaseError
from pyworm.ratings.rated_case import not_rated, rating_request, ratings
from pyworm.ratings.standard_loss import standard_loss

DRIVE = (DATA / "worm_rated.toml").read_text()


@pytest.fixture(autouse=True, scope="module")
def coarse():
    """Fewer phases and loads for load sharing."""
    with pytest.MonkeyPatch.context() as patch:
        coarse_springs(patch)
        yield


SYMBOLS = ("S_W", "S_H", "S_delta", "S_F", "S_T")


def case(*changes):
    return case_of(tomllib.loads(changed(DRIVE, *changes)), "rated", Path())


def worm(*changes):
    """The worm's rating, and what is not rated."""
    asked = rating_request(case(*changes))
    built = ratings(asked)
    return built[0], not_rated(asked, built)


def values(rating):
    return {of.symbol: of.value for of in rating.safeties}


def refused(*changes):
    with pytest.raises(CaseError) as error:
        case(*changes)
    return str(error.value)


STATED = ('life = "25000 h"', 'life = "25000 h"\n{}')


def stating(line):
    return (STATED[0], STATED[1].format(line))


# ------------------------------------------------------------------------------------- one material


def test_the_rating_is_of_the_wheel_s_own_material():
    iron = [('"CuSn12Ni2-C-GZ"', '"GJL"')]
    bronze, cast = (
        next(of for of in worm(*these)[0].safeties if of.symbol == "S_H") for these in ((), iron)
    )
    assert bronze.inputs["sigma_HlimT_MPa"] == pytest.approx(520)
    assert cast.inputs["sigma_HlimT_MPa"] == pytest.approx(350)
    same = worm(stating('wheel_material = "CC484K"'))[0]
    assert values(same) == values(worm()[0]) and same.differs == ()


def test_two_materials_of_one_wheel_are_refused():
    said = refused(('"CuSn12Ni2-C-GZ"', '"EN-GJS-400-15"'), stating('wheel_material = "CuSn12Ni2"'))
    assert 'worm_rating.wheel_material = "CuSn12Ni2-C-GZ"' in said
    assert 'bodies.wheel.material = "EN-GJS-400-15"' in said and "one wheel" in said
    plain = 'youngs_modulus = "210 GPa"\npoisson_ratio = 0.3\ndensity = "7850 kg/m^3"\n'
    plain += 'conductivity = "42 W/(m K)"\nspecific_heat = "460 J/(kg K)"'
    said = refused(('material = "CuSn12Ni2-C-GZ"', plain), stating('wheel_material = "CuSn12Ni2"'))
    assert "98.1 GPa" in said and "210 GPa" in said


def test_another_casting_of_the_alloy_is_in_the_headline():
    rating, _ = worm(stating('wheel_material = "CuSn12Ni2-GC"'))
    assert "CuSn12Ni2-C-GC" in rating.titled and "bodies.wheel.material" in rating.titled
    assert rating.summary()["differs"]
    # W_ML of 4.1 for 1.75
    assert values(worm()[0])["S_W"] / values(rating)["S_W"] == pytest.approx(4.1 / 1.75)


@pytest.mark.parametrize("material", ["CuZn25Al5Mn4Fe3", "42CrMo4", "CuSn12-GC"])
def test_a_material_without_strengths_is_said_line_by_line(material):
    rating, left = worm(('"CuSn12Ni2-C-GZ"', f'"{material}"'))
    built = values(rating)
    assert built["S_T"] and built["S_W"] is built["S_H"] is built["S_F"] is None
    assert any(of.startswith("S_H") and "worm-gear standard" in of for of in left)
    # friction is known of the alloy; with brass and steel the shaft bends as with tin bronze, which is said
    of_shaft = next(of for of in rating.safeties if of.symbol == "S_delta")
    assert built["S_delta"] > 0
    assert any("tin bronze" in of for of in of_shaft.doubts) == (material != "CuSn12-GC")
    assert ("friction" in rating.summary()["standard"]) == (material == "CuSn12-GC")


# ------------------------------------------------------------------- one oil, one sump, one balance


def test_oil_and_temperature_are_those_of_the_drive():
    rating, _ = worm()
    by_symbol = {of.symbol: of for of in rating.safeties}
    assert by_symbol["S_T"].inputs["theta_S_C"] == pytest.approx(70)
    assert by_symbol["S_H"].inputs["oil"] == "PAG"
    assert values(worm(stating('oil = "PAG VG 220"\nsump_temperature = "70 degC"'))[0]) == values(
        rating
    )


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ('oil = "PAG VG 460"', "one sump holds one oil"),
        ('sump_temperature = "80 degC"', "but the oil enters at 70 degC"),
    ],
)
def test_a_second_oil_or_temperature_is_refused(line, sentence):
    assert sentence in refused(stating(line))


COOLED = (
    "[bodies.worm]",
    '[cooling]\nambient_temperature = "30 degC"\nconductance = "12 W/K"\n[bodies.worm]',
)


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ('sump_temperature = "70 degC"', "has no effect with [cooling]"),
        ('ambient_temperature = "20 degC"', "differs from cooling.ambient_temperature"),
        ('bearings = "fixed and floating"', "differs from cooling.bearings"),
        ("immersion_factor = 0.8", "differs from cooling.immersion"),
    ],
)
def test_a_second_cooling_is_refused(line, sentence):
    assert sentence in refused(COOLED, stating(line))


def test_a_cooled_drive_is_rated_at_the_temperatures_of_its_balance():
    cooled = case(COOLED)
    sump = cooled.drive.oil.heat.inlet_temperature
    rating = ratings(rating_request(cooled))[0]
    by_symbol = {of.symbol: of for of in rating.safeties}
    assert by_symbol["S_T"].inputs["theta_S_C"] == pytest.approx(sump - 273.15)
    assert by_symbol["S_T"].inputs["taken"] == "by [cooling]"
    figures = rating.summary()["standard"]
    assert figures["bulk_temperature_C"] == pytest.approx(
        cooled.drive.bodies[1].bulk_temperature - 273.15
    )
    # the balance of another load of a spectrum: all its losses over the same conductance
    step = '[[worm_rating.spectrum]]\nwheel_torque = "{} N m"\nworm_speed = "{} rpm"\nduration = "9 h"\n'
    loads = step.format(300, 1500) + step.format(600, 750)
    rating, _ = worm(
        COOLED, ('life = "25000 h"', ""), ("[worm_rating]\n", f"[worm_rating]\n{loads}")
    )
    lost = rating.summary()["standard"]["loss_gearbox_W"]
    hottest = next(of for of in rating.safeties if of.symbol == "S_T").inputs["theta_S_C"]
    assert hottest == pytest.approx(max(30 + lost / 12, sump - 273.15))


def test_bulk_temperatures_are_those_of_the_balance_by_hand():
    """P_Vz over alpha_L b2 d_m2, alpha_L = 1940 + 15 n, with the friction of the bath's curve of PAG."""
    drive = case().drive
    lead = atan(2 / 9)
    v = pi * 36e-3 * 25 / (1 + (2 / 9) ** 2) ** -0.5
    mu = (0.024 + 0.0032 / (v + 0.1) ** 1.71) * (0.07 / 0.06934) ** 0.5 * 0.95
    mu *= (0.8 * drive.bodies[0].roughness / 0.5e-6) ** 0.25
    loss = 300 * 1500 * pi / 30 / 20.5 * (tan(lead + atan(mu)) / tan(lead) - 1)
    rise = loss / ((1940 + 15 * 1500) * 30e-3 * 164e-3)
    for body in drive.bodies:
        assert body.bulk_temperature - 343.15 == pytest.approx(rise, rel=2e-3)
    assert drive.oil.heat.inlet_temperature == pytest.approx(343.15)
    assert any("warmer than the oil, by the heat balance" in of for of in drive.assumptions)
    rating = ratings(rating_request(case()))[0]
    assert rating.summary()["standard"]["bulk_temperature_C"] == pytest.approx(70 + rise, rel=1e-4)
    assert rating.differs == ()


def test_temperatures_that_are_given_stay():
    given = case(('finish = "run-in"', 'finish = "run-in"\nbulk_temperature = "85 degC"'))
    worm_, wheel = given.drive.bodies
    assert (worm_.bulk_temperature, wheel.bulk_temperature) == pytest.approx((343.15, 358.15))
    rated = ratings(rating_request(given))[0].summary()["standard"]
    assert rated["bulk_temperature_C"] == pytest.approx(85)


def test_without_a_loss_by_the_standard_bodies_are_as_warm_as_the_oil_and_it_is_said():
    ester = case(('"PAG VG 220"', '"ester VG 320"'))
    assert [of.bulk_temperature for of in ester.drive.bodies] == pytest.approx([343.15] * 2)
    assert any("have the oil temperature: worm_rating.oil" in of for of in ester.drive.assumptions)


def test_a_wheel_of_unknown_friction_is_warmed_by_that_of_tin_bronze_and_it_is_said():
    bronze, brass = case(), case(('"CuSn12Ni2-C-GZ"', '"CuZn25Al5Mn4Fe3"'))
    warmer = [of.drive.bodies[1].bulk_temperature - 343.15 for of in (bronze, brass)]
    # the factor of friction of CuSn12Ni2 is 0.95, that of tin bronze 1
    assert warmer[0] / warmer[1] == pytest.approx(0.95, rel=5e-3)
    says = [
        "friction of tin bronze, an estimate" in " ".join(of.drive.assumptions)
        for of in (bronze, brass)
    ]
    assert says == [False, True]


def test_an_oil_far_colder_than_the_standard_has_it_is_in_the_headline():
    cold, _ = worm(('temperature = "70 degC"', 'temperature = "35 degC"'))
    assert "The oil is given as 35 °C; by the standard's balance" in cold.titled


# ------------------------------------------------------------------------------------- line by line


@pytest.mark.parametrize("rpm", [5, 50, 3000, 5000])
def test_at_any_speed_all_five_safeties_are_rated(rpm):
    rating, left = worm(('"1500 rpm"', f'"{rpm} rpm"'))
    built = values(rating)
    assert tuple(built) == SYMBOLS and all(of > 0 for of in built.values())
    creeping = [of for of in left if "sliding speed" in of]
    assert bool(creeping) == (rpm == 5)
    assert all("must lie between 0.05 and 25 m/s" in of for of in creeping)


def test_a_unit_smaller_than_the_standard_s_balance_is_rated():
    small = [
        ('centre_distance = "100 mm"', 'centre_distance = "40 mm"'),
        ("threads = 2", "threads = 4"),
        ("teeth = 41", "teeth = 30"),
        ('module = "4 mm"', 'module = "2 mm"'),
        ("diameter_factor = 9", "diameter_factor = 10"),
        ('face_width = "30 mm"\n', ""),
        ('"300 N m"', '"39 N m"'),
    ]
    rating, _ = worm(*small)
    assert all(of > 0 for of in values(rating).values())
    warm = next(of for of in rating.safeties if of.symbol == "S_T")
    assert any("must lie between 0.05 and 0.5 m" in of for of in warm.doubts)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ([], None),
        ([('"1500 rpm"', '"5 rpm"')], "for wear a sliding speed of 0.0097 m/s, below 0.1 m/s"),
        ([('"1500 rpm"', '"20000 rpm"')], "a sliding speed of 38.6 m/s, above 25 m/s"),
    ],
)
def test_what_lies_outside_the_standard_s_scope_is_said(changes, said):
    basis = worm(*changes)[0].basis
    assert basis[0].startswith("Worm gear: ISO/TS 14521:2020")
    outside = [of for of in basis if "Outside the scope" in of and "contact ratio" not in of]
    assert (said is None) == (outside == [])
    assert said is None or said in outside[0]


def test_a_verdict_tells_a_value_from_the_minimum_that_it_misses():
    """110 degC over 100.04 degC is 1.09956, which four digits would show as 1.1."""
    rating, _ = worm(('temperature = "70 degC"', 'temperature = "100.04 degC"'))
    assert "S_T = 1.0996 against temperature of the oil is below 1.1." in rating.failed


# ------------------------------------------------------------------------------------------ locking

SLOW_IRON = [
    ("threads = 2", "threads = 1"),
    ("diameter_factor = 9", "diameter_factor = 12"),
    ('centre_distance = "100 mm"', 'centre_distance = "106 mm"'),
    ('"1500 rpm"', '"200 rpm"'),
    ('"CuSn12Ni2-C-GZ"', '"EN-GJS-400-15"'),
    ('name = "PAG VG 220"', 'name = "mineral VG 460"'),
]


def said_of_locking(rating):
    return next(of for of in rating.words if "elf-locking" in of)


def test_a_gearbox_locks_by_all_its_losses():
    """Teeth of cast iron let a tenth of the wheel's power through; bearings and seals take more."""
    rating, _ = worm(*SLOW_IRON, ('"300 N m"', '"40 N m"'))
    figures = rating.summary()["standard"]
    assert 0 < figures["efficiency_back"] < 0.25
    assert figures["efficiency_gearbox_back"] == "cannot drive"
    said = said_of_locking(rating)
    assert said.startswith("Self-locking, running and at rest")
    assert "no brake" in said


def test_a_gearbox_that_runs_and_cannot_start():
    rating, _ = worm(*SLOW_IRON, ('"300 N m"', '"900 N m"'), ('"200 rpm"', '"700 rpm"'))
    figures = rating.summary()["standard"]
    assert 0 < figures["efficiency_gearbox_back"] < figures["efficiency_back"]
    assert said_of_locking(rating).startswith("Self-locking at rest only")
    assert said_of_locking(worm()[0]).startswith("Not self-locking")
    assert "no brake" in said_of_locking(worm()[0])


def test_churning_alone_can_stop_a_gearbox_that_starts():
    """At 3000 rpm and next to no load, oil takes what the wheel gives; at rest oil does not resist."""
    idle, _ = worm(('"1500 rpm"', '"3000 rpm"'), ('"300 N m"', '"20 N m"'))
    assert said_of_locking(idle).startswith("Self-locking at this speed only")


def test_a_wheel_that_is_to_drive_and_cannot_fails():
    driven = ('driver = "wheel"\nphases = [0.5]',)
    rating, _ = worm(*SLOW_IRON, ('"300 N m"', '"40 N m"'), ("phases = [0.5]", *driven))
    assert any("operation.driver) and cannot" in of for of in rating.failed)


def test_a_wheel_that_drives_loses_what_does_not_come_to_the_worm():
    back = case(("phases = [0.5]", 'driver = "wheel"\nphases = [0.5]'))
    figures = ratings(rating_request(back))[0].summary()["standard"]
    given = 300 * 1500 * pi / 30 / 20.5
    lead, rho = atan(2 / 9), atan(figures["friction"])
    assert figures["loss_W"] == pytest.approx(given * (1 - tan(lead - rho) / tan(lead)))
    assert figures["loss_W"] < worm()[0].summary()["standard"]["loss_W"]
    assert standard_loss(back).power == pytest.approx(figures["loss_W"])
    left = given - figures["loss_gearbox_W"]
    assert figures["efficiency_gearbox_back"] == pytest.approx(left / given)
