"""Measurements of `validation/` beside what pyworm computes: E, u_val, verdicts and a picture.

What has been computed is kept in results/measured/rows.csv for the next run, an experiment at a time, as long
as neither its inputs nor the committed program change. From the repository's root (half a minute of CPU):

    python benchmarks/measured/measured.py docs/pictures/measured.png
"""

import json
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from pathlib import Path
from statistics import median

from comparison_error import AGREES, MODEL, Comparison, Computed, share
from computed_rows import computed
from measured_picture import draw

from pyworm.case.experiment import ExperimentTable, RowTable, read_experiments

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_data import ROOT
from evidence_record import record
from kept_rows import keep_rows, kept_rows

FOLDER = ROOT / "validation"
KEPT = ROOT / "results/measured/rows.csv"
TEXTS = ("key", "inputs")

OIL_QUANTITIES = {
    "pressure_viscosity": "pressure-viscosity coefficient",
    "viscosity": "viscosity",
    "viscosity_rise": "ln(viscosity / ambient), 1 GPa",
    "density": "density",
    "limiting_coefficient": "limiting stress / pressure",
}
CONTACT_QUANTITIES = {
    "film": "film thickness",
    "film_exit_min": "film thickness",
    "friction_of_mesh": "friction coefficient",
    "efficiency": "efficiency",
    "efficiency_at_rest": "efficiency",
}
LABELS = CONTACT_QUANTITIES | OIL_QUANTITIES
"""Quantity of a row -> what it is called; properties of oils after figures of contacts."""

UNITS = {
    "film thickness": (1e-9, "nm"),
    "pressure-viscosity coefficient": (1e-9, "1/GPa"),
    "viscosity": (1e-3, "mPa s"),
    "density": (1.0, "kg/m3"),
}
"""Quantity -> its unit in the table in SI, and that; others have none."""

COLUMNS = (
    "source", "row", "quantity", "series", "measured", "computed", "E", "u_val", "u_D", "u_num", "u_input",
    "largest input", "model uncertainty", "verdict",
)  # fmt: skip


@dataclass(frozen=True)
class Compared:
    """A row of an experiment with its comparison."""

    experiment: ExperimentTable
    """Where it is from."""
    row: RowTable
    """Measured value."""
    comparison: Comparison
    """E and u_val."""

    @property
    def quantity(self) -> str:
        """What was measured."""
        return LABELS[self.row.quantity]

    @property
    def source(self) -> str:
        """Author and, where it is known, year."""
        source = self.experiment.source
        return source.author if source.year is None else f"{source.author} {source.year}"

    def cells(self) -> tuple[str, ...]:
        """The row of the table; errors and uncertainties in per cent of the measured value."""
        compared, found = self.comparison, self.comparison.computed
        unit, name = UNITS.get(self.quantity, (1.0, ""))
        parts = (compared.uncertainty, compared.measurement, found.numerical, found.by_inputs)
        return (
            self.source,
            self.row.label,
            self.quantity,
            f"{self.source}: {self.quantity}",
            f"{compared.measured / unit:.4g} {name}".rstrip(),
            f"{found.value / unit:.4g} {name}".rstrip(),
            f"{compared.error / compared.measured * 100:+.1f} %",
            *(f"{part / compared.measured * 100:.1f} %" for part in parts),
            found.largest_input,
            f"{found.model / compared.measured * 100:.0f} %" if found.model else "",
            compared.verdict,
        )


def compared() -> Iterator[Compared]:
    """All rows of all experiments, those kept without computing them anew."""
    kept = {row["key"]: row for row in kept_rows(KEPT, TEXTS)}
    for name, experiment in read_experiments(FOLDER).items():
        keys = [_key(name, experiment, number) for number in range(len(experiment.rows))]
        if not all(key in kept for key in keys):
            for key, (row, found) in zip(keys, computed(experiment, FOLDER), strict=True):
                kept[key] = _as_kept(key, found)
                print(f"{name}: {row.label}: {found.value:.4g}", flush=True)
            keep_rows(KEPT, list(kept.values()))
        for key, row in zip(keys, experiment.rows, strict=True):
            measured = experiment.measured(row)
            found = _found(kept[key])
            yield Compared(experiment, row, Comparison(found, measured.value, measured.standard))


def _key(name: str, experiment: ExperimentTable, number: int) -> str:
    """What a computed row depends on: the program, the case and the experiment less its measurements."""
    case = experiment.case
    read = (FOLDER / case).read_text() if isinstance(case, str) else ""
    told = experiment.model_dump_json(exclude={"title", "measurement", "reading", "source"}) + read
    return f"{name} {number} {_program()} {sha256(told.encode()).hexdigest()[:16]}"


@cache
def _program() -> str:
    """The committed package and kernel as one word."""
    trees = ["git", "rev-parse", "HEAD:pyworm", "HEAD:fortran"]
    done = subprocess.run(trees, cwd=ROOT, capture_output=True, text=True, check=True)
    return sha256(done.stdout.encode()).hexdigest()[:8]


def _as_kept(key: str, found: Computed) -> dict:
    parts = {"value": found.value, "numerical": found.numerical, "model": found.model}
    return {"key": key, **parts, "inputs": json.dumps(dict(found.inputs))}


def _found(kept: dict) -> Computed:
    return Computed(kept["value"], kept["numerical"], kept["model"], json.loads(kept["inputs"]))


def summary(rows: list[Compared]) -> Iterator[tuple[object, ...]]:
    """Rows, sources, shares and the median error of each quantity, then of contacts, oils and all."""
    for label in dict.fromkeys(LABELS.values()):
        yield _summed(label, [row for row in rows if row.quantity == label])
    for label, names in (("all of contacts", CONTACT_QUANTITIES), ("all of oils", OIL_QUANTITIES)):
        yield _summed(label, [row for row in rows if row.row.quantity in names])
    yield _summed("all", rows)


def _summed(label: str, rows: list[Compared]) -> tuple[object, ...]:
    verdicts = [row.comparison.verdict for row in rows]
    errors = [row.comparison.error / row.comparison.measured for row in rows]
    return (
        label,
        len(rows),
        len({row.source for row in rows}),
        f"{share(verdicts, AGREES):.0%}",
        f"{share(verdicts, AGREES, MODEL):.0%}",
        f"{median(errors) * 100:+.1f} %",
    )


def main() -> None:
    rows = list(compared())
    record("measured", COLUMNS, [row.cells() for row in rows])
    columns = (
        "quantity",
        "rows",
        "sources",
        "within u_val",
        "or the model's uncertainty",
        "median E",
    )
    record("measured_shares", columns, summary(rows))
    draw(rows).savefig(Path(sys.argv[1]), dpi=120)


if __name__ == "__main__":
    main()
