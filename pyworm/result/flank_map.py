"""Extremes over a mesh cycle at each place of the wheel's flank.

Solutions are fields over the tangent planes of some phases. Between neighbouring phases fields and their
places on the flank are interpolated, so that the contact sweeps the flank without gaps.

**Entry.** Oil enters the contact where the entrainment crosses the outline of the dry contact inwards; its
speed normal to the outline there determines the film downstream. Where the streamline of the entrainment
through a place entered at less than `FAILURE` of the entrainment's mean speed, or nowhere, entrainment fails
(so Sharif et al. 2001, section 6, explain their band of thin film).
"""

from collections.abc import Iterable, Iterator
from itertools import compress, pairwise

import numpy as np
import scipy

from pyworm.drives.tooth_loss import FEWEST_PHASES
from pyworm.formulas.fatigue import failure_probability
from pyworm.formulas.whole_numbers import whole
from pyworm.io.on_demand import xarray as xr
from pyworm.io.present import present
from pyworm.io.quantities import describe
from pyworm.result.mesh_cycle import flank_place, phase_of
from pyworm.result.result import Result
from pyworm.solver.solution import Solution

Array = np.ndarray

NODES = 200, 100
"""Nodes along x and y of the common grid on which solutions are interpolated."""

STEPS = 12
"""Interpolated phases from one solved phase to the next."""

CELL = 0.25e-3
"""Side of a cell of the map [m]."""

LOADED_FRACTION = 0.05
"""Pressure over the largest of the cycle above which a place counts as in contact."""

FAILURE = 0.2
"""Speed at which oil enters, over the mean entrainment, below which the entrainment fails."""

PITTED_AREA, PASSES = 1e-6, 1e7
"""Area [m2] whose probability of pitting is shown, after so many passes of the teeth."""

LEAST_PROBABILITY = 1e-9
"""Probability that counts as none."""

_MAXIMUM_FIELDS = (
    "pressure",
    "temperature_body_2",
    "temperature_middle",
    "asperity_pressure",
    "asperity_rubbing",
    "fatigue_ratio_body_2",
    "fatigue_risk_body_2",
)

_MINIMUM_FIELDS = ("film", "entry")


def flank_map(result: Result) -> "xr.Dataset | None":
    """Extremes over the mesh cycle on the wheel's flank; None without enough phases.

    Over (radius, face), NaN where no contact passed: pressure, and in the phases that simulated them
    temperature_body_2, temperature_middle, asperity_pressure and asperity_rubbing, or where a run had fatigue
    limits fatigue_ratio_body_2 and pitting_probability, their largest values (that of the whole flank is an
    attribute, by the area of its projection); film
    and entry, their least. `entry` is the speed at which oil entered over the mean entrainment [-],
    `asperity_rubbing` the asperities' pressure times the sliding [W/m2], by which wear goes.
    """
    solved = sorted(
        (
            solution
            for solution in result.solutions
            if solution.converged and "tooth_face" in solution.fields
        ),
        key=phase_of,
    )
    if len(solved) < FEWEST_PHASES:
        return None
    x, y = common_grid(solved)
    layers = [layer_of(solution, x, y) for solution in solved]
    face, radius = _axes(layers)
    loaded = LOADED_FRACTION * max(float(layer["pressure"].max()) for layer in layers)
    phases = [phase_of(solution) for solution in solved]
    unsolved = [phase_of(solution) for solution in result.unsound]
    extremes: dict[str, Array] = {}
    for held, names in _simulated(layers).items():
        without = [phase for phase, has in zip(phases, held, strict=True) if not has]
        pairs = _neighbours(
            [*compress(phases, held)], [*compress(layers, held)], unsolved + without
        )
        extremes |= _extremes(pairs, names, (radius, face), loaded)
    attributes = {}
    if "fatigue_risk_body_2" in extremes:
        risk = extremes.pop("fatigue_risk_body_2")
        extremes["pitting_probability"] = pitting_probability(risk * PITTED_AREA)
        whole_flank = np.sum(risk, where=np.isfinite(risk)) * CELL**2
        attributes["pitting_probability_of_flank"] = float(pitting_probability(whole_flank))
    on_tooth = _on_tooth(result, face, radius)
    return describe(
        xr.Dataset(
            {
                name: (("radius", "face"), np.where(on_tooth & np.isfinite(values), values, np.nan))
                for name, values in extremes.items()
            },
            coords={"radius": radius, "face": face},
            attrs=attributes,
        )
    )


THREAD_FIELDS = "fatigue_ratio_body_1", "fatigue_risk_body_1"
"""Fields of fatigue of the worm's thread."""


def thread_map(result: Result) -> "xr.Dataset | None":
    """Fatigue of the worm's thread over a mesh cycle; None without enough phases that have it.

    Over (thread_radius, thread_axial), NaN where no contact passed: fatigue_ratio_body_1 and
    pitting_probability, with that of the whole thread as an attribute, as on the wheel.
    """
    solved = sorted(
        (
            solution
            for solution in result.solutions
            if solution.converged and {"thread_axial", *THREAD_FIELDS} <= set(solution.fields)
        ),
        key=phase_of,
    )
    if len(solved) < FEWEST_PHASES:
        return None
    grid = common_grid(solved)
    layers = [_thread_layer(solution, *grid) for solution in solved]
    axial, radius = _axes(layers)
    loaded = LOADED_FRACTION * max(float(layer["pressure"].max()) for layer in layers)
    gaps = [phase_of(solution) for solution in result.unsound]
    pairs = _neighbours([phase_of(solution) for solution in solved], layers, gaps)
    extremes = _extremes(pairs, [*THREAD_FIELDS, "of_section"], (radius, axial), loaded)
    ratio, risk, of_section = (
        np.where(np.isfinite(values), values, np.nan) for values in extremes.values()
    )
    found = {
        "fatigue_ratio_body_1": ratio,
        "pitting_probability": pitting_probability(risk * PITTED_AREA),
    }
    whole_thread = float(pitting_probability(np.nansum(of_section) * CELL**2))
    return describe(
        xr.Dataset(
            {name: (("thread_radius", "thread_axial"), values) for name, values in found.items()},
            coords={"thread_radius": radius, "thread_axial": axial},
            attrs={"pitting_probability_of_thread": whole_thread},
        )
    )


def _thread_layer(solution: Solution, x: Array, y: Array) -> dict[str, Array]:
    """Fatigue of the worm and places of its thread on the common grid, (y, x)."""
    there = solution.fields[["pressure", *THREAD_FIELDS]].interp(x=x, y=y, assume_sorted=True)
    there = there.transpose("y", "x").fillna(0.0)
    at_x, at_y = np.meshgrid(x, y)
    places = flank_place(solution, at_x, at_y, ("thread_axial", "thread_radius"))
    layer = {name: there[name].values for name in ("pressure", *THREAD_FIELDS)}
    layer |= dict(zip(("face", "radius"), places, strict=True))
    (axial_y, axial_x), (radius_y, radius_x) = (np.gradient(place, y, x) for place in places)
    # the thread's area for each of that in the plane of both places, where it runs round the worm
    stretch = 1 / np.maximum(np.abs(axial_x * radius_y - axial_y * radius_x), MIN_FLOAT)
    layer["of_section"] = layer["fatigue_risk_body_1"] * stretch
    return layer


def pitting_probability(once: Array) -> Array:
    """Probability of pitting after `PASSES` by the risk of one pass; not a number where none passed."""
    found = failure_probability([(np.maximum(once, 0), PASSES)])
    rounded = np.where(found > LEAST_PROBABILITY, found, 0)
    return np.asarray(np.where(np.isfinite(once), rounded, np.nan))


def _simulated(layers: list[dict[str, Array]]) -> dict[tuple[bool, ...], list[str]]:
    """Fields of which extremes are kept, by the phases that simulated them: heat may be neglected in some."""
    found: dict[tuple[bool, ...], list[str]] = {}
    for name in (*_MAXIMUM_FIELDS, *_MINIMUM_FIELDS):
        held = tuple(name in layer for layer in layers)
        if any(held):
            found.setdefault(held, []).append(name)
    return found


def _extremes(
    pairs: Iterable[tuple[dict[str, Array], dict[str, Array]]],
    names: list[str],
    axes: tuple[Array, Array],
    loaded: float,
) -> dict[str, Array]:
    """Extremes of fields in each cell, (radius, face), between pairs of phases, over a pressure [Pa]."""
    radius, face = axes
    shape = len(radius), len(face)
    extremes = {
        name: np.full(shape, np.inf if name in _MINIMUM_FIELDS else -np.inf) for name in names
    }
    for before, after in pairs:
        for part in np.linspace(0, 1, STEPS + 1):
            now = {
                name: (1 - part) * before[name] + part * after[name]
                for name in {"pressure", "radius", "face", *names}
            }
            inside = now["pressure"] > loaded
            row = whole(np.rint((now["radius"][inside] - radius[0]) / CELL))
            column = whole(np.rint((now["face"][inside] - face[0]) / CELL))
            for name in names:
                keep = np.minimum if name in _MINIMUM_FIELDS else np.maximum
                keep.at(extremes[name], (row, column), now[name][inside])
    return extremes


def _on_tooth(result: Result, face: Array, radius: Array) -> Array:
    """Whether cells lie on the tooth, (radius, face), by the crossings of rays with its outline.

    Between phases a contact at the edge of a tooth is interpolated with places beyond it.
    """
    cycle = present(result.mesh_cycle, "a mesh cycle")
    rim = [cycle[name].values for name in ("rim_face", "rim_radius")]
    (x, y), (next_x, next_y) = rim, [np.roll(axis, -1) for axis in rim]
    face, radius = (axis[..., None] for axis in np.meshgrid(face, radius))
    spans = (y > radius) != (next_y > radius)
    with np.errstate(divide="ignore", invalid="ignore"):
        crossing = x + (radius - y) / (next_y - y) * (next_x - x)
    within = np.sum(spans & (face < crossing), axis=-1) % 2 == 1
    return scipy.ndimage.binary_dilation(within)  # cells that the outline passes through


def _neighbours(
    phases: list[float], layers: list[dict[str, Array]], gaps: list[float]
) -> Iterator[tuple[dict[str, Array], dict[str, Array]]]:
    """Phases between which fields are interpolated; each by itself where one between them has none."""
    for (first, before), (last, after) in pairwise(zip(phases, layers, strict=True)):
        if any(first < gap < last for gap in gaps):
            yield before, before
            yield after, after
        else:
            yield before, after
    if len(phases) == 1:
        yield layers[0], layers[0]


def common_grid(solved: list[Solution]) -> tuple[Array, Array]:
    """Nodes that span every solution's contact."""
    sides = []
    for axis, other, count in zip("xy", "yx", NODES, strict=True):
        ends = []
        for solution in solved:
            loaded = solution.fields[axis].values[
                (solution.fields["pressure"] > 0).any(other).values
            ]
            pressure = solution.fields["pressure"].max(other).sel({axis: loaded}).values
            inside = loaded[pressure > LOADED_FRACTION / 2 * pressure.max()]
            ends += [inside[0], inside[-1]]
        sides.append(np.linspace(min(ends), max(ends), count))
    return sides[0], sides[1]


def layer_of(solution: Solution, x: Array, y: Array) -> dict[str, Array]:
    """A solution's fields and places of the flank on the common grid, (y, x)."""
    fields = solution.fields
    names = [name for name in ("pressure", "film", *_MAXIMUM_FIELDS[1:]) if name in fields]
    film = fields["film"]
    # beyond the end of a flank its continuation comes close to the other one, or passes through it
    least = film.where(fields["covered"] == 1).min()
    given = fields[names].assign(film=film.where(film >= least, film.max()))
    there = given.interp(x=x, y=y, assume_sorted=True).transpose("y", "x")
    layer = {name: there[name].values for name in names}
    layer["pressure"] = np.nan_to_num(layer["pressure"])
    for name in names[1:]:  # outside a solution's window nothing is loaded
        layer[name] = np.where(np.isnan(layer[name]), np.nanmax(layer[name]), layer[name])
    if "asperity_pressure" in layer:
        sliding = fields[["sliding_x", "sliding_y"]].interp(x=x, y=y, assume_sorted=True)
        sliding = sliding.transpose("y", "x")
        speed = np.hypot(_filled(sliding["sliding_x"].values), _filled(sliding["sliding_y"].values))
        layer["asperity_rubbing"] = layer["asperity_pressure"] * speed
    layer["face"], layer["radius"] = flank_place(solution, *np.meshgrid(x, y))
    layer["entry"] = entry(solution, x, y)
    return layer


def _axes(layers: list[dict[str, Array]]) -> tuple[Array, Array]:
    axes = []
    for name in ("face", "radius"):
        low = min(float(layer[name].min()) for layer in layers)
        high = max(float(layer[name].max()) for layer in layers)
        axes.append(low + CELL * np.arange(np.ceil((high - low) / CELL) + 2))
    return axes[0], axes[1]


def entry(solution: Solution, x: Array, y: Array) -> Array:
    """Speed at which the oil of each node entered the contact, over the mean entrainment, (y, x).

    Oil is followed upstream along the entrainment to the outline of the dry contact; outside the value is 1.
    """
    fields = solution.fields[["dry_pressure", "entrainment_x", "entrainment_y"]]
    there = fields.interp(x=x, y=y, assume_sorted=True).transpose("y", "x")
    inside = np.nan_to_num(there["dry_pressure"].values) > 0
    dx, dy = x[1] - x[0], y[1] - y[0]
    u, v = (_filled(there[f"entrainment_{axis}"].values) for axis in "xy")
    speed = np.hypot(u, v)
    # the square of a dry pressure falls to zero linearly: its slope is square to the outline
    square = scipy.ndimage.gaussian_filter(
        np.nan_to_num(there["dry_pressure"].values) ** 2, SMOOTHING
    )
    normal_y, normal_x = np.gradient(square, dy, dx)
    inflow = (u * normal_x + v * normal_y) / np.maximum(np.hypot(normal_x, normal_y), MIN_FLOAT)
    within = inside.astype(float)
    result = np.ones(inside.shape)
    if not inside.any():
        return result
    result[inside] = 0.0
    nodes, place = np.flatnonzero(inside), np.array(np.nonzero(inside), float)
    steps = [v / dy, u / dx]
    longest = 0.5 / max(np.abs(step).max() for step in steps) * speed.max()
    steps = [longest * step / np.maximum(speed, MIN_SPEED_RATIO * speed.max()) for step in steps]
    inflow = np.maximum(inflow, 0.0) / speed[inside].mean()
    for _ in range(MOST_STEPS):
        place = place - np.array([_at(step, place) for step in steps])
        left = _at(within, place) >= 0.5
        result.flat[nodes[~left]] = _at(inflow, place[:, ~left])
        nodes, place = nodes[left], place[:, left]
        if not nodes.size:
            break
    return result


SMOOTHING = 2.0
"""Width [nodes] over which the outline of the dry contact is smoothed for its normal."""

MIN_FLOAT = np.finfo(float).tiny

MIN_SPEED_RATIO = 1e-3
"""Speed, over the largest, below which oil is followed as if it had that."""

MOST_STEPS = 4 * sum(NODES)
"""Largest number of half cells followed upstream; oil that is still inside then recirculates."""


def _at(field: Array, place: Array) -> Array:
    """Values of a field between nodes."""
    return scipy.ndimage.map_coordinates(field, place, order=1, mode="nearest")


def _filled(field: Array) -> Array:
    """A field with NaN replaced by the nearest value."""
    missing = np.isnan(field)
    if not missing.any():
        return field
    nearest = scipy.ndimage.distance_transform_edt(
        missing, return_distances=False, return_indices=True
    )
    return field[tuple(nearest)]
