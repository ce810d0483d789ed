"""Methods whose values are kept: what a drive is asked for again and again is found once."""

from collections import OrderedDict
from collections.abc import Callable
from functools import wraps
from typing import Concatenate, ParamSpec, TypeVar

MAX_KEPT_VALUES = 1000
"""Number of values that an object keeps; beyond it those used least recently go."""


Own = TypeVar("Own")
Kept = TypeVar("Kept")
Rest = ParamSpec("Rest")


class _Found(OrderedDict):
    """Values by method and arguments; other processes get none of them along with their object."""

    def __reduce__(self) -> tuple:
        return _Found, ()


def cached(
    method: Callable[Concatenate[Own, Rest], Kept],
) -> Callable[Concatenate[Own, Rest], Kept]:
    """A method of an immutable object that finds each value once; arguments have to be hashable."""

    @wraps(method)
    def cached_value(self: Own, /, *arguments: Rest.args, **named: Rest.kwargs) -> Kept:
        found = vars(self).setdefault("_found", _Found())
        key = method.__name__, *arguments, *named.items()
        if key not in found:
            found[key] = method(self, *arguments, **named)
            if len(found) > MAX_KEPT_VALUES:
                found.popitem(last=False)
        found.move_to_end(key)
        return found[key]

    return cached_value
