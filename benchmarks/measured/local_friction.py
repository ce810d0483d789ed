"""Local friction along a worm's contact line, for the finding of a three-disc rig.

98FTM10 reports friction as largest where rolling runs along the contact line, and least at the outlet. From
the repository's root (half a minute of CPU):

    python benchmarks/measured/local_friction.py
"""

import sys
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import numpy as np

import pyworm

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

CASE = "cases/worm_drawing.toml"
PHASES = 0.2, 0.5, 0.8
PARTS = 5
"""Equal parts of the dry contact along its longer axis, x; oil enters at the first."""

COLUMNS = (
    "phase",
    "part of the line",
    "rolling across / speed",
    "asperity load ratio",
    "local friction",
)


def parts(phase: float) -> Iterator[tuple[object, ...]]:
    """Rows of a contact: part of its line, direction of rolling, load on asperities, friction."""
    scene = pyworm.load(CASE).scene(phase=phase)
    fields = pyworm.solve(scene, pyworm.plan(scene, 0.1, ("auto", "-squeeze"))).fields
    sliding = np.hypot(fields.sliding_x, fields.sliding_y)
    across = fields.entrainment_y / np.hypot(fields.entrainment_x, fields.entrainment_y)
    touched = fields.dry_pressure > 0
    along = fields.x.where(touched.any("y"), drop=True)
    ends = np.linspace(float(along.min()), float(along.max()), PARTS + 1)
    for number, (first, last) in enumerate(pairwise(ends), 1):
        inside = touched & (fields.x >= first) & (fields.x <= last)
        load = float(fields.pressure.where(inside).sum())
        asperities = float(fields.asperity_pressure.where(inside).sum())
        slid = float((fields.pressure * sliding).where(inside).sum())
        friction = float(fields.friction_power.where(inside).sum()) / slid
        rolling = float((across * fields.pressure).where(inside).sum()) / load
        yield (
            phase,
            f"{number} of {PARTS}",
            f"{rolling:+.2f}",
            f"{asperities / load:.0%}",
            f"{friction:.4f}",
        )


def main() -> None:
    record("measured_local_friction", COLUMNS, [row for phase in PHASES for row in parts(phase)])


if __name__ == "__main__":
    main()
