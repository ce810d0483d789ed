"""A report as one self-contained page of HTML, without script or network."""

from base64 import b64encode
from html import escape
from pathlib import Path

from pyworm.report.page.content import (
    Block,
    Cover,
    Items,
    Picture,
    Report,
    Section,
    Table,
    Words,
)

_STYLE = Path(__file__).with_name("page.css")

_SHORT = 12
"""Letters up to which a cell is not broken into lines."""

_NARROW = 2
"""Columns of tables that stand side by side where there is room."""


def render(report: Report) -> str:
    """The page.

    Parameters
    ----------
    report : Report
        Text of the element.
    """
    contents = "\n".join(
        f'<li><a href="#part-{number}">{escape(section.title)}</a></li>'
        for number, section in enumerate(report.sections, 1)
    )
    warnings = "\n".join(f'<p class="warning">{escape(of)}</p>' for of in report.warnings)
    opening = warnings if report.cover is None else _cover(report.cover, warnings)
    parts = "\n".join(_section(number, of) for number, of in enumerate(report.sections, 1))
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{escape(report.title)}</title>
<style>
{_STYLE.read_text(encoding="utf-8")}</style>
</head>
<body>
<header>
<h1>{escape(report.title)}</h1>
<p class="source">{escape(report.source)}</p>
{opening}
<nav><ol>
{contents}
</ol></nav>
</header>
<main>
{parts}
</main>
</body>
</html>
"""


def _cover(cover: Cover, warnings: str) -> str:
    """Head, verdicts with colours and words, what a signer must know, and lines to sign."""
    head = "\n".join(
        f"<div><dt>{escape(name)}</dt><dd>{escape(value)}</dd></div>" for name, value in cover.head
    )
    rows = "\n".join(
        f'<tr><th scope="row">{escape(of.what)}</th><td>{escape(of.value)}</td>'
        f"<td>{escape(of.required)}</td>"
        f'<td><span class="verdict {of.words.replace(" ", "-")}">{escape(of.words)}</span></td>'
        f"<td>{escape(of.why)}</td></tr>"
        for of in cover.verdicts
    )
    return f"""<section class="cover">
<dl>
{head}
</dl>
<div class="wide"><table>
<thead><tr><th>Safety</th><th>Value</th><th>Required</th><th>Verdict</th><th>Made of</th></tr></thead>
<tbody>
{rows}
</tbody></table></div>
{warnings}
<p class="sign"><span>Calculated</span><span>Checked</span><span>Released</span></p>
</section>"""


def _section(number: int, section: Section) -> str:
    blocks = "\n".join(_block(block) for block in section.blocks)
    tables = [block for block in section.blocks if isinstance(block, Table)]
    narrow = len(tables) == len(section.blocks) > _NARROW and all(
        len(table.head) <= _NARROW for table in tables
    )
    inside = f'<div class="parts">\n{blocks}\n</div>' if narrow else blocks
    return f'<section id="part-{number}">\n<h2>{escape(section.title)}</h2>\n{inside}\n</section>'


def _block(block: Block) -> str:
    match block:
        case Words(text):
            return f"<p>{escape(text)}</p>"
        case Items(items):
            return "<ul>\n" + "\n".join(f"<li>{escape(of)}</li>" for of in items) + "\n</ul>"
        case Picture(caption, png):
            data = b64encode(png).decode("ascii")
            return (
                f'<figure>\n<img alt="{escape(caption)}" src="data:image/png;base64,{data}">\n'
                f"<figcaption>{escape(caption)}</figcaption>\n</figure>"
            )
        case Table():
            return _table(block)


def _table(table: Table) -> str:
    lines = ['<div class="wide"><table>']
    if table.title:
        lines.append(f"<caption>{escape(table.title)}</caption>")
    if any(table.head):
        cells = "".join(f'<th scope="col">{escape(of)}</th>' for of in table.head)
        lines.append(f"<thead><tr>{cells}</tr></thead>")
    lines.append("<tbody>")
    for name, *cells in table.rows:
        part = ' class="part"' if name.startswith(" ") else ""
        first = f'<th scope="row"{part}>{_words(name.strip())}</th>'
        lines.append(f"<tr>{first}{''.join(_cell(of) for of in cells)}</tr>")
    lines.append("</tbody></table></div>")
    if table.note:
        lines.append(f'<p class="note">{escape(table.note)}</p>')
    return "\n".join(lines)


def _cell(text: str) -> str:
    mark = ' class="no"' if text.startswith("NO: ") else ""
    value, sign, bar = text.partition(" ± ")
    if not sign:
        return f"<td{mark}>{_words(text)}</td>"
    # A line may break before the error bar, and nowhere else.
    return f"<td{mark}>{_kept(value)} {_kept(f'± {bar}')}</td>"


def _words(text: str) -> str:
    """Text of a cell; a number with its unit stays on one line."""
    return _kept(text) if len(text) <= _SHORT else escape(text)


def _kept(text: str) -> str:
    return f'<span class="kept">{escape(text)}</span>'
