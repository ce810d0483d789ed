"""Figures of a design by closed forms, corrected by solved contacts.

Closed forms see all of the geometry and all of the load sharing; what they miss of films, friction and
temperatures is the ratio of solved figures over theirs, contact by contact. At a solved design the ratio and
its slope are right, so that the corrected figures have the value and the gradient of the simulation there
(first-order consistent approximation: Alexandrov, Lewis, Gumbert, Green and Newman, J. Aircraft 38 (2001)
1093-1101).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from pyworm.batch.case_figures import (
    case_values,
    closed_form_summary,
    contact_figures,
    moved_summary,
)
from pyworm.batch.operating_points import Computed, OperatingPoint
from pyworm.case.case import Case, case_without_contacts
from pyworm.case.design import DesignTask
from pyworm.case.dotted_keys import with_values
from pyworm.planning.closed_form_figures import closed_form_figures
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.index import ContactIndex


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
    """The design, as `Design.fractions`."""
    offsets: Mapping[ContactIndex, Mapping[str, float]]
    """Contact -> name of a figure -> ln of the solved one over that by closed forms; of temperatures their
    difference [K]."""
    slopes: Mapping[ContactIndex, Mapping[str, tuple[float, ...]]] = field(default_factory=dict)
    """Derivatives of the offsets with respect to the fractions; 0 where there are none."""

    def changes(
        self, place: ContactIndex, fractions: Sequence[float], figures: Mapping[str, float]
    ) -> dict[str, float]:
        """Changes of the closed-form figures of a contact of a design; of the nearest one, if unsolved."""
        near = place if place in self.offsets else next(iter(self.offsets))
        step = np.subtract(fractions, self.centre)
        found = {}
        for name, offset in self.offsets[near].items():
            slope = self.slopes.get(near, {}).get(name, np.zeros_like(step))
            moved = offset + float(np.dot(slope, step))
            by_degrees = name.startswith("temperature")
            found[name] = moved if by_degrees else figures[name] * np.expm1(moved)
        return found


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


def case_of_design(task: DesignTask, design: Design, error: Mapping[str, Any]) -> Case:
    """The case of a design under an error of its assembly; CaseError of one that there cannot be."""
    values = task.values(design.fractions, dict(design.chosen)) | dict(error)
    content = with_values(task.case.content, values)
    return case_without_contacts(content, task.case.name, task.case.directory)


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


def laid_out(task: DesignTask, design: Design) -> tuple[LaidOut, ...] | Refused:
    """The contacts of a design without error of its assembly, and under each of the errors."""
    try:
        return tuple(_laid_out(task, design, error) for error in ({}, *task.errors))
    except (ValueError, ArithmeticError) as error:
        return Refused(str(error))


def _laid_out(task: DesignTask, design: Design, error: Mapping[str, Any]) -> LaidOut:
    case = case_of_design(task, design, error)
    point = OperatingPoint(case, case.places())
    scenes = tuple(case.scene(**place.given) for place in point.places)
    summaries = tuple(map(closed_form_summary, scenes))
    contact_figures(point, summaries)  # the drive keeps what it needs for them
    figures = tuple(map(closed_form_figures, scenes))
    return LaidOut(point, scenes, summaries, figures, case_values(case, task.names))


def estimated(
    task: DesignTask, design: Design, laid: Sequence[LaidOut], correction: Correction | None
) -> Figures:
    """Figures of a design by closed forms, corrected where that is known, with extremes over all errors."""
    found = [_figures(task, design, each, correction) for each in laid]
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
    summaries: Sequence[Mapping[str, Any]] = laid.summaries
    if correction is not None:
        summaries = [
            moved_summary(
                summary, scene, correction.changes(place, design.fractions, figures), figures
            )
            for place, scene, summary, figures in zip(
                laid.point.places, laid.scenes, laid.summaries, laid.figures, strict=True
            )
        ]
    found = contact_figures(laid.point, summaries)
    found = {name: Computed(value, 0.0) for name, value in laid.values.items()} | found
    return {name: found[name] for name in task.names if name in found}
