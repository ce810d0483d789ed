"""A report as one self-contained page of HTML, without script or network."""

from base64 import b64encode
from collections.abc import Callable
from html import escape
from pathlib import Path

from pyworm.report.page.content import (
    Block,
    Cover,
    Items,
    Matrix,
    Overleaf,
    Picture,
    Report,
    Section,
    Variants,
    Words,
)
from pyworm.report.page.symbols import typeset
from pyworm.report.policy import policy
from pyworm.report.table import Table, html, html_cell, unbroken

_STYLE = Path(__file__).with_name("page.css")

_NARROW = 2
"""Columns of tables that stand side by side where there is room."""


def render(report: Report) -> str:
    """The page of a report."""
    contents = "\n".join(
        f'<li><a href="#part-{number}">{escape(section.title)}</a></li>'
        for number, section in enumerate(report.sections, 1)
    )
    warnings = "\n".join(
        f'<p class="warning">{typeset(warning)}</p>' for warning in report.warnings
    )
    opening = warnings if report.cover is None else _cover(report.cover, warnings)
    if report.overleaf is not None:
        opening += _overleaf(report.overleaf)
    parts = "\n".join(
        _section(number, section) for number, section in enumerate(report.sections, 1)
    )
    content = f"""<header>
<h1>{escape(report.title)}</h1>
<p class="source">{escape(report.source)}</p>
{opening}
<nav><ol>
{contents}
</ol></nav>
</header>
<main>
{parts}
</main>"""
    return _page(report.title, content)


def render_variants(variants: Variants) -> str:
    """The page of variants side by side."""
    warnings = "\n".join(
        f'<p class="warning">{escape(warning)}</p>' for warning in variants.warnings
    )
    parts = (
        ("What differs", variants.differences, html_cell),
        ("Verdicts", variants.verdicts, _judged),
        ("Figures", variants.figures, html_cell),
    )
    tables = "\n".join(
        f"<h2>{title}</h2>\n{_side_by_side(variants.names, matrix, cell)}"
        for title, matrix, cell in parts
        if matrix.rows
    )
    count = max(len(variant.pictures) for variant in variants.beside)
    rows = "\n".join(
        '<div class="columns">'
        + "".join(
            f"<div><h3>{escape(variant.name)}</h3>{_block(variant.pictures[n])}</div>"
            for variant in variants.beside
            if n < len(variant.pictures)
        )
        + "</div>"
        for n in range(count)
    )
    content = f"""<header>
<h1>{escape(variants.title)}: {len(variants.names)} variants</h1>
{warnings}
</header>
<main class="variants">
{tables}
<p class="note">{typeset(variants.note)}</p>
{rows}
</main>"""
    return _page(variants.title, content)


def _side_by_side(names: tuple[str, ...], matrix: Matrix, cell: Callable[[str], str]) -> str:
    """Rows of variants as a table."""
    head = "".join(f'<th scope="col">{escape(name)}</th>' for name in names)
    rows = "\n".join(
        f'<tr><th scope="row">{typeset(name)}</th>{"".join(map(cell, cells))}</tr>'
        for name, cells in matrix.rows
    )
    return (
        f'<div class="wide"><table class="matrix"><thead><tr><th></th>{head}</tr></thead>\n<tbody>\n{rows}\n'
        "</tbody></table></div>"
    )


def _judged(cell: str) -> str:
    """A safety of a variant with its verdict."""
    value, _, verdict = cell.partition("|")
    return f"<td>{unbroken(value)} {badge(verdict)}</td>" if verdict else "<td></td>"


def _page(title: str, content: str) -> str:
    """A page with its style."""
    style = _STYLE.read_text(encoding="utf-8")
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
{policy(style)}
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{escape(title)}</title>
<style>{style}</style>
</head>
<body>
{content}
</body>
</html>
"""


def _cover(cover: Cover, warnings: str) -> str:
    """Head, verdicts with colours and words, what a signer must know, and lines to sign."""
    rows = "\n".join(
        f'<tr><th scope="row">{typeset(verdict.what)}</th><td>{unbroken(verdict.value)}</td>'
        f"<td>{escape(verdict.required)}</td><td>{badge(verdict.words)}</td><td>{escape(verdict.clause)}</td>"
        f"<td>{typeset(verdict.why)}</td></tr>"
        for verdict in cover.verdicts
    )
    doubts = f"<h3>Assumed or doubtful</h3>\n{_block(cover.doubts)}" if cover.doubts.items else ""
    lines = "".join(
        f"<span>{who}: date, name</span>" for who in ("Calculated", "Checked", "Released")
    )
    geometry = (
        f'<h3>Geometry as computed</h3>\n<dl class="geometry">\n{_head(cover.geometry)}\n</dl>'
        if cover.geometry
        else ""
    )
    basis = f'<div class="basis">{_block(cover.basis)}</div>' if cover.basis.items else ""
    return f"""<section class="cover">
<dl>
{_head(cover.head)}
</dl>
{geometry}
{basis}
<div class="wide"><table>
<thead><tr><th>Safety factor</th><th>Value</th><th>Required</th><th>Verdict</th><th>By</th>
<th>Inputs</th></tr></thead>
<tbody>
{rows}
</tbody></table></div>
{doubts}
{warnings}
<p class="sign">{lines}</p>
</section>"""


def _head(head: tuple[tuple[str, str], ...]) -> str:
    return "\n".join(
        f"<div><dt>{escape(name)}</dt><dd>{escape(value)}</dd></div>" for name, value in head
    )


def badge(verdict: str) -> str:
    """A verdict in its colour."""
    kind = verdict.partition(",")[0].replace(" ", "-")
    return f'<span class="verdict {kind}">{escape(verdict)}</span>'


def _overleaf(page: Overleaf) -> str:
    """What the verdicts rest on."""
    pictures = "\n".join(_block(picture) for picture in page.pictures)
    return f"""
<section class="overleaf">
<h2>What the verdicts rest on</h2>
{html(page.figures)}
<div class="flanks">
{pictures}
</div>
<h3>Assumptions</h3>
{_block(page.assumptions)}
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
            return f"<p>{typeset(text)}</p>"
        case Items(items):
            return "<ul>\n" + "\n".join(f"<li>{typeset(item)}</li>" for item in items) + "\n</ul>"
        case Picture(caption, png):
            data = b64encode(png).decode("ascii")
            return (
                f'<figure>\n<img alt="{escape(caption)}" src="data:image/png;base64,{data}">\n'
                f"<figcaption>{escape(caption)}</figcaption>\n</figure>"
            )
        case Table():
            return html(block)
