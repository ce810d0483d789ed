"""The table of the atlas: read, write, and as groups of the film formula."""

import csv
from dataclasses import fields
from pathlib import Path

import numpy as np
from atlas.contacts import DENSITY

from pyworm.formulas.film_atlas import AtlasGroups
from pyworm.io.atomic import whole_file
from pyworm.materials.viscosity_density import ROELANDS_PRESSURE, Density

TEXTS = "film_min_kind", "status"
"""Columns that are no numbers."""


def read(table: Path) -> dict[int, dict]:
    """The rows of a table by their numbers."""
    if not table.exists():
        return {}
    with table.open(newline="") as file:
        return {int(of["number"]): of for of in csv.DictReader(file)}


def write(table: Path, rows: dict[int, dict]) -> None:
    """Write a table whole, or not at all."""
    ordered = [rows[number] for number in sorted(rows)]
    with whole_file(table) as partial, partial.open("w", newline="") as file:
        writer = csv.DictWriter(file, list(ordered[0]), lineterminator="\n")
        writer.writeheader()
        for one in ordered:
            writer.writerow({name: _short(value) for name, value in one.items()})


def _short(value: float | str) -> float | str:
    """Numbers to seven digits, a thousandth of their bars."""
    return f"{value:.7g}" if isinstance(value, float) else value


def columns(table: Path) -> dict[str, np.ndarray]:
    """The columns of a table."""
    rows = list(read(table).values())
    return {
        name: np.array([of[name] if name in TEXTS else float(of[name]) for of in rows])
        for name in rows[0]
    }


def known(table: Path, bar: float) -> dict[str, np.ndarray]:
    """The columns of the contacts whose central and least film have bars of at most `bar`."""
    found = columns(table)
    good = (found["film_central_error"] <= bar) & (found["film_min_error"] <= bar)
    return {name: of[good] for name, of in found.items()}


def groups(of: dict[str, np.ndarray]) -> AtlasGroups:
    """The groups of a table's contacts."""
    law = Density.dowson_higginson(DENSITY)
    pressure = of["alpha_pressure"] / of["alpha"]
    return AtlasGroups(
        moes_m=of["moes_m"],
        moes_l=of["moes_l"],
        ratio=of["ratio"],
        angle=np.radians(of["angle"]),
        spin=of["spin"],
        alpha_ratio=_alpha_ratio(of),
        compression=of["compressible"] * (law(pressure) / DENSITY - 1),
    )


def _alpha_ratio(of: dict[str, np.ndarray]) -> np.ndarray:
    """Reciprocal asymptotic isoviscous pressure coefficient over alpha: of Roelands' law by Laguerre's rule.

    With y = s [(1 + p/p0)^z - 1] it is 1/int e^-y (1 + y/s)^(1/z - 1) dy.
    """
    s, z = of["alpha"] * ROELANDS_PRESSURE / of["z"], of["z"]
    place, weight = np.polynomial.laguerre.laggauss(40)
    area = weight @ (1 + place[:, None] / s) ** (1 / z - 1)
    return np.where(of["barus"] == 1, 1.0, 1 / area)


def part(of: AtlasGroups, which: np.ndarray) -> AtlasGroups:
    """Some of the contacts."""
    return AtlasGroups(*(np.asarray(getattr(of, one.name))[which] for one in fields(of)))
