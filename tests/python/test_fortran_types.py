"""Derived types of the kernel: each is released with all that it holds.

For a type that is extended, or has a final procedure anywhere in it, gfortran writes a procedure that
releases the components, those of components too. Which of them are done, it knows by the addresses of its
own expressions, some of which are freed by then (`finalize_component` in its `class.cc`): where a type occurs
twice, the second may be taken for the first, and its memory is never released. In gfortran 12.2 this depends
on what else is in the file. Allocatable components are released whole, each for itself.
"""

import re
from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

from folders import ROOT

KERNEL = ROOT / "fortran"

DEFINITION = re.compile(
    r"^ *type\b(?:[^:(\n]*extends\((\w+)\))?[^:(\n]*:: *(\w+)\n(.*?)^ *end type",
    re.MULTILINE | re.DOTALL,
)
"""A derived type: the type that it extends, its name, what stands in it."""

COMPONENTS = re.compile(r"^ *(?:type|class)\((\w+)\)([^:\n]*)::([^!\n]*)", re.MULTILINE)
"""Components of a derived type: the type, their attributes and names."""


class DerivedType(NamedTuple):
    """What a derived type holds."""

    parent: str | None
    """The type that it extends."""
    parts: list[str]
    """Types of the components that are part of it, that which it extends included."""
    allocated: list[str]
    """Types of the components that are allocatable."""
    allocates: bool
    """Whether any component is allocatable."""
    final: bool
    """Whether it has a final procedure itself."""


def derived_types(text: str) -> dict[str, DerivedType]:
    """All derived types in Fortran's text, by name."""
    types = {"c_ptr": DerivedType(None, [], [], False, False)}
    for parent, name, body in DEFINITION.findall(text):
        parts, allocated = [parent] if parent else [], []
        for type_name, attributes, names in COMPONENTS.findall(body):
            count = len(re.sub(r"\([^)]*\)", "", names).split(","))
            if "allocatable" in attributes:
                allocated += count * [type_name]
            elif "pointer" not in attributes:
                parts += count * [type_name]
        allocates = re.search(r"^[^!\n]*\ballocatable\b", body, re.MULTILINE) is not None
        final = re.search(r"^ *final ::", body, re.MULTILINE) is not None
        types[name] = DerivedType(parent or None, parts, allocated, allocates, final)
    return types


def has_memory(types: dict[str, DerivedType], name: str) -> bool:
    """Whether something is to be released with an object of a type."""
    own = types[name]
    return own.allocates or own.final or any(has_memory(types, part) for part in own.parts)


def is_finalised(types: dict[str, DerivedType], name: str) -> bool:
    """Whether there is a final procedure anywhere in a type."""
    own = types[name]
    return own.final or any(is_finalised(types, part) for part in own.parts + own.allocated)


def released_by_parts(types: dict[str, DerivedType], name: str) -> Iterator[str]:
    """Types with memory whose components are released one by one with an object of a type."""
    for part in types[name].parts:
        if has_memory(types, part) and not types[part].final:
            yield part
            yield from released_by_parts(types, part)


def released_twice(text: str) -> dict[str, list[str]]:
    """Types that are released by parts more than once with an object of another, by the name of that."""
    types = derived_types(text)
    extended = {one.parent for one in types.values()}
    found = {}
    for name, one in types.items():
        if one.parent or name in extended or is_finalised(types, name):
            counts = Counter(released_by_parts(types, name))
            found[name] = [part for part, count in counts.items() if count > 1]
    return found


def test_no_type_with_memory_is_twice_in_a_finalised_one():
    text = "\n".join(file.read_text(encoding="utf-8") for file in KERNEL.rglob("*.f90"))
    found = released_twice(text)
    assert {"point_contact", "point_film_heat", "elastic_half_space"} <= found.keys()
    assert not {name: parts for name, parts in found.items() if parts}


def test_types_in_types_are_counted():
    assert released_twice(
        "type :: ended\n contains\n final :: done\nend type ended\n"
        "type :: field\n real, allocatable :: p(:)\nend type field\n"
        "type :: inner\n type(field) :: a, b(2)\n type(ended) :: e, f\nend type inner\n"
        "type :: plain\n type(field) :: a, b\nend type plain\n"
        "type, abstract :: base\n type(field) :: a\nend type base\n"
        "type, extends(base) :: whole\n type(field), allocatable :: b\nend type whole\n"
        "type, extends(base) :: seen\n type(field), pointer :: b\nend type seen\n"
        "type, extends(base) :: double\n type(field) :: b\nend type double\n"
    ) == {"ended": [], "inner": ["field"], "base": [], "whole": [], "seen": [], "double": ["field"]}
