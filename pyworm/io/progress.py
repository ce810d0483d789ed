"""Progress of long work: a callable that takes a message and the fraction done."""

from collections.abc import Callable

Progress = Callable[[str, float], None]
