"""What the maximum stress below both surfaces costs, over the film of the same contact.

Random point and line contacts of `tests/hard/draws.py` and three of `cases/`, solved to 10 %, where the film
is cheapest. Ratios of processor times, one thread, the least of three measurements of the stress. From the
repository's root:

    python benchmarks/cost/stress_cost.py [COUNT]
"""

import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from time import process_time

import pyworm
from pyworm.case.case import case_of
from pyworm.scene.any_contact import AnyContact
from pyworm.solver.stress.subsurface import inputs_of_scene, with_stress
from pyworm.solver.stress.thermal import why_no_heat

sys.path.append(str(Path(__file__).parents[2] / "tests" / "hard"))
from draws import JUDGED_DRAWS

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

ACCURACY = 0.1
COUNT, SEED = 8, 54
EXPANSION = 11.5e-6
"""Thermal expansion of steel [1/K]."""

CASES = {
    "zi_sharif_2001": {"phase": 0.5},
    "traction_steel": {"slide_roll_ratio": 0.5},
    "film_rig": {},
}


def contacts(count: int) -> Iterator[tuple[str, AnyContact]]:
    """Contacts by name, of bodies that expand."""
    for name, index in CASES.items():
        yield name, pyworm.load(Path(f"cases/{name}.toml")).scene(**index)
    for kind in ("isothermal", "thermal", "warm", "thermal-line"):
        for number in range(count):
            drawn = JUDGED_DRAWS[kind](number, SEED)
            yield f"{kind} {number}", case_of(drawn.tables, kind, Path()).scene()


def least(work: Callable[[], object]) -> float:
    """Least processor time of three runs [s]."""
    times = []
    for _ in range(3):
        start = process_time()
        work()
        times.append(process_time() - start)
    return min(times)


def row(name: str, scene: AnyContact) -> tuple[object, ...] | None:
    """A row of the table; None of a film that does not converge."""
    bodies = tuple(replace(body, thermal_expansion=EXPANSION) for body in scene.bodies)
    scene = replace(scene, bodies=bodies)
    start = process_time()
    solution = pyworm.solve(scene, accuracy=ACCURACY)
    film = process_time() - start
    if not solution.converged:
        return None
    found = [least(lambda: with_stress(solution, inputs_of_scene(scene))) / film]
    if not why_no_heat(solution, scene):
        found.append(least(lambda: with_stress(solution, inputs_of_scene(scene, True))) / film)
    return (name, f"{film:.2f}", *(f"{share:.3f}" for share in found), "")[:4]


if __name__ == "__main__":
    count = int(sys.argv[1]) if len(sys.argv) > 1 else COUNT
    rows = [row(name, scene) for name, scene in contacts(count)]
    record(
        "stress_cost",
        ("contact", "film / s", "stress / film", "with thermal stress / film"),
        filter(None, rows),
    )
