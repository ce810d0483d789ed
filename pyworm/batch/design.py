"""Find the best design of a gear set, as `pyworm design` does.

First steps go by closed forms, from the case as it is and from designs drawn between the bounds. Then the
contacts of the best design are solved at a moderate accuracy, the closed forms are corrected to meet them,
and the search is repeated about it within a reach that shrinks where the corrected figures mislead. The best
design and the case as it is are solved again at the case's own accuracy. Solved contacts are kept and found
again.
"""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from pyworm.batch.case_figures import figures_of
from pyworm.batch.design_model import Design, Incomplete, Refused
from pyworm.batch.design_report import decisive, variables, verdicts
from pyworm.batch.design_search import Estimates, Goal, best_of
from pyworm.batch.in_python import executor as executor_for
from pyworm.batch.in_python import messages, progress_of
from pyworm.batch.operating_points import NotSolvedError
from pyworm.batch.solved_designs import DesignSolver, KnownDesign
from pyworm.case.design import DesignTask, figure_text, load_design
from pyworm.case.dotted_keys import value_at
from pyworm.io.input_error import CaseError
from pyworm.io.present import present
from pyworm.io.progress import Progress
from pyworm.io.quantity_text import percent
from pyworm.result.design import BestDesign, FrontDesign

SMALLEST_REACH = 0.01
"""Reach of a search below which it ends, a fraction of the way between the bounds."""

SMALL_GAIN = 0.1
"""Expected gain below which a search on solved figures ends, over their accuracy."""

FIRST_REACH = 0.5
"""Reach of the first search about solved figures; that by closed forms is not limited."""

CHOSEN_WITHIN = 0.05
"""Difference of the merits by closed forms within which choices of discrete values are solved."""

MOST_CHOICES = 3
"""Maximum number of them that are solved."""

BY_FORMULA = "All results by closed forms; no contact was solved."


def design(
    path: str | Path,
    *,
    out: str | Path | None = None,
    processes: int = 1,
    scheduler: str | None = None,
    progress: bool | Progress = True,
) -> BestDesign:
    """Find the best design of a gear set, as `pyworm design` does.

    Args:
        path: A design file: case, variables with bounds, objective, constraints.
        out: Directory in which solved contacts are kept and found again; by default none are.
        processes: Processes that solve; more than one need a script with `if __name__ == "__main__":`.
        scheduler: Address of a dask.distributed scheduler whose workers solve instead.
        progress: Whether a bar shows the progress, or what is called instead.

    Raises:
        CaseError: Invalid input, or figures that the case does not compute.
        NotSolvedError: A contact of the case as it is, or of the best design, without a solution.
    """
    with ExitStack() as stack:
        where = stack.enter_context(TemporaryDirectory()) if out is None else out
        pool = stack.enter_context(executor_for(processes, scheduler))
        told = stack.enter_context(progress_of(progress))
        return best_design(load_design(path), Path(where), pool, told, messages(progress))


def best_design(
    task: DesignTask,
    directory: Path,
    executor: Executor | None = None,
    progress: Progress | None = None,
    print_message: Callable[[str], None] = lambda message: None,
) -> BestDesign:
    """The best design of a checked design file; arguments and errors as of `design`."""
    search = _Search(task, directory, executor, progress, print_message)
    return search.found()


@dataclass
class _Search:
    """Search for the best design of a design file."""

    task: DesignTask
    directory: Path
    executor: Executor | None
    progress: Progress | None
    print_message: Callable[[str], None]
    known: dict[Design, KnownDesign] = field(default_factory=dict)
    """Designs of which one is the best: those whose contacts are solved or, without a solve, best ones."""

    def __post_init__(self) -> None:
        self.formula = Estimates(self.task, None, self.executor)
        how = self.directory, self.executor, self.progress, self.print_message
        self.solver = DesignSolver(self.task, self.formula, *how)

    @property
    def simulates(self) -> bool:
        return self.task.tables.figures == "simulation"

    def found(self) -> BestDesign:
        """The best design, and the front if one is wanted."""
        start = self._start()
        first = self.formula.one(start)
        if isinstance(first, Refused):
            raise self._error(first)
        if self.simulates:
            before = self._solved(start, self.formula)
        else:
            before = self.known[start] = KnownDesign(start, first, self.formula)
        scales = {
            name: abs(figure.value) if figure.value else 1.0
            for name, figure in before.figures.items()
        }
        tables = self.task.tables
        goal = Goal(tables.objective.weights, self.task.limits, scales)
        self._search(goal, before)
        front: tuple[KnownDesign, ...] = ()
        if tables.front is not None:
            front = self._front(goal, replace(goal, weights=tables.front.weights), before)
        return self._report(goal, before, front)

    def _start(self) -> Design:
        """The case as it is, within the bounds; first values of discrete variables that it has not."""
        chosen = []
        for key, values in self.task.tables.choices.items():
            now = value_at(self.task.case.content, key)
            chosen.append((key, now if now in values else values[0]))
        return Design(tuple(each.start for each in self.task.variables), tuple(chosen))

    def _error(self, refused: Refused) -> CaseError:
        """The error of a case that cannot be, or lacks a figure that decides."""
        if not isinstance(refused, Incomplete):
            return CaseError(f"{self.task.name}: the case as it is: {refused.reason}")
        return CaseError(
            f"{self.task.name}: {self.task.case.name} has no figure {refused.missing[0]}; it has "
            f"{', '.join(figures_of_case(self.task))}"
        )

    def _best(self, goal: Goal) -> KnownDesign:
        """The best known design for a goal."""
        return self._ranked(goal)[0]

    def _ranked(self, goal: Goal) -> list[KnownDesign]:
        return sorted(self.known.values(), key=lambda known: goal.merit(known.figures))

    def _search(self, goal: Goal, before: KnownDesign) -> None:
        """Find the best design for a goal, over all choices of discrete values."""
        starts = [replace(before.design, chosen=chosen) for chosen in self._choices()]
        by_formula = [best_of(self.formula, goal, start) for start in starts]
        by_formula.sort(key=lambda design: goal.merit(self.formula.one(design)))
        if not self.simulates:
            self._estimated(by_formula[0], self.formula)
            return
        least = goal.merit(self.formula.one(by_formula[0]))
        near = [
            design
            for design in by_formula
            if goal.merit(self.formula.one(design)) < least + CHOSEN_WITHIN
        ][:MOST_CHOICES]
        most = len(self.known) + self.task.tables.solves
        for design in near:
            if len(self.known) < most:
                self._tried(design, self.formula)
        chosen = {design.chosen for design in near}
        best = [known.design.chosen for known in self._ranked(goal)]
        for choice in dict.fromkeys(each for each in best if each in chosen):
            self._descend(goal, choice, most)

    def _choices(self) -> Iterator[tuple[tuple[str, Any], ...]]:
        choices = self.task.tables.choices
        for values in product(*choices.values()):
            yield tuple(zip(choices, values, strict=True))

    def _descend(self, goal: Goal, choice: tuple[tuple[str, Any], ...], most: int) -> None:
        """Solve better and better designs with some discrete values until this many are known."""
        current = next(each for each in self._ranked(goal) if each.design.chosen == choice)
        reach, least_gain = FIRST_REACH, SMALL_GAIN * self.task.tables.accuracy
        while len(self.known) < most and reach >= SMALLEST_REACH:
            trial = best_of(current.estimates, goal, current.design, reach)
            expected = goal.merit(current.figures) - goal.merit(current.estimates.one(trial))
            if trial in self.known or expected < least_gain:
                break
            new = self._tried(trial, current.estimates)
            if new is None:
                reach /= 4
            elif goal.merit(new.figures) < goal.merit(current.figures):
                current = new
            else:
                reach = _distance(current.design, new.design) / 2

    def _tried(self, design: Design, estimates: Estimates) -> KnownDesign | None:
        """A design by solved contacts; None, with a message, of one without a solution."""
        try:
            return self._solved(design, estimates)
        except NotSolvedError as error:
            self._pass_over(error)
            return None

    def _solved(self, design: Design, near: Estimates) -> KnownDesign:
        """A design by solved contacts, once; errors as of `DesignSolver.solved`."""
        if design not in self.known:
            known = self.known[design] = self.solver.solved(design, near)
            words = ", ".join(
                f"{name} {figure_text(name, each.value)}" for name, each in known.figures.items()
            )
            self.print_message(f"{self.task.name}: design {len(self.known)}: {words}")
        return self.known[design]

    def _pass_over(self, error: NotSolvedError) -> None:
        self.print_message(f"{self.task.name}: a design is passed over: {error}")

    def _estimated(self, design: Design, estimates: Estimates) -> None:
        """Keep a design without a solve, if there can be one."""
        figures = estimates.one(design)
        if not isinstance(figures, Refused):
            self.known.setdefault(design, KnownDesign(design, figures, estimates))

    def _front(self, first: Goal, second: Goal, before: KnownDesign) -> tuple[KnownDesign, ...]:
        """Designs between the best by one goal and by another: the first under ceilings of the second."""
        self._search(second, before)
        start, end = (second.cost(self._best(goal).figures) for goal in (first, second))
        count = present(self.task.tables.front, "front").designs
        levels = [
            first.with_ceiling(second, float(level))
            for level in np.linspace(start, end, count)[1:-1]
        ]
        for goal in levels:
            near = self._best(goal)
            trial = best_of(near.estimates, goal, near.design)
            (self._tried if self.simulates else self._estimated)(trial, near.estimates)
        return tuple(self._best(goal) for goal in (first, *levels, second))

    def _report(self, goal: Goal, before: KnownDesign, front: Sequence[KnownDesign]) -> BestDesign:
        best, method = self._best(goal), BY_FORMULA
        if self.simulates:
            accuracy = self.task.case.accuracy
            before = self.solver.confirmed(before)
            best = self._confirmed_best(goal, before)
            method = (
                f"{len(self.known)} designs solved to {percent(self.task.tables.accuracy)}, the case as "
                f"it is and the best again to {percent(accuracy)}; uncertainties are numerical."
            )
        violated, unsure = verdicts(goal, best.figures)
        return BestDesign(
            name=self.task.name,
            title=self.task.tables.title,
            case_name=self.task.case.name,
            variables=tuple(variables(self.task, best.design)),
            figures=tuple(decisive(goal, self.task, before.figures, best.figures)),
            violated=violated,
            open=unsure,
            front=tuple(
                FrontDesign(
                    {each.key: each.best for each in variables(self.task, known.design)},
                    {name: known.figures[name].value for name in self.task.names},
                )
                for known in front
            ),
            estimates=len(self.formula.laid),
            solved=len(self.known) if self.simulates else 0,
            method=method,
        )

    def _confirmed_best(self, goal: Goal, before: KnownDesign) -> KnownDesign:
        """The best design with a solution at the case's own accuracy; the case as it is if that is better."""
        for known in self._ranked(goal):
            if known.design == before.design:
                return before
            try:
                best = self.solver.confirmed(known)
            except NotSolvedError as error:
                self._pass_over(error)
                continue
            return min(before, best, key=lambda each: goal.merit(each.figures))
        return before


def _distance(first: Design, second: Design) -> float:
    return float(np.max(np.abs(np.subtract(first.fractions, second.fractions))))


def figures_of_case(task: DesignTask) -> list[str]:
    """Names of the figures that a case has by closed forms."""
    from pyworm.batch.key_sensitivities import by_closed_forms

    here = by_closed_forms(task.case)
    return sorted(figures_of(here.point, here.summaries))
