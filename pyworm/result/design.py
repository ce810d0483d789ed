"""The best design of a gear set: variables, figures before and after, constraints, Pareto front."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pyworm.case.design import change_text, figure_text, is_temperature
from pyworm.case.fitted_values import fitted_file
from pyworm.io.atomic import whole_file
from pyworm.io.quantity_text import with_bars
from pyworm.io.shown import Shown


@dataclass(frozen=True)
class DesignVariable:
    """A value of a case that the design changes."""

    key: str
    """Dotted key."""
    start: str
    """Value of the case, as a case file has it."""
    best: str | float
    """Value of the best design, as a case file has it."""
    bounds: str
    """Bounds, or values to choose from, in words."""
    at_bound: bool = False
    """Whether it is at a bound."""


@dataclass(frozen=True)
class DesignFigure:
    """A figure that decides, of the case as it is and of the best design."""

    name: str
    """Name."""
    role: str
    """What it decides, in words: "minimised", ">= 0.3 µm"."""
    before: float
    """Of the case as it is [SI, or by the unit at the end of the name]."""
    best: float
    """Of the best design [SI, or by the unit at the end of the name]."""
    before_error: float = 0.0
    """Numerical uncertainty, a 95 % bound; 0 of closed forms."""
    best_error: float = 0.0
    """Numerical uncertainty of the best design, a 95 % bound."""
    margin: float | None = None
    """What is left to its limit over that, at the worst error of assembly; None without a limit."""
    worst: float | None = None
    """Of the best design at the worst error of assembly; None without errors."""

    @property
    def change(self) -> float:
        """Relative change [-], of temperatures the change [K]."""
        if is_temperature(self.name):
            return self.best - self.before
        return self.best / self.before - 1 if self.before else 0.0

    @property
    def change_text(self) -> str:
        """Its change in words."""
        return change_text(self.name, self.change)

    def text(self, value: float, error: float = 0.0) -> str:
        """A value in words with its unit and uncertainty."""
        words = figure_text(self.name, value)
        if not error or not value:
            return words
        if is_temperature(self.name):
            return with_bars(words, error, scale=1.0, unit=" K")
        return with_bars(words, error / abs(value))


@dataclass(frozen=True)
class FrontDesign:
    """A design of a Pareto front."""

    values: dict[str, str | float]
    """Dotted key -> value."""
    figures: dict[str, float]
    """Figures that decide [SI, or by the unit at the end of their name]."""


@dataclass(frozen=True, repr=False)
class BestDesign(Shown):
    """The best design of a gear set: what `pyworm.design` gives."""

    name: str
    """Name of the design file."""
    title: str
    """What is designed."""
    case_name: str
    """Name of the case."""
    variables: tuple[DesignVariable, ...]
    """Values of the case that are changed."""
    figures: tuple[DesignFigure, ...]
    """Figures that decide."""
    violated: tuple[str, ...]
    """Constraints that no design meets, each with the amount, a sentence; none of a design that meets all."""
    open: tuple[str, ...]
    """Constraints met or violated by less than the numerical uncertainty, a sentence each."""
    front: tuple[FrontDesign, ...]
    """Pareto front from the best design by the first objective to that by the second; none unless wanted."""
    estimates: int
    """Designs whose figures were computed by closed forms."""
    solved: int
    """Designs whose contacts were solved."""
    method: str
    """Where the figures are from, a sentence."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows in words."""
        return f"BestDesign of {self.case_name}", {
            **{variable.key: f"{variable.best}" for variable in self.variables},
            **{
                figure.name: f"{figure.text(figure.before)} -> {figure.text(figure.best)}"
                for figure in self.figures
            },
        }

    def __getitem__(self, name: str) -> DesignFigure:
        """A figure by name; KeyError without it."""
        for figure in self.figures:
            if figure.name == name:
                return figure
        raise KeyError(name)

    @property
    def feasible(self) -> bool:
        """Whether the best design meets all constraints."""
        return not self.violated

    @property
    def values(self) -> dict[str, str | float]:
        """Dotted key -> value of the best design, as a case file has it."""
        return {variable.key: variable.best for variable in self.variables}

    @property
    def statements(self) -> tuple[str, ...]:
        """What the search shows, a sentence each."""
        at_bound = [variable.key for variable in self.variables if variable.at_bound]
        bounds = f"At a bound: {', '.join(at_bound)}." if at_bound else ""
        changed = [
            f"{figure.name} {figure.change_text}"
            for figure in self.figures
            if "imised" in figure.role and _beyond_errors(figure)
        ]
        unsure = [
            f"{figure.name} changes by less than its numerical uncertainty."
            for figure in self.figures
            if "imised" in figure.role and not _beyond_errors(figure)
        ]
        gain = f"Against the case as it is: {', '.join(changed)}." if changed else ""
        return tuple(filter(None, (*self.violated, *self.open, gain, *unsure, bounds)))

    def summary(self) -> dict[str, Any]:
        """All of it as one object."""
        return {
            "design": self.name,
            "case": self.case_name,
            "variables": {variable.key: vars(variable) for variable in self.variables},
            "figures": {
                figure.name: {**vars(figure), "change": figure.change} for figure in self.figures
            },
            "feasible": self.feasible,
            "statements": list(self.statements),
            "front": [vars(each) for each in self.front],
            "designs_estimated": self.estimates,
            "designs_solved": self.solved,
            "method": self.method,
        }

    def save(self, path: str | Path) -> Path:
        """Write the values of the best design as a file that a case names, `fitted = "best.toml"`."""
        path = Path(path)
        source = f"best design of {self.name}, case {self.case_name}, by pyworm design"
        with whole_file(path) as partial:
            partial.write_text(fitted_file(source, self.values), encoding="utf-8")
        return path


def _beyond_errors(figure: DesignFigure) -> bool:
    """Whether the change of a figure exceeds the numerical uncertainties of both values."""
    return abs(figure.best - figure.before) > figure.before_error + figure.best_error
