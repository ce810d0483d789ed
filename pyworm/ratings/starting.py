"""Start of a worm gear set: breakaway, torque in cold oil, warming, and locking at rest and under vibration.

At rest teeth rub by the standard's static friction, and oil does not resist; at speed they rub as they run
warm, and cold oil resists by `pyworm.ratings.no_load`, fitted to the standard's churning at the sump's
temperature.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from math import pi

import numpy as np

from pyworm.case.ratings import StartingTable
from pyworm.drives.gear_unit import AMBIENT, HOUR, IRON_HEAT, OIL, GearUnit
from pyworm.drives.heat_network import HeatPath, ThermalNetwork, ThermalStep
from pyworm.drives.rotor import STEEL_DENSITY
from pyworm.formulas.unit_factors import SQUARE_MILLIMETRE, ZERO_CELSIUS
from pyworm.formulas.unknown import known
from pyworm.formulas.worm_curves import SLIDING_RANGE
from pyworm.formulas.worm_rating import WormRating
from pyworm.formulas.worm_standard import forward_efficiency
from pyworm.materials.library import NamedOil
from pyworm.ratings import no_load
from pyworm.ratings.no_load import NoLoad
from pyworm.ratings.rating import RatedFigure, Rating
from pyworm.ratings.worm_loads import RatedWormGear

LOCKED_BELOW, FREE_ABOVE = 0.45, 0.55
"""Efficiencies of a gearbox, worm driving, that lock for certain, and not at all [-] (SEVA-tec)."""

POUR_MARGIN = 5.0
"""Kelvin by which oil pours below the coldest start (Errichello)."""

PUMPABLE = 1e4
"""Kinematic viscosity up to which a bath reaches the teeth [mm2/s], from memory."""

SOURCE = f"friction and seals by the worm standard; cold oil: {no_load.SOURCE}"

RISEN = 0.632
"""Part of the rise of temperature by which times are given [-]: 1 - 1/e."""

MAX_WARMING_TIME = 200 * HOUR
"""Time in which a unit warms [s]."""


@dataclass(frozen=True)
class WormStart:
    """A start of a worm gear set."""

    gear_set: RatedWormGear
    """The gear set by the standards."""
    table: StartingTable
    """How it starts."""
    resistance: NoLoad
    """What its oil resists with, not yet fitted."""
    unit: GearUnit | None = None
    """Its thermal network, if the sizes of its housing are given."""

    @property
    def rated(self) -> WormRating:
        """Its rating under the largest load."""
        return self.gear_set.hardest.rated

    @property
    def oil(self) -> NamedOil:
        """Its oil."""
        return known(self.gear_set.oil)

    @property
    def speed(self) -> float:
        """Speed of the worm [rad/s]."""
        return self.rated.under.worm_speed

    @property
    def load(self) -> float:
        """Torque of the wheel over the ratio, that of the worm without losses [N m]."""
        return self.table.load_share * self.rated.under.torque / self.rated.gear.ratio

    @property
    def sump(self) -> float:
        """Temperature of the warm sump [K]."""
        return known(self.rated.under.sump_temperature)

    @cached_property
    def fitted(self) -> NoLoad:
        """Resistance of the oil with the standard's churning at the temperature of the sump."""
        return self.resistance.fitted(self.rated.standard_losses.churning, self.oil, self.sump)

    @property
    def dry(self) -> float:
        """Torque at the worm of loaded bearings and seals, which oil hardly changes [N m]."""
        losses = self.rated.standard_losses
        return (self.table.load_share * losses.bearings + losses.seals) / self.speed

    @property
    def breakaway(self) -> float:
        """Torque of the worm that starts it from rest [N m]."""
        rated = self.rated
        return self.load / forward_efficiency(rated.gear.tan_lead, rated.static_friction) + self.dry

    def running(self, temperature: float) -> float:
        """Torque of the worm at its speed, in oil of a temperature [K] [N m]."""
        resisted = self.fitted.torque(self.oil, temperature)
        return self.load / self.rated.forward_efficiency + self.dry + resisted

    @property
    def largest(self) -> float:
        """Largest torque of the start [N m]."""
        return max(self.breakaway, self.running(self.table.temperature))

    @property
    def held(self) -> float:
        """Torque of the worm that holds the wheel's torque at rest [N m]; below zero the teeth lock."""
        return self.load * self.rated.static_backward_efficiency - self.dry

    @property
    def creeping_margin(self) -> float:
        """mu/tan gamma of teeth that creep, at the least sliding speed of known friction [-]."""
        rated = self.rated
        slow = self.speed * SLIDING_RANGE[0] / rated.sliding_speed
        return WormRating(rated.gear, replace(rated.under, worm_speed=slow)).self_locking_margin

    @property
    def worm_inertia(self) -> float:
        """Moment of inertia of the worm without its motor [kg m2]: as long as the wheel is high."""
        gear = self.rated.gear
        return pi / 32 * STEEL_DENSITY * gear.wheel_tip_diameter * gear.worm_diameter**4

    def loss(self, temperature: float) -> float:
        """Loss of the unit at its speed, in oil of a temperature [K] [W]."""
        teeth = self.table.load_share * self.rated.teeth_loss.power
        return teeth + self.speed * (self.dry + self.fitted.torque(self.oil, temperature))

    @property
    def network(self) -> ThermalNetwork | None:
        """Thermal network of the start, with sizes of the housing or the mass of the unit; None without."""
        cold = self.table.temperature
        if self.unit is not None:
            return self.unit.starting_network(
                cold,
                self.table.load_share,
                lambda seats: self.speed * self.fitted.parts(self.oil, seats)["bearings"],
                lambda sump: self.speed * self.fitted.parts(self.oil, sump)["churning"],
            )
        if self.table.mass is None:
            return None
        excess = self.sump - self.gear_set.table.ambient_temperature
        if excess <= 0:
            raise ValueError("[starting]: the warm sump is no warmer than ambient_temperature")
        path = HeatPath("housing", OIL, AMBIENT, self.rated.loss / excess)
        return ThermalNetwork(
            {OIL: IRON_HEAT * self.table.mass},
            {AMBIENT: cold},
            [path],
            {OIL: lambda known: self.loss(known[OIL])},
        )


@dataclass(frozen=True)
class Warming:
    """Temperature of the oil after a start, in surroundings as cold."""

    after_hour: float
    """After an hour [K]."""
    balanced: float
    """In balance [K]."""
    time: float | None
    """Time in which `RISEN` of the rise is done [s]; None beyond `MAX_WARMING_TIME`."""


def warming(network: ThermalNetwork, cold: float) -> Warming:
    """How the oil of a network warms that starts at a temperature [K]; ValueError without a balance."""
    balanced = network.steady().temperatures[OIL]
    steps = [ThermalStep(HOUR), ThermalStep(MAX_WARMING_TIME - HOUR)]
    history = network.history(steps, cold)
    found = history.temperatures[OIL]
    wanted = cold + RISEN * (balanced - cold)
    time = float(np.interp(wanted, found, history.time)) if found[-1] > wanted else None
    return Warming(float(np.interp(HOUR, history.time, found)), balanced, time)


def rate_start(start: WormStart) -> Rating:
    """Torques of the start, warming and locking as a rating."""
    motor, largest = start.table.motor_torque, start.largest
    failed: tuple[str, ...] = ()
    if motor is not None and motor < largest:
        failed = (f"The motor does not start it: {motor:.4g} N m are less than {largest:.4g} N m.",)
    return Rating(
        key="starting",
        title="Starting",
        source=SOURCE,
        columns=("computed",),
        figures=tuple(_figures(start)),
        words=tuple(_words(start)),
        failed=failed,
    )


Row = tuple[str, str, float, str]
"""Key, label, value in the unit of the key, and shown unit of a figure."""


def _figures(start: WormStart) -> Iterator[RatedFigure]:
    for key, label, value, unit in (*_torques(start), *_warming(start), *_locks(start)):
        yield RatedFigure(key, label, (value,), unit)


def _torques(start: WormStart) -> Iterator[Row]:
    """Torques of the worm at breakaway and at speed."""
    cold, motor = start.table.temperature, start.table.motor_torque
    viscosity = float(start.oil.kinematic_viscosity(cold))
    parts = start.fitted.parts(start.oil, cold)
    yield "start_temperature_C", "Temperature at the start", cold - ZERO_CELSIUS, "°C"
    yield "start_viscosity_m2_s", "Kinematic viscosity at the start", viscosity, "mm²/s"
    yield "breakaway_friction", "Static tooth friction", start.rated.static_friction, ""
    yield "breakaway_torque_N_m", "Worm torque at breakaway", start.breakaway, "N m"
    yield "cold_torque_N_m", "Worm torque at speed, cold", start.running(cold), "N m"
    yield "cold_bearings_torque_N_m", "  of it oil in bearings", parts["bearings"], "N m"
    yield "cold_churning_torque_N_m", "  of it churning", parts["churning"], "N m"
    yield "warm_torque_N_m", "Worm torque at speed, warm", start.running(start.sump), "N m"
    if motor is not None:
        label = "Motor torque over largest torque of the start"
        yield "start_margin", label, motor / start.largest, ""


def _warming(start: WormStart) -> Iterator[Row]:
    """Temperatures of the oil after the start, where the mass is given."""
    network, cold = start.network, start.table.temperature
    if network is None:
        return
    found = warming(network, cold)
    balanced = found.balanced - ZERO_CELSIUS
    yield "oil_after_hour_C", "Oil after an hour", found.after_hour - ZERO_CELSIUS, "°C"
    yield "cold_sump_C", "Oil in balance, cold surroundings", balanced, "°C"
    if found.time is not None:
        label = f"Time for {100 * RISEN:.0f} % of the rise"
        yield "warming_time_h", label, found.time / HOUR, "h"


def _locks(start: WormStart) -> Iterator[Row]:
    """Margins of locking, and what holds or releases the teeth."""
    margin, held = start.rated.static_locking_margin, start.held
    yield "locking_rest", "mu/tan gamma at rest (teeth lock above 1)", margin, ""
    yield "locking_creeping", "mu/tan gamma creeping", start.creeping_margin, ""
    if held >= 0:
        yield "holding_torque_N_m", "Worm torque that holds the wheel at rest", held, "N m"
        return
    yield "releasing_torque_N_m", "Worm torque that releases the locked teeth", -held, "N m"
    yield (
        "releasing_acceleration_rad_s2",
        "Angular acceleration of the worm that releases them",
        -held / start.worm_inertia,
        "rad/s²",
    )


def _words(start: WormStart) -> Iterator[str]:
    share, factor = start.table.load_share, start.fitted.factor
    yield (
        f"{start.oil.name} as cold as the unit, {100 * share:.3g} % of the wheel's torque. Its pour point "
        f"should be {start.table.temperature - POUR_MARGIN - ZERO_CELSIUS:.0f} °C or lower (Errichello). At "
        f"{start.sump - ZERO_CELSIUS:.0f} °C the correlations of cold oil give {100 / factor:.0f} % of the "
        "standard's loss without load, to which they are fitted: their uncertainty. Tapered rollers may "
        "resist up to four times as much at rest (SKF)."
    )
    thick = float(start.oil.kinematic_viscosity(start.table.temperature)) / SQUARE_MILLIMETRE
    if thick > PUMPABLE:
        yield (
            f"Oil of {thick:.0f} mm²/s hardly flows to the mesh (above {PUMPABLE:.0f} mm²/s): warm it before."
        )
    yield _locking(start)


def _locking(start: WormStart) -> str:
    """What happens at rest, and when the locked teeth are shaken."""
    efficiency = start.rated.gearbox_efficiency
    bands = (
        f"By its efficiency of {100 * efficiency:.3g} % makers count it as "
        + (
            "self-locking"
            if efficiency < LOCKED_BELOW
            else "uncertain"
            if efficiency <= FREE_ABOVE
            else "not self-locking"
        )
        + f" (below {100 * LOCKED_BELOW:.0f} %, to {100 * FREE_ABOVE:.0f} %)."
    )
    if start.held >= 0:
        return (
            f"The teeth do not lock at rest: {start.held:.4g} N m at the worm have to hold the wheel. "
            f"{bands}"
        )
    caught = start.creeping_margin > 1
    after = (
        "creeping teeth rub enough to stop again, so that the load sinks by steps while it lasts"
        if caught
        else "creeping teeth rub too little to stop again: the load runs away"
    )
    return (
        "The teeth lock at rest. Vibration that turns the worm with more than the angular acceleration above "
        f"(the worm alone; a motor's inertia lowers it) lets them slip; {after}. {bands}"
    )
