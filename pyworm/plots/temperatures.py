"""Temperatures of a gear unit over time, and its heat flows in balance."""

from matplotlib.figure import Figure

from pyworm.drives.gear_unit import HOUR
from pyworm.drives.heat_network import HeatState, TemperatureHistory
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.plots.layout import add_grids, new_figure


def draw_temperatures(name: str, history: TemperatureHistory, state: HeatState) -> Figure:
    """Temperature of every node over time, and heat along every path in balance."""
    figure = new_figure(11.0, 4.8, f"{name} · temperatures of the gear unit")
    left, right = figure.subplots(1, 2)
    for number, (node, values) in enumerate(history.temperatures.items()):
        style = "--" if number % 2 else "-"
        left.plot(history.time / HOUR, values - ZERO_CELSIUS, style, label=node)
    left.set_xlabel("time / h")
    left.set_xlim(0, history.time[-1] / HOUR)
    left.set_ylabel("temperature / °C")
    left.legend(frameon=False, fontsize="x-small")
    labels = [f"{path.first} to {path.second}, {path.name}" for path, _ in state.flows]
    right.barh(range(len(labels)), [flow for _, flow in state.flows], color="tab:orange", zorder=2)
    right.set_yticks(range(len(labels)), labels, fontsize="x-small")
    right.invert_yaxis()
    right.set_xlabel("heat flow in balance / W")
    add_grids([left, right])
    return figure
