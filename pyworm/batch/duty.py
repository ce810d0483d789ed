"""Duty of a gear unit: temperatures over time, losses, films, wear and damage of its blocks.

Losses between the teeth follow their temperature by closed forms (`pyworm.ratings.mesh_estimate`), or by a
table of solves; solves of some loads, at the temperatures found, correct them.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from math import ceil
from typing import Any

import numpy as np
import scipy

from pyworm.case.case import Case
from pyworm.case.ratings import RatedCase
from pyworm.drives.drive import Drive
from pyworm.drives.duty_cycle import DutyBlock, DutyCycle
from pyworm.drives.gear_unit import AMBIENT, FOUNDATION, HOUR, OIL, GearUnit
from pyworm.drives.heat_network import TemperatureHistory, ThermalStep
from pyworm.drives.other_losses import NonMeshLosses
from pyworm.drives.rotor import Rotor
from pyworm.formulas.whole_numbers import whole
from pyworm.io.input_error import CaseError
from pyworm.io.present import present
from pyworm.ratings.duty_damage import DutyDamage, HourlyDamage
from pyworm.ratings.mesh_estimate import MeshEstimate, MeshFriction
from pyworm.result.tabulated_loss import TabulatedLoss

Array = np.ndarray
Load = tuple[float, float]
"""Speed of the first shaft [rad/s] and torque of the second [N m]."""

HOTTEST = 423.15
"""Temperature of teeth up to which losses are tabulated [K]; hotter ones lose as much."""

COLDEST_MARGIN = 5.0
"""Range of these temperatures below the coldest surroundings [K]."""

TIMES, FEWEST_TIMES, MOST_TIMES = 3000, 4, 100
"""Times of all blocks together, and the least and most of each."""

PIECE, MOST_PIECES = 0.5, 6
"""Length [h] and largest number of the parts of a block that are rated at their mean temperatures."""


@dataclass(frozen=True)
class LoadState:
    """The gear unit at one load."""

    drive: Drive
    """The gears."""
    unit: GearUnit
    """Its thermal network, whose tooth loss follows the temperature."""
    friction: MeshFriction
    """Its mesh by closed forms."""

    def corrected(self, factor: float) -> "LoadState":
        """The state with its loss between the teeth times a factor."""
        tooth_loss = present(self.unit.tooth_loss_at, "tooth_loss_at")
        unit = replace(self.unit, tooth_loss_at=lambda known: factor * tooth_loss(known))
        return replace(self, unit=unit)


@dataclass(frozen=True)
class BlockFigures:
    """A block of a duty: means over its time where not said otherwise."""

    name: str
    """Name of the block."""
    start: float
    """Time at which it begins [s]."""
    duration: float
    """Length [s]."""
    torque: float
    """Torque of the wheel or gear [N m]."""
    speed: float
    """Speed of the worm or pinion [rad/s]."""
    temperatures: dict[str, float]
    """Node -> mean temperature [K]."""
    oil_max: float
    """Largest temperature of the oil [K]."""
    energy_lost: float
    """Energy lost [J]."""
    tooth_loss: float = 0.0
    """Loss between the teeth [W]."""
    friction: float = 0.0
    """Mean coefficient of friction of the teeth [-]."""
    film_min: float | None = None
    """Minimum film thickness [m]; None at rest."""
    specific_film: float | None = None
    """Minimum film thickness over composite roughness [-]."""
    asperity_load_fraction: float | None = None
    """Asperity load ratio [-]."""
    wear: Mapping[str, float] | None = None
    """Gear body -> wear depth [m]."""
    damage: Mapping[str, float] | None = None
    """What is damaged -> share of its life that the block takes once [-]."""
    not_rated: tuple[str, ...] = ()
    """What is not rated, each with the reason."""


@dataclass(frozen=True)
class DutyModel:
    """A case's duty with the gear unit at each of its loads."""

    case: Case
    """The case."""
    cycle: DutyCycle
    """Its blocks."""
    base: GearUnit
    """The unit at the case's own operating point."""
    loads: Mapping[Load, LoadState]
    """The unit at each load of a block that turns."""
    tabulated: bool = False
    """Whether teeth lose by a loss table, not by closed forms."""

    @property
    def steps(self) -> list[ThermalStep]:
        """Each block as a step of the thermal network."""
        return [self._step(block) for block in self.cycle.blocks]

    def _step(self, block: DutyBlock) -> ThermalStep:
        unit = self.loads[block.load].unit if block.running else self.base
        network = unit.network(fit=self.base.fit, ambient=block.ambient)
        swings = {AMBIENT: self.base.ambient_at} if block.ambient is None else {}
        return ThermalStep(block.duration, block.running, network, swings)

    @property
    def times_of_block(self) -> int:
        """Times of each block in the history."""
        return int(np.clip(TIMES // len(self.cycle.blocks), FEWEST_TIMES, MOST_TIMES))

    @cached_property
    def history(self) -> TemperatureHistory:
        """Temperatures over the duty; ValueError where they cannot be integrated."""
        steps, ambient = self.steps, self.coldest
        network = present(steps[0].network, "network")
        start: Mapping[str, float] | float = self.first_ambient
        if self.cycle.periodic:
            start = network.periodic_start(steps, ambient)
        return network.history(steps, start, points=self.times_of_block)

    @property
    def first_ambient(self) -> float:
        """Temperature of the surroundings at the start [K]."""
        given = self.cycle.blocks[0].ambient
        return self.base.ambient_at(0.0) if given is None else given

    @property
    def coldest(self) -> float:
        """Least temperature of the surroundings [K]."""
        return coldest_ambient(self.cycle, self.base)

    def blocks(self) -> Iterator[BlockFigures]:
        """The figures of each block."""
        rate, last, begun = DutyDamage(self.case), self.times_of_block - 1, 0.0
        for number, (block, name) in enumerate(
            zip(self.cycle.blocks, self.cycle.names, strict=True)
        ):
            span = slice(number * last, (number + 1) * last + 1)
            yield self._figures(block, name, begun, span, rate)
            begun += block.duration

    def _figures(
        self, block: DutyBlock, name: str, begun: float, span: slice, rate: DutyDamage
    ) -> BlockFigures:
        history = self.history
        time = history.time[span]
        nodes = {node: values[span].copy() for node, values in history.temperatures.items()}
        for node in (AMBIENT, FOUNDATION):
            nodes[node][0] = nodes[node][1]  # the first is that of the block before
        known: dict[str, Any] = {
            "name": name,
            "start": begun,
            "duration": block.duration,
            "torque": block.torque,
            "speed": block.speed,
            "temperatures": {node: _mean(time, values) for node, values in nodes.items()},
            "oil_max": float(nodes["oil"].max()),
            "energy_lost": float(history.dissipated[span][-1] - history.dissipated[span][0]),
        }
        if not block.running:
            return BlockFigures(**known)
        state = self.loads[block.load]
        count = min(max(ceil(block.duration / HOUR / PIECE), 1), MOST_PIECES, len(time) - 1)
        edges = whole(np.linspace(0, len(time) - 1, count + 1).round())
        pieces = []
        for first, end in pairwise(edges):
            part = slice(first, end + 1)
            warm = {node: _mean(time[part], values[part]) for node, values in nodes.items()}
            mesh = state.friction.at(mean_of_teeth(state.unit.rotors, warm))
            hours = float(time[end] - time[first]) / HOUR
            loss = present(state.unit.tooth_loss_at, "tooth_loss_at")(warm)
            pieces.append(_Piece(hours, loss, mesh, rate.hourly(state.drive, mesh, warm)))
        return BlockFigures(**known, **_of_pieces(pieces))


@dataclass(frozen=True)
class _Piece:
    """A part of a block at its mean temperatures."""

    hours: float
    tooth_loss: float
    mesh: MeshEstimate
    damage: HourlyDamage


def _of_pieces(pieces: Sequence[_Piece]) -> dict[str, Any]:
    """Figures of a block that turns, from its parts."""
    hours = np.array([piece.hours for piece in pieces])
    shares = hours / hours.sum()

    def mean(values: Sequence[float]) -> float:
        return float(shares @ np.array(values))

    def total(rates: Sequence[Mapping[str, float]]) -> dict[str, float]:
        return {
            key: float(hours @ np.array([rate[key] for rate in rates]))
            for key in rates[0]
            if all(key in rate for rate in rates)
        }

    meshes = [piece.mesh for piece in pieces]
    losses = [piece.tooth_loss for piece in pieces]
    # friction of a table or of solves is that of the closed forms by its loss
    frictions = [
        mesh.loss.friction * power / mesh.loss.loss
        for mesh, power in zip(meshes, losses, strict=True)
    ]
    return {
        "tooth_loss": mean(losses),
        "friction": mean(frictions),
        "film_min": mean([mesh.film_min for mesh in meshes]),
        "specific_film": mean([mesh.specific_film for mesh in meshes]),
        "asperity_load_fraction": mean([mesh.asperity_load_fraction for mesh in meshes]),
        "wear": total([piece.damage.wear for piece in pieces]),
        "not_rated": pieces[0].damage.not_rated,
        "damage": total([piece.damage.lives for piece in pieces]),
    }


def duty_model(case: Case, table: TabulatedLoss | None = None) -> DutyModel:
    """The duty of a case; CaseError of a case without one, or whose losses or temperatures are not found."""
    tables = case.tables
    if not isinstance(tables, RatedCase) or tables.duty is None:
        raise CaseError(f"{case.name}: has no [duty]")
    cycle, drive = tables.duty.cycle(case.directory), present(case.drive, "drive")
    try:
        base = tables.unit_of(drive)  # type: ignore[attr-defined]  # each that has [cooling]
        base.require_capacity()
        base = replace(base, rotors=sized(base.rotors, base.rotors))
        low = coldest_ambient(cycle, base) - COLDEST_MARGIN
        loads = {load: _at_load(case, base, load, low, table) for load in cycle.loads}
    except ValueError as error:
        raise CaseError(f"{case.name}: {error}") from error
    return DutyModel(case, cycle, base, loads, table is not None)


def coldest_ambient(cycle: DutyCycle, unit: GearUnit) -> float:
    """Least temperature of the surroundings in a duty [K]."""
    given = [block.ambient for block in cycle.blocks if block.ambient is not None]
    if len(given) < len(cycle.blocks):
        given.append(unit.cooling.ambient_temperature - unit.cooling.ambient_swing)
    return min(given)


def _at_load(
    case: Case, base: GearUnit, load: Load, low: float, table: TabulatedLoss | None
) -> LoadState:
    """The unit at a load, its tooth loss over the temperature from `low` on [K]."""
    drive = present(case.drive, "drive").at_load(*load)
    friction = MeshFriction(drive, case.places())
    rotors = present(drive.rotors, "rotors")
    if table is None:
        curve = _interpolated(*friction.losses(low, HOTTEST))
        tooth_loss = lambda known: curve(mean_of_teeth(rotors, known))  # noqa: E731
    else:
        tooth_loss = lambda known: table.at(*load, known[OIL])  # noqa: E731
    unit = unit_at_load(case, base, drive)
    return LoadState(drive, replace(unit, tooth_loss_at=tooth_loss), friction)


def unit_at_load(case: Case, base: GearUnit, drive: Drive) -> GearUnit:
    """The thermal network of a drive at another load, with the shafts of its own.

    Given losses besides the teeth are taken in proportion to the speed.
    """
    unit = case.tables.unit_of(drive, base.tooth_loss)
    other = unit.cooling.other
    if other.standard is None:
        part = unit.rotors[0].speed / base.rotors[0].speed
        other = NonMeshLosses(given=part * base.cooling.other.given)
    cooling = replace(unit.cooling, other=other)
    return replace(unit, rotors=sized(unit.rotors, base.rotors), cooling=cooling)


def sized(rotors: tuple[Rotor, Rotor], base: tuple[Rotor, Rotor]) -> tuple[Rotor, Rotor]:
    """Rotors with shafts as thick as others, whatever their torque."""
    first, second = (
        replace(rotor, shaft=sized.shaft_diameter)
        for rotor, sized in zip(rotors, base, strict=True)
    )
    return first, second


def _interpolated(temperatures: Array, losses: Array) -> Callable[[float], float]:
    """Loss [W] over temperature [K], beyond the ends as there."""
    curve = scipy.interpolate.PchipInterpolator(temperatures, np.log(losses))
    low, high = float(temperatures[0]), float(temperatures[-1])
    return lambda temperature: float(np.exp(curve(min(max(temperature, low), high))))


def mean_of_teeth(rotors: tuple[Rotor, Rotor], temperatures: Mapping[str, float]) -> float:
    """Mean temperature of both gear bodies [K]."""
    first, second = (temperatures[rotor.name] for rotor in rotors)
    return (first + second) / 2


def _mean(time: Array, values: Array) -> float:
    """Mean over time."""
    return float(np.trapezoid(values, time) / (time[-1] - time[0]))
