"""Derivatives of the results of a case with respect to the numbers of its file.

The numbers reach the gap, the velocities and the load of a contact by closed forms (geometry, kinematics,
load sharing), whose differences are cheap: a case is made with each number a step above and below, its
contacts are laid out, and what they change in the figures of the solved contact is contracted with its
adjoint solution. Extremes and losses over the mesh cycle, efficiencies and safeties follow by the formulas of
the run itself, as a central difference.

The loss that warms the teeth and the friction in their balance of torques, which a run finds by iteration,
follow the inputs: their changes are those of the implicit function theorem. Lifts of films are held.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pyworm.batch.case_figures import FigureChanges, closed_form_summary, figures_of, moved_summary
from pyworm.batch.operating_points import OperatingPoint
from pyworm.case.case import Case, case_without_contacts
from pyworm.case.dotted_keys import with_values
from pyworm.case.numeric_keys import NumericKey, found_keys, numeric_keys
from pyworm.io.input_error import CaseError
from pyworm.io.progress import Progress
from pyworm.planning.closed_form_figures import ClosedFormChanges
from pyworm.ratings.standard_loss import StandardLoss, standard_loss
from pyworm.result.key_sensitivities import KeySensitivities, KeySensitivity
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.index import ContactIndex

BY_CLOSED_FORMS = (
    "Figures of contacts by closed forms of smooth films; geometry, load sharing and ratings by "
    "differences."
)
BY_ADJOINT = (
    "Figures of contacts by adjoint solutions; geometry, load sharing and ratings by differences."
)

FOUND = "operation.friction", "cooling.tooth_loss"
"""Keys of what a run finds by iteration, and whose changes follow the inputs."""


@dataclass(frozen=True)
class Side:
    """A case with one number moved, and its contacts."""

    value: float
    """The number [SI]."""
    point: OperatingPoint
    """Case and places of contacts."""
    scenes: tuple[AnyContact, ...]
    """The contacts."""


@dataclass(frozen=True)
class Solved:
    """Contacts of a case, with their scalars and how these change."""

    point: OperatingPoint
    """Case and places of contacts."""
    summaries: tuple[Mapping[str, Any], ...]
    """Scalars of each contact, as of `Solution.summary`."""
    changes: tuple[FigureChanges, ...]
    """Changes of the figures of each contact."""
    heated_by: str = "simulation"
    """Source of the loss that warms the teeth, as of `pyworm.ratings.heating.HeatingLoss`."""


def by_closed_forms(case: Case, places: Sequence[ContactIndex] | None = None) -> Solved:
    """Contacts of a case by closed forms, by default those that it lists, without a solve.

    ValueError for contacts that `pyworm.scene.scales` refuses.
    """
    point = OperatingPoint(case, case.places() if places is None else tuple(places))
    scenes = [case.scene(**place.given) for place in point.places]
    return Solved(
        point, tuple(map(closed_form_summary, scenes)), tuple(map(ClosedFormChanges, scenes))
    )


def key_sensitivities(
    solved: Solved,
    method: str = BY_CLOSED_FORMS,
    keys: Sequence[NumericKey] | None = None,
    progress: Progress | None = None,
) -> KeySensitivities:
    """Derivatives of all results of a case, by default to all numbers of its file."""
    wanted = numeric_keys(solved.point.case) if keys is None else keys
    here = _here(solved)
    results = {
        name: each.value for name, each in figures_of(solved.point, solved.summaries).items()
    }
    response = _Response.of(solved, here)
    found, refused = [], {}
    for count, number in enumerate(wanted):
        if progress is not None:
            progress(number.key, count / len(wanted))
        try:
            sides = both_sides(solved.point, number, here)
        except ValueError as error:
            refused[number.key] = str(error)
            continue
        derivatives = response.whole(_derivatives(solved, *sides))
        if any(derivatives.values()):
            found.append(_scaled(number, derivatives))
    return KeySensitivities(solved.point.case.name, results, tuple(found), refused, method)


def _here(solved: Solved) -> Side:
    case, places = solved.point.case, solved.point.places
    return Side(0.0, solved.point, tuple(case.scene(**place.given) for place in places))


@dataclass(frozen=True)
class _Response:
    """How what a run finds by iteration follows the other inputs."""

    found: dict[str, Mapping[str, float]]
    """Key of each value found -> derivatives of all results with respect to it."""

    @classmethod
    def of(cls, solved: Solved, here: Side) -> "_Response":
        """The response of a solved case; of values found that its results do not determine, none."""
        found = {
            number.key: _derivatives(solved, *both_sides(solved.point, number, here))
            for number in found_keys(solved.point.case)
            if number.key in FOUND
        }
        return cls({key: each for key, each in found.items() if key in each})

    def whole(self, derivatives: Mapping[str, float]) -> dict[str, float]:
        """Derivatives with respect to an input, from those with the values found held.

        Values found u equal results R(x, u): du/dx = (1 - dR/du)^-1 dR/dx.
        """
        keys = list(self.found)
        gains = np.array([[self.found[by][key] for by in keys] for key in keys])
        held = np.array([derivatives[key] for key in keys])
        changes = np.linalg.solve(np.eye(len(keys)) - gains, held) if keys else held
        return {
            name: value
            + sum(by * self.found[key][name] for by, key in zip(changes, keys, strict=True))
            for name, value in derivatives.items()
            if name not in keys
        }


def _derivatives(solved: Solved, low: Side, high: Side) -> dict[str, float]:
    """Derivatives of all results with respect to a number between two sides, in SI."""
    changes = [
        known.change(plus, minus)
        for known, plus, minus in zip(solved.changes, high.scenes, low.scenes, strict=True)
    ]
    less, more = (
        _figures(solved, side, changes, share) for side, share in ((low, -0.5), (high, 0.5))
    )
    between = high.value - low.value
    return {name: (more[name] - less[name]) / between for name in more.keys() & less.keys()}


def both_sides(point: OperatingPoint, number: NumericKey, here: Side) -> tuple[Side, Side]:
    """A case with a number a step below and above; the case itself for a side that there cannot be.

    ValueError of a number that can be moved to neither side.
    """
    sides, reasons = [], []
    for step in (-number.step, number.step):
        try:
            sides.append(_side(point, number, number.value + step))
        except ValueError as error:
            reasons.append(error)
            sides.append(replace(here, value=number.value))
    if len(reasons) == 2:
        raise reasons[0]
    return sides[0], sides[1]


def _side(point: OperatingPoint, number: NumericKey, value: float) -> Side:
    case = moved_case(point.case, {number.key: number.written(value)})
    scenes = tuple(case.scene(**place.given) for place in point.places)
    return Side(value, replace(point, case=case), scenes)


def moved_case(case: Case, values: Mapping[str, Any]) -> Case:
    """A case with other values at some keys, and what its run has found by iteration; CaseError of none."""
    moved = case_without_contacts(with_values(case.content, values), case.name, case.directory)
    found = {
        table: {key: getattr(getattr(case.tables, table), key) for key in open_keys}
        for table, open_keys in moved.left_open.items()
    }
    moved = moved.with_found(found)
    if moved.drive is None and case.drive is not None:
        raise CaseError(f"{case.name}: has no gears any more")
    return moved


def _figures(
    solved: Solved, side: Side, changes: Sequence[Mapping[str, float]], share: float
) -> dict[str, float]:
    """Results on one side, with a share of the changes of the figures of its contacts."""
    summaries = [
        moved_summary(
            summary,
            scene,
            {name: share * value for name, value in change.items()},
            known.figures,
        )
        for summary, scene, change, known in zip(
            solved.summaries, side.scenes, changes, solved.changes, strict=True
        )
    ]
    results = {name: each.value for name, each in figures_of(side.point, summaries).items()}
    return results | _found_again(solved, side, results)


def _found_again(solved: Solved, side: Side, results: Mapping[str, float]) -> dict[str, float]:
    """What the run would find by iteration, by key, from the results on one side."""
    loss = results.get("power_loss")
    if solved.heated_by == "standard":
        standard = standard_loss(side.point.case)
        loss = standard.power if isinstance(standard, StandardLoss) else None
    again = zip(FOUND, (results.get("friction_coefficient"), loss), strict=True)
    return {key: value for key, value in again if value is not None}


def _scaled(number: NumericKey, derivatives: Mapping[str, float]) -> KeySensitivity:
    """Derivatives by the unit in which the number is shown."""
    change, words = number.usual_change
    per_unit = 1.0 if not number.unit else 1 / (number.shown(1.0) - number.shown(0.0))
    return KeySensitivity(
        key=number.key,
        value=number.shown(number.value),
        unit=number.unit,
        change=change / per_unit,
        change_words=words,
        derivatives={name: value * per_unit for name, value in derivatives.items()},
    )
