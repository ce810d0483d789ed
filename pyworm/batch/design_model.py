"""Figures of a design by closed forms, corrected by solved contacts.

Closed forms see all of the geometry and all of the load sharing; what they miss of films, friction and
temperatures is the ratio of solved figures over theirs, contact by contact. At a solved design the ratio and
its slope are right, so that the corrected figures have the value and the gradient of the simulation there
(first-order consistent approximation: Alexandrov, Lewis, Gumbert, Green and Newman, J. Aircraft 38 (2001)
1093-1101). Where the loss between the teeth warms the housing, closed forms at two losses give the powers of
the loss with which the figures of contacts change, and that loss is found which the contacts then have.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import exp, expm1, log
from typing import Any

import numpy as np
import scipy

from pyworm.batch.case_figures import (
    case_values,
    closed_form_summary,
    contact_figures,
    moved_summary,
)
from pyworm.batch.operating_points import Computed, OperatingPoint, follows_loss
from pyworm.case.case import Case, case_without_contacts
from pyworm.case.design import AssemblyError, DesignTask, is_temperature
from pyworm.case.dotted_keys import with_values
from pyworm.planning.closed_form_figures import closed_form_figures
from pyworm.ratings.heating import tooth_loss_of
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.index import ContactIndex

LOSS_RATIO = 1.2
"""Ratio of the two losses between the teeth at which contacts are laid out."""

MOST_LOSS_RATIO = 20.0
"""Largest ratio, either way, of the loss found over the one at which contacts are laid out."""


@dataclass(frozen=True)
class Design:
    """Values of the variables of a design file."""

    fractions: tuple[float, ...]
    """Continuous variables, each a fraction of the way between its bounds."""
    chosen: tuple[tuple[str, Any], ...] = ()
    """Key and value of each discrete one."""

    def moved(self, fractions: Sequence[float]) -> "Design":
        """The design with other continuous variables."""
        return replace(self, fractions=tuple(round(float(each), 12) for each in fractions))


@dataclass(frozen=True)
class Correction:
    """What solved contacts of a design have over their closed forms."""

    centre: tuple[float, ...]
    """The design, as `Design.fractions`; then, where the loss warms the teeth, the logarithm of that loss."""
    offsets: Mapping[ContactIndex, Mapping[str, float]]
    """Contact -> name of a figure -> ln of the solved one over that by closed forms; of temperatures their
    difference [K]."""
    slopes: Mapping[ContactIndex, Mapping[str, tuple[float, ...]]] = field(default_factory=dict)
    """Derivatives of the offsets with respect to the numbers of `centre`; 0 where there are none."""

    def moves(self, place: ContactIndex, numbers: Sequence[float]) -> dict[str, float]:
        """Offsets of a contact of a design, as of `offsets`; those of the nearest one, if it is unsolved.

        `numbers` are those of the design, as of `centre`.
        """
        near = place if place in self.offsets else next(iter(self.offsets))
        step = np.subtract(numbers, self.centre)
        slopes = self.slopes.get(near, {})
        return {
            name: offset + float(np.dot(slopes.get(name, np.zeros_like(step)), step))
            for name, offset in self.offsets[near].items()
        }


@dataclass(frozen=True)
class Figure:
    """A figure of a design, with its extremes over the errors of assembly."""

    value: float
    """Without error [SI, or by the unit at the end of its name]."""
    low: float
    """Smallest over all errors."""
    high: float
    """Largest over all errors."""
    error: float = 0.0
    """Numerical uncertainty of the value."""


Figures = dict[str, Figure]
"""Name -> figure."""


@dataclass(frozen=True)
class Refused:
    """A design that there cannot be."""

    reason: str
    """Why, a sentence."""


def case_of_design(task: DesignTask, design: Design, error: AssemblyError | None = None) -> Case:
    """The case of a design under an error of its assembly; CaseError of one that there cannot be."""
    values = task.values(design.fractions, dict(design.chosen))
    content = with_values(task.case.content, values)
    case = case_without_contacts(content, task.case.name, task.case.directory)
    return case if error is None else error.applied(case)


@dataclass(frozen=True)
class Incomplete(Refused):
    """A design without figures that decide, such as a loss where too few contacts carry load."""

    missing: tuple[str, ...] = ()
    """Names of the figures."""


@dataclass(frozen=True)
class LaidOut:
    """Contacts of a design under an error of its assembly, by closed forms."""

    point: OperatingPoint
    """Case and places of the contacts."""
    scenes: tuple[AnyContact, ...]
    """The contacts."""
    summaries: tuple[dict[str, Any], ...]
    """Their scalars by closed forms, as of `Solution.summary`."""
    figures: tuple[dict[str, float], ...]
    """Their figures by closed forms."""
    values: dict[str, float]
    """Figures that no contact decides."""
    loss: float | None = None
    """Loss between the teeth to which the temperatures belong [W]; None where none warms them."""
    by_loss: tuple[dict[str, float], ...] = ()
    """Changes of the logarithms of figures, of temperatures [K], with the logarithm of that loss."""

    def moves(self, number: int, loss: float | None) -> dict[str, float]:
        """Changes of the figures of a contact at another loss [W], as of `by_loss`."""
        if self.loss is None or loss is None:
            return {}
        ratio = log(loss / self.loss)
        return {name: slope * ratio for name, slope in self.by_loss[number].items()}


def laid_out(task: DesignTask, design: Design) -> tuple[LaidOut, ...] | Refused:
    """The contacts of a design without error of its assembly, and under each of the errors."""
    try:
        return tuple(_laid_out(task, design, error) for error in (None, *task.errors))
    except (ValueError, ArithmeticError) as error:
        return Refused(str(error))


def _laid_out(task: DesignTask, design: Design, error: AssemblyError | None) -> LaidOut:
    case = case_of_design(task, design, error)
    point = OperatingPoint(case, case.places())
    scenes = tuple(case.scene(**place.given) for place in point.places)
    summaries = tuple(map(closed_form_summary, scenes))
    found = contact_figures(point, summaries)  # the drive keeps what it needs for them
    figures = tuple(map(closed_form_figures, scenes))
    laid = LaidOut(point, scenes, summaries, figures, case_values(case, task.names))
    return _with_heat(laid) if follows_loss(case) and "power_loss" in found else laid


def _with_heat(laid: LaidOut) -> LaidOut:
    """The contacts with what another loss between the teeth changes in them."""
    loss = tooth_loss_of(laid.point.case)
    warmer = laid.point.with_tooth_loss(LOSS_RATIO * loss)
    by_loss = tuple(
        {
            name: (
                value - before[name]
                if is_temperature(name)
                else log(value / before[name])
                if before[name] > 0
                else 0.0
            )
            / log(LOSS_RATIO)
            for name, value in closed_form_figures(warmer.case.scene(**place.given)).items()
        }
        for place, before in zip(laid.point.places, laid.figures, strict=True)
    )
    return replace(laid, loss=loss, by_loss=by_loss)


def estimated(
    task: DesignTask, design: Design, laid: Sequence[LaidOut], correction: Correction | None
) -> Figures | Refused:
    """Figures of a design by closed forms, corrected where that is known, with extremes over all errors."""
    try:
        found = [_figures(task, design, each, correction) for each in laid]
    except ValueError as error:
        return Refused(str(error))
    return {
        name: Figure(
            figure.value,
            min(each[name].value for each in found if name in each),
            max(each[name].value for each in found if name in each),
        )
        for name, figure in found[0].items()
    }


def _figures(
    task: DesignTask, design: Design, laid: LaidOut, correction: Correction | None
) -> dict[str, Computed]:
    found = _contact_figures(design, laid, correction, balanced_loss(design, laid, correction))
    found = {name: Computed(value, 0.0) for name, value in laid.values.items()} | found
    return {name: found[name] for name in task.names if name in found}


def balanced_loss(design: Design, laid: LaidOut, correction: Correction | None) -> float | None:
    """The loss that the contacts have at the temperatures to which it leads [W]; None where none warms them.

    ValueError where there is none within `MOST_LOSS_RATIO`.
    """
    if laid.loss is None:
        return None
    first = laid.loss

    def excess(ratio: float) -> float:
        loss = first * exp(ratio)
        return log(_contact_figures(design, laid, correction, loss)["power_loss"].value / loss)

    most = log(MOST_LOSS_RATIO)
    if excess(-most) < 0 or excess(most) > 0:
        raise ValueError(f"no heat balance within {MOST_LOSS_RATIO:g} times {first:.4g} W")
    return float(first * exp(scipy.optimize.brentq(excess, -most, most, xtol=1e-9)))


def _contact_figures(
    design: Design, laid: LaidOut, correction: Correction | None, loss: float | None
) -> dict[str, Computed]:
    """Figures that contacts decide, at the temperatures of some loss between the teeth [W]."""
    if correction is None and loss is None:
        return contact_figures(laid.point, laid.summaries)
    numbers = design.fractions if loss is None else (*design.fractions, log(loss))
    summaries = []
    for number, (place, scene, summary, figures) in enumerate(
        zip(laid.point.places, laid.scenes, laid.summaries, laid.figures, strict=True)
    ):
        moves = laid.moves(number, loss)
        if correction is not None:
            for name, move in correction.moves(place, numbers).items():
                moves[name] = moves.get(name, 0.0) + move
        changes = {
            name: move if is_temperature(name) else figures[name] * expm1(move)
            for name, move in moves.items()
        }
        summaries.append(moved_summary(summary, scene, changes, figures))
    return contact_figures(laid.point, summaries)
