"""Error messages for case files: one sentence for the first error."""

import difflib
import typing
from collections.abc import Iterable, Sequence
from typing import Any

from pydantic import BaseModel, ValidationError

_EXPECTED_TYPES = {
    "missing": "is missing",
    "float_type": "must be a number without unit",
    "finite_number": "must be finite",
    "int_type": "must be a whole number",
    "int_from_float": "must be a whole number",
    "string_type": "must be a text in quotes",
    "string_too_short": "must not be empty",
    "tuple_type": "must be a list",
    "list_type": "must be a list",
    "dict_type": "must be a table",
    "model_type": "must be a table",
    "model_attributes_type": "must be a table",
    "greater_than": "must be greater than {gt:g}",
    "greater_than_equal": "must be at least {ge:g}",
    "less_than": "must be less than {lt:g}",
    "less_than_equal": "must be at most {le:g}",
    "too_short": "has too few entries, at least {min_length} needed",
    "too_long": "has too many entries, at most {max_length} allowed",
    "literal_error": "must be {expected}",
    "union_tag_invalid": "must be one of {expected_tags}",
    "value_error": "{error}",
}


Location = tuple[str | int, ...]
"""Keys of tables and places in lists on the way to a value, with those of the models that pydantic chose."""

_LAST = {"extra_forbidden": 0, "missing": 2}
"""Kind of error -> place in the order of reporting, 1 of all others."""


class CaseError(ValueError):
    """Invalid input; the message is one sentence for the user."""


def sentence(error: ValidationError, model: type[BaseModel], data: dict[str, Any]) -> str:
    """The message about the first error in a case file: dotted key, value as written, what would be right."""
    # A misspelt key or a wrong name leaves another key missing, too: the former is the one to report.
    problem = min(error.errors(), key=lambda found: _LAST.get(found["type"], 1))
    keys, value = _as_written(problem["loc"], data, absent=problem["type"] == "missing")
    name = shortened(dotted(keys))
    if problem["type"] == "extra_forbidden":
        return (
            f"{name}: no such key; {right_key(str(keys[-1]), _choices(model, problem['loc'][:-1]))}"
        )
    if problem["type"] == "missing":
        return f"{name} is missing"
    if problem["type"] == "union_tag_not_found":
        return f"{name}.{problem['ctx']['discriminator'].strip(chr(39))} is missing"
    context = {**problem.get("ctx", {})}
    if problem["type"] == "union_tag_invalid":
        key = context["discriminator"].strip("'")
        name, value = f"{name}.{key}", value[key]
    wanted = (
        _EXPECTED_TYPES.get(problem["type"], problem["msg"]).format(**context).replace("'", '"')
    )
    if not keys:  # what two tables have to agree on; the message names them
        return wanted
    if isinstance(value, dict):
        return f"{name}: {wanted}"
    return f"{name} = {shortened(toml(value))}: {wanted}"


def _as_written(loc: Location, data: dict[str, Any], absent: bool) -> tuple[list[str | int], Any]:
    """Keys of a pydantic location as they stand in the file, and the value there.

    Pydantic names the chosen model of a union among the keys; the file does not. With `absent` the last
    key is one that the file lacks.
    """
    keys: list[str | int] = []
    value: Any = data
    for key in loc[:-1] if absent else loc:
        try:
            value = value[key]
        except (KeyError, IndexError, TypeError):
            continue
        keys.append(key)
    return ([*keys, loc[-1]], None) if absent else (keys, value)


def dotted(keys: Sequence[str | int]) -> str:
    """Keys of tables and places in lists as one name: "operation.lifts[0]"."""
    name = ""
    for key in keys:
        name += f"[{key}]" if isinstance(key, int) else f".{key}" if name else key
    return name


def _choices(model: type[BaseModel], loc: Location) -> list[type[BaseModel]]:
    """Models that the table may have to which a pydantic location leads."""
    choices: list[type[BaseModel]] = [model]
    for key in loc:
        fields = [table.model_fields[key] for table in choices if key in table.model_fields]
        if fields:
            choices = [table for field in fields for table in models_of(field.annotation)]
        else:  # the tag of a union, or a key or place that the writer chooses
            tagged = [
                table
                for table in choices
                if any(key in typing.get_args(f.annotation) for f in table.model_fields.values())
            ]
            choices = tagged or choices
    return choices


def models_of(annotation: Any) -> list[type[BaseModel]]:
    """The models that a field may hold."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [table for part in typing.get_args(annotation) for table in models_of(part)]


def right_key(key: str, choices: list[type[BaseModel]], further: Iterable[str] = ()) -> str:
    """What may be meant by a key that none of some models has, nor is among further ones."""
    for table in choices:
        called = getattr(table, "also_called", {})
        if key in called:
            return f"give {called[key]} instead"
    valid = sorted({key for table in choices for key in table.model_fields} | {*further})
    close = difflib.get_close_matches(key, valid, n=3, cutoff=0.6)
    if close:
        return f"did you mean {' or '.join(close)}?"
    return f"valid keys are {', '.join(valid)}"


MAX_VALUE_LENGTH = 80
"""Characters of a value that a sentence shows."""


def shortened(text: str) -> str:
    """A text, or its beginning where it is long."""
    return (
        text
        if len(text) <= MAX_VALUE_LENGTH
        else f"{text[:MAX_VALUE_LENGTH]}... ({len(text)} characters)"
    )


def toml(value: object) -> str:
    """A value as a case file has it."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, list):
        return f"[{', '.join(toml(entry) for entry in value)}]"
    return str(value)
