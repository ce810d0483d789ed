"""A running-in programme as a table, sentences and comma-separated values."""

from collections.abc import Iterator

from pyworm.batch.running_in import RunInSequence, RunningIn, state_summary
from pyworm.drives.gear_unit import HOUR
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.quantities import QUANTITIES
from pyworm.report.duty import as_csv
from pyworm.report.table import Table

SEQUENCES = "programme", "none"
"""Names of both sequences in tables and files."""


def stages_table(found: RunningIn) -> Table:
    """The end of each stage, and the largest temperatures in it."""
    first, second = found.bodies
    share = QUANTITIES["asperity_load_fraction"]
    head = (
        *("Stage", "Ended by", "h", "Oil\n°C", "Contact\n°C", share.column),
        *(f"{first}\nRq µm", f"{second}\nRq µm", "Wear\nµm"),
    )
    rows: list[tuple[str, ...]] = []
    for name, sequence in zip(SEQUENCES, (found.programme, found.none), strict=True):
        for stage, ended in zip(sequence.stages, sequence.ended_by, strict=True):
            states = sequence.of_stage(stage)
            last = states[-1]
            rows.append(
                (
                    f"{name}, {stage}",
                    ended,
                    f"{last.time / HOUR:.4g}",
                    f"{last.oil - ZERO_CELSIUS:.1f}",
                    f"{max(state.contact for state in states) - ZERO_CELSIUS:.1f}",
                    f"{100 * last.asperity_load_fraction:.1f}",
                    *(f"{rough * 1e6:.3f}" for rough in last.roughness),
                    f"{max(last.wear) * 1e6:.3g}",
                )
            )
    heading = f"Running-in of {found.name}, contacts by closed forms"
    return Table(head, tuple(rows), heading, texts=(1,), narrow=True)


def words(found: RunningIn) -> Iterator[str]:
    """When contacts are as hot as the oil bears."""
    limit = found.scuffing_temperature
    if limit is None:
        return
    for name, sequence in zip(SEQUENCES, (found.programme, found.none), strict=True):
        yield f"{name.capitalize()}: {_heated(sequence, limit)}."


def _heated(sequence: RunInSequence, limit: float) -> str:
    hot = [state for state in sequence.states if state.contact >= limit]
    shown = f"the scuffing temperature of {limit - ZERO_CELSIUS:.0f} °C"
    if not hot:
        return f"contacts stay below {shown}"
    return f"contacts reach {shown} after {hot[0].time / HOUR:.3g} h, in {hot[0].stage}"


def states_csv(found: RunningIn) -> str:
    """A row for each state of both sequences."""
    rows = []
    for name, sequence in zip(SEQUENCES, (found.programme, found.none), strict=True):
        for state in sequence.states:
            row = state_summary(state)
            roughness, wear = row.pop("roughness_m"), row.pop("wear_m")
            both = {
                f"{key}_{body}_m": value
                for key, values in (("roughness", roughness), ("wear", wear))
                for body, value in zip(found.bodies, values, strict=True)
            }
            rows.append({"sequence": name, **row, **both})
    return as_csv(rows)
