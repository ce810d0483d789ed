"""Stages of long work: named where they begin, and said by commands to whoever waits for them."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from threading import Event, Thread
from time import monotonic

from pyworm.io.terminal import print_message

PATIENCE = 3.0
"""Time after which a stage is said [s]."""

STILL_WORKING = "still"
"""First word of what is said of a stage."""


@dataclass(frozen=True, eq=False)
class Stage:
    """Work that may take longer than a reader of a silent terminal waits."""

    work: str
    """What is done, to follow "still"."""
    begun: float = field(default_factory=monotonic)
    """When it began, by the clock of `time.monotonic` [s]."""


_current: list[Stage] = []
"""Stages that have begun and not ended, innermost last."""


@contextmanager
def stage(work: str) -> Iterator[None]:
    """Name what is done within, such as "checking case.toml"."""
    begun = Stage(work)
    _current.append(begun)
    try:
        yield
    finally:
        _current.remove(begun)


@contextmanager
def long_stages_said() -> Iterator[None]:
    """Say on standard error, once for each, what stages within are that take longer than `PATIENCE`."""
    ended = Event()
    watch = Thread(target=_watch, args=(ended, PATIENCE), daemon=True)
    watch.start()
    try:
        yield
    finally:
        ended.set()
        watch.join()


def _watch(ended: Event, patience: float) -> None:
    said: list[Stage] = []
    while not ended.wait(patience / 6):
        innermost = _current[-1:]  # a copy: the stage may end meanwhile
        for running in innermost:
            if running not in said and monotonic() - running.begun > patience:
                said.append(running)
                print_message(f"{STILL_WORKING} {running.work}")
