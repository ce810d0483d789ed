"""Thermal stress below the surface of a solved contact, by the temperature of the surface."""

from collections.abc import Sequence
from math import ceil

import numpy as np
import scipy

from pyworm.formulas.arrays import Array
from pyworm.formulas.thermal_stress import ThermalSolid
from pyworm.io.present import present
from pyworm.kernel import thermal_stress
from pyworm.materials.body import Body
from pyworm.scene.any_contact import AnyContact
from pyworm.solver.solution import Solution
from pyworm.solver.stress.tractions import Tractions

ROOM = 0.45
"""Room on both sides of the film's grid over its extent, on which the heat behind the contact fades out."""

FAST_STRIDE = 32
"""Largest distance in nodes of a coarser grid, whose transforms are made fast too."""


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
        width = [_room(count) for count in rise.shape]
        self.largest = solid.restrained * float(np.abs(rise).max())
        """Largest thermal stress of a surface that is heated everywhere alike and cannot expand [Pa]."""
        self._rise = _faded(np.pad(rise, width, mode="edge"), width)
        self._first = [
            start - sides[0] * step
            for start, sides, step in zip(grid.first, width, grid.spacing, strict=True)
        ]
        self._spacing, self._velocity, self._solid = grid.spacing, velocity, solid

    def stress(self, grid: Tractions, depths: Sequence[float] | Array) -> Array:
        """Thermal stress below the nodes of a grid whose nodes are among the film's [Pa].

        A coarser grid has the temperature at its own nodes.
        """
        chosen, window = [], []
        for axis, first, step, fine, total in zip(
            grid.axes(), self._first, grid.spacing, self._spacing, self._rise.shape, strict=True
        ):
            stride = round(step / fine)
            place = round((axis[0] - first) / fine)
            count = (total - place % stride - 1) // (2 * stride) * 2  # even
            chosen.append(slice(place % stride, place % stride + count * stride, stride))
            window.append((place // stride, len(axis)))
        return thermal_stress(
            self._rise[tuple(chosen)], grid.spacing, self._velocity, self._solid, depths, window
        )


def _room(count: int) -> tuple[int, int]:
    """Nodes before and behind some so that all, and every few of them, make fast transforms."""
    total = FAST_STRIDE * scipy.fft.next_fast_len(
        ceil((1 + 2 * ROOM) * count / FAST_STRIDE), real=True
    )
    before = (total - count) // 2
    return before, total - count - before


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
