"""Choice of the grade of oil for a gear drive, backwards from the specific film, in steps.

A pure function of plain numbers: whoever calls it takes them from a case, from a simulation or from a
drawing.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from textwrap import fill

from pyworm.formulas import scuffing, wear_distress
from pyworm.formulas.bearing_life import reference_viscosity
from pyworm.formulas.gear_oil import ISO_GRADES, withdrawn
from pyworm.formulas.lubricant_type import LubricantKind
from pyworm.formulas.lubrication import BOUNDARY
from pyworm.formulas.unit_factors import SQUARE_MILLIMETRE, ZERO_CELSIUS
from pyworm.io.present import present
from pyworm.materials.library import named_oil, oil_from_index
from pyworm.ratings.oil_grades import (
    THICKEST,
    GradeRow,
    OilDuty,
    grade_row,
    least_grade,
    past_practice,
    viscosity_needed,
)
from pyworm.ratings.oil_reasons import (
    POUR_MARGIN,
    Step,
    additive_step,
    chosen_type,
    cold_step,
    life_step,
    practice_steps,
    type_step,
)

PAGE_WIDTH = 100
"""Letters in a line of the page."""


@dataclass(frozen=True)
class OilChoice:
    """A recommended grade and how it was found."""

    duty: OilDuty
    """What was asked."""
    grade: int
    """The recommended ISO viscosity grade."""
    oil: str
    """The oil's name."""
    lubricant: LubricantKind | None
    """Type of lubricant; None where none suits, or that is not looked at."""
    reached: bool
    """Whether it gives the wanted specific film."""
    viscosity_needed: float | None
    """Viscosity at 40 degC [m2/s] that would give it at the temperature of reference, if any does."""
    rows: tuple[GradeRow, ...]
    """Every grade."""
    steps: tuple[Step, ...]
    """In the order of the reasoning, the recommendation last."""


def choose_oil(duty: OilDuty) -> OilChoice:
    """Choose a grade.

    The thinnest grade whose film is the wanted one in balance with its own churning, but none thinner
    than practice allows and none that overheats the sump. Where no grade gives the film, the thickest
    that practice recommends: the film is then not the oil's to mend.

    ValueError for numbers outside the formulas, or a sump that every grade overheats.
    """
    rows = tuple(grade_row(duty, grade) for grade in ISO_GRADES)
    cool = [row for row in rows if row.sump_temperature <= duty.sump_limit]
    if not cool:
        raise ValueError(
            f"limit of the sump temperature = {duty.sump_limit:g} K: exceeded by every grade, "
            f"{rows[0].sump_temperature:.0f} K with VG {rows[0].grade}; cool the sump"
        )
    practice, least = past_practice(duty), least_grade(duty)
    needed = viscosity_needed(duty)
    thick_enough = [row for row in cool if row.specific_film >= duty.specific_film]
    if thick_enough:
        wanted = [row for row in thick_enough if row.grade >= least]
        chosen = wanted[0] if wanted else thick_enough[-1]
    else:
        most = max([*practice, least]) if practice else ISO_GRADES[-1]
        chosen = [row for row in cool if row.grade <= most or row is cool[0]][-1]
    steps = tuple(_steps(duty, rows, chosen, practice, needed, cool))
    return OilChoice(
        duty=duty,
        grade=chosen.grade,
        oil=f"{duty.base} VG {chosen.grade}",
        lubricant=chosen_type(duty),
        reached=chosen.specific_film >= duty.specific_film,
        viscosity_needed=needed,
        rows=rows,
        steps=steps,
    )


def _steps(
    duty: OilDuty,
    rows: tuple[GradeRow, ...],
    chosen: GradeRow,
    practice: list[int],
    needed: float | None,
    cool: list[GradeRow],
) -> Iterator[Step]:
    """All steps in the order of the reasoning."""
    teeth = duty.teeth
    if teeth is not None:
        yield type_step(duty, teeth)
    yield from practice_steps(duty)
    yield _film_step(duty)
    yield _backwards_step(duty, needed)
    yield _balance_step(duty, rows, chosen)
    if duty.bearing_speed is not None:
        yield _bearing_step(duty, chosen)
    if duty.contact_temperature is not None:
        yield _scuffing_step(duty, chosen)
    if teeth is not None:
        yield additive_step(duty, teeth, chosen)
        if duty.coldest_start is not None:
            yield cold_step(duty, teeth, chosen, rows)
    yield life_step(duty, chosen)
    yield _recommendation(duty, chosen, practice, cool)


def page(choice: OilChoice) -> str:
    """The choice as one page of plain text."""
    lines = [f"Oil for {choice.duty.name}", ""]
    for number, step in enumerate(choice.steps, 1):
        source = f" ({step.source})" if step.source else ""
        lines.append(fill(f"{number}. {step.title}{source}", PAGE_WIDTH, subsequent_indent="   "))
        lines.append(fill(step.text, PAGE_WIDTH, initial_indent="   ", subsequent_indent="   "))
        if step.table:
            lines += ["", *(f"   {line}" for line in step.table)]
        lines.append("")
    return "\n".join(lines[:-1]) + "\n"


def _film_step(duty: OilDuty) -> Step:
    wanted = duty.specific_film * duty.roughness
    return Step(
        "Required film thickness",
        f"lambda = {duty.specific_film:g} over a composite roughness of {duty.roughness * 1e6:.3g} um "
        f"requires a minimum film thickness of {wanted * 1e6:.3g} um. Below 1 the teeth rest on their "
        "roughness, from 3 on the film keeps them apart.",
    )


def _backwards_step(duty: OilDuty, needed: float | None) -> Step:
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
            f"{given} no oil up to {THICKEST / SQUARE_MILLIMETRE:.0f} mm2/s at 40 degC makes this film.",
            duty.film.source,
        )
    oil = oil_from_index("", duty.base, needed, index)
    hot = oil.kinematic_viscosity(bulk) / SQUARE_MILLIMETRE
    alpha = duty.film.alpha_of(oil, bulk) * 1e9
    millimetres = needed / SQUARE_MILLIMETRE
    beyond = ", thicker than any gear oil" if millimetres > 1.1 * ISO_GRADES[-1] else ""
    return Step(
        title,
        f"{given} the film needs {hot:.3g} mm2/s or {oil.viscosity(bulk) * 1e3:.3g} mPa s on the teeth "
        f"(alpha = {alpha:.3g} 1/GPa), which is {millimetres:.0f} mm2/s at 40 degC{beyond}.",
        duty.film.source,
    )


def _balance_step(duty: OilDuty, rows: tuple[GradeRow, ...], chosen: GradeRow) -> Step:
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


_COLUMNS: tuple[tuple[str, str, Callable[[GradeRow], float | None], str], ...] = (
    ("sump", "degC", lambda row: row.sump_temperature - ZERO_CELSIUS, "5.0f"),
    ("teeth", "degC", lambda row: row.bulk_temperature - ZERO_CELSIUS, "5.0f"),
    ("teeth", "mm2/s", lambda row: row.viscosity / SQUARE_MILLIMETRE, "6.1f"),
    ("film", "um", lambda row: row.film * 1e6, "6.3f"),
    ("lambda", "", lambda row: row.specific_film, "6.3f"),
    ("heat", "", lambda row: row.heat, "5.2f"),
    ("kappa", "", lambda row: row.kappa, "5.2f"),
    ("loss", "W", lambda row: row.loss, "6.0f"),
    ("energy", "/year", lambda row: row.energy_cost, "6.0f"),
    ("oil", "h", lambda row: float(f"{row.oil_life:.2g}"), "7.0f"),
    ("start", "N m", lambda row: row.start_torque, "6.1f"),
)
"""Heading, unit, number and format of each column of the table of grades."""


def _table(rows: tuple[GradeRow, ...], chosen: GradeRow) -> tuple[str, ...]:
    """One line a grade, with the columns that are known."""
    columns = [column for column in _COLUMNS if column[2](rows[0]) is not None]
    widths = [max(len(head), len(unit), int(form.split(".")[0])) for head, unit, _, form in columns]
    heads = (
        "  ".join(
            [
                "VG  ",
                *(
                    f"{column[part]:>{width}}"
                    for column, width in zip(columns, widths, strict=True)
                ),
            ]
        )
        for part in (0, 1)
    )
    lines = [next(heads), "    " + next(heads)[4:]]
    for row in rows:
        cells = (
            f"{format(column[2](row), column[3]):>{width}}"
            for column, width in zip(columns, widths, strict=True)
        )
        lines.append("  ".join([f"{row.grade:<4d}", *cells]) + ("  <-" if row is chosen else ""))
    return tuple(lines)


def _bearing_step(duty: OilDuty, chosen: GradeRow) -> Step:
    speed, diameter, kappa = (
        present(duty.bearing_speed, "bearing_speed"),
        present(duty.bearing_diameter, "bearing_diameter"),
        present(chosen.kappa, "kappa"),
    )
    wanted = reference_viscosity(speed, diameter) / SQUARE_MILLIMETRE
    good = kappa >= 1
    return Step(
        "Bearings",
        f"The bearing requires {wanted:.1f} mm2/s; with VG {chosen.grade} at "
        f"{_celsius(chosen.sump_temperature)} kappa = {kappa:.2f}, "
        + ("which is enough." if good else "below 1: it loses life to thin oil."),
        "ISO 281:2007",
    )


def _scuffing_step(duty: OilDuty, chosen: GradeRow) -> Step:
    contact = present(duty.contact_temperature, "contact_temperature")
    texts = []
    for anti_scuff, words in ((False, "without"), (True, "with")):
        limit = float(scuffing.scuffing_temperature(chosen.grade * SQUARE_MILLIMETRE, anti_scuff))
        probability = float(scuffing.scuffing_probability(contact, limit))
        texts.append(
            f"{_celsius(limit)} {words} anti-scuff additives (probability {_percent(probability)}, "
            f"{scuffing.risk(probability)})"
        )
    limits = "The formula is for mineral oils. " if duty.base != "mineral" else ""
    return Step(
        "Scuffing",
        f"The teeth reach {_celsius(contact)} in contact; VG {chosen.grade} scuffs at {texts[0]} "
        f"and at {texts[1]}. {limits}".strip(),
        f"{scuffing.SOURCE}; {withdrawn('AGMA 2001-B88')}",
    )


def _recommendation(
    duty: OilDuty, chosen: GradeRow, practice: list[int], cool: list[GradeRow]
) -> Step:
    words = [
        f"{duty.base} VG {chosen.grade}: film {chosen.film * 1e6:.3g} um, lambda {chosen.specific_film:.2g} "
        f"({wear_distress.regime(chosen.specific_film)}), sump {_celsius(chosen.sump_temperature)}."
    ]
    if chosen.specific_film >= duty.specific_film:
        thinner = [row for row in cool if row.grade < chosen.grade]
        if not thinner or thinner[-1].specific_film < duty.specific_film:
            words.append(
                "It is the thinnest grade that gives the required film; a thicker one only churns more."
            )
        else:
            words.append(
                "A thinner grade would give the required film, but not what practice asks for."
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
    if duty.coldest_start is not None and duty.teeth is None:
        words.append(
            f"Its pour point should be {_celsius(duty.coldest_start - POUR_MARGIN)} or lower."
        )
    return Step("Recommendation", " ".join(words))


def _celsius(kelvin: float) -> str:
    return f"{kelvin - ZERO_CELSIUS:.0f} degC"


def _percent(probability: float) -> str:
    if probability < 0.01:
        return "below 1 %"
    return "above 99 %" if probability > 0.99 else f"{probability * 100:.0f} %"
