"""Uncertainty of results by inputs, by the model, and by the numbers.

Standard uncertainties of the GUM (JCGM 100:2008). An input moves a result by half of its difference between
solves one standard uncertainty above and below (5.1.3, note 2); inputs are independent but for values of one
fit, whose correlations are known (5.2.2). Numerical and model uncertainties are bounds that hold in 19 of 20
cases; half of each counts as its standard uncertainty.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot, sqrt
from typing import Any

import numpy as np

from pyworm.case.uncertain_inputs import UncertainInputs
from pyworm.formulas.arrays import Array
from pyworm.io.quantities import Quantity, quantity_of
from pyworm.io.shown import Shown
from pyworm.result.result import Result

BOUND = 2.0
"""A bound that holds in 19 of 20 cases over its standard uncertainty."""


@dataclass(frozen=True)
class UncertainResult:
    """A result and its standard uncertainties [SI]."""

    name: str
    """Name of the result."""
    value: float
    """The result."""
    changes: tuple[float, ...]
    """Its change with each input by that one's standard uncertainty."""
    inputs: float
    """Standard uncertainty by all inputs."""
    model: float
    """Standard uncertainty by the model."""
    numerical: float
    """Standard uncertainty by the numerical solution."""

    @property
    def quantity(self) -> Quantity:
        """How it is shown."""
        return quantity_of(self.name)

    @property
    def combined(self) -> float:
        """Combined standard uncertainty."""
        return hypot(self.inputs, self.model, self.numerical)

    @property
    def shares(self) -> Array:
        """Share of each input in the variance by inputs; of correlated ones without their covariance."""
        squares = np.square(self.changes)
        return squares / squares.sum() if squares.any() else squares


@dataclass(frozen=True, repr=False)
class InputUncertainty(Shown):
    """Uncertainty of the results of a case by its inputs, by the model and by the numbers."""

    inputs: tuple[str, ...]
    """Dotted keys of the uncertain inputs."""
    texts: tuple[str, ...]
    """Each with its standard uncertainty, in words."""
    results: tuple[UncertainResult, ...]
    """Results with their uncertainties."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and results in words."""
        return "Uncertainty by inputs", {
            each.name: each.quantity.text(each.value)
            + f" ± {each.combined * each.quantity.scale:.2g}"
            for each in self.results
        }

    def summary(self) -> dict[str, Any]:
        """All of it as an object, in SI."""
        return {
            "inputs": dict(zip(self.inputs, self.texts, strict=True)),
            "results": {
                each.name: {
                    "value": each.value,
                    "changes": list(each.changes),
                    "by_inputs": each.inputs,
                    "by_model": each.model,
                    "by_numbers": each.numerical,
                    "combined": each.combined,
                }
                for each in self.results
            },
        }


IN_PROVENANCE = "input_uncertainty"
"""Entry of a result's provenance."""


def uncertainty_in(result: Result) -> InputUncertainty | None:
    """The uncertainty by inputs that a result holds; None without one."""
    kept = result.provenance.get(IN_PROVENANCE)
    if kept is None:
        return None
    return InputUncertainty(
        tuple(kept["inputs"]),
        tuple(kept["inputs"].values()),
        tuple(
            UncertainResult(
                name,
                part["value"],
                tuple(part["changes"]),
                part["by_inputs"],
                part["by_model"],
                part["by_numbers"],
            )
            for name, part in kept["results"].items()
        ),
    )


def by_inputs(uncertain: UncertainInputs, changes: Sequence[float]) -> float:
    """Standard uncertainty of a result by all inputs, from its change with each."""
    keys = list(uncertain.values)
    correlation = [[uncertain.correlation(first, second) for second in keys] for first in keys]
    return sqrt(max(float(np.array(changes) @ np.array(correlation) @ np.array(changes)), 0.0))
