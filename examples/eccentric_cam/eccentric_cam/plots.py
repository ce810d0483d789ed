"""Entrainment of an eccentric cam over a turn."""

from matplotlib.figure import Figure

from pyworm.plots.drives.picture import CyclePicture
from pyworm.plots.layout import new_figure, result_heading
from pyworm.result.result import Result


def draw_entrainment(result: Result) -> Figure:
    """Entrainment over phase, with the contacts solved."""
    figure = new_figure(6, 4, result_heading(result, "entrainment over a turn"))
    axes = figure.subplots()
    axes.plot(result.mesh_cycle["phase"], result.mesh_cycle["entrainment"])
    for solution in result.solutions:
        axes.axvline(solution.phase, color="0.8")
    axes.set_xlabel("phase")
    axes.set_ylabel("entrainment / (m/s)")
    return figure


CYCLE_PICTURES = {"entrainment": CyclePicture("Entrainment over a turn", draw_entrainment)}
"""File name -> picture of the mesh cycle."""
