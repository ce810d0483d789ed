"""Seconds that `pyworm check` expects and those that a solve takes, shipped cases."""

from pathlib import Path
from statistics import median
from time import process_time

from accuracy_page import fill, markdown

import pyworm
from pyworm.solver.cost.expected_time import expectation

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

QUICK = 1.0
"""Solves shorter than this [s] are timed three times: the first of a process does what others need not."""


def main() -> None:
    rows, ratios = [["case", "asked", "expected / s", "measured / s", "ratio"]], []
    for name, place in PLACES.items():
        scene = pyworm.load(Path(f"cases/{name}.toml")).scene(**place)
        for accuracy in ACCURACIES:
            plan = pyworm.plan(scene, accuracy, "auto,-squeeze")
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
    fill("expected", markdown(rows))


def _seconds(scene, plan) -> float:
    started = process_time()
    pyworm.solve(scene, plan)
    return process_time() - started
