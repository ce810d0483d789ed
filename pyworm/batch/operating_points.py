"""What is computed at several operating points of a case, for fits and for the uncertainty of inputs.

All contacts of all points are solved together, each once, kept by their keys and found again. It is the model
of `pyworm run` but for what costs much and changes little: teeth share their load without the film-induced
separation and with the usual friction, and films are steady. Temperatures of a cooled housing are found.
"""

from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from math import inf
from pathlib import Path
from typing import Any

from pyworm.batch.case_run import SCENES
from pyworm.batch.drive_iteration import WARM_PASSES, WARMTH, next_loss, steady
from pyworm.batch.solve_tasks import solve_all
from pyworm.batch.solved_scenes import Store
from pyworm.batch.task import Task
from pyworm.case.case import Case
from pyworm.drives.mesh_loss import ContactLoss, MeshLoss
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.present import present
from pyworm.io.progress import Progress
from pyworm.io.quantities import QUANTITIES, Quantity
from pyworm.planning.by_formula import films_by_formula
from pyworm.ratings.heating import tooth_loss_of
from pyworm.scene.formula_film import film_of
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.cost.expected_time import expectation

EXTREMES: tuple[str, ...] = (
    *("film_min", "film_central", "pressure_max"),
    *("temperature_max_body_1", "temperature_max_body_2", "temperature_max_film"),
)
"""Results of which the extreme over the contacts of a point is taken."""

QUANTITY_OF = {
    "film": "film",
    "friction": "friction",
    "power": "friction",
    "temperature": "temperature",
}
"""First word of the name of a result -> the quantity that has to be accurate for it."""


class NotSolvedError(RuntimeError):
    """A contact of an operating point has no solution; the message says which and why."""


@dataclass(frozen=True)
class Computed:
    """A result with its uncertainties."""

    value: float
    """The value [SI]."""
    error: float
    """Numerical uncertainty in the same unit, a 95 % bound."""
    model: float = 0.0
    """Model uncertainty in the same unit, likewise."""


@dataclass(frozen=True)
class OperatingPoint:
    """A case and those of its contacts that are solved."""

    case: Case
    """The case."""
    places: tuple[ContactIndex, ...]
    """Its contacts."""
    quantities: tuple[str, ...] | None = None
    """Quantities that have to be accurate, as of `pyworm.plan`."""
    by_formula: bool = False
    """Whether its films are those of the atlas, without a solve."""

    def with_tooth_loss(self, power: float) -> "OperatingPoint":
        """The point with temperatures of a housing by another loss between the teeth [W]."""
        return replace(self, case=self.case.with_found({"cooling": {"tooth_loss": power}}))


Results = Mapping[str, Computed]
"""Name -> result of an operating point."""


@dataclass(frozen=True)
class SolvedPoint:
    """An operating point with its contacts solved."""

    point: OperatingPoint
    """The point, of a cooled housing with the loss between the teeth to which its temperatures belong."""
    summaries: tuple[Mapping[str, Any], ...]
    """Scalars of each contact, as of `Solution.summary`; none of films by formula."""
    results: Results
    """Its results."""


@dataclass(frozen=True)
class Solving:
    """How operating points are solved."""

    directory: Path
    """Directory in which solved contacts are kept."""
    accuracy: float
    """Requested relative error [-]."""
    effects: Sequence[str]
    """Effects, as of `pyworm.plan`."""
    executor: Executor | None = None
    """The processes that solve; by default this one."""
    progress: Progress | None = None
    """What is called with the progress."""

    def results(self, points: Sequence[OperatingPoint]) -> list[Results]:
        """Results of each point; errors as of `balanced`."""
        return [each.results for each in self.balanced(points)]

    def balanced(self, points: Sequence[OperatingPoint]) -> list["SolvedPoint"]:
        """Each point with its contacts solved, at the temperatures that its own loss gives a housing.

        Raises:
            NotSolvedError: A contact could not be solved, or did not converge.
        """
        current = list(points)
        losses: list[list[tuple[float, float]]] = [[] for _ in current]
        for _ in range(WARM_PASSES):
            found = self._solved_points(current)
            moved = [_warmed(*each) for each in zip(found, losses, strict=True)]
            if moved == [None] * len(current):
                break
            current = [
                point if new is None else new for new, point in zip(moved, current, strict=True)
            ]
        return found

    def _solved_points(self, points: Sequence[OperatingPoint]) -> list["SolvedPoint"]:
        tasks = [[] if point.by_formula else self.tasks(point) for point in points]
        known = self.solved([task for some in tasks for task in some])
        return [
            SolvedPoint(point, (), _by_formula(point))
            if point.by_formula
            else _solved_point(point, tuple(known[task.key] for task in some))
            for point, some in zip(points, tasks, strict=True)
        ]

    def solved(self, tasks: Sequence[Task]) -> dict[str, dict[str, Any]]:
        """Scalars of the solutions of some contacts by key, each solved once.

        Raises:
            NotSolvedError: A contact could not be solved, or did not converge.
        """
        store = Store(self.directory.absolute() / SCENES, False)
        reasons = solve_all(store.missing(tasks), store, self.executor, self.progress)
        for task in tasks:
            if task.key in reasons:
                raise NotSolvedError(f"{_named(task)} could not be solved: {reasons[task.key]}")
        known = {task.key: store.summary(task) for task in tasks}
        for task in tasks:
            if not known[task.key]["converged"]:
                reason = known[task.key]["stop_reason"]
                raise NotSolvedError(f"{_named(task)} did not converge: {reason}")
        return known

    def formula_suffices(self, point: OperatingPoint) -> bool:
        """Whether a formula gives all that is asked of a point to the accuracy."""
        return all(
            films_by_formula(task.scene, task.plan) is not None for task in self.tasks(point)
        )

    def tasks(self, point: OperatingPoint) -> list[Task]:
        """The contacts of a point as they are solved."""
        how = self.accuracy, self.effects, point.quantities
        return [steady(Task(point.case, place, *how)) for place in point.places]

    def expected_seconds(self, points: Sequence[OperatingPoint]) -> float:
        """Expected CPU time of one solve of all contacts of some points, none for films by formula [s]."""
        solved = [point for point in points if not point.by_formula]
        tasks = {task.key: task for point in solved for task in self.tasks(point)}.values()
        return sum(expectation(task.scene, task.plan).seconds for task in tasks)


def _named(task: Task) -> str:
    return ", ".join(part for part in (task.case.name, str(task.place)) if part)


def _solved_point(point: OperatingPoint, summaries: tuple[Mapping[str, Any], ...]) -> SolvedPoint:
    return SolvedPoint(point, summaries, read_results(point, summaries))


def follows_loss(case: Case) -> bool:
    """Whether the temperatures of a case follow from the loss between its teeth, which is not given."""
    return "tooth_loss" not in case.content.get("cooling", {"tooth_loss": None})


def _warmed(solved: SolvedPoint, losses: list[tuple[float, float]]) -> OperatingPoint | None:
    """The point with the temperatures of its loss; None where these are found, or given."""
    case = solved.point.case
    if not follows_loss(case) or "power_loss" not in solved.results:
        return None
    assumed, power = tooth_loss_of(case), solved.results["power_loss"].value
    if abs(power - assumed) <= WARMTH * case.tables.unit_of(case.drive).conductance:
        return None
    losses.append((assumed, power))
    return solved.point.with_tooth_loss(float(f"{next_loss(losses):.3g}"))


def _by_formula(point: OperatingPoint) -> Results:
    """Films of a point by the formula of the atlas."""
    films = [film_of(_point_contact(point.case.scene(**place.given))) for place in point.places]
    central, minimum = (
        min(
            (Computed(float(value), float(value * error)) for value, error in pairs),
            key=lambda computed: computed.value,
        )
        for pairs in (
            [(film.central, film.central_error) for film in films],
            [(film.minimum, film.minimum_error) for film in films],
        )
    )
    return {"film_central": central, "film_min": minimum}


def _point_contact(scene: Scene | LineScene) -> Scene:
    if isinstance(scene, LineScene):
        raise ValueError(f"{scene.name}: the atlas has point contacts alone")
    return scene


def read_results(point: OperatingPoint, summaries: Sequence[Mapping[str, Any]]) -> Results:
    """Results of a point by name, from the scalars of its contacts."""
    return dict(_read(point, summaries))


def _read(
    point: OperatingPoint, summaries: Sequence[Mapping[str, Any]]
) -> Iterator[tuple[str, Computed]]:
    for name in EXTREMES:
        quantity = QUANTITIES[name]
        values = [value for summary in summaries if (value := _computed(summary, quantity))]
        if values:
            choose = min if quantity.extreme == "minimum" else max
            yield name, choose(values, key=lambda computed: computed.value)
    if point.case.drive is not None:
        yield from _of_gears(point, summaries)
    elif len(summaries) == 1:
        (summary,) = summaries
        for name in ("friction_coefficient", "power_loss", "power_loss_per_length"):
            if computed := _computed(summary, QUANTITIES[name]):
                yield QUANTITIES[name].figure, computed


def _computed(summary: Mapping[str, Any], quantity: Quantity) -> Computed | None:
    """A scalar of a solution in SI; None where it was not simulated."""
    name, celsius, body = quantity.key.partition("_C_")
    if celsius:
        parts = (f"{name}_C", f"{name}_error_K", f"{name}_model_error_K")
        value, error, model = (summary.get(part, {}).get(body, 0.0) for part in parts)
        return Computed(value + ZERO_CELSIUS, error, model) if parts[0] in summary else None
    value = summary.get(quantity.key)
    if value is None:
        return None
    error, model = summary.get(quantity.error_key, inf), summary.get(quantity.model_key, 0.0)
    return Computed(value, error * abs(value), model * abs(value))


def _of_gears(
    point: OperatingPoint, summaries: Sequence[Mapping[str, Any]]
) -> Iterator[tuple[str, Computed]]:
    """Friction, loss and efficiency of the teeth, and what follows for the gear unit."""
    if any("friction_coefficient" not in summary for summary in summaries):
        return
    drive = present(point.case.drive, "drive")
    loss = drive.mesh_loss([_contact_loss(summary) for summary in summaries])
    if loss is None:
        return
    yield "friction_coefficient", _related(loss, loss.friction, loss.friction)
    yield "power_loss", _related(loss, loss.loss, loss.loss)
    yield "efficiency", _related(loss, loss.efficiency, 1 - loss.efficiency)
    if getattr(point.case.tables, "cooling", None) is None:
        return
    unit = point.case.tables.unit_of(drive, loss.loss)
    cooling = unit.cooling
    whole = loss.loss + cooling.other.power
    # bearings, seals and churning take their power at the shaft that drives
    share = whole / (loss.power + cooling.other.power)
    yield "unit_efficiency", _related(loss, 1 - share, share * loss.loss / whole)
    rise = whole / unit.conductance
    yield (
        "sump_temperature",
        _related(loss, cooling.ambient_temperature + rise, loss.loss / unit.conductance),
    )


def _related(loss: MeshLoss, value: float, size: float) -> Computed:
    """A result with the relative uncertainties of the loss of the teeth, to a part of it of some size."""
    model = 0.0 if loss.model is None else loss.model
    return Computed(value, loss.error * size, model * size)


def _contact_loss(summary: Mapping[str, Any]) -> ContactLoss:
    """Friction of a contact by the scalars of its solution."""
    kind = "" if summary["kind"] == "point" else "_per_length"
    load, power = QUANTITIES[f"load{kind}"], QUANTITIES[f"power_loss{kind}"]
    return ContactLoss(
        phase=summary["phase"],
        load=summary[load.key],
        friction=summary["friction_coefficient"],
        power=summary[power.key],
        error=summary[power.error_key],
        model=summary.get(power.model_key),
        section=summary["section"],
        station=summary["station"],
    )


def quantities_for(names: Sequence[str]) -> tuple[str, ...]:
    """Quantities that have to be accurate for some results, as of `pyworm.plan`."""
    asked = {QUANTITY_OF.get(name.partition("_")[0], "friction") for name in names}
    return tuple(word for word in ("film", "friction", "temperature") if word in asked)
