"""Newton steps and processor time of the transient solves of gear drives, by their parts.

From the repository's root, for shipped cases and drives of `tests/hard` (SEED:NUMBER):

    python benchmarks/accuracy/transient_cost.py zi_drive 99014:5

Behind `NEWTON_STEPS`, `ROUGH_NEWTON_STEPS` and `TIME_STEP_OVERHEAD` of `pyworm.solver.cost.calibration`.
"""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time

import pyworm
from pyworm.solver.cost.calibration import calibration
from pyworm.solver.cost.expected_motion import TimeSteps, _time_steps
from pyworm.solver.cost.expected_time import SCENES_A_STEP, _making, _sampling
from pyworm.solver.transient.next_film import NoFilmError
from pyworm.solver.transient.time_grid import TimeGrid, time_grid_of
from pyworm.solver.transient.time_integration import integrate_in_time
from pyworm.solver.transient.transient import part_at, recent

ROOT = Path(__file__).parents[2]
sys.path.append(str(ROOT / "tests/hard"))
from case_text import case_text  # noqa: E402
from gear_draws import drive  # noqa: E402

PHASES, ACCURACY, REFINEMENTS = (0.1, 0.3, 0.5, 0.7, 0.9), 0.05, (0, 1)


def loaded(name: str) -> pyworm.Case:
    """A shipped case, or a drive of the suite by seed and number."""
    seed, _, number = name.partition(":")
    if not number:
        return pyworm.load(ROOT / "cases" / f"{name}.toml")
    with TemporaryDirectory() as directory:
        path = Path(directory) / "drive.toml"
        path.write_text(case_text(drive(int(number), int(seed)).tables))
        return pyworm.load(path)


def scenes_of(case: pyworm.Case) -> list[pyworm.Scene]:
    """The contacts of a case at those phases of `PHASES` that carry load."""
    scenes = []
    for phase in PHASES:
        try:
            scenes.append(case.scene(phase=phase))
        except ValueError:  # neighbouring teeth carry all of the load
            continue
    return scenes


def row(name: str, refinement: int, scenes: list[pyworm.Scene]) -> str:
    """Parts of the time of a transient solve through the first part of the life of some contacts."""
    scene = scenes[0]
    plan = pyworm.plan(scene, ACCURACY)
    time_grid = time_grid_of(recent(scene).life, plan)
    part = part_at(time_grid, recent(scene).seconds)
    times = sorted(
        seconds
        for seconds in (recent(one).seconds for one in scenes)
        if part_at(time_grid, seconds) == part
    )
    steps = _time_steps(time_grid, range(refinement, refinement + 1), part.begin, times[-1])
    started = process_time()
    try:
        found = integrate_in_time(time_grid, refinement, part.begin, times, times[-1])
    except NoFilmError as reason:
        return f"{name:14} {refinement}  {reason}"
    taken, count = process_time() - started, sum(step.count for step in steps)
    newton = found.newton_steps / count
    entry, one, coarse, sampled = _parts(time_grid, scene, plan, steps)
    left = taken - entry - newton * one - sampled
    return (
        f"{name:14} {refinement:10}{time_grid.plan.model.rough!s:>7}{newton:8.2f}{taken:8.1f}"
        f"{entry:8.1f}{newton * one:8.1f}{sampled:8.1f}{left / coarse:10.1f}"
    )


def _parts(
    time_grid: TimeGrid, scene: pyworm.Scene, plan: pyworm.Plan, steps: tuple[TimeSteps, ...]
) -> tuple[float, ...]:
    """Expected times of grids, of one Newton step each, of the coarsest grids, and of gaps [s]."""
    model = time_grid.plan.model
    pace = calibration()._full(plan.work.kind, model)
    gap, motions = _sampling(plan.simplified(scene), plan)
    at_node, making = gap + (1 + (model.levels > 0) + model.heated) * motions, _making(scene)
    return (
        sum(step.count * pace.entry(step.nodes) for step in steps),
        sum(step.count * pace.steps(1, step.nodes) for step in steps),
        sum(step.count * pace.entry(step.coarse) for step in steps),
        sum(step.count * (step.nodes * at_node + SCENES_A_STEP * making) for step in steps),
    )


if __name__ == "__main__":
    print(
        f"{'drive':14} {'refinement':10}{'rough':>7}{'Newton':>8}{'CPU/s':>8}{'grids':>8}{'steps':>8}"
        f"{'gaps':>8}{'overhead':>10}"
    )
    for name in sys.argv[1:]:
        scenes = scenes_of(loaded(name))
        for refinement in REFINEMENTS:
            print(row(name, refinement, scenes), flush=True)
