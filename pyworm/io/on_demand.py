"""Modules that take long to load, loaded with the first use of what is in them.

SciPy does so by itself: `import scipy` is quick, and `scipy.optimize` is loaded where it is called.
"""

import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any, cast


class _OnDemand(ModuleType):
    """Stands for a module and loads it for its attributes; annotations that name one are quoted."""

    def __getattr__(self, name: str) -> Any:
        return getattr(import_module(self.__name__), name)


def forbid(name: str) -> None:
    """Let a module count as missing in this process, one that a library would load without any use for it."""
    cast("dict[str, ModuleType | None]", sys.modules).setdefault(name, None)


def allow(name: str) -> None:
    """Let a module that was left out be loaded."""
    if name in sys.modules and sys.modules[name] is None:
        del sys.modules[name]


if TYPE_CHECKING:
    import xarray as xarray
else:
    xarray = _OnDemand("xarray")


def lazy_property(module: str, name: str, doc: str) -> property:
    """An attribute made of its owner by a class of a module that is loaded with the first use.

    So objects of one floor can be asked for what is built upon them, and know no more of it than where.
    """
    return property(lambda owner: attribute_of(module, name)(owner), doc=doc)


def attribute_of(module: str, name: str) -> Any:
    """What a module built upon the asking one has; loaded with the first use."""
    return getattr(import_module(module), name)
