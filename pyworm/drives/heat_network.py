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

Source = float | Callable[[Mapping[str, float]], float]
"""Heat set free in a node [W], a number or a function of the temperatures of all nodes [K]."""

Swings = Mapping[str, Callable[[float], float]]
"""Fixed nodes -> temperature [K] over time [s]."""

MAX_IMBALANCE = 1e-6
"""Largest imbalance of a steady network, relative to the heat of its sources [-]."""

FIRST_EXCESS = 30.0
"""Excess over the coldest fixed node at which conductances are taken first [K]."""

PERIODIC = 1e-5
"""Largest difference of temperatures a period apart [K]."""

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
    network: "ThermalNetwork | None" = None
    """Network of the span, with the nodes of that whose history it is; None: that one."""
    swings: "Swings | None" = None
    """Fixed nodes whose temperature changes in the span; None: those of the history."""


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
    dissipated: Array
    """Heat of the sources from the start to each time, (times,) [J]."""


@dataclass(frozen=True)
class ThermalNetwork:
    """A thermal network; ValueError where a node has no path to a fixed one, or is not in the network."""

    capacities: Mapping[str, float]
    """Free node -> heat capacity [J/K]."""
    fixed: Mapping[str, float]
    """Node whose temperature is given -> temperature [K]."""
    paths: Sequence[HeatPath]
    """Paths of heat."""
    sources: Mapping[str, Source]
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

    @cached_property
    def _held(self) -> Array:
        """Heat capacity of each free node [J/K]."""
        return np.array([*self.capacities.values()])

    def _temperatures(self, free: Array, fixed: Mapping[str, float]) -> dict[str, float]:
        return {**dict(zip(self._nodes, free.tolist(), strict=True)), **fixed}

    def _powers(self, known: Mapping[str, float]) -> dict[str, float]:
        return {
            node: source(known) if callable(source) else source
            for node, source in self.sources.items()
        }

    def _flows(self, known: Mapping[str, float], running: bool) -> list[float]:
        return [path.flow(known[path.first], known[path.second], running) for path in self.paths]

    def _heating(
        self, known: Mapping[str, float], powers: Mapping[str, float], running: bool = True
    ) -> Array:
        """Heat that each free node takes up [W]."""
        taken = np.zeros(len(self._nodes))
        for node, power in powers.items():
            taken[self._nodes[node]] += power
        for path, flow in zip(self.paths, self._flows(known, running), strict=True):
            for node, sign in ((path.first, -1.0), (path.second, 1.0)):
                if node in self._nodes:
                    taken[self._nodes[node]] += sign * flow
        return taken

    def steady(self) -> HeatState:
        """The network in balance; ValueError where its balance does not close to `MAX_IMBALANCE`."""
        start = np.full(len(self._nodes), min(self.fixed.values()) + FIRST_EXCESS)
        at_start = self._powers(self._temperatures(start, self.fixed))
        scale = max(sum(map(abs, at_start.values())), 1.0)

        def heating(free: Array) -> Array:
            known = self._temperatures(free, self.fixed)
            return self._heating(known, self._powers(known))

        found = scipy.optimize.root(
            lambda free: heating(free) / scale,
            start,
            method="hybr",
            options={"xtol": 1e-13},
        )
        missing = float(np.max(np.abs(heating(found.x)), initial=0.0))
        if not missing <= MAX_IMBALANCE * scale:
            raise ValueError(
                f"the heat balance does not close: {missing:.3g} W of {scale:.4g} W remain"
            )
        known = self._temperatures(found.x, self.fixed)
        flows, powers = self._flows(known, True), self._powers(known)
        given = sum(
            flow if path.second in self.fixed else -flow
            for path, flow in zip(self.paths, flows, strict=True)
            if (path.first in self.fixed) != (path.second in self.fixed)
        )
        return HeatState(
            known,
            tuple(zip(self.paths, flows, strict=True)),
            powers,
            given,
        )

    def history(
        self,
        steps: Sequence[ThermalStep],
        start: Mapping[str, float] | float,
        swings: Swings | None = None,
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
        times, states, energies, begun, first = (
            [np.zeros(1)],
            [free[:, None]],
            np.zeros(2),
            0.0,
            free,
        )
        fixed_nodes, dissipated = [self._surroundings(0.0, swings)], [np.zeros(1)]

        for step in steps:
            span, network = (begun, begun + step.duration), step.network or self
            moved = swings if step.swings is None else step.swings
            found = scipy.integrate.solve_ivp(
                network._rates,
                span,
                np.append(free, energies),
                method="LSODA",
                t_eval=np.linspace(*span, points)[1:],
                args=(step.running, moved),
                rtol=TIME_TOLERANCE,
                atol=1e-6,
                max_step=step.duration / 20,
            )
            if not found.success:
                raise ValueError(f"temperatures over time: {found.message}")
            times.append(found.t)
            states.append(found.y[:-2])
            dissipated.append(found.y[-1])
            fixed_nodes += [network._surroundings(when, moved) for when in found.t]
            free, energies, begun = found.y[:-2, -1], found.y[-2:, -1], span[1]
        time, values = np.concatenate(times), np.concatenate(states, axis=1)
        known = {node: values[number] for node, number in self._nodes.items()}
        known |= {node: np.array([there[node] for there in fixed_nodes]) for node in self.fixed}
        stored = float(self._held @ (free - first))
        return TemperatureHistory(
            time, known, stored, float(energies[0]), np.concatenate(dissipated)
        )

    def periodic_start(
        self, steps: Sequence[ThermalStep], start: float, swings: Swings | None = None
    ) -> dict[str, float]:
        """Temperatures [K] to which the steps, repeated for ever, come back; sought from `start` on [K].

        Fixed-point iteration over whole periods, accelerated by Anderson's method. ValueError where it does
        not converge.
        """
        nodes = list(self._nodes)

        def change(free: Array) -> Array:
            given = dict(zip(nodes, free.tolist(), strict=True))
            after = self.history(steps, given, swings, points=2).temperatures
            return np.array([after[node][-1] for node in nodes]) - free

        try:
            found = scipy.optimize.anderson(
                change,
                np.full(len(nodes), start),
                alpha=1.0,
                f_tol=PERIODIC,
                line_search=None,
                maxiter=100,
            )
        except (scipy.optimize.NoConvergence, FloatingPointError) as error:
            raise ValueError("temperatures that come back after a period are not found") from error
        return dict(zip(nodes, np.asarray(found).tolist(), strict=True))

    def _surroundings(self, time: float, swings: Swings | None) -> dict[str, float]:
        """Temperatures of the fixed nodes at a time [K]."""
        return {**self.fixed, **{node: swing(time) for node, swing in (swings or {}).items()}}

    def _rates(
        self,
        time: float,
        state: Array,
        running: bool,
        swings: Swings | None,
    ) -> Array:
        """Rates of the free temperatures [K/s], of the heat that is stored and of that set free [W]."""
        known = self._temperatures(state[:-2], self._surroundings(time, swings))
        powers = self._powers(known) if running else {}
        heating = self._heating(known, powers, running)
        return np.append(heating / self._held, [heating.sum(), sum(powers.values())])
