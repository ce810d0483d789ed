"""Headers of text files of heights: units, sides and distances of points.

Labels are those of the programs of instruments: Gwyddion's in the languages of its export, SPIP's,
Nova's, Attocube's and Zygo's, and plain ones.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from pyworm.io.number_with_unit import number_and_unit, unit_of

_VALUE_UNIT = (
    "value units", "value unit", "z-unit", "z unit", "zunit", "unit z", "unit data", "height unit",
    "height units", "jednotky hodnot", "einheiten", "unités", "unità valore", "値の単位", "값 단위",
    "unidades de valor", "единицы измерения",
)  # fmt: skip
_X_UNIT = ("lateral units", "lateral unit", "x-unit", "x unit", "unit x", "xy unit", "xy units")
_Y_UNIT = ("y-unit", "y unit", "unit y")
_ALL_UNITS = ("unit", "units", "length unit", "length units")
_WIDTH = (
    "width", "x-length", "x length", "šířka", "breite", "anchura", "largeur", "larghezza", "幅", "폭",
    "largura", "ширина",
)  # fmt: skip
_HEIGHT = (
    "height", "y-length", "y length", "výška", "höhe", "altura", "hauteur", "altezza", "高さ", "높이",
    "высота",
)  # fmt: skip
_X_STEP = ("pixel size", "pixel_size", "pixelsize", "spacing", "step", "scale x", "dx", "x-step")
_Y_STEP = ("scale y", "dy", "y-step")

_LABELLED = re.compile(r"[#%;/*!\s]*(?P<label>[^=:：]+?)\s*[=:：]\s*(?P<value>.*?)\s*")

_HEIGHT_FACTOR = re.compile(r"height conversion factor\s*\(->\s*(?P<unit>[^)]*)\)", re.IGNORECASE)
"""Label of the factor by which values become heights in a unit."""

_VALUES_IN = re.compile(
    r"\b(?:z|heights?|values?|data)\b[^\[(/]*?(?:[\[(/]|\bin\s)\s*(?P<unit>[^\s\])]+)",
    re.IGNORECASE,
)
"""A comment without a label: heights in um, z [um]."""

_COLUMN = re.compile(
    r"(?:.*?[\[(/]|.*\bin\s+|.*\s|)\s*(?P<unit>[^\s\[\](/)]+?)\s*[\])]?", re.IGNORECASE
)
"""Title of a column: x [mm], y/mm, z in um, lateral um, or the unit alone."""

_TITLES = re.compile(r"[^\s\[(]+\s*[\[(][^\])]+[\])]")
"""Titles with a unit in brackets, one after the other: x [um] z [nm]."""

_SPELLED = {
    "å": "angstrom", "microns": "micron", "ångström": "angstrom", "micrometer": "micron",
    "micrometers": "micron", "micrometre": "micron", "micrometres": "micron", "nanometer": "nm",
    "nanometers": "nm", "millimeter": "mm", "millimeters": "mm",
}  # fmt: skip
"""What units are called in headers and nowhere else."""


@dataclass(frozen=True)
class Header:
    """What the lines before the numbers say; None where they do not."""

    height_metres: float | None = None
    """Metres of a unit of height."""
    metres: tuple[float, float] | None = None
    """Metres of a unit along x and along y."""
    sides: tuple[float, float] | None = None
    """Lengths of the sides along x and y [m]."""
    steps: tuple[float, float] | None = None
    """Distance of points along x and y [m]."""


def metres_of(unit: str) -> float | None:
    """Metres of a unit of length; None of any other text."""
    try:
        meant = unit_of(_SPELLED.get(unit.strip().lower(), unit.strip()))
    except ValueError:
        return None
    return meant.factor if meant.base == "m" else None


def read_header(lines: Sequence[str]) -> Header:
    """What the lines before the numbers say; ValueError if they are no heights, such as volts."""
    said = _labelled(lines)
    header = _with_units(said)
    if header.height_metres is None:
        header = _by_titles(lines, header)
    sides, steps = (
        _pair(said, header.metres, *labels) for labels in ((_WIDTH, _HEIGHT), (_X_STEP, _Y_STEP))
    )
    if steps is not None:
        steps = steps[0], steps[1] or steps[0]
    whole = None if sides is None or sides[1] is None else (sides[0], sides[1])
    return replace(header, sides=whole, steps=steps)


def _labelled(lines: Sequence[str]) -> dict[str, str]:
    """Label in small letters -> value."""
    matches = (_LABELLED.fullmatch(line) for line in lines)
    return {match["label"].lower(): match["value"] for match in matches if match}


def _with_units(said: dict[str, str]) -> Header:
    """The units that labels give."""
    heights, along_x, along_y = (
        _said(said, labels + _ALL_UNITS) for labels in (_VALUE_UNIT, _X_UNIT, _Y_UNIT)
    )
    factor = next((found for found in map(_HEIGHT_FACTOR.fullmatch, said) if found), None)
    if factor is not None:
        metres = metres_of(factor["unit"])
        number = _number(said[factor[0]])
        return Header(None if metres is None or number is None else metres * number)
    x_metres = None if along_x is None else metres_of(along_x)
    y_metres = x_metres if along_y is None else metres_of(along_y)
    both = None if x_metres is None or y_metres is None else (x_metres, y_metres)
    if heights is None:
        return Header(metres=both)
    metres = metres_of(heights)
    if metres is None:
        raise ValueError(f'has values in "{heights}" by its header; heights are needed')
    return Header(metres, both)


def _by_titles(lines: Sequence[str], header: Header) -> Header:
    """The header with the units of columns x, y and z, or of the values, that lines without labels give."""
    for line in lines:
        fields = [field for field in re.split(r"[;,\t]|\s{2,}", line.strip(" #%;\t")) if field]
        if len(fields) == 1:
            fields = _TITLES.findall(fields[0]) or fields[0].split()
        columns = [_COLUMN.fullmatch(field.strip()) for field in fields]
        units = [None if found is None else metres_of(found["unit"]) for found in columns]
        metres = [unit for unit in units if unit is not None]
        if len(metres) == len(units) == 3:
            return replace(header, height_metres=metres[2], metres=(metres[0], metres[1]))
        if len(units) == 2 and units[0] is not None:
            return replace(header, height_metres=units[1], metres=(units[0], units[0]))
        found = _VALUES_IN.search(line)
        if found is not None and metres_of(found["unit"]) is not None:
            return replace(header, height_metres=metres_of(found["unit"]))
    return header


def _said(said: dict[str, str], labels: Sequence[str]) -> str | None:
    return next((said[label] for label in labels if said.get(label)), None)


def _pair(
    said: dict[str, str],
    metres: tuple[float, float] | None,
    x_labels: Sequence[str],
    y_labels: Sequence[str],
) -> tuple[float, float | None] | None:
    """Two lengths [m] by their labels, the second None where it is not given."""
    x_metres, y_metres = metres or (None, None)
    along_x = _length(_said(said, x_labels), x_metres)
    along_y = _length(_said(said, y_labels), y_metres)
    return None if along_x is None else (along_x, along_y)


def _length(text: str | None, metres: float | None) -> float | None:
    """A length [m] with its unit, or without in units of so many metres; None where it is none."""
    parts = None if text is None else number_and_unit(text)
    if parts is None:
        return None
    number, unit = parts
    unit_metres = metres_of(unit) if unit else metres
    return float(number) * unit_metres if unit_metres is not None and float(number) > 0 else None


def _number(text: str) -> float | None:
    parts = number_and_unit(text)
    return None if parts is None else float(parts[0])
