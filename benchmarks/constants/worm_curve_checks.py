"""Base friction, base wear and wheel materials of worm gears against neighbours."""

from itertools import pairwise, product
from math import exp
from statistics import mean

from chapter import OURS, TRANSCRIBED, Chapter, Clause, falls, within_factor
from constant_slips import Check, ModuleNumbers

OILS = ("mineral", "PAO", "PAG")
WAYS = ("injection", "bath")
FAMILIES = ("tin bronze", "aluminium bronze", "cast iron")
SPEEDS = [0.05 * 1.1**step for step in range(65)]

TENSILE = {
    "CuSn12-C-GZ": 280e6,
    "CuSn12Ni2-C-GZ": 300e6,
    "CuSn12Ni2-C-GC": 300e6,
    "CuAl10Fe5Ni5-C-GZ": 650e6,
    "EN-GJS-400-15": 400e6,
    "EN-GJL-250": 250e6,
}
"""Tensile strength of EN 1982, EN 1563 and EN 1561 [Pa]."""

MODULI = {
    "CuSn12-C-GZ": 140e9,
    "CuSn12Ni2-C-GZ": 151e9,
    "CuSn12Ni2-C-GC": 151e9,
    "CuAl10Fe5Ni5-C-GZ": 174e9,
    "EN-GJS-400-15": 210e9,
    "EN-GJL-250": 147e9,
}
"""Reduced modulus against steel [Pa], from the materials' own moduli."""


def agma_friction(speed: float) -> float:
    """Friction of steel worms on bronze by AGMA 6034, 0.103 exp(-0.110 v^0.450) + 0.012, v in ft/min."""
    return 0.103 * exp(-0.110 * (speed / 0.00508) ** 0.450) + 0.012


def _curves(of):
    return [
        (family, way, oil, [of.base_friction(oil, v, way, family) for v in SPEEDS])
        for family, way, oil in product(FAMILIES, WAYS, OILS)
    ]


def _of_oils(of, speed, way="injection", family="tin bronze"):
    return [of.base_friction(oil, speed, way, family) for oil in OILS]


def _bath_over_injection(of):
    ratios = [
        of.base_friction(oil, 1.0, "bath") / of.base_friction(oil, 1.0, "injection") for oil in OILS
    ]
    return within_factor(max(ratios), min(ratios), 1.09) and 0.7 < mean(ratios) < 0.8


def _bath_crosses_once(of):
    """Bath rubs less than injection at medium speeds and more at the highest, where it drags."""
    return all(
        of.base_friction(oil, 0.5, "bath") < 0.95 * of.base_friction(oil, 0.5)
        and 1.0 < of.base_friction(oil, 25, "bath") / of.base_friction(oil, 25) < 1.2
        for oil in OILS
    )


def _creeping(of):
    """The largest values are those towards standstill, below the friction at rest of a worm that ran."""
    limits = [
        of.base_friction(oil, 1e-9 + 0.05, way, family)
        for family, way, oil in product(FAMILIES, WAYS, OILS)
    ]
    caps = [row[-1] for row in (*of._FRICTION.values(), *of._FRICTION_OF_IRON.values())]
    bronze = [of.base_friction(oil, 0.05) for oil in OILS]
    return (
        max(limits) <= 0.105
        and within_factor(max(caps), min(caps), 1.08)
        and within_factor(max(bronze), min(bronze), 1.08)
    )


def _like_agma(of):
    return all(
        within_factor(of.base_friction("mineral", v, way), agma_friction(v), 1.35)
        for way in WAYS
        for v in (0.3, 0.5, 1.0, 1.5, 2.0)
    )


def _iron_above_bronze(of):
    """Iron rubs more than bronze by 1.1 to 2 at 0.5 to 5 m/s, and PAG on it as much less as on bronze."""
    for speed in (0.5, 1.0, 2.0, 5.0):
        bronze, iron = _of_oils(of, speed), _of_oils(of, speed, family="cast iron")
        if not all(1.1 < a / b < 2 for a, b in zip(iron, bronze, strict=True)):
            return False
        if not within_factor(iron[2] / iron[0], bronze[2] / bronze[0], 1.1):
            return False
    return True


def _alike_on_iron(of):
    """On iron PAO rubs as mineral oil, and PAG's share of speed is mineral oil's within a fifth."""
    for speed in (0.1, 0.3, 1.0, 3.0):
        mineral, pao, pag = _of_oils(of, speed, family="cast iron")
        ends = _of_oils(of, 25, family="cast iron")
        if mineral != pao or not within_factor(mineral - ends[0], pag - ends[2], 1.2):
            return False
    return True


def _halving(of):
    """From 1 to 10 m/s friction above its value at high speed falls like 1/v to 1/v^2."""
    for family, way, oil in product(("tin bronze", "cast iron"), WAYS, OILS):
        far, slow, fast = (of.base_friction(oil, v, way, family) for v in (25, 0.5, 1.0))
        if not 1.3 < (slow - far) / (fast - far) < 3:
            return False
    return True


# --------------------------------------------------------------------------------------- wear


def _wear(of, oil, parameter, way="injection", family="tin bronze"):
    return of.base_wear(oil, parameter, way, family)


def _polyglycol_wears_as_pao(of):
    ratios = [_wear(of, "PAG", 0.5, way) / _wear(of, "PAO", 0.5, way) for way in WAYS]
    slopes = [of.wear_exponent("PAG", way) / of.wear_exponent("PAO", way) for way in WAYS]
    return within_factor(*ratios, 1.01) and all(within_factor(slope, 1, 1.001) for slope in slopes)


def _bath_wears_as_injection(of):
    """Both ways have the same wear within a factor of three where films are usual, 0.1 to 1 um."""
    ratios = [
        _wear(of, oil, film, "bath") / _wear(of, oil, film)
        for oil in OILS
        for film in (0.1, 0.3, 1.0)
    ]
    return 0.7 < min(ratios) and max(ratios) < 3


def _bath_is_flatter(of):
    gains = [of.wear_exponent(oil, "bath") / of.wear_exponent(oil, "injection") for oil in OILS]
    return within_factor(max(gains), min(gains), 1.03) and max(gains) < 1


def _bound_is_boundary(of):
    """Wear is bounded where the film is as thin as the finest run-in flanks are rough, 0.03 to 0.11 um."""
    rows = {**of._WEAR, **of._WEAR_OF}
    ends = [(most / factor) ** (1 / slope) for factor, slope, most in rows.values() if most]
    of_bronze = [(most / f) ** (1 / s) for f, s, most in of._WEAR.values() if most]
    return (
        min(ends) > 0.03 and max(ends) < 0.11 and within_factor(max(of_bronze), min(of_bronze), 1.2)
    )


def _oils_in_order(of):
    """At one film, with W_S of their viscosities at 80 degC, mineral wears most and PAG least, within ten."""
    for way, film in product(WAYS, (0.2, 0.4)):
        factors = (1.0, 0.037**-0.35, 0.054**-0.35)
        worn = [_wear(of, oil, film * f, way) for oil, f in zip(OILS, factors, strict=True)]
        if not (falls(worn) and worn[0] < 10 * worn[2]):
            return False
    return True


def _families_in_order(of):
    """With mineral oil at 0.3 um iron wears most, then aluminium bronze, then tin bronze."""
    worn = [_wear(of, "mineral", 0.3, family=family) for family in FAMILIES]
    others = [_wear(of, oil, 1.0, family="cast iron") for oil in OILS]
    return (
        falls(reversed(worn))
        and all(b < 10 * a for a, b in pairwise(worn))
        and within_factor(max(others), min(others), 3.5)
        and within_factor(
            _wear(of, "PAG", 1.0, family="aluminium bronze"), _wear(of, "PAG", 1.0), 4
        )
        and _wear(of, "PAO", 0.3, family="aluminium bronze") == worn[1]
    )


def _slopes(of):
    """Films that double wear less: by 2 to 13, as shares of asperities do (Archard)."""
    return all(1.1 < -slope < 3.75 for _, slope, _ in (*of._WEAR.values(), *of._WEAR_OF.values()))


# ---------------------------------------------------------------------------------- materials


def _strengths_in_proportion(of):
    ratios = [m.root_strength / m.pitting_strength for m in of.WHEEL_MATERIALS.values()]
    return 0.19 < min(ratios) and max(ratios) < 0.24


def _strains_in_proportion(of):
    strains = [m.pitting_strength / MODULI[name] for name, m in of.WHEEL_MATERIALS.items()]
    bronze, iron = strains[:4], strains[4:]
    return within_factor(max(bronze), min(bronze), 1.3) and within_factor(max(iron), min(iron), 1.1)


def _roots_by_tensile_strength(of):
    shares = [m.root_strength / TENSILE[name] for name, m in of.WHEEL_MATERIALS.items()]
    return 0.19 < min(shares) and max(shares) < 0.34


def _factors_are_near_one(of):
    wheels = list(of.WHEEL_MATERIALS.values())
    frictions = [wheel.friction_factor for wheel in wheels]
    return 0.9 < min(frictions) and max(frictions) < 1.15


def _wear_factors(of):
    """The best cast wears least, mineral oil and PAO alike, PAG up to twice; continuous casting 4 times."""
    for wheel in of.WHEEL_MATERIALS.values():
        mineral, pao, pag = (wheel.wear_factors[oil] for oil in OILS)
        if not (mineral == pao and 1 <= pag / mineral < 1.8 and 1 <= mineral < 4.5):
            return False
    centrifugal = of.WHEEL_MATERIALS["CuSn12Ni2-C-GZ"].wear_factors
    continuous = of.WHEEL_MATERIALS["CuSn12Ni2-C-GC"].wear_factors
    plain = of.WHEEL_MATERIALS["CuSn12-C-GZ"].wear_factors
    return all(
        1.2 < plain[oil] / centrifugal[oil] < 1.7 and 2 < continuous[oil] / centrifugal[oil] < 4.2
        for oil in OILS
    )


def _results(of):
    """Friction at usual speeds, wear at usual films."""
    return [
        value
        for family, way, oil in product(FAMILIES, WAYS, OILS)
        for value in (
            *(of.base_friction(oil, v, way, family) for v in (0.1, 0.3, 1.0, 3.0, 10.0)),
            *(_wear(of, oil, film, way, family) for film in (0.03, 0.3, 1.0)),
        )
    ]


CURVES = Chapter(
    "Base friction and base wear of worm gears",
    ModuleNumbers("pyworm.formulas.worm_curves"),
    "[DIN 3996:2012](bibliography.md#din-3996), base curves of the reference gear",
    {
        "SLIDING_RANGE": Clause("sliding speeds between which the curves are used, m/s", OURS),
        "_FRICTION": Clause("mu_0T = a + b/(vg + c)^d of bronzes, its largest value", TRANSCRIBED),
        "_FRICTION_OF_IRON": Clause("the same of cast iron", TRANSCRIBED),
        "_MOST_WEAR": Clause("largest J_0T", TRANSCRIBED),
        "_WEAR": Clause("J_0T = factor K_W^exponent of tin bronze", TRANSCRIBED),
        "_WEAR_OF": Clause("the same of aluminium bronze and cast iron", TRANSCRIBED),
    },
    (
        Check("friction falls with speed", lambda of: all(falls(c[-1]) for c in _curves(of))),
        Check(
            "mineral above PAO above PAG from 0.3 m/s on, either way of lubrication",
            lambda of: all(
                falls(_of_oils(of, v, way)) for way in WAYS for v in (0.3, 1, 3, 10, 25)
            ),
        ),
        Check("bath over injection at 1 m/s is 0.7 to 0.8 of every oil", _bath_over_injection),
        Check(
            "bath is below injection at 0.5 m/s and up to 1.2 times it at 25 m/s",
            _bath_crosses_once,
        ),
        Check("towards standstill all largest values agree within 8 %", _creeping),
        Check("mineral oil's friction is AGMA 6034's within 1.35 from 0.3 to 2 m/s", _like_agma),
        Check("iron over bronze is 1.1 to 2, PAG's gain on both alike", _iron_above_bronze),
        Check("on iron PAO rubs as mineral oil, PAG falls as these", _alike_on_iron),
        Check("halving the speed at 1 m/s multiplies what falls by 1.3 to 3", _halving),
        Check("PAG wears the same part of PAO either way", _polyglycol_wears_as_pao),
        Check("bath wears 0.7 to 3 times as injection from 0.1 to 1 um", _bath_wears_as_injection),
        Check("the bath's exponent is the same part of the injection's", _bath_is_flatter),
        Check("largest wear at films of 0.03 to 0.11 um", _bound_is_boundary),
        Check("mineral oil wears more than PAO, PAO than PAG, at one film", _oils_in_order),
        Check("iron wears most, tin bronze least, at one film", _families_in_order),
        Check("exponents from 1.1 to 3.75", _slopes),
    ),
    _results,
)

MATERIALS = Chapter(
    "Wheel materials",
    ModuleNumbers("pyworm.formulas.worm_wheel_material"),
    "[DIN 3996:2012](bibliography.md#din-3996), table of wheel materials",
    {
        "WHEEL_MATERIALS": Clause(
            "Y_W; W_ML of mineral oil, PAO, PAG; sigma_HlimT, tau_FlimT in Pa", TRANSCRIBED
        )
    },
    (
        Check("tau_FlimT is 0.19 to 0.24 of sigma_HlimT", _strengths_in_proportion),
        Check("sigma_HlimT over the reduced modulus agrees in a family", _strains_in_proportion),
        Check(
            "tau_FlimT is 0.19 to 0.34 of the tensile strength of EN 1982, 1561, 1563",
            _roots_by_tensile_strength,
        ),
        Check("Y_W from 0.9 to 1.15", _factors_are_near_one),
        Check("W_ML: castings in order, PAG below 1.8 times mineral", _wear_factors),
    ),
    lambda of: [of.WHEEL_MATERIALS["CuSn12-C-GZ"].pitting_strength],
)

CHAPTERS = (CURVES, MATERIALS)
