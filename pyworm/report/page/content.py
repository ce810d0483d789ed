"""Content of a report: sections of paragraphs, lists, tables and pictures."""

from dataclasses import dataclass

from pyworm.report.table import Table


@dataclass(frozen=True)
class Words:
    """A paragraph."""

    text: str
    """Its sentences."""


@dataclass(frozen=True)
class Items:
    """A list."""

    items: tuple[str, ...]
    """Its entries."""


@dataclass(frozen=True)
class Picture:
    """A picture."""

    caption: str
    """What it shows."""
    png: bytes
    """The picture."""


Block = Words | Items | Table | Picture


@dataclass(frozen=True)
class Section:
    """A part of the report under a heading."""

    title: str
    """Its heading."""
    blocks: tuple[Block, ...]
    """What stands under it, in order."""


@dataclass(frozen=True)
class Verdict:
    """A safety as it is signed."""

    what: str
    """Its name."""
    value: str
    """Its value."""
    required: str
    """The least value that is required."""
    words: str
    """In words: "sufficient", "not sufficient" or "cannot be rated"."""
    clause: str
    """Where the standard has it."""
    why: str
    """What it is made of, or why it is not rated."""


@dataclass(frozen=True)
class Cover:
    """The page to sign."""

    head: tuple[tuple[str, str], ...]
    """Drive, drawing, customer and the like, with their values."""
    basis: Items
    """Standards and editions of the safeties, what of them was not read, and what is outside their scope."""
    geometry: tuple[tuple[str, str], ...]
    """Computed geometry of the gears, by name; empty where it is not known."""
    verdicts: tuple[Verdict, ...]
    """The safeties."""
    doubts: Items
    """What in them is assumed or doubtful."""


@dataclass(frozen=True)
class Overleaf:
    """The page behind the page to sign."""

    figures: Table
    """Decisive figures with their error bars; life asked for, and what becomes of it."""
    pictures: tuple[Picture | Words, ...]
    """Contact pattern, maps of the flank, wear."""
    assumptions: Items
    """What all this rests on."""


@dataclass(frozen=True)
class Matrix:
    """Rows of variants side by side."""

    rows: tuple[tuple[str, tuple[str, ...]], ...]
    """Name of a row and its cells, one for each variant."""


@dataclass(frozen=True)
class Beside:
    """Pictures of one variant."""

    name: str
    """What the variant is called."""
    pictures: tuple[Picture | Words, ...]
    """Its pictures, or a paragraph in place of one."""


@dataclass(frozen=True)
class Variants:
    """Variants side by side."""

    title: str
    """Title of the cases."""
    names: tuple[str, ...]
    """What the variants are called."""
    warnings: tuple[str, ...]
    """What a reader must know before all else."""
    differences: Matrix
    """Inputs in which they differ."""
    verdicts: Matrix
    """Safeties as "value|verdict"."""
    figures: Matrix
    """Simulated figures with their bars."""
    beside: tuple[Beside, ...]
    """Their pictures."""
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
