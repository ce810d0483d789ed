"""Studies from Python: many scenes of a script, or a sweep file, to one table."""

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from contextlib import ExitStack
from dataclasses import replace
from functools import partial
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from pyworm.batch.case_run import SCENES
from pyworm.batch.in_python import executor, messages, progress_of
from pyworm.batch.scene_task import SceneTask, require_sendable
from pyworm.batch.solved_scenes import Store
from pyworm.batch.sweep import Sweep, label, load_sweep
from pyworm.batch.sweep_run import run_sweep
from pyworm.io import units
from pyworm.io.given import Names, WithUnit, kind_of, number, row
from pyworm.io.progress import Progress
from pyworm.planning.effects.selection import effect_names, quantity_names
from pyworm.result.sweep_result import SweepResult
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.scene.slide_roll import with_slide_roll_ratio


def sweep(
    make: str | Path | Callable[..., Scene | LineScene],
    *,
    out: str | Path | None = None,
    accuracy: WithUnit = 0.01,
    effects: Names = "auto",
    quantities: Names | None = None,
    fields: bool = False,
    processes: int = 1,
    scheduler: str | None = None,
    progress: bool | Progress = True,
    title: str = "study",
    largest_grid: int | None = None,
    together: Mapping[str, Sequence[Any]] | None = None,
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
        progress, title: Whether a bar shows the progress, or what is called instead; heading of the picture.
        largest_grid: Nodes beyond which no grid is refined, which ends dear scenes unconverged; not of a
            sweep file.
        together: Values of arguments that vary together, such as those of `pyworm.draw`.
        **vary: Values of each argument of `make`; all are crossed, the last one changing fastest.

    Returns:
        `dataset` has the results over the varied names, NaN where there is no solution; `table` has a row a
        scene; `solutions` are there with `fields`.

    Raises:
        ValueError: Nothing to vary, a scene that is none, cannot be planned, or cannot go to other processes.
    """
    with ExitStack() as stack:
        where = stack.enter_context(TemporaryDirectory()) if out is None else out
        folder = Path(where).absolute()
        told = stack.enter_context(progress_of(progress))
        pool = stack.enter_context(executor(processes, scheduler))
        store = Store(folder / SCENES, fields)
        if isinstance(make, str | Path):
            study = _of_file(make, vary, pool, told, store)
        else:
            how = effect_names(effects), quantity_names(quantities), largest_grid
            if together is not None and not isinstance(together, Mapping):
                raise ValueError(
                    f'together = {together!r:.40}: must be values by name, such as {{"load": (10, 20)}}'
                )
            axes = [{name: values} for name, values in vary.items()] + [together or {}]
            study = _study(make, title, axes, (_accuracy(accuracy), *how), pool is not None)
        found = run_sweep(study, folder, fields, pool, told, messages(progress))
        return _with_solutions(found, study, store) if fields else found


def _with_solutions(found: SweepResult, study: Sweep, store: Store) -> SweepResult:
    """A sweep with its solutions in full, of the scenes that have one."""
    solved = [task for task in study.tasks if store.holds(task)]
    return replace(found, solutions=tuple(store.result(task).solutions[0] for task in solved))


def traction_curve(
    scene: Scene,
    slide_roll_ratios: Sequence[float],
    *,
    accuracy: WithUnit = 0.01,
    effects: Names = "auto",
    out: str | Path | None = None,
    processes: int = 1,
    progress: bool | Progress = True,
) -> SweepResult:
    """Friction of a scene over the slide-roll ratio, sliding over entrainment, at its entrainment.

    Args:
        scene: A point contact whose surfaces translate (`RigidMotion`).
        slide_roll_ratios: The curve's places.
        accuracy, effects, out, processes, progress: As of `sweep`.

    Returns:
        The sweep over `slide_roll_ratio` with its solutions; `pyworm.plots.draw_traction` draws its
        `result`.

    Raises:
        ValueError: Surfaces that do not translate, or a scene that cannot be planned.
    """
    return sweep(
        partial(_at_ratio, scene),
        slide_roll_ratio=tuple(row("slide_roll_ratios", slide_roll_ratios)),
        accuracy=accuracy,
        effects=effects,
        out=out,
        processes=processes,
        progress=progress,
        fields=True,
        title=scene.name,
    )


def _at_ratio(scene: Scene, slide_roll_ratio: float) -> Scene:
    return with_slide_roll_ratio(scene, slide_roll_ratio)


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
    axes: Sequence[Mapping[str, Sequence[Any]]],
    how: tuple[Any, ...],
    sent: bool,
) -> Sweep:
    """The scenes of all combinations, each planned before the first is solved."""
    if not callable(make):
        raise ValueError(f"make is a {type(make).__name__}: must be a function that makes a scene")
    axes = [axis for axis in axes if axis]
    combinations = [
        {name: value for part in parts for name, value in part.items()}
        for parts in product(*map(_in_step, axes))
    ]
    if not axes or not combinations:
        raise ValueError("nothing varies; name values of the function's arguments, load=(10, 20)")
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
    written = {
        "vary": [{name: list(map(str, axis[name])) for name in axis} for axis in axes],
    }
    return Sweep(title, title, written, list(map(list, axes)), tuple(combinations), tuple(tasks))


def _in_step(axis: Mapping[str, Sequence[Any]]) -> list[dict[str, Any]]:
    """The values of names that vary together, one by one; ValueError where one has more."""
    counts = {name: len(row(name, values)) for name, values in axis.items()}
    if len(set(counts.values())) > 1:
        listed = ", ".join(f"{name} has {count} values" for name, count in counts.items())
        raise ValueError(f"together: {listed}; give the same number")
    return [dict(zip(axis, values, strict=True)) for values in zip(*axis.values(), strict=True)]


def _accuracy(given: WithUnit) -> float:
    """An accuracy as a number."""
    return number("accuracy", given, kind_of(units.Share))
