"""Comparison error of a computed figure against a measured one (ASME V&V 20-2009).

E = S - D with the computed S and the measured D, and its standard uncertainty u_val: its square is the sum of
u_num^2 of the solution, u_input^2 of the inputs and u_D^2 of the measurement. The error of the model lies
between E - u_val and E + u_val. Where E exceeds u_val the model errs, unless the uncertainty that is stated
for it covers the rest.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from math import hypot

AGREES, MODEL, DISAGREES = "within u_val", "within the model's uncertainty", "disagrees"
"""Verdicts."""


@dataclass(frozen=True)
class Computed:
    """A computed figure S, in SI units."""

    value: float
    """S."""
    numerical: float
    """u_num, a standard uncertainty."""
    model: float
    """Uncertainty that pyworm states for its model; zero where it states none."""
    inputs: Mapping[str, float] = field(default_factory=dict)
    """Change of S by a standard uncertainty of each input, with its sign."""

    @property
    def by_inputs(self) -> float:
        """u_input."""
        return hypot(*self.inputs.values())

    @property
    def largest_input(self) -> str:
        """The input that contributes most; empty where there is none."""
        return max(self.inputs, key=lambda name: abs(self.inputs[name]), default="")


@dataclass(frozen=True)
class Comparison:
    """A computed and a measured figure."""

    computed: Computed
    measured: float
    """D."""
    measurement: float
    """u_D."""

    @property
    def error(self) -> float:
        """E."""
        return self.computed.value - self.measured

    @property
    def uncertainty(self) -> float:
        """u_val."""
        return hypot(self.computed.numerical, self.computed.by_inputs, self.measurement)

    @property
    def verdict(self) -> str:
        """Whether E lies within u_val, or within that and the model's stated uncertainty."""
        if abs(self.error) <= self.uncertainty:
            return AGREES
        return MODEL if abs(self.error) <= self.uncertainty + self.computed.model else DISAGREES


def share(verdicts: Iterable[str], *wanted: str) -> float:
    """Share of some verdicts among all."""
    listed = list(verdicts)
    return sum(verdict in wanted for verdict in listed) / len(listed)
