"""What a search for the best design shows: variables, figures that decide, verdicts on constraints."""

from collections.abc import Iterator

from pyworm.batch.design_model import Design, Figures
from pyworm.batch.design_search import Goal, margin, size_of, worst
from pyworm.case.design import DesignTask, Limit, figure_text, is_temperature
from pyworm.case.dotted_keys import value_at
from pyworm.case.numeric_keys import NumericKey
from pyworm.io.input_error import toml
from pyworm.io.quantity_text import percent
from pyworm.result.design import DesignFigure, DesignVariable

AT_BOUND = 1e-6
"""Distance from a bound that counts as none, a fraction of the way between the bounds."""

VIOLATED = 1e-3
"""Violation of a limit, over its size, that is reported."""


def verdicts(goal: Goal, figures: Figures) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Limits that are violated, and those that are open within the numerical uncertainty."""
    violated, unsure = [], []
    for limit in goal.limits:
        figure, left = figures[limit.name], margin(limit, figures, goal.scales)
        found = figure_text(limit.name, worst(figure, limit.upper))
        size = size_of(limit, goal.scales)
        if left >= -VIOLATED and abs(left) * size < figure.error:
            unsure.append(
                f"{limit.words} is open: {found} is within its numerical uncertainty of the limit."
            )
        elif left < -VIOLATED:
            violated.append(
                f"No design was found that meets {limit.words}: the best has {found}, "
                f"{_amount(limit, left, size)} beyond the limit."
            )
    return tuple(violated), tuple(unsure)


def _amount(limit: Limit, left: float, size: float) -> str:
    """The amount of a violation in words, of temperatures in kelvins."""
    return f"{-left * size:.2g} K" if is_temperature(limit.name) else percent(-left)


def variables(task: DesignTask, best: Design) -> Iterator[DesignVariable]:
    """Variables, chosen values and numbers that follow, as the best design has them."""
    numbers = {}
    for variable, fraction in zip(task.variables, best.fractions, strict=True):
        number = variable.number
        numbers[number.key] = variable.at(fraction)
        yield DesignVariable(
            key=number.key,
            start=_text(number, number.value),
            best=_written(number, variable.at(fraction)),
            bounds=f"{_text(number, variable.low)} to {_text(number, variable.high)}",
            at_bound=not AT_BOUND < fraction < 1 - AT_BOUND,
        )
    for key, chosen in best.chosen:
        start = value_at(task.case.content, key)
        yield DesignVariable(
            key, f"{start}", chosen, ", ".join(map(toml, task.tables.choices[key]))
        )
    for each in task.followed:
        yield DesignVariable(
            key=each.number.key,
            start=_text(each.number, each.number.value),
            best=_written(each.number, each.at(numbers[each.variable])),
            bounds=f"follows {each.variable}",
        )


def _written(number: NumericKey, value: float) -> str | float:
    """A value in SI as a case file has it, in the unit in which it is shown."""
    return _text(number, value) if number.unit else value


def _text(number: NumericKey, value: float) -> str:
    return f"{number.shown(value):.6g} {number.unit}".rstrip()


def decisive(
    goal: Goal, task: DesignTask, before: Figures, best: Figures
) -> Iterator[DesignFigure]:
    """Figures that decide, with their roles."""
    limits: dict[str, list[Limit]] = {}
    for limit in task.limits:
        limits.setdefault(limit.name, []).append(limit)
    front = {} if task.tables.front is None else task.tables.front.weights
    for name in task.names:
        roles = [
            "minimised" if weights[name] > 0 else "maximised"
            for weights in (goal.weights, front)
            if name in weights
        ]
        roles += [
            f"{'<=' if limit.upper else '>='} {figure_text(name, limit.bound)}"
            for limit in limits.get(name, ())
        ]
        margins = [margin(limit, best, goal.scales) for limit in limits.get(name, ())]
        upper = goal.weights.get(name, front.get(name, 0.0)) > 0 or any(
            limit.upper for limit in limits.get(name, ())
        )
        yield DesignFigure(
            name=name,
            role=", ".join(roles),
            before=before[name].value,
            best=best[name].value,
            before_error=before[name].error,
            best_error=best[name].error,
            margin=min(margins) if margins else None,
            worst=worst(best[name], upper) if task.errors else None,
        )
