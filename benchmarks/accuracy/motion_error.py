"""Error bars of transient films against a finer transient solve.

At each phase of a drive (loads shared dry) the films on the plan's first grid take the rates of change of one
transient solve, of two, and so on; the last stands for the truth. A bar is that of `transient.Transient`. Run
from the repository's root (it takes nine minutes):

    python benchmarks/accuracy/motion_error.py [CASE] [--phase PHASE ...] [--effects EFFECTS] [--solves 3]
"""

from argparse import ArgumentParser
from collections import defaultdict
from collections.abc import Iterator, Sequence

import pyworm
from pyworm.planning.plan import Plan
from pyworm.planning.target import FILMS
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.transient.next_film import NoFilmError
from pyworm.solver.transient.time_grid import time_grid_of
from pyworm.solver.transient.time_integration import integrate_in_time
from pyworm.solver.transient.time_records import until
from pyworm.solver.transient.transient import WARM_UP, Rates, part_at, transient

ACCURACY = 0.05
"""Accuracy of the plans [-]; bars of each number of solves are judged alike."""


def found(scenes: Sequence[Scene | LineScene], plan: Plan, solves: int) -> dict[str, Rates]:
    """Rates of change of scenes of one life by several transient solves, by the scene's name.

    The last of them, which the others are judged by, begins `WARM_UP` transits earlier. NoFilmError where
    there is no film.
    """
    time_grid = time_grid_of(scenes[0].past.life, plan)
    parts = defaultdict(list)
    for scene in scenes:
        parts[part_at(time_grid, scene.past.seconds)].append(scene)
    rates = {}
    for part, some in parts.items():
        wanted = sorted(scene.past.seconds for scene in some)
        earlier = max(0.0, part.begin - WARM_UP[plan.work.kind])
        begins = [part.begin] * (solves - 1) + [earlier]
        solved = [
            integrate_in_time(time_grid, number, begin, wanted)
            for number, begin in enumerate(begins)
        ]
        for failure in filter(None, (one.failure for one in solved)):
            raise NoFilmError(failure)
        for scene in some:
            at = scene.past.seconds
            rates[scene.name] = Rates(
                tuple(one.rates[at] for one in solved),
                tuple(until(one.records, at) for one in solved),
            )
    return rates


def judged(
    scene: Scene | LineScene, plan: Plan, rates: Rates
) -> Iterator[tuple[int, str, float, float]]:
    """Number of solves, film, its error against the last solve, and its bar."""
    simple = plan.simplified(scene)
    some = [slice(max(0, last - 2), last + 1) for last in range(len(rates.found))]
    of = [  # errors are told after up to three solves
        transient(simple, plan, Rates(rates.found[those], rates.records[those])) for those in some
    ]
    truth = of[-1].level.read().figures
    for number, one in enumerate(of[:-1], 1):
        figures = one.level.read().figures
        for name in FILMS:
            yield number, name, abs(figures[name] / truth[name] - 1), one.errors[name]


class Tally:
    """Rows of errors and bars, and how many hold after each number of solves."""

    def __init__(self) -> None:
        self._held: dict[int, list[bool]] = defaultdict(list)

    def show(self, scene: Scene | LineScene, plan: Plan, rates: Rates) -> None:
        """Print the rows of a scene."""
        for number, name, error, bar in judged(scene, plan, rates):
            self._held[number].append(error <= bar)
            print(f"{scene.name:>24} {number} {name:>12} {error:6.2%} of {bar:5.2%}", flush=True)

    def end(self) -> list[tuple[int, int, int]]:
        """Print how many hold, and return it: number of solves, estimates that hold, and all."""
        counts = [(number, sum(of), len(of)) for number, of in self._held.items()]
        for number, held, count in counts:
            print(f"{number} transient solves: {held} of {count} estimates hold")
        return counts


def main(
    path: str, phases: Sequence[float] | None, effects: str | tuple[str, ...], solves: int
) -> None:
    """A row for each phase, film and number of solves; then how many bars hold."""
    case = pyworm.load(path)
    scenes = [case.scene(**place.given) for place in case.places(phase=phases)]
    plans = {scene.name: pyworm.plan(scene, ACCURACY, effects) for scene in scenes}
    moving = [scene for scene in scenes if "squeeze" in plans[scene.name].on]
    rates, tally = found(moving, plans[moving[0].name], solves), Tally()
    for scene in moving:
        tally.show(scene, plans[scene.name], rates[scene.name])
    tally.end()


if __name__ == "__main__":
    parser = ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", nargs="?", default="cases/zi_drive.toml")
    parser.add_argument("--phase", type=float, nargs="+")
    parser.add_argument(
        "--effects", type=lambda text: tuple(text.split(",")), default=("auto", "squeeze")
    )
    parser.add_argument("--solves", type=int, default=3)
    asked = parser.parse_args()
    main(asked.case, asked.phase, asked.effects, asked.solves)
