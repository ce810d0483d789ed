"""The table of a sweep as labelled arrays, a dimension for each varied name."""

from collections.abc import Iterator, Sequence

import numpy as np

from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import QUANTITIES, Quantity
from pyworm.scene.index import INDEX_NAMES

JOINT_DIMENSION = "point"
"""Dimension of names that vary together, whose values stand along it; of others after it with a number."""

TEXTS = "status", "stop_reason", "regime"
"""Variables that hold text."""

NOT_IN_SWEEP = "not in the sweep"
"""Status of a combination that no scene has, such as a phase without load."""


def labelled(table: "xr.Dataset", axes: Sequence[Sequence[str]]) -> "xr.Dataset":
    """The results of a sweep over its varied names, as `SweepResult.dataset` describes them.

    Args:
        table: Variables over `scene`, results with the names and units of `Solution.summary`.
        axes: Varied variables of the table; those that vary together in one list.
    """
    codes, shape, coords = [], {}, {}
    for name, columns in _dimensions(table, axes):
        rows = [
            tuple(map(str, row)) for row in zip(*(table[c].values for c in columns), strict=True)
        ]
        levels = {row: number for number, row in enumerate(dict.fromkeys(rows))}
        first = [rows.index(row) for row in levels]
        codes.append(np.array([levels[row] for row in rows]))
        shape[name] = len(levels)
        for column in columns:
            coords[column] = name, table[column].values[first], _described(table, column)
    place = np.ravel_multi_index(codes, tuple(shape.values()))

    def spread(values: np.ndarray, missing: object) -> tuple[tuple[str, ...], np.ndarray]:
        whole = np.full(int(np.prod(list(shape.values()))), missing, dtype=values.dtype)
        whole[place] = values
        return tuple(shape), whole.reshape(tuple(shape.values()))

    converged, status = table["converged"].values == 1, _status(table)
    flags = {"converged": converged, "accurate": table["accurate"].values == 1}
    texts = {name: table[name].values.astype(object) for name in TEXTS[1:] if name in table}
    variables: dict[str, tuple[object, ...]] = {
        name: spread(values, False) for name, values in flags.items()
    }
    variables |= {"status": spread(status, NOT_IN_SWEEP)}
    variables |= {name: spread(values, "") for name, values in texts.items()}
    for name, values, attrs in _results(table):
        if name not in coords:
            variables[name] = (*spread(np.where(converged, values, np.nan), np.nan), attrs)
    return xr.Dataset(variables, coords)


def _dimensions(
    table: "xr.Dataset", axes: Sequence[Sequence[str]]
) -> Iterator[tuple[str, list[str]]]:
    """Name and columns of each dimension: those of the axes, then places in the mesh that differ."""
    joint, varied = 0, []
    for axis in axes:
        columns = [
            str(name)
            for name in table.data_vars
            if any(name == key or str(name).startswith(f"{key}[") for key in axis)
        ]
        varied += columns
        if len(columns) == 1:
            yield columns[0], columns
        elif columns:
            joint += 1
            yield JOINT_DIMENSION if joint == 1 else f"{JOINT_DIMENSION}_{joint}", columns
    for name in INDEX_NAMES:
        if name in table and name not in varied and len(set(map(str, table[name].values))) > 1:
            yield name, [name]


def _status(table: "xr.Dataset") -> np.ndarray:
    """How far each scene came: accurate, converged, not converged, no solution."""
    solved = table["kind"].values != "" if "kind" in table else np.full(table.sizes["scene"], False)
    found = np.where(solved, "not converged", "no solution")
    found = np.where(table["converged"].values == 1, "converged", found)
    status: np.ndarray = np.where(table["accurate"].values == 1, "accurate", found).astype(object)
    return status


def _results(table: "xr.Dataset") -> Iterator[tuple[str, np.ndarray, dict[str, str]]]:
    """Results in SI by name, each with its uncertainties in the same unit."""
    for quantity in QUANTITIES.values():
        if (
            not quantity.source
            or quantity.key not in table
            or table[quantity.key].dtype.kind != "f"
        ):
            continue
        shown = table[quantity.key].values
        kelvin = quantity.unit == "K"
        yield quantity.name, shown + quantity.offset if kelvin else shown, _words(quantity)
        for key, ending, kind in (
            (quantity.error_key, "error", "numerical uncertainty"),
            (quantity.model_key, "model_error", "model uncertainty"),
        ):
            if key in table:
                size = table[key].values
                error = size if kelvin else size * np.abs(shown)
                yield f"{quantity.name}_{ending}", error, _words(quantity, f"{kind}: ")


def _words(quantity: Quantity, before: str = "") -> dict[str, str]:
    return {"units": quantity.unit, "long_name": f"{before}{quantity.words()}"}


def _described(table: "xr.Dataset", column: str) -> dict[str, str]:
    """Unit of a varied name as it was written, else that of the quantity of this name, and its words."""
    quantity = QUANTITIES.get(column.rsplit(".", 1)[-1])
    known = {} if quantity is None else _words(quantity)
    return known | table[column].attrs
