"""A table of text, built once: on a terminal by rich, on a page by the macro of `macros.html`."""

from dataclasses import dataclass

import rich.console
import rich.table
from rich.box import HEAVY_HEAD, SIMPLE_HEAD

UNBROKEN = 24
"""Letters up to which a cell of a terminal's table is not broken into lines."""


@dataclass(frozen=True)
class Table:
    """A table of text; the first column names its rows."""

    head: tuple[str, ...]
    """Headings; the first may be empty."""
    rows: tuple[tuple[str, ...], ...]
    """Cells, on the right fewer than headings where the others are empty; a row without any is a rule. A
    scene that did not converge has a cell with that statement."""
    title: str = ""
    """Title above it."""
    note: str = ""
    """Note below it."""
    texts: tuple[int, ...] = ()
    """Columns of words beside the first, which a terminal breaks into lines; the others are right-aligned."""
    narrow: bool = False
    """Whether it never has lines between its columns, which leave more of a terminal's width to them."""

    def column(self, number: int) -> tuple[str, ...]:
        """Cells of a column, empty where a row has none."""
        return tuple(row[number] if number < len(row) else "" for row in self.rows if row)

    def __rich_console__(
        self, console: rich.console.Console, options: rich.console.ConsoleOptions
    ) -> rich.console.RenderResult:
        """The table on a terminal: between lines, or without them where these make it too wide."""
        fits = self._framed_width <= options.max_width
        yield self._drawn(framed=fits and not self.narrow)

    @property
    def _framed_width(self) -> int:
        """Letters of a line of the table between lines, where none but long cells and words are broken."""
        width = 1 + 3 * len(self.head)
        for number, heading in enumerate(self.head):
            cells = (heading, *self.column(number))
            longest = max(len(line) for cell in cells for line in cell.split("\n"))
            breaks = number in self.texts or (longest > UNBROKEN and number > 0)
            width += min(longest, UNBROKEN) if breaks else longest
        return width

    def _drawn(self, framed: bool) -> rich.table.Table:
        table = rich.table.Table(
            title=self.title or None,
            caption=self.note or None,
            show_header=any(self.head),
            title_justify="left",
            caption_justify="left",
            box=HEAVY_HEAD if framed else SIMPLE_HEAD,
            padding=(0, 1) if framed else (0, 1, 0, 0),
            pad_edge=framed,
        )
        for number, heading in enumerate(self.head):
            text = number == 0 or number in self.texts
            longest = max(map(len, self.column(number)), default=0)
            whole = bool(self.texts) if number == 0 else not text and longest <= UNBROKEN
            table.add_column(
                heading,
                justify="left" if text else "right",
                no_wrap=whole and number not in self.texts,
                overflow="fold",
            )
        for row in self.rows:
            if row:
                table.add_row(*row)
            else:
                table.add_section()
        return table
