"""The table of a sweep: for each scene its varied values, place, figures and status.

Layout of the file: variables over `scene`; those that vary are named in the attribute `axes` (JSON: the keys
that go together in one list) and have the unit they were written with, the others are the scalars of
`Solution.summary`, units in their names. A scene without solution has its reason under `stop_reason` and NaN
for numbers. One that needed no solve has the name of its `formula`, films and NaN for what else others have.
"""

import csv
import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from pyworm.case.sweep import Value
from pyworm.formulas.lubrication import BY_SEVERITY
from pyworm.io.atomic import whole_file
from pyworm.io.bounded_number import read_json
from pyworm.io.number_with_unit import parse_in
from pyworm.io.on_demand import xarray as xr
from pyworm.io.shown import Shown
from pyworm.result.labelled_sweep import labelled
from pyworm.result.result import MAX_ARRAY_BYTES, Result, plain_attributes
from pyworm.result.sound_result import from_json
from pyworm.solver.neglected_effects import (
    ASPERITY_SHARE,
    LAMBDAS,
    MIXED_ABOVE,
    NeglectedEffects,
    worst,
)
from pyworm.solver.solution import Solution

FORMAT = "pyworm sweep"
FORMAT_VERSION = 1

NEGLECTED_PREFIX = "left_out_"
"""Prefix of variables that hold an effect's influence."""


@dataclass(frozen=True, repr=False)
class SweepResult(Shown):
    """Result of a sweep: a table over its scenes, and its provenance."""

    name: str
    """Name of the sweep."""
    title: str
    """Title of the sweep."""
    axes: list[list[str]]
    """Varied variables of the table; those that vary together in one list."""
    table: "xr.Dataset"
    """Variables over `scene`."""
    provenance: dict
    """The sweep as written, versions, time and machine."""
    solutions: tuple[Solution, ...] = ()
    """Solutions in full in the order of the scenes, without those that have none; empty unless fields are
    requested, and of a sweep from a file."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the sweep in words."""
        return f"SweepResult {self.name}", {
            "scenes": f"{self.table.sizes['scene']}",
            "converged": f"{int(self.converged.sum())}",
            "varied": " x ".join(" with ".join(axis) for axis in self.axes),
        }

    @cached_property
    def dataset(self) -> "xr.Dataset":
        """Results as labelled arrays: a dimension for each varied name.

        Names that vary together are along `point`. Results are in SI under the names of `Figures`, with
        units and long names as attributes; their uncertainties `NAME_error` and `NAME_model_error` are in
        the same unit. `converged` and `accurate` are booleans, `status` and `stop_reason` texts. Numbers are
        NaN where the scene has no converged solution.
        """
        return labelled(self.table, self.axes)

    @property
    def result(self) -> Result:
        """The solutions in full, as `pyworm.plots`, `pyworm explore` and files take them."""
        return Result(self.name, {}, self.solutions, None, self.provenance)

    @property
    def converged(self) -> np.ndarray:
        """Whether the solution of each scene converged."""
        return self.table["converged"].values == 1

    @property
    def accurate(self) -> np.ndarray:
        """Whether the solution of each scene has the requested accuracy."""
        return self.table["accurate"].values == 1

    @cached_property
    def neglected_effects(self) -> NeglectedEffects:
        """Effects neglected in the results, at the worst of the converged scenes."""
        influences = {
            str(name): column.values[self.converged].tolist()
            for name, column in self.table.items()
            if str(name).startswith(NEGLECTED_PREFIX)
            or name in ("lubrication", *LAMBDAS, ASPERITY_SHARE, MIXED_ABOVE)
        }
        rows = (
            dict(zip(influences, row, strict=True))
            for row in zip(*influences.values(), strict=True)
        )
        return worst([_neglected_effects(row) for row in rows])

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write one NetCDF file, atomically."""
        path = Path(path)
        attributes = {
            "format": FORMAT,
            "format_version": FORMAT_VERSION,
            "name": self.name,
            "title": self.title,
            "axes": json.dumps(self.axes),
            "provenance": json.dumps(self.provenance, default=str),  # TOML has dates
        }
        content = self.table.assign_attrs(attributes).to_netcdf(None, engine="netcdf4")
        with whole_file(path) as partial:
            partial.write_bytes(content)
        return path

    def save_csv(self, path: str | os.PathLike[str]) -> Path:
        """Write the table as comma-separated values, units of varied keys in brackets."""
        path = Path(path)
        columns = self.table.data_vars.values()
        heads = [
            f"{column.name} [{column.attrs['units']}]" if column.attrs.get("units") else column.name
            for column in columns
        ]
        with whole_file(path) as partial, partial.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(heads)
            writer.writerows(zip(*(column.values.tolist() for column in columns), strict=True))
        return path


def open_sweep(path: str | os.PathLike[str]) -> SweepResult | None:
    """Read a file written by `SweepResult.save`; None if it is no table of a sweep.

    Args:
        path: The file.

    Raises:
        ValueError: The format version is another one, or the content is no valid table.
    """
    path = Path(path)
    table = _loaded(path) if path.is_file() else None
    if table is None:
        return None
    attributes, table.attrs = table.attrs, {}
    if attributes.get("format") != FORMAT:
        return None
    version = attributes.get("format_version")
    if version != FORMAT_VERSION:
        raise ValueError(
            f"{path} has sweep format {version!s:.20}; this version of pyworm reads format {FORMAT_VERSION}"
        )
    try:
        result = SweepResult(
            from_json(str, attributes["name"], "name"),
            from_json(str, attributes["title"], "title"),
            from_json(list[list[str]], read_json(attributes["axes"]), "axes"),
            table,
            from_json(dict, read_json(attributes["provenance"]), "provenance"),
        )
        _check(result)
    except (ValueError, LookupError, TypeError, RecursionError) as error:
        why = " ".join(str(error).split())
        raise ValueError(f"{path} is damaged: expected content is missing ({why})") from error
    return result


def _loaded(path: Path) -> "xr.Dataset | None":
    """The content of a NetCDF file; None if it is not one, or too large for a table."""
    try:
        with xr.open_dataset(path, engine="netcdf4", decode_times=False) as table:
            return table.load() if table.nbytes <= MAX_ARRAY_BYTES else None
    except Exception:  # whatever a damaged file makes the library stumble over
        return None


def _check(result: SweepResult) -> None:
    """Refuse an impossible table; ValueError with the first error."""
    table = result.table
    if not table.sizes.get("scene"):
        raise ValueError("it has no contacts")
    for name, column in table.variables.items():
        if column.dims != ("scene",):
            raise ValueError(f"{name} does not have one value for each contact")
        if column.dtype.kind not in "iufb" and not all(
            isinstance(entry, str) for entry in column.values
        ):
            raise ValueError(f"{name} holds neither numbers nor texts")
    for key in (key for axis in result.axes for key in axis or [""]):
        if not any(name == key or str(name).startswith(f"{key}[") for name in table.data_vars):
            raise ValueError(f'there is no column of "{key}", which varies')
    if table["stop_reason"].dtype.kind in "iufb":
        raise ValueError("stop_reason is no text")
    for name in ("converged", "accurate"):
        if not np.isin(table[name].values, (0, 1)).all():
            raise ValueError(f"{name} must be 0 or 1")
    by_formula = table["formula"].values != "" if "formula" in table else False
    for name in {"film_min_m", "film_central_m", "pressure_max_Pa"} & set(table.data_vars):
        known = result.converged & ~(by_formula & np.isnan(table[name].values))
        if not (table[name].values[known] > 0).all():
            raise ValueError(f"{name} of a scene that is marked as converged is not above zero")


def sweep_table(
    values: Sequence[Mapping[str, Value]], rows: Sequence[Mapping[str, Any]], keys: Sequence[str]
) -> "xr.Dataset":
    """Make the table of all scenes: varied values as written, by key, summary, and key of the scene's file.

    A summary has at least the scene's place, `converged`, `accurate` and `stop_reason`.
    """
    table = xr.Dataset()
    for key in values[0]:
        for name, column, unit in _varied(key, [given[key] for given in values]):
            table[name] = ("scene", column, {"units": unit} if unit else {})
    flat = [_flat(row) for row in rows]
    names = list({name: None for row in flat for name in row if name != "name"})
    for name in names:
        table[name] = ("scene", _column([row.get(name) for row in flat]))
    table["key"] = ("scene", np.array(keys, dtype=object))
    return table


def _neglected_effects(row: Mapping[str, float | str]) -> NeglectedEffects:
    """Effects neglected in the results of a scene, from its row; invalid entries are ignored."""
    numbers = {
        name: number
        for name, number in row.items()
        if isinstance(number, float) and not np.isnan(number)
    }
    influence = {
        name.removeprefix(NEGLECTED_PREFIX): number
        for name, number in numbers.items()
        if name.startswith(NEGLECTED_PREFIX)
    }
    regime = row.get("lubrication")
    lubrication = regime if regime in BY_SEVERITY else "unknown"
    return NeglectedEffects.read({**numbers, "left_out": influence, "lubrication": lubrication})


def _varied(key: str, values: list[Value]) -> list[tuple[str, np.ndarray, str]]:
    """Name, numbers and unit of a key's values; a list's entries one by one; texts if they are no numbers."""
    if all(isinstance(value, list) and len(value) == len(values[0]) for value in values):
        return [
            part
            for place in range(len(values[0]))
            for part in _varied(f"{key}[{place}]", [value[place] for value in values])
        ]
    if all(isinstance(value, int | float) for value in values):
        return [(key, np.array(values, dtype=float), "")]
    try:
        _, unit = parse_in(values[0])
        return [(key, np.array([parse_in(value, unit)[0] for value in values]), unit)]
    except ValueError:
        return [(key, np.array([str(value) for value in values], dtype=object), "")]


def _flat(row: Mapping[str, Any]) -> dict[str, Any]:
    """A summary's scalars.

    Components of vectors have the letter of their direction after the name; lists of names, such as the
    effects that are simulated, are one text with commas.
    """
    flat: dict[str, Any] = {}
    for name, value in plain_attributes(row).items():
        if not isinstance(value, list):
            flat[name] = value
        elif all(isinstance(part, str) for part in value):
            flat[name] = ",".join(value)
        else:
            directions = "xy"[: len(value)]
            flat |= {f"{name}_{axis}": part for axis, part in zip(directions, value, strict=True)}
    return flat


def _column(values: list[Any]) -> np.ndarray:
    """One value for each scene; a missing one is NaN or an empty text."""
    if any(isinstance(value, str) for value in values):
        return np.array(["" if value is None else value for value in values], dtype=object)
    return np.array([np.nan if value is None else value for value in values], dtype=float)


def columns(result: SweepResult, axis: list[str]) -> list[str]:
    """The variables of keys that vary together, one for each varying entry of a list."""
    return [
        str(name)
        for name in result.table.data_vars
        if any(name == key or str(name).startswith(f"{key}[") for key in axis)
        and len(np.unique(result.table[name])) > 1
    ] or axis[:1]


def distinguishing(result: SweepResult, axis: list[str]) -> list[str]:
    """Variables of keys that vary together which distinguish their scenes.

    Most often the first, as of both bodies' velocities; errors of assembly, one at a time, take all.
    """
    first, *others = columns(result, axis)
    chosen = [first]
    for name in others:
        if _combinations(result, [*chosen, name]) > _combinations(result, chosen):
            chosen.append(name)
    return chosen


def _combinations(result: SweepResult, names: list[str]) -> int:
    return len(set(zip(*(result.table[name].values.tolist() for name in names), strict=True)))
