"""Fields of a solution rounded to the accuracy they have, which takes a fifth of the room.

Single precision keeps 24 binary digits of a field whose figures are known to a per cent. Here every value
keeps only as many as a tenth of the error bar of its figure needs; the others are zero, and compress to
nothing. Rounding is to the nearest and relative to each value, so that thin films and low pressures are as
accurate as thick and high ones. To round again changes nothing.
"""

from math import ceil, isnan, log2

import numpy as np

from pyworm.io.on_demand import xarray as xr
from pyworm.io.plain_dataset import PlainDataset, PlainVariable
from pyworm.io.quantities import QUANTITIES
from pyworm.solver.estimate import Estimate
from pyworm.solver.solution import Solution

OF_ERROR_BAR = 0.1
"""Largest change by rounding, over the error bar of the field's figure."""

OF_GIVEN = 1e-4
"""Largest relative change of what the scene gives, gap and velocities, which have no error bar."""

MAX_RELATIVE_ROUNDING = 2.0**-10
"""Largest relative change of any field, so that contour lines stay smooth where error bars are wide."""

_SINGLE_DIGITS = 23
"""Binary digits that single precision stores after the leading one (IEEE 754)."""

_MARK = "rounded"
"""Attribute of the fields that says to what they are rounded."""


def is_rounded(solution: Solution) -> bool:
    """Whether fields were rounded by `rounded`."""
    return _MARK in solution.dataset("fields").attrs


def rounded(solution: Solution) -> Solution:
    """The solution with fields, and frames of its life, that have the accuracy of its figures.

    One that did not converge keeps all digits, since none of its error bars is known; so do fields of double
    precision, which are places.
    """
    if not solution.converged:
        return solution
    parts = {}
    for part in ("fields", "life"):
        data = solution.held(part)
        if data is not None:
            data = data if type(data) is PlainDataset else _plain(data)
            variables = {
                name: _rounded(solution, name, variable)
                for name, variable in data.variables.items()
            }
            parts[part] = PlainDataset(variables, data.coords, dict(data.attrs))
    fields = parts["fields"]
    marked = {**fields.attrs, _MARK: f"to {OF_ERROR_BAR:g} of the uncertainties"}
    parts["fields"] = PlainDataset(fields.variables, fields.coords, marked)
    return solution.changed(**parts)


def _plain(data: "PlainDataset | xr.Dataset") -> PlainDataset:
    """A dataset of xarray's as a plain one."""
    variables = {
        str(name): PlainVariable(tuple(map(str, variable.dims)), variable.values, variable.attrs)
        for name, variable in data.variables.items()
    }
    return PlainDataset(variables, tuple(map(str, data.coords)), data.attrs)


def _rounded(solution: Solution, name: str, variable: PlainVariable) -> PlainVariable:
    values = variable.values
    if values.dtype != np.float32:
        return variable
    figure = QUANTITIES[name].figure
    change = OF_GIVEN if figure == name else _allowed(getattr(solution.figures, figure))
    return PlainVariable(variable.dims, to_digits(values, _digits(change)), variable.attrs)


def _allowed(figure: Estimate | None) -> float:
    """Relative change that rounding may make of values up to a figure [-]; none where there is no figure."""
    if figure is None or isnan(figure.bar) or not figure.value > 0:
        return 0.0
    # the error bar of a temperature is that of the rise, and its field is in kelvin
    return min(OF_ERROR_BAR * figure.bar / figure.value, MAX_RELATIVE_ROUNDING)


def _digits(change: float) -> int:
    """Binary digits after the leading one with which rounding changes a value by no more than this [-]."""
    if change <= 2.0 ** -(_SINGLE_DIGITS + 1):
        return _SINGLE_DIGITS
    return ceil(-log2(change)) - 1


def to_digits(values: np.ndarray, digits: int) -> np.ndarray:
    """Numbers in single precision rounded to nearest, ties to even, in some binary digits.

    These are 1 to 23 after the leading one; 23 changes nothing.
    """
    dropped = _SINGLE_DIGITS - digits
    if dropped == 0:
        return values
    bits = np.ascontiguousarray(values).view(np.uint32)
    even = (bits >> np.uint32(dropped)) & np.uint32(1)
    up = bits + np.uint32((1 << (dropped - 1)) - 1) + even
    kept = (up & ~np.uint32((1 << dropped) - 1)).view(np.float32)
    # the largest numbers, and what is no number, have no neighbour to go to
    return np.where(np.isfinite(values) & np.isfinite(kept), kept, values)
