"""What a result takes for granted: the effects left out, and what its drive assumes."""

from collections.abc import Mapping
from typing import Any

from pyworm.case import Case
from pyworm.drives.gear_pair import GearPairDrive
from pyworm.drives.zi_worm import ZiWormDrive
from pyworm.report.content import Block, Items, Section, Table
from pyworm.report.figures import place_of
from pyworm.result import Result
from pyworm.solution import ZERO_CELSIUS


def plan_section(result: Result) -> Section | None:
    """Which effects were simulated and why, once for all contacts that agree; None where none is told."""
    tables: dict[tuple, list[str]] = {}
    plans = result.provenance.get("plans", ())
    for solution, plan in zip(result.solutions, plans, strict=False):
        rows = tuple(
            (effect["name"], "on" if effect["on"] else "off", _judged(effect))
            for effect in plan["effects"]
        )
        tables.setdefault(rows, []).append(place_of(solution))
    if not tables:
        return None
    blocks: list[Block] = [
        Table(
            ("Effect", "", "Reason"),
            rows,
            title="" if len(tables) == 1 else f"At {'; '.join(places)}",
        )
        for rows, places in tables.items()
    ]
    wanted = plans[0]["accuracy"]
    heading = f"Effects simulated and left out (accuracy asked for: {wanted * 100:g} %)"
    return Section(heading, tuple(blocks))


def _judged(effect: Mapping[str, Any]) -> str:
    """Reason, and what leaving the effect out would change where that was estimated."""
    influence = effect.get("influence") or {}
    parts = [f"{name} {share * 100:.2g} %" for name, share in influence.items() if share]
    return effect["reason"] + (f"; influence: {', '.join(parts)}" if parts else "")


def assumptions_section(case: Case, result: Result) -> Section:
    """What was assumed, said by the models; assumed numbers are marked in the case file."""
    items = [
        "Numbers of the inputs that the source does not give are marked as assumed in the case file.",
        "Smooth flanks, an inlet full of oil, and at each phase a film that has had time to settle.",
    ]
    items += _drive_items(case)
    inlet = {of.inlet_temperature for of in result.solutions if of.inlet_temperature is not None}
    if inlet:
        bodies = {name: body.bulk_temperature or min(inlet) for name, body in case.tables.bodies}
        warm = ", ".join(f"{name} {of - ZERO_CELSIUS:.4g} °C" for name, of in bodies.items())
        items.append(
            f"Oil enters at {min(inlet) - ZERO_CELSIUS:.4g} °C; bulk temperatures given, not found: {warm}."
        )
    return Section("What was assumed", (Items(tuple(items)),))


def _drive_items(case: Case) -> list[str]:
    drive = case.drive
    if isinstance(drive, ZiWormDrive):
        return [
            f"The load on the tooth, {drive.load / 1e3:.4g} kN, is given and the same at every phase; "
            "it is not shared among teeth.",
            "Contacts are those of the unloaded mesh: shafts, bearings and teeth do not bend, but for the "
            "contact itself.",
        ]
    if isinstance(drive, GearPairDrive):
        return [
            f"Load sharing by the rule '{drive.load_sharing}'; load factor {drive.load_factor:g}.",
            "Shafts and teeth do not bend, but for the contact itself; no dynamic loads but by the load "
            "factor.",
        ]
    return ["One contact, with the curvature, velocities and load given."]


def provenance_section(result: Result) -> Section:
    """Versions, time, cost: what is needed to repeat the run."""
    said = result.provenance
    rows = [
        (key, str(said[key]))
        for key in ("pyworm", "python", "numpy", "machine", "created")
        if key in said
    ]
    rows.append(("case", result.case_name))
    rows += [
        (
            place_of(of),
            f"{' x '.join(str(count) for count in of.summary()['grid'])} nodes, "
            f"{of.cost.seconds:.3g} s; {of.stop_reason}",
        )
        for of in result.solutions
    ]
    rows += [(name, f"not solved: {reason}") for name, reason in said.get("failed", {}).items()]
    return Section("Provenance", (Table(("", ""), tuple(rows)),))
