"""Pictures of a result; they read results and nothing else."""

import os
from collections.abc import Callable, Collection, Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import replace
from functools import partial
from pathlib import Path

from matplotlib.figure import Figure

from pyworm.batch.workers import WorkerDiedError
from pyworm.io.quantities import BODIES
from pyworm.io.reason import reason_of
from pyworm.plots.attempts import Attempts
from pyworm.plots.contact.across_film import draw_across_film
from pyworm.plots.contact.convergence import draw_history
from pyworm.plots.contact.entrainment import draw_entrainment
from pyworm.plots.contact.film import draw_film
from pyworm.plots.contact.gap import draw_gap
from pyworm.plots.contact.line_profiles import (
    draw_line_friction,
    draw_line_profiles,
    draw_line_temperature,
)
from pyworm.plots.contact.maps import draw_friction, draw_pressure, draw_supply, draw_temperature
from pyworm.plots.contact.profiles import draw_profiles
from pyworm.plots.contact.stress import draw_stress
from pyworm.plots.drives.picture import cycle_pictures
from pyworm.plots.life import draw_life
from pyworm.plots.regimes import draw_regimes
from pyworm.plots.traction import draw_traction, traction_curve
from pyworm.result.life import life_names
from pyworm.result.result import Result, open_result
from pyworm.solver.solution import Solution

SCENE_PICTURES = {
    "point": {
        "gap": draw_gap,
        "pressure": draw_pressure,
        "film": draw_film,
        "entrainment": draw_entrainment,
        "profiles": draw_profiles,
        "history": draw_history,
        "friction": draw_friction,
        "temperature": draw_temperature,
        "across_film": draw_across_film,
        "supply": draw_supply,
        "stress": draw_stress,
    },
    "line": {
        "profiles": draw_line_profiles,
        "history": draw_history,
        "friction": draw_line_friction,
        "temperature": draw_line_temperature,
        "across_film": draw_across_film,
        "stress": draw_stress,
    },
}
"""Kind of contact -> name in the file name -> function of the case's name and a solution."""

OF_BODIES = {draw_friction, draw_temperature, draw_across_film, draw_line_temperature, draw_stress}
"""Those that take what the bodies are called, besides."""

KEY_PICTURES = {
    "point": ("film", "temperature", "stress"),
    "line": ("profiles", "temperature", "stress"),
}
"""Kind of contact -> pictures that show most of it."""

SHOWS = {
    "friction": lambda solution: solution.figures.friction_coefficient,
    "temperature": lambda solution: solution.figures.temperature_max_film,
    "across_film": lambda solution: solution.profile,
    "supply": lambda solution: solution.figures.supply,
    "stress": lambda solution: solution.figures.stress,
}
"""Name of a picture that not every solution has -> what it shows, None where it was not simulated."""


def draw(
    result: Result | str | os.PathLike[str],
    directory: str | os.PathLike[str],
    executor: Executor | None = None,
    *,
    key_only: bool = False,
    names: Collection[str] = (),
) -> list[Path]:
    """Draw the pictures of a result as PNG.

    Args:
        result (Result or path): The result or the file that holds it.
        directory: Where the pictures go; made if missing.
        executor: Whose processes draw those of the scenes; by default this one does.
        key_only: Whether to draw of all contacts only that with the thinnest film, and of it only
            `KEY_PICTURES`.
        names: Only these, of `picture_names`, those of contacts for each; by default all.

    Returns:
        The files, scene by scene, those of the whole result last.

    Raises:
        PicturesError: Some could not be drawn; all others are.
    """
    if not isinstance(result, Result):
        result = open_result(result)
    directory = Path(directory)
    directory.mkdir(parents=True, exist_ok=True)
    attempts = Attempts()
    if key_only and result.solutions:
        thinnest = result.solutions[result.thinnest]
        key = KEY_PICTURES[thinnest.kind]
        attempts.add(_draw_scene(result, directory, result.thinnest, thinnest, key))
    elif not key_only:
        for scene in _scene_pictures(result, directory, executor, names):
            attempts.add(scene)
    for name, picture in _whole_pictures(result).items():
        if not names or name in names:
            attempts.draw(directory / f"{name}.png", picture)
    return attempts.result()


def picture_names(result: Result) -> list[str]:
    """Names of the pictures that there may be of a result: those of contacts, then those of the whole."""
    kinds = {solution.kind: None for solution in result.solutions}
    of_scenes = {name: None for kind in kinds for name in SCENE_PICTURES[kind]}
    return [*of_scenes, *_whole_pictures(result)]


def _whole_pictures(result: Result) -> dict[str, Callable[[], Figure | None]]:
    """Name in the file name -> what draws a picture of the whole result."""
    pictures: dict[str, Callable[[], Figure | None]] = {
        name: partial(picture.draw, result) for name, picture in cycle_pictures(result).items()
    }
    if result.solutions:
        pictures["regimes"] = partial(draw_regimes, result)
    if traction_curve(result):
        pictures["traction"] = partial(draw_traction, result)
    for name, life in life_names(result).items():
        pictures[name] = partial(draw_life, result, life)
    return pictures


def _scene_pictures(
    result: Result, directory: Path, executor: Executor | None, names: Collection[str]
) -> Iterator[Attempts]:
    """Pictures of each scene and their failures; a process that dies loses only those of its scene."""
    scenes = [
        (
            number,
            solution,
            tuple(
                picture
                for picture in SCENE_PICTURES[solution.kind]
                if picture in names or not names
            ),
        )
        for number, solution in enumerate(result.solutions)
    ]
    shown = replace(result, solutions=(), mesh_cycle=None)  # what goes to other processes is small
    picture = partial(_draw_scene, shown, directory)
    if executor is None:
        yield from (picture(*scene) for scene in scenes)
        return
    futures = [executor.submit(picture, *scene) for scene in scenes]
    for number, future in enumerate(futures):
        try:
            yield future.result()
        except WorkerDiedError as error:
            yield Attempts(failed={f"{_stem(number)}_*.png": reason_of(error)})


def _draw_scene(
    result: Result, directory: Path, number: int, solution: Solution, names: Sequence[str]
) -> Attempts:
    """The pictures of one scene of a result."""
    attempts, pictures = Attempts(), SCENE_PICTURES[solution.kind]
    for name in names:
        if name in pictures and has_picture(solution, name):
            file = directory / f"{_stem(number)}_{name}.png"
            attempts.draw(file, scene_picture(result, solution, name))
    return attempts


def scene_picture(result: Result, solution: Solution, name: str) -> Callable[[], Figure]:
    """What draws a picture of one scene of a result."""
    draw = SCENE_PICTURES[solution.kind][name]
    named = (tuple(map(_in_words, result.body_names)),) if draw in OF_BODIES else ()
    return partial(draw, result.case_name, solution, *named)


def _in_words(body: str) -> str:
    """A body as titles name it: "the worm", "body 1"."""
    return body if body in BODIES else f"the {body}"


def has_picture(solution: Solution, name: str) -> bool:
    """Whether what a picture shows was simulated."""
    return name not in SHOWS or SHOWS[name](solution) is not None


def _stem(number: int) -> str:
    """Prefix of the names of a scene's pictures."""
    return f"scene_{number:03d}"
