"""Thermal network: nodes of one temperature each, heat paths between them, sources of heat.

Steady, the heat that flows into each free node is zero; in time it warms the node's heat capacity
(lumped capacities: Incropera et al. 2011, chapter 5). Conductances may depend on both ends' temperatures.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy

Array = np.ndarray

Conductance = float | Callable[[float, float], float]
"""Conductance of a path [W/K], a number or a function of the temperatures of its ends [K]."""

MAX_IMBALANCE = 1e-6
"""Largest imbalance of a steady network, relative to the heat of its sources [-]."""

FIRST_EXCESS = 30.0
"""Excess over the coldest fixed node at which conductances are taken first [K]."""

TIME_TOLERANCE = 1e-7
"""Relative error of temperatures in a step of time [-]."""


@dataclass(frozen=True)
class HeatPath:
    """A path by which heat flows from one node to another."""

    name: str
    """What carries the heat: "free convection"."""
    first: str
    """Node from which the flow counts as positive."""
    second: str
    """Node to which it flows."""
    conductance: Conductance
    """Conductance while the unit runs [W/K]."""
    at_rest: Conductance | None = None
    """Conductance while it stands still [W/K]; None: the same."""
    factor: float = 1.0
    """Factor of both [-]."""

    def flow(self, first: float, second: float, running: bool = True) -> float:
        """Heat from the first node to the second at their temperatures [W]."""
        conductance = self.conductance
        if not running and self.at_rest is not None:
            conductance = self.at_rest
        found = conductance(first, second) if callable(conductance) else conductance
        return self.factor * found * (first - second)


@dataclass(frozen=True)
class HeatState:
    """Temperatures and heat flows of a network in balance."""

    temperatures: dict[str, float]
    """Node -> temperature [K], fixed ones too."""
    flows: tuple[tuple[HeatPath, float], ...]
    """Each path and the heat that flows along it [W]."""
    sources: dict[str, float]
    """Node -> heat set free in it [W]."""
    given_off: float
    """Heat that all fixed nodes take [W]."""

    @property
    def power(self) -> float:
        """Heat of all sources [W]."""
        return sum(self.sources.values())

    @property
    def imbalance(self) -> float:
        """Heat of the sources less that given off, over the former [-]."""
        return (self.power - self.given_off) / self.power if self.power else 0.0


@dataclass(frozen=True)
class ThermalStep:
    """A span of time in which the unit runs or stands still."""

    duration: float
    """Length [s]."""
    running: bool = True
    """Whether sources heat and turning parts stir."""


@dataclass(frozen=True)
class TemperatureHistory:
    """Temperatures of a network over time."""

    time: Array
    """Times from the start, (times,) [s]."""
    temperatures: dict[str, Array]
    """Node -> temperatures, (times,) [K], fixed nodes too."""
    stored: float
    """Heat that the nodes took up from start to end [J]."""
    supplied: float
    """Heat of the sources less that given off from start to end [J]."""


@dataclass(frozen=True)
class ThermalNetwork:
    """A thermal network; ValueError where a node has no path to a fixed one, or is not in the network."""

    capacities: Mapping[str, float]
    """Free node -> heat capacity [J/K]."""
    fixed: Mapping[str, float]
    """Node whose temperature is given -> temperature [K]."""
    paths: Sequence[HeatPath]
    """Paths of heat."""
    sources: Mapping[str, float]
    """Free node -> heat set free in it while the unit runs [W]."""

    def __post_init__(self) -> None:
        unknown = {end for path in self.paths for end in (path.first, path.second)} | {
            *self.sources
        }
        for node in sorted(unknown - {*self.capacities, *self.fixed}):
            raise ValueError(f"{node}: is no node of the network")
        reached, grows = {*self.fixed}, True
        while grows:
            more = {
                end
                for path in self.paths
                if {path.first, path.second} & reached
                for end in (path.first, path.second)
            }
            grows = not more <= reached
            reached |= more
        for node in self.capacities:
            if node not in reached:
                raise ValueError(f"{node}: has no path to a node of given temperature")

    @cached_property
    def _nodes(self) -> dict[str, int]:
        return {node: number for number, node in enumerate(self.capacities)}

    def _temperatures(self, free: Array, fixed: Mapping[str, float]) -> dict[str, float]:
        return {**dict(zip(self._nodes, free.tolist(), strict=True)), **fixed}

    def _flows(self, free: Array, fixed: Mapping[str, float], running: bool) -> list[float]:
        known = self._temperatures(free, fixed)
        return [path.flow(known[path.first], known[path.second], running) for path in self.paths]

    def _heating(self, free: Array, fixed: Mapping[str, float], running: bool) -> Array:
        """Heat that each free node takes up [W]."""
        taken = np.zeros(len(self._nodes))
        for node, power in self.sources.items() if running else ():
            taken[self._nodes[node]] += power
        for path, flow in zip(self.paths, self._flows(free, fixed, running), strict=True):
            for node, sign in ((path.first, -1.0), (path.second, 1.0)):
                if node in self._nodes:
                    taken[self._nodes[node]] += sign * flow
        return taken

    def steady(self) -> HeatState:
        """The network in balance; ValueError where its balance does not close to `MAX_IMBALANCE`."""
        scale = max(sum(map(abs, self.sources.values())), 1.0)
        start = np.full(len(self._nodes), min(self.fixed.values()) + FIRST_EXCESS)
        found = scipy.optimize.root(
            lambda free: self._heating(free, self.fixed, True) / scale,
            start,
            method="hybr",
            options={"xtol": 1e-13},
        )
        missing = float(np.max(np.abs(self._heating(found.x, self.fixed, True)), initial=0.0))
        if not missing <= MAX_IMBALANCE * scale:
            raise ValueError(
                f"the heat balance does not close: {missing:.3g} W of {scale:.4g} W remain"
            )
        flows = self._flows(found.x, self.fixed, True)
        given = sum(
            flow if path.second in self.fixed else -flow
            for path, flow in zip(self.paths, flows, strict=True)
            if (path.first in self.fixed) != (path.second in self.fixed)
        )
        return HeatState(
            self._temperatures(found.x, self.fixed),
            tuple(zip(self.paths, flows, strict=True)),
            dict(self.sources),
            given,
        )

    def history(
        self,
        steps: Sequence[ThermalStep],
        start: Mapping[str, float] | float,
        swings: Mapping[str, Callable[[float], float]] | None = None,
        points: int = 200,
    ) -> TemperatureHistory:
        """Temperatures over time from those at the start [K], one for all nodes or one for each.

        `swings` gives fixed nodes a temperature over time [s] -> [K] instead; each step has `points` times.
        ValueError where the equations cannot be integrated.
        """
        if isinstance(start, Mapping):
            free = np.array([start[node] for node in self._nodes])
        else:
            free = np.full(len(self._nodes), start)
        moved = {node: _constant(value) for node, value in self.fixed.items()} | {**(swings or {})}
        held = np.array([*self.capacities.values()])
        times, states, supplied, begun, first = [np.zeros(1)], [free[:, None]], 0.0, 0.0, free

        def rates(time: float, state: Array, running: bool) -> Array:
            fixed = {node: ambient(time) for node, ambient in moved.items()}
            heating = self._heating(state[:-1], fixed, running)
            return np.append(heating / held, heating.sum())

        for step in steps:
            span = begun, begun + step.duration
            found = scipy.integrate.solve_ivp(
                rates,
                span,
                np.append(free, supplied),
                method="LSODA",
                t_eval=np.linspace(*span, points)[1:],
                args=(step.running,),
                rtol=TIME_TOLERANCE,
                atol=1e-6,
                max_step=step.duration / 20,
            )
            if not found.success:
                raise ValueError(f"temperatures over time: {found.message}")
            times.append(found.t)
            states.append(found.y[:-1])
            free, supplied, begun = found.y[:-1, -1], float(found.y[-1, -1]), span[1]
        time, values = np.concatenate(times), np.concatenate(states, axis=1)
        known = {node: values[number] for node, number in self._nodes.items()}
        known |= {
            node: np.array([ambient(when) for when in time]) for node, ambient in moved.items()
        }
        return TemperatureHistory(time, known, float(held @ (free - first)), supplied)


def _constant(value: float) -> Callable[[float], float]:
    return lambda time: value
