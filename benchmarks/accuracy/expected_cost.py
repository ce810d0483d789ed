"""Seconds that `pyworm check` expects and those that a solve takes, shipped cases.

`precision.py expected` runs it for steady films. Transient films, some of them of whole lives, from the
repository's root (it takes fifteen minutes; names choose cases):

    python benchmarks/accuracy/expected_cost.py [NAME ...]
"""

import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from time import process_time
from typing import Any

import pyworm
from pyworm.batch.case_run import run
from pyworm.batch.task import Task
from pyworm.solver.cost.expected_time import expectation, expectations, together

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

PLACES = {
    "point_m20_l10": {},
    "point_m100_l10": {},
    "point_m200_l10": {},
    "point_m200_l20": {},
    "point_m1000_l10": {},
    "mourier_2006": {},
    "ellipse10_across": {},
    "ellipse10_along": {},
    "ellipse10_oblique": {},
    "ellipse30_along": {},
    "spin_zi_like": {},
    "gap_example": {},
    "line_m20_l10": {},
    "line_m200_l10": {},
    "line_thermal": {},
    "traction_steel": {"slide_roll_ratio": 0.5},
    "opposite_sliding": {},
    "zi_paraboloid": {},
    "zi_sharif_2001": {"phase": 0.5},
    "roller_ref": {"section": "left", "phase": 0.5, "station": 0.5},
    "roller_crowned": {"section": "left", "phase": 0.5},
    "spur_pair": {"phase": 0.2},
    "errichello_speed_increaser": {"phase": 0.6},
}

ACCURACIES = (0.05, 0.01)

IN_MOTION_COLUMNS = (
    "case",
    "accuracy requested",
    "contacts",
    "expected / s",
    "measured / s",
    "ratio",
    "load",
    "constants",
)
"""Columns of transient films; the load is that of the machine's cores."""


@dataclass(frozen=True)
class InMotion:
    """Contacts of a case whose films are solved in motion, together."""

    name: str
    """Name of the case."""
    accuracies: tuple[float, ...]
    """Accuracies asked for [-]."""
    effects: tuple[str, ...] = ("auto", "squeeze")
    """Which effects to simulate."""
    places: dict[str, Any] = field(default_factory=dict)
    """Which contacts; by default all that the case lists."""
    chosen_with: bool = False
    """Whether the constants of the law were chosen with these."""


IN_MOTION = (
    InMotion("reversal_line", (0.05,), chosen_with=True),
    InMotion("impact_ball", (0.05,), chosen_with=True),
    InMotion("spur_pair", (0.05,), places={"phase": [0.2]}, chosen_with=True),
    InMotion(
        "roller_ref",
        (0.05,),
        places={"section": ["left"], "phase": [0.5], "station": [0.5]},
        chosen_with=True,
    ),
    InMotion("zi_drive", (0.05,), places={"phase": [0.1]}, chosen_with=True),
    InMotion("zi_drive", (0.1, 0.05), chosen_with=True),
    InMotion("reversal_line", (0.1, 0.02)),
    InMotion("impact_ball", (0.1, 0.02)),
    InMotion("spur_pair", (0.05,)),
    InMotion("zi_drive", (0.05, 0.02), places={"phase": [0.5]}),
    InMotion("zi_drive", (0.05,), places={"phase": [0.74]}),
    InMotion("worm_drawing", (0.2, 0.05)),
)

QUICK = 1.0
"""Solves shorter than this [s] are timed three times: the first of a process does what others need not."""


def main() -> None:
    rows, ratios = [], []
    for name, place in PLACES.items():
        scene = pyworm.load(Path(f"cases/{name}.toml")).scene(**place)
        for accuracy in ACCURACIES:
            plan = pyworm.plan(scene, accuracy, ("auto", "-squeeze"))
            expected = expectation(scene, plan).seconds
            measured = [_seconds(scene, plan)]
            if measured[0] < QUICK:
                measured += [_seconds(scene, plan) for _ in range(2)]
            ratios.append(expected / median(measured))
            rows.append(
                [
                    name,
                    f"{accuracy:.0%}".replace("%", " %"),
                    f"{expected:.2g}",
                    f"{median(measured):.2g}",
                    f"{ratios[-1]:.2f}",
                ]
            )
            print(*rows[-1], flush=True)
    within = sum(0.5 <= ratio <= 2 for ratio in ratios)
    print(f"{within} of {len(ratios)} within a factor of 2, median {median(ratios):.2f}")
    columns = "case", "accuracy requested", "expected / s", "measured / s", "ratio"
    record("expected_time", columns, rows)


def _seconds(scene, plan) -> float:
    started = process_time()
    pyworm.solve(scene, plan)
    return process_time() - started


def in_motion(names: Sequence[str]) -> None:
    """A row for each entry of `IN_MOTION`, or those of some cases."""
    rows, ratios = [], []
    for of in IN_MOTION:
        for accuracy in of.accuracies if not names or of.name in names else ():
            case = pyworm.load(Path(f"cases/{of.name}.toml"))
            places = list(case.places(**of.places))
            tasks = [Task(case, place, accuracy, of.effects) for place in places]
            lives = [replace(place, phase=None) for place in places]
            expected = together(
                expectations([(task.scene, task.plan) for task in tasks], lives), lives
            )
            measured = _seconds_of_all(case, [replace(task) for task in tasks])
            ratios.append(expected / measured)
            rows.append(
                [
                    of.name,
                    f"{accuracy:.0%}".replace("%", " %"),
                    _contacts(of, len(tasks)),
                    f"{float(f'{expected:.2g}'):g}",
                    f"{float(f'{measured:.2g}'):g}",
                    f"{ratios[-1]:.2f}",
                    f"{os.getloadavg()[0]:.1f}",
                    "chosen with" if of.chosen_with else "new",
                ]
            )
            print(*rows[-1], flush=True)
    within = sum(0.5 <= ratio <= 2 for ratio in ratios)
    print(f"{within} of {len(ratios)} within a factor of 2, median {median(ratios):.2f}")
    if not names:
        record("expected_in_motion", IN_MOTION_COLUMNS, rows)


def _contacts(of: InMotion, count: int) -> str:
    """Which contacts, in words."""
    given = ", ".join(f"{name} {value[0]}" for name, value in of.places.items())
    return given or ("one" if count == 1 else f"all {count}")


def _seconds_of_all(case: pyworm.Case, tasks: Sequence[Task]) -> float:
    """Processor time of a run of some contacts, with loads and temperatures as they are [s]."""
    started = process_time()
    with TemporaryDirectory() as directory:
        run(case, tasks, Path(directory))
    return process_time() - started


if __name__ == "__main__":
    in_motion(sys.argv[1:])
