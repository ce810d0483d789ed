"""The Newton steps of a solve as a dataset."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from pyworm.io.plain_dataset import PlainDataset, described
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.solver.newton import NewtonStep


def convergence_history(steps: Sequence[NewtonStep], grid: Grid | LineGrid) -> PlainDataset:
    """Over iteration: grid points along each direction of a grid, balances, GMRES iterations and work."""
    columns: dict[str, list[Any]] = {
        f"points_{axis}": [step.points[number] for step in steps]
        for number, axis in enumerate("xy"[: len(grid.shape)])
    }
    for name in ("residual", "load_error", "krylov"):
        columns[name] = [getattr(step, name) for step in steps]
    for name in steps[0].work if steps else ():
        columns[name] = [step.work[name] for step in steps]
    return described(
        {name: (("iteration",), np.array(values)) for name, values in columns.items()},
        {"iteration": (("iteration",), np.arange(len(steps)))},
    )
