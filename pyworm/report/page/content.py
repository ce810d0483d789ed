"""Content of a report: sections of paragraphs, lists, tables and pictures."""

from dataclasses import dataclass


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
class Table:
    """A table of text; the first column names its rows.

    Attributes
    ----------
    head : tuple of str
        Headings; the first may be empty.
    rows : tuple of tuple of str
        Cells; a scene that did not converge has a cell with that statement.
    title : str
        Above it.
    note : str
        Below it.
    """

    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    title: str = ""
    note: str = ""


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
    """

    title: str
    source: str
    warnings: tuple[str, ...]
    sections: tuple[Section, ...]
