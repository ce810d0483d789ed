"""What solved contacts of a design have over their closed forms, and its slopes by adjoint solutions."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import log
from typing import Any

from pyworm.batch.case_figures import figure_in
from pyworm.batch.design_model import Design, LaidOut, case_of_design
from pyworm.case.case import Case
from pyworm.case.design import DesignTask, is_temperature
from pyworm.case.numeric_keys import RELATIVE_STEP
from pyworm.planning.closed_form_figures import closed_form_figures
from pyworm.scene.index import ContactIndex

Pairs = tuple[tuple[Case, Case], ...]
"""Lower and higher case of each number of a correction."""


def offsets(
    laid: LaidOut, loss: float | None, summaries: Sequence[Mapping[str, Any]]
) -> dict[ContactIndex, dict[str, float]]:
    """What solved contacts have over their closed forms, as of `Correction`.

    Args:
        laid: The contacts by closed forms.
        loss: Loss between the teeth to which the temperatures of the solved ones belong [W].
        summaries: Scalars of the solved ones.
    """
    found: dict[ContactIndex, dict[str, float]] = {}
    for number, (place, closed, summary) in enumerate(
        zip(laid.point.places, laid.figures, summaries, strict=True)
    ):
        moves, found[place] = laid.moves(number, loss), {}
        for name, value in closed.items():
            simulated = figure_in(summary, name)
            if simulated is None:
                continue
            if is_temperature(name):
                found[place][name] = simulated - value - moves.get(name, 0.0)
            elif min(simulated, value) > 0:
                found[place][name] = log(simulated / value) - moves.get(name, 0.0)
    return found


def neighbours(task: DesignTask, design: Design, loss: float | None) -> Pairs:
    """Cases of a design with each number of its correction a step below and above.

    CaseError of a variable that can be moved to one side alone.
    """
    variables = tuple(
        (
            _at_loss(case_of_design(task, _shifted(design, place, -step)), loss),
            _at_loss(case_of_design(task, _shifted(design, place, step)), loss),
        )
        for place, step in enumerate(_steps(task))
    )
    if loss is None:
        return variables
    case, step = case_of_design(task, design), RELATIVE_STEP
    return (*variables, (_at_loss(case, loss * (1 - step)), _at_loss(case, loss * (1 + step))))


def _at_loss(case: Case, loss: float | None) -> Case:
    return case if loss is None else case.with_found({"cooling": {"tooth_loss": loss}})


def slopes(
    task: DesignTask,
    laid: LaidOut,
    pairs: Pairs,
    known: Mapping[ContactIndex, Mapping[str, Any]],
) -> dict[ContactIndex, dict[str, tuple[float, ...]]]:
    """Slopes of the offsets of all contacts with an adjoint.

    Args:
        task: The design file.
        laid: The contacts by closed forms.
        pairs: Cases next to the design, of `neighbours`.
        known: Figures and changes of each contact, of `pyworm.batch.adjoint_changes`.
    """
    found = {}
    steps = [*_steps(task), RELATIVE_STEP][: len(pairs)]
    for number, place in enumerate(laid.point.places):
        changes = known[place]
        if "reason" in changes:
            continue
        closed = [
            _closed_form_changes([closed_form_figures(case.scene(**place.given)) for case in pair])
            for pair in pairs[: len(task.variables)]
        ]
        if laid.loss is not None:
            by_loss = laid.by_loss[number].items()
            closed.append({name: 2 * RELATIVE_STEP * slope for name, slope in by_loss})
        found[place] = _slopes(changes, closed, steps)
    return found


def _steps(task: DesignTask) -> list[float]:
    """Step of each continuous variable, a fraction of the way between its bounds."""
    return [variable.number.step / (variable.high - variable.low) for variable in task.variables]


def _shifted(design: Design, place: int, by: float) -> Design:
    fractions = list(design.fractions)
    fractions[place] += by
    return replace(design, fractions=tuple(fractions))


def _closed_form_changes(pair: Sequence[Mapping[str, float]]) -> dict[str, float]:
    """Changes of the logarithms of figures by closed forms, of temperatures themselves [K]."""
    low, high = pair
    return {
        name: high[name] - low[name] if is_temperature(name) else log(high[name] / low[name])
        for name in low
        if is_temperature(name) or min(low[name], high[name]) > 0
    }


def _slopes(
    known: Mapping[str, Any], closed: Sequence[Mapping[str, float]], steps: Sequence[float]
) -> dict[str, tuple[float, ...]]:
    """Slopes of the offsets of a contact: those of its adjoint less those of its closed forms."""
    found = {}
    for name, figure in known["figures"].items():
        if not figure or any(name not in each for each in closed):
            continue
        size = 1.0 if is_temperature(name) else figure
        found[name] = tuple(
            (change[name] / size - by_closed_forms[name]) / (2 * step)
            for change, by_closed_forms, step in zip(known["changes"], closed, steps, strict=True)
        )
    return found
