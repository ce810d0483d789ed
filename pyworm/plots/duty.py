"""A duty of a gear unit: temperatures, loss and load over time, and the part of each block in damages."""

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.drives.gear_unit import AMBIENT, HOUR, OIL
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.plots.layout import add_grids, new_figure

if TYPE_CHECKING:
    from pyworm.batch.duty_run import CaseDuty

MAX_NAMED = 12
"""Largest number of blocks that are named."""


def draw_duty(found: "CaseDuty") -> Figure:
    """Temperatures, loss with load, and parts of the blocks, one above the other."""
    figure = new_figure(9.5, 9.0, f"{found.name} · duty of the gear unit")
    warm, power, parts = figure.subplots(3, 1, height_ratios=(1.5, 1, 1))
    _draw_temperatures(warm, found)
    _draw_loss(power, found)
    _draw_parts(parts, found)
    add_grids([warm, power])
    return figure


def _draw_temperatures(axes: Axes, found: "CaseDuty") -> None:
    history = found.model.history
    first, second = (rotor.name for rotor in found.model.base.rotors)
    for node, style in ((first, "-"), (second, "--"), (OIL, "-"), ("housing", "-"), (AMBIENT, ":")):
        axes.plot(history.time / HOUR, history.temperatures[node] - ZERO_CELSIUS, style, label=node)
    axes.set_ylabel("temperature / °C")
    axes.set_xlim(0, history.time[-1] / HOUR)
    axes.legend(
        frameon=False, fontsize="small", ncols=5, loc="lower center", bbox_to_anchor=(0.5, 1.0)
    )
    if len(found.blocks) > MAX_NAMED:
        return
    for number, block in enumerate(found.blocks):
        if number % 2:
            axes.axvspan(
                block.start / HOUR, (block.start + block.duration) / HOUR, color="0.93", zorder=0
            )


def _draw_loss(axes: Axes, found: "CaseDuty") -> None:
    """Loss of the unit, and the torque."""
    history = found.model.history
    time, power = history.time, np.diff(history.dissipated) / np.diff(history.time)
    axes.stairs(power, time / HOUR, color="tab:red", label="loss of the unit")
    axes.set_ylabel("loss / W", color="tab:red")
    axes.set_xlabel("time / h")
    axes.set_xlim(0, time[-1] / HOUR)
    axes.set_ylim(0, 1.1 * power.max())
    load = axes.twinx()
    edges = [block.start / HOUR for block in found.blocks] + [time[-1] / HOUR]
    torques = [block.torque if block.speed else 0.0 for block in found.blocks]
    load.stairs(torques, edges, color="0.4", linestyle="--")
    load.set_ylim(0, 1.3 * max(torques))
    load.set_ylabel(f"torque of the {found.model.base.rotors[1].name} / (N m)", color="0.4")


def _draw_parts(axes: Axes, found: "CaseDuty") -> None:
    """Part of each block in every damage and in the energy lost."""
    shares = found.shares
    names, begun = list(shares), np.zeros(len(shares))
    labels = [{"energy": "energy lost"}.get(what, what) for what in names]
    loads = {block.name: block for block in found.blocks}
    for number, (name, _) in enumerate(loads.items()):
        values = np.array(
            [
                sum(
                    part
                    for part, block in zip(shares[what], found.blocks, strict=True)
                    if block.name == name
                )
                for what in names
            ]
        )
        if not values.any():
            continue
        label = name if len(loads) <= MAX_NAMED else None
        axes.barh(labels, 100 * values, left=begun, label=label, color=f"C{number % 10}")
        begun += 100 * values
    axes.set_xlim(0, 100)
    axes.invert_yaxis()
    axes.set_xlabel("part of each block / %")
    if len(loads) <= MAX_NAMED:
        axes.legend(
            frameon=False, fontsize="small", ncols=6, loc="lower center", bbox_to_anchor=(0.5, 1.0)
        )
