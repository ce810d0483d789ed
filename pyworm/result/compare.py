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
        """Second over first by figure, with the uncertainties of both."""
        return {
            name: second / first for name, (first, second) in self.figures.items() if first.value
        }

    @property
    def differ(self) -> tuple[str, ...]:
        """Figures whose difference is more than both uncertainties."""
        return tuple(
            name for name, (first, second) in self.figures.items() if not first.agrees_with(second)
        )

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the comparison in words."""
        ratios = self.ratios
        rows = {}
        for name, (first, second) in self.figures.items():
            per_length = self.kind == "line" and name == "power_loss"
            quantity = QUANTITIES["power_loss_per_length" if per_length else name]
            ratio = ratios[name] if name in ratios else "-"
            rows[name] = (
                f"{in_words(first, quantity)} | {in_words(second, quantity)} | times {ratio}"
            )
        return f"{self.names[0]} | {self.names[1]}", rows


def compare(first: Solution, second: Solution) -> Comparison:
    """Compare the results of two solutions.

    Args:
        first, second: Two solutions, of point contacts or of line contacts.

    Raises:
        ValueError: Not two solutions, or of different kinds of contact: losses of lines are for each length.
    """
    for solution in (first, second):
        if not isinstance(solution, Solution):
            raise ValueError(
                f"compare takes two solutions, and was given a {type(solution).__name__}"
            )
    if first.kind != second.kind:
        raise ValueError(
            f"{first.name} is a {first.kind} contact, {second.name} a {second.kind} contact"
        )
    figures = {
        name: (estimate, getattr(second.figures, name))
        for name, estimate in first.figures
        if getattr(second.figures, name) is not None
    }
    return Comparison((first.name, second.name), figures, first.kind)
