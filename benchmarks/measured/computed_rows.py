"""What pyworm computes for the rows of an experiment, and how each input moves it.

Each input is moved by its standard uncertainty up and down, and all is solved anew; half of the difference is
its part of u_input. Rows of one contact share its solutions.
"""

import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache, partial
from math import log
from pathlib import Path
from typing import Any

from comparison_error import Computed

import pyworm
from pyworm.case.case import Case, case_of
from pyworm.case.dotted_keys import value_at, with_values
from pyworm.case.experiment import ExperimentTable, InputTable, MeasuredOilTable, RowTable
from pyworm.drives.worm.duty import geometry_of
from pyworm.formulas.worm_standard import forward_efficiency
from pyworm.io import units
from pyworm.io.given import kind_of
from pyworm.io.number_with_unit import number_and_unit
from pyworm.io.quantity import parse
from pyworm.io.toml import read_toml
from pyworm.io.uncertain import Uncertain, parse_uncertain
from pyworm.materials.library import NamedOil
from pyworm.materials.viscosity_density import Roelands
from pyworm.result.contact_loss import contact_losses
from pyworm.solver.estimate import Estimate
from pyworm.solver.solution import Solution

COVERAGE = 2.0
"""Standard uncertainties in a numerical uncertainty, which 19 of 20 errors keep to."""

BOUNDARY_SPREAD = 0.25
"""Relative uncertainty of boundary friction, as that of the model of roughness has it."""


@dataclass(frozen=True)
class Found:
    """A figure with its numerical and its model uncertainty, in SI units."""

    value: float
    numerical: float = 0.0
    model: float = 0.0

    @classmethod
    def of(cls, estimate: Estimate) -> "Found":
        """The figure of a solution."""
        size = abs(estimate.value - estimate.datum)
        return cls(estimate.value, estimate.error * size / COVERAGE, (estimate.model or 0.0) * size)


def computed(experiment: ExperimentTable, folder: Path) -> Iterator[tuple[RowTable, Computed]]:
    """The rows of an experiment, whose files are relative to a folder, and what is computed for them."""
    find = _of_oil if experiment.oils else partial(_of_case, folder=folder)
    for row in experiment.rows:
        base = find(experiment, row, None, 0.0)
        parts = {}
        for uncertain in experiment.inputs:
            up, down = (find(experiment, row, uncertain, step).value for step in (1.0, -1.0))
            parts[", ".join(uncertain.keys)] = (up - down) / 2
        yield row, Computed(base.value, base.numerical, base.model, parts)


# ------------------------------------------------------------------------------------------------- oils


def _of_oil(
    experiment: ExperimentTable, row: RowTable, moved: InputTable | None, step: float
) -> Found:
    """A property of an oil with one input moved by some standard uncertainties."""
    table = experiment.oils[row.oil]
    given = {"temperature": row.temperature, "pressure": row.pressure}
    factor = 1.0
    if moved is not None and moved.keys == ["viscosity"]:
        factor += step * moved.of(Uncertain(1.0, 0.0, "")).standard
    elif moved is not None:
        (name,) = moved.keys
        written = parse_uncertain(given[name])
        given[name] = moved.of(written).moved(step) if written.value else given[name]
    temperature = parse(given["temperature"], kind_of(units.Temperature))
    pressure = parse(given["pressure"], kind_of(units.PressureCoordinate))
    if table.viscosity is not None:
        law = table.viscosity.viscosity(temperature, None)
        return Found(float(Roelands(law.eta0 * factor, law.z, law.p0)(pressure)))
    return _PROPERTIES[row.quantity](_oil(table, factor), temperature, pressure)


def _oil(table: MeasuredOilTable, factor: float) -> NamedOil:
    """The oil of measured viscosities, all of them times a factor."""
    listed = {
        name: [f"{float(number) * factor!r} {unit}" for number, unit in map(number_and_unit, texts)]
        for name, texts in (("eta", table.eta), ("nu", table.nu))
        if texts is not None
    }
    return NamedOil.from_table(table.temperatures, base=table.base, **listed)


def _alpha(oil: NamedOil, temperature: float, pressure: float) -> Found:
    value = float(oil.alpha(temperature))
    return Found(value, model=oil.stock.alpha_spread * value)


def _rise(oil: NamedOil, temperature: float, pressure: float) -> Found:
    """ln(eta/eta0); Roelands' exponent spreads as alpha does, of which it is a multiple."""
    law = oil.oil(temperature).viscosity
    spread = Roelands(law.eta0, law.z * (1 + oil.stock.alpha_spread), law.p0)
    value = log(float(law(pressure)) / law.eta0)
    return Found(value, model=log(float(spread(pressure)) / law.eta0) - value)


def _limiting(oil: NamedOil, temperature: float, pressure: float) -> Found:
    flow = oil.flow(temperature)
    return Found(flow.limit / pressure + flow.limit_pressure)


_PROPERTIES: dict[str, Callable[[NamedOil, float, float], Found]] = {
    "pressure_viscosity": _alpha,
    "viscosity": lambda oil, temperature, pressure: Found(float(oil.viscosity(temperature))),
    "viscosity_rise": _rise,
    "density": lambda oil, temperature, pressure: Found(float(oil.density(temperature))),
    "limiting_coefficient": _limiting,
}


# ---------------------------------------------------------------------------------------------- contacts


def _of_case(
    experiment: ExperimentTable,
    row: RowTable,
    moved: InputTable | None,
    step: float,
    folder: Path,
) -> Found:
    """A figure of a case with one input moved by some standard uncertainties."""
    named = isinstance(experiment.case, str)
    content = read_toml(folder / experiment.case) if named else experiment.case
    content = with_values(content, row.changes)
    if moved is not None:
        content = with_values(
            content, {key: _moved(content, key, moved, step) for key in moved.keys}
        )
    where = (folder / experiment.case).parent if named else folder
    how = json.dumps(content), str(where), json.dumps(row.place), experiment.effects
    return _FIGURES[row.quantity](row, *_solved(*how, experiment.accuracy))


def _moved(content: dict[str, Any], key: str, uncertain: InputTable, step: float) -> str | float:
    """The value at a key moved by some standard uncertainties, as a case file has it."""
    return uncertain.of(parse_uncertain(value_at(content, key))).moved(step)


@cache
def _solved(
    content: str, folder: str, place: str, effects: tuple[str, ...], accuracy: float
) -> tuple[Case, tuple[Solution, ...]]:
    """A case and the solutions of its contact at a place, or of all that it lists."""
    case = case_of(json.loads(content), "measured", Path(folder))
    given = json.loads(place)
    places = [given] if given or case.drive is None else [at.given for at in case.places()]
    scenes = [case.scene(**where) for where in places]
    solved = (pyworm.solve(scene, pyworm.plan(scene, accuracy, effects)) for scene in scenes)
    return case, tuple(_converged(solution) for solution in solved)


def _converged(solution: Solution) -> Solution:
    """A solution, which has to have converged."""
    if not solution.converged:
        raise RuntimeError(f"not converged: {solution}")
    return solution


def _film(row: RowTable, case: Case, solutions: tuple[Solution, ...]) -> Found:
    """Film on the centre line, its numerical uncertainty as that of the central film thickness."""
    (solution,) = solutions
    x = parse(row.x, kind_of(units.Offset))
    value = float(solution.fields.film.interp(x=x, y=0.0))
    return Found(value, solution.figures.film_central.error * value / COVERAGE)


def _exit_min(row: RowTable, case: Case, solutions: tuple[Solution, ...]) -> Found:
    """Minimum film on the centre line, its numerical uncertainty as that of the minimum film thickness."""
    (solution,) = solutions
    value = solution.figures.film_exit_min
    return Found(value, solution.figures.film_min.error * value / COVERAGE)


def _mesh_friction(row: RowTable, case: Case, solutions: tuple[Solution, ...]) -> Found:
    """Mean friction coefficient of a gear pair, over load times sliding."""
    loss = case.drive.mesh_loss(contact_losses(solutions))
    model = (loss.model or 0.0) * loss.friction
    return Found(loss.friction, loss.error * loss.friction / COVERAGE, model)


def _efficiency(row: RowTable, case: Case, solutions: tuple[Solution, ...]) -> Found:
    """Efficiency of a worm's teeth with the friction of one contact for all."""
    (solution,) = solutions
    found = Found.of(solution.figures.friction_coefficient)
    return _of_friction(case, found)


def _at_rest(row: RowTable, case: Case, solutions: tuple[Solution, ...]) -> Found:
    """Efficiency of a worm's teeth whose asperities carry all of the load."""
    friction = case.drive.oil.boundary_friction
    return _of_friction(case, Found(friction, model=BOUNDARY_SPREAD * friction))


def _of_friction(case: Case, friction: Found) -> Found:
    """Efficiency of a worm's teeth by the standard's formula."""
    tan_lead = geometry_of(case.drive).tan_lead
    value, by_numbers, by_model = (
        forward_efficiency(tan_lead, friction.value + part)
        for part in (0.0, friction.numerical, friction.model)
    )
    return Found(value, abs(by_numbers - value), abs(by_model - value))


_FIGURES: dict[str, Callable[[RowTable, Case, tuple[Solution, ...]], Found]] = {
    "film": _film,
    "film_exit_min": _exit_min,
    "friction_of_mesh": _mesh_friction,
    "efficiency": _efficiency,
    "efficiency_at_rest": _at_rest,
}
