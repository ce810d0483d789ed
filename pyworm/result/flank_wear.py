"""Work of asperities at each place of a wheel's or worm's flank: pressure times sliding, over a pass in mesh.

Wear is proportional to it. Between solved phases fields and places are interpolated, as for extremes
(`pyworm.result.flank_map`); where films are in motion what asperities do is known at many instants between
them, on coarser grids, whose whole is made that of the solved phases. Each node of a contact gives its share
to the cells of the flank around it by the area it has there, so that the sum over the flank is that over the
contact: nothing is worn twice or lost.
"""

from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np
import scipy

from pyworm.drives.tooth_loss import FEWEST_PHASES
from pyworm.formulas.whole_numbers import whole
from pyworm.io.present import present
from pyworm.result.flank_map import LOADED_FRACTION, common_grid, layer_of
from pyworm.result.life import ContactLife, Fields, lives
from pyworm.result.mesh_cycle import flank_place, phase_of
from pyworm.result.result import Result
from pyworm.solver.solution import Solution

Array = np.ndarray

CELL = 0.5e-3
"""Side of a cell of worn flanks [m]."""

FLANK_MARGIN = 6e-3
"""Flank beyond the contacts as cut that a map holds [m]: in 1000 h they grow by some 3 mm to each side."""


@dataclass(frozen=True)
class FlankGrid:
    """Cells over a wheel's flank, or a worm's thread."""

    face: Array
    """Their middles along the wheel's face, or along the worm's axis, evenly spaced [m]."""
    radius: Array
    """Their middles away from the own axis, evenly spaced [m]."""

    @property
    def shape(self) -> tuple[int, int]:
        """Number of cells over (radius, face)."""
        return len(self.radius), len(self.face)

    @property
    def cell(self) -> float:
        """Area of a cell in these coordinates [m2]."""
        return float((self.face[1] - self.face[0]) * (self.radius[1] - self.radius[0]))

    def spread(self, amount: Array, face: Array, radius: Array) -> Array:
        """Amounts of points over the four cells around each, over the cells' area; (radius, face).

        An amount is a value times an area; points [m] beyond the grid are left out.
        """
        field = np.zeros(self.shape)
        column, across = _between(face, self.face)
        row, along = _between(radius, self.radius)
        inside = (column >= 0) & (column < len(self.face) - 1)
        inside &= (row >= 0) & (row < len(self.radius) - 1)
        column, row, across, along = (values[inside] for values in (column, row, across, along))
        held = amount[inside] / self.cell
        for down, part in ((0, 1 - along), (1, along)):
            for right, share in ((0, 1 - across), (1, across)):
                np.add.at(field, (row + down, column + right), held * part * share)
        return field


def _between(place: Array, axis: Array) -> tuple[Array, Array]:
    """Cell before each place, and the fraction of the way to the next."""
    distance = (place - axis[0]) / (axis[1] - axis[0])
    cell = whole(np.floor(distance))
    return cell, distance - cell


@dataclass(frozen=True)
class Pass:
    """What a pass through the mesh does to a flank."""

    work: Array
    """Pressure of asperities times sliding speed, over the time of a pass, (radius, face) [Pa m]."""
    volume: float
    """`work` integrated over the flank's true area [N m]."""


_WEARING = ("pressure", "asperity_rubbing", "seen_area", "area", "face", "radius")
"""Fields of a phase by which it wears a flank; others, temperatures, may be of some phases alone."""

Side = Literal["wheel", "worm"]
"""Whose flank."""

_PLACES = {"wheel": ("tooth_face", "tooth_radius"), "worm": ("thread_axial", "thread_radius")}
"""Fields with the place on each flank."""


def _placed(solution: Solution, x: Array, y: Array, side: Side) -> dict[str, Array]:
    """A solution's fields on the common grid, with places on one of the flanks."""
    at_x, at_y = np.meshgrid(x, y)
    places = flank_place(solution, at_x, at_y, _PLACES[side])
    return {**layer_of(solution, x, y), **dict(zip(("face", "radius"), places, strict=True))}


def flank_grid(result: Result, side: Side = "wheel") -> FlankGrid:
    """Cells that hold all contacts of a worm drive with simulated roughness, with a margin.

    They lie on the wheel, or on a thread of the worm. ValueError if too few phases converged.
    """
    solved = _solved(result)
    layers = [_placed(solution, *common_grid(solved), side) for solution in solved]
    stations = _whole_mesh([phase_of(solution) for solution in solved], layers, _tooth_load(result))
    axes = []
    for name in ("face", "radius"):
        low = min(float(_loaded(layer, name).min()) for _, layer in stations) - FLANK_MARGIN
        high = max(float(_loaded(layer, name).max()) for _, layer in stations) + FLANK_MARGIN
        axes.append(low + CELL * np.arange(np.ceil((high - low) / CELL) + 1))
    return FlankGrid(*axes)


def _loaded(layer: dict[str, Array], name: str) -> Array:
    pressure = layer["pressure"]
    return layer[name][pressure > LOADED_FRACTION * pressure.max()]


def _rough_phases(result: Result) -> list[Solution]:
    return [
        solution
        for solution in result.solutions
        if solution.converged and "asperity_pressure" in solution.fields
    ]


def _solved(result: Result) -> list[Solution]:
    solved = _rough_phases(result)
    if len(solved) < FEWEST_PHASES:
        listed = ", ".join(f"{solution.phase:g}" for solution in solved) or "none"
        raise ValueError(
            f"operation.phases: of those solved {len(solved)} converged with simulated roughness ({listed}); "
            f"wear needs {FEWEST_PHASES} or more, at which the teeth carry load: give more of them, or "
            "others by --phase"
        )
    return sorted(solved, key=phase_of)


def asperity_pass(
    result: Result, grid: FlankGrid, phases_per_second: float, side: Side = "wheel"
) -> Pass:
    """A pass through the mesh, from first touch of a tooth pair to its last, at a rate of the phase [1/s].

    Before the first solved phase and after the last one the contact of that phase goes on, its work in the
    ratio of the tooth pair's load; without a curve of that load the pass ends with them. A tooth has a pass
    in each turn of the wheel, a thread in each turn of the worm.
    """
    solved = _solved(result)
    x, y = common_grid(solved)
    layers = [_with_areas(_placed(solution, x, y, side), x, y) for solution in solved]
    work, volume = np.zeros(grid.shape), 0.0
    phases, layers = _with_instants(
        result, [phase_of(solution) for solution in solved], layers, x, y
    )
    stations = _whole_mesh(phases, layers, _tooth_load(result))
    for (phase, before), (next_phase, after) in pairwise(stations):
        moved = np.hypot(
            *(np.median(after[direction] - before[direction]) for direction in ("face", "radius"))
        )
        steps = max(int(whole(np.ceil(2 * moved / CELL))), 4)
        seconds = (next_phase - phase) / abs(phases_per_second) / steps
        for part in (np.arange(steps) + 0.5) / steps:  # the middle of each step
            now = {name: (1 - part) * before[name] + part * after[name] for name in _WEARING}
            rubbing = np.where(now["pressure"] > 0, now["asperity_rubbing"], 0.0) * seconds
            work += grid.spread(
                (rubbing * now["seen_area"]).ravel(), now["face"].ravel(), now["radius"].ravel()
            )
            volume += float((rubbing * now["area"]).sum())
    return Pass(work, volume)


def flank_work(result: Result, grid: FlankGrid, side: Side = "wheel") -> Array | None:
    """Pressure of asperities times sliding over a pass of transient solutions [Pa m], (radius, face).

    None of any other result.
    """
    life = _worm_life(result)
    if life is None or len(_rough_phases(result)) < FEWEST_PHASES:
        return None
    rate = float(
        np.median(np.diff(present(life.phases, "phases of the life")) / np.diff(life.seconds))
    )
    return asperity_pass(result, grid, rate, side).work


def _worm_life(result: Result) -> ContactLife | None:
    """The life of a tooth pair whose asperities' rubbing is known at its instants."""
    found = lives(result)
    if len(found) != 1 or found[0].phases is None or len(found[0].seconds) < 2:
        return None
    frames = found[0].frames
    return found[0] if frames and all(frame.rubbing is not None for frame in frames) else None


def _with_instants(
    result: Result, phases: list[float], layers: list[dict[str, Array]], x: Array, y: Array
) -> tuple[list[float], list[dict[str, Array]]]:
    """Phases and layers with those of the instants between, where films are transient.

    Places are between those of the solved phases; pressure and rubbing are the instant's, the latter in the
    ratio that it has in the whole at the solved phases on their finer grids.
    """
    life = _worm_life(result)
    if life is None:
        return phases, layers
    phases_of_frames = np.interp(
        [frame.seconds for frame in life.frames],
        life.seconds,
        present(life.phases, "phases of the life"),
    )
    between = [
        (phase, *_on_grid(frame, x, y))
        for phase, frame in sorted(
            zip(phases_of_frames, life.frames, strict=True), key=lambda pair: pair[0]
        )
    ]
    known, whole = (
        np.array(column)
        for column in zip(*((row[0], row[2].sum()) for row in between), strict=True)
    )
    solved = [float(layer["asperity_rubbing"].sum()) for layer in layers]
    coarse = np.interp(phases, known, whole)
    stations = dict(zip(phases, layers, strict=True))
    for phase, pressure, rubbing in between:
        after = int(np.searchsorted(phases, phase))
        if not 0 < after < len(phases) or phase in stations:
            continue
        part = (phase - phases[after - 1]) / (phases[after] - phases[after - 1])
        layer = {
            name: (1 - part) * layers[after - 1][name] + part * layers[after][name]
            for name in layers[after - 1].keys() & layers[after].keys()
        }
        fine, rough = (float(np.interp(phase, phases, values)) for values in (solved, coarse))
        if rough > 0:  # else nothing is known but the solved phases
            rubbed = {"pressure": pressure, "asperity_rubbing": fine / rough * rubbing}
            stations[phase] = {**layer, **rubbed}
    return sorted(stations), [stations[phase] for phase in sorted(stations)]


def _on_grid(frame: Fields, x: Array, y: Array) -> tuple[Array, Array]:
    """Pressure and rubbing of an instant on the common grid, (y, x), zero beyond its own."""
    places = np.stack(np.meshgrid(x, y), axis=-1)
    return tuple(
        scipy.interpolate.interpn(
            (frame.x, frame.y), field, places, bounds_error=False, fill_value=0.0
        )
        for field in (frame.pressure, frame.rubbing)
    )


Load = tuple[Array, Array]
"""Phases of the mesh, beyond 0 and 1 too, and the load of the tooth pair there [N]."""


def _tooth_load(result: Result) -> Load | None:
    """Load of a tooth pair over its whole mesh; None where the result has no curve of it."""
    cycle = result.mesh_cycle
    if cycle is None or "tooth_load" not in cycle:
        return None
    return cycle["load_phase"].values, cycle["tooth_load"].values


PHASES_PER_END = 6
"""Phases to each end of the mesh at which a solved contact is taken to go on."""


def _whole_mesh(
    phases: list[float], layers: list[dict[str, Array]], load: Load | None
) -> list[tuple[float, dict[str, Array]]]:
    """Layers of the solved phases, and of those before and after them.

    A contact moves over the flank as it does between the two solved phases next to it, up to phases 0 and 1;
    beyond them a tip touches, which stays where it is.
    """
    solved = list(zip(phases, layers, strict=True))
    if load is None:
        return solved
    touching = load[0][load[1] > 0]
    early = np.linspace(touching[0], phases[0], PHASES_PER_END, endpoint=False)
    late = np.linspace(touching[-1], phases[-1], PHASES_PER_END, endpoint=False)[::-1]
    before = [
        (phase, _moved(phase, solved[0], solved[1], load)) for phase in early if phase < phases[0]
    ]
    after = [
        (phase, _moved(phase, solved[-1], solved[-2], load)) for phase in late if phase > phases[-1]
    ]
    return [*before, *solved, *after]


def _moved(
    phase: float,
    end: tuple[float, dict[str, Array]],
    inner: tuple[float, dict[str, Array]],
    load: Load,
) -> dict[str, Array]:
    """The layer of the last solved phase at one beyond it."""
    carried, there = (float(np.interp(position, *load)) for position in (phase, end[0]))
    part = (min(max(phase, 0.0), 1.0) - end[0]) / (end[0] - inner[0])
    shift = {name: part * np.median(end[1][name] - inner[1][name]) for name in ("face", "radius")}
    moved = {name: end[1][name] + by for name, by in shift.items()}
    return {**end[1], **moved, "asperity_rubbing": end[1]["asperity_rubbing"] * carried / there}


def _with_areas(layer: dict[str, Array], x: Array, y: Array) -> dict[str, Array]:
    """A layer with the area of each node, in its plane and in the coordinates of the flank [m2]."""
    (face_y, face_x), (radius_y, radius_x) = (
        np.gradient(layer[name], y, x) for name in ("face", "radius")
    )
    area = np.full(layer["face"].shape, (x[1] - x[0]) * (y[1] - y[0]))
    seen = np.abs(face_x * radius_y - face_y * radius_x) * area
    return {**layer, "area": area, "seen_area": seen}


def smoothed(field: Array) -> Array:
    """A worn flank without the ripple of its cells, as a spline through them has to be."""
    return scipy.ndimage.gaussian_filter(field, 0.8, mode="nearest")
