"""The contacts of a result on reduced grids, for the page."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import QUANTITIES, listed
from pyworm.plots.layout import MILLI, contact_window
from pyworm.plots.overlays import dry_outline
from pyworm.report.explore.colours import FIELDS
from pyworm.report.explore.packed import packed
from pyworm.report.page.figures import load_of, place_of
from pyworm.result.accuracy import accuracy_words
from pyworm.result.mesh_cycle import flank_place
from pyworm.result.result import Result
from pyworm.solver.solution import Solution

NODES = 160, 80
"""Maximum number of nodes along x and y that a field keeps on the page."""

LINE_NODES = 1000
"""Maximum number of nodes that a field of a line contact keeps on the page."""

VECTORS = {
    "shear_stress": ("shear_stress_x", "shear_stress_y"),
    "sliding": ("sliding_x", "sliding_y"),
}
"""Length of a vector -> its components."""


def scenes(result: Result, grids: "Sequence[xr.Dataset]") -> list[dict[str, Any]]:
    """Every contact by its `reduced` fields: its name, figures, grid and fields."""
    pairs = zip(result.solutions, grids, strict=True)
    return [_scene(solution, grid, result.body_names) for solution, grid in pairs]


def _scene(solution: Solution, grid: "xr.Dataset", bodies: tuple[str, str]) -> dict[str, Any]:
    fields = {
        name: packed(QUANTITIES[name].number(values.astype(float)), QUANTITIES[name].logarithmic)
        for name, values in _values(grid, solution.kind).items()
    }
    figures = solution.figures
    return {
        "name": place_of(solution),
        "converged": solution.converged,
        "x": _axis(grid["x"].values),
        "y": _axis(grid["y"].values) if "y" in grid else None,
        "fields": fields,
        "outline": _outline(solution),
        "rows": [["Load", load_of(solution)], *scene_rows(solution, bodies)],
        "least": [MILLI * coordinate for coordinate in figures.film_min_at],
        "stopped": "" if solution.converged else solution.stop_reason,
    }


def _outline(solution: Solution) -> list[list[list[float]]]:
    """Lines of the boundary of the dry contact on the solution's own grid [mm]; none of a line contact."""
    if solution.kind == "line" or "dry_pressure" not in solution.fields:
        return []
    return [line.round(5).tolist() for line in dry_outline(solution.fields)]


def reduced(solution: Solution) -> "xr.Dataset":
    """The fields around the contact on no more than `NODES`, by interpolation, with places on the flank."""
    fields = solution.fields
    if solution.kind == "line":
        pressure = fields["pressure"].values
        loaded = fields["x"].values[pressure > 0.002 * pressure.max()]
        width = loaded[-1] - loaded[0]
        inside = fields.sel(x=slice(loaded[0] - 0.5 * width, loaded[-1] + 0.2 * width))
        x = np.linspace(
            float(inside["x"][0]), float(inside["x"][-1]), min(inside.sizes["x"], LINE_NODES)
        )
        return inside.interp(x=x, assume_sorted=True)
    window = contact_window(fields)
    sides = ((window.left, window.right), (window.bottom, window.top))
    places = {
        axis: np.linspace(
            max(low / MILLI, float(fields[axis][0])),
            min(high / MILLI, float(fields[axis][-1])),
            min(count, int(((fields[axis] >= low / MILLI) & (fields[axis] <= high / MILLI)).sum())),
        )
        for axis, (low, high), count in zip("xy", sides, NODES, strict=True)
    }
    names = [name for name in fields.data_vars if set(fields[name].dims) == {"x", "y"}]
    grid = fields[names].interp(places, assume_sorted=True).transpose("y", "x")
    if "tooth_face" in fields:
        face, radius = flank_place(solution, *np.meshgrid(places["x"], places["y"]))
        grid = grid.assign(face=(("y", "x"), face), radius=(("y", "x"), radius))
    return grid


def _values(grid: "xr.Dataset", kind: str) -> dict[str, np.ndarray]:
    """Fields shown, vectors by their lengths; a line contact has no components along y."""
    found = {}
    for name in FIELDS:
        parts = [part for part in VECTORS.get(name, (name,)) if part in grid]
        if parts and (kind == "line" or len(parts) == len(VECTORS.get(name, (name,)))):
            found[name] = (
                np.sqrt(sum(grid[part].values ** 2 for part in parts))
                if name in VECTORS
                else grid[name].values
            )
    return found


def _axis(values: np.ndarray) -> list[float]:
    """First and last place [mm] and their number."""
    return [float(values[0]) * MILLI, float(values[-1]) * MILLI, len(values)]


def scene_rows(solution: Solution, bodies: tuple[str, str]) -> list[list[str]]:
    """The figures in words."""
    rows = [
        [quantity.title(bodies), text]
        for quantity in listed("explore")
        if (text := solution.figure_text(quantity))
    ]
    wide = "" if solution.accurate else ", less accurate than requested"
    accuracy = accuracy_words(solution.accuracy, solution.accuracy_of)
    stated = [["Requested accuracy", accuracy]] if accuracy else []
    return [*rows, ["Converged", f"yes{wide}" if solution.converged else "NO"], *stated]
