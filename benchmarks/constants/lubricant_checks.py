"""Checks of type and life of lubricants, of the torque of cold oil and of jets of thick oil."""

from itertools import pairwise
from math import exp, pi, sqrt

from chapter import MEMORY, OURS, READ, Chapter, Clause, falls, within_factor
from constant_slips import Check, ModuleNumbers

C = 273.15

# ------------------------------------------------------------------------------- life of oil


def _halved(of):
    """Lives halve from 80 to 90 degC and double to 71 degC, by Arrhenius."""
    lives = [of.oil_life("mineral", C + celsius) for celsius in (70.5, 80, 90)]
    return (
        within_factor(lives[1] / lives[2], 2, 1.001)
        and within_factor(lives[0] / lives[1], 2, 1.02)
        and within_factor(lives[1], 1e4, 1.001)
        and within_factor(of.ACTIVATION_ENERGY, 73.9e3, 1.005)
        and within_factor(of.GAS_CONSTANT, 1.380649e-23 * 6.02214076e23, 1.0001)
    )


def _synthetic(of):
    """Synthetic oils last twice as long as mineral ones, in hours and in years."""
    return all(
        table["PAO"] == table["PAG"] == 2 * table["mineral"] == 2 * table["ester"]
        for table in (of.REFERENCE_LIFE, of.LONGEST_LIFE)
    ) and within_factor(of.REFERENCE_LIFE["mineral"], 5000 * of.LONGEST_LIFE["mineral"], 1.01)


def _intervals(of):
    """Steps of 15 K that halve the interval of mineral oil; synthetic oil three to seven times as long."""
    limits = [row[0] - C for row in of.MAKER_INTERVALS]
    mineral = [row[1] for row in of.MAKER_INTERVALS]
    synthetic = [row[2] for row in of.MAKER_INTERVALS]
    second = [b - a for a, b in pairwise(pairwise_ratio(synthetic))]
    return (
        [b - a for a, b in pairwise(limits)] == [15, 15]
        and within_factor(limits[1], 80, 1.01)
        and [a / b for a, b in pairwise(mineral)] == [2, 2]
        and within_factor(mineral[1] * 2.5, of.REFERENCE_LIFE["mineral"], 1.01)
        and all(3 < s / m < 6.5 for s, m in zip(synthetic, mineral, strict=True))
        and second[0] < 0
        and within_factor(synthetic[0] / synthetic[2], 2, 1.001)
        and within_factor(synthetic[1], sqrt(synthetic[0] * synthetic[2]), 1.2)
    )


def pairwise_ratio(values):
    """Each value over the next."""
    return [a / b for a, b in pairwise(values)]


def _limits_of_used_oil(of):
    """Gear oil of VG 220 is used from 198 to 242 mm2/s; caution at half the way, acid below 2."""
    return (
        within_factor(of.VISCOSITY_LIMIT, 242 / 220 - 1, 1.01)
        and within_factor(of.VISCOSITY_CAUTION * 2, of.VISCOSITY_LIMIT, 1.01)
        and within_factor(of.MEASURABLE * of.VISCOSITY_LIMIT, 0.01, 1.2)
        and within_factor(of.ACID_LIMIT, 2, 1.2)
        and within_factor(of.FIRST_CHANGE, of.MAKER_INTERVALS[1][1] / 8, 1.2)
        and of.HOUR == 3600
    )


LIFE = Chapter(
    "Life of oil",
    ModuleNumbers("pyworm.formulas.oil_life"),
    "[Flender (2009)](bibliography.md#flender-2009), [Bonfiglioli](bibliography.md#bonfiglioli); "
    "[ANSI/AGMA 9005](bibliography.md#agma-9005); [Amarillo Gear](bibliography.md#amarillo)",
    {
        "HOUR": Clause("units", READ),
        "REFERENCE_TEMPERATURE": Clause("Flender: 80 degC", READ),
        "REFERENCE_LIFE": Clause("Flender: hours", READ),
        "LONGEST_LIFE": Clause("Flender: years", READ),
        "HALVING": Clause("Flender: K", READ),
        "MAKER_INTERVALS": Clause("Bonfiglioli: K, hours", READ),
        "GAS_CONSTANT": Clause("definition", READ),
        "FIRST_CHANGE": Clause("AGMA 9005-D94: hours", MEMORY),
        "MEASURABLE": Clause("1 % of viscosity", OURS),
        "VISCOSITY_CAUTION, VISCOSITY_LIMIT": Clause("laboratories; Amarillo Gear", READ),
    },
    (
        Check("lives halve by 10 K", _halved),
        Check("synthetic oils last twice as long", _synthetic),
        Check("intervals halve by 15 K", _intervals),
        Check("limits of used VG 220", _limits_of_used_oil),
    ),
    lambda of: [of.oil_life("PAG", C + 60), of.change_interval("mineral", C + 70, 6000)],
)

# ------------------------------------------------------------------------------- cold oil


def _meets(of):
    """Both laws of bearings meet at nu n = 2000, where 160 is their torque."""
    slow = of.bearing_torque(2, 0.1, 1e-6, 100.0)
    return within_factor(slow, 160e-10 * 2 * 1e6, 1.01) and within_factor(
        of.bearing_torque(2, 0.1, 8e-4, 100.0) / of.bearing_torque(2, 0.1, 1e-4, 100.0), 4, 1.001
    )


def _factors(of):
    """Rollers resist more than balls, tapered ones twice as much."""
    table = of.BATH_FACTORS
    return (
        table["ball"] < table["cylindrical"] < table["angular ball"] < table["tapered"]
        and within_factor(table["tapered"], 2 * table["ball"], 1.01)
        and within_factor(table["cylindrical"], 3, 1.1)
        and within_factor(table["angular ball"], 3.3, 1.1)
        and within_factor(table["ball"], 2, 1.1)
    )


def _discs(of):
    """Jeffery's 32/3 mu w R^3, von Karman's layers by their momentum integrals, Blasius' plate."""
    disc = of.DippingBody(0.1, 1e-3, 1.0)
    creeping = disc.torque(900.0, 1.0, 0.1) - 4 * pi * 900 * 0.1 * 0.01 * 1e-3
    laminar, turbulent = (_sides(disc, viscosity) for viscosity in (1e-4, 1e-7))
    return (
        within_factor(creeping, 32 / 3 * 900 * 0.1 * 1e-3, 1.005)
        and within_factor(laminar, pi * 0.616 * 2, 1.005)
        and within_factor(turbulent, 0.146, 1.02)
        and within_factor(of.LAMINAR_PLATE, 4 * 0.33206, 1.001)
        and within_factor(disc.torque(900.0, 1e-4, 100.0) / _thin(of, 100.0), 1, 1.05)
    )


def _sides(disc, viscosity):
    """Moment coefficient times the power of its Reynolds number, rim taken away."""
    speed, radius = 100.0, disc.radius
    reynolds = speed * radius**2 / viscosity
    rim = 1.328 / sqrt(2 * pi * reynolds) * 450 * (speed * radius) ** 2
    creep = 4 * pi * 900 * viscosity * speed * radius**2 * disc.width
    torque = disc.torque(900.0, viscosity, speed)
    torque -= max(rim * 2 * pi * radius**2 * disc.width, creep)
    power = 0.2 if reynolds > 3e5 else 0.5
    return torque / (450 * speed**2 * radius**5) * reynolds**power


def _thin(of, speed):
    """Torque of the same disc without its rim."""
    return of.DippingBody(0.1, 1e-3, 1.0).torque(900.0, 1e-4, speed)


def _regimes(of):
    """A disc is turbulent above Re of 3e5, and torque rises there; no step down."""
    disc = of.DippingBody(0.2, 0.05, 0.5)
    torques = [disc.torque(900.0, 10**-power, 100.0) for power in (2, 3, 4, 5)]
    below, above = (disc.torque(900.0, 4.0 / re, 100.0) for re in (2.9e5, 3.2e5))
    return falls(torques) and above > below and disc.torque(900.0, 1e-4, 0.0) == 0


COLD = Chapter(
    "Torque of cold oil",
    ModuleNumbers("pyworm.formulas.no_load_torque"),
    "[Palmgren (1959)](bibliography.md#palmgren-1959), "
    "[Schlichting (1979)](bibliography.md#schlichting-1979), [Jeffery (1915)](bibliography.md#jeffery-1915)",
    {
        "BATH_FACTORS": Clause("Palmgren: f_0 in a bath", MEMORY),
        "SLOW_BEARING": Clause("Palmgren: mm2/s rpm", MEMORY),
        "LAMINAR_DISC, TURBULENT_DISC, CREEPING_DISC": Clause("free discs", MEMORY),
        "LAMINAR_PLATE": Clause("Blasius", MEMORY),
        "bearing_torque": Clause("Palmgren: N mm", MEMORY),
        "DippingBody.torque": Clause("discs and rims", MEMORY),
    },
    (
        Check("laws of bearings meet", _meets),
        Check("rollers resist more than balls", _factors),
        Check("limits of discs", _discs),
        Check("regimes of discs", _regimes),
    ),
    lambda of: [
        of.bearing_torque(4, 0.07, 2e-4, 150.0),
        of.DippingBody(0.28, 0.06, 0.3).torque(1000.0, 2e-4, 8.0),
    ],
)

# ------------------------------------------------------------------------------- jets


def _viscous(of):
    """Poiseuille's long pipe, Sampson's hole in a plate, and a drilled hole of 0.6 to 0.8."""
    pipe, hole = of.discharge_coefficient(1e-3, 20), of.discharge_coefficient(1e-3, 0)
    return (
        within_factor(1 / pipe - 1 / hole, 64 * 20 / 1e-3, 1.001)
        and within_factor(1 / hole, 37.699 / 1e-3, 1.001)
        and within_factor(of.discharge_coefficient(1e9, 2), 0.7, 1.02)
        and within_factor(of.discharge_coefficient(100, 0), _quadratic(37.699 / 100), 1.005)
    )


def _quadratic(drag):
    """Root of C^2/0.49 + drag C = 1."""
    return 0.49 / 2 * (sqrt(drag**2 + 4 / 0.49) - drag)


def _sized(of):
    """Jets of that discharge pass the flow."""
    flow, pressure, density, viscosity = 1e-4, 2e5, 870.0, 1e-4
    found = of.jet_discharge(flow, pressure, density, viscosity, 4, 2)
    ideal = sqrt(2 * pressure / density)
    diameter = sqrt(4 * flow / (4 * pi * found * ideal))
    return within_factor(found, of.discharge_coefficient(diameter * ideal / viscosity, 2), 1.001)


JETS = Chapter(
    "Jets of thick oil",
    ModuleNumbers("pyworm.formulas.nozzle"),
    "[Sampson (1891)](bibliography.md#sampson-1891), [Dagan et al. (1982)](bibliography.md#dagan-1982)",
    {
        "TURBULENT_DISCHARGE": Clause("drilled holes", OURS),
        "ENTRY_RESISTANCE": Clause("Sampson", MEMORY),
        "PIPE_RESISTANCE": Clause("Hagen and Poiseuille", MEMORY),
        "LENGTHS": Clause("holes that are jets", OURS),
        "discharge_coefficient": Clause("sum of pressures", OURS),
        "jet_discharge": Clause("circles; range of diameters", OURS),
    },
    (Check("viscous and inviscid limits", _viscous), Check("jets pass the flow", _sized)),
    lambda of: [of.discharge_coefficient(300, 2)],
)

# ------------------------------------------------------------------------------- types


def _ranges(of):
    """Ranges widen from oil over grease to solid films; those of synthetic oils by 10 K at both ends."""
    (cold, hot), (synthetic_cold, synthetic_hot) = of.OIL_RANGE["mineral"], of.OIL_RANGE["PAG"]
    return (
        of.OIL_RANGE["PAG"] == of.OIL_RANGE["PAO"]
        and within_factor(cold - synthetic_cold, 10, 1.01)
        and within_factor(synthetic_hot - hot, 10, 1.01)
        and within_factor(of.OIL_RANGE["ester"][0] + 5, cold, 1.001)
        and of.OIL_RANGE["ester"][1] == hot
        and within_factor(hot - C, 100, 1.01)
        and within_factor(of.SHORT_TIME, 100 - 90, 1.01)
        and of.SOLID_RANGE[0] < of.GREASE_RANGE[0] < synthetic_cold
        and synthetic_hot < of.GREASE_RANGE[1] < of.SOLID_RANGE[1]
        and within_factor(C - of.GREASE_RANGE[0], 30, 1.05)
        and within_factor(of.GREASE_RANGE[1] - C, 120, 1.05)
        and within_factor(of.SOLID_RANGE[0], (-365 + 459.67) / 1.8, 1.02)
        and within_factor(of.SOLID_RANGE[1], (450 + 459.67) / 1.8, 1.01)
    )


def _speeds(of):
    """Grease to walking speeds, less with sliding, compounds slower still; light is a third of hard steel."""
    return (
        of.COMPOUND_SPEED < of.GREASE_SLIDING < of.GREASE_SPEED
        and within_factor(of.GREASE_SPEED / of.GREASE_SLIDING, exp(0.5), 1.03)
        and within_factor(of.GREASE_SLIDING / of.COMPOUND_SPEED, 1.6, 1.02)
        and within_factor(of.GREASE_SPEED, 6.5, 1.2)
        and 0.3e9 < of.LIGHT_LOAD < 0.9e9
    )


TYPES = Chapter(
    "Type of lubricant",
    ModuleNumbers("pyworm.formulas.lubricant_type"),
    "[Errichello (1991)](bibliography.md#errichello-1991); limits of "
    "[Flender (2009)](bibliography.md#flender-2009), [Goang Chyan](bibliography.md#goang-chyan), "
    "[Anoplate](bibliography.md#anoplate); [DIN 51509](bibliography.md#din-51509)",
    {
        "GREASE_SPEED, GREASE_SLIDING": Clause("Goang Chyan: m/s", READ),
        "COMPOUND_SPEED": Clause("DIN 51509: m/s", MEMORY),
        "LIGHT_LOAD": Clause("a third of what hard steel bears", OURS),
        "SHORT_TIME": Clause("Flender: 90 and 100 degC", READ),
        "OIL_RANGE": Clause("Flender: short-term temperatures", READ),
        "GREASE_RANGE": Clause("lithium greases", MEMORY),
        "SOLID_RANGE": Clause("Anoplate: degF", READ),
    },
    (Check("temperatures", _ranges), Check("speeds and loads", _speeds)),
    lambda of: [of.GREASE_SPEED],
)

CHAPTERS = (TYPES, LIFE, COLD, JETS)
