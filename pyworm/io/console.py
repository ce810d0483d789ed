"""Tables and progress bars on a terminal, by rich."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import rich.console
from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn
from rich.text import Text

from pyworm.io.terminal import encoding_of, plain, silence


class Console(rich.console.Console):
    """A console that shows text unchanged: no markup, no emoji, no highlighting of numbers."""

    def __init__(self, stderr: bool = False):
        super().__init__(stderr=stderr, markup=False, emoji=False, highlight=False)

    @property
    def encoding(self) -> str:
        """The encoding of what is written; of ASCII, lines of tables are made of - and |."""
        return encoding_of(self.file).lower()

    def render_str(self, text: str, **how: Any) -> Text:
        """A text, a title or a cell, as the stream can show it."""
        return super().render_str(plain(text, self.file), **how)

    def on_broken_pipe(self) -> None:
        """Continue without a reader: a closed pipe is no error."""
        silence(self.file)


@contextmanager
def progress_bar() -> Iterator[Callable[[str, float], None] | None]:
    """Show a progress bar on standard error if that is a terminal, or in a notebook; nothing otherwise.

    Yields what is called with the work at hand and the fraction of all that is done, 0 to 1; None without a
    bar.
    """
    console = Console(stderr=True)
    if not (sys.stderr.isatty() or console.is_jupyter):
        yield None
        return
    columns = (
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        TaskProgressColumn(markup=False),
        TimeRemainingColumn(),
    )
    # Scenes may take minutes: the remaining time is estimated from the last ten.
    period = 600.0
    with Progress(*columns, console=console, transient=True, speed_estimate_period=period) as bar:
        task = bar.add_task("", total=1.0)

        def show(message: str, share: float) -> None:
            if share == 0:  # another kind of work, at another pace
                bar.reset(task)
            bar.update(task, description=plain(message, sys.stderr), completed=share)

        yield show
