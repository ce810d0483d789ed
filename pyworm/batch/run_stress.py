"""Stress below the surfaces of the contacts of a run, as `pyworm run --stress` shows."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from pyworm.batch.case_run import RESULT_NAME
from pyworm.batch.task import Task
from pyworm.result.result import Result
from pyworm.scene.index import ContactIndex
from pyworm.solver.solution import Solution
from pyworm.solver.stress.fatigue import with_fatigue
from pyworm.solver.stress.subsurface import inputs_of_scene, with_stress
from pyworm.solver.stress.thermal import why_no_heat
from pyworm.solver.stress.tractions import has_shear

WITHOUT_SHEAR = "stress by the pressure alone, since the shear stress of the film was not simulated"


def stressed_run(
    result: Result,
    tasks: Sequence[Task],
    directory: Path,
    print_message: Callable[[str], None] = lambda message: None,
    *,
    thermal: bool = False,
) -> Result:
    """A result with the stresses of its converged contacts, in its file in a directory too.

    `print_message` reports contacts whose stress lacks that by the shear of the film, or the thermal one.
    """
    scenes = {task.place: task.scene for task in tasks}

    def stressed(solution: Solution) -> Solution:
        if not solution.converged:
            return solution
        scene = scenes[ContactIndex.of(solution)]
        lacking = why_no_heat(solution, scene) if thermal else ""
        if lacking:
            print_message(f"{solution.name}: no thermal stress: {lacking}")
        found = with_stress(solution, inputs_of_scene(scene, thermal and not lacking))
        return with_fatigue(found, scene)

    solutions = tuple(stressed(solution) for solution in result.solutions)
    for solution in solutions:
        if solution.converged and not has_shear(solution):
            print_message(f"{solution.name}: {WITHOUT_SHEAR}")
    whole = replace(result, solutions=solutions)
    whole.save(directory / RESULT_NAME)
    return whole
