"""Error bars of films in motion against a finer transient solve.

At each phase of a drive (loads shared dry) the films on the plan's first grid take the rates of change of one
transient solve, of two, and so on; the last stands for the truth. A bar is that of `transient.Transient`. Run
from the repository's root (it takes nine minutes):

    python benchmarks/drives/motion_error.py [CASE] [--phase PHASE ...] [--effects auto,squeeze] [--solves 3]
"""

from argparse import ArgumentParser
from collections import defaultdict
from collections.abc import Sequence

import pyworm
from pyworm.planning.plan import Plan
from pyworm.planning.target import FILMS
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.transient.course import course_of
from pyworm.solver.transient.march import RateOfChange, march
from pyworm.solver.transient.transient import Rates, part_at, transient

ACCURACY = 0.05
"""Accuracy of the plans [-]; bars of each number of solves are judged alike."""


def found(
    scenes: Sequence[Scene | LineScene], plan: Plan, solves: int
) -> dict[str, tuple[RateOfChange, ...]]:
    """Rates of change of scenes of one life by several transient solves, by the scene's name."""
    course = course_of(scenes[0].past.life, plan)
    parts = defaultdict(list)
    for scene in scenes:
        parts[part_at(course, scene.past.seconds)].append(scene)
    rates = {}
    for part, some in parts.items():
        wanted = sorted(scene.past.seconds for scene in some)
        solved = [march(course, number, part.begin, wanted) for number in range(solves)]
        for scene in some:
            rates[scene.name] = tuple(one.rates[scene.past.seconds] for one in solved)
    return rates


def main(path: str, phases: Sequence[float] | None, effects: str, solves: int) -> None:
    """A row for each phase, film and number of solves; then how many bars hold."""
    case = pyworm.load(path)
    scenes = [case.scene(**place.given) for place in case.places(phase=phases)]
    plans = {scene.name: pyworm.plan(scene, ACCURACY, effects) for scene in scenes}
    moving = [scene for scene in scenes if "squeeze" in plans[scene.name].on]
    rates = found(moving, plans[moving[0].name], solves)
    held = defaultdict(list)
    for scene in moving:
        plan = plans[scene.name]
        simple = plan.simplified(scene)
        of = [
            transient(simple, plan, Rates(rates[scene.name][: number + 1]))
            for number in range(solves)
        ]
        truth = of[-1].level.read().figures
        for number, one in enumerate(of[:-1], 1):
            row = [f"{scene.name:>12} {number}"]
            for name in FILMS:
                error = abs(one.level.read().figures[name] / truth[name] - 1)
                held[number].append(error <= one.errors[name])
                row.append(f"{name} {error:6.2%} of {one.errors[name]:5.2%}")
            print("  ".join(row), flush=True)
    for number, of_all in held.items():
        print(f"{number} transient solves: {sum(of_all)} of {len(of_all)} bars hold")


if __name__ == "__main__":
    parser = ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", nargs="?", default="cases/zi_drive.toml")
    parser.add_argument("--phase", type=float, nargs="+")
    parser.add_argument("--effects", default="auto,squeeze")
    parser.add_argument("--solves", type=int, default=3)
    asked = parser.parse_args()
    main(asked.case, asked.phase, asked.effects, asked.solves)
