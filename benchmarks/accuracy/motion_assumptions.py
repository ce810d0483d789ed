"""What transient films assume of the worm drive: how a tooth pair's life begins, and heat that oil stores.

Films of an early part of the life by the second transient solve, isothermal, over those of another beginning:
with a steady film at phase 0, under half and twice the load from which on it is given, at twice the distance.
Then the figures of some phases with the heat that oil stores in the film of that time, over those without.
Run from the repository's root (it takes two minutes):

    python benchmarks/accuracy/motion_assumptions.py
"""

from collections.abc import Callable
from dataclasses import replace
from unittest.mock import patch

import numpy as np

import pyworm
from pyworm.drives.tooth_life import ToothLife
from pyworm.drives.worm.loads import tooth_pair_motion
from pyworm.planning.target import FILMS, HEAT_FIGURES
from pyworm.solver.transient.time_grid import time_grid_of
from pyworm.solver.transient.time_integration import integrate_in_time
from pyworm.solver.transient.time_records import until
from pyworm.solver.transient.transient import Rates, transient

CASE = "cases/zi_drive.toml"

EARLY = (0.02, 0.06, 0.1, 0.14, 0.18, 0.22, 0.26)
"""Phases at which beginnings are compared."""

STORING = (0.02, 0.1, 0.26, 0.5, 0.74, 0.9, 0.98)
"""Phases at which stored heat is."""

ACCURACY = 0.05


def early_films(life_of: Callable) -> np.ndarray:
    """Least and central films of a life of the drive at the early phases [m]."""
    drive = pyworm.load(CASE).drive
    life = life_of(drive)
    scene = replace(drive.scene(0.5), past=life.past(0.5))
    time_grid = time_grid_of(
        scene.past.life, pyworm.plan(scene, ACCURACY, ("isothermal", "squeeze"), ("film",))
    )
    records = integrate_in_time(time_grid, 1, 0.0, [life.past(0.3).seconds]).records
    phases = [one.phase for one in records]
    return np.array(
        [np.interp(EARLY, phases, [one.figures[name] for one in records]) for name in FILMS]
    )


def beginnings() -> None:
    """Print what other beginnings change."""
    usual = early_films(lambda drive: drive.life)
    touch, apart = tooth_pair_motion.TOUCH, tooth_pair_motion.FIRST_SEPARATION
    rows = {
        "steady at phase 0": early_films(
            lambda drive: ToothLife(drive.scene_at, drive.phases_per_second, drive.contact_axes)
        )
    }
    for name, constant, value in (
        ("half the load", "TOUCH", touch / 2),
        ("twice the load", "TOUCH", 2 * touch),
        ("twice the distance", "FIRST_SEPARATION", 2 * apart),
    ):
        with patch.object(tooth_pair_motion, constant, value):
            rows[name] = early_films(lambda drive: drive.life)
    print(f"{'':32}" + "".join(f"{phase:8.2f}" for phase in EARLY))
    for name, films in rows.items():
        for film, changes in zip(FILMS, films / usual - 1, strict=True):
            print(f"{name:18} {film:13}" + "".join(f"{of:+8.1%}" for of in changes))


def stored_heat() -> None:
    """Print what the heat that oil stores changes."""
    case = pyworm.load(CASE)
    scenes = [case.scene(phase=phase) for phase in STORING]
    plans = [pyworm.plan(scene, ACCURACY, ("auto", "squeeze")) for scene in scenes]
    time_grid = time_grid_of(scenes[0].past.life, plans[0])
    found = integrate_in_time(time_grid, 1, 0.0, [scene.past.seconds for scene in scenes])
    names = (*FILMS, "friction_coefficient", *HEAT_FIGURES)
    for scene, plan in zip(scenes, plans, strict=True):
        at = scene.past.seconds
        rate, records = found.rates[at], (until(found.records, at),)
        stored, steady = (
            transient(plan.simplified(scene), plan, Rates((one,), records)).level.read().figures
            for one in (rate, replace(rate, warming=None, pressing=None))
        )
        told = ", ".join(f"{name} {stored[name] / steady[name] - 1:+.3%}" for name in names)
        print(f"{scene.name}: {told}", flush=True)


if __name__ == "__main__":
    beginnings()
    stored_heat()
