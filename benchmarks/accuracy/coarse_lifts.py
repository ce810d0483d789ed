"""What coarse transient solves find of the lifts of a drive's teeth, beside the full ones of a run.

Of each phase: lift by the coarse solve over the full one. Then the ratios of lift and friction that steady
films of a contact in the middle tell, the largest change of a load from full lifts to coarse ones, as they
are and times that ratio, and processor time of the coarse and of the first transient solve. From the
repository's root, with results files of runs to 5 %:

    python benchmarks/accuracy/coarse_lifts.py results/worm_drawing/result.nc ...
"""

import sys
from time import process_time

from pyworm.batch.drive_iteration import estimate_of, load_change, steady
from pyworm.batch.task import Task
from pyworm.batch.tooth_lifts import lifts_of, steady_ratios
from pyworm.batch.transient_solutions import is_transient, tasks_by_part
from pyworm.case.case import case_again
from pyworm.io.present import present
from pyworm.result.mesh_cycle import drive_cycle
from pyworm.result.result import open_result
from pyworm.solver.transient.lifts import mean_friction
from pyworm.solver.transient.time_integration import integrate_in_time
from pyworm.solver.transient.transient import part_at, present_in_life


def first_solves(tasks: list[Task]) -> None:
    """Make the first transient solves of a run."""
    for part in tasks_by_part(tasks):
        time_grid = part[0].time_grid
        seconds = [present_in_life(task.scene).seconds for task in part]
        integrate_in_time(time_grid, 0, part_at(time_grid, seconds[0]).begin, seconds)


def main(path: str) -> None:
    """The lines of a results file."""
    result = open_result(path)
    cycle = present(drive_cycle(result), "a mesh cycle")
    case, full = case_again(result.case), dict(cycle.lifts)
    tasks = [Task(case, place, 0.05) for place in case.places(phase=[*full])]
    tasks = [task for task in tasks if is_transient(task)]
    began = process_time()
    coarse = lifts_of(tasks, None)
    coarse_seconds, began = process_time() - began, process_time()
    middle = tasks[len(tasks) // 2]
    ratios = steady_ratios(middle, steady(estimate_of(middle)), None)
    ratio_seconds, began = process_time() - began, process_time()
    first_solves(tasks)
    first_seconds = process_time() - began

    def with_lifts(factor: float, lifts: dict[float, float]):
        given = tuple((phase, factor * lifts[phase]) for phase in sorted(coarse))
        return case.with_found({"operation": {"lifts": given}})

    found = {phase: lift.distance for phase, lift in coarse.items()}
    shares = " ".join(f"{phase:g}: {found[phase] / full[phase]:.2f}" for phase in sorted(found))
    changes = " and ".join(
        f"{load_change(with_lifts(1.0, full), with_lifts(factor, found), sorted(found)):.2%}"
        for factor in (1.0, ratios[0])
    )
    friction = (
        present(mean_friction(coarse.values()), "friction")
        / present(cycle.loss, "the loss of the cycle").friction
    )
    print(f"{result.case_name}\n  coarse over full lift: {shares}; friction {friction:.2f}")
    print(f"  ratios by steady films: lift {ratios[0]:.2f}, friction {ratios[1]:.2f}")
    print(f"  loads differ by {changes}")
    print(
        f"  {coarse_seconds:.1f} s and steady films {ratio_seconds:.1f} s; "
        f"first transient solves {first_seconds:.1f} s",
        flush=True,
    )


if __name__ == "__main__":
    for path in sys.argv[1:]:
        main(path)
