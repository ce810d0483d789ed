"""A result: the solutions of a case with their provenance, stored in one NetCDF file.

Layout of the file:

    /                       attributes: format, format_version, case_name, case, provenance
    /mesh_cycle             the unloaded mesh cycle over phase, if the case is a drive
    /scene_000              attributes: the scalars of the solution, units in their names
    /scene_000/fields       fields over (y, x), or over x for a line contact, in single precision
    /scene_000/history      convergence over iterations
    /scene_000/profile      temperature and velocity across the film at its hottest point, if simulated
    /scene_000/life         figures and fields over time before it, if its films are transient

Attributes that are not numbers or plain text (case, provenance, solution) are JSON.
"""

import json
import os
import re
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, fields, is_dataclass, replace
from pathlib import Path
from typing import Any

from pyworm.io.atomic import whole_file
from pyworm.io.bounded_number import read_json
from pyworm.io.input_error import CaseError
from pyworm.io.on_demand import lazy_property
from pyworm.io.on_demand import xarray as xr
from pyworm.io.plain_dataset import PlainDataset, same_data
from pyworm.io.present import present
from pyworm.io.quantities import QUANTITIES
from pyworm.io.reason import reason_of
from pyworm.io.shown import Shown
from pyworm.result.netcdf import as_netcdf
from pyworm.result.sound_result import check, from_json
from pyworm.solver.solution import DATASETS, Solution

FORMAT = "pyworm result"
FORMAT_VERSION = 7

PROVENANCE = {"plans": list, "keys": list, "failed": dict}
"""Types of the entries of the provenance that readers use."""

MOST_NAMED = 4
"""Contacts without a converged solution that are named in a line; of others the number alone."""

MAX_ARRAY_BYTES = 2**31
"""Size beyond which arrays are not read [bytes], some twenty times the largest scene of the solver."""


@dataclass(frozen=True, repr=False)
class Result(Shown):
    """Solutions of one case and their provenance."""

    case_name: str
    """Name of the case."""
    case: dict
    """The case in full, checked and in SI."""
    solutions: tuple[Solution, ...]
    """One for each scene, in the order of the mesh cycle or the sweep."""
    mesh_cycle: "xr.Dataset | None"
    """The unloaded mesh cycle of gears, as `Drive.cycle_data` makes it."""
    provenance: dict
    """Version of pyworm, effects, tolerances and all else that is needed to repeat the run."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the result in words."""
        thinnest = self.solutions[self.thinnest] if self.solutions else None
        film = QUANTITIES["film_min"]
        text = "" if thinnest is None else thinnest.figure_text(film)
        found = {film.words(): text} if text else {}
        return f"Result {self.case_name}", {
            "contacts": f"{len(self.solutions)}, {len(self.unsound)} of them not converged",
            **found,
        }

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Result):
            return NotImplemented
        plain = ("case_name", "case", "solutions", "provenance")
        return all(getattr(self, name) == getattr(other, name) for name in plain) and same_data(
            self.mesh_cycle, other.mesh_cycle
        )

    def __hash__(self) -> int:
        return hash((self.case_name, self.solutions))

    cycle = lazy_property(
        "pyworm.result.mesh_cycle",
        "drive_cycle",
        "Extremes of the mesh cycle, loss and efficiency (`DriveCycle`); None unless teeth share the load.",
    )
    mesh_loss = lazy_property(
        "pyworm.ratings.mesh_loss",
        "mesh_loss_of",
        "Loss between the teeth, friction and efficiency (`MeshLoss`); None where they are not known.",
    )
    input_uncertainty = lazy_property(
        "pyworm.result.input_uncertainty",
        "uncertainty_in",
        "Uncertainty of the results by inputs (`InputUncertainty`); None where it was not requested.",
    )
    sensitivities = lazy_property(
        "pyworm.result.key_sensitivities",
        "sensitivities_in",
        "Derivatives with respect to the numbers of the case (`KeySensitivities`); None where not requested.",
    )

    @property
    def cycle_data(self) -> "xr.Dataset":
        """The mesh cycle of the gears; ValueError of a result without one."""
        return present(self.mesh_cycle, "the result's mesh cycle")

    @property
    def converged(self) -> bool:
        """Whether every solution converged."""
        return all(solution.converged for solution in self.solutions)

    @property
    def body_names(self) -> tuple[str, str]:
        """What the bodies of the contacts are called, as in the case file: worm and wheel of a worm drive."""
        first, second = self.case.get("bodies", ("body_1", "body_2"))
        return first.replace("_", " "), second.replace("_", " ")

    @property
    def sound(self) -> "Result":
        """The result with the converged solutions only, used for extremes, means and curves.

        The others are among those that could not be solved, so that they are missing of it as well.
        """
        return replace(
            self,
            solutions=tuple(solution for solution in self.solutions if solution.converged),
            provenance=self.provenance | {"failed": self.without_solution},
        )

    @property
    def without_solution(self) -> dict[str, str]:
        """Names of the contacts without a converged solution, and the reason of each."""
        unsound = {solution.name: solution.stop_reason for solution in self.unsound}
        failed: dict[str, str] = self.provenance.get("failed", {})
        return unsound | failed

    @property
    def missing(self) -> str:
        """Contacts without a converged solution in words: what means and losses lack; else empty."""
        names = list(self.without_solution)
        if not names:
            return ""
        count = len(self.solutions) - len(self.unsound) + len(names)
        listed = ", ".join(names[:MOST_NAMED]) + (", ..." if len(names) > MOST_NAMED else "")
        return f"{len(names)} of {count} contacts missing: {listed}"

    @property
    def stop_reason(self) -> str | None:
        """Reasons of the contacts without a converged solution, most frequent first; None without any."""
        if not self.without_solution:
            return None
        causes = Counter(self.without_solution.values()).most_common()
        return f"{self.missing} ({'; '.join(cause for cause, _ in causes)})"

    @property
    def shortfall(self) -> str | None:
        """Why a run does not have the requested accuracy; None where it has."""
        wide = [
            f"{solution.name}: {solution.stop_reason}"
            for solution in self.sound.solutions
            if not solution.accurate
        ]
        lacking = [self.stop_reason, *wide]
        return "; ".join(filter(None, lacking)) or None

    @property
    def unsound(self) -> tuple[Solution, ...]:
        """The solutions that did not converge."""
        return tuple(solution for solution in self.solutions if not solution.converged)

    @property
    def thinnest(self) -> int:
        """Number of the contact with the minimum film thickness among those converged, or all if none is."""
        judged = self.sound.solutions or self.solutions
        thinnest = min(judged, key=lambda solution: solution.figures.film_min.value)
        return next(
            number for number, solution in enumerate(self.solutions) if solution is thinnest
        )

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write one NetCDF file, atomically."""
        path = Path(path)
        content = as_netcdf(_groups(self))
        with whole_file(path) as partial:
            partial.write_bytes(content)
        return path


def open_result(path: str | os.PathLike[str]) -> Result:
    """Read a file written by `Result.save`, such as `pyworm run` writes.

    Args:
        path: The file.

    Raises:
        FileNotFoundError: If there is no such file.
        ValueError: If the file is not a pyworm result or is of another format version.
    """
    path = Path(path)
    if not path.is_file():
        raise FileNotFoundError(f"there is no result file at {path}")
    try:
        groups = _load(path)
    except Exception as error:  # whatever a damaged file makes the library stumble over
        raise ValueError(f"{path} is not a pyworm result: it cannot be read as NetCDF") from error
    attributes = groups["/"].attrs
    if attributes.get("format") != FORMAT:
        raise ValueError(f"{path} is not a pyworm result: it is another kind of NetCDF file")
    version = attributes.get("format_version")
    if version != FORMAT_VERSION:
        raise ValueError(
            f"{path} has result format {version!s:.20}; this version of pyworm reads format {FORMAT_VERSION}"
        )
    try:
        return _read(groups)
    except Exception as error:  # whatever is missing or of another kind
        why = " ".join(str(error).split())
        raise ValueError(f"{path} is damaged: expected content is missing ({why})") from error


def save_solution(solution: Solution, path: str | os.PathLike[str]) -> Path:
    """Write a solution as a result of its own, `Solution.save`."""
    return Result(solution.name, {}, (solution,), None, {}).save(path)


def open_solution(path: str | os.PathLike[str]) -> Solution:
    """Read a solution from a file of `Solution.save`, or from any result that has a single one.

    Args:
        path: The file.

    Raises:
        FileNotFoundError: If there is no such file.
        ValueError: If it is no pyworm result, or has several solutions: `pyworm.open_result` reads those.
    """
    solutions = open_result(path).solutions
    if len(solutions) > 1:
        raise ValueError(
            f"{path} has {len(solutions)} solutions: open it by pyworm.open_result and take one of them"
        )
    return solutions[0]


def _load(path: Path) -> "dict[str, xr.Dataset]":
    """Read all groups of a file by their paths."""
    # Times are numbers of seconds here, not dates to be decoded.
    groups = xr.open_groups(path, engine="netcdf4", decode_times=False)
    try:
        if max(group.nbytes for group in groups.values()) > MAX_ARRAY_BYTES:
            raise ValueError("an array is larger than any of a result")
        return {name: group.load() for name, group in groups.items()}
    finally:
        for group in groups.values():
            group.close()


def _read(groups: "dict[str, xr.Dataset]") -> Result:
    attributes = groups["/"].attrs
    provenance = from_json(dict, read_json(attributes["provenance"]), "provenance")
    for name, kind in PROVENANCE.items():
        from_json(kind, provenance.get(name, kind()), f"provenance.{name}")
    mesh_cycle = groups.get("/mesh_cycle")
    if mesh_cycle is not None:
        from_json(str, mesh_cycle.attrs.get("drive"), "the kind of gears of the mesh cycle")
    scenes = [name for name in groups if re.fullmatch(r"/scene_\d+", name)]
    if not scenes:
        raise ValueError("it has no contacts")
    scenes.sort(key=lambda name: int(name.removeprefix("/scene_")))  # a file may list them by name
    return Result(
        case_name=from_json(str, attributes["case_name"], "case_name"),
        case=from_json(dict, read_json(attributes["case"]), "case"),
        solutions=tuple(_read_solution(groups, scene) for scene in scenes),
        mesh_cycle=mesh_cycle,
        provenance=provenance,
    )


def case_in(path: Path) -> dict | None:
    """The case of a results file, without reading the solutions; None if there is no such file."""
    try:
        with xr.open_dataset(path, engine="netcdf4") as root:
            known = root.attrs.get("format") == FORMAT
            return from_json(dict, read_json(root.attrs["case"]), "case") if known else None
    except Exception:  # whatever a damaged file makes the library stumble over
        return None


@contextmanager
def readable(path: Path) -> Iterator[None]:
    """Turn errors of reading a results file into one message, a CaseError."""
    try:
        yield
    except CaseError:
        raise
    except (ValueError, LookupError, TypeError, AttributeError, ArithmeticError) as error:
        raise CaseError(
            f"{path} is damaged or was made by another program: {reason_of(error)}"
        ) from error


def _groups(result: Result) -> "dict[str, PlainDataset | xr.Dataset]":
    about = {
        "format": FORMAT,
        "format_version": FORMAT_VERSION,
        "case_name": result.case_name,
        "case": _to_json(result.case),
        "provenance": _to_json(result.provenance),
    }
    groups: dict[str, PlainDataset | xr.Dataset] = {"/": PlainDataset({}, (), about)}
    if result.mesh_cycle is not None:
        groups["/mesh_cycle"] = result.mesh_cycle
    for number, solution in enumerate(result.solutions):
        scene = f"/scene_{number:03d}"
        attributes = plain_attributes(solution.summary())
        attributes["solution"] = _to_json(_scalars(solution))
        groups[scene] = PlainDataset({}, (), attributes)
        parts = {part: solution.held(part) for part in DATASETS}
        groups |= {
            f"{scene}/{part}": dataset for part, dataset in parts.items() if dataset is not None
        }
    return groups


def plain_attributes(summary: Mapping[str, Any]) -> dict[str, Any]:
    """Scalars as NetCDF attributes: no None, truth values as 0 or 1, objects flattened."""
    plain: dict[str, Any] = {}
    for name, value in summary.items():
        if isinstance(value, Mapping):
            plain |= {f"{name}_{part}": number for part, number in value.items()}
        elif value is not None:
            plain[name] = int(value) if isinstance(value, bool) else value
    return plain


def _scalars(value: Any) -> Any:
    """A dataclass as nested dictionaries, without its datasets."""
    if is_dataclass(value):
        names = [part.name for part in fields(value) if part.compare and part.name not in DATASETS]
        return {name: _scalars(getattr(value, name)) for name in names}
    if isinstance(value, tuple):
        return [_scalars(part) for part in value]
    return value


def _to_json(value: Any) -> str:
    # NumPy's scalars and arrays know their own plain form; anything else is a mistake of ours.
    return json.dumps(value, default=lambda item: item.tolist())


def _read_solution(groups: "dict[str, xr.Dataset]", scene: str) -> Solution:
    datasets = {part: groups[f"{scene}/{part}"] for part in DATASETS if f"{scene}/{part}" in groups}
    try:
        solution: Solution = from_json(
            Solution, read_json(groups[scene].attrs["solution"]) | datasets
        )
        check(solution)
    except (ValueError, RecursionError) as error:
        raise ValueError(f"{scene[1:]}: {error}") from None
    return solution
