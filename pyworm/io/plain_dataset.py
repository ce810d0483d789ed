"""Named arrays over named dimensions, so that a run does not wait for xarray to be loaded.

What solving, writing and drawing a contact use of xarray.Dataset, by its names: the same code reads either.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, TypeAlias, TypeVar

import numpy as np

from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import attributes

T = TypeVar("T")


@dataclass(frozen=True)
class PlainVariable:
    """An array with names of its dimensions."""

    dims: tuple[str, ...]
    """Names of its dimensions."""
    values: np.ndarray
    """The array."""
    attrs: Mapping[str, str]
    """Unit and long name."""

    def transpose(self, *dims: str) -> "PlainVariable":
        """The variable with its dimensions in another order."""
        order = [self.dims.index(name) for name in dims]
        return replace(self, dims=dims, values=self.values.transpose(order))


@dataclass(frozen=True)
class PlainDataset:
    """Variables that share dimensions."""

    variables: Mapping[str, PlainVariable]
    """Name -> variable."""
    coords: tuple[str, ...]
    """Names of those that are coordinates."""
    attrs: Mapping[str, Any]
    """Attributes of the whole."""

    @cached_property
    def sizes(self) -> dict[str, int]:
        """Name of each dimension -> its size."""
        return {
            name: size
            for variable in self.variables.values()
            for name, size in zip(variable.dims, variable.values.shape, strict=True)
        }

    @property
    def dims(self) -> Iterable[str]:
        """Names of the dimensions."""
        return self.sizes

    def __contains__(self, name: str) -> bool:
        """Whether a variable is there."""
        return name in self.variables

    def __getitem__(self, name: str) -> PlainVariable:
        """A variable."""
        return self.variables[name]

    def isel(self, **parts: slice) -> "PlainDataset":
        """Parts of some dimensions, by place."""
        variables = {
            name: replace(
                variable,
                values=variable.values[tuple(parts.get(dim, slice(None)) for dim in variable.dims)],
            )
            for name, variable in self.variables.items()
        }
        return replace(self, variables=variables)

    def merge(self, other: "PlainDataset") -> "PlainDataset":
        """The variables of both, with the attributes of this one."""
        variables = {**self.variables, **other.variables}
        return replace(self, variables=variables, coords=(*self.coords, *other.coords))

    def to_xarray(self) -> "xr.Dataset":
        """The dataset as one of xarray."""
        variables = {
            name: (variable.dims, variable.values, variable.attrs)
            for name, variable in self.variables.items()
        }
        coords = {name: variables.pop(name) for name in self.coords}
        return xr.Dataset(variables, coords=coords, attrs=dict(self.attrs))


AnyDataset: TypeAlias = "PlainDataset | xr.Dataset"
"""Either kind; a name alone, so that xarray is not loaded for it."""


def merged(first: "PlainDataset | xr.Dataset", second: PlainDataset) -> "PlainDataset | xr.Dataset":
    """The variables of both, with the attributes of the first, held as that is."""
    if isinstance(first, PlainDataset):
        return first.merge(second)
    return first.merge(second.to_xarray())


def described(
    variables: Mapping[str, tuple[tuple[str, ...], Any]],
    coords: Mapping[str, tuple[tuple[str, ...], Any]],
    attrs: Mapping[str, Any] | None = None,
) -> PlainDataset:
    """A dataset of variables, by dimensions and values, with units and long names; KeyError without such."""
    held = {}
    for name, (dims, values) in {**variables, **coords}.items():
        held[name] = PlainVariable(dims, np.asarray(values), attributes(name))
    return PlainDataset(held, tuple(coords), attrs or {})


class _OnDemandDataset:
    """An attribute that is given as any dataset and read as xarray's, made with the first look."""

    def __init__(self, name: str) -> None:
        self._place = f"_{name}"

    def __set__(self, instance: Any, value: "PlainDataset | xr.Dataset | None") -> None:
        vars(instance)[self._place] = value

    def __get__(self, instance: Any, owner: type) -> "xr.Dataset | None":
        value = self.held(instance)
        if isinstance(value, PlainDataset):
            opened = vars(instance)[self._place] = value.to_xarray()
            return opened
        return value

    def held(self, instance: Any) -> "PlainDataset | xr.Dataset | None":
        value: PlainDataset | xr.Dataset | None = vars(instance)[self._place]
        return value


def reads_as_xarray(*names: str) -> Callable[[type[T]], type[T]]:
    """Decorator of a dataclass: these attributes, given as any datasets, are read as xarray's (`held`)."""

    def decorated(kind: type[T]) -> type[T]:
        for name in names:
            setattr(kind, name, _OnDemandDataset(name))
        return kind

    return decorated


def held(instance: Any, name: str) -> "PlainDataset | xr.Dataset | None":
    """An attribute named in `reads_as_xarray` as it is held, so that xarray is not loaded for it."""
    attribute: _OnDemandDataset = vars(type(instance))[name]
    return attribute.held(instance)


def same_data(first: "xr.Dataset | None", other: "xr.Dataset | None") -> bool:
    """Whether two datasets, or none, hold the same, missing numbers included."""
    return first is other if first is None or other is None else first.identical(other)
