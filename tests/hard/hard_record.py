"""What the suite came to, as data of docs/evidence/hard-cases.md: one row for each drive, command or kind.

Rows of other drives, seeds and kinds stay; each has the commit that it was made with.
"""

import sys
from collections.abc import Sequence
from pathlib import Path

from drive_trial import Called, DriveTrial, DriveVerdict
from promise import PROMISED
from trial import Verdict

sys.path.append(str(Path(__file__).parents[2] / "benchmarks" / "evidence"))
from evidence_record import commit, record

DRIVE_COLUMNS = (
    "seed",
    "drive",
    "kind",
    "accuracy requested",
    "phases",
    "converged",
    "CPU time / s",
    "expected / s",
    "outcome",
    "reason",
    "commit",
)


def record_drives(verdicts: Sequence[DriveVerdict], seed: int) -> None:
    """Write runs of drives."""
    state = commit()
    rows = [
        (
            seed,
            one.name.partition(":")[2],
            one.kind,
            one.accuracy,
            one.phases,
            one.converged,
            f"{one.processor:.3g}",
            f"{one.expected:.3g}",
            one.outcome,
            one.reason,
            state,
        )
        for one in verdicts
    ]
    record("hard_drives", DRIVE_COLUMNS, rows, key=("seed", "drive", "accuracy requested"))


def record_walks(walks: Sequence[tuple[DriveTrial, Called]], seed: int) -> None:
    """Write commands that drives were walked through."""
    state = commit()
    rows = []
    for trial, done in walks:
        number = trial.name.partition(":")[2]
        name = "shim" if "--shim" in done.command else done.command.split()[0]
        kind, time = trial.drawn.traits["kind"], f"{done.processor:.0f}"
        rows.append((seed, number, kind, name, done.outcome, time, state))
    columns = "seed", "drive", "kind", "command", "outcome", "CPU time / s", "commit"
    record("hard_commands", columns, rows, key=("seed", "drive", "command"))


def record_contacts(kind: str, verdicts: Sequence[Verdict], seed: int) -> None:
    """Write how many contacts of a kind converged."""
    converged = sum(one.outcome == "converged" for one in verdicts)
    share = f"{converged / len(verdicts):.1%}".replace("%", " %")
    target = f"{PROMISED[kind]:.0%}".replace("%", " %")
    row = kind, seed, len(verdicts), converged, share, target, commit()
    columns = "kind", "seed", "solved", "converged", "share", "target", "commit"
    record("hard_contacts", columns, [row], key=("kind", "seed"))
