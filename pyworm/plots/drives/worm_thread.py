"""Fatigue of the worm's thread over a mesh cycle."""

from matplotlib.figure import Figure

from pyworm.io.quantities import QUANTITIES
from pyworm.plots.layout import MILLI, broken, new_figure, result_heading
from pyworm.result.flank_map import thread_map
from pyworm.result.result import Result


def draw_thread(result: Result) -> Figure | None:
    """Fatigue ratio and probability of pitting on the worm's thread; None without fatigue of the worm."""
    field = thread_map(result)
    if field is None:
        return None
    names = [
        name for name in field.data_vars if name != "pitting_probability" or field[name].max() > 0
    ]
    figure = new_figure(6.5 * len(names), 3.4, result_heading(result, "worm thread"))
    panels = figure.subplots(1, len(names), squeeze=False).ravel()
    for panel, quantity in zip(panels, (QUANTITIES[str(name)] for name in names), strict=True):
        mesh = panel.pcolormesh(
            field["thread_axial"] * MILLI,
            field["thread_radius"] * MILLI,
            quantity.number(field[quantity.name]),
            cmap=quantity.colours,
            shading="nearest",
        )
        label = quantity.axis(quantity.worst(result.body_names))
        figure.colorbar(mesh, ax=panel, label=broken(label), shrink=0.8)
        if quantity.name == "pitting_probability":
            whole = quantity.number(field.attrs["pitting_probability_of_thread"])
            panel.set_title(f"of the whole thread: {whole:.3g} %", fontsize="medium")
        panel.set_aspect("equal")
        panel.set_xlabel("axial coordinate from the line of centres / mm")
        panel.set_ylabel("radius / mm")
    return figure
