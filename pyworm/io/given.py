"""Values given in Python: numbers in SI, or texts with units, judged as those of case files are.

A class of values has types of `pyworm.io.units` for its fields, `load: units.Force`, by which values are read
here and in case files. Sizes that there are not are refused here with the sentences of case files; what is
impossible besides is refused by the class itself.
"""

from collections.abc import Iterator, Sequence
from dataclasses import fields, is_dataclass
from functools import cache
from math import isfinite
from numbers import Real
from typing import Any, get_args, get_origin, get_type_hints, overload

import numpy as np

from pyworm.io.quantity import Kind, doubt, parse, possible

WithUnit = float | str
"""What stands for a number with a dimension: the number in SI, or a text with its unit."""

Given = WithUnit | Sequence[WithUnit] | Sequence[Sequence[WithUnit]] | np.ndarray
"""What stands for numbers with a dimension: numbers in SI, texts with units, or rows of both."""

Names = str | Sequence[str]
"""What stands for a choice of names: one, "auto", or several, ("auto", "-squeeze")."""

MAX_VALUE_LENGTH = 40
"""Characters of a value that a sentence shows."""


def take(owner: Any, *, sizes: bool = True, law: type | None = None) -> None:
    """Replace the quantities of a frozen dataclass by numbers in SI; None stays where it is the default.

    Quantities have types of `pyworm.io.units`, of several numbers `tuple[type, ...]`; a `law` may stand in
    place of a number. ValueError if there is no number and no text with a unit, or, unless not `sizes`, for
    one of an impossible size.
    """
    its_class: type = type(owner)
    optional = {part.name for part in fields(owner) if part.default is None}
    for name, (kind, several) in quantities(its_class).items():
        value = getattr(owner, name)
        if law is not None and isinstance(value, law):
            continue
        if value is None and name in optional:
            continue
        read = _several if several else number
        object.__setattr__(owner, name, read(name, value, kind, sizes=sizes))


@cache
def quantities(owner: type) -> dict[str, tuple[Kind, bool]]:
    """Fields of a dataclass that are quantities -> their kind, and whether each is several numbers."""
    hints = get_type_hints(owner, include_extras=True)
    found = {}
    for part in fields(owner):
        hint = hints[part.name]
        several = get_origin(hint) is tuple
        kinds = [kind for part in (hint, *get_args(hint)) if (kind := _own_kind(part)) is not None]
        if kinds:
            found[part.name] = kinds[0], several
    return found


def _own_kind(hint: Any) -> Kind | None:
    """The kind of quantity of a type of `pyworm.io.units`; None of any other."""
    return next(
        (
            annotation
            for annotation in getattr(hint, "__metadata__", ())
            if isinstance(annotation, Kind)
        ),
        None,
    )


def kind_of(annotated: Any) -> Kind:
    """The kind of quantity of a type of `pyworm.io.units`."""
    return next(annotation for annotation in annotated.__metadata__ if isinstance(annotation, Kind))


def _several(name: str, value: object, kind: Kind, *, sizes: bool = True) -> tuple[float, ...]:
    """Numbers in SI from numbers or texts with units in a row; ValueError as of `take`."""
    return tuple(
        number(f"{name}[{place}]", entry, kind, sizes=sizes)
        for place, entry in enumerate(row(name, value))
    )


def text(name: str, value: object) -> str:
    """A text; ValueError of anything else."""
    if not isinstance(value, str):
        raise ValueError(f"{name} = {value!r:.{MAX_VALUE_LENGTH}}: must be a text in quotes")
    return value


def as_names(value: Any, example: str) -> tuple[str, ...]:
    """The names of a choice; ValueError for what is none, and for several in one text."""
    given = (value,) if isinstance(value, str) else value
    if isinstance(value, str) and "," in value:
        several = ", ".join(f'"{part.strip()}"' for part in value.split(","))
        raise ValueError(f"several names must be texts of their own, {several}")
    if (
        not isinstance(given, Sequence | np.ndarray)
        or not len(given)
        or not all(isinstance(part, str) for part in given)
    ):
        raise ValueError(f"must be one name or several, such as {example}")
    return tuple(map(str, given))


def name_list(name: str, value: Any, example: str) -> tuple[str, ...]:
    """The names of an argument, as of `as_names`."""
    try:
        return as_names(value, example)
    except ValueError as error:
        shown = f'"{value}"' if isinstance(value, str) else f"{value!r}"
        raise ValueError(f"{name} = {shown:.{MAX_VALUE_LENGTH}}: {error}") from None


def row(name: str, value: Any) -> Sequence[Any] | np.ndarray:
    """Several values in a row; ValueError of a single one."""
    if isinstance(value, str) or not isinstance(value, Sequence | np.ndarray) or not np.ndim(value):
        raise ValueError(
            f"{name} = {value!r:.{MAX_VALUE_LENGTH}}: must be several values, such as (1.0, 2.0)"
        )
    return value


@overload
def in_si(name: str, value: WithUnit, annotated: Any) -> float: ...


@overload
def in_si(name: str, value: Given, annotated: Any) -> Any: ...


def in_si(name: str, value: Given, annotated: Any) -> Any:
    """A number in SI, or an array of several, from numbers, which stay as they are, or texts with units.

    `annotated` is their type of `pyworm.io.units`. ValueError of a text that means no such quantity, and of
    what is neither number nor text.
    """
    dtype = getattr(value, "dtype", None)
    if type(value) is float or (dtype is not None and dtype.kind not in "OUS"):
        return value
    if isinstance(value, str):
        return number(name, value, kind_of(annotated))
    if isinstance(value, Sequence | np.ndarray):
        return np.array(
            [in_si(f"{name}[{place}]", entry, annotated) for place, entry in enumerate(value)]
        )
    if isinstance(value, bool) or not isinstance(value, Real):
        number(name, value, kind_of(annotated))
    return value


def number(name: str, value: object, kind: Kind, *, sizes: bool = True) -> float:
    """A number in SI from a number or a text with its unit; ValueError as of `take`.

    Zero, negative and infinite numbers are left to the caller, who knows what they mean.
    """
    if isinstance(value, str):
        try:
            return parse(value, kind)
        except ValueError as error:
            raise ValueError(f'{name} = "{value:.{MAX_VALUE_LENGTH}}": {error}') from None
    if isinstance(value, bool) or not isinstance(value, Real):
        raise ValueError(
            f"{name} = {value!r:.{MAX_VALUE_LENGTH}}: must be {kind.noun} as a number in {_si(kind)}, or a "
            f'text such as "{kind.example}"'
        )
    try:
        given = float(value)
    except OverflowError:  # of a whole number or a fraction that has no float
        raise ValueError(
            f"{name} = {value!r:.{MAX_VALUE_LENGTH}}: must be {kind.noun} of a possible size"
        ) from None
    if sizes and isfinite(given) and given > 0 and not possible(given, kind):
        try:
            parse(_text(given, kind), kind)
        except ValueError as error:
            raise ValueError(f"{name} = {given:g} {kind.unit}: {error}") from None
    return given


def _si(kind: Kind) -> str:
    return kind.unit or "parts of one"


def _text(value: float, kind: Kind) -> str:
    """A number in SI as a case file would have it."""
    return f"{value!r} {kind.unit}".rstrip()


def unusual(record: Any, above: str = "") -> Iterator[str]:
    """A sentence for each unusual value in a dataclass and those within it, as of `quantity.doubt`."""
    its_class: type = type(record)
    kinds = quantities(its_class)
    for part in fields(record):
        value = getattr(record, part.name)
        name = f"{above}{part.name}"
        if part.name in kinds and not _holds(value):
            several = value if isinstance(value, tuple) else (value,)
            worst = (_doubted(name, entry, kinds[part.name][0]) for entry in several)
            yield from (sentence for sentence in worst if sentence is not None)
        elif isinstance(value, tuple):
            for place, entry in enumerate(value):
                if _holds(entry):
                    yield from unusual(entry, f"{name}[{place}].")
        elif _holds(value):
            yield from unusual(value, f"{name}.")


def _doubted(name: str, value: object, kind: Kind) -> str | None:
    """The sentence on an unusual number in SI; None of a usual one, and of what is no number."""
    if not isinstance(value, Real) or not isfinite(value):
        return None
    sentence = doubt(_text(float(value), kind), kind)
    return (
        None if sentence is None else f"{name} = {value:g} {kind.unit}".rstrip() + f": {sentence}"
    )


def _holds(value: object) -> bool:
    """Whether a value is a dataclass that may name quantities."""
    return is_dataclass(value) and not isinstance(value, type)
