"""Life of rolling bearings against joints, limits and the theory behind its exponents."""

from itertools import pairwise
from math import pi, radians

from chapter import MEMORY, READ, Chapter, Clause, within_factor
from constant_slips import Check, ModuleNumbers

RPM = pi / 30
KINDS = ("ball", "roller")


def _joints(of):
    """a_ISO has no step where its rows meet, at kappa 0.4 and 1."""
    return all(
        within_factor(
            of.life_modification(joint * 0.999999, x, kind),
            of.life_modification(joint * 1.000001, x, kind),
            1.004,
        )
        for kind in KINDS
        for joint in (0.4, 1.0)
        for x in (0.05, 0.3, 1.0)
    )


def _without_film(of):
    """At kappa 0.1 no film is left: a_ISO is 0.1 whatever the load."""
    return all(
        within_factor(of.life_modification(0.1, x, kind), 0.1, 1.02)
        for kind in KINDS
        for x in (0.05, 0.3, 1.0)
    )


def _balls_as_rollers(of):
    """Balls and rollers have k1 in one proportion to their constant, and the same k2."""
    ends = [
        [1 - (0.1 / of.life_modification(kappa, x, kind)) ** power for kappa in (0.2, 0.6, 2.0)]
        for kind, x, power in (("ball", 0.3, 1 / 9.3), ("roller", 0.3, 1 / 9.185))
    ]
    ball, roller = ends
    shares = [
        (a / ball[2]) ** (1 / 0.83) - b / roller[2] for a, b in zip(ball, roller, strict=True)
    ]
    return max(map(abs, shares)) < 2e-3


def _exponents_of_theory(of):
    """-c/e and w of Ioannides and Harris: c = 31/3, e = 10/9 of points, 9/8 of lines; w = 1/3 and 2/5."""
    for kind, e, w in (("ball", 10 / 9, 1 / 3), ("roller", 9 / 8, 0.4)):
        values = [of.life_modification(1.0, x, kind) for x in (0.1, 0.2)]
        power = -(31 / 3) / e
        ends = [1 - (value / 0.1) ** (1 / power) for value in values]
        if not within_factor(ends[1] / ends[0], 2**w, 1.001):
            return False
    return True


def _bound(of):
    """Life is bounded where a load comes near the limit of fatigue: from C_u/0.1 to C_u/1.2."""
    for kind, low, high in (("ball", 0.1, 0.6), ("roller", 0.5, 1.5)):
        if not of.life_modification(4, low, kind) < of.life_modification(4, high, kind):
            return False
        if of.life_modification(4, high, kind) != of.life_modification(4, 20, kind):
            return False
    most = of.life_modification(4, 20, "ball")
    return 40 < most < 60 and of.life_modification(10, 0.1, "ball") == of.life_modification(
        4.05, 0.1, "ball"
    ) > of.life_modification(3.9, 0.1, "ball")


def _helped_to_three(of):
    helped = of.life_modification(0.3, 2.0, "ball", additives=True, contamination=0.5)
    return 2.9 < helped < 3.1 and of.life_modification(
        0.3, 0.3, "ball", additives=True, contamination=0.18
    ) < of.life_modification(0.3, 0.3, "ball", additives=True, contamination=0.22)


def _thrust(of):
    """Thrust bearings bear two to four times less of their limit than radial ones."""
    factors = [of._THRUST_FACTOR[kind] for kind in KINDS]
    values = [of.life_modification(1, 0.2, kind, "thrust") for kind in KINDS]
    alike = [of.life_modification(1, 0.2 / f, kind) for kind, f in zip(KINDS, factors, strict=True)]
    return values == alike and 4 > factors[0] > factors[1] > 2


def _reference_viscosity(of):
    """Both forms meet at 1000 rpm within 2.5 %, and want 14 mm2/s of 100 mm at 1000 rpm."""
    slow, fast = (of.reference_viscosity(n * RPM, 0.1) for n in (999.99, 1000.01))
    large = [of.reference_viscosity(n * RPM, 0.4) for n in (100, 3000)]
    small = [of.reference_viscosity(n * RPM, 0.1) for n in (100, 3000)]
    halves = all(within_factor(a / b, 2, 1.001) for a, b in zip(small, large, strict=True))
    rate = of.reference_viscosity(3000 * RPM, 0.1) / of.reference_viscosity(12000 * RPM, 0.1)
    return (
        within_factor(slow, fast, 1.025)
        and within_factor(fast, 14e-6, 1.05)
        and halves
        and (within_factor(rate, 2, 1.001))
        and 1.7
        < of.reference_viscosity(100 * RPM, 0.1) / of.reference_viscosity(200 * RPM, 0.1)
        < 1.85
    )


def _limit_of_fatigue(of):
    """C_u over C0 is (1500/4200)^3 of points and (1500/4200)^2 of lines, in MPa; large balls bear less."""
    ball = of.fatigue_load_limit(1e5, "ball", 0.08) / 1e5
    roller = of.fatigue_load_limit(1e5, "roller", 0.08) / 1e5
    large = of.fatigue_load_limit(1e5, "ball", 0.4) / 1e5
    return (
        within_factor(ball, (1500 / 4200) ** 3, 1.03)
        and within_factor(roller, (1500 / 4200) ** 2, 1.06)
        and within_factor(ball / large, 2, 1.01)
    )


def _life_exponents(of):
    """Life falls with the load to the third power for points and 10/3 for rollers."""
    points, lines = (
        of.basic_life(1e4, 1e3, kind) / of.basic_life(1e4, 2e3, kind) for kind in KINDS
    )
    return within_factor(points, 8, 1.001) and within_factor(lines, 2 ** (10 / 3), 1.001)


def _reliability(of):
    """The standard's table of a1, 0.64, 0.55, 0.47, 0.37 and 0.25 at 95 to 99 %, and 1 at 90 %."""
    table = {0.9: 1.0, 0.95: 0.64, 0.96: 0.55, 0.97: 0.47, 0.98: 0.37, 0.99: 0.25}
    return all(abs(of.reliability_factor(r) - a1) < 0.0055 for r, a1 in table.items())


def _hours(of):
    rated = of.BearingRating(
        elements="ball", dynamic_rating=1e4, fatigue_load_limit=300, load=1e3, speed=1000 * RPM,
        mean_diameter=0.05, viscosity=2e-5, contamination=0.5,
    )  # fmt: skip
    return within_factor(rated.basic_hours * 60 * 1000, rated.basic_life, 1.001)


def _classes(of):
    """From class to class c falls by 0.3 to 0.78 and b grows by 1.38 to 1.8, and the cleanest have one c."""
    tables = [list(rows.values()) for rows in of._CLEANLINESS.values()]
    for rows in tables:
        for (c1, b1), (c2, b2) in pairwise(rows):
            if not (0.3 < c2 / c1 < 0.78 and 1.38 < b2 / b1 < 1.8):
                return False
    first = [rows[0] for rows in tables]
    return (
        len({c for c, _ in first}) == 1
        and first[1] == first[2]
        and (tables[1][1][1] == tables[2][1][1] and 1.1 < first[1][1] / first[0][1] < 1.3)
    )


def _dirt_by_words(of):
    """At kappa 1 and 80 mm the cleanest class is the words' "high", the dirtiest "very severe"."""
    high = of.contamination_range("high cleanliness", 0.08)
    for way in ("oil bath", "grease"):
        found = [of.contamination_factor(way, code, 1.0, 0.08) for code in of._CLEANLINESS[way]]
        if not (high[0] < found[0] < high[1] * 1.1 and 0.2 < found[1] < 0.4):
            return False
        if not (0.05 < found[2] < 0.15 and found[3] < 0.1 and found[4] < 0.02):
            return False
    return True


def _dirt_grows(of):
    """Thicker films and larger bearings bear more dirt."""
    base = of.contamination_factor("oil bath", "-/15/12", 0.5, 0.06)
    film = of.contamination_factor("oil bath", "-/15/12", 1.0, 0.06) / base
    size = of.contamination_factor("oil bath", "-/15/12", 0.2, 0.24) / (
        of.contamination_factor("oil bath", "-/15/12", 0.2, 0.06)
    )
    large, small = (of.contamination_factor("grease", "slight", 0.3, d) for d in (0.5, 0.4999))
    return 1.5 < film < 1.7 and 2.2 < size < 3.2 and 1.0 < large / small < 1.05


def _words_in_order(of):
    """Ranges of the words descend, each meeting the next, and larger bearings bear at least as much."""
    rows = list(of.CONTAMINATION.values())
    for small, large in rows:
        if not (0 <= small[0] <= small[1] <= 1 and small[0] <= large[0] <= large[1] <= 1):
            return False
    for size in (0, 1):
        for above, below in pairwise(rows):
            if (
                not below[size][1] <= above[size][0]
                or above[size][0] > below[size][1] * 1.34 + 0.2001
            ):
                return False
    exact = [[below[0][1] == above[0][0] for above, below in pairwise(rows[2:6])]]
    return all(map(all, exact)) and of.contamination_range("normal cleanliness", 0.099) != (
        of.contamination_range("normal cleanliness", 0.101)
    )


BEARINGS = Chapter(
    "Rolling bearing life",
    ModuleNumbers("pyworm.formulas.bearing_life"),
    "[ISO 281:2007](bibliography.md#iso-281)",
    {
        "LARGEST_MODIFICATION": Clause("largest a_ISO", READ),
        "LARGEST_WITH_ADDITIVES": Clause("largest a_ISO by additives", MEMORY),
        "DIRTIEST_WITH_ADDITIVES": Clause("e_C from which additives count", MEMORY),
        "SMALLEST_RATIO, LARGEST_RATIO": Clause("kappa between which a_ISO holds", READ),
        "_LIFE_EXPONENT": Clause("p of L10", READ),
        "_MODIFICATION": Clause("eqs 31 to 42: joints, k1, k2", READ),
        "_THRUST_FACTOR": Clause("divisor of e_C C_u/P of thrust bearings", MEMORY),
        "_CLEANLINESS": Clause("annex A: c, b", READ),
        "_LARGE_SLIGHT_GREASE": Clause("annex A: b from 500 mm on", READ),
        "CONTAMINATION": Clause("table 13: e_C below and from 100 mm", READ),
        "reference_viscosity": Clause("eqs 27, 28: nu1", READ),
        "contamination_factor": Clause("annex A: kappa^0.68 D^0.55, D^(1/3), 500 mm", MEMORY),
        "fatigue_load_limit": Clause("B.3.3: C0/8.2, C0/22, (100/D)^0.5", READ),
        "_modification": Clause("eqs 31 to 42: constants and exponents", READ),
        "reliability_factor": Clause("Weibull law of a1", MEMORY),
        "BearingRating._hours": Clause("seconds in an hour", READ),
    },
    (
        Check("no step of a_ISO at kappa 0.4 and 1", _joints),
        Check("a_ISO is 0.1 at kappa 0.1, whatever the load", _without_film),
        Check("k1 over its constant and k2 are those of the other kind", _balls_as_rollers),
        Check(
            "exponents are 31/3 over 10/9 and 9/8, 1/3 and 2/5 (Ioannides and Harris)",
            _exponents_of_theory,
        ),
        Check("lives are bounded at loads near the limit of fatigue, at 40 to 60", _bound),
        Check("additives help to a_ISO of 3 where it is clean", _helped_to_three),
        Check("thrust bearings bear two to four times less", _thrust),
        Check("nu1 without a step at 1000 rpm, 14 mm2/s of 100 mm there", _reference_viscosity),
        Check("C_u is C0 at 1500 instead of 4200 MPa", _limit_of_fatigue),
        Check("life exponents 3 and 10/3", _life_exponents),
        Check("a1 by the standard's table", _reliability),
        Check("hours are revolutions over speed", _hours),
        Check("classes of cleanliness in geometric steps", _classes),
        Check("classes agree with the words of table 13", _dirt_by_words),
        Check("thick films and large bearings bear dirt", _dirt_grows),
        Check("words in order, range meets range", _words_in_order),
    ),
    lambda of: [
        *(of.life_modification(k, 0.3, e) for k in (0.2, 0.6, 2.0) for e in KINDS),
        of.contamination_factor("grease", "slight", 0.3, 0.6),
        of.contamination_factor("oil bath", "-/17/14", 1.0, 0.1),
        of.reference_viscosity(600 * RPM, 0.07),
    ],
)


def _no_step(of):
    """The equivalent load has no step where the thrust begins to count: X + e Y = 1."""
    balls = [(0.0, thrust) for thrust in of._DEEP_GROOVE] + [
        (radians(angle), 1.0) for angle in of._ANGULAR_CONTACT
    ]
    found = [of.load_factors("ball", angle, thrust, 1.0) for angle, thrust in balls]
    found += [of.load_factors("roller", radians(angle), 1.0, None) for angle in (10, 25, 40)]
    return all(abs(f.radial + f.limit * f.thrust - 1) < 0.02 for f in found)


def _steeper_bears_more(of):
    """Larger contact angles, and thrusts of deep grooves, bear more thrust before it counts."""
    angles = [of.load_factors("ball", radians(a), 1.0, None).limit for a in of._ANGULAR_CONTACT]
    thrusts = [of.load_factors("ball", 0.0, t, 1.0).limit for t in of._DEEP_GROOVE]
    return all(more > less for each in (angles, thrusts) for less, more in pairwise(each))


def _as_printed(of):
    """X 0.56, and Y 1.31 and 1.15 at relative thrusts of 0.17 and 0.28, as a public lesson has them."""
    rows = [of.load_factors("ball", 0.0, thrust, 1.0) for thrust in (0.17, 0.28)]
    return [(f.radial, f.thrust) for f in rows] == [(0.56, 1.31), (0.56, 1.15)]


LOADS = Chapter(
    "Equivalent load of rolling bearings",
    ModuleNumbers("pyworm.formulas.bearing_load"),
    "[ISO 281:2007](bibliography.md#iso-281)",
    {
        "_DEEP_GROOVE": Clause("table of X and Y: F_a/C0, e, Y", MEMORY),
        "_DEEP_GROOVE_RADIAL": Clause("table of X and Y: X", MEMORY),
        "_ANGULAR_CONTACT": Clause("table of X and Y: alpha, e, X, Y", MEMORY),
        "_ROLLER_LIMIT, _ROLLER_RADIAL, _ROLLER_THRUST": Clause("table of X and Y", MEMORY),
    },
    (
        Check("no step of the equivalent load where the thrust counts", _no_step),
        Check("steeper contacts bear more thrust", _steeper_bears_more),
        Check("factors of deep groove bearings as a lesson prints them", _as_printed),
    ),
    lambda of: [
        *(of.load_factors("ball", 0.0, thrust, 1.0).limit for thrust in of._DEEP_GROOVE),
        *(of.load_factors("ball", 0.0, thrust, 1.0).thrust for thrust in of._DEEP_GROOVE),
        *(of.load_factors("ball", radians(a), 1.0, None).thrust for a in of._ANGULAR_CONTACT),
    ],
)

CHAPTERS = (BEARINGS, LOADS)
