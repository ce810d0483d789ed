"""Find the best design of a gear set, as `pyworm design` does.

First steps go by closed forms, from the case as it is and from designs drawn between the bounds. Then the
contacts of the best design are solved at a moderate accuracy, the closed forms are corrected to meet them,
and the search is repeated about it within a reach that shrinks where the corrected figures mislead. The best
design and the case as it is are solved again at the case's own accuracy. Solved contacts are kept and found
again.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from pyworm.batch.adjoint_changes import MovedContact, changes_of
from pyworm.batch.case_figures import OF_CONTACTS, figures_of
from pyworm.batch.design_correction import neighbours, offsets, slopes
from pyworm.batch.design_model import (
    Correction,
    Design,
    Figure,
    Figures,
    Incomplete,
    Refused,
    case_of_design,
)
from pyworm.batch.design_report import decisive, variables, verdicts
from pyworm.batch.design_search import Estimates, Goal, best_of
from pyworm.batch.drive_iteration import steady
from pyworm.batch.in_python import executor as executor_for
from pyworm.batch.in_python import messages, progress_of
from pyworm.batch.operating_points import (
    Computed,
    NotSolvedError,
    OperatingPoint,
    Solving,
    quantities_for,
)
from pyworm.batch.task import Task
from pyworm.case.design import DesignTask, figure_text, load_design
from pyworm.case.dotted_keys import value_at
from pyworm.io.input_error import CaseError
from pyworm.io.progress import Progress
from pyworm.io.quantity_text import percent
from pyworm.result.design import BestDesign, FrontDesign
from pyworm.scene.index import ContactIndex

SMALLEST_REACH = 0.01
"""Reach of a search below which it ends, a fraction of the way between the bounds."""

SMALL_GAIN = 0.1
"""Expected gain below which a search on solved figures ends, over their accuracy."""

FIRST_REACH = 0.5
"""Reach of the second search on solved figures; the first one is not limited."""

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


@dataclass(frozen=True)
class _Known:
    """A design with its figures, and what estimates figures about it."""

    design: Design
    figures: Figures
    estimates: Estimates


@dataclass
class _Search:
    """Search for the best design of a design file."""

    task: DesignTask
    directory: Path
    executor: Executor | None
    progress: Progress | None
    print_message: Callable[[str], None]
    simulated: dict[Design, _Known] = field(default_factory=dict)
    """Designs whose contacts are solved."""

    def __post_init__(self) -> None:
        self.formula = Estimates(self.task, None, self.executor)

    @property
    def simulates(self) -> bool:
        return self.task.tables.figures == "simulation"

    def found(self) -> BestDesign:
        """The best design, and the front if one is wanted."""
        start = self._start()
        first = self.formula.one(start)
        if isinstance(first, Refused):
            raise self._error(first)
        before = self._solved(start) if self.simulates else _Known(start, first, self.formula)
        scales = {
            name: abs(figure.value) if figure.value else 1.0
            for name, figure in before.figures.items()
        }
        tables = self.task.tables
        goal = Goal(tables.objective.weights, self.task.limits, scales)
        best = self._best(goal, before)
        front: tuple[_Known, ...] = ()
        if tables.front is not None:
            front = self._front(goal, replace(goal, weights=tables.front.weights), before, best)
        return self._report(goal, before, best, front)

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

    def _best(self, goal: Goal, before: _Known) -> _Known:
        """The best design for a goal, over all choices of discrete values."""
        starts = [replace(before.design, chosen=chosen) for chosen in self._choices()]
        by_formula = [best_of(self.formula, goal, start) for start in starts]
        by_formula.sort(key=lambda design: goal.merit(self.formula.one(design)))
        if not self.simulates:
            best = by_formula[0]
            figures = self.formula.one(best)
            return before if isinstance(figures, Refused) else _Known(best, figures, self.formula)
        least = goal.merit(self.formula.one(by_formula[0]))
        near = [
            design
            for design in by_formula
            if goal.merit(self.formula.one(design)) < least + CHOSEN_WITHIN
        ]
        found = [before, *(self._descended(goal, each, before) for each in near[:MOST_CHOICES])]
        return min(found, key=lambda known: goal.merit(known.figures))

    def _choices(self) -> Iterator[tuple[tuple[str, Any], ...]]:
        choices = self.task.tables.choices
        for values in product(*choices.values()):
            yield tuple(zip(choices, values, strict=True))

    def _descended(self, goal: Goal, start: Design, before: _Known) -> _Known:
        """The best design by solved contacts, from one that closed forms find."""
        trial = start
        reach, current, wanted = FIRST_REACH, before, self.task.tables.solves
        known = len(self.simulated)
        least_gain = SMALL_GAIN * self.task.tables.accuracy
        while len(self.simulated) - known < wanted:
            try:
                new = self._solved(trial)
            except NotSolvedError as error:
                self.print_message(f"{self.task.name}: a design is passed over: {error}")
                reach /= 4
            else:
                gain = goal.merit(current.figures) - goal.merit(new.figures)
                if gain > 0 or current.design.chosen != new.design.chosen:
                    current = new
                    reach = min(reach, FIRST_REACH)
                else:
                    reach = self._distance(current.design, new.design) / 2
            if reach < SMALLEST_REACH:
                break
            trial = best_of(current.estimates, goal, current.design, reach)
            expected = goal.merit(current.figures) - goal.merit(current.estimates.one(trial))
            if trial in self.simulated or expected < least_gain:
                break
        return current

    @staticmethod
    def _distance(first: Design, second: Design) -> float:
        return float(np.max(np.abs(np.subtract(first.fractions, second.fractions))))

    def _solved(self, design: Design) -> _Known:
        """A design by solved contacts at the accuracy of the search; NotSolvedError without a solution."""
        if design in self.simulated:
            return self.simulated[design]
        tables = self.task.tables
        effects = self.task.effects
        found, summaries, point = self._figures(design, tables.accuracy, effects)
        correction = Correction(
            design.fractions,
            offsets(point, summaries),
            self._slopes(point, design, (tables.accuracy, effects)),
        )
        estimates = self.formula.corrected(correction)
        figures = estimates.one(design)
        if isinstance(figures, Refused):
            raise NotSolvedError(f"{self.task.name}: {figures.reason}")
        known = _Known(design, _with_errors(figures, found), estimates)
        self.simulated[design] = known
        self.print_message(
            f"{self.task.name}: design {len(self.simulated)}: {_in_words(known.figures)}"
        )
        return known

    def _figures(
        self, design: Design, accuracy: float, effects: Sequence[str]
    ) -> tuple[dict[str, Computed], list[Mapping[str, Any]], OperatingPoint]:
        """Figures of a design by solved contacts, with the scalars of each."""
        case = case_of_design(self.task, design, {})
        names = [name for name in self.task.names if name in OF_CONTACTS]
        point = OperatingPoint(case, case.places(), _quantities(names))
        solving = Solving(self.directory, accuracy, effects, self.executor, self.progress)
        tasks = solving.tasks(point)
        known = solving.solved(tasks)
        summaries: list[Mapping[str, Any]] = [known[each.key] for each in tasks]
        return figures_of(point, summaries, self.task.names), summaries, point

    def _slopes(
        self, point: OperatingPoint, design: Design, how: tuple[float, Sequence[str]]
    ) -> Mapping[ContactIndex, Mapping[str, tuple[float, ...]]]:
        """Slopes of the corrections of a design; a message of contacts without."""
        try:
            pairs = neighbours(self.task, design)
        except CaseError as error:
            self.print_message(f"{self.task.name}: slopes by closed forms: {error}")
            return {}
        moved = [
            MovedContact(
                replace(
                    steady(Task(point.case, place, *how, point.quantities)), wider_window=False
                ),
                pairs,
            )
            for place in point.places
        ]
        known = dict(
            zip(point.places, changes_of(moved, self.directory, self.executor), strict=True)
        )
        for reason in dict.fromkeys(each["reason"] for each in known.values() if "reason" in each):
            self.print_message(f"{self.task.name}: slopes by closed forms: {reason}")
        return slopes(self.task, pairs, known)

    def _front(self, first: Goal, second: Goal, before: _Known, best: _Known) -> tuple[_Known, ...]:
        """Designs between the best by one goal and by another: the first under ceilings of the second."""
        other = self._best(second, before)
        ends = second.cost(best.figures), second.cost(other.figures)
        tables = self.task.tables
        count = 0 if tables.front is None else tables.front.designs
        found = [best]
        for level in np.linspace(*ends, count)[1:-1]:
            goal = first.with_ceiling(second, float(level))
            near = min((*found, other), key=lambda known: goal.merit(known.figures))
            trial = best_of(near.estimates, goal, near.design)
            found.append(self._known(trial, near))
        return (*found, other)

    def _known(self, design: Design, near: _Known) -> _Known:
        """A design of the front, by solved contacts where these are wanted."""
        if self.simulates:
            try:
                return self._solved(design)
            except NotSolvedError as error:
                self.print_message(f"{self.task.name}: a design is passed over: {error}")
                return near
        figures = near.estimates.one(design)
        return near if isinstance(figures, Refused) else _Known(design, figures, near.estimates)

    def _report(
        self, goal: Goal, before: _Known, best: _Known, front: Sequence[_Known]
    ) -> BestDesign:
        method = BY_FORMULA
        if self.simulates:
            case = self.task.case
            effects = self.task.effects
            before, best = (
                replace(
                    known,
                    figures=_scaled(
                        known.figures, self._figures(known.design, case.accuracy, effects)[0]
                    ),
                )
                for known in (before, best)
            )
            method = (
                f"{len(self.simulated)} designs solved to {percent(self.task.tables.accuracy)}, the case as "
                f"it is and the best again to {percent(case.accuracy)}; uncertainties are numerical."
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
            solved=len(self.simulated),
            method=method,
        )


def figures_of_case(task: DesignTask) -> list[str]:
    """Names of the figures that a case has by closed forms."""
    from pyworm.batch.key_sensitivities import by_closed_forms

    here = by_closed_forms(task.case)
    return sorted(figures_of(here.point, here.summaries))


def _quantities(names: Sequence[str]) -> tuple[str, ...]:
    """What has to be accurate for some figures of contacts, as of `pyworm.plan`."""
    films = {"specific_film": "film_min", "pressure_max": "film_min"}
    return quantities_for([films.get(name, name) for name in names] if names else ["film_min"])


def _with_errors(figures: Figures, found: Mapping[str, Computed]) -> Figures:
    """Figures with the numerical uncertainties of solved ones."""
    return {
        name: replace(figure, error=found[name].error) if name in found else figure
        for name, figure in figures.items()
    }


def _scaled(figures: Figures, found: Mapping[str, Computed]) -> Figures:
    """More accurate figures, whose extremes over errors of assembly change in proportion."""
    scaled = {}
    for name, figure in figures.items():
        now = found[name]
        ratio = now.value / figure.value if figure.value else 1.0
        scaled[name] = Figure(now.value, figure.low * ratio, figure.high * ratio, now.error)
    return scaled


def _in_words(figures: Figures) -> str:
    return ", ".join(f"{name} {figure_text(name, each.value)}" for name, each in figures.items())
