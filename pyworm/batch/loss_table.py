"""Loss table of a worm drive: solves at some points of a grid, and friction emulated between them.

Solved points spread over the grid, each next one farthest from those before. The mean friction coefficient
of the teeth is interpolated between them over the logarithms of speed and torque and over the temperature
(`ScatteredSurface`); efficiencies follow from it by the balance of torques (`TorqueBalance`), transmission
error and stiffness by the load sharing of each torque without lift of films.
"""

from collections.abc import Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import numpy as np

from pyworm.batch.operating_points import OperatingPoint, Results, Solving
from pyworm.case.case import Case, case_without_contacts
from pyworm.case.drive_case import LOADS
from pyworm.drives.drive import Drive
from pyworm.drives.torque_balance import MeshAtTorque, TorqueBalance
from pyworm.formulas.arrays import Array
from pyworm.formulas.response_surface import ScatteredSurface
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.input_error import CaseError
from pyworm.io.present import present
from pyworm.result.loss_table import LossTable

POINTS = 16
"""Usual number of solved points."""

UNUSED = ("published", "assumed", "cooling")
"""Tables of a case without influence on its contacts at a given temperature of the oil."""

Node = tuple[int, int, int]
"""Numbers of speed, torque and temperature of a point of the grid."""

Axis = tuple[float, ...]
"""Rising values of speed, torque or temperature in SI."""


@dataclass(frozen=True)
class Grid:
    """Values over which a table is made, rising."""

    speeds: Axis
    """Speeds of the worm [rad/s]."""
    torques: Axis
    """Torques of the wheel [N m]."""
    temperatures: Axis
    """Temperatures of the oil at the inlet [K]."""

    @property
    def nodes(self) -> list[Node]:
        """All points; the temperature changes fastest."""
        counts = len(self.speeds), len(self.torques), len(self.temperatures)
        return list(product(*map(range, counts)))  # type: ignore[arg-type]  # three of them

    def places(self, nodes: Sequence[Node]) -> Array:
        """Points from 0 to 1 over each value that varies, logarithms of speeds and torques, (nodes, axes)."""
        columns = []
        for axis, values in enumerate(
            (np.log(self.speeds), np.log(self.torques), np.array(self.temperatures))
        ):
            if len(values) > 1:
                scaled = (values - values[0]) / (values[-1] - values[0])
                columns.append(scaled[[node[axis] for node in nodes]])
        return np.stack(columns, axis=1) if columns else np.zeros((len(nodes), 0))


def spread_nodes(grid: Grid, count: int, besides: Sequence[Node] = ()) -> list[Node]:
    """Some points of a grid, besides others: from its middle on each the farthest from all before."""
    nodes = grid.nodes
    places = grid.places(nodes)
    chosen = [nodes.index(node) for node in besides]
    if not chosen:
        chosen = [int(np.argmin(np.sum((places - 0.5) ** 2, axis=1)))]
    while len(chosen) < min(count + len(besides), len(nodes)):
        distances = np.linalg.norm(places[:, None] - places[chosen][None], axis=2).min(axis=1)
        distances[chosen] = -1.0
        chosen.append(int(np.argmax(distances)))
    return [nodes[number] for number in chosen[len(besides) :]]


@dataclass(frozen=True)
class Checked:
    """Solved points of a table compared with its emulation, which did not use them."""

    deviations: tuple[float, ...]
    """Relative deviation of the emulated friction, and so of the loss, at each."""
    error: float
    """Relative error that the table states."""

    @property
    def within(self) -> int:
        """Number of points within the error."""
        return sum(abs(deviation) <= self.error for deviation in self.deviations)

    def summary(self) -> dict[str, Any]:
        """The comparison as an object for JSON."""
        return {
            "points": len(self.deviations),
            "within": self.within,
            "deviation_max": max(map(abs, self.deviations), default=0.0),
            "error": self.error,
        }


def table_mesh(case: Case, temperatures: bool) -> MeshAtTorque:
    """The mesh of a case of which a table can be made; CaseError of another one.

    With `temperatures` its oil has to be known over temperature.
    """
    try:
        mesh = None if case.drive is None else case.drive.mesh_at_torque()
    except ValueError as error:
        raise CaseError(f"{case.name}: {error}; give a torque in [operation]") from error
    if mesh is None:
        raise CaseError(
            f"{case.name}: a table is made of a worm drive (drive.kind = worm); of other gears neither "
            "locking nor the yielding of the teeth is computed"
        )
    if case.drive is not None and case.drive.oil.heat is None:
        raise CaseError(f"{case.name}: oil.heat is missing, which friction needs")
    if temperatures and "temperature" not in case.content.get("oil", {}):
        raise CaseError(
            f"{case.name}: the oil's constants hold at one temperature; --temperatures needs an oil by "
            'name, such as oil.name = "PAG VG 460" with oil.temperature'
        )
    return mesh


def loss_table(
    case: Case,
    grid: Grid,
    solving: Solving,
    points: int = POINTS,
    phases: Sequence[float] | None = None,
    checks: int = 0,
) -> tuple[LossTable, Checked]:
    """The loss table of a worm drive over a grid, and a check of it by further solves.

    Args:
        case: The case, as `table_mesh` has it.
        grid: Values of the table.
        solving: How points are solved; solved contacts are kept in its directory, and found there again.
        points: Number of points that are solved.
        phases: Mesh phases that are solved; by default the case's.
        checks: Number of further points to compare with the emulation.

    Raises:
        NotSolvedError: A contact has no solution, or too few phases carry load.
    """
    chosen = spread_nodes(grid, points)
    compared = spread_nodes(grid, checks, chosen) if checks else []
    # one torque after the other, since the compliance of the teeth is kept for the last ones
    nodes = sorted((*chosen, *compared), key=lambda node: node[1])
    cases = {node: _case_at(case, grid, node) for node in nodes}
    asked = [_point(cases[node], phases) for node in cases]
    results = dict(zip(cases, solving.results(asked), strict=True))
    meshes = _meshes(case, grid)
    frictions = {
        node: meshes[node[1]].balance.friction(_efficiency(found))
        for node, found in results.items()
    }
    surface = ScatteredSurface(
        grid.places(chosen), np.array([frictions[node] for node in chosen], dtype=float)
    )
    error = _stated_error(surface, len(chosen) == len(grid.nodes))
    emulated = surface.at(grid.places(compared)) if compared else np.zeros(0)
    deviations = (
        float(value / frictions[node] - 1) for node, value in zip(compared, emulated, strict=True)
    )
    table = _table(case, grid, surface, chosen, meshes, (error, _largest_error(results)))
    return table, Checked(tuple(deviations), error)


def _efficiency(found: Results) -> float:
    return found["efficiency"].value


def _largest_error(results: Mapping[Node, Results]) -> float:
    """Largest relative numerical error of the loss."""
    losses = [found["power_loss"] for found in results.values()]
    return max(loss.error / loss.value for loss in losses)


def _stated_error(surface: ScatteredSurface, all_solved: bool) -> float:
    """Relative error of friction between the solved points: the largest by leaving out one of them.

    Infinite where too few were solved to leave one out.
    """
    if all_solved:
        return 0.0
    errors = np.abs(surface.errors())
    return float(np.nanmax(errors)) if np.isfinite(errors).any() else float("inf")


def _case_at(case: Case, grid: Grid, node: Node) -> Case:
    """The case at a point of the grid, the worm driving."""
    content = deepcopy(case.content)
    for table in UNUSED:
        content.pop(table, None)
    operation = content["operation"]
    for key in (*LOADS, "worm_speed", "wheel_speed", "lifts"):
        operation.pop(key, None)
    operation |= {
        "worm_speed": f"{float(grid.speeds[node[0]])!r} rad/s",
        "wheel_torque": f"{float(grid.torques[node[1]])!r} N m",
        "driver": "worm",
    }
    if "temperature" in content["oil"]:
        content["oil"]["temperature"] = f"{float(grid.temperatures[node[2]] - ZERO_CELSIUS)!r} degC"
    return case_without_contacts(content, case.name, case.directory)


def _point(case: Case, phases: Sequence[float] | None) -> OperatingPoint:
    """The contacts of a point that are solved, those under load."""
    return OperatingPoint(case, case.places(phase=phases), ("friction",))


@dataclass(frozen=True)
class _Mesh:
    """The mesh of one torque, and its gears."""

    loaded: MeshAtTorque
    drive: Drive

    @property
    def balance(self) -> TorqueBalance:
        return self.loaded.balance


def _meshes(case: Case, grid: Grid) -> list[_Mesh]:
    """The mesh at each torque; its loads do not depend on speed and temperature, but for their friction."""
    found = []
    for number in range(len(grid.torques)):
        drive = present(_case_at(case, grid, (0, number, 0)).drive, "drive")
        found.append(_Mesh(present(drive.mesh_at_torque(), "mesh"), drive))
    return found


def _table(
    case: Case,
    grid: Grid,
    surface: ScatteredSurface,
    chosen: Sequence[Node],
    meshes: Sequence[_Mesh],
    errors: tuple[float, float],
) -> LossTable:
    """The table of a surface of friction; the errors are those of emulation and of solutions."""
    nodes = grid.nodes
    shape = len(grid.speeds), len(grid.torques), len(grid.temperatures)
    friction = surface.at(grid.places(nodes)).reshape(shape)
    efficiency, reverse = (
        np.stack(
            [
                getattr(mesh.balance, name)(friction[:, number])
                for number, mesh in enumerate(meshes)
            ],
            axis=1,
        )
        for name in ("efficiency", "reverse_efficiency")
    )
    solved = np.zeros(shape, bool)
    solved[tuple(np.transpose(chosen))] = True
    return LossTable(
        name=case.name,
        title=case.title,
        ratio=meshes[0].loaded.ratio,
        speeds=np.array(grid.speeds),
        torques=np.array(grid.torques),
        temperatures=np.array(grid.temperatures),
        friction=friction,
        efficiency=efficiency,
        reverse_efficiency=reverse,
        other_torque=_other_torque(case, grid, meshes),
        transmission_error=np.array([mesh.loaded.transmission_error for mesh in meshes]),
        transmission_error_range=np.array(
            [mesh.loaded.transmission_error_range for mesh in meshes]
        ),
        stiffness=np.array([mesh.loaded.stiffness for mesh in meshes]),
        solved=solved,
        emulation_error=errors[0],
        solution_error=errors[1],
    )


def _other_torque(case: Case, grid: Grid, meshes: Sequence[_Mesh]) -> Array:
    """Torque of bearings, seals and churning on the worm by `[cooling]` [N m]; zero without."""
    shape = len(grid.speeds), len(grid.torques), len(grid.temperatures)
    found = np.zeros(shape)
    if case.tables.cooling is None:
        return found
    for number, mesh in enumerate(meshes):
        for place, speed in enumerate(grid.speeds):
            drive: Any = mesh.drive
            cooling = case.tables.cooling_of(replace(drive, speed=speed))
            found[place, number] = cooling.other.power / speed
    return found
