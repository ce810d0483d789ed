"""Fields of a solution for other programs: comma-separated values, and VTK's image data."""

import csv
import os
from pathlib import Path

import numpy as np

from pyworm.io.atomic import whole_file
from pyworm.io.vtk import write_image
from pyworm.solver.solution import Solution


def require_solution(solution: object) -> None:
    """Refuse what is no solution; ValueError."""
    if not isinstance(solution, Solution):
        raise ValueError(
            f"solution is a {type(solution).__name__}: must be a Solution, as pyworm.solve gives it"
        )


def write_csv(solution: Solution, path: str | os.PathLike[str]) -> Path:
    """Write the fields of a solution as a table, a row for each node, units in brackets.

    Args:
        solution: Whose fields are written, x changing fastest.
        path: The file.
    """
    require_solution(solution)
    path, fields = Path(path), solution.fields
    grid = np.meshgrid(*(fields[axis].values for axis in _axes(solution)), indexing="ij")
    columns = dict(zip(_axes(solution), grid, strict=True))
    columns |= {str(name): fields[name].values for name in fields.data_vars}
    heads = [f"{name} [{fields[name].attrs['units']}]" for name in columns]
    with whole_file(path) as partial, partial.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(heads)
        rows = zip(*(values.ravel() for values in columns.values()), strict=True)
        writer.writerows([f"{number:.9g}" for number in row] for row in rows)
    return path


def write_vtk(solution: Solution, path: str | os.PathLike[str]) -> Path:
    """Write the fields of a solution as VTK image data (`.vti`), as ParaView and PyVista read them.

    Args:
        solution: Whose fields are written, each as data of the nodes, in SI.
        path: The file; its name must end in .vti.

    Raises:
        ValueError: Another ending.
    """
    require_solution(solution)
    path, fields = Path(path), solution.fields
    if path.suffix != ".vti":
        raise ValueError(f"{path.name}: VTK image data has names that end in .vti")
    axes = [fields[axis].values for axis in reversed(_axes(solution))]
    held = {str(name): fields[name].values for name in fields.data_vars}
    with whole_file(path) as partial:
        write_image(partial, axes, held, "pressure")
    return path


def _axes(solution: Solution) -> tuple[str, ...]:
    """Dimensions of the fields, the slowest first."""
    return ("y", "x") if solution.kind == "point" else ("x",)
