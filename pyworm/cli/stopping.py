"""Handling of Ctrl-C (SIGINT) and SIGTERM.

Exit codes are those of shells, 128 and the number of the signal. Only the command line asks for this: in a
program that imports pyworm signals do what that program wants.
"""

import os
import signal
import sys
from contextlib import suppress
from types import FrameType

SIGNALS = signal.SIGINT, signal.SIGTERM

GRACE = 3.0
"""Time to end in an orderly way [s], which is enough on a busy machine too."""


class Stopped(KeyboardInterrupt):
    """A signal that asks the program to end."""

    def __init__(self, number: int) -> None:
        """By the signal of a number."""
        super().__init__()
        self.number = number
        """Number of the signal."""


def exit_code(stop: KeyboardInterrupt) -> int:
    """The exit code after an interrupt, which is one by SIGINT if nothing else is known."""
    return 128 + getattr(stop, "number", signal.SIGINT)


def end_at_once() -> None:
    """Let signals end this process at once."""
    for number in SIGNALS:
        signal.signal(number, _end)


def end_in_order() -> None:
    """Let a signal raise Stopped.

    That may be lost, as in a finaliser, and what it ends may hang, as a connection to a machine that is gone:
    the process ends without more ado at a second signal, and after `GRACE`.
    """
    for number in SIGNALS:
        signal.signal(number, _raise)


def end_if_stopped(code: int) -> None:
    """End at once with the exit code if a signal arrived, without the slow exit handlers of libraries."""
    if signal.getitimer(signal.ITIMER_REAL)[0] > 0:
        with suppress(OSError):
            sys.stdout.flush()
        os._exit(code)


def report_stopped() -> None:
    """Report on standard error that a signal ended the program, outside a command, which reports more."""
    os.write(2, b"pyworm: stopped\n")


def _end(number: int, frame: FrameType | None) -> None:
    report_stopped()
    os._exit(128 + number)


def _raise(number: int, frame: FrameType | None) -> None:
    end_at_once()
    signal.signal(signal.SIGALRM, lambda *_: _end(number, None))
    signal.setitimer(signal.ITIMER_REAL, GRACE)
    raise Stopped(number)
