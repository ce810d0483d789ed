"""Contact and flow of a rough surface over its separation from a smooth one, solved once and kept."""

from contextlib import suppress
from dataclasses import asdict, dataclass, fields
from functools import lru_cache
from hashlib import sha256
from math import inf, isfinite
from typing import Any

import numpy as np

from pyworm.io.cache import cache_directory
from pyworm.io.input_error import CaseError
from pyworm.io.kept_arrays import DamagedError, keep, kept
from pyworm.kernel.core import EXTENSION, NOT_CONVERGED, KernelError
from pyworm.kernel.rough_cell import conduct, press
from pyworm.materials.topography import Topography

Array = np.ndarray

SEPARATIONS = np.geomspace(8.0, 0.2, 20)
"""Separations from the mean plane over the roughness, the widest first."""

CROSSED_SEPARATIONS = np.array([0.0, -0.25, -0.5, -1.0, -1.5, -2.0])
"""Further ones of surfaces that yield, whose mean planes can cross."""

MAX_CONTACT_AREA = 0.9
"""Real area of contact over the nominal one at which a table ends."""

LEAST_ROWS = 10
"""Rows that a table has at least; where the surface is closer, it may end for want of convergence."""

GAP_TOLERANCE = 1e-5
"""Gap left in the contact over the roughness, root mean square."""

MIN_GAP_RATIO = 0.02
"""Gap over the roughness that remains for the flow where surfaces touch, with 1e-5 of the conductance of one
as wide as the roughness: its equations stay regular, and the film's are left with ten times that
(`rough_surfaces.MIN_GAP_RATIO`)."""

FORMAT = 2
"""Number of what is in the files that are kept; another makes them anew."""


@dataclass(frozen=True)
class CellTable:
    """A rough surface against a smooth one over its separation, the widest first."""

    height: float
    """Root mean square height [m]."""
    separation: Array
    """Flat from the mean plane of the deformed surface [m]."""
    pressure: Array
    """Mean pressure of the contact [Pa]."""
    area: Array
    """Real area of the contact over the nominal one."""
    thickness: Array
    """Mean gap [m]."""
    flowing: Array
    """Mean gap with what remains for the flow where surfaces touch (`MIN_GAP_RATIO`) [m]."""
    conducted: Array
    """Cube of the gap that conducts as much as the cell [m3]: tensors xx, yy, xy, shape (3, separations)."""
    dragged: Array
    """Mean flowing gap less the thickness that a moving rough wall carries along [m]: likewise."""


@lru_cache(maxsize=16)
def cell_table(cell: Topography, reduced_modulus: float, hardness: float | None) -> CellTable:
    """Contact and flow of a periodic cell of any direction, from the user's cache or solved.

    By E' and, of surfaces that yield, the largest pressure [Pa]. CaseError if a contact or a flow did not
    converge where the gap is wide; KernelError if there is no memory, or the heights are not finite.
    """
    path = cache_directory() / "surfaces" / f"{_key(cell, reduced_modulus, hardness)}.npz"
    try:
        return kept(path, _of_arrays)
    except (OSError, DamagedError):
        table = solve_cell(cell, reduced_modulus, hardness)
    with suppress(OSError):  # where nothing can be kept it is solved again
        keep(path, **asdict(table))
    return table


def _of_arrays(arrays: dict[str, Array]) -> CellTable:
    """The table of kept arrays, one each for the places of the others; ValueError if they are not."""
    height, *rest = (arrays[field.name] for field in fields(CellTable))
    table = CellTable(float(height), *rest)
    if len({len(column) for column in rest}) != 1 or not all(np.isfinite(rest[0])):
        raise ValueError("columns of other lengths, or without values")
    return table


def solve_cell(cell: Topography, reduced_modulus: float, hardness: float | None) -> CellTable:
    """Contact and flow of a periodic cell; arguments and errors as of `cell_table`."""
    rms, most = cell.rms, inf if hardness is None else hardness
    separations = SEPARATIONS if hardness is None else np.append(SEPARATIONS, CROSSED_SEPARATIONS)
    rows: list[dict[str, Any]] = []
    for separation in separations * rms:
        try:
            row = _at(cell, separation, reduced_modulus, most)
        except KernelError as error:
            if error.status != NOT_CONVERGED:
                raise
            if len(rows) < LEAST_ROWS:
                raise CaseError(
                    f"contact or flow of a surface did not converge at a gap of {separation / rms:.3g} Rq; "
                    "give a shortest_wave that its points resolve"
                ) from error
            break
        if row["area"] >= MAX_CONTACT_AREA:
            break
        rows.append(row)
    columns = {name: np.array([row[name] for row in rows]) for name in rows[0]}
    return CellTable(
        rms,
        columns["separation"],
        columns["pressure"],
        columns["area"],
        columns["thickness"],
        columns["flowing"],
        columns["conducted"].T,
        columns["dragged"].T,
    )


def _at(cell: Topography, separation: float, modulus: float, hardness: float) -> dict:
    """One row of a table."""
    rms = cell.rms
    bound = hardness if isfinite(hardness) else modulus * 1e6
    pressure, gap = press(
        cell.height, cell.spacing, modulus, separation, bound, GAP_TOLERANCE * rms
    )
    gap = np.maximum(gap, 0.0)
    open_gap = np.maximum(gap, MIN_GAP_RATIO * rms)
    conducted, carried = conduct(open_gap, cell.spacing)
    flowing = float(open_gap.mean())
    return {
        "separation": separation,
        "pressure": float(pressure.mean()),
        "area": float((pressure > 0).mean()),
        "thickness": float(gap.mean()),
        "flowing": flowing,
        "conducted": conducted,
        "dragged": np.array([flowing, flowing, 0.0]) - carried,
    }


def _key(cell: Topography, reduced_modulus: float, hardness: float | None) -> str:
    """Key of a table in the cache: the heights, the bodies and the program."""
    parts = (
        FORMAT,
        cell.turned(0.0).digest,
        reduced_modulus,
        hardness,
        tuple(SEPARATIONS),
        tuple(CROSSED_SEPARATIONS),
        sha256(EXTENSION.read_bytes()).hexdigest(),
    )
    return sha256(repr(parts).encode()).hexdigest()[:24]
