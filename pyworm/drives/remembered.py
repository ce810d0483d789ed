"""Methods whose values are kept: what a drive is asked for again and again is found once."""

from collections import OrderedDict
from collections.abc import Callable
from functools import wraps
from typing import Any

MOST = 1000
"""Number of values that an object keeps; beyond it those used least recently go."""


class _Found(OrderedDict):
    """Values by method and arguments; other processes get none of them along with their object."""

    def __reduce__(self) -> tuple:
        return _Found, ()


def remembered(method: Callable) -> Callable:
    """A method of an immutable object that finds each value once; arguments have to be hashable."""

    @wraps(method)
    def recall(self: Any, *arguments: Any) -> Any:
        found = vars(self).setdefault("_found", _Found())
        key = method.__name__, *arguments
        if key not in found:
            found[key] = method(self, *arguments)
            if len(found) > MOST:
                found.popitem(last=False)
        found.move_to_end(key)
        return found[key]

    return recall
