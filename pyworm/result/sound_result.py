"""Validation of a results file: types, fields and figures.

Files may be damaged, edited or made by others. Accepted is what the solver writes: fields of numbers over the
right directions, finite in a converged solution, with pressure not negative and film, largest pressure and
load above zero. A solution that did not converge may hold any numbers.
"""

from collections.abc import Iterator
from dataclasses import fields as parts_of
from dataclasses import is_dataclass
from enum import EnumType
from math import inf, isfinite
from types import NoneType, UnionType
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

import numpy as np

from pyworm.io.on_demand import xarray as xr
from pyworm.solver.solution import Estimate, Solution

_SURFACES = ("gap", "covered", "pressure", "film", "entrainment_x", "sliding_x")
_SHEAR = ("shear_stress_x", "shear_rate", "friction_power", "slip")
_HEAT = ("temperature_body_1", "temperature_body_2", "temperature_middle")
_LIFE = ("life_seconds", "life_load", "life_film_min", "life_film_min_error")
_ACROSS = ("level_position", "profile_temperature", "profile_velocity_x", "profile_x")

NEEDED_FIELDS = {
    "point": (*_SURFACES, "dry_pressure", "entrainment_y", "sliding_y"),
    "line": _SURFACES,
}
"""Kind of contact -> fields that every solution has."""

SIZES = {
    "point": ("radius_x_m", "radius_y_m", "load_N", "reduced_modulus_Pa"),
    "line": ("radius_m", "load_per_length_N_m", "reduced_modulus_Pa"),
}
"""Kind of contact -> attributes of its fields, numbers above zero."""

AXES = {"point": ("x", "y"), "line": ("x",)}
"""Kind of contact -> directions of its grid."""


def from_json(kind: Any, value: Any, name: str = "") -> Any:
    """A value read from JSON as its declared type; ValueError, which names it, of a value of another type.

    Dataclasses are made from tables and tuples from lists; datasets stay as they are.
    """
    origin, options = get_origin(kind), get_args(kind)
    if origin in (Union, UnionType):
        return _one_of(options, value, name)
    if origin is Literal and value in options:
        return value
    if isinstance(kind, EnumType):
        return kind(value)
    if origin is tuple and isinstance(value, list | tuple):
        kinds = options[:1] * len(value) if options[-1] is Ellipsis else options
        if len(kinds) == len(value):
            pairs = enumerate(zip(kinds, value, strict=True))
            return tuple(
                from_json(type_of_part, part, f"{name}[{number}]")
                for number, (type_of_part, part) in pairs
            )
    if origin is list and isinstance(value, list):
        return [
            from_json(options[0], part, f"{name}[{number}]") for number, part in enumerate(value)
        ]
    if origin is dict and isinstance(value, dict):
        return {key: from_json(options[1], part, f"{name}.{key}") for key, part in value.items()}
    if is_dataclass(kind) and isinstance(value, dict):
        return _without_flaws(kind, value, name)
    if kind is float and isinstance(value, int | float) and not isinstance(value, bool):
        return value
    if kind in (bool, str, int, list, dict, NoneType, xr.Dataset) and type(value) is kind:
        return value
    raise ValueError(f"{name} is {value!r:.60}")


def _one_of(options: tuple, value: Any, name: str) -> Any:
    for option in options:
        if option is NoneType and value is None:
            return None
        if is_dataclass(option) and isinstance(value, dict):
            return from_json(option, value, name)
    for option in options:
        try:
            return from_json(option, value, name)
        except ValueError:
            continue
    raise ValueError(f"{name} is {value!r:.60}")


def _without_flaws(kind: Any, value: dict[str, Any], name: str) -> Any:
    hints = get_type_hints(kind)
    strange = value.keys() - {part.name for part in parts_of(kind)}
    if strange:
        raise ValueError(f"{name} has an unknown {min(strange)!r:.60}")
    below = f"{name}." if name else ""
    try:
        return kind(
            **{
                key: from_json(hints[key], part_value, f"{below}{key}")
                for key, part_value in value.items()
            }
        )
    except TypeError as error:
        raise ValueError(f"{name or 'it'} is not complete ({error})") from None


def check(solution: Solution) -> None:
    """Refuse a solution that the solver cannot have written; ValueError with the first error."""
    for flaw in _flaws(solution):
        raise ValueError(flaw)


def _flaws(solution: Solution) -> Iterator[str]:
    yield from _flaws_of_fields(solution)
    yield from _flaws_of_parts(solution)
    yield from _flaws_of_figures(solution)


def _flaws_of_fields(solution: Solution) -> Iterator[str]:
    fields, axes = solution.fields, AXES[solution.kind]
    figures = solution.figures
    for axis in axes:
        if axis not in fields.coords or not _rises(fields[axis]):
            yield f"its fields have no increasing {axis}"
    needed = NEEDED_FIELDS[solution.kind]
    # a Newtonian film of one temperature has friction, but no fields of it (`solver.newtonian_shear`)
    needed += _SHEAR * any(name in fields for name in _SHEAR)
    needed += _HEAT * (figures.temperature_max_film is not None)
    for name in needed:
        if name not in fields:
            yield f"the field {name} is missing"
        elif set(fields[name].dims) != set(axes):
            yield f"the field {name} is over {', '.join(map(str, fields[name].dims)) or 'nothing'}"
    for held, field in fields.variables.items():
        if field.dtype.kind not in "iufb":
            yield f"the field {held} is not one of numbers"
        # a tooth's gap is known where the teeth are
        elif solution.converged and held != "tooth_gap" and not np.isfinite(field.values).all():
            yield f"it is marked as converged, but its field {held} is not finite everywhere"
    if solution.converged and fields["pressure"].values.min() < 0:
        yield "it is marked as converged, but its pressure is negative somewhere"
    # mean planes of rough flanks may cross where asperities carry the load, others beyond their ends, where
    # they are continued
    film = fields["film"].where(fields["covered"] != 0, inf)
    apart = "asperity_pressure" in fields or film.values.min() > 0
    if solution.converged and not apart:
        yield "it is marked as converged, but its film is not above zero everywhere"
    for name in SIZES[solution.kind]:
        if not _is_size(fields.attrs.get(name)):
            yield f"{name} of its fields is {fields.attrs.get(name)!r:.60}"


def _flaws_of_parts(solution: Solution) -> Iterator[str]:
    """Errors in the convergence history and in the profile across a hot film."""
    wanted = [(solution.history, ("residual", "load_error", "krylov", "points_x"), "history")]
    if solution.figures.temperature_max_film is not None:
        if solution.profile is None or solution.inlet_temperature is None:
            yield "it has temperatures, but no profile or no inlet temperature"
            return
        wanted.append((solution.profile, _ACROSS, "profile"))
    if solution.life is not None:
        wanted.append((solution.life, _LIFE, "life"))
    for part, names, what in wanted:
        for name in names:
            if name not in part or part[name].dtype.kind not in "iuf":
                yield f"its {what} has no numbers for {name}"


def _flaws_of_figures(solution: Solution) -> Iterator[str]:
    figures = solution.figures
    estimates = {
        part.name: getattr(figures, part.name)
        for part in parts_of(figures)
        if isinstance(getattr(figures, part.name), Estimate)
    }
    for name, estimate in estimates.items() if solution.converged else ():
        if not isfinite(estimate.value):
            yield f"it is marked as converged, but its {name} is {estimate.value}"
        if not estimate.error >= 0:
            yield f"it is marked as converged, but the numerical uncertainty of {name} is {estimate.error}"
    sizes = {name: estimates[name].value for name in ("film_min", "film_central", "pressure_max")}
    for name, value in (sizes | {"load": solution.load}).items():
        if solution.converged and not value > 0:
            yield f"it is marked as converged, but its {name} is {value:g}"
    if len(figures.film_min_at) != len(AXES[solution.kind]):
        yield f"film_min_at is {figures.film_min_at}"
    if (figures.dry is None) != (solution.kind == "line"):
        yield "its figures are those of another kind of contact"


def _rises(coordinate: "xr.DataArray") -> bool:
    values = coordinate.values
    return values.dtype.kind in "iuf" and values.size > 1 and bool((np.diff(values) > 0).all())


def _is_size(value: Any) -> bool:
    return isinstance(value, int | float | np.number) and bool(isfinite(value) and value > 0)
