"""Running-in of a gear unit: temperatures, asperity load ratio, roughness, with a programme and without."""

from typing import TYPE_CHECKING

from matplotlib.figure import Figure

from pyworm.drives.gear_unit import HOUR
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.quantities import QUANTITIES
from pyworm.plots.layout import MICRO, add_grids, new_figure

if TYPE_CHECKING:
    from pyworm.batch.running_in import RunningIn

COLOURS = {"programme": "tab:blue", "none": "tab:red"}
"""Course -> its colour."""


def draw_running_in(found: "RunningIn") -> Figure:
    """Temperatures, asperity load ratio and roughness, side by side."""
    figure = new_figure(11.5, 4.4, f"{found.name} · running-in")
    warm, borne, rough = figure.subplots(1, 3)
    for name, sequence in (("programme", found.programme), ("none", found.none)):
        hours = [state.time / HOUR for state in sequence.states]
        colour, words = COLOURS[name], f"{name}, " if name == "programme" else "no programme, "
        contact = [state.contact - ZERO_CELSIUS for state in sequence.states]
        warm.plot(hours, contact, color=colour, label=f"{words}contact")
        oil = [state.oil - ZERO_CELSIUS for state in sequence.states]
        warm.plot(hours, oil, "--", color=colour, label=f"{words}oil")
        share = [100 * state.asperity_load_fraction for state in sequence.states]
        borne.plot(hours, share, color=colour)
        for number, style in ((0, "-"), (1, "--")):
            values = [state.roughness[number] * MICRO for state in sequence.states]
            rough.plot(hours, values, style, color=colour, label=f"{words}{found.bodies[number]}")
    if found.scuffing_temperature is not None:
        limit = found.scuffing_temperature - ZERO_CELSIUS
        warm.axhline(limit, color="0.3", linestyle=":", label="scuffing temperature")
    warm.set_ylabel("temperature / °C")
    borne.set_ylabel(QUANTITIES["asperity_load_fraction"].axis())
    rough.set_ylabel("Rq / µm")
    for axes in (warm, borne, rough):
        axes.set_xlabel("time / h")
        axes.set_xlim(left=0)
    borne.set_ylim(0, 100)
    rough.set_ylim(bottom=0)
    warm.legend(frameon=False, fontsize="x-small")
    rough.legend(frameon=False, fontsize="x-small")
    add_grids([warm, borne, rough])
    return figure
