"""What the gap of a worm drive's flanks costs on 257 x 257 nodes, by profile.

    python benchmarks/cost/worm_gaps.py

Processor time of `ToothGap`, heights of both flanks and tooth boundaries included, of the drive of
`benchmarks/validation/worm_profiles.py` (a = 100 mm, 2/39): in a window within the teeth in mid-mesh, and in
the windows that its films have at three phases, parts of which lie beyond the ends of the flanks. Profiles
take turns; the least of `TURNS` counts. Beside it the ratio to ZI, whose flanks are closed forms, and the
part of the nodes that both teeth cover.
"""

import sys
import tomllib
from pathlib import Path
from time import process_time

import numpy as np

import pyworm
from pyworm.case.case import Case, case_of
from pyworm.drives.worm.flanks.worm_profiles import PROFILES

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

NODES, TURNS = 257, 7

WITHIN = 6e-3, 1e-3
"""Half sides of the window within the teeth [m]."""

PHASES = 0.1, 0.5, 0.9

CASE = Path(__file__).parents[2] / "cases/worm_drawing.toml"

SIZE = (("teeth = 41", "teeth = 39"), ("diameter_factor = 10", "diameter_factor = 9.5"))
"""The shipped drawing's numbers, and those with the profile shift that concave worms need."""

Sides = tuple[np.ndarray, np.ndarray]


def drive_of(profile: str) -> Case:
    """The drive with flanks of a profile."""
    text = CASE.read_text().replace('"ZI"', f'"{profile}"')
    for old, new in SIZE:
        text = text.replace(old, new)
    return case_of(tomllib.loads(text), profile, CASE.parent)


def windows(case: Case) -> dict[str, tuple[float, Sides]]:
    """Words for a window -> the phase and the nodes along both sides [m]."""
    within = tuple(np.linspace(-half, half, NODES) for half in WITHIN)
    found = {"within the teeth": (0.5, within)}
    for phase in PHASES:
        grid = pyworm.plan(case.scene(phase=phase)).grids[-1]
        sides = tuple(np.linspace(nodes[0], nodes[-1], NODES) for nodes in (grid.x, grid.y))
        found[f"film at phase {phase:g}"] = phase, sides
    return found


def seconds(case: Case, phase: float, sides: Sides) -> tuple[float, float]:
    """Processor time of one gap [s], and the part of its nodes that is covered."""
    nodes = np.meshgrid(*sides, indexing="ij")
    gap = case.drive.gap(case.drive.cycle.contact(phase))
    start = process_time()
    _, covered = gap(*nodes)
    return process_time() - start, float(covered.mean())


def main() -> None:
    cases = {profile: drive_of(profile) for profile in PROFILES}
    made = {profile: windows(case) for profile, case in cases.items()}
    rows = []
    for name in made["ZI"]:
        runs = [
            {profile: seconds(case, *made[profile][name]) for profile, case in cases.items()}
            for _ in range(TURNS)
        ]
        least = {profile: min(run[profile] for run in runs) for profile in cases}
        for profile, (time, covered) in least.items():
            ratio = time / least["ZI"][0]
            rows.append((name, profile, f"{time:.3f}", f"{ratio:.1f}", f"{covered:.2f}"))
    columns = "domain", "profile", "time / s", "time / that of ZI", "part covered"
    record("worm_gaps", columns, rows)


if __name__ == "__main__":
    main()
