"""What stretches leave of the first transient solve's error, by how far before a phase they begin.

From the repository's root, for shipped worm gear sets:

    python benchmarks/accuracy/stretch_length.py zi_drive worm_drawing

Behind `STRETCH` and `COARSE_WAY` of `pyworm.solver.transient.time_steps`: deviation of the minimum and
central film thickness from those of a second solve that goes through the whole life on its own grid, in per
cent, of the first solve and of stretches of several lengths. Loads are those of dry flanks.
"""

import sys
from pathlib import Path
from unittest.mock import patch

import numpy as np

import pyworm
from pyworm.solver.transient import time_steps
from pyworm.solver.transient.time_grid import TimeGrid, time_grid_of
from pyworm.solver.transient.time_integration import (
    TimeIntegration,
    integrate_in_time,
    integrate_on,
)

ROOT = Path(__file__).parents[2]
PHASES, ACCURACY, FIGURES = (0.02, 0.1, 0.3, 0.5, 0.7, 0.9), 0.05, ("film_min", "film_central")

BEGINNINGS = ((1.0, 0.9), (1.25, 0.75), (1.5, 0.5))
"""Transits before a phase, and share of the way to the touch for phases soon after it."""


def films(found: TimeIntegration, seconds: float) -> np.ndarray:
    """Figures of a solve at a time [m]."""
    times = [record.seconds for record in found.records]
    return np.array(
        [
            np.interp(seconds, times, [record.figures[name] for record in found.records])
            for name in FIGURES
        ]
    )


def stretch(time_grid: TimeGrid, seconds: float, length: float, way: float) -> TimeIntegration:
    """The second solve for a time, through a stretch that begins as given."""
    with patch.multiple(time_steps, STRETCH=length, COARSE_WAY=way):
        first = integrate_in_time(time_grid, 0, 0.0, [seconds], solves_after=1)
        return integrate_on(time_grid, first.restarts[seconds], 0.0, [seconds])


def rows(name: str) -> None:
    """Print a row of each phase of a case."""
    case = pyworm.load(ROOT / "cases" / f"{name}.toml")
    scenes = [case.scene(phase=phase) for phase in PHASES]
    time_grid = time_grid_of(scenes[0].past.life, pyworm.plan(scenes[0], ACCURACY))
    times = [scene.past.seconds for scene in scenes]
    touched = time_grid.place(time_grid.life.touched)
    first = integrate_in_time(time_grid, 0, 0.0, times)
    with patch.object(time_steps, "COARSE_WAY", 0.0):
        whole = integrate_in_time(time_grid, 1, 0.0, times)
    for phase, seconds in zip(PHASES, times, strict=True):
        if time_grid.place(seconds) <= touched:
            continue
        solves = [first, *(stretch(time_grid, seconds, *how) for how in BEGINNINGS)]
        changes = [100 * (films(one, seconds) / films(whole, seconds) - 1) for one in solves]
        shown = "".join(f"{least:9.2f}{central:7.2f}" for least, central in changes)
        print(f"{name:14}{phase:6.2f}{time_grid.place(seconds) - touched:8.2f}{shown}", flush=True)


if __name__ == "__main__":
    heads = ["first", *(f"{length:g} / {way:g}" for length, way in BEGINNINGS)]
    print(f"{'drive':14}{'phase':>6}{'touch':>8}{''.join(f'{head:>16}' for head in heads)}")
    for given in sys.argv[1:]:
        rows(given)
