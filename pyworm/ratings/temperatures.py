"""Temperatures and heat flows of a gear unit in balance, by its thermal network."""

from collections.abc import Iterator
from typing import Any

from pyworm.drives.gear_unit import HOUR, GearUnit
from pyworm.drives.heat_network import TemperatureHistory
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.quantities import QUANTITIES
from pyworm.ratings.rating import RatedFigure, Rating

SOURCE = (
    "thermal network with conductances by published correlations (pyworm.formulas.heat_transfer)"
)

SHOWN_TIMES = 7
"""Number of times in the table of temperatures."""

GIVEN = "thermal network of gear bodies and oil in a housing of given conductance"


def rate_temperatures(unit: GearUnit) -> Rating:
    """Temperature of each node with its model uncertainty, and heat along each path."""
    by_sizes = unit.cooling.housing is not None
    return Rating(
        key="temperatures",
        title="Temperatures and heat flows",
        source=SOURCE if by_sizes else GIVEN,
        columns=("computed",),
        figures=tuple(_figures(unit)),
        words=tuple(_words(unit)),
    )


def _figures(unit: GearUnit) -> Iterator[RatedFigure]:
    state = unit.steady
    for node, temperature in state.temperatures.items():
        spread = unit.uncertainty[node]
        yield RatedFigure(
            f"{_key(node)}_temperature_C",
            f"Temperature, {node}",
            (temperature - ZERO_CELSIUS,),
            "°C",
            bars=((0.0, spread),) if spread else (),
        )
    for node, power in state.sources.items():
        yield RatedFigure(f"{_key(node)}_loss_W", f"Loss into {node}", (power,), "W")
    for path, flow in state.flows:
        first, second = path.first, path.second
        yield RatedFigure(
            f"heat_{_key(first)}_to_{_key(second)}_{_key(path.name)}_W",
            f"Heat from {first} to {second}, {path.name}",
            (flow,),
            "W",
        )
    yield RatedFigure(
        "conductance_W_K", "Loss over excess of oil above ambient", (unit.conductance,), "W/K"
    )
    yield RatedFigure(
        "imbalance", "Imbalance of the heat flows over the losses", (state.imbalance,), ""
    )


def rate_history(history: TemperatureHistory) -> Rating:
    """Temperature of each node at some times."""
    last = len(history.time) - 1
    shown = [number * last // (SHOWN_TIMES - 1) for number in range(SHOWN_TIMES)]
    return Rating(
        key="temperatures_over_time",
        title="Temperatures over time",
        source=SOURCE,
        columns=tuple(f"{history.time[number] / HOUR:.3g} h" for number in shown),
        figures=tuple(
            RatedFigure(
                f"{_key(node)}_temperature_C",
                node.capitalize(),
                tuple(float(values[number]) - ZERO_CELSIUS for number in shown),
                "°C",
            )
            for node, values in history.temperatures.items()
        ),
    )


def history_summary(history: TemperatureHistory) -> dict[str, Any]:
    """All times and temperatures as an object for JSON."""
    return {
        "time_h": (history.time / HOUR).tolist(),
        **{
            f"{_key(node)}_temperature_C": (values - ZERO_CELSIUS).tolist()
            for node, values in history.temperatures.items()
        },
        "heat_stored_J": history.stored,
        "heat_supplied_J": history.supplied,
    }


def _key(name: str) -> str:
    return name.replace(" ", "_")


def _words(unit: GearUnit) -> Iterator[str]:
    """Losses, and what the uncertainties hold."""
    yield f"Between the teeth {unit.tooth_loss:.4g} W are lost. {unit.cooling.other.words}"
    if unit.cooling.housing is None:
        yield "The conductance of the housing is as given; nothing is known of shafts, bearings and walls."
        return
    point = unit.cooling.measured
    if point is None:
        yield (
            "Model uncertainties are those of the correlations (95 %); a measured sump temperature in "
            "[cooling.measured] takes those of the housing's outside."
        )
        return
    yield (
        f"The conductance of the housing's outside is {unit.fit:.3g} times that of the correlations, by the "
        f"measured {QUANTITIES['sump_temperature'].text(point.sump_temperature)} at {point.loss:.4g} W."
    )
