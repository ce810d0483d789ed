"""Values given in Python: numbers in SI, or texts with units, judged as those of case files are.

A class of values names the kinds of its attributes in `QUANTITIES`. Sizes that there are not are refused here
with the sentences of case files; what is impossible besides is refused by the class itself.
"""

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from math import isfinite
from numbers import Real
from typing import Any

from pyworm.io.quantity import Kind, doubt, parse

LONGEST = 40
"""Characters of a value that a sentence shows."""


def take(owner: Any, *, sizes: bool = True) -> None:
    """Replace the quantities of a frozen dataclass by numbers in SI; None stays where it is the default.

    Parameters
    ----------
    owner : dataclass
        Its class has `QUANTITIES`, name of an attribute -> its type of `pyworm.io.units`.
    sizes : bool, optional
        Whether numbers of a size that there is not are refused.

    Raises
    ------
    ValueError
        No number and no text with a unit, or of a size that there is not.
    """
    optional = {part.name for part in fields(owner) if part.default is None}
    for name, of in type(owner).QUANTITIES.items():
        value = getattr(owner, name)
        if _holds(value):  # a law in place of a number, which has been checked itself
            continue
        if value is not None or name not in optional:
            object.__setattr__(owner, name, number(name, value, kind_of(of), sizes=sizes))


def kind_of(annotated: Any) -> Kind:
    """The kind of quantity of a type of `pyworm.io.units`."""
    return next(part for part in annotated.__metadata__ if isinstance(part, Kind))


def number(name: str, value: Any, kind: Kind, *, sizes: bool = True) -> float:
    """A number in SI from a number or a text with its unit; ValueError as of `take`.

    Zero, negative and infinite numbers are left to the caller, who knows what they mean.
    """
    if isinstance(value, str):
        try:
            return parse(value, kind)
        except ValueError as error:
            raise ValueError(f'{name} = "{value:.{LONGEST}}": {error}') from None
    if isinstance(value, bool) or not isinstance(value, Real):
        raise ValueError(
            f"{name} = {value!r:.{LONGEST}}: must be {kind.noun} as a number in {_si(kind)}, or a text "
            f'such as "{kind.example}"'
        )
    try:
        given = float(value)
    except OverflowError:  # of a whole number or a fraction that has no float
        raise ValueError(
            f"{name} = {value!r:.{LONGEST}}: must be {kind.noun} of a possible size"
        ) from None
    if sizes and isfinite(given) and given > 0:
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


def unusual(of: Any, above: str = "") -> Iterator[str]:
    """A sentence for each unusual value in a dataclass and those within it, as of `quantity.doubt`."""
    kinds: Mapping[str, Any] = getattr(type(of), "QUANTITIES", {})
    for part in fields(of):
        value = getattr(of, part.name)
        name = f"{above}{part.name}"
        if part.name in kinds and isinstance(value, Real) and isfinite(value):
            kind = kind_of(kinds[part.name])
            sentence = doubt(_text(float(value), kind), kind)
            if sentence is not None:
                yield f"{name} = {value:g} {kind.unit}".rstrip() + f": {sentence}"
        elif isinstance(value, tuple):
            for place, one in enumerate(value):
                if _holds(one):
                    yield from unusual(one, f"{name}[{place}].")
        elif _holds(value):
            yield from unusual(value, f"{name}.")


def _holds(value: Any) -> bool:
    """Whether a value is a dataclass that may name quantities."""
    return is_dataclass(value) and not isinstance(value, type)
