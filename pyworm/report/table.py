"""A table of text, built once and rendered on a terminal by rich and on a page in HTML."""

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

import rich.console
import rich.table
from rich.box import HEAVY_HEAD, SIMPLE_HEAD

from pyworm.report.page.symbols import typeset

SHORT = 12
"""Letters up to which a cell of a page is not broken into lines."""

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


def html(table: Table) -> str:
    """The table on a page."""
    lines = ['<div class="wide"><table>']
    if table.title:
        lines.append(f"<caption>{escape(table.title.replace(chr(10), '; '))}</caption>")
    if any(table.head):
        cells = "".join(f'<th scope="col">{typeset(heading)}</th>' for heading in table.head)
        lines.append(f"<thead><tr>{cells}</tr></thead>")
    lines.append("<tbody>")
    lines += [_row(row, len(table.head)) for row in table.rows if row]
    lines.append("</tbody></table></div>")
    if table.note:
        lines.append(f'<p class="note">{typeset(table.note)}</p>')
    return "\n".join(lines)


def _row(row: Sequence[str], columns: int) -> str:
    name, *values = row
    part = ' class="part"' if name.startswith(" ") else ""
    first = f'<th scope="row"{part}>{_words(name.strip())}</th>'
    values += [""] * (columns - len(row))
    return f"<tr>{first}{''.join(html_cell(value) for value in values)}</tr>"


def html_cell(text: str) -> str:
    """A cell of a page; a figure is broken into lines before its error bar alone."""
    mark = ' class="no"' if text.startswith("NO: ") else ""
    value, sign, bar = text.partition(" ± ")
    if not sign:
        return f"<td{mark}>{_words(text)}</td>"
    return f"<td{mark}>{unbroken(value)} {unbroken(f'± {bar}')}</td>"


def _words(text: str) -> str:
    """Text of a cell; a number with its unit stays on one line."""
    return unbroken(text) if len(text) <= SHORT else typeset(text)


def unbroken(text: str) -> str:
    """Text of a page on one line."""
    return f'<span class="kept">{typeset(text)}</span>'
