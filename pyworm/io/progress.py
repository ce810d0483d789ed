"""Progress of long work: a callable that takes a message and the fraction done, and its lines in a log.

A log of jobs that nobody watches has a line at the start, at each tenth and at the end.
"""

from collections.abc import Callable

Progress = Callable[[str, float], None]

LOG_LINES = 10
"""Lines from start to end."""


def log_lines(print_message: Callable[[str], None], name: str) -> Progress:
    """A progress that prints a line, with a name, at the start of each kind of work and each tenth of it."""
    reached = -1

    def tell(message: str, fraction: float) -> None:
        nonlocal reached
        part = int(LOG_LINES * fraction + 1e-9)
        if part > reached or (part == 0 and reached != 0):
            reached = part
            print_message(f"{name}: {100 * fraction:.0f} %, {message}")

    return tell


def marks_tenth(number: int, count: int) -> bool:
    """Whether one of some scenes, counted from 1, is the first, the last, or completes a tenth of all."""
    return number == 1 or LOG_LINES * number // count > LOG_LINES * (number - 1) // count
