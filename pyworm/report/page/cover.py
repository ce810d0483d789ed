"""The two pages to sign: verdicts; and what they rest on: figures, flanks, life, assumptions."""

from datetime import datetime

from pydantic import BaseModel

from pyworm.case.case import Case
from pyworm.case.workshop_units import as_text
from pyworm.io.quantities import QUANTITIES
from pyworm.ratings.rating import Safety
from pyworm.report.console.drive import described_row
from pyworm.report.findings import Findings
from pyworm.report.page.assumptions import assumptions_of
from pyworm.report.page.content import Cover, Judged, Overleaf, Picture
from pyworm.report.page.figures import key_result_rows, life_rows
from pyworm.report.page.symbols import inputs_as_text, named
from pyworm.report.table import Table
from pyworm.result.result import Result

Identity = tuple[tuple[str, str], ...]


def named_safety(safety: Safety) -> str:
    """A safety by its symbol and its name."""
    return f"{named(safety.symbol)}, {safety.label}"


def judged(safety: Safety, value: str) -> Judged:
    """A value with the verdict on a safety."""
    return Judged(value, safety.verdict + (", uncertain" if safety.open else ""))


def cover_of(found: Findings, identity: Identity) -> Cover | None:
    """The page to sign; None without safeties.

    Args:
        found: The findings of the report.
        identity: What it names besides the case: drawing, customer.
    """
    safeties = [safety for rating in found.ratings for safety in rating.safeties]
    if not safeties:
        return None
    head = (("Case", found.result.case_name), *identity, *_operation(found.case))
    head += _computed(found.result)
    doubts = (f"{named_safety(safety)}: {doubt}" for safety in safeties for doubt in safety.doubts)
    basis = (sentence for rating in found.ratings for sentence in (*rating.differs, *rating.basis))
    return Cover(
        head,
        tuple(dict.fromkeys(basis)),
        _geometry(found.case),
        Table(
            ("Safety factor", "Value", "Required", "Verdict", "By", "Inputs"),
            tuple(map(_signed_row, safeties)),
        ),
        tuple(dict.fromkeys(doubts)),
    )


def _signed_row(safety: Safety) -> tuple[str, ...]:
    """A safety as it is signed."""
    value, required = safety.shown, f"{safety.minimum:g}"
    verdict, inputs = judged(safety, ""), inputs_as_text(safety)
    return named_safety(safety), value, required, verdict, safety.clause, inputs


def _geometry(case: Case) -> Identity:
    """Computed geometry of a drive's gears in workshop units."""
    computed = {} if case.drive is None else case.drive.geometry()
    return tuple(described_row(key, value) for key, value in computed.items())


def _operation(case: Case) -> Identity:
    """Size, operating point and oil of a drive."""
    tables = case.tables
    apart = _of(tables.drive, "centre_distance")
    found = [("Drive", f"{tables.drive.kind}, centre distance {apart}")]
    operation = type(tables.operation).model_fields
    running = [
        f"{name.replace('_', ' ')} {_of(tables.operation, name)}"
        for name in operation
        if name.endswith(("_speed", "_torque")) or name == "power"
        if getattr(tables.operation, name) is not None
    ]
    found.append(("Operating point", ", ".join(running)))
    heat = tables.oil.heat
    inlet = QUANTITIES["inlet_temperature"]
    warm = "" if heat is None else f", {inlet.text(heat.inlet_temperature)}"
    return (*found, ("Oil", f"{tables.oil.name}{warm}"))


def _of(table: BaseModel, name: str) -> str:
    return as_text(getattr(table, name), type(table).model_fields[name])


def _computed(result: Result) -> Identity:
    """Version and time of the computation."""
    known = result.provenance
    if "pyworm" not in known:
        return ()
    commit = f" ({known['commit'][:9]})" if "commit" in known else ""
    computed = (("Computed with", f"pyworm {known['pyworm']}{commit}"),)
    if "created" not in known:
        return computed
    when = datetime.fromisoformat(str(known["created"]))
    return (*computed, ("Computed on", f"{when:%d %B %Y, %H:%M} UTC"))


def overleaf_of(found: Findings, pictures: tuple[Picture | str, ...]) -> Overleaf:
    """The page behind the page to sign."""
    assumed = assumptions_of(found)
    drive = found.case.drive
    usual = () if drive is None else drive.usual_values
    decisive = tuple(sentence for sentence in assumed if sentence not in usual)
    more = len(assumed) - len(decisive)
    if more:
        decisive += (
            f'{more} dimensions assumed by common practice, listed under "What was assumed".',
        )
    rows = (*key_result_rows(found), *life_rows(found.case, found.ratings))
    return Overleaf(Table(("", "Value", "Where"), rows), pictures, decisive)
