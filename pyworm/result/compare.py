"""Two solutions side by side: figure by figure, with error bars and their ratio."""

from dataclasses import dataclass
from typing import Literal

from pyworm.io.quantities import QUANTITIES
from pyworm.io.shown import Shown
from pyworm.solver.estimate import Estimate, in_words
from pyworm.solver.solution import Solution


@dataclass(frozen=True, repr=False)
class Comparison(Shown):
    """Figures of two solutions."""

    names: tuple[str, str]
    """Names of both."""
    figures: dict[str, tuple[Estimate, Estimate]]
    """Name of a figure that both have -> the pair."""
    kind: Literal["point", "line"]
    """Kind of contact of both."""

    @property
    def ratios(self) -> dict[str, Estimate]:
        """Second over first by figure, with the error bars of both."""
        return {name: other / one for name, (one, other) in self.figures.items() if one.value}

    @property
    def differ(self) -> tuple[str, ...]:
        """Figures whose difference is more than both error bars."""
        return tuple(
            name for name, (one, other) in self.figures.items() if not one.agrees_with(other)
        )

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the comparison in words."""
        ratios = self.ratios
        rows = {}
        for name, (one, other) in self.figures.items():
            lost = self.kind == "line" and name == "power_loss"
            quantity = QUANTITIES["power_loss_per_length" if lost else name]
            ratio = ratios[name] if name in ratios else "-"
            rows[name] = f"{in_words(one, quantity)} | {in_words(other, quantity)} | times {ratio}"
        return f"{self.names[0]} | {self.names[1]}", rows


def compare(one: Solution, other: Solution) -> Comparison:
    """Set the figures of two solutions beside each other.

    Parameters
    ----------
    one, other : Solution
        Two solutions, of point contacts or of line contacts.

    Raises
    ------
    ValueError
        Not two solutions, or of different kinds of contact: losses of lines are for each length.
    """
    for of in (one, other):
        if not isinstance(of, Solution):
            raise ValueError(f"compare takes two solutions, and was given a {type(of).__name__}")
    if one.kind != other.kind:
        raise ValueError(f"{one.name} is a {one.kind} contact, {other.name} a {other.kind} contact")
    figures = {
        name: (own, getattr(other.figures, name))
        for name, own in vars(one.figures).items()
        if isinstance(own, Estimate) and getattr(other.figures, name) is not None
    }
    return Comparison((one.name, other.name), figures, one.kind)
