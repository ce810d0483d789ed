"""What calls from Python have in common: the case, its contacts that are asked for, processes, progress."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from typing import Any
from warnings import warn

from pyworm.batch.task import Task
from pyworm.batch.workers import executor_of
from pyworm.case.case import Case, load
from pyworm.io import units
from pyworm.io.console import progress_bar
from pyworm.io.given import WithUnit, kind_of, number, row
from pyworm.io.input_error import CaseError
from pyworm.io.progress import Progress
from pyworm.io.stage import stage
from pyworm.io.terminal import print_message
from pyworm.planning.effects.selection import Effects, as_text
from pyworm.scene.index import INDEX_NAMES, ContactIndex
from pyworm.scene.plausibility import UnusualWarning

CaseLike = Case | str | Path | Mapping[str, Any]
"""A case, or what `pyworm.load` makes one of: the path of its file, or its tables."""


def as_case(case: CaseLike) -> Case:
    """A case, its file or its tables as a case, with an `UnusualWarning` for each unusual value."""
    case = case if isinstance(case, Case) else load(case)
    for sentence in case.warnings:
        warn(f"{case.name}: {sentence}", UnusualWarning, stacklevel=3)
    return case


def requested_places(
    case: Case,
    wanted: Mapping[str, Sequence[Any] | None],
    key: str = "phases",
    say: Callable[[str], None] = lambda message: None,
) -> tuple[ContactIndex, ...]:
    """Contacts of a case that are asked for; phases without load, which are omitted, are named.

    Args:
        wanted: Sections, phases, stations and slide-roll ratios, by the names of `ContactIndex`; by default
            the case's.
        key: What phases are called where they are asked for.

    Raises:
        CaseError: None of the phases is under load.
    """
    phases = wanted.get("phase") or ()
    idle = case.idle_phases(asked := phases or case.mesh_places.get("phase", ()))
    words = ", ".join(f"{phase:g}" for phase in idle)
    if idle and len(idle) == len(asked):
        loaded = ", ".join(f"{phase:g}" for phase in case.phases_under_load) or "none of its tenths"
        raise CaseError(
            f"{case.name}: {key if phases else 'operation.phases'} {words}: neighbouring teeth carry all of "
            f"the load; the pair carries some at {loaded}"
        )
    if phases and idle:
        say(f"{key} {words}: neighbouring teeth carry all of the load; not solved")
    return case.places(**{name: wanted.get(name) for name in INDEX_NAMES})


def planned(
    case: Case,
    places: Sequence[ContactIndex],
    accuracy: float | None = None,
    effects: str | None = None,
    quantities: Sequence[str] | None = None,
) -> list[Task]:
    """The tasks of a case, all planned before the first is solved.

    Args:
        places: Contacts.
        accuracy, effects, quantities: As of `pyworm.plan`; by default the case's.

    Raises:
        CaseError: One cannot be planned.
    """
    how = (
        case.accuracy if accuracy is None else accuracy,
        effects or case.effects,
        case.quantities if quantities is None else tuple(quantities),
    )
    tasks = [Task(case, place, *how) for place in places]
    try:
        with stage(f"planning {len(tasks)} contacts"):
            for task in tasks:
                _ = task.plan
    except ValueError as error:
        raise CaseError(str(error)) from error
    return tasks


def requested(
    case: Case,
    accuracy: WithUnit | None,
    effects: Effects | None,
    quantities: Sequence[str] | None,
    phases: Sequence[float] | None,
    **places: Sequence[Any] | None,
) -> list[Task]:
    """Tasks of a case as a script asks for them, with an `UnusualWarning` for phases without load."""

    def said(sentence: str) -> None:
        warn(f"{case.name}: {sentence}", UnusualWarning, stacklevel=4)

    return planned(
        case,
        requested_places(case, {"phase": phases, **places}, say=said),
        None if accuracy is None else number("accuracy", accuracy, kind_of(units.Share)),
        None if effects is None else as_text(effects),
        None if quantities is None else tuple(row("quantities", quantities)),
    )


def executor(processes: int, scheduler: str | None) -> AbstractContextManager[Executor | None]:
    """The processes that solve, on this machine or those of a scheduler; None for this one."""
    if isinstance(processes, bool) or not isinstance(processes, int) or processes < 1:
        raise ValueError(f"processes = {processes!r:.40}: must be a whole number from 1")
    return executor_of(processes, scheduler)


@contextmanager
def progress_of(wanted: bool | Progress) -> Iterator[Progress | None]:
    """A bar, a function that is called instead, or nothing."""
    if callable(wanted):
        yield wanted
    elif wanted:
        with progress_bar() as bar:
            yield bar
    else:
        yield None


def messages(wanted: bool | Progress) -> Callable[[str], None]:
    """What prints messages where progress is wanted, and nothing else."""
    return print_message if wanted else _silent


def _silent(message: str) -> None:
    """Where no progress is wanted."""
