"""What solved contacts of a design have over their closed forms, and its slopes by adjoint solutions."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import log
from typing import Any

from pyworm.batch.case_figures import figure_in
from pyworm.batch.design_model import Design, case_of_design
from pyworm.batch.operating_points import OperatingPoint
from pyworm.case.case import Case
from pyworm.case.design import DesignTask
from pyworm.planning.closed_form_figures import closed_form_figures
from pyworm.scene.index import ContactIndex

Pairs = tuple[tuple[Case, Case], ...]
"""Lower and higher case of each continuous variable."""


def offsets(
    point: OperatingPoint, summaries: Sequence[Mapping[str, Any]]
) -> dict[ContactIndex, dict[str, float]]:
    """What solved contacts have over their closed forms, as of `Correction`."""
    found: dict[ContactIndex, dict[str, float]] = {}
    for place, summary in zip(point.places, summaries, strict=True):
        found[place] = {}
        for name, closed in closed_form_figures(point.case.scene(**place.given)).items():
            simulated = figure_in(summary, name)
            if simulated is None:
                continue
            if name.startswith("temperature"):
                found[place][name] = simulated - closed
            elif min(simulated, closed) > 0:
                found[place][name] = log(simulated / closed)
    return found


def neighbours(task: DesignTask, design: Design) -> Pairs:
    """Cases of a design with each continuous variable a step below and above.

    CaseError of a variable that can be moved to one side alone.
    """
    steps = _steps(task)
    return tuple(
        (
            case_of_design(task, _shifted(design, place, -step), {}),
            case_of_design(task, _shifted(design, place, step), {}),
        )
        for place, step in enumerate(steps)
    )


def slopes(
    task: DesignTask, pairs: Pairs, known: Mapping[ContactIndex, Mapping[str, Any]]
) -> dict[ContactIndex, dict[str, tuple[float, ...]]]:
    """Slopes of the offsets of all contacts with an adjoint.

    Args:
        task: The design file.
        pairs: Cases next to the design, of `neighbours`.
        known: Figures and changes of each contact, of `pyworm.batch.adjoint_changes`.
    """
    found = {}
    for place, changes in known.items():
        if "reason" in changes:
            continue
        closed = [
            [closed_form_figures(case.scene(**place.given)) for case in pair] for pair in pairs
        ]
        found[place] = _slopes(changes, closed, _steps(task))
    return found


def _steps(task: DesignTask) -> list[float]:
    """Step of each continuous variable, a fraction of the way between its bounds."""
    return [variable.number.step / (variable.high - variable.low) for variable in task.variables]


def _shifted(design: Design, place: int, by: float) -> Design:
    fractions = list(design.fractions)
    fractions[place] += by
    return replace(design, fractions=tuple(fractions))


def _slopes(
    known: Mapping[str, Any],
    closed: Sequence[Sequence[Mapping[str, float]]],
    steps: Sequence[float],
) -> dict[str, tuple[float, ...]]:
    """Slopes of the offsets of a contact: those of its adjoint less those of its closed forms."""
    found = {}
    for name, figure in known["figures"].items():
        if name not in closed[0][0] or not figure:
            continue
        rates = []
        for change, (low, high), step in zip(known["changes"], closed, steps, strict=True):
            if name.startswith("temperature"):
                moved = change[name] - (high[name] - low[name])
            else:
                moved = change[name] / figure - log(high[name] / low[name])
            rates.append(moved / (2 * step))
        found[name] = tuple(rates)
    return found
