"""Fields of a solution for other programs: comma-separated values, and VTK's image data."""

import csv
import os
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from pyworm.io.atomic import whole_file
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
    origin = [float(axis[0]) for axis in axes] + [0.0] * (3 - len(axes))
    spacing = [float(np.diff(axis).mean()) for axis in axes] + [1.0] * (3 - len(axes))
    extent = " ".join(f"0 {axis.size - 1}" for axis in axes) + " 0 0" * (3 - len(axes))
    arrays = "".join(_array(str(name), fields[name].values) for name in fields.data_vars)
    with whole_file(path) as partial:
        partial.write_text(
            '<?xml version="1.0"?>\n<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">\n'
            f'<ImageData WholeExtent="{extent}" Origin="{_numbers(origin)}" Spacing="{_numbers(spacing)}">\n'
            f'<Piece Extent="{extent}"><PointData Scalars="pressure">\n{arrays}</PointData></Piece>\n'
            "</ImageData></VTKFile>\n",
            encoding="utf-8",
        )
    return path


def _axes(solution: Solution) -> tuple[str, ...]:
    """Dimensions of the fields, the slowest first."""
    return ("y", "x") if solution.kind == "point" else ("x",)


def _array(name: str, values: np.ndarray) -> str:
    head = f'<DataArray type="Float64" Name="{name}" format="ascii">'
    return f"{head}\n{_numbers(values.ravel())}\n</DataArray>\n"


def _numbers(values: Iterable[float]) -> str:
    return " ".join(f"{float(value):.9g}" for value in values)
