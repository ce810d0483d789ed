"""Stress below the surfaces of the contacts of a run, as `pyworm run --stress` shows."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from pyworm.batch.case_run import RESULT_NAME
from pyworm.batch.task import Task
from pyworm.result.result import Result
from pyworm.scene.index import ContactIndex
from pyworm.solver.stress.subsurface import inputs_of_scene, with_stress


def stressed_run(result: Result, tasks: Sequence[Task], directory: Path) -> Result:
    """A result with the stresses of its converged contacts, in its file in a directory too."""
    scenes = {task.place: task.scene for task in tasks}
    solutions = tuple(
        with_stress(solution, inputs_of_scene(scenes[ContactIndex.of(solution)]))
        if solution.converged
        else solution
        for solution in result.solutions
    )
    whole = replace(result, solutions=solutions)
    whole.save(directory / RESULT_NAME)
    return whole
