"""What the suite promises of random scenes, and what breaks the promise."""

import csv
from collections.abc import Sequence
from pathlib import Path

from draws import SEED
from trial import Verdict

COUNTS = {"isothermal": 500, "thermal": 150, "rough": 150, "past": 20, "starved": 100}
"""Random scenes of each kind."""

PROMISED = {"isothermal": 0.99, "thermal": 0.97, "rough": 0.97, "past": 0.95, "starved": 0.97}
"""Fraction of them that converges, of any seed."""

DRIVES = 100
"""Gear drives of a seed."""

PHASES, CYCLES, TIMES = 0.99, 0.97, 0.95
"""Promised fractions of gear drives: phases that converge, cycles with all of theirs, and runs whose expected
time is within a factor `TIME_FACTOR`."""

TIME_FACTOR = 2.0

LISTED = Path(__file__).parents[2] / "docs/evidence/data/hard_not_converged.csv"
"""Where each scene of the default seed that does not converge stands with its reason."""


def complaints(part: str, verdicts: Sequence[Verdict], seed: int = SEED) -> list[str]:
    """What breaks the promise in a part of the suite, a sentence each.

    Scenes of other seeds than the default are not listed anywhere: the promised fraction counts of those,
    and that none broke. The fraction is judged where all scenes of a kind were solved.
    """
    found = [f"{one.name} broke: {one.reason}" for one in verdicts if one.outcome == "broken"]
    if seed == SEED:
        with LISTED.open() as file:
            listed = {tuple(row[:2]) for row in csv.reader(file)}
        found += [
            f"{one.name} did not converge and is not listed in {LISTED.name}"
            for one in verdicts
            if one.outcome == "not converged" and (str(SEED), one.name) not in listed
        ]
    share = sum(one.outcome == "converged" for one in verdicts) / len(verdicts)
    if len(verdicts) == COUNTS.get(part) and share < PROMISED[part]:
        found.append(f"{share:.1%} of {part} scenes converged, {PROMISED[part]:.0%} are promised")
    return found
