"""Designs by solved contacts: their figures, and what estimates figures about them."""

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from math import log
from pathlib import Path

from pyworm.batch.adjoint_changes import MovedContact, changes_of
from pyworm.batch.case_figures import OF_CONTACTS, figures_of
from pyworm.batch.design_correction import neighbours, offsets, slopes
from pyworm.batch.design_model import (
    Correction,
    Design,
    Figure,
    Figures,
    Refused,
    case_of_design,
)
from pyworm.batch.design_search import Estimates
from pyworm.batch.drive_iteration import steady
from pyworm.batch.operating_points import (
    Computed,
    NotSolvedError,
    OperatingPoint,
    SolvedPoint,
    Solving,
    quantities_for,
)
from pyworm.batch.task import Task
from pyworm.case.design import DesignTask
from pyworm.io.input_error import CaseError
from pyworm.io.progress import Progress
from pyworm.ratings.heating import tooth_loss_of
from pyworm.scene.index import ContactIndex


@dataclass(frozen=True)
class KnownDesign:
    """A design with its figures, and what estimates figures about it."""

    design: Design
    """The design."""
    figures: Figures
    """Its figures."""
    estimates: Estimates
    """What estimates figures about it."""


@dataclass(frozen=True)
class DesignSolver:
    """How contacts of designs are solved; solved ones are kept and found again."""

    task: DesignTask
    """The design file."""
    formula: Estimates
    """Figures by closed forms."""
    directory: Path
    """Directory in which solved contacts are kept."""
    executor: Executor | None
    """Processes that solve; by default this one."""
    progress: Progress | None
    """What is called with the progress."""
    print_message: Callable[[str], None]
    """Reports designs without slopes."""

    def solved(self, design: Design, near: Estimates) -> KnownDesign:
        """A design by solved contacts at the accuracy of the search.

        Args:
            design: The design.
            near: What estimates its loss.

        Raises:
            NotSolvedError: A contact without a solution.
        """
        solved = self._contacts(design, near.loss(design), self.task.tables.accuracy)
        laid = self.formula.contacts(design)
        loss = None if laid.loss is None else tooth_loss_of(solved.point.case)
        correction = Correction(
            design.fractions if loss is None else (*design.fractions, log(loss)),
            offsets(laid, loss, solved.summaries),
            self._slopes(solved.point, design, loss),
        )
        estimates = self.formula.corrected(correction)
        figures = estimates.one(design)
        if isinstance(figures, Refused):
            raise NotSolvedError(f"{self.task.name}: {figures.reason}")
        found = figures_of(solved.point, solved.summaries, self.task.names)
        return KnownDesign(design, _with_errors(figures, found), estimates)

    def confirmed(self, known: KnownDesign) -> KnownDesign:
        """A design by contacts solved to the case's own accuracy; NotSolvedError without a solution."""
        loss = known.estimates.loss(known.design)
        solved = self._contacts(known.design, loss, self.task.case.accuracy)
        found = figures_of(solved.point, solved.summaries, self.task.names)
        return replace(known, figures=_scaled(known.figures, found))

    def _contacts(self, design: Design, loss: float | None, accuracy: float) -> SolvedPoint:
        """The solved contacts of a design, at the temperatures of their loss."""
        case = case_of_design(self.task, design)
        names = [name for name in self.task.names if name in OF_CONTACTS]
        point = OperatingPoint(case, case.places(), _quantities(names))
        if loss is not None:
            point = point.with_tooth_loss(float(f"{loss:.3g}"))
        effects = self.task.effects
        solving = Solving(self.directory, accuracy, effects, self.executor, self.progress)
        return solving.balanced([point])[0]

    def _slopes(
        self, point: OperatingPoint, design: Design, loss: float | None
    ) -> Mapping[ContactIndex, Mapping[str, tuple[float, ...]]]:
        """Slopes of the corrections of a design; a message of contacts without."""
        try:
            pairs = neighbours(self.task, design, loss)
        except CaseError as error:
            self.print_message(f"{self.task.name}: slopes by closed forms: {error}")
            return {}
        how = self.task.tables.accuracy, self.task.effects
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
        return slopes(self.task, self.formula.contacts(design), pairs, known)


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
