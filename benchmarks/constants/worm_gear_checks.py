"""Geometry, film, friction, pitting, wear, roots and shafts of worm gears against an older form."""

from dataclasses import replace
from itertools import pairwise, product
from math import atan, cos, hypot, log, pi, sqrt, tan

from chapter import MEMORY, OURS, TRANSCRIBED, Chapter, Clause, falls, rises, within_factor
from constant_slips import Check, ModuleNumbers

from pyworm.formulas.micropitting import mean_friction
from pyworm.formulas.oil_properties import gold_alpha
from pyworm.formulas.worm_gear import REFERENCE_GEAR, WormGear
from pyworm.materials.library import named_oil

RPM = pi / 30
BRONZE = 150622e6


def gears(module):
    """Worm gears of usual proportions, with the face width of the older form, 2 m (0.5 + sqrt(q + 1))."""
    for q, starts, teeth, shift in product((7, 9, 12), (1, 2, 4), (30, 41, 60), (-0.3, 0.0, 0.3)):
        m = 4e-3
        yield module.WormGear(
            m / 2 * (q + teeth + 2 * shift), starts, teeth, m, q, 2 * m * (0.5 + sqrt(q + 1)), shift
        )


def film_of_1998(gear) -> float:
    """h* by the older form (in the transcription beside that of 2012)."""
    q, teeth, shift = gear.diameter_factor, gear.teeth, gear.profile_shift
    first = 0.018 + q / (7.86 * (q + teeth)) + 1 / teeth + shift / 110 - gear.ratio / 36300
    return first + gear.face_width / (370.4 * gear.module) - sqrt(2 * q - 1) / 213.9


def pressure_of_1998(gear) -> float:
    """p_m* by the older form (from memory)."""
    q, u = gear.diameter_factor, gear.ratio
    width = gear.face_width / gear.module
    first = 0.4 + gear.profile_shift / u + 0.01 * gear.teeth - 0.083 * width + sqrt(2 * q - 1) / 6.9
    return 1.03 * (first + (q + 50 * (u + 1) / u) / (15.9 + 37.5 * q))


def _as_1998(of):
    return all(
        within_factor(g.film_parameter, film_of_1998(g), 1.13)
        and within_factor(g.pressure_parameter, pressure_of_1998(g), 1.2)
        for g in gears(of)
    )


def _nominal(of):
    gear = of.REFERENCE_GEAR
    return (
        within_factor(gear.film_parameter, of.REFERENCE_FILM, 1.02)
        and within_factor(gear.film_parameter, 0.07, 1.02)
        and within_factor(gear.pressure_parameter, 0.962, 1.02)
        and within_factor(gear.sliding_parameter, 30.8, 1.03)
    )


def _hollow(of):
    """Hollow flanks: every parameter the same multiple of the other flanks', 1.3, 0.781 and 1.196."""
    rows = [
        (
            hollow.film_parameter / gear.film_parameter,
            hollow.pressure_parameter / gear.pressure_parameter,
            hollow.sliding_parameter / gear.sliding_parameter,
        )
        for gear in gears(of)
        for hollow in [replace(gear, concave=True)]
    ]
    return all(within_factor(max(row), min(row), 1.004) for row in zip(*rows, strict=True))


def _shift(of):
    """A shift changes pressures of low leads by 6 % at most, and of high ones several times as much."""
    like = of.WormGear(0.1, 2, 41, 4e-3, 9.0, 30e-3)
    steep = of.WormGear(0.09, 6, 36, 4e-3, 9.0, 30e-3)
    ranges = []
    for gear in (like, steep):
        ends = [
            replace(gear, profile_shift=x, centre_distance=gear.centre_distance + x * 4e-3)
            for x in (-0.5, 0.5)
        ]
        ranges.append(ends[1].pressure_parameter / ends[0].pressure_parameter)
    return 1.02 < ranges[0] < 1.08 and 1.3 < ranges[1] < 2.2


def _pressure_angle(of):
    """From 15 to 25 degrees flanks curve less: pressures fall by 5 to 25 %, films grow by 10 to 35 %."""
    like = of.WormGear(0.1, 2, 41, 4e-3, 9.0, 30e-3)
    made = [replace(like, pressure_angle=angle * pi / 180) for angle in (15, 20, 25)]
    pressed, films = (
        [getattr(g, key) for g in made] for key in ("pressure_parameter", "film_parameter")
    )
    return (
        falls(pressed)
        and 1.05 < pressed[0] / pressed[2] < 1.25
        and rises(films)
        and 1.1 < films[2] / films[0] < 1.35
    )


def _wear_leaves_teeth(of):
    """What may wear off is 15 to 25 % of a tooth's thickness, and a tip of 0.2 modules stays."""
    gear = of.REFERENCE_GEAR
    share = gear.wear_limit / gear.tooth_thickness
    tip = gear.module * (pi / 2 - 2 * tan(pi / 9)) - gear.wear_limit / cos(gear.lead_angle)
    return 0.15 < share < 0.25 and 0.2 < tip / gear.module < 0.7


def _reference_closes(of):
    """Its parts make its centre distance, u is 20.5."""
    gear = of.REFERENCE_GEAR
    made = gear.module / 2 * (gear.diameter_factor + gear.teeth)
    return (
        within_factor(made, gear.centre_distance, 1.001)
        and gear.ratio == 20.5
        and 0.7 < gear.face_width / gear.worm_diameter < 0.9
    )


def _root_of_the_worm(of):
    """A root 1.2 to 1.3 modules below the reference cylinder (ISO 10828)."""
    gear = of.REFERENCE_GEAR
    return 1.2 < (gear.worm_diameter - gear.worm_root_diameter) / gear.module / 2 < 1.3


def _gear_results(of):
    rows = []
    for gear in gears(of):
        hollow = replace(gear, concave=True)
        rows += [g for one in (gear, hollow) for g in (
            one.film_parameter, one.pressure_parameter, one.sliding_parameter
        )]  # fmt: skip
    return [*rows, of.REFERENCE_GEAR.wear_limit]


GEOMETRY = Chapter(
    "Geometry parameters of worm gears",
    ModuleNumbers("pyworm.formulas.worm_gear"),
    "[DIN 3996:2012](bibliography.md#din-3996), parameters h*, p_m*, s*",
    {
        "REFERENCE_FILM": Clause("h* of the reference gear", TRANSCRIBED),
        "ALLOWED_WEAR": Clause("delta_Wlim = 0.3 m_x cos gamma", TRANSCRIBED),
        "WormGear.worm_root_diameter": Clause("usual depth of threads, two dedenda", TRANSCRIBED),
        "WormGear.film_parameter": Clause("h* of 2012", TRANSCRIBED),
        "WormGear.pressure_parameter": Clause("p_m* of 2012, hollow flanks first", TRANSCRIBED),
        "WormGear.sliding_parameter": Clause("s*, hollow flanks first", MEMORY),
        "REFERENCE_GEAR": Clause("reference gear: a, z2, m_x, q, b_2H in m", TRANSCRIBED),
    },
    (
        Check("h* within 13 %, p_m* within 20 % of the older forms over 81 gears", _as_1998),
        Check("the reference gear's nominal 0.07, 0.962 and 30.8 within 3 %", _nominal),
        Check("hollow flanks have the same multiple of every parameter of other flanks", _hollow),
        Check("shifts change p_m* little, most at high leads", _shift),
        Check("with the pressure angle p_m* falls and h* grows", _pressure_angle),
        Check("worn teeth keep three quarters of their thickness and a tip", _wear_leaves_teeth),
        Check("the reference gear's parts make its centre distance and u", _reference_closes),
        Check("threads are 2.2 to 2.3 modules deep", _root_of_the_worm),
    ),
    _gear_results,
)


# ---------------------------------------------------------------------- film, friction, pitting

OILS = ("mineral", "PAO", "PAG")
FILM = {
    "film_parameter": 0.07,
    "pressure_viscosity": 1.3e-8,
    "viscosity": 0.05,
    "worm_speed": 1500 * RPM,
    "centre_distance": 0.1,
    "reduced_modulus": BRONZE,
    "torque": 300.0,
}
UNITS = {  # exponents of kg, m and s
    "pressure_viscosity": (-1, 1, 2),
    "viscosity": (1, -1, -1),
    "worm_speed": (0, 0, -1),
    "centre_distance": (0, 1, 0),
    "reduced_modulus": (1, -1, -2),
    "torque": (1, 2, -2),
}


def _exponents(of):
    base = of.minimum_film(**FILM)
    return {
        key: log(of.minimum_film(**{**FILM, key: FILM[key] * 1.1}) / base) / log(1.1)
        for key in FILM
    }


def _film_is_a_length(of):
    powers = _exponents(of)
    left = [sum(powers[key] * unit[base] for key, unit in UNITS.items()) for base in range(3)]
    return max(abs(a - b) for a, b in zip(left, (0, 1, 0), strict=True)) < 2e-3


def _film_of_dowson_and_higginson(of):
    """Exponents of h = R 1.6 (alpha E)^0.6 (eta u/(E R))^0.7 (w/(E R))^-0.13, R and u/n being lengths."""
    powers = _exponents(of)
    wanted = {
        "pressure_viscosity": 0.6,
        "viscosity": 0.7,
        "worm_speed": 0.7,
        "reduced_modulus": 0.6 - 0.7 + 0.13,
        "torque": -0.13,
    }
    return all(abs(powers[key] - value) < 2e-3 for key, value in wanted.items())


def _film_constant_is_units(of):
    """In SI the constant becomes one: 21 holds nothing but rpm, mm, N/mm2 and um."""
    product_ = 1.0
    for key, power in _exponents(of).items():
        product_ *= FILM[key] ** power
    return within_factor(of.minimum_film(**FILM) / product_, 1.0, 1.01)


def _as_golds_law(of):
    """c_alpha is Gold's coefficient of VG 220 at 80 degC within 1.35, in its order."""
    values = [of.PRESSURE_VISCOSITY[oil] for oil in OILS]
    golds = []
    for oil in OILS:
        named = named_oil(f"{oil} VG 220")
        nu = named.kinematic_viscosity(353.15)
        golds.append(float(gold_alpha(nu, named.stock.gold_s, named.stock.gold_t)))
    return falls(values) and all(
        within_factor(a, b, 1.35) for a, b in zip(values, golds, strict=True)
    )


def _pressure_of_hertz(of):
    """The worm of Sharif et al. (2001): its mean is 0.45 to 0.56 of the 530 MPa of Hertz for one tooth."""
    gear = WormGear(0.3048, 3, 59, 9.145e-3, 8.5, 60.33e-3, -0.42)
    torque = 14e3 * 0.26 * cos(gear.lead_angle) * cos(pi / 9) * 1.96
    mean = of.mean_pressure(gear.pressure_parameter, torque, 170.81e9, 0.3048)
    larger = of.mean_pressure(gear.pressure_parameter, torque * 8, 170.81e9, 0.6096)
    return 0.45 < mean / 530e6 < 0.56 and within_factor(mean, larger, 1.001)


def _friction(of, **changed):
    given = {
        "oil": "PAG",
        "sliding_speed": 2.0,
        "centre_distance": 0.1,
        "film_parameter": 0.07,
        "roughness": 0.5e-6,
    } | changed
    return of.tooth_friction(**given)


def _factors_are_one(of):
    """Of the reference gear each factor is 1: friction its base curve, S_H its strength over the stress."""
    base = of.base_friction("PAG", 2.0, "injection", "tin bronze")
    safety = of.pitting_safety(4e8, 4e8, 25000, 1.0, 0.1, "PAG", 20.5)
    return within_factor(_friction(of), base, 1.001) and within_factor(safety, 1, 1.001)


def _size_factor_is_bounded(of):
    """Y_S lies between 0.6 and 1.3 for gears of any size, and falls as the root of the size between."""
    sizes = [_friction(of, centre_distance=a) / _friction(of) for a in (0.025, 0.08, 0.16, 2.0)]
    return (
        1.15 < sizes[0] < 1.3
        and 0.6 < sizes[3] < 0.7
        and within_factor(sizes[1] / sizes[2], sqrt(2), 1.001)
    )


def _roughness_as_in_micropitting(of):
    """Friction grows with Ra by the power of ISO/TS 6336-22's mean friction."""
    ratio = _friction(of, roughness=1e-6) / _friction(of)
    other = mean_friction(1e5, 5.0, 0.01, 0.05, 1e-6, 1.0) / mean_friction(
        1e5, 5.0, 0.01, 0.05, 0.5e-6, 1.0
    )
    return within_factor(ratio, other, 1.001)


def _at_rest(of):
    """At rest teeth rub 1.2 to 1.5 times as much as creeping ones; bronze within 10 % of Niemann's 0.12."""
    mu = of.STATIC_FRICTION
    tin, other, iron = mu["tin bronze"], mu["aluminium bronze"], mu["cast iron"]
    return (
        within_factor(tin, 0.12, 1.1)
        and 1.1 < other / tin < 1.25
        and 1.25 < iron / tin < 1.5
        and within_factor(of.static_friction(0.1, 0.5e-6), tin, 1.001)
    )


def _oil_limits(of):
    """Sumps end at 85 to 115 degC, mineral oil first, in steps of 8 to 12 K."""
    celsius = [of.OIL_LIMITS[oil] - 273.15 for oil in OILS]
    steps = [b - a for a, b in pairwise(celsius)]
    return 85 < celsius[0] and celsius[-1] < 115 and all(8 < step < 12 for step in steps)


def _cycles_decide(of):
    """Life over ratio, the number of cycles of the wheel, decides: 12 % more stress for half of them."""

    def safety(life, ratio):
        return of.pitting_safety(4e8, 4e8, life, 1.0, 0.1, "PAG", ratio)

    same = within_factor(safety(10000, 5), safety(20000, 10), 1.001)
    return same and 1.10 < safety(10000, 10) / safety(20000, 10) < 1.15


def _short_lives(of):
    """Static strength is reached at 1000 to 2000 h of the reference test, 1e7 turns of the wheel."""

    def safety(life):
        return of.pitting_safety(4e8, 4e8, life, 1.0, 0.1, "PAG", 20.5)

    return safety(1000) == safety(1.0) and safety(2000) < safety(1000)


def _faster_and_larger_pit_sooner(of):
    """From 0 to 25 m/s strength falls to 0.3 to 0.45, from 25 mm to 2 m to 0.7 to 0.85."""

    def safety(speed, size):
        return of.pitting_safety(4e8, 4e8, 25000, speed, size, "PAG", 20.5)

    return (
        0.3 < safety(25, 0.1) / safety(0, 0.1) < 0.45
        and 0.7 < safety(1, 2.0) / safety(1, 0.025) < 0.85
    )


def _oils_pit_in_order(of):
    """Mineral oil, PAO, PAG: strengths in this order, all within 15 %."""
    return rises([0.85] + [of.pitting_safety(4e8, 4e8, 25000, 1.0, 0.1, oil) for oil in OILS])


def _warmer(of, size, speed, injected):
    gear = REFERENCE_GEAR
    if size != 0.1:
        m = gear.module * size / 0.1
        gear = replace(
            gear, centre_distance=size, module=m, face_width=gear.face_width * size / 0.1
        )
    loss = 200 * (size / 0.1) ** 2
    if injected:
        return of.injected_bulk_temperature(340, loss, speed * RPM, gear, 55e-6) - 340
    area = gear.face_width * gear.mean_wheel_diameter
    return of.bulk_temperature(340, loss, speed * RPM, area, 1.0) - 340


def _bath_as_injection(of):
    """A creeping reference wheel is as warm in a bath as with injected oil, within 1.2."""
    for slow in (60, 150):
        if not within_factor(_warmer(of, 0.1, slow, True), _warmer(of, 0.1, slow, False), 1.2):
            return False
    return 2 < _warmer(of, 0.1, 1500, True) / _warmer(of, 0.1, 1500, False) < 3.5


def _heat_transfer(of):
    """The wheel passes 3 to 10 kW/(m2 K) on at 150 rpm, 10 to 40 at 1500, and as much below 150 as there."""
    area = REFERENCE_GEAR.face_width * REFERENCE_GEAR.mean_wheel_diameter
    slow, fast = (200 / area / _warmer(of, 0.1, n, False) for n in (150, 1500))
    level = (
        _warmer(of, 0.1, 60, False) == _warmer(of, 0.1, 150, False) < _warmer(of, 0.1, 60, True) * 2
    )
    below = _warmer(of, 0.1, 120, True) == _warmer(of, 0.1, 150, True) > _warmer(of, 0.1, 200, True)
    return (
        3e3 < slow < 1e4 < fast < 4e4
        and level
        and below
        and _warmer(of, 0.1, 200, False) < _warmer(of, 0.1, 150, False)
    )


def _injected_trends(of):
    """Twice the speed or half the viscosity cool by 1.15 to 1.45, twice the size by 1.3 to 1.7."""
    gear = REFERENCE_GEAR
    double = replace(gear, centre_distance=0.2, module=8e-3)

    def warm(gear_=gear, speed=1000, thick=55e-6):
        return of.injected_bulk_temperature(340, 200, speed * RPM, gear_, thick) - 340

    return all(
        low < warm(**slow) / warm(**fast) < high
        for slow, fast, low, high in (
            ({}, {"speed": 2000}, 1.15, 1.45),
            ({"thick": 110e-6}, {}, 1.15, 1.45),
            ({}, {"gear_": double}, 1.3, 1.7),
        )
    )


def _standard_results(of):
    values = [of.minimum_film(**FILM), of.mean_pressure(0.95, 300, BRONZE, 0.1)]
    values += [_friction(of, centre_distance=a) for a in (0.05, 0.1, 0.5)]
    values += [
        _warmer(of, size, n, way) for size in (0.1, 0.25) for n in (60, 1000) for way in (0, 1)
    ]
    values += [
        of.pitting_safety(4e8, 4e8, life, v, a, oil, u)
        for life, v, a, oil, u in ((1000, 0.5, 0.05, "PAO", 10), (40000, 5, 0.3, "mineral", 40))
    ]
    return values


STANDARD = Chapter(
    "Film, stress, tooth friction, pitting, bulk temperature",
    ModuleNumbers("pyworm.formulas.worm_standard"),
    "[DIN 3996:2012](bibliography.md#din-3996), [ISO/TS 14521](bibliography.md#iso-ts-14521)",
    {
        "PRESSURE_VISCOSITY": Clause("c_alpha in m2/N", MEMORY),
        "_OIL_LIFE": Clause("Z_oil", MEMORY),
        "STATIC_FRICTION": Clause("friction at rest", TRANSCRIBED),
        "OIL_LIMITS": Clause("theta_Slim in K", TRANSCRIBED),
        "_REFERENCE_RATIO": Clause("u in Z_u", MEMORY),
        "minimum_film": Clause("h_min,m", MEMORY),
        "mean_pressure": Clause("sigma_Hm = (4/pi) sqrt(p_m* T2 E_red/a^3)", MEMORY),
        "_size_factor": Clause("Y_S and its bounds, m", TRANSCRIBED),
        "_rubbing": Clause("Y_R = (Ra/0.5 um)^(1/4)", TRANSCRIBED),
        "pitting_safety": Clause("Z_h, its bound, Z_v, Z_S, Z_u", MEMORY),
        "rim_heat_transfer": Clause("alpha_L = c_k (1940 + 15 n1)", MEMORY),
        "injected_bulk_temperature": Clause("16 K_n K_nu K_S P_Vz", TRANSCRIBED),
    },
    (
        Check("the film is a length", _film_is_a_length),
        Check(
            "the film has Dowson and Higginson's exponents of 1966", _film_of_dowson_and_higginson
        ),
        Check("21 is nothing but units", _film_constant_is_units),
        Check("c_alpha is Gold's at 80 degC within 1.35", _as_golds_law),
        Check(
            "the mean stress is half of Hertz's for one tooth of a published worm",
            _pressure_of_hertz,
        ),
        Check("each factor of the reference gear is 1", _factors_are_one),
        Check("Y_S from 0.6 to 1.3", _size_factor_is_bounded),
        Check("friction grows with Ra as in ISO/TS 6336-22", _roughness_as_in_micropitting),
        Check("friction at rest: bronze as Niemann, iron 1.25 to 1.5 times", _at_rest),
        Check("limits of the sump in steps of 8 to 12 K", _oil_limits),
        Check("cycles of the wheel alone decide on pitting", _cycles_decide),
        Check("short lives end at static strength", _short_lives),
        Check(
            "speed and size weaken flanks by 0.3 to 0.45 and 0.7 to 0.85",
            _faster_and_larger_pit_sooner,
        ),
        Check("oils pit in order, within 15 %", _oils_pit_in_order),
        Check(
            "bath and injection agree within 1.2 for the creeping reference gear",
            _bath_as_injection,
        ),
        Check("wheels pass on 3 to 40 kW/(m2 K)", _heat_transfer),
        Check("trends of injected oil with speed, viscosity and size", _injected_trends),
    ),
    _standard_results,
)


# ---------------------------------------------------------------------------- wear, root, shaft


def _pressure_is_continuous(of):
    """W_H is 1 up to the pitting strength of tin bronze, 425 to 520 MPa, and goes on without a jump."""
    ends = [p * 1e6 for p in range(400, 540) if of.pressure_factor(p * 1e6) < 1]
    return 425e6 < ends[0] < 520e6 and of.pressure_factor(ends[0]) > 0.97


def _pressure_thins(of):
    """A stress a tenth higher counts as 1.3 to 1.8 times thinner films on bronze, 1.1 to 1.2 on iron."""
    bronze = of.pressure_factor(500e6) / of.pressure_factor(550e6)
    iron = of.pressure_factor(300e6, "cast iron") / of.pressure_factor(330e6, "cast iron")
    unit = [p for p in range(100, 700, 5) if of.pressure_factor(p * 1e6, "cast iron") <= 1]
    return 1.3 < bronze < 1.8 and 1.1 < iron < 1.2 and 250 < unit[0] < 350


def _thick_oil_wears_less(of):
    """W_S falls slower than films grow with the viscosity, eta^0.7, and is 2 to 4 at 80 degC."""
    thin, thick = (of.structure_factor("PAG", eta) for eta in (0.03, 0.06))
    return 1.15 < thin / thick < 2**0.7 * 0.9 and 2 < thick < 4


def _starts(of):
    """A start a minute doubles the wear at least and no number of them more than fivefold."""
    return (
        1.5 < of.start_factor(60) < 2.5
        and 3 < of.start_factor(1e4) < 5
        and (of.start_factor(150) < of.start_factor(250) == of.start_factor(1e4))
    )


WEAR = Chapter(
    "Wear factors",
    ModuleNumbers("pyworm.formulas.worm_wear"),
    "[DIN 3996:2012](bibliography.md#din-3996), wear",
    {
        "MOST_STARTS": Clause("largest W_NS", TRANSCRIBED),
        "structure_factor": Clause("W_S = eta^-0.35", TRANSCRIBED),
        "pressure_factor": Clause("W_H of iron, of bronze (Pa)", TRANSCRIBED),
        "start_factor": Clause("W_NS = 1 + 0.015 N_S", TRANSCRIBED),
    },
    (
        Check("W_H begins at the pitting strength without a jump", _pressure_is_continuous),
        Check("W_H of a tenth more stress", _pressure_thins),
        Check("thicker oil wears less", _thick_oil_wears_less),
        Check("W_NS: 1.5 to 2.5 at a start a minute, 3 to 5 at most", _starts),
    ),
    lambda of: [
        of.structure_factor("PAG", 0.05),
        of.pressure_factor(5e8),
        of.pressure_factor(4e8, "cast iron"),
        of.start_factor(30),
        of.start_factor(1e3),
    ],
)


def _root_of_a_rack(of):
    """The wheel's tooth is as thick as a rack's at its dedendum, and up to a tenth more for the throat."""
    gear = REFERENCE_GEAR
    rack = gear.module * (pi / 2 + 2 * 1.25 * tan(gear.pressure_angle) / cos(gear.lead_angle))
    return 1 <= of.root_thickness(gear) / rack < 1.1 and within_factor(of.DEDENDUM, 1.2, 1.05)


def _rim_is_continuous(of):
    """No jump at two modules, and 1.5 to 2 at one."""
    return abs(of.rim_factor(2 - 1e-9) - 1) < 1e-3 and 1.5 < of.rim_factor(1.0) < 2


def _shear_over_the_root(of):
    """Nominal shear is 2 to 4 times the force of one of two teeth over the area of its root."""
    gear = REFERENCE_GEAR
    plain = gear.tangential_force(300) / 2 / (gear.face_width * gear.module * 2.6)
    return 2.4 < of.root_shear(gear, 300) / plain < 3.6


ROOT = Chapter(
    "Roots of the wheel's teeth",
    ModuleNumbers("pyworm.formulas.worm_root"),
    "[DIN 3996:2012](bibliography.md#din-3996), tooth root",
    {
        "CONTACT_FACTOR": Clause("Y_epsilon", TRANSCRIBED),
        "DEDENDUM": Clause("of the wheel, in modules", OURS),
        "root_thickness": Clause("s_f2", TRANSCRIBED),
        "rim_factor": Clause("Y_K; 5.218 for the transcription's 5.281", TRANSCRIBED),
        "root_shear": Clause("Y_F = 2.9 m_x/s_f2", TRANSCRIBED),
    },
    (
        Check("root as thick as a rack's, and up to a tenth more", _root_of_a_rack),
        Check("Y_K without a jump at two modules", _rim_is_continuous),
        Check("shear 2.4 to 3.6 times that over a root of two teeth", _shear_over_the_root),
    ),
    lambda of: [of.root_shear(REFERENCE_GEAR, 300), of.rim_factor(1.5)],
)


def _bends_as_transcribed(of):
    """The transcription's 0.006592 F l^3/(E d^4) is ours within 4 %: 64/(3 pi)/1000 = 0.00679."""
    lead, half = atan(2 / 9), 86e-3
    across = hypot(tan(lead + atan(0.03)), tan(pi / 9) / cos(lead))
    force = REFERENCE_GEAR.tangential_force(300) * across
    worked = 6.592 * force * half**3 / (2 * 210e9 * (1.1 * 26e-3) ** 4)
    return within_factor(of.shaft_deflection(REFERENCE_GEAR, 300, 0.03), worked, 1.04)


def _limit_of_shafts(of):
    """Within three of 0.01 m_x, which a design program allows with heat-treated worms, from 2 to 10 mm."""
    return all(within_factor(of.deflection_limit(m), 0.01 * m, 3) for m in (2e-3, 4e-3, 10e-3))


SHAFT = Chapter(
    "Deflection of the worm's shaft",
    ModuleNumbers("pyworm.formulas.worm_deflection"),
    "[DIN 3996:2012](bibliography.md#din-3996), deflection",
    {
        "STIFF_DIAMETER": Clause("shaft over root diameter", TRANSCRIBED),
        "STEEL": Clause("Young's modulus in Pa", TRANSCRIBED),
        "deflection_limit": Clause("0.04 sqrt(m_x) mm, in m", TRANSCRIBED),
    },
    (
        Check("deflection of the transcription within 4 %", _bends_as_transcribed),
        Check("limit within three of 0.01 m_x of a design program", _limit_of_shafts),
    ),
    lambda of: [of.shaft_deflection(REFERENCE_GEAR, 300, 0.03), of.deflection_limit(4e-3)],
)


def _required(of):
    """No part may fail by rule, none needs more than a fifth to spare: wear."""
    least = of.REQUIRED
    return (
        set(least) == {"S_W", "S_H", "S_delta", "S_F", "S_T", "S_M"}
        and least["S_M"] == 1  # of the wheel's material, which the standard does not rate
        and all(1 <= value < 1.2 for value in least.values())
        and least["S_W"] == least["S_F"] == least["S_T"] > least["S_H"] == least["S_delta"]
    )


REQUIRED = Chapter(
    "Minimum safety factors of worm gears",
    ModuleNumbers("pyworm.ratings.worm_safeties", only=("REQUIRED",)),
    "[DIN 3996:2012](bibliography.md#din-3996), minimum safety factors",
    {"REQUIRED": Clause("S_Wmin, S_Fmin, S_Tmin (those of 1 are not listed)", TRANSCRIBED)},
    (Check("from 1 to 1.2, wear, roots and oil alike", _required),),
    lambda of: list(of.REQUIRED.values()),
)

CHAPTERS = (GEOMETRY, STANDARD, WEAR, ROOT, SHAFT, REQUIRED)
