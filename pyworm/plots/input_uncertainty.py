"""Standard uncertainties of results: by inputs, each with its share, by the model, and by the numbers."""

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.plots.layout import placed_panels
from pyworm.result.input_uncertainty import InputUncertainty, UncertainResult

BAR = 0.25
"""Height of a bar over the distance of two results."""

OTHERS = {"model": "0.45", "numbers": "0.75"}
"""Origin besides inputs -> its colour."""


def draw_input_uncertainty(found: InputUncertainty, case_name: str) -> Figure:
    """Bars in per cent of the result, of temperatures of its value in °C above 0 °C."""
    count = len(found.results)
    size, room = (10.5, 0.62 * count + 1.4), (3.3, 2.9, 0.6, 0.1)
    words = f"{case_name}  ·  standard uncertainty of the results"
    figure, (axes,) = placed_panels(size, words, room)
    colours = matplotlib.colormaps["viridis"](np.linspace(0.1, 0.9, len(found.inputs)))
    for place, each in enumerate(reversed(found.results)):
        _draw(axes, place, each, found.inputs, colours)
    names = [_named(each) for each in reversed(found.results)]
    axes.set_yticks(range(count), names)
    axes.set_xlabel("standard uncertainty / % of the result")
    axes.grid(True, axis="x", color="0.9")
    axes.set_axisbelow(True)
    handles, labels = axes.get_legend_handles_labels()
    once = dict(zip(labels, handles, strict=True))
    axes.legend(
        once.values(),
        once.keys(),
        frameon=False,
        fontsize="small",
        loc="upper left",
        bbox_to_anchor=(1.01, 1.0),
    )
    return figure


def _named(each: UncertainResult) -> str:
    return f"{each.quantity.words()}\n{each.quantity.text(each.value)}"


def _draw(
    axes: Axes, place: int, each: UncertainResult, inputs: tuple[str, ...], colours: np.ndarray
) -> None:
    """Up to three bars of a result; that of the inputs is divided by their shares in its variance."""
    quantity = each.quantity
    percent = 100 * quantity.scale / abs(quantity.number(each.value))
    left = 0.0
    for key, share, colour in zip(inputs, each.shares, colours, strict=True):
        width = each.inputs * percent * share
        axes.barh(place + BAR, width, BAR, left, color=colour, label=f"inputs: {key}")
        left += width
    for number, (name, width) in enumerate(zip(OTHERS, (each.model, each.numerical), strict=True)):
        if not width > 0:  # no part in the result, and none in the legend
            continue
        axes.barh(place - number * BAR, width * percent, BAR, color=OTHERS[name], label=name)
