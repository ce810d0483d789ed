"""Oil laws, base stocks and rules of practice against tables, joints, other laws and measured oils."""

from itertools import pairwise, product
from math import exp, log, sqrt
from pathlib import Path

import numpy as np
from chapter import MEMORY, OURS, READ, Chapter, Clause, rises, within_factor
from constant_slips import Check, ModuleNumbers, TableNumbers

from pyworm.formulas.oil_properties import (
    agma_alpha,
    gold_alpha,
    viscosity_index,
    walther_viscosity,
)
from pyworm.formulas.unit_factors import DEGREES_40, DEGREES_100

OILS_TABLE = Path(__file__).parents[2] / "pyworm/materials/oils.toml"

INDEX_OILS = {
    2.0: (7.994, 6.394),
    5.0: (40.23, 28.49),
    10.0: (147.7, 82.87),
    15.0: (296.5, 149.7),
    70.0: (4905.0, 1558.0),
}
"""Viscosity at 100 degC -> L and H of the standard's own table (from memory)."""


def _limits(of, y):
    """L and H by the rows of a module."""
    _, *c = max(row for row in of._INDEX_OILS if row[0] <= y)
    return (c[0] * y + c[1]) * y + c[2], (c[3] * y + c[4]) * y + c[5]


def _index_joints(of):
    joints = [row[0] for row in of._INDEX_OILS[1:]]
    return len(set(joints)) == 15 and all(
        within_factor(a, b, 1.004)
        for joint in joints
        for a, b in zip(_limits(of, joint - 1e-9), _limits(of, joint + 1e-9), strict=True)
    )


def _index_table(of):
    return all(
        within_factor(a, b, 1.001)
        for y, row in INDEX_OILS.items()
        for a, b in zip(_limits(of, y), row, strict=True)
    )


def _index_is_smooth(of):
    """L and H grow with a power of the viscosity that itself changes smoothly, between 1.0 and 2.6."""
    for which in (0, 1):
        last = None
        for y in np.geomspace(2.05, 140, 90):
            a, b = (_limits(of, v)[which] for v in (y * 0.995, y * 1.005))
            slope = log(b / a) / log(1.005 / 0.995)
            if not 0.95 < slope < 2.6 or (last is not None and abs(slope - last) > 0.35):
                return False
            last = slope
    return True


def _index_examples(of):
    """The standard's two examples, 92 and 156; 100 where an oil is its reference."""
    found = [of.viscosity_index(u * 1e-6, y * 1e-6) for u, y in ((73.30, 8.86), (22.83, 5.05))]
    low, high = _limits(of, 10.0)
    ends = [of.viscosity_index(v * 1e-6, 1e-5) for v in (low, high, high * 0.999999)]
    return [round(v) for v in found] == [92, 156] and all(
        abs(a - b) < 0.05 for a, b in zip(ends, (0, 100, 100), strict=True)
    )


def _roelands_pole(of):
    """Roelands wrote 10^-4.2 Pa s and -135 degC."""
    return within_factor(exp(-of.ROELANDS_POLE_LOG), 10**-4.2, 1.01) and (
        abs(of.ROELANDS_POLE_TEMPERATURE - 138.15) < 0.2
    )


def _walther(of):
    """Through two viscosities and back, and D341's shift: 0.6 to 0.8 mm2/s of Walther's own 0.6 and 0.8."""
    m, n = of.walther_constants(220e-6, DEGREES_40, 19e-6, DEGREES_100)
    back = [of.walther_viscosity(m, n, t) for t in (DEGREES_40, DEGREES_100)]
    there = of.walther_temperature(m, n, 60e-6)
    middle = of.walther_viscosity(m, n, there)
    return (
        within_factor(back[0], 220e-6, 1.0001)
        and within_factor(back[1], 19e-6, 1.0001)
        and within_factor(middle, 60e-6, 1.0001)
        and 0.6 < of.WALTHER_SHIFT < 0.8
        and abs(of.viscosity_index(220e-6, of.viscosity_100_of_index(220e-6, 97)) - 97) < 0.01
    )


def _conduction(of):
    """Cragoe as it is usually printed, 0.117 (1 - 0.00054 t)/s, within 7 % from 20 to 100 degC."""
    return all(
        within_factor(of.conductivity(900, 273.15 + t), 0.117 * (1 - 0.00054 * t) / 0.9, 1.07)
        for t in (20, 60, 100)
    )


def _density(of):
    """The density at 15 degC is that at 15 degC, and 2.6 % less at 60."""
    return of.density(900, 5.8e-4, 288.15) == 900 and within_factor(
        of.density(900, 5.8e-4, 333.15) / 900, 0.974, 1.001
    )


LAWS = Chapter(
    "Oil laws at ambient pressure",
    ModuleNumbers(
        "pyworm.formulas.oil_properties",
        only=(
            "WALTHER_SHIFT", "ROELANDS_POLE_LOG, ROELANDS_POLE_TEMPERATURE", "_INDEX_OILS",
            "viscosity_index", "density", "conductivity",
        ),
    ),
    "[ASTM D341](bibliography.md#astm-d341), [ASTM D2270](bibliography.md#astm-d2270), "
    "[Roelands (1966)](bibliography.md#roelands-1966), "
    "[Cragoe (1929)](bibliography.md#cragoe-1929)",
    {
        "WALTHER_SHIFT": Clause("D341: shift, mm2/s", READ),
        "ROELANDS_POLE_LOG, ROELANDS_POLE_TEMPERATURE": Clause("pole of Roelands' law", READ),
        "_INDEX_OILS": Clause("D2270: joints, L and H", MEMORY),
        "viscosity_index": Clause("D2270: equations", MEMORY),
        "density": Clause("temperature of reference, degC", READ),
        "conductivity": Clause("Cragoe's constants in GEARpie", READ),
    },
    (
        Check("L and H meet at all joints within 0.4 %", _index_joints),
        Check("L and H of five rows of the standard's table within 0.1 %", _index_table),
        Check("L and H are smooth", _index_is_smooth),
        Check("the standard's examples, 92 and 156", _index_examples),
        Check("Roelands' pole is 10^-4.2 Pa s at -135 degC", _roelands_pole),
        Check("two viscosities give themselves back", _walther),
        Check("conductivity as usually printed within 7 %", _conduction),
        Check("density at 15 degC", _density),
    ),
    lambda of: [
        of.viscosity_index(u * 1e-6, y * 1e-6)
        for u, y in ((15, 3.2), (22, 4.2), (30, 5.5), (38, 6.6), (46, 7.3), (60, 8.4), (100, 11),
                     (150, 14), (200, 17), (260, 20), (330, 25), (450, 33), (680, 48), (900, 62), (1500, 90))
    ],
)  # fmt: skip


# --------------------------------------------------------------------------------- base stocks

MEASURED = {
    "mineral": (0.096, 0.0106, 882, {60: 19.1e-9, 90: 16.9e-9}),
    "PAO": (0.0941, 0.014, 840, {60: 13.8e-9, 90: 11.9e-9}),
}
"""Paraffinic mineral oil and PAO of Mann (1995): density and alpha by degC."""


def _grades(tables, base):
    return {int(grade): tuple(row) for grade, row in tables[base]["grades"].items()}


def _viscosities(of):
    return {
        base: {
            grade: [float(walther_viscosity(m, n, t)) * 1e6 for t in (DEGREES_40, DEGREES_100)]
            for grade, (m, n) in _grades(of, base).items()
        }
        for base in of
    }


def _grades_hold(of):
    """Every oil is within 11 % of its grade at 40 degC."""
    return all(
        abs(row[0] / grade - 1) < 0.11
        for rows in _viscosities(of).values()
        for grade, row in rows.items()
    )


def _indices_in_family(of):
    """Indices of a base stock lie in its usual range: mineral 85 to 110, PAO 130 to 195, PAG 180 to 290."""
    ranges = {"mineral": (85, 112), "PAO": (130, 195), "ester": (125, 200), "PAG": (180, 290)}
    return all(
        low < viscosity_index(cold * 1e-6, hot * 1e-6) < high
        for base, (low, high) in ranges.items()
        for cold, hot in _viscosities(of)[base].values()
    )


def _densities(of):
    """Mineral 870 to 910, PAO 825 to 865, ester 900 to 980, PAG 990 to 1070; all fall by 5 to 9 in 10,000."""
    ranges = {"mineral": (870, 910), "PAO": (825, 865), "ester": (900, 980), "PAG": (990, 1070)}
    return all(
        low < of[base]["density_15"] < high and 5e-4 < of[base]["density_coefficient"] < 9e-4
        for base, (low, high) in ranges.items()
    )


def _heat_capacity(of):
    """Cragoe's (1685 + 3.4 t)/sqrt(s) at 60 degC within 17 %; PAG 1.8 to 2.1 kJ/(kg K)."""
    for base in ("mineral", "PAO", "ester"):
        wanted = (1685 + 3.4 * 60) / sqrt(of[base]["density_15"] / 1000)
        if not within_factor(of[base]["specific_heat"], wanted, 1.18):
            return False
    return 1800 < of["PAG"]["specific_heat"] < 2100 and 0.14 < of["PAG"]["conductivity"] < 0.16


def _gold(of, base, nu):
    return float(gold_alpha(nu, of[base]["gold_s"], of[base]["gold_t"]))


def _alpha_measured(of):
    """Gold's alpha of the oils of Mann (1995), 96 and 94 mm2/s at 40 degC, within 1.3 at 60 and 90 degC."""
    for base, nus in (("mineral", (40e-6, 13.7e-6)), ("PAO", (48e-6, 18.0e-6))):
        for nu, wanted in zip(nus, MEASURED[base][3].values(), strict=True):
            if not within_factor(_gold(of, base, nu), wanted, 1.3):
                return False
    return within_factor(_gold(of, "PAG", 180e-6), 9.5e-9, 1.35)


def _spread_holds_measured(of):
    """The spread holds the measured oils, and is at most twice what they need."""
    for base, nus in (("mineral", (38e-6, 13.8e-6)), ("PAO", (43e-6, 17.8e-6))):
        for nu, wanted in zip(nus, MEASURED[base][3].values(), strict=True):
            if not abs(wanted / _gold(of, base, nu) - 1) < of[base]["alpha_spread"]:
                return False
    off = abs(9.5e-9 / _gold(of, "PAG", 221e-6) - 1)
    return off < of["PAG"]["alpha_spread"] and all(
        0.15 < rows["alpha_spread"] < 0.6 for rows in of.values()
    )


def _golds_exponents(of):
    """Exponents of all base stocks agree within 12 %, and coefficients fall mineral, PAO, ester, PAG."""
    exponents = [of[base]["gold_t"] for base in of]
    values = [_gold(of, base, 100e-6) for base in ("PAG", "ester", "PAO", "mineral")]
    return (
        within_factor(max(exponents), min(exponents), 1.12) and rises(values) and values[3] < 20e-9
    )


def _agma_as_gold(of):
    """AGMA's law is Gold's within 1.35 from 8 to 300 mm2/s."""
    for base, nu in product(("mineral", "PAO", "PAG"), (8e-6, 50e-6, 300e-6)):
        k, s = of[base]["agma_k"], of[base]["agma_s"]
        eta = nu * of[base]["density_15"] * 0.97
        if not within_factor(float(agma_alpha(eta, k, s)), _gold(of, base, nu), 1.4):
            return False
    k, s = of["mineral"]["agma_k"], of["mineral"]["agma_s"]
    return all(
        within_factor(float(agma_alpha(eta, k, s)), alpha * 1e-4 / 6894.757, 1.12)
        for eta, alpha in ((6.6e-3, 1.02), (10e-3, 1.09))
    )


def _limits_of_traction(of):
    """Limiting coefficients 0.03 to 0.055, mineral above PAO above ester."""
    values = [of[base]["limiting_coefficient"] for base in ("ester", "PAO", "mineral")]
    return (
        rises(values) and 0.025 < values[0] and values[-1] < 0.055
        and within_factor(values[1], sqrt(values[0] * values[2]), 1.05)
        and 60 < of["PAG"]["limiting_stress"] < 120
        and 2 < of["PAG"]["eyring_stress"] < 8
    )  # fmt: skip


def _asperities(of):
    """Friction of asperities from 0.04 to 0.13, mineral oil's the highest."""
    values = [of[base]["boundary_friction"] for base in ("PAG", "PAO", "mineral")]
    return (
        all(0.04 < v < 0.13 for v in values) and values[0] <= values[1] * 1.02 <= values[2] * 1.04
    )


def _under_pressure(of):
    """As Larsson's PAO within 2.6, each; denser by 12 to 22 % at 1 GPa."""
    heat, other = of["PAG"]["heat"], {
        "conductivity_c1": 1.40, "conductivity_c2": 0.34, "heat_capacity_k1": 0.41,
        "heat_capacity_k2": 1.05, "heat_capacity_b1": 2.7, "heat_capacity_b2": -1.5,
        "expansivity_decay": 1.5, "heat_capacity_b0": 6.5e-4,
    }  # fmt: skip
    like = all(within_factor(abs(heat[key]), abs(value), 2.6) for key, value in other.items())
    d1, d2 = of["PAG"]["density_d1"], of["PAG"]["density_d2"]
    return (
        like and 0.12 < d1 / (1 + d2) < 0.22 and within_factor(heat["expansivity_decay"], 1.5, 1.2)
    )


def _stock_results(of):
    return [_gold(of, base, 1e-4) for base in of]


STOCKS = Chapter(
    "Base stocks of the oil library",
    TableNumbers(OILS_TABLE),
    "[GEARpie](bibliography.md#gearpie), [Gold et al. (2001)](bibliography.md#gold-2001), "
    "[AGMA 925-A03](bibliography.md#agma-925-a03), "
    "[Sharif et al. (2001)](bibliography.md#sharif-2001), "
    "[Arana et al. (2019)](bibliography.md#arana-2019)",
    {
        "mineral": Clause("keys of the table; AGMA's k and s from memory", READ),
        "PAO": Clause("keys of the table; AGMA's k and s from memory", READ),
        "ester": Clause("keys of the table", READ),
        "PAG": Clause("keys of the table; AGMA's k and s from memory", READ),
    },
    (
        Check("every oil within 11 % of its grade", _grades_hold),
        Check("viscosity indices of each base stock in its range", _indices_in_family),
        Check("densities in their ranges", _densities),
        Check("heat capacity by Cragoe within 18 %", _heat_capacity),
        Check("alpha of three measured oils within 1.3 to 1.35", _alpha_measured),
        Check("the spread of alpha holds measured oils", _spread_holds_measured),
        Check("Gold's exponents alike, coefficients in order", _golds_exponents),
        Check("AGMA's alpha is Gold's within 1.4", _agma_as_gold),
        Check("limiting stresses in order", _limits_of_traction),
        Check("friction of asperities 0.04 to 0.13, in order", _asperities),
        Check("pressure acts as on another measured oil within 2.6", _under_pressure),
    ),
    _stock_results,
)


# --------------------------------------------------------------------------- rules of practice


def _units(of):
    """550 ft lbf/s to the horsepower, 231 in3 to the gallon, 12 in to the foot, 4.44822 N to the pound."""
    horsepower, gallon = 550 * 0.3048 * 4.4482216, 231 * 0.0254**3
    return (
        within_factor(of.HORSEPOWER_PER_GPM, horsepower / (gallon / 60), 1.0001)
        and within_factor(of.FOOT_PER_MINUTE, 0.00508, 1.0001)
        and within_factor(of.INCH * 12, 0.3048, 1.0001)
        and within_factor(of.PSI, 4.4482216 / 0.0254**2, 1.0001)
    )


def _steps_of_grades(of):
    """Grades follow each other by 1.36 to 1.55, AGMA's numbers have one grade each."""
    steps = [b / a for a, b in pairwise(of.ISO_GRADES)]
    named = list(of.AGMA_GRADES.values())
    return all(1.36 < s < 1.55 for s in steps) and named == list(of.ISO_GRADES[1:])


def _his_oils(of):
    """Errichello's two numbers: 128 mm2/s at 3000 ft/min, 350 at 400."""
    return within_factor(of.pitch_line_viscosity(15.24), 128e-6, 1.005) and within_factor(
        of.pitch_line_viscosity(2.032), 350e-6, 1.005
    )


def _his_flows(of):
    """200 hp take 1 gpm copious and 0.25 lean; scarcer by up to two each time, the last by 1.25."""
    gallon = 3.785411784e-3 / 60
    rows = [c for c, _ in of.FLOWS.values()]
    return (
        within_factor(of.oil_flow(200 * 745.7, "copious"), gallon, 1.001)
        and within_factor(of.oil_flow(200 * 745.7, "lean"), gallon / 4, 1.001)
        and [b / a for a, b in pairwise(rows)] == [2, 2, 1.25]
    )


def _agma_sizes(of):
    """Rows of worms end every 6 in; the larger, the slower they count as slow."""
    sizes = [row[0] for row in of._AGMA_WORM[:-1]]
    speeds = [row[1] for row in of._AGMA_WORM]
    products = [a * n**1.2 for a, n in zip(sizes, speeds[:-1], strict=True)]
    steps = [b / a for a, b in pairwise(speeds)]
    return (
        [b - a for a, b in zip((0, *sizes[:-1]), sizes, strict=True)] == [6, 6, 6, 6]
        and all(0.6 < s < 0.86 for s in steps)
        and within_factor(max(products), min(products), 1.25)
    )


def _agma_parallel_reads(of):
    """What Errichello reads: VG 150 or 220 at 16 in, VG 150 for a small drive."""
    large, small = (of.agma_parallel(a * 0.0254, 300).grades for a in (16, 7.5))
    ends = [of._AGMA_PARALLEL[i][0] for i in (0, 1)]
    return large == (150, 220) and small[-1] == 150 and 2 < ends[1] / ends[0] < 3 and ends[1] == 20


def _warm(of):
    """Cold places end at 50 degF."""
    return not of._is_warm(283.0) and of._is_warm(283.3)


def _rows_of_worms(of):
    """Synthetic oils one grade thinner; larger and slower worms and hotter sumps thicker."""
    index = {grade: step for step, grade in enumerate(of.ISO_GRADES)}
    for row in of._WORM_ROWS:
        low, high = (index[g] for g in row.mineral)
        thin = [index[g] for g in row.synthetic]
        if not (high - low == 1 and low - thin[0] == 1 and high - thin[1] in (0, 1)):
            return False
        if not (
            row.size[0] < row.size[1] and row.speed[0] < row.speed[1] and row.sump[0] < row.sump[1]
        ):
            return False
    small_slow, small_fast, middle, large, hot = of._WORM_ROWS
    joins = small_slow.size == small_fast.size and small_slow.size[1] == middle.size[0]
    joins = (
        joins and middle.size[1] == large.size[0] == 2 * middle.size[0] == 4 * small_slow.size[0]
    )
    speeds = small_fast.speed[0] == middle.speed[1] == 2 * small_slow.speed[1] == 4 * large.speed[1]
    slowest = middle.speed[0] * 5 == small_slow.speed[1]
    sumps = small_slow.sump == large.sump and small_slow.sump[0] == middle.sump[0] == 60
    sumps = sumps and middle.sump[1] == small_fast.sump[1] == hot.sump[0] == 100
    sumps = sumps and small_slow.sump[1] + 10 == small_fast.sump[0] == 80
    order = rises(index[row.mineral[0]] for row in (small_fast, small_slow, middle, large, hot))
    there = of.worm_table(0.1, 50.0, 370.0, True), of.worm_table(0.1, 50.0, 374.0, True)
    return joins and speeds and slowest and sumps and order and there[1].grades[0] == 460


def _jets(of):
    """Holes of 0.7 to 3.2 mm; pressures of a filter and a pump, 0.1 to 0.75 MPa."""
    low, high = of.FEED_PRESSURES
    made = of.oil_jets(1e-4, 3e5, 870, 2)
    velocity = sqrt(2 * 3e5 / 870)
    area = made.number * 3.14159265 / 4 * made.diameter**2
    most = of.oil_jets(1e-4, 3e5, 870, 20)
    holes = 1e-4 / (0.7 * velocity) / (3.14159265 / 4 * of.SMALLEST_JET**2)
    clogs = of.oil_jets(1e-6, low * 0.995, 870, 2), of.oil_jets(1e-6, low * 0.98, 870, 2)
    gushes = of.oil_jets(1e-6, high * 1.005, 870, 2), of.oil_jets(1e-6, high * 1.02, 870, 2)
    return (
        0.7e-3 < of.SMALLEST_JET < 0.8e-3 and 2.8e-3 < of.LARGEST_JET < 3.2e-3
        and 0.13e6 < low < 0.145e6 and within_factor(high / low, 5, 1.01)
        and 0.6 < 1e-4 / (velocity * area) < 0.8 and most.most == int(holes)
        and len(clogs[1].advice) - len(clogs[0].advice) == 1
        and len(gushes[1].advice) - len(gushes[0].advice) == 1
    )  # fmt: skip


def _methods(of):
    """Six ways of bringing oil, from splash to jets, at 10 to 110 m/s, never back to a simpler one."""
    words, ends = [], []
    for step in range(1, 240):
        said = of.application_method(step * 0.5)
        if not words or said != words[-1]:
            words.append(said)
            ends.append(step * 0.5)
    steps = [b / a for a, b in pairwise(ends[1:])]
    return (
        len(set(words)) == len(words) == 7
        and 14 < ends[1] < 17
        and 95 < ends[-1] < 110
        and all(1.1 < s < 2.1 for s in steps)
    )


def _fast_and_rough(of):
    """Splash ends where AGMA 250.04 does; 3625 rpm are fast, with oil two grades below that of the rule."""
    index = {grade: step for step, grade in enumerate(of.ISO_GRADES)}
    below, above = (of.application_method(part * of.FASTEST_250_04) for part in (0.999, 1.001))
    by_rule = of.nearest_grade(of.pitch_line_viscosity(15.24))
    return (
        "baffles" in below
        and "jets" in above
        and 3500 < of.FAST_SHAFT * 30 / 3.14159265 < 3625
        and index[by_rule] - index.get(of.GRADE_421_06, 99) == 2
        and of.HOBBED_WHEEL_GRADE == of._WORM_ROWS[0].mineral[0]
    )


RULES = Chapter(
    "Rules of practice for gear oils",
    ModuleNumbers("pyworm.formulas.gear_oil"),
    "[Errichello (1991)](bibliography.md#errichello-1991); "
    "[AGMA 250.04](bibliography.md#agma-250-04); [ISO 3448](bibliography.md#iso-3448); "
    "an article's table of worm gear oils",
    {
        "FOOT_PER_MINUTE": Clause("units", READ),
        "INCH": Clause("units", READ),
        "HORSEPOWER_PER_GPM": Clause("units", READ),
        "PSI": Clause("units", READ),
        "ISO_GRADES": Clause("ISO 3448", READ),
        "AGMA_GRADES": Clause("AGMA 250.04: lubricant numbers", READ),
        "pitch_line_viscosity": Clause("Errichello, eq. 1", READ),
        "_AGMA_PARALLEL": Clause("AGMA 250.04: sizes in inches", MEMORY),
        "_AGMA_WORM": Clause("AGMA 250.04: sizes in inches, rpm", MEMORY),
        "_is_warm": Clause("AGMA 250.04: 50 degF", MEMORY),
        "_WORM_ROWS": Clause("table: mm, rpm, degC, grades mineral, synthetic", READ),
        "worm_table": Clause("table: hottest ordinary sump, degC", READ),
        "FASTEST_250_04": Clause("Errichello: ft/min", READ),
        "FAST_SHAFT": Clause("AGMA 421.06: rpm", MEMORY),
        "GRADE_421_06": Clause("Errichello's example of AGMA 421.06", READ),
        "HOBBED_WHEEL_GRADE": Clause("article, surface finish", READ),
        "FLOWS": Clause("Errichello, table 1", READ),
        "SMALLEST_JET, LARGEST_JET": Clause("Errichello: inches", READ),
        "FEED_PRESSURES": Clause("Errichello: psi", READ),
        "oil_jets": Clause("discharge, circles, tolerance of pressures", OURS),
        "application_method": Clause("Errichello: ft/min", READ),
    },
    (
        Check("units from their definitions", _units),
        Check("grades in geometric steps", _steps_of_grades),
        Check("Errichello's two viscosities", _his_oils),
        Check("Errichello's two flows", _his_flows),
        Check("worm sizes every 6 in, speeds in proportion", _agma_sizes),
        Check("grades that Errichello reads for parallel shafts", _agma_parallel_reads),
        Check("cold places end at 50 degF", _warm),
        Check("rows of worms meet, in order", _rows_of_worms),
        Check("jets and pressures", _jets),
        Check("fast gears and rough wheels", _fast_and_rough),
        Check("ways of bringing oil in order", _methods),
    ),
    lambda of: [of.pitch_line_viscosity(10)],
)

CHAPTERS = (LAWS, STOCKS, RULES)
