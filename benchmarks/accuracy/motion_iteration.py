"""What Newton's iteration in transient solves of the worm drive leaves in its films, and processor times.

Minimum films of some phases by the first and the second transient solve, over those whose instants are solved
to a thirtieth of the residual: with the steps that heated films take, and with those of films without heat.
Run from the repository's root (it takes three minutes):

    python benchmarks/accuracy/motion_iteration.py
"""

from collections.abc import Callable
from dataclasses import replace
from time import process_time
from unittest.mock import patch

import pyworm
from pyworm.solver.transient import next_film
from pyworm.solver.transient.settling import TOLERANCE, Settling, settling_of
from pyworm.solver.transient.time_grid import TimeGrid, time_grid_of
from pyworm.solver.transient.time_integration import integrate_in_time
from pyworm.solver.transient.time_records import until
from pyworm.solver.transient.time_steps import Step
from pyworm.solver.transient.transient import Rates, transient

CASE = "cases/zi_drive.toml"

PHASES = (0.02, 0.1, 0.18, 0.34, 0.5, 0.74, 0.98)

ACCURACY = 0.05

TIGHT = 1 / 30
"""Residual of the reference over the usual one."""


def as_usual(time_grid: TimeGrid, step: Step) -> Settling:
    """The steps that heated films take."""
    return settling_of(time_grid, step)


def as_cold(time_grid: TimeGrid, step: Step) -> Settling:
    """Those of films without heat."""
    return Settling(TOLERANCE * time_grid.step(step.refinement) ** 2)


def as_tight(time_grid: TimeGrid, step: Step) -> Settling:
    """Those of the reference."""
    usual = settling_of(time_grid, step)
    return replace(usual, tolerance=TIGHT * usual.tolerance)


def films(settling: Callable[[TimeGrid, Step], Settling], refinement: int) -> list[float]:
    """Minimum films of the phases by one transient solve [m]; its processor time is printed."""
    case = pyworm.load(CASE)
    scenes = [case.scene(phase=phase) for phase in PHASES]
    plans = [pyworm.plan(scene, ACCURACY, ("auto", "squeeze")) for scene in scenes]
    time_grid = time_grid_of(scenes[0].past.life, plans[0])
    started = process_time()
    with patch.object(next_film, "settling_of", settling):
        found = integrate_in_time(
            time_grid, refinement, 0.0, [scene.past.seconds for scene in scenes]
        )
    print(
        f"solve {refinement + 1} {settling.__name__}: {process_time() - started:.1f} s, "
        f"{found.newton_steps} Newton steps, {len(found.records)} films",
        flush=True,
    )
    least = []
    for scene, plan in zip(scenes, plans, strict=True):
        at = scene.past.seconds
        rates = Rates((found.rates[at],), (until(found.records, at),))
        level = transient(plan.simplified(scene), plan, rates).level
        least.append(level.read().figures["film_min"])
    return least


if __name__ == "__main__":
    for number in (0, 1):
        reference = films(as_tight, number)
        for how in (as_usual, as_cold):
            changes = (
                film / true - 1 for film, true in zip(films(how, number), reference, strict=True)
            )
            print("  " + "".join(f"{change:+8.2%}" for change in changes), flush=True)
