"""Thermal stress below the surface of a solved contact, by the temperature of the surface."""

from collections.abc import Sequence

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.formulas.thermal_stress import ThermalSolid, thermal_stress
from pyworm.io.present import present
from pyworm.materials.body import Body
from pyworm.scene.any_contact import AnyContact
from pyworm.solver.solution import Solution
from pyworm.solver.stress.tractions import Tractions

ROOM = 0.5
"""Room on both sides of the film's grid over its extent, on which the heat behind the contact fades out."""


def why_no_heat(solution: Solution, scene: AnyContact) -> str:
    """Why a solved contact has no thermal stress, in a clause; empty if it has."""
    if "temperature_body_1" not in solution.dataset("fields"):
        return "heat was not simulated"
    unknown = [
        str(number) for number, body in enumerate(scene.bodies, 1) if body.thermal_expansion is None
    ]
    return f"thermal_expansion of body {' and '.join(unknown)} is missing" if unknown else ""


def thermal_solid(body: Body, number: int) -> ThermalSolid:
    """Thermal constants of body 1 or 2; ValueError where one is not known."""
    name = f"body {number}: thermal_expansion"
    if body.thermal_expansion is None:
        raise ValueError(f'{name} is missing, such as "11.5e-6 1/K" of steel: no thermal stress')
    return ThermalSolid(
        body.youngs_modulus,
        body.poisson_ratio,
        body.thermal_expansion,
        body.diffusivity,
        present(body.bulk_temperature, "bulk_temperature"),
    )


class HeatedBody:
    """Thermal stress below the nodes of a film's grid.

    The body moves at its mean velocity where the contact bears load.
    """

    def __init__(
        self, rise: Array, grid: Tractions, velocity: tuple[float, ...], solid: ThermalSolid
    ):
        width = [(round(ROOM * count),) * 2 for count in rise.shape]
        self._rise = _faded(np.pad(rise, width, mode="edge"), width)
        self._first = [
            start - sides[0] * step
            for start, sides, step in zip(grid.first, width, grid.spacing, strict=True)
        ]
        self._spacing, self._velocity, self._solid = grid.spacing, velocity, solid
        self._known: dict[tuple[float, tuple[tuple[int, int], ...]], Array] = {}

    def stress(self, grid: Tractions, depths: Sequence[float] | Array) -> Array:
        """Thermal stress below the nodes of a grid whose nodes are among the film's [Pa].

        A coarser grid has the temperature at its own nodes.
        """
        parts, nodes = [], []
        for axis, first, step, fine in zip(
            grid.axes(), self._first, grid.spacing, self._spacing, strict=True
        ):
            stride = round(step / fine)
            place = round((axis[0] - first) / fine)
            parts.append((place % stride, stride))
            nodes.append(place // stride + np.arange(len(axis)))
        found = [self._below(float(depth), tuple(parts)) for depth in depths]
        inside = [
            np.clip(node, 0, count - 1)
            for node, count in zip(nodes, found[0].shape[1:], strict=True)
        ]
        chosen = np.ix_(np.arange(6), *inside)
        return np.stack([field[chosen] for field in found], axis=1)

    def _below(self, depth: float, parts: tuple[tuple[int, int], ...]) -> Array:
        """Components at a depth at some nodes of the grid with its room: the first, and every so many."""
        key = depth, parts
        if key not in self._known:
            spacing = [
                fine * stride for fine, (_, stride) in zip(self._spacing, parts, strict=True)
            ]
            chosen = tuple(slice(start, None, stride) for start, stride in parts)
            self._known[key] = thermal_stress(
                self._rise[chosen], spacing, self._velocity, self._solid, [depth]
            )[:, 0].astype(np.float32)
        return self._known[key]


def _faded(field: Array, width: Sequence[tuple[int, int]]) -> Array:
    """A field that falls to zero over the outer nodes of each direction."""
    for axis, (before, behind) in enumerate(width):
        count = field.shape[axis]
        place = np.minimum(np.arange(count) / before, (count - 1 - np.arange(count)) / behind)
        weight = (1 - np.cos(np.pi * np.clip(place, 0, 1))) / 2
        field = field * weight.reshape([-1 if other == axis else 1 for other in range(field.ndim)])
    return field


def heated_body(solution: Solution, body: int, solid: ThermalSolid) -> HeatedBody:
    """Body 1 or 2 of a solved contact with the heat of its surface; ValueError where none was simulated."""
    fields = solution.dataset("fields")
    name = f"temperature_body_{body}"
    if name not in fields:
        raise ValueError(f"{solution.name}: no thermal stress, since heat was not simulated")
    axes = ("x", "y") if solution.kind == "point" else ("x",)
    rise = np.asarray(fields[name].values.T, dtype=float) - solid.bulk_temperature
    nodes = [np.asarray(fields[axis].values, dtype=float) for axis in axes]
    grid = Tractions(
        np.zeros(rise.shape),
        (),
        tuple(float(axis[0]) for axis in nodes),
        tuple(float(axis[1] - axis[0]) for axis in nodes),
    )
    return HeatedBody(rise, grid, body_velocity(solution, body), solid)


def body_velocity(solution: Solution, body: int) -> tuple[float, ...]:
    """Velocity of the surface of a body past the contact along each direction, mean over the load [m/s]."""
    fields = solution.dataset("fields")
    load = np.asarray(fields["pressure"].values.T, dtype=float)
    side = 0.5 if body == 1 else -0.5
    return tuple(
        float(
            (
                load
                * (
                    fields[f"entrainment_{axis}"].values.T
                    + side * fields[f"sliding_{axis}"].values.T
                )
            ).sum()
            / load.sum()
        )
        for axis in (("x", "y") if solution.kind == "point" else ("x",))
    )
