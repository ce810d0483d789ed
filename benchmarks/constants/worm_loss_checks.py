"""Losses and sump temperatures of worm gearboxes against heat balances, neighbours and another standard."""

from dataclasses import replace
from itertools import pairwise, product
from math import pi

from chapter import TRANSCRIBED, Chapter, Clause, falls, rises, within_factor
from constant_slips import Check, ModuleNumbers

from pyworm.formulas.worm_gear import REFERENCE_GEAR, WormGear
from pyworm.formulas.worm_standard import teeth_loss

RPM = pi / 30
ROOM = 293.15
GRADES = (46, 220, 680)
SPEEDS = (60, 150, 500, 1500, 3000)
SIZES = (50, 80, 100, 200, 500)


def gear_of(size: float, starts: int = 2) -> WormGear:
    """The reference gear in another size [mm], or with one start and 40 teeth."""
    teeth = 41 if starts == 2 else 40
    module = 2e-3 * size / (9 + teeth)
    return replace(
        REFERENCE_GEAR,
        centre_distance=1e-3 * size,
        module=module,
        starts=starts,
        teeth=teeth,
        face_width=0.3e-3 * size,
    )


def rise(of, size=100, speed=1500, torque=300.0, grade=220.0, fan=False, oil="PAG", starts=2):
    """The sump above the room [K]."""
    gear = gear_of(size, starts)
    return of.sump_temperature(gear, speed * RPM, torque, oil, grade * 1e-6, ROOM, fan) - ROOM


def _fan_cools(of):
    return all(
        rise(of, size, speed, 300 * (size / 100) ** 3, grade, True)
        <= rise(of, size, speed, 300 * (size / 100) ** 3, grade) + 1e-9
        for size, speed, grade in product(SIZES, SPEEDS, GRADES)
    )


def _fan_cools_by_speed(of):
    """A fan takes a tenth to half of the rise at 1500 rpm, and more of it the faster it turns."""
    gains = [
        rise(of, speed=n, fan=True, torque=600.0) / rise(of, speed=n, torque=600.0) for n in SPEEDS
    ]
    fine = all(
        0.4
        < rise(of, size, 1500, 300 * (size / 100) ** 3, fan=True)
        / rise(of, size, 1500, 300 * (size / 100) ** 3)
        < 0.9
        for size in (63, 100, 200, 315)
    )
    return fine and gains[-1] < gains[0] and within_factor(gains[0], 1.0, 1.15)


def _formulas_meet_when_slow(of):
    """At 60 rpm the fan does next to nothing: both regressions agree within 1.4, each as it stands."""
    for size, grade in product((63, 100, 200, 400), (100, 220, 460)):
        gear, torque = gear_of(size), 300 * (size / 100) ** 3
        with_fan = of._rise_with_fan(gear, 1.0, torque, grade / 100)
        if not within_factor(with_fan, of._rise_without_fan(gear, 1.0, torque, grade / 100), 1.4):
            return False
    return True


def _rises_with_speed_and_torque(of):
    return all(
        rises(rise(of, speed=n, fan=fan) for n in SPEEDS)
        and rises(rise(of, torque=t, fan=fan) for t in (1, 50, 100, 200, 400))
        for fan in (False, True)
    )


def _no_notch_in_viscosity(of):
    """From grade to grade, and between them, the rise changes smoothly: without a fan by 3 % at most."""
    thick = [22 * 1.12**step for step in range(28)] + [218, 219, 220, 220.3, 221, 222]
    thick.sort()
    without = [rise(of, torque=t, grade=nu) for t in (1.0,) for nu in thick]
    with_fan = [rise(of, torque=1.0, grade=nu, fan=True) for nu in thick]
    steps = [b / a for a, b in pairwise(without)]
    return (
        all(0.99 < step < 1.04 for step in steps)
        and within_factor(max(without), min(without), 1.06)
        and rises(with_fan)
        and 2.5 < with_fan[-1] / with_fan[0] < 6
    )


def _loaded_part(of, grade, fan, size=100, starts=2):
    full, idle = (rise(of, size, 1500, t, grade, fan, starts=starts) for t in (300.0, 1e-6))
    return full - idle


def _thick_oil_under_load(of):
    """The part of the load hardly knows the oil without a fan, and falls with its viscosity with one."""
    without = [_loaded_part(of, nu, False) for nu in (32, 100, 220, 460)]
    with_fan = [_loaded_part(of, nu, True) for nu in (32, 100, 220, 460)]
    return (
        within_factor(max(without), min(without), 1.04)
        and falls(with_fan)
        and within_factor(with_fan[0], with_fan[-1], 1.8)
        and all(within_factor(a, b, 1.6) for a, b in zip(without, with_fan, strict=True))
    )


def _ratio_under_load(of):
    """At one output torque the loss is that of the output's power, as 1/u."""
    return all(
        1.05 < _loaded_part(of, 220, fan) / _loaded_part(of, 220, fan, starts=1) < 1.5
        for fan in (False, True)
    )


def _size_under_load(of):
    """At one torque over size cubed the loss grows as volume and the surface as area."""
    for fan in (False, True):
        rows = [rise(of, a, 1500, 300 * (a / 100) ** 3, fan=fan) for a in (63, 125, 250, 500)]
        steps = [b / a for a, b in pairwise(rows)]
        if not all(1.2 < step < 2 for step in steps):
            return False
        part = [_loaded_part(of, 220, fan, a) * (a / 100) ** 3 for a in (80, 160, 320)]
        if not all(1.1 < b / a < 1.6 for a, b in pairwise(part)):
            return False
    return True


def _speed_exponents(of):
    """Idle losses grow as n^(4/3) and the heat goes off the faster the worm stirs."""
    for fan, (low, high) in product((False, True), ((150, 300), (1500, 3000))):
        gained = rise(of, speed=high, torque=1e-6, fan=fan) / rise(
            of, speed=low, torque=1e-6, fan=fan
        )
        if not 2**0.45 < gained < 2**0.85:
            return False
        loaded = [
            rise(of, speed=n, torque=300.0, fan=fan) - rise(of, speed=n, torque=1e-6, fan=fan)
            for n in (low, high)
        ]
        if not 2**0.05 < loaded[1] / loaded[0] < 2**0.5:
            return False
    return True


def _heat_goes_off(of):
    """The gearbox's own losses over rise and usual surface, 9e-5 a^1.85 m2, are 8 to 60 W/(m2 K)."""
    for size, speed, fan in product((80, 100, 200), (500, 1500, 3000), (False, True)):
        gear, torque = gear_of(size), 300 * (size / 100) ** 3
        teeth = teeth_loss(gear, "PAG", speed * RPM, torque, 0.5e-6, lubrication="bath").power
        lost = teeth + of.other_losses(gear, speed * RPM, torque).power
        surface = 9e-5 * size**1.85
        warm = rise(of, size, speed, torque, fan=fan)
        if not 8 < lost / (warm * surface) < 60:
            return False
    return True


def _idle_heat(of):
    """Churning and seals alone make up the rise without load by 2 to 60 W/(m2 K)."""
    for size, speed, fan in product((80, 100, 200), (500, 1500, 3000), (False, True)):
        lost = of.other_losses(gear_of(size), speed * RPM, 1e-6)
        surface = 9e-5 * size**1.85
        if (
            not 2
            < (lost.churning + lost.seals) / (rise(of, size, speed, 1e-6, fan=fan) * surface)
            < 60
        ):
            return False
    return True


def _seals_as_iso(of):
    """Seals by ISO/TR 14179-2 lose 7.69e-6 d^2 n each: within 1.7, of two."""
    lost = of.other_losses(REFERENCE_GEAR, 1500 * RPM, 300).seals
    return within_factor(lost, 2 * 7.69e-6 * 36**2 * 1500, 1.7)


def _bearings(of):
    """Bearings lose 0.5 to 4 % of the output; adjusted pairs two to three times fixed and floating ones."""
    for size in (63, 100, 200, 400):
        gear, torque = gear_of(size), 300 * (size / 100) ** 3
        out = torque * 1500 * RPM / gear.ratio
        a, b = (
            of.other_losses(gear, 1500 * RPM, torque, how).bearings / out for how in of.BEARINGS
        )
        if not (0.005 < b < a < 0.04 and 2 < a / b < 3):
            return False
    small, large = (
        of.other_losses(gear_of(a), 1500 * RPM, 300 * (a / 100) ** 3).bearings / a**3
        for a in (63, 400)
    )
    return 2 < small / large < 4


def _churning(of):
    """Churning without load is 3 to 10 % of the reference gear's output, and a third of its cube of speed."""
    lost = [of.other_losses(REFERENCE_GEAR, n * RPM, 300).churning for n in (750, 1500, 3000)]
    out = 300 * 1500 * RPM / 20.5
    grown = [b / a for a, b in pairwise(lost)]
    return 0.03 < lost[1] / out < 0.1 and all(2**1.2 < step < 2**1.5 for step in grown)


def _oils_warm_in_order(of):
    """Sumps warm with mineral oil, PAO and PAG in the ratio of their losses, within 12 %."""
    speed, torque = 1500, 300.0
    lost = {
        oil: teeth_loss(REFERENCE_GEAR, oil, speed * RPM, torque, 0.5e-6, lubrication="bath").power
        + of.other_losses(REFERENCE_GEAR, speed * RPM, torque).power
        for oil in ("mineral", "PAO", "PAG")
    }
    factors = {oil: of.oil_factor(oil, 20.5, speed * RPM) for oil in lost}
    if not factors["mineral"] > factors["PAO"] > factors["PAG"] == 1:
        return False
    if not 1.5 < (factors["mineral"] - 1) / (factors["PAO"] - 1) < 2.2:
        return False
    others = [
        of.oil_factor("mineral", u, n * RPM) - 1 for u in (10, 20, 50) for n in (60, 300, 3000)
    ]
    return (
        all(within_factor(factors[oil], lost[oil] / lost["PAG"], 1.12) for oil in factors)
        and 0.06 < min(others)
        and max(others) < 0.25
    )


def _results(of):
    """Rises and losses of usual gearboxes."""
    rises_ = [
        rise(of, size, speed, 300 * (size / 100) ** 3, grade, fan, oil, starts)
        for size, speed, grade, oil, starts in (
            (63, 1500, 150, "mineral", 2),
            (100, 60, 220, "PAO", 1),
            (100, 1500, 460, "mineral", 1),
            (250, 500, 320, "PAG", 2),
        )
        for fan in (False, True)
    ]
    lost = of.other_losses(REFERENCE_GEAR, 1000 * RPM, 300)
    return [*rises_, lost.churning, lost.bearings, lost.seals]


LOSSES = Chapter(
    "Other power losses, sump temperature",
    ModuleNumbers("pyworm.formulas.worm_losses"),
    "[DIN 3996:2012](bibliography.md#din-3996), "
    "[ISO/TS 14521](bibliography.md#iso-ts-14521), losses and oil sump temperature",
    {
        "REFERENCE_SIZE": Clause("centre distance in (a/63)^3, mm", TRANSCRIBED),
        "_BEARING_LOSS": Clause("P_VLP = factor P2 a^0.44 u/d_m2", TRANSCRIBED),
        "other_losses": Clause(
            "exponent of P_VLP; P_V0 = 8.9e-5 a n1^(4/3); P_VD = 1.178e-5 d_m1^2 n1", TRANSCRIBED
        ),
        "oil_factor": Clause("c2 of mineral oil and PAO; its sign is ours", TRANSCRIBED),
        "_rise_without_fan": Clause("c0 and c1 without a fan", TRANSCRIBED),
        "_rise_with_fan": Clause("c0 and c1 with a fan", TRANSCRIBED),
    },
    (
        Check("a fan never warms the sump", _fan_cools),
        Check(
            "a fan cools by 0.4 to 0.9 at 1500 rpm, and the more the faster", _fan_cools_by_speed
        ),
        Check("at 60 rpm both regressions agree within 1.4", _formulas_meet_when_slow),
        Check("the rise grows with speed and torque", _rises_with_speed_and_torque),
        Check("the rise without load is smooth in viscosity", _no_notch_in_viscosity),
        Check("viscosity hardly changes the part of the load", _thick_oil_under_load),
        Check("half the ratio at one torque warms 1.05 to 1.5 times", _ratio_under_load),
        Check("at one stress the rise grows slower than the size", _size_under_load),
        Check("rises grow as n^0.45 to n^0.85 without load", _speed_exponents),
        Check("losses over rise and surface are 8 to 60 W/(m2 K)", _heat_goes_off),
        Check("the same without load, 2 to 60 W/(m2 K)", _idle_heat),
        Check("seals within 1.7 of ISO/TR 14179-2", _seals_as_iso),
        Check("bearings lose 0.5 to 4 % of the output", _bearings),
        Check("churning is 3 to 10 % of the output at 1500 rpm", _churning),
        Check("oils warm the sump in the order of their losses", _oils_warm_in_order),
    ),
    _results,
)

CHAPTERS = (LOSSES,)
