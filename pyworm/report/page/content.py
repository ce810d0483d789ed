"""Content of a report: sections of paragraphs, lists, tables and pictures."""

from dataclasses import dataclass

from pyworm.report.table import Table


@dataclass(frozen=True)
class Words:
    """A paragraph."""

    text: str


@dataclass(frozen=True)
class Items:
    """A list.

    Attributes
    ----------
    items : tuple of str
        Its entries.
    """

    items: tuple[str, ...]


@dataclass(frozen=True)
class Picture:
    """A picture.

    Attributes
    ----------
    caption : str
        What it shows.
    png : bytes
        The picture.
    """

    caption: str
    png: bytes


Block = Words | Items | Table | Picture


@dataclass(frozen=True)
class Section:
    """A part of the report under a heading."""

    title: str
    blocks: tuple[Block, ...]


@dataclass(frozen=True)
class Verdict:
    """A safety as it is signed.

    Attributes
    ----------
    what, value, required : str
        Its name, value and the least that is required.
    words : str
        "sufficient", "not sufficient" or "cannot be rated".
    clause : str
        Where the standard has it.
    why : str
        What it is made of, or why it is not rated.
    """

    what: str
    value: str
    required: str
    words: str
    clause: str
    why: str


@dataclass(frozen=True)
class Cover:
    """The page to sign.

    Attributes
    ----------
    head : tuple of tuple of str
        Drive, drawing, customer and the like, with their values.
    basis : Items
        Standards and editions of the safeties, what of them was not read, and what is outside their scope.
    geometry : tuple of tuple of str
        Computed geometry of the gears, by name; empty where it is not known.
    verdicts : tuple of Verdict
        The safeties.
    doubts : Items
        What in them is assumed or doubtful.
    """

    head: tuple[tuple[str, str], ...]
    basis: Items
    geometry: tuple[tuple[str, str], ...]
    verdicts: tuple[Verdict, ...]
    doubts: Items


@dataclass(frozen=True)
class Overleaf:
    """The page behind the page to sign.

    Attributes
    ----------
    figures : Table
        Decisive figures with their error bars; life asked for, and what becomes of it.
    pictures : tuple of Picture or Words
        Contact pattern, maps of the flank, wear.
    assumptions : Items
        What all this rests on.
    """

    figures: Table
    pictures: tuple[Picture | Words, ...]
    assumptions: Items


@dataclass(frozen=True)
class Matrix:
    """Rows of variants side by side.

    Attributes
    ----------
    rows : tuple
        Name of a row and its cells, one for each variant.
    """

    rows: tuple[tuple[str, tuple[str, ...]], ...]


@dataclass(frozen=True)
class Beside:
    """Pictures of one variant."""

    name: str
    pictures: tuple[Picture | Words, ...]


@dataclass(frozen=True)
class Variants:
    """Variants side by side.

    Attributes
    ----------
    title : str
        Of the cases.
    names : tuple of str
        What the variants are called.
    warnings : tuple of str
        What a reader must know before all else.
    differences, verdicts, figures : Matrix
        Inputs in which they differ, safeties as "value|verdict", simulated figures with their bars.
    beside : tuple of Beside
        Their pictures.
    note : str
        What the bars mean.
    """

    title: str
    names: tuple[str, ...]
    warnings: tuple[str, ...]
    differences: Matrix
    verdicts: Matrix
    figures: Matrix
    beside: tuple[Beside, ...]
    note: str


@dataclass(frozen=True)
class Report:
    """A report.

    Attributes
    ----------
    title, source : str
        Of the case.
    warnings : tuple of str
        What a reader must know before all else, such as what did not converge.
    sections : tuple of Section
        In order.
    cover : Cover or None
        The page to sign; None without safeties.
    overleaf : Overleaf or None
        The page behind it; None without it.
    """

    title: str
    source: str
    warnings: tuple[str, ...]
    sections: tuple[Section, ...]
    cover: Cover | None = None
    overleaf: Overleaf | None = None
