"""The worm standards' methods: worked values of the reference gear, dimensions, limits and refusals."""

from dataclasses import replace
from math import atan, log, pi, tan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pyworm.formulas.worm_curves import OIL_KINDS
from pyworm.formulas.worm_gear import REFERENCE_GEAR, WormGear
from pyworm.formulas.worm_rating import WormConditions, WormRating
from pyworm.formulas.worm_standard import (
    PRESSURE_VISCOSITY,
    backward_efficiency,
    bulk_temperature,
    forward_efficiency,
    mean_pressure,
    minimum_film,
    pitting_safety,
    self_locking_margin,
    static_friction,
    temperature_safety,
    tooth_friction,
)
from pyworm.formulas.worm_wear import wear_depth, wear_intensity
from pyworm.formulas.worm_wheel_material import WHEEL_MATERIALS
from pyworm.materials.body import Body, reduced_modulus

RPM = pi / 30
BRONZE = 150622e6
FILM = {
    "film_parameter": 0.07,
    "pressure_viscosity": 1.3e-8,
    "viscosity": 0.0542,
    "worm_speed": 1500 * RPM,
    "centre_distance": 0.1,
    "reduced_modulus": BRONZE,
    "torque": 300.0,
}
DUTY = {
    "oil": "PAG",
    "viscosity": 0.0542,
    "worm_speed": 1500 * RPM,
    "torque": 300.0,
    "reduced_modulus": BRONZE,
    "roughness": 0.5e-6,
}

WHEELS = {
    "CuSn12": (88300, 0.35, 140144),
    "CuSn12Ni2": (98100, 0.35, 150622),
    "CuAl10Fe5Ni5": (122600, 0.35, 174053),
    "EN-GJS-400": (175000, 0.3, 209790),
    "EN-GJL-250": (98100, 0.3, 146955),
}
"""Wheel material of DIN 3996 -> modulus [N/mm2], Poisson's ratio, E_red against a steel worm [N/mm2]."""

leads = st.floats(0.03, 0.8)
frictions = st.floats(0.005, 0.1)


@pytest.mark.parametrize(("modulus", "poisson", "reduced"), WHEELS.values(), ids=WHEELS)
def test_reduced_moduli_of_din_3996(modulus, poisson, reduced):
    """The standard's E_red is the reduced modulus of Dowson and Higginson."""
    worm, wheel = Body(210e9, 0.3), Body(modulus * 1e6, poisson)
    assert reduced_modulus(worm, wheel) == pytest.approx(reduced * 1e6, abs=0.6e6)


def test_parameters_of_the_reference_gear():
    """Of the standard's tests, nominally 0.07, 0.962 and 30.8; hollow flanks have a film a third thicker."""
    assert pytest.approx(0.0693, abs=6e-5) == REFERENCE_GEAR.film_parameter
    assert pytest.approx(0.947, abs=6e-4) == REFERENCE_GEAR.pressure_parameter
    assert pytest.approx(30.3, abs=0.06) == REFERENCE_GEAR.sliding_parameter
    hollow = replace(REFERENCE_GEAR, concave=True)
    assert hollow.film_parameter == pytest.approx(0.0900, abs=6e-4)
    assert hollow.pressure_parameter == pytest.approx(0.7395, abs=6e-4)
    assert hollow.sliding_parameter == pytest.approx(0.94 + 0.25 * 20.5 + 6.7 * 9 / 2)


@pytest.mark.parametrize(
    ("oil", "viscosity", "film"),
    [("mineral", 0.0304, 0.191), ("PAO", 0.0373, 0.196), ("PAG", 0.0542, 0.243)],
)
def test_film_worked_for_vg_220_at_80_degrees(oil, viscosity, film):
    worked = {**FILM, "viscosity": viscosity, "pressure_viscosity": PRESSURE_VISCOSITY[oil]}
    assert minimum_film(**worked) * 1e6 == pytest.approx(film, abs=6e-4)


def test_film_worked_for_the_size_of_sharif_2001():
    worked = {**FILM, "viscosity": 0.227, "centre_distance": 0.3048, "torque": 10e3}
    assert minimum_film(**worked) * 1e6 == pytest.approx(1.98, abs=6e-3)


UNITS = {  # exponents of kg, m and s
    "film_parameter": (0, 0, 0),
    "pressure_viscosity": (-1, 1, 2),
    "viscosity": (1, -1, -1),
    "worm_speed": (0, 0, -1),
    "centre_distance": (0, 1, 0),
    "reduced_modulus": (1, -1, -2),
    "torque": (1, 2, -2),
}


def test_the_film_is_a_length_unlike_the_form_in_circulation():
    def exponent(key):
        return log(minimum_film(**{**FILM, key: FILM[key] * 1.1}) / minimum_film(**FILM)) / log(1.1)

    exponents = {key: exponent(key) for key in FILM}
    wrong = {**exponents, "pressure_viscosity": 1, "worm_speed": 0.43}
    wrong |= {"centre_distance": -0.057, "torque": 0.13}
    for powers, length in ((exponents, True), (wrong, False)):
        unit = [sum(powers[key] * UNITS[key][base] for key in FILM) for base in range(3)]
        assert (unit == pytest.approx([0, 1, 0], abs=1e-9)) is length


def test_the_constant_21_is_nothing_but_units():
    product = 1.0
    for key, power in zip(FILM, (1, 0.6, 0.7, 0.7, 1.39, 0.03, -0.13), strict=True):
        product *= FILM[key] ** power
    assert minimum_film(**FILM) / product == pytest.approx(21 / 21.087, rel=1e-4)


def test_mean_pressure_worked_for_the_reference_gear():
    """(4/pi) sqrt(0.962 x 300e3 N mm x 150622 N/mm2 / 1e6 mm3) = 265.5 N/mm2."""
    assert mean_pressure(0.962, 300, BRONZE, 0.1) / 1e6 == pytest.approx(265.5, abs=0.1)
    assert mean_pressure(1, 400, BRONZE, 0.1) == pytest.approx(
        2 * mean_pressure(1, 100, BRONZE, 0.1)
    )


@pytest.mark.parametrize(
    ("oil", "speed", "expected"),
    [("mineral", 1.0, 0.0511), ("PAO", 1.0, 0.0407), ("PAG", 1.0, 0.0368)],
)
def test_friction_of_the_reference_gear_at_1_metre_per_second(oil, speed, expected):
    friction = tooth_friction(oil, speed, 0.1, 0.07, 0.5e-6)
    assert friction == pytest.approx(expected, abs=6e-5)


@given(st.sampled_from(OIL_KINDS), st.floats(0.05, 20), st.floats(1.01, 1.2))
def test_friction_falls_with_speed_size_and_smoothness(oil, speed, more):
    friction = tooth_friction(oil, speed, 0.1, 0.07, 0.5e-6)
    assert tooth_friction(oil, speed * more, 0.1, 0.07, 0.5e-6) <= friction
    assert tooth_friction(oil, speed, 0.1 * more, 0.07, 0.5e-6) < friction
    assert tooth_friction(oil, speed, 0.3 * more, 0.07, 0.5e-6) == tooth_friction(
        oil, speed, 0.25, 0.07, 0.5e-6
    )
    assert tooth_friction(oil, speed, 0.1, 0.07 * more, 0.5e-6) < friction
    assert tooth_friction(oil, speed, 0.1, 0.07, 0.5e-6 * more) > friction


@given(st.floats(0.25, 25))
def test_polyglycol_rubs_least_and_mineral_oil_most(speed):
    mineral, pao, pag = (tooth_friction(oil, speed, 0.1, 0.07, 0.5e-6) for oil in OIL_KINDS)
    assert pag <= pao <= mineral


@given(leads, frictions)
def test_efficiencies_by_the_forces_on_the_thread(lead, friction):
    """Axial against tangential force on the thread: F_t = F_a (tan gamma +- mu)/(1 -+ mu tan gamma)."""
    forward = lead * (1 - friction * lead) / (lead + friction)
    backward = (lead - friction) / (1 + friction * lead) / lead
    assert forward_efficiency(lead, friction) == pytest.approx(forward)
    assert backward_efficiency(lead, friction) == pytest.approx(backward, abs=1e-12)
    assert backward <= forward <= 1


@given(leads, frictions)
def test_a_self_locking_gear_cannot_be_driven_backwards(lead, friction):
    margin, efficiency = self_locking_margin(lead, friction), backward_efficiency(lead, friction)
    if abs(margin - 1) > 1e-9:
        assert (margin > 1) == (efficiency < 0)
    # A thread that locks wastes more than half of the work when it drives.
    if margin > 1:
        assert forward_efficiency(lead, friction) < 0.5


def test_pitting_safety_is_one_at_the_strength_in_the_reference_test():
    strength = WHEEL_MATERIALS["CuSn12Ni2-C-GZ"].pitting_strength
    assert pitting_safety(strength, strength, 25000, 1, 0.1, "PAG") == pytest.approx(1)
    assert pitting_safety(strength, strength, 25000 / 64, 1, 0.1, "PAG") == 1.6
    assert pitting_safety(strength, strength, 400000, 1, 0.1, "PAG") == pytest.approx(
        16 ** (-1 / 6)
    )
    assert pitting_safety(strength, strength, 25000, 16, 0.1, "mineral") == pytest.approx(0.445)
    few = pitting_safety(strength, strength, 25000, 1, 0.1, "PAG", 20.5 / 64)
    assert few == pytest.approx(0.5)


@given(st.sampled_from(OIL_KINDS), st.floats(1e-8, 5e-6), st.floats(1.01, 3))
def test_wear_falls_with_the_film_from_its_cap(oil, film, more):
    wear = wear_intensity(oil, film)
    assert wear_intensity(oil, film * more) <= wear
    assert oil != "mineral" or wear <= 400e-9


def test_wear_depth_grows_as_the_path():
    once = wear_depth(1e-9, 30.3, 270e6, 0.1, BRONZE, 1e6)
    assert once == pytest.approx(1e-9 * 30.3 * 270e6 / BRONZE * 0.1 * 1e6)
    assert wear_depth(1e-9, 30.3, 270e6, 0.1, BRONZE, 3e6) == pytest.approx(3 * once)


def test_bulk_temperature_without_loss_is_the_sumps():
    assert bulk_temperature(350, 0, 100, 0.01, 1) == 350
    # 300 W through 24440 W/(m2 K) times 0.00492 m2.
    hot = bulk_temperature(350, 300, 1500 * RPM, 0.00492, 1)
    assert hot - 350 == pytest.approx(300 / ((1940 + 15 * 1500) * 0.00492))


def test_temperature_safety_is_in_celsius():
    assert temperature_safety(273.15 + 60, 273.15 + 90) == pytest.approx(1.5)


def test_rating_agrees_with_its_formulas_and_with_energy():
    bronze = WHEEL_MATERIALS["CuSn12Ni2-C-GZ"]
    conditions = WormConditions(
        **DUTY, material=bronze, life=25000, sump_temperature=353.15, lubrication="bath"
    )
    rating = WormRating(REFERENCE_GEAR, conditions)
    assert rating.film == pytest.approx(0.2409e-6, rel=2e-3)  # 0.2432 um, worked for h* = 0.07
    assert rating.sliding_speed == pytest.approx(2.896, abs=2e-3)
    power = 300 * 1500 * RPM / 20.5
    assert power / (power + rating.tooth_loss) == pytest.approx(rating.forward_efficiency)
    assert power / (power + rating.loss) == pytest.approx(rating.gearbox_efficiency)
    assert rating.pitting_safety > 1
    assert rating.bulk_temperature > 353.15


@pytest.mark.parametrize("figure", ["pitting_safety", "bulk_temperature", "wear"])
def test_a_figure_without_its_data_says_what_is_missing(figure):
    rating = WormRating(REFERENCE_GEAR, WormConditions(**DUTY))
    assert rating.film > 0 and rating.friction > 0
    with pytest.raises(ValueError, match="it is not given"):
        getattr(rating, figure)


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"centre_distance": 100.0}, "centre distance = 100 m: must lie between 0.025 and 2 m"),
        ({"module": 4.0}, "module = 4 m"),
        ({"teeth": 50}, "module, diameter factor, teeth and profile shift make 0.118 m"),
        ({"face_width": 30.0}, "face width = 30 m"),
        ({"pressure_angle": 20.0}, "pressure angle = 20 rad"),
    ],
)
def test_gears_in_wrong_units_are_refused(change, sentence):
    gear = {
        "centre_distance": 0.1,
        "starts": 2,
        "teeth": 41,
        "module": 4e-3,
        "diameter_factor": 9.0,
        "face_width": 0.03,
    }
    with pytest.raises(ValueError, match=sentence):
        WormGear(**{**gear, **change})


@pytest.mark.parametrize(
    ("figure", "change", "sentence"),
    [
        ("film", {"oil": "ester"}, 'oil = "ester": must be one of "mineral", "PAO", "PAG"'),
        ("film", {"viscosity": 54.2}, "dynamic viscosity = 54.2 Pa s"),
        ("mean_pressure", {"reduced_modulus": 150622.0}, "reduced modulus = 150622 Pa"),
        ("friction", {"roughness": 0.5}, "roughness Ra = 0.5 m"),
        (
            "mean_pressure",
            {"torque": -1.0},
            "wheel torque = -1 N m: must be finite and greater than",
        ),
        ("film", {"worm_speed": 2e4}, "worm speed"),
        (
            "bulk_temperature",
            {"sump_temperature": 80.0, "lubrication": "bath"},
            "sump temperature = 80 K",
        ),
        (
            "bulk_temperature",
            {"sump_temperature": 350.0, "supplied_viscosity": 54.0},
            "viscosity of the injected oil",
        ),
        ("root_shear", {"rim": 0.5}, "rim over module = 0.5"),
        ("loss", {"bearings": "plain"}, 'bearings = "plain"'),
        ("friction", {"lubrication": "spray"}, 'lubrication = "spray"'),
    ],
)
def test_duties_in_wrong_units_are_refused(figure, change, sentence):
    rating = WormRating(REFERENCE_GEAR, WormConditions(**DUTY | change))
    with pytest.raises(ValueError, match=sentence) as refused:
        getattr(rating, figure)
    assert "\n" not in str(refused.value)


def test_what_the_wheel_loses_as_it_drives():
    """Of its power, what does not come to the worm; of a gear that locks, also what the worm adds."""
    for oil, rpm in (("PAG", 1500), ("mineral", 60)):
        duty = DUTY | {"oil": oil, "worm_speed": rpm * RPM, "driver": "wheel"}
        rating = WormRating(WormGear(0.106, 1, 41, 4e-3, 12.0, 30e-3), WormConditions(**duty))
        worm = rating.output * rating.backward_efficiency  # negative where the worm has to help
        assert rating.tooth_loss == pytest.approx(rating.output - worm)
        forward = replace(rating, under=WormConditions(**duty | {"driver": "worm"}))
        assert forward.tooth_loss == pytest.approx(
            rating.output * (1 / rating.forward_efficiency - 1)
        )
        # friction is taken from the force along the worm's circumference, or added to it
        assert rating.shaft_deflection < forward.shaft_deflection
        assert rating.gearbox_efficiency == forward.gearbox_efficiency


def test_what_locks_a_gearbox():
    """Bearings and seals resist at rest as well, churning does not: of speed zero, with friction at rest."""
    rating = WormRating(REFERENCE_GEAR, WormConditions(**DUTY))
    others = 0.03 * 100**0.44 * 20.5 / 164 + 2 * 1.178e-5 * 36**2 * 1500 / rating.output
    mu = static_friction(0.1, 0.5e-6)
    teeth = tan(atan(2 / 9) - atan(mu)) / (2 / 9)
    assert rating.static_gearbox_efficiency_back == pytest.approx(teeth - others, abs=3e-3)
    assert rating.static_gearbox_efficiency_back < rating.static_backward_efficiency


@pytest.mark.parametrize(("rpm", "nearest"), [(5, 0.05), (20000, 25.0)])
def test_beyond_the_speeds_of_known_friction_a_wheel_is_as_warm_as_at_the_nearest(rpm, nearest):
    duty = DUTY | {"worm_speed": rpm * RPM, "sump_temperature": 353.15, "lubrication": "bath"}
    rating = WormRating(REFERENCE_GEAR, WormConditions(**duty))
    assert not rating.within_friction
    with pytest.raises(ValueError, match="sliding speed"):
        rating.friction  # noqa: B018
    mu = tooth_friction(
        "PAG", nearest, 0.1, REFERENCE_GEAR.film_parameter, DUTY["roughness"], 1.0, "bath"
    )
    loss = rating.output * (tan(atan(2 / 9) + atan(mu)) / (2 / 9) - 1)
    area = REFERENCE_GEAR.face_width * REFERENCE_GEAR.mean_wheel_diameter
    assert rating.bulk_temperature == pytest.approx(
        bulk_temperature(353.15, loss, rpm * RPM, area, 1.0)
    )


def test_static_friction_of_the_reference_gear():
    """0.13 of bronze; its factors are those of running friction, the size's only by the root of the root."""
    assert static_friction(0.1, 0.5e-6) == pytest.approx(0.13)
    assert static_friction(0.2, 0.5e-6) == pytest.approx(0.13 / 2**0.25)
    assert static_friction(0.1, 8e-6, 1.2) == pytest.approx(0.13 * 1.2 * 2)
    for oil in OIL_KINDS:
        assert tooth_friction(oil, 0.05, 0.1, 0.07, 0.5e-6) < static_friction(0.1, 0.5e-6)


def test_teeth_at_rest_rub_no_less_than_creeping_ones():
    """Of a small gear with thin films the running friction near standstill is above 0.13 sqrt(Y_S)."""
    small = WormGear(0.06, 1, 100, 1e-3, 20.0, 15e-3)
    duty = DUTY | {"oil": "mineral", "worm_speed": 110 * RPM, "torque": 5.0}
    rated = WormRating(small, WormConditions(**duty))
    assert rated.friction > static_friction(0.06, 0.5e-6)
    assert rated.static_friction == rated.friction
