"""Common parts of commands: exit codes, messages, pictures, results, planned tasks, executors."""

import argparse
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.batch.workers import executor_of
from pyworm.case.case import Case
from pyworm.io.atomic import atomic_directory, check_writable, whole_file
from pyworm.io.input_error import CaseError
from pyworm.io.quantity import SHARE_KIND, Kind, parse
from pyworm.io.reason import reason_of
from pyworm.io.terminal import print_message, print_result
from pyworm.scene.index import INDEX_NAMES

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from pyworm.batch.request import Request
    from pyworm.batch.task import Task
    from pyworm.result.result import Result
    from pyworm.scene.index import ContactIndex


CONVERGED = 0
FAILED = 1
BAD_INPUT = 2
NOT_CONVERGED = 3

SWEEP_NAME, TABLE_NAME, SWEEP_PICTURE = "sweep.nc", "sweep.csv", "sweep.png"


PICTURES = ("scene_*.png", "mesh_cycle*.png", "traction.png", "life*.png")


def end_with(message: str, code: int) -> int:
    """Print a message on standard error and return the exit code."""
    print_message(message)
    return code


def drawn_pictures(
    directory: Path, draw: Callable[[Path], list[Path]], instead_of: Sequence[str] = ()
) -> tuple[list[str], bool]:
    """Draw pictures into a directory; a failure gives a message and nothing else is lost.

    Returns the names of those drawn, and whether these are all.
    """
    from pyworm.plots.attempts import PicturesError

    complete = True
    try:
        with atomic_directory(directory, instead_of) as aside:
            try:
                drawn = draw(aside)
            except PicturesError as error:
                print_message(f"{error}")
                drawn, complete = error.drawn, False
    except (OSError, MemoryError) as error:
        why = reason_of(error) if isinstance(error, MemoryError) else str(error)
        print_message(f"no pictures: {why}")
        return [], False
    return [path.name for path in drawn], complete


def warn_of_unusual(case: Case) -> None:
    """Print the warnings of a case."""
    for warning in case.warnings:
        print_message(f"warning: {warning}")


def warn_of_refusals(tasks: Sequence["Task"]) -> None:
    """Say, before anything is solved, which films the largest grid will not bring, each reason once."""
    reasons: dict[str, list[str]] = {}
    for task in tasks:
        if task.plan.refusal is not None:
            reasons.setdefault(task.plan.refusal, []).append(task.scene.name)
    for reason, names in reasons.items():
        print_message(
            f"warning: {', '.join(names)}: will not reach the requested accuracy: {reason}"
        )


def page_file(given: Path | None, default: Path) -> Path:
    """Where a page is written; CaseError if that is a directory, or not possible."""
    path = given or default
    if path.is_dir():
        raise CaseError(f"--out {path}: is a directory, a file such as {default.name} is needed")
    check_writable(path.parent)
    return path


def write_page(path: Path, page: str) -> None:
    """Write a page and print its path."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with whole_file(path) as partial:
        partial.write_text(page, encoding="utf-8")
    print_result(f"{path}")


def option_value(option: str, text: str, kind: Kind) -> float:
    """The value in SI of an option with a unit; CaseError of one that is none."""
    try:
        return parse(text, kind)
    except ValueError as error:
        raise CaseError(f"--{option} {text}: {error}") from None


def opened_result(path: Path) -> "Result":
    """A result file; CaseError if it is none, or is not there."""
    from pyworm.result.result import open_result

    try:
        return open_result(path)
    except (FileNotFoundError, ValueError) as error:
        raise CaseError(str(error)) from error


def wanted_places(case: Case, options: argparse.Namespace) -> "tuple[ContactIndex, ...]":
    """Places that the options ask for; phases without load, which are omitted, are named.

    CaseError where none of them is under load.
    """
    from pyworm.batch.request import requested_places

    wanted = {name: getattr(options, name) for name in INDEX_NAMES}
    return requested_places(
        case, wanted, "--phase", lambda words: print_message(f"warning: {words}")
    )


def planned_tasks(case: Case, options: argparse.Namespace) -> "list[Task]":
    """The tasks of a case, all planned before the first is solved."""
    request: Request = {"effects": options.effects, "quantities": options.quantities}
    if options.accuracy is not None:
        request["accuracy"] = option_value("accuracy", options.accuracy, SHARE_KIND)

    from pyworm.batch.request import planned

    return planned(case, wanted_places(case, options), request)


def batch_executor(options: argparse.Namespace) -> "AbstractContextManager[Executor | None]":
    """Context manager of the executor of a batch; None where this process solves it."""
    return executor_of(options.jobs, options.scheduler)
