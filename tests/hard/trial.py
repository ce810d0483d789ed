"""One scene of the suite: a task whose solution is judged besides being found."""

from dataclasses import dataclass, replace
from functools import cached_property
from math import isfinite, prod
from pathlib import Path
from typing import Any

import numpy as np

from pyworm.batch.solve_tasks import solve_and_keep
from pyworm.batch.solved_scenes import Store
from pyworm.batch.task import Task
from pyworm.case.case import case_of
from pyworm.io.progress import Progress
from pyworm.planning.plan import Plan
from pyworm.result.result import Result
from pyworm.scene.index import ContactIndex
from pyworm.solver.solution import Solution
from pyworm.solver.transient.transient import Rates

ACCURACY = 0.05
"""Accuracy at which scenes are solved."""


class Trial(Task):
    """A task whose solution must make sense, converged or not."""

    def __reduce__(self) -> tuple:
        return Trial, super().__reduce__()[1]

    def solved(self, progress: Progress | None = None, rates: Rates | None = None) -> Result:
        """Solve the scene; AssertionError where its solution makes no sense."""
        result = super().solved(progress, rates)
        (solution,) = result.solutions
        for flaw in flaws(solution):
            raise AssertionError(flaw)
        return result


class BriefTrial(Trial):
    """The same on the first grid of the figures only, for a build that is thirty times as slow."""

    @cached_property
    def plan(self) -> Plan:
        """How it is solved."""
        return replace(super().plan, wider_grids=(), largest_grid=1)

    def __reduce__(self) -> tuple:
        return BriefTrial, super().__reduce__()[1]

    @property
    def identity(self) -> dict[str, Any]:
        """Everything that decides the solution."""
        return super().identity | {"brief": True}


def flaws(solution: Solution) -> list[str]:
    """What is wrong with a solution, beyond that it may not have converged."""
    found = [
        f"{name} is not finite everywhere"
        for name, field in solution.fields.items()
        if not np.isfinite(field.values).all()
    ]
    if (solution.fields["pressure"].values < 0).any():
        found.append("pressure is negative somewhere")
    if not solution.stop_reason:
        found.append("it stopped without a reason")
    if "asperity_pressure" in solution.fields:
        asperities = solution.fields["asperity_pressure"].values
        if (asperities < 0).any() or (asperities > solution.fields["pressure"].values).any():
            found.append("asperities bear less than nothing, or more than all")
    if solution.converged:
        figures = solution.figures
        if not figures.film_min.value > 0 or not solution.fields["film"].values.min() > 0:
            found.append("a converged film is not positive everywhere")
        for name in ("film_min", "film_central"):
            if not isfinite(getattr(figures, name).error):
                found.append(f"the error bar of a converged {name} is not finite")
    return found


def trial(
    tables: dict[str, Any],
    name: str,
    directory: Path,
    effects: str | tuple[str, ...],
    kind: type[Trial] = Trial,
) -> Trial:
    """The trial of a case file's content."""
    return kind(case_of(tables, name, directory), ContactIndex(), ACCURACY, effects)


@dataclass(frozen=True)
class Verdict:
    """What a scene of the suite came to."""

    name: str
    """The scene."""
    outcome: str
    """Outcome: "converged", "not converged" or "broken"."""
    reason: str
    """Why it did not converge, or what broke."""
    cost: float
    """Convolutions times the nodes of the finest grid, in millions."""
    grid: tuple[int, ...]
    """Nodes of the finest grid along x and y."""
    figures: dict[str, Any]
    """The summary of its solution; empty if there is none."""

    @property
    def line(self) -> str:
        """A row of the table."""
        films = (
            "{film_min_m:9.3g} {film_central_m:9.3g} m".format(**self.figures)
            if self.figures
            else " " * 21
        )
        size = " x ".join(str(count) for count in self.grid)
        why = "" if self.outcome == "converged" else f"  {self.outcome}: {self.reason}"
        return f"{self.name:28} {films} {size:>12} {self.cost:8.1f}{why}"


HEADING = f"{'scene':28} {'min':>9} {'central':>9} film {'grid':>11} {'cost':>8}"


def verdict(one: Trial, store: Store) -> Verdict:
    """Solve a scene, unless it was solved before, and judge what it came to."""
    name = one.case.name
    if store.missing([one]):
        broken = solve_and_keep(one, store)
        if broken is not None:
            return Verdict(name, "broken", broken, 0.0, (), {})
    summary = store.summary(one)
    grid = tuple(summary["grid"])
    return Verdict(
        name,
        "converged" if summary["accurate"] else "not converged",
        summary["stop_reason"],
        summary["convolutions"] * prod(grid) / 1e6,
        grid,
        summary,
    )
