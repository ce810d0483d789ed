"""Films after a written past by the number of time steps, of transient solves and of nodes.

Contacts are the `past` of `tests/hard/draws.py`. Columns are grids of the figures, the first one and two of
half and a quarter of its spacing; rows are transient solves, the first, second and so on, with 1, 2 and 4
times `STEPS_A_TRANSIT`. From the repository's root (each further solve takes eight times as long):

    python benchmarks/accuracy/turned_steps.py [NUMBER] [--seed 20260] [--solves 2]
"""

import sys
from argparse import ArgumentParser
from pathlib import Path
from unittest.mock import patch

from pyworm.planning.expected_work import STEPS_A_TRANSIT
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.transient.rated_films import rated_films
from pyworm.solver.transient.time_grid import TURNED_STEPS, time_grid_of
from pyworm.solver.transient.time_integration import integrate_in_time
from pyworm.solver.transient.transient import recent

sys.path.append(str(Path(__file__).parents[2] / "tests" / "hard"))
from draws import past
from trial import trial

FACTORS, GRIDS = (1, 2, 4), 3


def main(number: int, seed: int, solves: int) -> None:
    """A row for each number of time steps and each solve."""
    one = trial(past(number, seed).tables, f"past {number}", Path(), ("isothermal", "squeeze"))
    life = recent(one.scene)
    solver = SOLVERS[type(one.scene)](one.scene, one.plan)
    print(f"{one.case.title}: minimum / central film [um]")
    for factor in FACTORS:
        with (
            patch.dict(STEPS_A_TRANSIT, point=factor * STEPS_A_TRANSIT["point"]),
            patch.dict(TURNED_STEPS, point=1),
        ):
            time_grid = time_grid_of(life.life, one.plan)
            for solve in range(solves):
                found = integrate_in_time(time_grid, solve, 0.0, [life.seconds])
                rate = found.rates[life.seconds]
                level, _ = solver.begin(one.plan.grids)
                shown = []
                for _ in range(GRIDS):
                    films = rated_films(one.scene, one.plan, [rate], True, level)
                    sizes = films.figures["film_min"] * 1e6, films.figures["film_central"] * 1e6
                    shown.append("{:.4g} / {:.4g}".format(*sizes))
                    level, _ = solver.refined(films.level)
                steps = len(found.records)
                print(f"{factor} x, solve {solve + 1}, {steps:4} steps: ", *shown, flush=True)


if __name__ == "__main__":
    parser = ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("number", type=int, nargs="?", default=4)
    parser.add_argument("--seed", type=int, default=20260)
    parser.add_argument("--solves", type=int, default=2)
    asked = parser.parse_args()
    main(asked.number, asked.seed, asked.solves)
