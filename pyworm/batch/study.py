"""Studies from Python: many scenes of a script, or a sweep file, to one table."""

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from contextlib import ExitStack
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from pyworm.batch.case_run import SCENES
from pyworm.batch.in_python import executor, messages, progress_of
from pyworm.batch.provenance import provenance
from pyworm.batch.scene_task import SceneTask, require_sendable
from pyworm.batch.solve_tasks import solve_all
from pyworm.batch.solved_scenes import Store
from pyworm.batch.sweep import Sweep, label, load_sweep
from pyworm.batch.sweep_run import run_sweep
from pyworm.io import units
from pyworm.io.given import WithUnit, kind_of, number, row, text
from pyworm.io.progress import Progress
from pyworm.planning.effects.selection import Effects, as_text
from pyworm.result.result import Result
from pyworm.result.sweep_result import SweepResult
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.scene.slide_roll import with_slide_roll_ratio


def sweep(
    make: str | Path | Callable[..., Scene | LineScene],
    *,
    out: str | Path | None = None,
    accuracy: WithUnit = 0.01,
    effects: Effects = "auto",
    quantities: Sequence[str] | None = None,
    fields: bool = False,
    processes: int = 1,
    scheduler: str | None = None,
    progress: bool | Progress = True,
    title: str = "study",
    largest_grid: int | None = None,
    **vary: Sequence[Any],
) -> SweepResult:
    """Solve a scene over ranges of its values, `sweep(make, load=(10, 20), speed=(0.5, 1.0))`.

    Args:
        make (callable or path): Makes a scene of the varied values, given by name; or a sweep file, as
            `pyworm sweep` solves it.
        out: Directory where solved scenes are kept, and found again by another call; by default none are.
        accuracy, effects, quantities: As of `pyworm.plan`; of a sweep file its own. Where `quantities` are
            films alone, those that the formula of the atlas gives to the accuracy are not solved, unless
            `fields` are kept.
        fields: Whether solutions are kept in full, or their scalars only.
        processes: Processes that solve; more than one need a script with `if __name__ == "__main__":`.
        scheduler: Address of a dask.distributed scheduler whose workers solve instead.
        progress, title: Whether a bar shows the progress, or what is called
            instead; heading of the table's picture.
        largest_grid: Nodes beyond which no grid is refined, which ends dear scenes unconverged; not of a
            sweep file.
        **vary: Values of each argument of `make`; all are crossed, the last one changing fastest.

    Returns:
        `table`, an xarray.Dataset, has a row a scene, also of those without a solution.

    Raises:
        ValueError: Nothing to vary, a scene that is none, cannot be planned, or cannot go to other processes.
    """
    with ExitStack() as stack:
        where = stack.enter_context(TemporaryDirectory()) if out is None else out
        folder = Path(where).absolute()
        told = stack.enter_context(progress_of(progress))
        pool = stack.enter_context(executor(processes, scheduler))
        if isinstance(make, str | Path):
            study = _of_file(make, vary, pool, told, Store(folder / SCENES, fields))
        else:
            how = (
                as_text(effects),
                quantities and tuple(row("quantities", quantities)),
                largest_grid,
            )
            study = _study(make, title, vary, (_accuracy(accuracy), *how), pool is not None)
        return run_sweep(study, folder, fields, pool, told, messages(progress))


def traction_curve(
    scene: Scene,
    slide_roll_ratios: Sequence[float],
    *,
    accuracy: WithUnit = 0.01,
    effects: Effects = "auto",
    out: str | Path | None = None,
    processes: int = 1,
    progress: bool | Progress = True,
) -> Result:
    """Friction of a scene over the slide-roll ratio, sliding over entrainment, at its entrainment.

    Args:
        scene: A point contact whose surfaces translate (`RigidMotion`).
        slide_roll_ratios: The curve's places.
        accuracy, effects, out, processes, progress: As of `sweep`.

    Returns:
        A solution a place, in their order; `pyworm.plots.draw_traction` draws it.

    Raises:
        ValueError: Surfaces that do not translate, or a scene that cannot be planned.
    """
    tasks: list[Any] = [
        SceneTask(
            with_slide_roll_ratio(scene, ratio), _accuracy(accuracy), text("effects", effects)
        )
        for ratio in row("slide_roll_ratios", slide_roll_ratios)
    ]
    with ExitStack() as stack:
        directory = Path(stack.enter_context(TemporaryDirectory()) if out is None else out)
        told = stack.enter_context(progress_of(progress))
        workers = stack.enter_context(executor(processes, None))
        store = Store(directory.absolute() / SCENES, fields=True)
        reasons = solve_all(store.missing(tasks), store, workers, told)
        for task in tasks:
            if task.key in reasons:
                raise ValueError(f"{task.scene.name} has no solution: {reasons[task.key]}")
        solutions = tuple(store.result(task).solutions[0] for task in tasks)
    return Result(scene.name, {}, solutions, None, provenance({task.key: {} for task in tasks}))


def _of_file(
    path: str | Path,
    vary: Mapping[str, Any],
    executor: Executor | None,
    told: Progress | None,
    store: Store,
) -> Sweep:
    """The scenes of a sweep file."""
    if vary:
        raise ValueError(f"{', '.join(vary)}: a sweep file says itself what varies")
    return load_sweep(path, (1, 1), executor, told, store)


def _study(
    make: Callable[..., Scene | LineScene],
    title: str,
    vary: Mapping[str, Sequence[Any]],
    how: tuple[Any, ...],
    sent: bool,
) -> Sweep:
    """The scenes of all combinations, each planned before the first is solved."""
    if not callable(make):
        raise ValueError(f"make is a {type(make).__name__}: must be a function that makes a scene")
    if not vary or not all(len(values) for values in vary.values()):
        raise ValueError("nothing varies; name values of the function's arguments, load=(10, 20)")
    combinations = [dict(zip(vary, row, strict=True)) for row in product(*vary.values())]
    tasks: list[Any] = []
    for values in combinations:
        scene = make(**values)
        if not isinstance(scene, Scene | LineScene):
            raise ValueError(f"with {label(values)}: make gave a {type(scene).__name__}, no scene")
        task = SceneTask(scene, *how)
        try:
            _ = task.plan
        except ValueError as error:
            raise ValueError(f"with {label(values)}: {error}") from error
        if sent:
            require_sendable(task)
        tasks.append(task)
    written = {"vary": [{name: list(map(str, values))} for name, values in vary.items()]}
    return Sweep(
        title, title, written, [[name] for name in vary], tuple(combinations), tuple(tasks)
    )


def _accuracy(given: WithUnit) -> float:
    """An accuracy as a number."""
    return number("accuracy", given, kind_of(units.Share))
