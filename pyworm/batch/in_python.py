"""What calls from Python have in common: the case, processes, progress."""

from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Executor
from contextlib import AbstractContextManager, contextmanager
from numbers import Integral
from pathlib import Path
from typing import Any
from warnings import warn

from pyworm.batch.workers import executor_of
from pyworm.case.case import Case, load
from pyworm.io.console import progress_bar
from pyworm.io.given import text
from pyworm.io.progress import Progress
from pyworm.io.terminal import print_message
from pyworm.scene.plausibility import UnusualWarning

CaseLike = Case | str | Path | Mapping[str, Any]
"""A case, or what `pyworm.load` makes one of: the path of its file, or its tables."""


def as_case(case: CaseLike) -> Case:
    """A case, its file or its tables as a case, with an `UnusualWarning` for each unusual value."""
    case = case if isinstance(case, Case) else load(case)
    for sentence in case.warnings:
        warn(f"{case.name}: {sentence}", UnusualWarning, stacklevel=3)
    return case


def executor(processes: int, scheduler: str | None) -> AbstractContextManager[Executor | None]:
    """The processes that solve, on this machine or those of a scheduler; None for this one."""
    if isinstance(processes, bool) or not isinstance(processes, Integral) or processes < 1:
        raise ValueError(f"processes = {processes!r:.40}: must be a whole number from 1")
    if scheduler is not None:
        text("scheduler", scheduler)
    return executor_of(int(processes), scheduler)


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
