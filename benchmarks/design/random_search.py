"""The best design of `pyworm design` beside the best of ten times as many random designs.

Run from the repository's root, a few minutes of CPU time:
    python benchmarks/design/random_search.py [NAME ...]

Cost is the number of designs whose contacts were solved, without a solve the number of designs computed. The
better of two designs has the smaller merit: cost with violated constraints (`pyworm.batch.design_search`).
"""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from pyworm.batch.design import _Search
from pyworm.batch.design_model import Design
from pyworm.batch.design_search import Goal
from pyworm.case.design import load_design

ROOT = Path(__file__).parents[2]
TIMES, SEED = 10, 51

FILES = {
    "addenda": (ROOT / "cases/designs/addenda.toml").read_text(),
    "rollers": (ROOT / "cases/designs/roller.toml").read_text(),
    "rollers by formula": f"""
title = "Three sizes of the roller worm drive"
case = "{ROOT}/cases/roller_ref.toml"
figures = "formula"
fixed = {{ "operation.phases" = [0.0, 0.5, 1.0], "operation.stations" = [0.5] }}
[variables]
"drive.rollers.radius" = {{ low = "4.5 mm", high = "8.5 mm" }}
"drive.worm.throat_coefficient" = {{ low = 0.3, high = 0.5 }}
"drive.worm.outer_angle" = {{ low = "40 deg", high = "70 deg" }}
[objective]
maximise = "film_min"
[constraints]
pressure_max = {{ high = "900 MPa" }}
""",
    "ball on disc": f"""
title = "Radii of a ball"
case = "{ROOT}/cases/ball_pag_460.toml"
effects = "isothermal"
[variables]
"contact.radii[0]" = {{ low = "8 mm", high = "20 mm" }}
"contact.radii[1]" = {{ low = "8 mm", high = "20 mm" }}
[objective]
maximise = "pressure_max"
[constraints]
film_min = {{ low = "0.33 um" }}
""",
    "hob by formula": f"""
title = "Setting of a hob"
case = "{ROOT}/cases/zi_sharif_2001.toml"
figures = "formula"
fixed = {{ "operation.phases" = [0.3, 0.5, 0.7] }}
[variables]
"drive.hob.swivel" = {{ low = "0 deg", high = "0.5 deg" }}
"drive.hob.axial_shift" = {{ low = "-1.5 mm", high = "0.5 mm" }}
"drive.hob.centre_distance" = {{ low = "305.3 mm", high = "305.9 mm" }}
[objective]
maximise = "film_min"
[constraints]
pressure_max = {{ high = "560 MPa" }}
""",
}


def compared(name: str, text: str, folder: Path) -> str:
    """One row: cost and merit of the search, and of random designs of ten times the cost."""
    path = folder / f"{name.replace(' ', '_')}.toml"
    path.write_text(text.replace('"../', f'"{ROOT}/cases/'))
    task = load_design(path)
    search = _Search(task, folder / "kept", None, None, lambda message: None)
    best = search.found()
    start = search._start()
    before = search._solved(start, search.formula) if search.simulates else None
    first = search.formula.one(start) if before is None else before.figures
    scales = {key: abs(figure.value) for key, figure in first.items()}
    goal = Goal(task.tables.objective.weights, task.limits, scales)
    merit = min(
        goal.merit(known.figures) for known in search.known.values()
    ) if search.simulates else min(map(goal.merit, search.formula.known.values()))  # fmt: skip
    cost = best.solved if search.simulates else best.estimates
    others = _random(search, task, goal, TIMES * cost)
    return f"| {name} | {cost} | {merit:.5f} | {TIMES * cost} | {others:.5f} | {merit < others} |"


def _random(search: _Search, task, goal: Goal, count: int) -> float:
    """Merit of the best of some random designs."""
    generator = np.random.Generator(np.random.PCG64(SEED))
    designs = [
        Design(tuple(map(float, point))) for point in generator.random((count, len(task.variables)))
    ]
    if not search.simulates:
        return min(map(goal.merit, search.formula.many(designs)))
    return min(goal.merit(search._solved(design, search.formula).figures) for design in designs)


def main() -> None:
    print("| case | designs | merit | random designs | merit | better |\n|---|---|---|---|---|---|")
    with TemporaryDirectory() as folder:
        for name in sys.argv[1:] or FILES:
            print(compared(name, FILES[name], Path(folder)), flush=True)


if __name__ == "__main__":
    main()
