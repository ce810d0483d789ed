"""Steps of the choice of an oil besides its film: type, practice, additives, cold start, life of the oil."""

from dataclasses import dataclass

from pyworm.formulas import gear_oil, lubricant_type, oil_life
from pyworm.formulas.gear_oil import TableAdvice
from pyworm.formulas.lubricant_type import (
    LubricantKind,
    TypeConditions,
    TypeVerdict,
    type_verdicts,
)
from pyworm.formulas.unit_factors import RPM, SQUARE_MILLIMETRE, ZERO_CELSIUS
from pyworm.materials.library import named_oil
from pyworm.ratings import no_load
from pyworm.ratings.oil_grades import GearTeeth, GradeRow, OilDuty

POUR_MARGIN = 5.0
"""Kelvin by which oil pours below the coldest start (Errichello)."""

ACTIVE_SULPHUR = 343.15
"""Temperature from which active sulphur attacks copper alloys [K] (articles for users of worm gears)."""

COMPOUNDED = 3, 10
"""Fatty oil or low-acid tallow in mineral oils of worm gears [%] (Errichello)."""


@dataclass(frozen=True)
class Step:
    """One step of the choice."""

    title: str
    """What it is about."""
    text: str
    """What was found, in words with numbers."""
    source: str = ""
    """Where the rule comes from; empty where nothing but arithmetic is used."""
    table: tuple[str, ...] = ()
    """Lines of a table that belongs to it."""


def _verdicts(duty: OilDuty, teeth: GearTeeth) -> tuple[TypeVerdict, ...]:
    """Verdict on each type of lubricant."""
    start = duty.ambient_temperature if duty.coldest_start is None else duty.coldest_start
    return type_verdicts(
        TypeConditions(
            base=duty.base,
            velocity=teeth.velocity,
            sliding=teeth.worm,
            coldest=start,
            hottest=duty.sump_temperature,
            enclosure=duty.enclosure,
            pressure=teeth.pressure,
        )
    )


def chosen_type(duty: OilDuty) -> LubricantKind | None:
    """The type of lubricant that is chosen; None where none suits, or the teeth are not known."""
    if duty.teeth is None:
        return None
    return next((each.kind for each in _verdicts(duty, duty.teeth) if each.suitable), None)


def type_step(duty: OilDuty, teeth: GearTeeth) -> Step:
    """Type of lubricant, with what speaks against the others."""
    verdicts = _verdicts(duty, teeth)
    suited = [verdict for verdict in verdicts if verdict.suitable]
    words = [
        f"No {verdict.kind}: {'; '.join(verdict.against)}."
        for verdict in verdicts
        if not verdict.suitable
    ]
    if suited:
        chosen = suited[0]
        words.insert(
            0, f"{chosen.kind.capitalize()} ({duty.enclosure} enclosure): {chosen.limits}."
        )
        if chosen.kind != "oil":
            words.append(
                "The grades below are those of oil"
                + (", here its base oil." if chosen.kind == "grease" else ".")
            )
    else:
        words.append("No type suits: seal the enclosure, cool it, or warm it before the start.")
    return Step("Type of lubricant", " ".join(words), lubricant_type.SOURCE)


def practice_steps(duty: OilDuty) -> list[Step]:
    """Rules of practice: by speed and by tables."""
    steps = []
    if duty.pitch_line_velocity is not None:
        steps.append(_speed_step(duty, duty.pitch_line_velocity))
    if duty.tables:
        found = (_table_words(table) for table in duty.tables)
        words = " ".join(f"{text[0].upper()}{text[1:]}" for text in found)
        steps.append(Step("Tables", words))
    return steps


def _table_words(table: TableAdvice | None) -> str:
    if table is None:
        return f"{gear_oil.WORM_TABLE_SOURCE}: no row for this size, speed and temperature."
    if table.least or not table.grades:
        return f"{table.source}: {table.row}."
    grades = " or ".join(f"VG {grade}" for grade in table.grades)
    return f"{table.source}: {grades} ({table.row})."


def _speed_step(duty: OilDuty, velocity: float) -> Step:
    wanted, feet = (
        gear_oil.pitch_line_viscosity(velocity),
        velocity / gear_oil.FOOT_PER_MINUTE,
    )
    words = [
        f"At a pitch line velocity of {velocity:.3g} m/s ({feet:.0f} ft/min) the viscosity at "
        f"40 degC should be 7000/sqrt({feet:.0f}) = {wanted / SQUARE_MILLIMETRE:.0f} mm2/s; "
        f"nearest is VG {gear_oil.nearest_grade(wanted)}. The faster the teeth, "
        "the thinner the oil that still makes a film."
    ]
    teeth = duty.teeth
    if (
        teeth is not None
        and teeth.fast_shaft >= gear_oil.FAST_SHAFT
        and velocity <= gear_oil.FASTEST_250_04
    ):
        words.append(
            f"At {teeth.fast_shaft * RPM:.0f} rpm AGMA 421.06 counts the shaft as fast (VG "
            f"{gear_oil.GRADE_421_06} in Errichello's example, whose gears failed within weeks): the pitch "
            "line velocity decides, not the speed of the shaft."
        )
    return Step("Speed", " ".join(words), "Errichello, pitch line rule")


def additive_step(duty: OilDuty, teeth: GearTeeth, chosen: GradeRow) -> Step:
    """Additives for the materials of the teeth."""
    if not teeth.copper:
        if teeth.worm:
            return Step(
                "Additives",
                f"{teeth.wheel_material}: anti-wear and EP additives (sulphur-phosphorus) are safe.",
                "article on worm gear oils",
            )
        fast = teeth.velocity > gear_oil.FASTEST_250_04
        words = (
            "Fast and lightly loaded gears: rust and oxidation inhibitors (R&O) are enough, if the film "
            "separates the teeth."
            if fast and chosen.specific_film >= 1
            else "Slower, loaded gears: anti-scuff (EP) additives, by the contact temperature where known."
        )
        return Step("Additives", words, "Errichello, selecting lubricant type")
    low, high = COMPOUNDED
    hot = chosen.bulk_temperature > ACTIVE_SULPHUR
    material = teeth.wheel_material or "The wheel, taken for bronze"
    package = (
        f"mineral oil compounded with {low} to {high} % fatty oil, or mild additives"
        if duty.base == "mineral"
        else "anti-wear additives"
    )
    return Step(
        "Additives",
        f"{material}: {package} without active sulphur (copper strip 1 at 100 degC, ISO 2160), no hypoid "
        f"oil. Active sulphur attacks copper from about 70 degC; the teeth have "
        f"{chosen.bulk_temperature - ZERO_CELSIUS:.0f} degC{', so it would' if hot else ''}. The sources "
        "differ: Errichello compounds mineral oil, the article wants sulphur-phosphorus.",
        "Errichello; article on worm gear oils; ISO 2160",
    )


def cold_step(
    duty: OilDuty, teeth: GearTeeth, chosen: GradeRow, rows: tuple[GradeRow, ...]
) -> Step:
    """Torque of a cold start, and the grades with which the motor starts."""
    start = duty.coldest_start or duty.ambient_temperature
    oil = named_oil(f"{duty.base} VG {chosen.grade}")
    thick = float(oil.kinematic_viscosity(start)) / SQUARE_MILLIMETRE
    torque = chosen.start_torque or 0.0
    shaft = duty.no_load.shafts[0].name if duty.no_load else "fast shaft"
    share = 100 * torque / teeth.fast_torque
    pour = start - POUR_MARGIN - ZERO_CELSIUS
    words = [
        f"At {start - ZERO_CELSIUS:.0f} degC VG {chosen.grade} has {thick:.0f} mm2/s; at full speed bearings "
        f"and bath resist with {torque:.3g} N m at the {shaft}, {share:.2g} % of its "
        f"{teeth.fast_torque:.4g} N m under load. Its pour point should be {pour:.0f} degC or lower."
    ]
    if duty.motor_torque is not None:
        able = [
            row.grade
            for row in rows
            if row.start_torque is not None
            and row.start_torque + teeth.starting_torque <= duty.motor_torque
        ]
        most = f"VG {able[-1]} is the thickest that" if able else "no grade is thin enough that"
        words.append(
            f"With {duty.motor_torque:.4g} N m {most} the motor starts under load, which takes "
            f"{teeth.starting_torque:.4g} N m with the friction of teeth at rest."
        )
    return Step("Cold start", " ".join(words), no_load.SOURCE)


def life_step(duty: OilDuty, chosen: GradeRow) -> Step:
    """Life of the oil, when to change it, and what an analysis says."""
    reference = oil_life.REFERENCE_LIFE[duty.base]
    energy, sump = oil_life.ACTIVATION_ENERGY / 1e3, chosen.sump_temperature
    maker, hours = oil_life.maker_interval(duty.base, sump), duty.hours_per_year
    other = "none so hot" if maker is None else _hours(maker)
    words = [
        f"{reference:.0f} h at 80 degC and {energy:.0f} kJ/mol (halved by each 10 K) "
        f"make {_hours(chosen.oil_life)} at {sump - ZERO_CELSIUS:.0f} degC; another maker's table has "
        f"{other}. First change after {oil_life.FIRST_CHANGE:.0f} h"
    ]
    if hours is not None:
        interval = oil_life.change_interval(duty.base, sump, hours)
        words[0] += f", then every {_hours(interval)} or {oil_life.LONGEST_LIFE[duty.base]} years"
    words[0] += "."
    if duty.used_oil is not None:
        words.append(_analysis(duty.used_oil))
    return Step(
        "Life of the oil", " ".join(words), "Arrhenius; Flender BA 7300, Bonfiglioli, AGMA 9005-D94"
    )


def _analysis(used: oil_life.UsedOil) -> str:
    """What an analysis of used oil says."""
    acid = "" if used.acid_number is None else f", acid number {used.acid_number:.3g} mg KOH/g"
    life = "" if used.life is None else f"; at this rate it lasts {_hours(used.life)}"
    limits = f"{100 * oil_life.VISCOSITY_LIMIT:.0f} % and {oil_life.ACID_LIMIT:g}"
    return (
        f"Used oil after {_hours(used.operation / oil_life.HOUR)}: viscosity "
        f"{100 * used.thickening:+.1f} %{acid} (limits {limits}): {used.verdict}{life}."
    )


def _hours(hours: float) -> str:
    """Hours to three digits."""
    return f"{float(f'{hours:.3g}'):.0f} h"
