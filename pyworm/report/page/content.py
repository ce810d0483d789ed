"""Content of a report: sections of paragraphs, lists, tables and pictures."""

from base64 import b64encode
from dataclasses import dataclass

from pyworm.report.table import Table


@dataclass(frozen=True)
class Picture:
    """A picture."""

    caption: str
    """What it shows."""
    png: bytes
    """The picture."""

    @property
    def base64(self) -> str:
        """The picture as text."""
        return b64encode(self.png).decode("ascii")


Block = str | tuple[str, ...] | Table | Picture
"""A paragraph, a list, a table or a picture."""

_NARROW = 2
"""Columns of tables that stand side by side where there is room."""


@dataclass(frozen=True)
class Section:
    """A part of the report under a heading."""

    title: str
    """Its heading."""
    blocks: tuple[Block, ...]
    """What stands under it, in order."""

    @property
    def narrow(self) -> bool:
        """Whether its blocks are narrow tables, more than stand on one line."""
        return len(self.blocks) > _NARROW and all(
            isinstance(block, Table) and len(block.head) <= _NARROW for block in self.blocks
        )


class Judged(str):
    """Cell of a table: value of a safety, empty where it stands elsewhere, with its verdict."""

    verdict: str
    """In words: "sufficient", "not sufficient" or "cannot be rated"."""

    def __new__(cls, value: str, verdict: str) -> "Judged":
        """Of a value and a verdict."""
        cell = super().__new__(cls, value)
        cell.verdict = verdict
        return cell


@dataclass(frozen=True)
class Cover:
    """The page to sign."""

    head: tuple[tuple[str, str], ...]
    """Drive, drawing, customer and the like, with their values."""
    basis: tuple[str, ...]
    """Standards and editions of the safeties, what of them was not read, and what is outside their scope."""
    geometry: tuple[tuple[str, str], ...]
    """Computed geometry of the gears, by name; empty where it is not known."""
    verdicts: Table
    """The safeties."""
    doubts: tuple[str, ...]
    """What in them is assumed or doubtful."""


@dataclass(frozen=True)
class Overleaf:
    """The page behind the page to sign."""

    figures: Table
    """Decisive figures with their error bars; life asked for, and what becomes of it."""
    pictures: tuple[Picture | str, ...]
    """Contact pattern, maps of the flank, wear."""
    assumptions: tuple[str, ...]
    """What all this rests on."""


@dataclass(frozen=True)
class Variants:
    """Variants side by side."""

    title: str
    """Title of the cases."""
    names: tuple[str, ...]
    """What the variants are called."""
    warnings: tuple[tuple[str, str], ...]
    """What a reader must know before all else, each with the name of its variant."""
    sections: tuple[Section, ...]
    """Tables with a column for each variant: inputs in which they differ, verdicts, figures."""
    pictures: tuple[tuple[tuple[str, Picture | str], ...], ...]
    """Rows of pictures, or paragraphs in place of one, each with the name of its variant."""
    note: str
    """What the bars mean."""


@dataclass(frozen=True)
class Report:
    """A report."""

    title: str
    """Title of the case."""
    source: str
    """Source of the case."""
    warnings: tuple[str, ...]
    """What a reader must know before all else, such as what did not converge."""
    sections: tuple[Section, ...]
    """Its parts, in order."""
    cover: Cover | None = None
    """The page to sign; None without safeties."""
    overleaf: Overleaf | None = None
    """The page behind it; None without it."""
