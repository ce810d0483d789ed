"""Which grade of oil a gear drive wants, worked backwards from the specific film, step by step in words.

A pure function of plain numbers: whoever calls it takes them from a case, from a simulation or from a
drawing.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import pi
from textwrap import fill

from scipy.optimize import brentq

from pyworm.formulas import film as films
from pyworm.formulas import gear_oil, scuffing, wear_distress
from pyworm.formulas.bearing_life import reference_viscosity
from pyworm.formulas.gear_oil import TableAdvice
from pyworm.formulas.lubrication import BOUNDARY
from pyworm.formulas.ranges import positive, within
from pyworm.formulas.worm_standard import PRESSURE_VISCOSITY, WormGear, minimum_film
from pyworm.named_oils import (
    ISO_GRADES,
    Base,
    NamedOil,
    base_stock,
    named_oil,
    oil_from_index,
)

ZERO_CELSIUS = 273.15

MILLIMETRE_SQUARED = 1e-6
"""1 mm2/s [m2/s]."""

CHURNING_EXPONENT = 0.5
"""How churning loss grows with viscosity: friction of a laminar boundary layer on a disc goes as its root."""

THICKEST = 9e-3
"""Largest viscosity at 40 degC [m2/s] that is looked for."""

PAGE_WIDTH = 100
"""Letters in a line of the page."""


@dataclass(frozen=True)
class FilmLaw:
    """A minimum film as a function of the oil alone, all else being fixed.

    Attributes
    ----------
    film : callable
        Of dynamic viscosity [Pa s] and pressure-viscosity coefficient [1/Pa]; the minimum film [m].
    source : str
        The formula's.
    words : str
        The formula, with the numbers of all but the oil.
    alpha : float or None
        The pressure-viscosity coefficient [1/Pa] that the formula has for the base stock; None where it takes
        the oil's own.
    """

    film: Callable[[float, float], float]
    source: str
    words: str
    alpha: float | None = None

    def of(self, oil: NamedOil, temperature: float) -> float:
        """The film [m] of an oil on teeth of a temperature [K]."""
        return self.film(float(oil.viscosity(temperature)), self.alpha_of(oil, temperature))

    def alpha_of(self, oil: NamedOil, temperature: float) -> float:
        """The pressure-viscosity coefficient [1/Pa] that the formula takes."""
        return float(oil.alpha(temperature)) if self.alpha is None else self.alpha


def line_film(
    radius: float, load_per_length: float, reduced_modulus: float, speed: float
) -> FilmLaw:
    """Dowson and Higginson's film of one contact of a gear pair.

    Parameters
    ----------
    radius : float
        Relative radius of curvature [m].
    load_per_length : float
        [N/m].
    reduced_modulus : float
        E' [Pa].
    speed : float
        Mean speed of both surfaces [m/s].
    """

    def film(viscosity: float, alpha: float) -> float:
        groups = films.line_groups(
            radius, load_per_length, reduced_modulus, speed, viscosity, alpha
        )
        return float(films.dowson_higginson(groups).minimum)

    return FilmLaw(
        film,
        "minimum film of a line contact, Dowson and Higginson (1968)",
        "h = 2.65 R U^0.70 G^0.54 W^-0.13, U = eta u/(E' R), G = alpha E', W = w/(E' R), at the thinnest "
        f"place of the line of action with R = {radius * 1e3:.3g} mm, u = {speed:.3g} m/s, "
        f"w = {load_per_length * 1e-3:.0f} N/mm, E' = {reduced_modulus * 1e-9:.0f} GPa",
    )


def worm_film(
    gear: WormGear, worm_speed: float, torque: float, reduced_modulus: float, base: Base
) -> FilmLaw:
    """The mean minimum film of a worm gear by the standards; arguments as of `worm_standard.rate_worm`."""

    def film(viscosity: float, alpha: float) -> float:
        return minimum_film(
            gear.film_parameter,
            alpha,
            viscosity,
            worm_speed,
            gear.centre_distance,
            reduced_modulus,
            torque,
        )

    return FilmLaw(
        film,
        "mean minimum film of a worm gear, methods of DIN 3996",
        "h = 21 h* alpha^0.6 eta^0.7 n^0.7 a^1.39 E^0.03/T^0.13 um (alpha in m2/N, eta in Pa s) with h* = "
        f"{gear.film_parameter:.4f}, n = {worm_speed * 30 / pi:.0f} rpm, "
        f"a = {gear.centre_distance * 1e3:.1f} mm, E = {reduced_modulus * 1e-6:.0f} N/mm2, "
        f"T = {torque:.0f} N m",
        alpha=PRESSURE_VISCOSITY.get(base),
    )


@dataclass(frozen=True)
class Duty:
    """What an oil has to do.

    Attributes
    ----------
    name : str
        The drive.
    base : str
        Base stock to choose a grade of.
    film : FilmLaw
        How the film follows the oil.
    roughness : float
        Composite rms roughness of the teeth [m].
    specific_film : float
        lambda that is wanted [-].
    ambient_temperature : float
        [K].
    sump_temperature, sump_grade : float, int
        Sump temperature [K], measured or expected with this grade.
    bulk_excess : float
        How far the teeth are hotter than the sump [K].
    churning_share : float
        Share of the heat in the sump that churning makes with that grade [-], 0 to 0.9.
    sump_limit : float
        Highest sump temperature allowed [K].
    pitch_line_velocity : float or None
        [m/s], for the rule of speed and the probability of distress; None for a worm gear, to which they
        do not apply.
    tables : tuple of TableAdvice or None
        What tables say; None in the place of a table that has no row.
    contact_temperature : float or None
        Largest contact temperature of the teeth [K], if scuffing is to be judged.
    bearing_speed, bearing_diameter : float or None
        Speed [rad/s] and mean diameter [m] of the bearing that needs the thickest oil.
    coldest_start : float or None
        Lowest temperature [K] that the drive starts at, if the pour point is to be said.
    """

    name: str
    base: Base
    film: FilmLaw
    roughness: float
    specific_film: float
    ambient_temperature: float
    sump_temperature: float
    sump_grade: int
    bulk_excess: float
    churning_share: float
    sump_limit: float
    pitch_line_velocity: float | None = None
    tables: tuple[TableAdvice | None, ...] = ()
    contact_temperature: float | None = None
    bearing_speed: float | None = None
    bearing_diameter: float | None = None
    coldest_start: float | None = None

    def __post_init__(self) -> None:
        """Refuse what is no duty."""
        base_stock(self.base)
        within("composite roughness", self.roughness, 1e-9, 1e-4, "m")
        within("wanted lambda", self.specific_film, 0.01, 20, "")
        within("ambient temperature", self.ambient_temperature, 220, 340, "K")
        within("sump temperature", self.sump_temperature, 250, 470, "K")
        within("limit of the sump temperature", self.sump_limit, 300, 470, "K")
        within("excess of the teeth's temperature", self.bulk_excess, 0, 150, "K")
        within("share of churning", self.churning_share, 0, 0.9, "")
        if self.sump_temperature <= self.ambient_temperature:
            raise ValueError(
                f"sump temperature = {self.sump_temperature:g} K: must be above the ambient "
                f"{self.ambient_temperature:g} K"
            )
        if (self.bearing_speed is None) != (self.bearing_diameter is None):
            raise ValueError("give bearing_speed and bearing_diameter together")
        if self.pitch_line_velocity is not None:
            positive("pitch line velocity", self.pitch_line_velocity, "m/s")


@dataclass(frozen=True)
class GradeRow:
    """What one grade would do.

    Attributes
    ----------
    grade : int
        ISO viscosity grade.
    sump_temperature, bulk_temperature : float
        In balance with its own churning [K].
    viscosity : float
        Kinematic viscosity at the teeth [m2/s].
    film : float
        Minimum film [m].
    specific_film : float
        lambda [-].
    heat : float
        Heat in the sump over that with the grade of reference [-].
    kappa : float or None
        Viscosity ratio of the bearing at the sump temperature [-].
    """

    grade: int
    sump_temperature: float
    bulk_temperature: float
    viscosity: float
    film: float
    specific_film: float
    heat: float
    kappa: float | None


@dataclass(frozen=True)
class Step:
    """One step of the choice.

    Attributes
    ----------
    title : str
        What it is about.
    text : str
        What was found, in words with numbers.
    source : str
        Where the rule comes from; empty where nothing but arithmetic is used.
    table : tuple of str
        Lines of a table that belongs to it.
    """

    title: str
    text: str
    source: str = ""
    table: tuple[str, ...] = ()


@dataclass(frozen=True)
class OilChoice:
    """A recommended grade and how it was found.

    Attributes
    ----------
    duty : Duty
        What was asked.
    grade : int
        The recommended ISO viscosity grade.
    oil : str
        The oil's name.
    reached : bool
        Whether it gives the wanted specific film.
    viscosity_needed : float or None
        Kinematic viscosity at 40 degC [m2/s] that would give it at the temperature of reference; None if
        none does.
    rows : tuple of GradeRow
        Every grade.
    steps : tuple of Step
        In the order of the reasoning, the recommendation last.
    """

    duty: Duty
    grade: int
    oil: str
    reached: bool
    viscosity_needed: float | None
    rows: tuple[GradeRow, ...]
    steps: tuple[Step, ...]


def choose_oil(duty: Duty) -> OilChoice:
    """Choose a grade.

    The thinnest grade whose film is the wanted one in balance with its own churning, but none thinner
    than practice allows and none that overheats the sump. Where no grade gives the film, the thickest
    that practice recommends: the film is then not the oil's to mend.

    Raises
    ------
    ValueError
        Numbers outside the formulas, or a sump that every grade overheats.
    """
    rows = tuple(_row(duty, grade) for grade in ISO_GRADES)
    cool = [row for row in rows if row.sump_temperature <= duty.sump_limit]
    if not cool:
        raise ValueError(
            f"limit of the sump temperature = {duty.sump_limit:g} K: exceeded by every grade, "
            f"{rows[0].sump_temperature:.0f} K with VG {rows[0].grade}; cool the sump"
        )
    practice = _practice(duty)
    needed = _viscosity_needed(duty)
    thick_enough = [row for row in cool if row.specific_film >= duty.specific_film]
    if thick_enough:
        least = min(practice, default=0)
        wanted = [row for row in thick_enough if row.grade >= least]
        chosen = wanted[0] if wanted else thick_enough[-1]
    else:
        most = max(practice, default=ISO_GRADES[-1])
        chosen = [row for row in cool if row.grade <= most or row is cool[0]][-1]
    steps = [
        *_practice_steps(duty),
        _film_step(duty),
        _backwards_step(duty, needed),
        _balance_step(duty, rows, chosen),
    ]
    if duty.bearing_speed is not None:
        steps.append(_bearing_step(duty, chosen))
    if duty.contact_temperature is not None:
        steps.append(_scuffing_step(duty, chosen))
    steps.append(_recommendation(duty, chosen, practice, cool))
    return OilChoice(
        duty=duty,
        grade=chosen.grade,
        oil=f"{duty.base} VG {chosen.grade}",
        reached=chosen.specific_film >= duty.specific_film,
        viscosity_needed=needed,
        rows=rows,
        steps=tuple(steps),
    )


def page(choice: OilChoice) -> str:
    """The choice as one page of plain text."""
    lines = [f"Oil for {choice.duty.name}", ""]
    for number, step in enumerate(choice.steps, 1):
        lines.append(f"{number}. {step.title}")
        if step.source:
            lines.append(fill(f"({step.source})", PAGE_WIDTH, initial_indent="   "))
        lines.append(fill(step.text, PAGE_WIDTH, initial_indent="   ", subsequent_indent="   "))
        if step.table:
            lines += ["", *(f"   {line}" for line in step.table)]
        lines.append("")
    return "\n".join(lines[:-1]) + "\n"


# ------------------------------------------------------------------------------------- numbers


def _row(duty: Duty, grade: int) -> GradeRow:
    oil = named_oil(f"{duty.base} VG {grade}")
    reference = named_oil(f"{duty.base} VG {duty.sump_grade}")
    thickness = float(reference.kinematic_viscosity(duty.sump_temperature))
    rise, share = duty.sump_temperature - duty.ambient_temperature, duty.churning_share

    def heat(sump: float) -> float:
        ratio = float(oil.kinematic_viscosity(sump)) / thickness
        return 1 - share + share * ratio**CHURNING_EXPONENT

    # Thinner with every degree, so that there is one balance; the teeth's share alone bounds it from below.
    coldest = duty.ambient_temperature + (1 - share) * rise
    sump = brentq(lambda sump: duty.ambient_temperature + rise * heat(sump) - sump, coldest, 499.0)
    bulk = sump + duty.bulk_excess
    film = duty.film.of(oil, bulk)
    return GradeRow(
        grade=grade,
        sump_temperature=sump,
        bulk_temperature=bulk,
        viscosity=float(oil.kinematic_viscosity(bulk)),
        film=film,
        specific_film=film / duty.roughness,
        heat=heat(sump),
        kappa=_kappa(duty, float(oil.kinematic_viscosity(sump))),
    )


def _kappa(duty: Duty, viscosity: float) -> float | None:
    if duty.bearing_speed is None or duty.bearing_diameter is None:
        return None
    return viscosity / reference_viscosity(duty.bearing_speed, duty.bearing_diameter)


def _film_at(duty: Duty, oil: NamedOil) -> float:
    """Film [m] of an oil on teeth of the temperature of reference."""
    return duty.film.of(oil, duty.sump_temperature + duty.bulk_excess)


def _viscosity_needed(duty: Duty) -> float | None:
    """Viscosity at 40 degC [m2/s] for the wanted film, of the index of the reference; None beyond reach."""
    index = named_oil(f"{duty.base} VG {duty.sump_grade}").viscosity_index

    def surplus(viscosity_40: float) -> float:
        oil = oil_from_index("", duty.base, viscosity_40, index)
        return _film_at(duty, oil) / duty.roughness - duty.specific_film

    thinnest = 15 * MILLIMETRE_SQUARED
    if surplus(THICKEST) < 0:
        return None
    if surplus(thinnest) > 0:
        return thinnest
    return brentq(surplus, thinnest, THICKEST, rtol=1e-6)


def _practice(duty: Duty) -> list[int]:
    """Grades that the rule of speed and the tables name."""
    grades = [grade for table in duty.tables if table is not None for grade in table.grades]
    if duty.pitch_line_velocity is not None:
        wanted = gear_oil.pitch_line_viscosity(duty.pitch_line_velocity)
        grades.append(gear_oil.nearest_grade(wanted))
    return grades


# --------------------------------------------------------------------------------------- words


def _practice_steps(duty: Duty) -> list[Step]:
    steps = []
    if duty.pitch_line_velocity is not None:
        velocity = duty.pitch_line_velocity
        wanted = gear_oil.pitch_line_viscosity(velocity)
        feet = velocity / gear_oil.FOOT_PER_MINUTE
        steps.append(
            Step(
                "Speed",
                f"At a pitch line velocity of {velocity:.3g} m/s ({feet:.0f} ft/min) the viscosity at "
                f"40 degC should be 7000/sqrt({feet:.0f}) = {wanted / MILLIMETRE_SQUARED:.0f} mm2/s; "
                f"nearest is VG {gear_oil.nearest_grade(wanted)}. The faster the teeth, "
                "the thinner the oil that still makes a film.",
                "Errichello, pitch line rule",
            )
        )
    for table in duty.tables:
        if table is None:
            text = "This table has no row for this size, speed and temperature."
            steps.append(Step("Table", text, gear_oil.WORM_TABLE_SOURCE))
            continue
        grades = " or ".join(f"VG {grade}" for grade in table.grades)
        steps.append(Step("Table", f"{grades} ({table.row}).", table.source))
    return steps


def _film_step(duty: Duty) -> Step:
    wanted = duty.specific_film * duty.roughness
    return Step(
        "Film that is wanted",
        f"lambda = {duty.specific_film:g} over a composite roughness of {duty.roughness * 1e6:.3g} um asks "
        f"for a minimum film of {wanted * 1e6:.3g} um. Below 1 the teeth rest on their roughness, from "
        "3 on the film keeps them apart.",
    )


def _backwards_step(duty: Duty, needed: float | None) -> Step:
    bulk = duty.sump_temperature + duty.bulk_excess
    index = named_oil(f"{duty.base} VG {duty.sump_grade}").viscosity_index
    title = "Backwards to the oil"
    given = (
        f"{duty.film.words}. At teeth of {bulk - ZERO_CELSIUS:.0f} degC and with {duty.base} oil of "
        f"viscosity index {index:.0f}"
    )
    if needed is None:
        return Step(
            title,
            f"{given} no oil up to {THICKEST / MILLIMETRE_SQUARED:.0f} mm2/s at 40 degC makes this film.",
            duty.film.source,
        )
    oil = oil_from_index("", duty.base, needed, index)
    hot = oil.kinematic_viscosity(bulk) / MILLIMETRE_SQUARED
    alpha = duty.film.alpha_of(oil, bulk) * 1e9
    millimetres = needed / MILLIMETRE_SQUARED
    beyond = ", thicker than any gear oil" if millimetres > 1.1 * ISO_GRADES[-1] else ""
    return Step(
        title,
        f"{given} the film needs {hot:.3g} mm2/s or {oil.viscosity(bulk) * 1e3:.3g} mPa s on the teeth "
        f"(alpha = {alpha:.3g} 1/GPa), which is {millimetres:.0f} mm2/s at 40 degC{beyond}.",
        duty.film.source,
    )


def _balance_step(duty: Duty, rows: tuple[GradeRow, ...], chosen: GradeRow) -> Step:
    sump, ambient = duty.sump_temperature - ZERO_CELSIUS, duty.ambient_temperature - ZERO_CELSIUS
    thin, thick = rows[0], rows[-1]
    cold, hot = thick.grade / thin.grade, thick.viscosity / thin.viscosity
    gain = thick.specific_film / thin.specific_film
    warmer = thick.sump_temperature - thin.sump_temperature
    return Step(
        "Churning and temperature, grade by grade",
        f"The sump is {sump:.0f} degC with VG {duty.sump_grade} at {ambient:.0f} degC outside; "
        f"{100 * duty.churning_share:.0f} % of its heat is taken to be churning, which grows with the root "
        f"of the viscosity. Thicker oil so heats itself: from VG {thin.grade} to VG {thick.grade} the "
        f"viscosity at 40 degC grows {cold:.0f} times, on the teeth {hot:.0f} times and the film "
        f"{gain:.1f} times, while the sump warms by {warmer:.0f} K.",
        table=_table(rows, chosen),
    )


def _table(rows: tuple[GradeRow, ...], chosen: GradeRow) -> tuple[str, ...]:
    bearings = chosen.kappa is not None
    head = "VG    sump degC  teeth degC  mm2/s on teeth  film um  lambda  heat"
    lines = [head + ("  kappa" if bearings else "")]
    for row in rows:
        mark = "  <-" if row is chosen else ""
        kappa = f"  {row.kappa:5.2f}" if row.kappa is not None else ""
        lines.append(
            f"{row.grade:<5d} {row.sump_temperature - ZERO_CELSIUS:9.0f} "
            f"{row.bulk_temperature - ZERO_CELSIUS:11.0f} {row.viscosity / MILLIMETRE_SQUARED:15.1f} "
            f"{row.film * 1e6:8.3f} {row.specific_film:7.3f} {row.heat:5.2f}{kappa}{mark}"
        )
    return tuple(lines)


def _bearing_step(duty: Duty, chosen: GradeRow) -> Step:
    wanted = reference_viscosity(duty.bearing_speed, duty.bearing_diameter) / MILLIMETRE_SQUARED
    good = chosen.kappa >= 1
    return Step(
        "Bearings",
        f"The bearing wants {wanted:.1f} mm2/s; with VG {chosen.grade} at "
        f"{_celsius(chosen.sump_temperature)} kappa = {chosen.kappa:.2f}, "
        + ("which is enough." if good else "below 1: it loses life to thin oil."),
        "ISO 281:2007",
    )


def _scuffing_step(duty: Duty, chosen: GradeRow) -> Step:
    contact = duty.contact_temperature
    said = []
    for anti_scuff, words in ((False, "without"), (True, "with")):
        limit = scuffing.scuffing_temperature(chosen.grade * MILLIMETRE_SQUARED, anti_scuff)
        probability = float(scuffing.scuffing_probability(contact, limit))
        said.append(
            f"{_celsius(limit)} {words} anti-scuff additives (probability {_percent(probability)}, "
            f"{scuffing.risk(probability)})"
        )
    limits = "The formula is for mineral oils. " if duty.base != "mineral" else ""
    return Step(
        "Scuffing",
        f"The teeth reach {_celsius(contact)} in contact; VG {chosen.grade} scuffs at {said[0]} "
        f"and at {said[1]}. {limits}".strip(),
        scuffing.SOURCE,
    )


def _recommendation(
    duty: Duty, chosen: GradeRow, practice: list[int], cool: list[GradeRow]
) -> Step:
    words = [
        f"{duty.base} VG {chosen.grade}: film {chosen.film * 1e6:.3g} um, lambda {chosen.specific_film:.2g} "
        f"({wear_distress.regime(chosen.specific_film)}), sump {_celsius(chosen.sump_temperature)}."
    ]
    if chosen.specific_film >= duty.specific_film:
        thinner = [row for row in cool if row.grade < chosen.grade]
        if not thinner or thinner[-1].specific_film < duty.specific_film:
            words.append(
                "It is the thinnest grade that gives the wanted film; a thicker one only churns more."
            )
        else:
            words.append(
                "A thinner grade would give the wanted film, but not what practice asks for."
            )
    else:
        best = max(cool, key=lambda row: row.specific_film)
        words.append(
            f"No grade within the sump's limit gives lambda = {duty.specific_film:g} (VG {best.grade}: "
            f"{best.specific_film:.2g}): thicker oil is not the cure. Smoother or run-in flanks, cooler oil, "
            "more speed or less load are; until then additives must protect the teeth."
        )
        if practice:
            words.append("The grade is the thickest that practice names and the sump allows.")
    if duty.pitch_line_velocity is not None:
        probability = float(
            wear_distress.distress_probability(chosen.specific_film, duty.pitch_line_velocity)
        )
        words.append(f"Probability of wear distress: {_percent(probability)}.")
    if chosen.specific_film < BOUNDARY:
        words.append(
            "Boundary lubrication: choose an oil with anti-scuff (EP) or, for bronze, lubricity additives."
        )
    if duty.coldest_start is not None:
        words.append(f"Its pour point should be {_celsius(duty.coldest_start - 5)} or lower.")
    return Step("Recommendation", " ".join(words))


def _celsius(kelvin: float) -> str:
    return f"{kelvin - ZERO_CELSIUS:.0f} degC"


def _percent(probability: float) -> str:
    if probability < 0.01:
        return "below 1 %"
    return "above 99 %" if probability > 0.99 else f"{probability * 100:.0f} %"
