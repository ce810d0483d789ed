"""Inputs of a case, in workshop units, and assumptions of its result: effects left out, those of a drive."""

from collections.abc import Sequence
from typing import Any

from pydantic import BaseModel

from pyworm.case.case import Case
from pyworm.case.workshop_units import as_text, assumptions
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.quantity_text import duration
from pyworm.planning.effects.judgement import Judgement
from pyworm.report.console.scenes import influence_percent
from pyworm.report.findings import Findings
from pyworm.report.page.content import Section
from pyworm.report.page.figures import place_of
from pyworm.report.table import Table
from pyworm.result.result import Result
from pyworm.solver.solution import Solution

ONE_CONTACT = "One contact, with the curvature, velocities and load given."
"""What is assumed of a contact without a drive."""


def plan_section(result: Result) -> Section | None:
    """Effects simulated and reasons, once for all contacts that agree; None where none is recorded."""
    solutions = [solution for solution in result.solutions if solution.effects]
    if not solutions:
        return None
    rows = []
    for effects in zip(*(solution.effects for solution in solutions), strict=True):
        on = [
            place_of(solution)
            for solution, effect in zip(solutions, effects, strict=True)
            if effect.on
        ]
        where = "on" if len(on) == len(solutions) else f"on at {', '.join(on)}" if on else "off"
        rows.append((effects[0].name, where, _reason(solutions, effects), _influence(effects)))
    words = (
        "Influence is the largest that leaving the effect out would have on the requested quantities, at any "
        "contact, judged by the solutions."
    )
    wanted = {plan["accuracy"] for plan in result.provenance.get("plans", ())}
    asked = " and ".join(f"{fraction * 100:g} %" for fraction in sorted(wanted))
    table = Table(("Effect", "", "Reason", "Influence"), tuple(rows), note=words)
    return Section(f"Effects simulated and neglected (requested accuracy: {asked})", (table,))


def _reason(solutions: Sequence[Solution], effects: Sequence[Judgement]) -> str:
    """Why an effect is on or off; where contacts differ, that of the one where it counts most."""
    if len({effect.reason for effect in effects}) == 1:
        return effects[0].reason
    weights = [max(effect.influence.values(), default=0.0) for effect in effects]
    most = weights.index(max(weights))
    return f"{effects[most].reason} at {place_of(solutions[most])}"


def _influence(effects: Sequence[Judgement]) -> str:
    """Largest influence on each quantity over the contacts."""
    largest: dict[str, float] = {}
    for effect in effects:
        for quantity, fraction in effect.influence.items():
            largest[quantity] = max(fraction, largest.get(quantity, 0.0))
    return ", ".join(f"{name} {influence_percent(fraction)}" for name, fraction in largest.items())


def _of_contacts(case: Case) -> list[str]:
    """Assumptions about the contacts themselves and the oil that they get."""
    if case.drive is not None:
        return list(case.drive.all_assumptions)
    known = case.tables.oil.supply is not None
    return [ONE_CONTACT, *(() if known else ("Fully flooded inlet: oil.supply is not given.",))]


def assumptions_of(found: Findings) -> tuple[str, ...]:
    """Assumptions: values that the source does not give, and those of the models."""
    case, result = found.case, found.result
    items = [f"{what}: {why}." for what, why in assumptions(case.tables).items()]
    on = {effect.name for solution in result.solutions for effect in solution.effects if effect.on}
    if "roughness" not in on:
        items.append("Smooth surfaces.")
    elif any(table.nesting_index is not None for table in case.tables.bodies.surfaces.values()):
        items.append(
            "Waves longer than the nesting index rest in the gap where they rest in the contact; those that "
            "roll through a steady film are in the model uncertainty."
        )
    if "squeeze" not in on:
        items.append("A steady film (the table of effects estimates the influence of squeeze).")
    else:
        items.append(
            "A transient solution begins with a steady film; its heat is that of a steady contact "
            "at each time."
        )
    items += _of_contacts(case)
    inlet = {
        solution.inlet_temperature
        for solution in result.solutions
        if solution.inlet_temperature is not None
    }
    if inlet:
        balanced = getattr(case.tables, "cooling", None) is not None
        drive = case.drive if balanced else None
        solids = [body for _, body in case.tables.bodies] if drive is None else drive.bodies
        bodies = {
            name: body.bulk_temperature or min(inlet)
            for (name, _), body in zip(case.tables.bodies, solids, strict=True)
        }
        warm = ", ".join(
            f"{name} {temperature - ZERO_CELSIUS:.4g} °C" for name, temperature in bodies.items()
        )
        how = "found from losses and [cooling]" if balanced else "given, not found"
        items.append(
            f"Oil enters at {min(inlet) - ZERO_CELSIUS:.4g} °C; bulk temperatures {how}: {warm}."
        )
    return tuple(items)


def assumptions_section(found: Findings) -> Section:
    """The assumptions under their heading."""
    return Section("What was assumed", (assumptions_of(found),))


PROVENANCE = (
    *("pyworm", "commit", "kernel_digest", "compiler", "compiler_flags"),
    *("python", "numpy", "machine", "created"),
)
"""Keys of the provenance in a report, in this order."""


def provenance_section(result: Result) -> Section:
    """Versions, time and cost, for repeating the run."""
    provenance = result.provenance
    rows = [
        (key.replace("_", " "), str(provenance[key])) for key in PROVENANCE if key in provenance
    ]
    rows.append(("case", result.case_name))
    rows += [
        (
            place_of(solution),
            f"{' x '.join(str(count) for count in solution.summary()['grid'])} nodes, "
            f"{duration(solution.cost.seconds)}; {solution.stop_reason}",
        )
        for solution in result.solutions
    ]
    rows += [
        (name, f"not solved: {reason}") for name, reason in provenance.get("failed", {}).items()
    ]
    return Section("Provenance", (Table(("", ""), tuple(rows)),))


_ELSEWHERE = {"title", "source", "published", "assumed", "accuracy", "effects", "quantities"}
"""Keys of case files that other sections of the report show."""

_FIRST = ("operation", "drive", "contact", "motion", "surfaces", "bodies", "oil")
"""Tables that come first, in this order."""


def inputs_section(case: Case) -> Section:
    """Every value of the case but its names and comparisons, defaults included."""
    tables = []
    fields = type(case.tables).model_fields
    for name in dict.fromkeys([*(name for name in _FIRST if name in fields), *fields]):
        field = fields[name]
        part = getattr(case.tables, name)
        if name not in _ELSEWHERE and part is not None:
            tables += _tables(name, part, field)
    return Section("Inputs", tuple(tables))


def _tables(name: str, part: Any, field: Any = None) -> list[Table]:
    """A table of the values at hand, and one for each table inside."""
    if isinstance(part, dict):
        return [table for key, value in part.items() for table in _tables(f"{name}.{key}", value)]
    if not isinstance(part, BaseModel):
        return [Table(("", ""), ((_label(name), as_text(part, field)),))]
    rows, inner = [], []
    for key, entry in type(part).model_fields.items():
        value = getattr(part, key)
        if isinstance(value, BaseModel | dict):
            inner += _tables(f"{name}.{key}", value)
        elif value is not None:
            rows.append((_label(key), as_text(value, entry)))
    tables = [Table(("", ""), tuple(rows), title=_label(name.replace(".", ": ")))] if rows else []
    return tables + inner


def _label(key: str) -> str:
    words = key.replace("_", " ").replace("youngs", "Young's").replace("poisson", "Poisson's")
    return words[0].upper() + words[1:]
