"""A calibration: values of a case fitted to measurements, and what the data say about them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import inf, isfinite
from pathlib import Path
from typing import Any

import numpy as np

from pyworm.case.fitted_values import fitted_file
from pyworm.formulas.least_squares import Combination
from pyworm.io.atomic import whole_file
from pyworm.io.quantity_text import percent
from pyworm.io.shown import Shown

STRONG_CORRELATION = 0.9
"""Correlation of two values from which they are reported as hardly told apart."""


@dataclass(frozen=True)
class FittedValue:
    """A fitted value of a case."""

    name: str
    """Name of the parameter."""
    keys: tuple[str, ...]
    """Dotted keys of the case that have it."""
    unit: str
    """Unit of the numbers below, empty without one."""
    value: float
    """The fitted value."""
    standard: float
    """Its standard uncertainty; infinite where the data do not determine it, 0 at a bound."""
    half_width: float
    """Half width of its 95 % interval, likewise."""
    start: float
    """Value of the case."""
    low: float
    """Lower bound."""
    high: float
    """Upper bound."""
    at_bound: bool = False
    """Whether it is held at a bound."""

    @property
    def interval(self) -> tuple[float, float]:
        """The 95 % interval; all values within the bounds where the data determine none."""
        if not isfinite(self.half_width):
            return self.low, self.high
        return self.value - self.half_width, self.value + self.half_width

    @property
    def written(self) -> str | float:
        """The value with its standard uncertainty as a case file has it."""
        number = f"{self.value:.6g} {self.unit}".rstrip()
        if not 0 < self.standard < inf:
            return number if self.unit else self.value
        return f"{number} +- {self.standard:.2g} {self.unit}".rstrip()

    def summary(self) -> dict[str, Any]:
        """All of it as an object; numbers that are not finite are null."""
        low, high = self.interval
        return {
            "keys": list(self.keys),
            "unit": self.unit,
            "value": self.value,
            "standard_uncertainty": self.standard if isfinite(self.standard) else None,
            "interval": [low, high],
            "start": self.start,
            "bounds": [self.low, self.high],
            "at_bound": self.at_bound,
        }


@dataclass(frozen=True)
class FittedRow:
    """A measurement and what is computed for it with the fitted values."""

    line: int
    """Line of the file."""
    conditions: Mapping[str, Any]
    """Conditions, key and value as a case file has them."""
    quantity: str
    """What was measured."""
    measured: float
    """Measured value [SI]."""
    standard: float
    """Its standard uncertainty [SI]."""
    before: float
    """Computed with the values of the case [SI]."""
    fitted: float
    """Computed with the fitted ones [SI]."""
    leave_one_out: float
    """Measured value less its prediction by a fit to all others [SI]."""

    @property
    def residual(self) -> float:
        """Measured less fitted value over the standard uncertainty."""
        return (self.measured - self.fitted) / self.standard

    def summary(self) -> dict[str, Any]:
        """All of it as an object, in SI."""
        return {**vars(self), "residual": self.residual}


@dataclass(frozen=True, repr=False)
class Calibration(Shown):
    """Values of a case fitted to measurements: what `pyworm.calibrate` gives."""

    case_name: str
    """Name of the case."""
    data_name: str
    """Name of the file of measurements."""
    values: tuple[FittedValue, ...]
    """The fitted values."""
    rows: tuple[FittedRow, ...]
    """The measurements."""
    correlation: tuple[tuple[float, ...], ...]
    """Correlations of the values."""
    combinations: tuple[Combination, ...]
    """Power products of the values by how well the data determine them."""
    chi_squared: float
    """Sum of the squares of the residuals over their standard uncertainties."""
    degrees: int
    """Degrees of freedom."""
    numerical: float
    """Largest numerical uncertainty of a computed value over the standard uncertainty of its measurement."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the calibration in words."""
        return f"Calibration of {self.case_name}", {
            **{value.name: f"{value.written}" for value in self.values},
            "measurements": f"{len(self.rows)}",
        }

    def __getitem__(self, name: str) -> FittedValue:
        """A fitted value by the name of its parameter; KeyError without one."""
        for value in self.values:
            if value.name == name:
                return value
        raise KeyError(name)

    @property
    def leave_one_out_error(self) -> dict[str, float]:
        """Quantity -> root mean square of its leave-one-out prediction errors [SI]."""
        names = dict.fromkeys(row.quantity for row in self.rows)
        return {
            name: float(
                np.sqrt(
                    np.mean([row.leave_one_out**2 for row in self.rows if row.quantity == name])
                )
            )
            for name in names
        }

    @property
    def statements(self) -> tuple[str, ...]:
        """What the data determine and what they cannot, a sentence each."""
        return (*self._determined(), *self._correlated(), *self._bounded(), *self._scatter())

    def _determined(self) -> Sequence[str]:
        names = [value.name for value in self.values]
        if not self.combinations:
            return []
        known = [found for found in self.combinations if found.determined]
        if len(known) == len(self.combinations) and known:
            worst = known[-1]
            every = "" if len(known) == 1 else " every free value; worst known is"
            return [f"The data determine{every} {worst.words(names)}, to {percent(worst.spread)}."]
        fixed = " and ".join(
            f"{found.words(names)} (to {percent(found.spread)})" for found in known
        )
        unknown = " and ".join(
            found.words(names) for found in self.combinations if not found.determined
        )
        if not known:
            return [f"The data do not determine {unknown}."]
        return [f"The data fix only {fixed}: they do not determine {unknown}."]

    def _correlated(self) -> Sequence[str]:
        return [
            f"{first.name} and {second.name} are correlated by {self.correlation[i][j]:.2f}: the data "
            "hardly separate them."
            for i, first in enumerate(self.values)
            for j, second in enumerate(self.values[:i])
            if abs(self.correlation[i][j]) > STRONG_CORRELATION
        ]

    def _bounded(self) -> Sequence[str]:
        return [
            f"{value.name} is at its bound: the data ask for a value beyond {value.value:.4g} "
            f"{value.unit}".rstrip()
            + ", and it has no uncertainty."
            for value in self.values
            if value.at_bound
        ]

    def _scatter(self) -> Sequence[str]:
        found = []
        if self.chi_squared > 2 * self.degrees:
            found.append(
                f"Residuals are {(self.chi_squared / self.degrees) ** 0.5:.2g} times the stated "
                "uncertainties: the model does not describe the data, or these are too small; intervals "
                "are enlarged by that factor."
            )
        if self.numerical > 1:
            found.append(
                f"The numerical uncertainty of the model is up to {self.numerical:.2g} times that of the "
                "measurements; request a higher accuracy."
            )
        return found

    def summary(self) -> dict[str, Any]:
        """All of it as one object; measured and fitted values in SI."""
        return {
            "case": self.case_name,
            "measured": self.data_name,
            "values": {value.name: value.summary() for value in self.values},
            "correlation": [list(row) for row in self.correlation],
            "chi_squared": self.chi_squared,
            "degrees_of_freedom": self.degrees,
            "statements": list(self.statements),
            "leave_one_out_error": self.leave_one_out_error,
            "rows": [row.summary() for row in self.rows],
        }

    def save(self, path: str | Path) -> Path:
        """Write the file of fitted values, which a case names: `fitted = "fitted.toml"`; returns its path."""
        path = Path(path)
        keys = [(key, number) for number, value in enumerate(self.values) for key in value.keys]
        values = {key: self.values[number].written for key, number in keys}
        matrix = [[self.correlation[i][j] for _, j in keys] for _, i in keys]
        source = (
            f"fitted by pyworm calibrate to {len(self.rows)} measurements of {self.data_name}, case "
            f"{self.case_name}"
        )
        exact = [value.name for value in self.values if not 0 < value.standard < inf]
        if exact:
            source += f"; without uncertainty, not determined or at a bound: {', '.join(exact)}"
        with whole_file(path) as partial:
            partial.write_text(fitted_file(source, values, matrix), encoding="utf-8")
        return path
