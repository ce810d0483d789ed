"""Pictures drawn one by one, so that a failure does not affect the others."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path

from matplotlib.figure import Figure

from pyworm.io.free_memory import available
from pyworm.io.reason import reason_of
from pyworm.plots.layout import write

ROOM = 3e8
"""Memory that a picture may need, with the libraries that it is the first to load [bytes].

Where there is less they end the process by a signal. 0.21e9 were measured (`test_failed_pictures.py`)."""


class PicturesError(RuntimeError):
    """Some pictures could not be drawn, the others exist; the message is one sentence."""

    def __init__(self, message: str, drawn: list[Path]) -> None:
        """From the reasons of failures and the pictures drawn."""
        super().__init__(message)
        self.drawn = drawn
        """Pictures that are there."""


@dataclass
class Attempts:
    """Pictures drawn and reasons of failures."""

    drawn: list[Path] = field(default_factory=list)
    """Files of those drawn."""
    failed: dict[str, str] = field(default_factory=dict)
    """Name of each other one, and why there is none."""

    def draw(self, path: Path, figure: Callable[[], Figure | None]) -> None:
        """Draw a picture into a file, if there is anything to draw; an exception becomes the reason."""
        try:
            if available() < ROOM:
                raise MemoryError
            drawing = figure()
            if drawing is not None:
                self.drawn.append(write(drawing, path))
        except Exception as error:
            self.failed[path.name] = reason_of(error)
            path.unlink(missing_ok=True)

    def add(self, others: "Attempts") -> None:
        """Add the outcome of other attempts."""
        self.drawn += others.drawn
        self.failed |= others.failed

    def result(self) -> list[Path]:
        """The files; PicturesError if some are missing."""
        if self.failed:
            parts = (f"{_listed(names)}: {why}" for why, names in _by_reason(self.failed))
            raise PicturesError(f"not drawn: {'; '.join(parts)}", self.drawn)
        return self.drawn


def _by_reason(failed: dict[str, str]) -> Iterable[tuple[str, list[str]]]:
    reasons: dict[str, list[str]] = {}
    for name, why in failed.items():
        reasons.setdefault(why, []).append(name)
    return reasons.items()


MAX_NAMED_PICTURES = 3
"""Largest number of pictures that a sentence names; of more it gives the number."""


def _listed(names: list[str]) -> str:
    more = len(names) - MAX_NAMED_PICTURES
    return ", ".join(names[:MAX_NAMED_PICTURES]) + (f" and {more} more" if more > 0 else "")
