"""Fatigue below the surfaces of a solved contact: what a pass through it does to the material."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
import scipy

from pyworm.formulas.arrays import Array
from pyworm.formulas.fatigue import dang_van, failure_probability, risk
from pyworm.io import units
from pyworm.io.given import in_si
from pyworm.io.plain_dataset import described, merged
from pyworm.materials.fatigue_strength import FatigueStrength
from pyworm.scene.any_contact import AnyContact
from pyworm.solver.solution import Solution
from pyworm.solver.stress.maximum import StressBelow
from pyworm.solver.stress.subsurface import inputs_of_scene, stress_below, stress_inputs
from pyworm.solver.stress.thermal import body_velocity
from pyworm.solver.stress.tractions import Tractions

CELLS = 6
"""Grid cells to the half-width at least, as far as the film's grid has them."""

DEPTHS = np.geomspace(0.08, 1.6, 12)
"""Depths over the half-width at which fatigue is judged."""

ROOM = 0.25
"""Room on both sides of the tractions over their extent, in which stresses rise and fall."""

MOST_PATHS = 41
"""Paths of material below a point contact at most."""


@dataclass(frozen=True)
class FatiguePass:
    """What one pass of a contact does to the material of a body."""

    strength: FatigueStrength
    """What the material endures."""
    across: Array
    """Place of each path of material across its motion [m]; one, 0, of a line contact."""
    depths: Array
    """Depths [m]."""
    stress: Array
    """Equivalent stress of Dang Van (depth, path) [Pa]."""

    @property
    def ratio(self) -> Array:
        """Equivalent stress over its limit (depth, path) [-]: above 1 the material fails in the end."""
        return self.stress / self.strength.limit(self.depths)[:, None]

    @property
    def safety(self) -> float:
        """Least limit over equivalent stress [-], S_DV."""
        return float(1 / self.ratio.max())

    @property
    def critical_depth(self) -> float:
        """Depth of the least safety [m]."""
        return float(self.depths[self.ratio.max(axis=1).argmax()])

    @cached_property
    def risk(self) -> Array:
        """Risk of the pass for each area of the flank below each path [1/m2] (`formulas.fatigue.risk`)."""
        return risk(self.stress, self.strength.limit(self.depths)[:, None], self.depths)

    def risk_of_area(self, width: float, length: float = 0.0) -> float:
        """Risk of a pass [-] over a length of the flank along the motion [m], and a width of a line contact.

        A point contact is as wide as its paths. -ln of the probability to survive one pass.
        """
        if len(self.across) == 1:
            return float(self.risk[0] * width * length)
        return float(np.trapezoid(self.risk, self.across) * length)


def fatigue_pass(
    solution: Solution,
    body: int,
    strength: FatigueStrength | None = None,
    thermal: bool | None = None,
) -> FatiguePass:
    """Dang Van's equivalent stress below the paths of a body's material through a solved contact.

    The contact is steady: stresses over time are those along the body's velocity.

    Args:
        solution: The solved contact.
        body: Number of the body.
        strength: What its material endures; by default that of the scene's body.
        thermal: Whether thermal stress counts, as of `pyworm.Solution.stress`.

    Raises:
        ValueError: As of `pyworm.Solution.stress`; a body without strength, or one that does not move.
    """
    if strength is None:
        known = None if solution.solved is None else solution.solved[0].bodies[body - 1].fatigue
        if known is None:
            raise ValueError(
                f"{solution.name}: body {body} has no fatigue limits ([bodies.NAME.fatigue])"
            )
        strength = known
    return _passed(
        stress_below(solution, body, stress_inputs(solution, thermal)), solution, body, strength
    )


def _passed(
    below: StressBelow, solution: Solution, body: int, strength: FatigueStrength
) -> FatiguePass:
    velocity = np.array(body_velocity(solution, body))
    speed = float(np.linalg.norm(velocity))
    if not speed > 0:
        raise ValueError(f"{solution.name}: body {body} does not move through the contact")
    acting = below.grid(below.level_for(below.half_width, CELLS))
    grid = acting.widened(ROOM)
    depths = DEPTHS * below.half_width
    history = below.stress(grid, depths)
    step = below.half_width / CELLS
    across = np.zeros(1)
    if len(velocity) == 1:
        history = history[..., None]
    else:
        across, history = _along_paths(history, acting, grid, velocity / speed, step)
    stress = dang_van(
        history.transpose(0, 2, 1, 3), strength.slope, strength.residual(depths)[:, None]
    )
    return FatiguePass(strength, across, depths, stress)


def _along_paths(
    field: Array, acting: Tractions, grid: Tractions, direction: Array, step: float
) -> tuple[Array, Array]:
    """Paths across a direction of motion [m], and the field (component, depth, place, path) along them.

    `step` is the distance of places and the least of paths [m].
    """
    x, y = np.meshgrid(*acting.axes(), indexing="ij")
    along, across = x * direction[0] + y * direction[1], y * direction[0] - x * direction[1]
    count = min(MOST_PATHS, int(np.ptp(across) / step) + 2)
    paths = np.linspace(across.min(), across.max(), count)
    room = ROOM * np.ptp(along)
    places = np.arange(along.min() - room, along.max() + room + step, step)
    forward, beside = np.meshgrid(places, paths, indexing="ij")
    nodes = [
        (place - first) / spacing
        for place, first, spacing in zip(
            (
                forward * direction[0] - beside * direction[1],
                forward * direction[1] + beside * direction[0],
            ),
            grid.first,
            grid.spacing,
            strict=True,
        )
    ]
    shape = field.shape[:2]
    found = [
        scipy.ndimage.map_coordinates(part, nodes, order=1, mode="nearest")
        for part in field.reshape(-1, *field.shape[2:])
    ]
    return paths, np.reshape(found, (*shape, *forward.shape))


def with_fatigue(solution: Solution, scene: AnyContact) -> Solution:
    """A converged solution with fields of fatigue of each body whose limits are known.

    `fatigue_ratio_body_N` is the largest ratio over depth below each node's path, `fatigue_risk_body_N` its
    risk; zero beyond the paths. A body at rest, which no load passes, has none.
    """
    found: dict[str, Array] = {}
    worst: dict[str, Any] = {}
    known = solution.figures.stress
    inputs = inputs_of_scene(scene, known is not None and known.heated is not None)
    for number, body in enumerate(scene.bodies, 1):
        if body.fatigue is None or not any(body_velocity(solution, number)):
            continue
        below = stress_below(solution, number, inputs)
        material = _passed(below, solution, number, body.fatigue)
        worst[f"fatigue_ratio_max_body_{number}"] = 1 / material.safety
        found[f"fatigue_ratio_body_{number}"] = _on_nodes(
            solution, number, material, material.ratio.max(axis=0)
        )
        found[f"fatigue_risk_body_{number}"] = _on_nodes(solution, number, material, material.risk)
    if not found:
        return solution
    fields = solution.dataset("fields")
    dims = ("y", "x") if solution.kind == "point" else ("x",)
    more = described({name: (dims, values) for name, values in found.items()}, {})
    stress = None if known is None else replace(known, **worst)
    figures = replace(solution.figures, stress=stress)
    return solution.changed(fields=merged(fields, more), figures=figures)


def _on_nodes(solution: Solution, body: int, material: FatiguePass, values: Array) -> Array:
    """A value of each path at the nodes that it passes, (ny, nx) or (nx,)."""
    fields = solution.dataset("fields")
    x = np.asarray(fields["x"].values, dtype=float)
    if solution.kind == "line":
        return np.full(x.shape, values[0], dtype=np.float32)
    velocity = np.array(body_velocity(solution, body))
    u, v = velocity / np.linalg.norm(velocity)
    x, y = np.meshgrid(x, np.asarray(fields["y"].values, dtype=float))
    return np.interp(y * u - x * v, material.across, values, left=0, right=0).astype(np.float32)


def duty_failure(duty: Sequence[tuple[FatiguePass, float]], width: float, length: float) -> float:
    """Probability that an area of a flank fails [-] under several contacts, by Miner.

    Args:
        duty: Passes and the number of cycles of each.
        width: Width of the flank of a line contact [m]; that of point contacts is their own.
        length: Length of the flank that they sweep [m].

    Raises:
        ValueError: A size that there is not.
    """
    wide, long = (
        in_si(name, value, units.Length) for name, value in (("width", width), ("length", length))
    )
    loads = [(material.risk_of_area(wide, long), cycles) for material, cycles in duty]
    return float(failure_probability(loads))
