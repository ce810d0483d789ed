"""Choosing and applying gear oil by rules of practice: viscosity by speed and by table, flow, jets, method.

The rules were stated in feet, inches, rpm, horsepower and gallons; arguments and results are in SI.
"""

from dataclasses import dataclass
from math import floor, inf, log, pi, sqrt

from pyworm.formulas.ranges import one_of, positive, within
from pyworm.formulas.unit_factors import RPM, ZERO_CELSIUS

SOURCE = "R. Errichello, Lubrication of Gears, part 3"

FOOT_PER_MINUTE = 0.3048 / 60
"""1 ft/min [m/s]."""

SUCCESSORS = {
    "AGMA 250.04": "ANSI/AGMA 9005-F16",
    "AGMA 421.06": "ANSI/AGMA 6011-J14",
    "AGMA 2001-B88": "ANSI/AGMA 2001-D04",
}
"""Withdrawn standard -> what stands in its place (9005-D94 revises 250.04; the others from memory)."""

FASTEST_250_04 = 5000 * FOOT_PER_MINUTE
"""Pitch line velocity up to which AGMA 250.04 holds, and from which AGMA 421.06 does [m/s] (Errichello)."""

FAST_SHAFT = 3600 / RPM
"""Speed of the pinion from which AGMA 421.06 counts gears as fast [rad/s]; from memory, near Errichello's
3625 rpm."""

GRADE_421_06 = 68
"""Grade of AGMA 421.06 in the one example that Errichello gives; its table was not read."""

HOBBED_WHEEL_GRADE = 220
"""Least grade of a new worm gear, whose hobbed wheel is rough: article on viscosity of worm gear oils, 3.1.
"""

INCH = 0.0254
"""1 in [m]."""

HORSEPOWER_PER_GPM = 745.6999 / (3.785411784e-3 / 60)
"""1 hp per US gallon per minute [W/(m3/s)]."""

PSI = 6894.757
"""1 psi [Pa]."""

ISO_GRADES = (32, 46, 68, 100, 150, 220, 320, 460, 680, 1000)
"""Grades of ISO 3448 used in gears: kinematic viscosity at 40 degC [mm2/s]."""

AGMA_GRADES = {
    "1": 46,
    "2": 68,
    "3": 100,
    "4": 150,
    "5": 220,
    "6": 320,
    "7": 460,
    "8": 680,
    "8A": 1000,
}
"""AGMA lubricant number (AGMA 250.04) -> ISO viscosity grade.

"Comp" oils of worm gears are compounded with 3 to 10 % fatty material."""


def pitch_line_viscosity(pitch_line_velocity: float) -> float:
    """Kinematic viscosity at 40 degC [m2/s] that a pitch line velocity [m/s] wants.

    7000/sqrt(v) mm2/s with v in ft/min. Source: Errichello, equation 1. Verified by his two numbers: 128 cSt
    at 3000 ft/min, 350 at 400. Range: spur, helical and bevel gears, 0.25 to 100 m/s; he gives none.
    """
    within("pitch line velocity", pitch_line_velocity, 0.25, 100, "m/s")
    return 7000 / sqrt(pitch_line_velocity / FOOT_PER_MINUTE) * 1e-6


def nearest_grade(viscosity_40: float) -> int:
    """The ISO viscosity grade nearest by ratio to a kinematic viscosity at 40 degC [m2/s].

    ValueError for a viscosity more than half a step beyond VG 32 or VG 1000.
    """
    within("kinematic viscosity at 40 degC", viscosity_40, 26e-6, 1.2e-3, "m2/s")
    return min(ISO_GRADES, key=lambda grade: abs(log(viscosity_40 * 1e6 / grade)))


@dataclass(frozen=True)
class TableAdvice:
    """Recommendation of a table of practice."""

    grades: tuple[int, ...]
    """ISO viscosity grades, thinnest first."""
    row: str
    """The row of the table."""
    source: str
    """The table."""
    least: bool = False
    """Whether it names the least grade only."""


def withdrawn(standard: str) -> str:
    """A withdrawn standard with its successor, in words."""
    return f"{standard}, withdrawn; today {SUCCESSORS[standard]}"


def hobbed_wheel() -> TableAdvice:
    """Least grade for the hobbed wheel of a worm gear; the table of the same article goes below it."""
    return TableAdvice(
        (HOBBED_WHEEL_GRADE,),
        f"VG {HOBBED_WHEEL_GRADE} or thicker while a hobbed wheel runs in, mineral or synthetic",
        "article on worm gear oils, surface finish",
        least=True,
    )


# centre distance up to [in], AGMA numbers for a cold (15 to 50 degF) and a warm (50 to 125 degF) place
_AGMA_PARALLEL: tuple[tuple[float, tuple[str, str], tuple[str, str]], ...] = (
    (8, ("2", "3"), ("3", "4")),
    (20, ("2", "3"), ("4", "5")),
    (inf, ("3", "4"), ("4", "5")),
)

# centre distance up to [in], worm speed up to which the slow row holds [rpm]
_AGMA_WORM = ((6, 700), (12, 450), (18, 300), (24, 250), (inf, 200))


def agma_parallel(
    centre_distance: float, ambient_temperature: float, pitch_line_velocity: float = 0.0
) -> TableAdvice:
    """AGMA 250.04's grades for single-reduction parallel-shaft drives, by centre distance and ambient.

    Source: AGMA 250.04, from memory. Verified by what Errichello reads from it: VG 150 or 220 at 16 in, VG
    150 for a small drive. Range: ambient 15 to 125 degF. Above 5000 ft/min it has no grades: AGMA 421.06 is
    to be consulted there, of which one example is known.
    """
    if pitch_line_velocity > FASTEST_250_04:
        return TableAdvice(
            (),
            f"{pitch_line_velocity:.3g} m/s is above {FASTEST_250_04:.1f} m/s (5000 ft/min), where AGMA "
            f"250.04 ends: consult {withdrawn('AGMA 421.06')}, which was not read",
            withdrawn("AGMA 250.04"),
        )
    within("centre distance", centre_distance, 0.02, 3, "m")
    warm = _is_warm(ambient_temperature)
    inches = centre_distance / INCH
    row = next(row for row in _AGMA_PARALLEL if inches <= row[0])
    _, in_cold, in_warm = row
    low, high = in_warm if warm else in_cold
    grades = tuple(g for g in AGMA_GRADES.values() if AGMA_GRADES[low] <= g <= AGMA_GRADES[high])
    size = f"to {row[0]} in" if row[0] < inf else "above 20 in"
    return TableAdvice(
        grades,
        f"centre distance {size}, {'warm' if warm else 'cold'} place: AGMA {low} to {high}",
        withdrawn("AGMA 250.04"),
    )


def agma_worm(centre_distance: float, worm_speed: float, ambient_temperature: float) -> TableAdvice:
    """AGMA 250.04's grade for enclosed cylindrical worm gears: 7 Comp, or 8 Comp where slow and warm.

    By centre distance [m], speed of the worm [rad/s] and ambient temperature [K], 15 to 125 degF. Source:
    AGMA 250.04, from memory; not checked beyond the VG 460 that the worm drive of Sharif et al. (2001) runs
    with.
    """
    within("centre distance", centre_distance, 0.02, 2, "m")
    within("worm speed", worm_speed * RPM, 0.1, 1e4, "rpm")
    warm = _is_warm(ambient_temperature)
    # The rows are bounded by whole inches; 304.8 mm is 12 in, whatever rounding makes of it.
    inches = round(centre_distance / INCH, 6)
    size, slow = next(row for row in _AGMA_WORM if inches <= row[0])
    is_slow = worm_speed * RPM <= slow
    number = "8" if warm and is_slow else "7"
    bound = f"to {size} in" if size < inf else "above 24 in"
    speed = f"worm {'up to' if is_slow else 'above'} {slow} rpm"
    return TableAdvice(
        (AGMA_GRADES[number],),
        f"centre distance {bound}, {speed}, {'warm' if warm else 'cold'} place: AGMA {number} Comp",
        withdrawn("AGMA 250.04"),
    )


def _is_warm(ambient_temperature: float) -> bool:
    """Whether the warmer of the table's two columns holds; they meet at 50 degF."""
    within("ambient temperature", ambient_temperature, 263, 325, "K")
    return ambient_temperature > 283.15


@dataclass(frozen=True)
class _WormRow:
    size: tuple[float, float]  # centre distance [mm]
    speed: tuple[float, float]  # worm [rpm]
    sump: tuple[float, float]  # [degC]
    mineral: tuple[int, int]
    synthetic: tuple[int, int]
    words: str


_WORM_ROWS = (
    _WormRow(
        (50, 100), (0, 500), (60, 70), (220, 320), (150, 220),
        "50 to 100 mm below 500 rpm: adequate film for moderate loads and speeds",
    ),
    _WormRow(
        (50, 100), (1000, inf), (80, 100), (150, 220), (100, 150),
        "50 to 100 mm above 1000 rpm: high shear, need for thermal stability",
    ),
    _WormRow(
        (100, 200), (100, 1000), (60, 100), (320, 460), (220, 320),
        "100 to 200 mm, 100 to 1000 rpm: higher loads, need for robust film formation",
    ),
    _WormRow(
        (200, inf), (0, 250), (60, 70), (460, 680), (320, 460),
        "above 200 mm below 250 rpm: very high torque, EP additives often essential",
    ),
    _WormRow(
        (0, inf), (0, inf), (100, inf), (680, 1000), (460, 1000),
        "very hot sump: thermal stability and film strength are critical, synthetics mandatory",
    ),
)  # fmt: skip

WORM_TABLE_SOURCE = "worm gear viscosity table (centre distance, worm speed, sump temperature)"


def worm_table(
    centre_distance: float, worm_speed: float, sump_temperature: float, synthetic: bool
) -> TableAdvice | None:
    """Grades for worm gears, PAG if `synthetic`, else mineral; None where the table has no row.

    By centre distance [m], speed of the worm [rad/s] and sump temperature [K], between whose rows are gaps; a
    sump below a row's range is read as its coolest. Above 100 degC the mineral grades are meant as PAO or
    ester.
    """
    within("centre distance", centre_distance, 0.02, 2, "m")
    within("worm speed", worm_speed * RPM, 0.1, 1e4, "rpm")
    within("sump temperature", sump_temperature, 250, 470, "K")
    size, speed, sump = centre_distance * 1e3, worm_speed * RPM, sump_temperature - ZERO_CELSIUS
    rows = _WORM_ROWS[-1:] if sump > 100 else _WORM_ROWS[:-1]
    for row in rows:
        if row.size[0] <= size <= row.size[1] and row.speed[0] <= speed <= row.speed[1]:
            if sump > row.sump[1]:
                continue
            low, high = row.synthetic if synthetic else row.mineral
            grades = tuple(grade for grade in ISO_GRADES if low <= grade <= high)
            return TableAdvice(grades, row.words, WORM_TABLE_SOURCE)
    return None


FLOWS = {
    "copious": (200, "general industrial"),
    "adequate": (400, "typical aviation"),
    "lean": (800, "light-weight, high-efficiency aviation"),
    "starved": (1000, "only for unusual conditions"),
}
"""Word -> c of `oil_flow` [hp/gpm] and where it is used."""

SMALLEST_JET, LARGEST_JET = 0.03 * INCH, 0.12 * INCH
"""Diameters of oil jets [m]: smaller ones clog."""

FEED_PRESSURES = (20 * PSI, 100 * PSI)
"""Typical feed pressures [Pa]: about 30 psi in industry, 100 in aerospace."""


def oil_flow(power: float, flow: str) -> float:
    """Oil flow per mesh [m3/s] for a power [W], q = P/c with c by a word of `FLOWS`.

    Source: Errichello, equation 4 and table 1. Verified by his examples: 200 hp copious is 1 gpm, lean 0.25.
    """
    positive("transmitted power", power, "W")
    within("transmitted power", power, 1, 1e9, "W")
    one_of("flow", flow, FLOWS)
    return power / (FLOWS[flow][0] * HORSEPOWER_PER_GPM)


@dataclass(frozen=True)
class Jets:
    """Oil jets of one mesh."""

    number: int
    """Number of jets."""
    diameter: float
    """Diameter of each jet [m]."""
    velocity: float
    """Velocity of the oil [m/s]."""
    most: int
    """The most jets for which the diameter is not below `SMALLEST_JET`; 0 if even one is."""
    discharge: float
    """Discharge coefficient [-]."""
    advice: tuple[str, ...]
    """Where the jets leave usual practice; empty if they do not."""


def oil_jets(
    flow: float, pressure: float, density: float, number: int, discharge: float = 0.7
) -> Jets:
    """Jets that pass a flow [m3/s]: Torricelli's velocity through holes with a discharge coefficient.

    That is 0.6 to 1 of thin oil, and less of thick oil (`nozzle.discharge_coefficient`); `pressure` is that
    of the feed above the housing's [Pa]. Source: the limits are Errichello's; the flow through a hole is
    Bernoulli's.
    """
    positive("oil flow", flow, "m3/s")
    within("feed pressure", pressure, 1e4, 1e7, "Pa")
    within("density", density, 500, 2000, "kg/m3")
    within("number of jets", number, 1, 1000, "")
    within("discharge coefficient", discharge, 1e-3, 1, "")
    velocity = sqrt(2 * pressure / density)
    area = flow / (discharge * velocity)
    diameter = sqrt(4 * area / (pi * number))
    most = floor(area / (pi / 4 * SMALLEST_JET**2) + 1e-9)
    advice = []
    if diameter < SMALLEST_JET:
        fewer = f"at most {most} jets" if most else "a lower feed pressure or more flow"
        advice.append(f"jets of {diameter * 1e3:.2f} mm clog: choose {fewer} for 0.76 mm or more")
    if diameter > LARGEST_JET:
        advice.append(f"jets of {diameter * 1e3:.1f} mm are large: more jets cover the face better")
    if number == 1:
        advice.append("a single jet may clog: choose more than one for each mesh")
    low, high = FEED_PRESSURES
    if not 0.99 * low <= pressure <= 1.01 * high:
        advice.append("feed pressures are usually between 0.14 and 0.69 MPa (20 and 100 psi)")
    return Jets(number, diameter, velocity, most, discharge, tuple(advice))


def application_method(pitch_line_velocity: float) -> str:
    """How to bring oil to gears of a pitch line velocity [m/s], in words.

    Source: Errichello, section on applying gear lubricants; the limits are 3000, 5000, 7000, 8000, 16000
    and 20000 ft/min (the scan of the fifth is damaged).
    """
    within("pitch line velocity", pitch_line_velocity, 0, 300, "m/s")
    feet = pitch_line_velocity / FOOT_PER_MINUTE
    if feet <= 3000:
        return "splash: gears dip about twice the tooth depth, troughs lead oil to the bearings"
    if feet <= 5000:
        return "splash with baffles and an oil pan, fans and fins to cool the housing"
    bearings = "bearings may live on splash" if feet <= 7000 else "bearings pressure-fed too"
    if feet <= 8000:
        return f"pressure-fed, jets at the incoming side of the mesh, {bearings}"
    if feet <= 16000:
        return f"pressure-fed, jets at the outgoing side, where the teeth are hottest, {bearings}"
    fractions = (
        f"pressure-fed, 2/3 of the oil at the outgoing and 1/3 at the incoming side, {bearings}"
    )
    if feet <= 20000:
        return fractions
    return f"{fractions}; number and place of the jets by experiment"
