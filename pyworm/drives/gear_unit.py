"""Thermal network of a gear unit: gear bodies, shafts, bearings, oil, housing, surroundings and foundation.

The loss between the teeth warms both gear bodies by halves, that of the bearings the bearings by halves, that
of the seals the first shaft, and churning the oil. Heat flows on

- from the gear bodies to the oil that stirs about them, and along the shafts to the bearings;
- from the oil to the walls, from the bearings to their seats, and from shaft ends, long fins, to the air;
- from the housing to the air by convection, to the room by radiation, to the foundation by its foot.

A unit of a given conductance has gear bodies and oil only. Correlations: `pyworm.formulas.heat_transfer`.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import cos, hypot, pi, radians, sin

import scipy

from pyworm.drives.cooling import Cooling, DriveTemperatures, HousingSizes
from pyworm.drives.heat_network import (
    HeatPath,
    HeatState,
    Source,
    TemperatureHistory,
    ThermalNetwork,
    ThermalStep,
)
from pyworm.drives.rotor import BEARING_OUTSIDE, STEEL_CONDUCTIVITY, Rotor
from pyworm.formulas import heat_transfer as ht
from pyworm.formulas import unit_losses as losses
from pyworm.formulas.no_load_torque import BATH_FACTORS, DippingBody, bearing_torque
from pyworm.formulas.worm_losses import OtherLosses
from pyworm.io.present import present
from pyworm.materials.oil import Oil

OIL, HOUSING, AMBIENT, FOUNDATION = "oil", "housing", "ambient", "foundation"

OTHER = "other losses"
"""Kind of the losses besides the teeth, among those of paths."""

HOUR, DAY = 3600.0, 86400.0
"""An hour and a day [s]."""

IRON_DENSITY, IRON_HEAT = 7200.0, 500.0
"""Density [kg/m3] and specific heat [J/(kg K)] of cast iron."""

USUAL_EXPANSIVITY = 7e-4
"""Thermal expansivity of an oil that is given without one [1/K], of mineral oils."""

PRESSURE_ANGLE = radians(20)
"""Pressure angle by which the loads of bearings follow from a torque [rad], usual."""

SPREADS = {
    "oil on gear body": ht.STIRRED_SPREAD,
    "shaft": 0.5,
    "bearing seats": ht.STIRRED_SPREAD,
    "shaft end": 0.5,
    "oil on walls": ht.STIRRED_SPREAD,
    "convection": ht.CONVECTION_SPREAD,
    "radiation": ht.RADIATION_SPREAD,
    "foot": 0.5,
}
"""Kind of path -> relative uncertainty of its conductance (95 %) [-]; those of sizes are assumed."""

OUTER = "shaft end", "convection", "radiation", "foot"
"""Kinds of paths that leave the unit, whose conductance a measured point fits."""

FIT_RANGE = 0.2, 5.0
"""Range in which the factor of these conductances is sought [-]."""

UNFIT = "no factor from 0.2 to 5 of the housing's conductance gives the measured sump temperature"


@dataclass(frozen=True)
class GearUnit:
    """A gear unit whose losses warm it."""

    rotors: tuple[Rotor, Rotor]
    """Gear bodies with their shafts."""
    oil: Oil
    """The oil, with its thermal constants."""
    cooling: Cooling
    """What cools the unit, and its losses besides the teeth."""
    tooth_loss: float
    """Loss between the teeth [W]."""
    to_oil: float | None = None
    """Conductance from each gear body to the oil [W/K]; None: that of discs that turn in oil."""
    tooth_loss_at: Callable[[Mapping[str, float]], float] | None = None
    """Loss between the teeth [W] by the temperatures of all nodes [K]; None: the same at any."""

    dips: tuple[float, float] | None = None
    """How deep both gear bodies dip into the oil [m]: losses besides the teeth follow its temperature."""

    def other_at(self, oil: float) -> OtherLosses:
        """Losses besides the teeth by closed forms at a temperature of the oil [K]."""
        fluid = self.fluid(oil)
        churning = bearings = seals = 0.0
        for rotor, dip in zip(self.rotors, present(self.dips, "dips"), strict=True):
            size = (1 + BEARING_OUTSIDE) / 2 * rotor.shaft_diameter
            load = 2 * rotor.torque / rotor.diameter / cos(PRESSURE_ANGLE)
            factor = BATH_FACTORS["tapered"]
            idle = 2 * bearing_torque(factor, size, fluid.viscosity, rotor.speed)
            bearings += rotor.speed * (idle + losses.bearing_load_torque(load, size))
            seals += losses.seal_loss(rotor.shaft_diameter, rotor.speed)
            share = losses.dipping_share(dip, rotor.diameter)
            body = DippingBody(rotor.diameter / 2, rotor.width, share)
            density = float(self.oil.density.rho0)
            churning += rotor.speed * body.torque(density, fluid.viscosity, rotor.speed)
        return OtherLosses(float(churning), float(bearings), seals)

    @property
    def loss(self) -> float:
        """Loss of the whole unit [W]."""
        return self.tooth_loss + self.cooling.other.power

    @cached_property
    def steady(self) -> HeatState:
        """Temperatures and heat flows in balance; ValueError where the balance does not close."""
        return self.network().steady()

    @cached_property
    def temperatures(self) -> DriveTemperatures:
        """Temperatures of sump and gear bodies in balance."""
        found = self.steady.temperatures
        first, second = (found[rotor.name] for rotor in self.rotors)
        return DriveTemperatures(found[OIL], (first, second))

    @property
    def conductance(self) -> float:
        """Loss over the excess of the oil above the surroundings [W/K]."""
        if self.cooling.conductance is not None:
            return self.cooling.conductance
        return self.loss / (self.temperatures.sump - self.cooling.ambient_temperature)

    @cached_property
    def uncertainty(self) -> dict[str, float]:
        """Node -> model uncertainty of its temperature (95 %) [K].

        By the spread of all conductances, and of losses besides the teeth by closed forms: each larger and
        smaller by its factor, of which the larger change counts.
        """
        middle = self.steady.temperatures
        spreads = {
            path.name: SPREADS[path.name] for path in self.network().paths if path.name in SPREADS
        }
        if self.dips is not None:
            spreads[OTHER] = losses.LOSS_SPREAD
        moved = [
            [
                self.network({kind: factor}).steady().temperatures
                for factor in (1 + spread, 1 / (1 + spread))
            ]
            for kind, spread in sorted(spreads.items())
        ]
        return {
            node: hypot(*(max(abs(other[node] - value) for other in both) for both in moved))
            for node, value in middle.items()
        }

    @cached_property
    def fit(self) -> float:
        """Factor of the housing's conductance that gives the measured point [-]; 1 without one."""
        return self._fit({})

    def network(
        self,
        factors: Mapping[str, float] | None = None,
        fit: float | None = None,
        ambient: float | None = None,
    ) -> ThermalNetwork:
        """The network, with factors of some kinds of paths; ValueError of a point that nothing fits.

        `fit` is a factor of the housing's conductance instead of its own, `ambient` a temperature [K].
        """
        factors = dict(factors or {})
        fit = self._fit(factors) if fit is None else fit
        ambient = self.cooling.ambient_temperature if ambient is None else ambient
        return self._network(factors, fit, ambient, 1.0)

    def starting_network(
        self,
        ambient: float,
        load_share: float,
        bearings: Callable[[float], float],
        churning: Callable[[float], float],
    ) -> ThermalNetwork:
        """The network in surroundings of a temperature [K], with losses that fall as the oil warms.

        `bearings` and `churning` give the losses without load [W] at the temperatures of the bearings and of
        the oil [K]; losses under load are a share of the warm ones. ValueError without sizes of the housing.
        """
        self.require_capacity()
        network = self.network(ambient=ambient)
        seats = [_bearings(rotor) for rotor in self.rotors]
        warm = self._sources()
        sources: dict[str, Source] = {**warm}
        sources |= {rotor.name: load_share * warm[rotor.name] for rotor in self.rotors}
        losses = self.cooling.other.standard
        loaded = 0.0 if losses is None else load_share * losses.bearings

        def of_seat(node: str) -> Source:
            return lambda known: (loaded + bearings(known[node])) / len(seats)

        sources |= {node: of_seat(node) for node in seats}
        sources[OIL] = lambda known: churning(known[OIL])
        return replace(network, sources=sources)

    def history(self, hours: Sequence[float]) -> TemperatureHistory:
        """Temperatures from a start as cold as the surroundings; ValueError without sizes of the housing.

        The unit runs for the first of the hours [h], stands still for the second, and so on. The surroundings
        start at their mean and are warmest after 6 h.
        """
        self.require_capacity()
        steps = [ThermalStep(HOUR * each, number % 2 == 0) for number, each in enumerate(hours)]
        mean = self.cooling.ambient_temperature
        return self.network().history(steps, mean, {AMBIENT: self.ambient_at})

    def require_capacity(self) -> None:
        """ValueError without sizes of the housing, whose heat capacity temperatures over time need."""
        if self.cooling.housing is None:
            raise ValueError("temperatures over time need [cooling.housing], for its heat capacity")

    def ambient_at(self, time: float) -> float:
        """Temperature of the surroundings [K] at a time of the day [s], warmest after 6 h."""
        mean, swing = self.cooling.ambient_temperature, self.cooling.ambient_swing
        return mean + swing * sin(2 * pi * time / DAY)

    def _fit(self, factors: Mapping[str, float]) -> float:
        """Factor of the outer conductances for the measured point [-]."""
        point = self.cooling.measured
        if point is None or self.cooling.housing is None:
            return 1.0

        def excess(factor: float) -> float:
            scale = point.loss / self.loss
            network = self._network(factors, factor, point.ambient_temperature, scale)
            return network.steady().temperatures[OIL] - point.sump_temperature

        low, high = FIT_RANGE
        if excess(low) < 0 or excess(high) > 0:
            raise ValueError(f"cooling.measured: {UNFIT}")
        return float(scipy.optimize.brentq(excess, low, high, xtol=1e-9))

    def _network(
        self, factors: Mapping[str, float], fit: float, ambient: float, scale: float
    ) -> ThermalNetwork:
        """The network for an ambient temperature [K] and losses of another scale [-]."""
        housing = self.cooling.housing
        fixed = {AMBIENT: ambient} | ({} if housing is None else {FOUNDATION: ambient})
        paths = [
            replace(path, factor=factors.get(path.name, 1.0) * (fit if path.name in OUTER else 1.0))
            for path in self._paths()
        ]
        sources: dict[str, Source] = {
            node: scale * power for node, power in self._sources().items()
        }
        if self.tooth_loss_at is not None:
            sources |= {rotor.name: self._tooth_source(scale) for rotor in self.rotors}
        if self.dips is not None:
            sources |= self._other_sources(scale * factors.get(OTHER, 1.0))
        return ThermalNetwork(self._capacities(), fixed, paths, sources)

    def _tooth_source(self, scale: float) -> Source:
        """Half of the loss between the teeth, as they are warm."""
        tooth_loss = present(self.tooth_loss_at, "tooth_loss_at")
        return lambda known: scale / 2 * tooth_loss(known)

    def _other_sources(self, scale: float) -> dict[str, Source]:
        """Node -> loss besides the teeth in it, as the oil is warm."""
        if self.cooling.housing is None:
            return {OIL: lambda known: scale * self.other_at(known[OIL]).power}

        def bearings(known: Mapping[str, float]) -> float:
            return scale / 2 * self.other_at(known[OIL]).bearings

        return {
            **{_bearings(rotor): bearings for rotor in self.rotors},
            _shaft(self.rotors[0]): lambda known: scale * self.other_at(known[OIL]).seals,
            OIL: lambda known: scale * self.other_at(known[OIL]).churning,
        }

    def _sources(self) -> dict[str, float]:
        """Node -> loss in it [W]."""
        found = {rotor.name: self.tooth_loss / 2 for rotor in self.rotors}
        other = self.cooling.other
        if self.cooling.housing is None or other.standard is None:
            return found | {OIL: other.power}
        by_standard = other.standard
        return {
            **found,
            **{_bearings(rotor): by_standard.bearings / 2 for rotor in self.rotors},
            _shaft(self.rotors[0]): by_standard.seals,
            OIL: by_standard.churning,
        }

    def _capacities(self) -> dict[str, float]:
        """Free node -> heat capacity [J/K]."""
        bodies = {rotor.name: rotor.capacity for rotor in self.rotors}
        housing = self.cooling.housing
        if housing is None:
            return bodies | {OIL: 1.0}
        volume = housing.oil_level * housing.height * housing.foot_print
        heat = present(self.oil.heat, "oil.heat")
        return {
            **bodies,
            **{_shaft(rotor): rotor.shaft_capacity for rotor in self.rotors},
            **{_bearings(rotor): rotor.bearing_capacity for rotor in self.rotors},
            OIL: self.oil.density.rho0 * heat.specific_heat * volume,
            HOUSING: IRON_DENSITY * IRON_HEAT * housing.hull * housing.wall,
        }

    def _paths(self) -> Iterator[HeatPath]:
        """All paths of heat."""
        for rotor in self.rotors:
            yield self._stirred(rotor)
        housing = self.cooling.housing
        if housing is None:
            given = present(self.cooling.conductance, "cooling.conductance")
            yield HeatPath("housing", OIL, AMBIENT, given)
            return
        for rotor in self.rotors:
            yield HeatPath("shaft", rotor.name, _shaft(rotor), rotor.along_shaft)
            inner, outer = ht.SEAT * rotor.inner_seats, ht.SEAT * rotor.outer_seats
            yield HeatPath("bearing seats", _shaft(rotor), _bearings(rotor), inner)
            yield HeatPath("bearing seats", _bearings(rotor), HOUSING, outer)
            yield HeatPath(
                "shaft end", _shaft(rotor), AMBIENT, _shaft_end(rotor, 1.0), _shaft_end(rotor, 0.0)
            )
        yield HeatPath(
            "oil on walls", OIL, HOUSING, ht.OIL_ON_WALLS * housing.hull, self._still_oil(housing)
        )
        yield HeatPath("convection", HOUSING, AMBIENT, _convection(housing))
        yield HeatPath("radiation", HOUSING, AMBIENT, _radiation(housing))
        area = housing.foot * housing.foot_print
        if area:
            foot = ht.spreading(housing.foundation_conductivity, area)
            yield HeatPath("foot", HOUSING, FOUNDATION, foot)

    def _stirred(self, rotor: Rotor) -> HeatPath:
        """From a gear body to the oil: it turns in it, or both are still."""

        def turning(body: float, oil: float) -> float:
            fluid = self.fluid((body + oil) / 2)
            return rotor.surface * ht.rotating_disc(fluid, rotor.speed)

        def still(body: float, oil: float) -> float:
            fluid = self.fluid((body + oil) / 2)
            return rotor.surface * ht.free_on_wall(fluid, rotor.diameter, body - oil)

        running = turning if self.to_oil is None else self.to_oil
        return HeatPath("oil on gear body", rotor.name, OIL, running, still)

    def _still_oil(self, housing: HousingSizes) -> Callable[[float, float], float]:
        """Conductance from still oil to the walls that it wets [W/K]."""
        depth = housing.oil_level * housing.height
        area = housing.foot_print + housing.oil_level * housing.sides

        def still(oil: float, wall: float) -> float:
            return area * ht.free_on_wall(self.fluid((oil + wall) / 2), depth, oil - wall)

        return still

    def fluid(self, temperature: float) -> ht.Fluid:
        """The oil at a temperature [K], at ambient pressure."""
        heat = present(self.oil.heat, "oil.heat")
        rise = temperature - heat.inlet_temperature
        density = self.oil.density.rho0 * (1 - heat.expansivity * rise)
        return ht.Fluid(
            heat.conductivity,
            self.oil.eta(0.0, rise) / density,
            heat.conductivity / (density * heat.specific_heat),
            heat.expansivity or USUAL_EXPANSIVITY,
        )


def _shaft(rotor: Rotor) -> str:
    return f"{rotor.name} shaft"


def _bearings(rotor: Rotor) -> str:
    return f"{rotor.name} bearings"


def _shaft_end(rotor: Rotor, turning: float) -> Callable[[float, float], float]:
    """Conductance of a shaft's end as a long fin in the air [W/K]; `turning` 1 while it does, 0 at rest."""
    diameter = rotor.shaft_diameter

    def end(shaft: float, ambient: float) -> float:
        fluid = ht.air((shaft + ambient) / 2)
        forced = ht.rotating_shaft(fluid, diameter, turning * rotor.speed)
        coefficient = ht.mixed(ht.free_on_wall(fluid, diameter, shaft - ambient), forced)
        return ht.long_fin(coefficient, STEEL_CONDUCTIVITY, diameter)

    return end


def _convection(housing: HousingSizes) -> Callable[[float, float], float]:
    """Conductance by free and forced convection of sides, top and the bottom without its foot [W/K]."""
    broad = housing.foot_print / (2 * (housing.length + housing.width))

    def convected(wall: float, ambient: float) -> float:
        fluid, excess = ht.air((wall + ambient) / 2), wall - ambient
        forced = ht.forced_along(fluid, housing.length, housing.air_velocity)
        return (
            housing.ribs
            * housing.sides
            * ht.mixed(ht.free_on_wall(fluid, housing.height, excess), forced)
            + housing.foot_print * ht.mixed(ht.free_on_top(fluid, broad, excess), forced)
            + (1 - housing.foot)
            * housing.foot_print
            * ht.mixed(ht.free_below(fluid, broad, excess), forced)
        )

    return convected


def _radiation(housing: HousingSizes) -> Callable[[float, float], float]:
    """Conductance by radiation of sides and top [W/K]; ribs radiate to each other."""
    seen = housing.sides + housing.foot_print
    return lambda wall, ambient: seen * ht.radiation(housing.emissivity, wall, ambient)
