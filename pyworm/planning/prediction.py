"""Prediction of a contact by closed forms, updated by solved figures.

Effects are judged by these numbers alone, so that they can be judged again from a solution. Friction and
temperatures are estimated together, since shear heats the oil and heat lowers its viscosity.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from math import cos, hypot, inf, log, pi, sin, sqrt
from typing import Any

import numpy as np
import scipy

from pyworm.formulas.film import LineGroups, PointGroups
from pyworm.formulas.regimes import LINE_MINIMUM, Regime
from pyworm.io.present import present
from pyworm.materials.body import Body
from pyworm.materials.flow_laws import NEWTONIAN, FlowLaw
from pyworm.materials.oil import Oil
from pyworm.scene.entrainment_continuation import with_auxiliary_entrainment
from pyworm.scene.life import Past
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.scene.scales import LINE_MEAN, POINT_MEAN, line_scales, scales

SOLID = 100.0
"""Limit of alpha p, beyond which no oil flows and exp(alpha p) is meaningless."""

HALVINGS = 10
"""Bisections of a transit time of oil, at whose begin the contact carries no load, for when it does."""

INLET_HEAT = 100.0
"""Heat of Poiseuille flow in the inlet, times h^2, over eta0 u^2."""


@dataclass(frozen=True)
class Prediction:
    """Lengths, pressures, films, friction and temperatures of a contact, predicted or solved."""

    scene: Scene | LineScene
    """The contact."""
    half_width: float
    """Half-width of the contact along the entrainment [m]."""
    half_length: float
    """Half-width of the contact across the entrainment [m]; infinite for a line."""
    mean_to_max: float
    """Ratio of mean to largest pressure [-]."""
    pressure_max: float
    """Largest pressure by Hertz, limited to `SOLID`; too high where a thick film spreads it [Pa]."""
    film_central: float
    """Central film [m]."""
    film_min: float
    """Minimum film [m]."""
    speed: float
    """Entrainment at the contact point [m/s]; for pure spin the mean entrainment about it."""
    sliding: float
    """Sliding at the contact point [m/s]."""
    velocities: tuple[float, float]
    """Speeds of the surfaces at the contact point [m/s]."""
    groups: PointGroups | LineGroups
    """Dimensionless groups along the entrainment."""
    regime: Regime
    """The regime of lubrication by closed forms, of smooth surfaces with enough oil."""
    supply_ratio: float = inf
    """Thickness of the oil that arrives over the flooded film [-]; infinite where there is always enough."""
    carried_by_heat: bool = False
    """Whether no film forms without heat."""
    work: float | None = None
    """Solved heat of shearing for each area [W/m2]; None before it is known."""
    rise_film: float | None = None
    """Solved largest temperature of the film above the inlet's [K]; None before it is known."""
    rise_bodies: float | None = None
    """Solved largest temperature of the warmer surface above the inlet's [K]; None before it is known."""

    @property
    def transit(self) -> float:
        """Transit time of oil through the middle of the contact [s]."""
        return 2 * self.half_width / self.speed

    @property
    def age(self) -> float:
        """Transit time, or time since the contact's mesh cycle began if that is less [s]."""
        return min(self.transit, present(self.scene.past, "past").seconds)

    @cached_property
    def before(self) -> "Prediction | None":
        """Prediction of the contact that time (`age`) ago, or of when it began to carry its load since then.

        None before the mesh cycle began.
        """
        if not self.age > 0:
            return None
        past = present(self.scene.past, "past")
        loaded = self.age if _carried_load(past, self.age) else _loaded_since(past, self.age)
        return predicted(past.before(loaded)) if loaded > 0 else None

    @property
    def oil(self) -> Oil:
        """The oil."""
        return self.scene.oil

    @property
    def pressure_mean(self) -> float:
        """Mean pressure [Pa]."""
        return self.mean_to_max * self.pressure_max

    @property
    def beta(self) -> float:
        """-d ln eta/dT at the mean pressure and the inlet's temperature [1/K]; 0 where it is unknown."""
        return -log(self.oil.eta(self.pressure_mean, 1.0) / self.oil.eta(self.pressure_mean))

    @property
    def inlet_beta(self) -> float:
        """-d ln eta/dT at ambient pressure and the inlet's temperature [1/K]; 0 where it is unknown."""
        return -log(self.oil.eta(0.0, 1.0) / self.oil.eta(0.0))

    def stress(self, flow: FlowLaw | None = None, rise: float = 0.0) -> float:
        """Shear stress by sliding at the mean pressure [Pa], of another flow law or a rise of the oil [K]."""
        law = flow or self.oil.flow or NEWTONIAN
        newtonian = self.oil.eta(self.pressure_mean, rise) * self.sliding / self.film_central
        return law.stress_at(newtonian, self.pressure_mean)

    def surface_rise(self, heat: float) -> float:
        """Largest temperature rise [K] of the surfaces by a heat flux [W/m2].

        A strip of half-width b that moves at Peclet numbers above a few warms by 2 q sqrt(2 b/(pi k rho c U))
        (Jaeger 1942; Carslaw and Jaeger 1959, section 10.7), a slower one by no more than 3 q b/(2 k). The
        heat is partitioned so that both surfaces are equally warm.
        """
        return heat / sum(1 / resistance for resistance in self._resistances)

    @property
    def _resistances(self) -> list[float]:
        return [
            _resistance(body, speed, self.half_width)
            for body, speed in zip(self.scene.bodies, self.velocities, strict=True)
        ]

    @property
    def wall_warmth(self) -> float:
        """Difference of ln eta between the surfaces if each took half of the heat [-]."""
        first, second = self._resistances
        return self.beta * self.heat / 2 * abs(first - second)

    def film_rise(self, heat: float) -> float:
        """Largest temperature rise [K] of the film above its walls by a heat flux [W/m2], q h/8k."""
        return heat * self.film_central / (8 * self._conductivity)

    @property
    def _conductivity(self) -> float:
        heat, p = self.oil.thermal, self.pressure_mean
        return heat.conductivity * (1 + heat.conductivity_c1 * p / (1 + heat.conductivity_c2 * p))

    def hot_stress(
        self, surfaces: bool = True, film: bool = True, flow: FlowLaw | None = None
    ) -> float:
        """Shear stress [Pa] of oil warmed by surfaces, film or both, consistent with its heat."""
        cold = self.stress(flow)
        if self.oil.heat is None or cold == 0:
            return cold

        def excess(stress: float) -> float:
            heat = stress * self.sliding
            rise = surfaces * self.surface_rise(heat) + film * self.film_rise(heat) * 2 / 3
            return stress - self.stress(flow, rise)

        if not excess(cold) > 0:
            return cold
        return float(scipy.optimize.brentq(excess, 0.0, cold, xtol=1e-6 * cold))

    @cached_property
    def own_hot_stress(self) -> float:
        """Shear stress [Pa] of the oil with its own flow law, warmed by surfaces and film."""
        return self.hot_stress()

    @property
    def heat(self) -> float:
        """Heat of shearing for each area [W/m2], solved or estimated."""
        return self.own_hot_stress * self.sliding if self.work is None else self.work

    @property
    def rolling_rise(self) -> float:
        """Temperature rise of the film by inlet flow and compression, without sliding [K].

        It is q h/8k of the heat of Poiseuille flow in the inlet, where the oil is several times as viscous as
        outside, and of compression, eps T u p/b.
        """
        heat = self.oil.thermal
        flow = INLET_HEAT * self.oil.viscosity.eta0 * self.speed**2
        compression = (
            heat.expansivity
            * heat.inlet_temperature
            * self.speed
            * self.pressure_max
            / self.half_width
            * self.film_central**2
        )
        return (flow + compression) / (8 * heat.conductivity)

    @property
    def rolling_warmth(self) -> float:
        """Decrease of ln eta by the rise of rolling [-]."""
        return self.beta * self.rolling_rise

    @property
    def bulk(self) -> float:
        """Largest difference between a body's bulk temperature and the inlet's [K]."""
        inlet = self.oil.thermal.inlet_temperature
        bulk = (present(body.bulk_temperature, "bulk_temperature") for body in self.scene.bodies)
        return max(abs(temperature - inlet) for temperature in bulk)

    @property
    def warmest(self) -> float:
        """Largest temperature above the inlet's [K], solved or estimated."""
        if self.rise_film is not None:
            return self.rise_film
        sheared = self.surface_rise(self.heat) + self.film_rise(self.heat)
        return self.bulk + self.rolling_rise + sheared

    @property
    def warmth(self) -> float:
        """Largest temperature rise relative to the reference of influences (`Influence`) [-]."""
        if self.oil.heat is None:
            return 0.0
        return min(1.0, self.warmest * self.inlet_beta)

    def updated(self, figures: Mapping[str, float]) -> "Prediction":
        """The prediction with solved figures (`solver.error_estimate`), by name, in place of closed forms."""
        changes: dict[str, Any] = {
            name: figures[name] for name in ("pressure_max", "film_central", "film_min")
        }
        if "friction_coefficient" in figures:
            friction = abs(figures["friction_coefficient"])
            changes["work"] = friction * self.pressure_mean * self.sliding
        if "temperature_max_film" in figures:
            inlet = self.scene.oil.thermal.inlet_temperature
            changes["rise_film"] = figures["temperature_max_film"] - inlet
            bodies = (figures[f"temperature_max_body_{number}"] for number in (1, 2))
            changes["rise_bodies"] = max(bodies) - inlet
        return replace(self, **changes)


def predicted(scene: Scene | LineScene) -> Prediction:
    """Predict a contact by closed forms; ValueError for a scene that `pyworm.scene.scales` refuses."""
    return _line(scene) if isinstance(scene, LineScene) else _point(scene)


def _flowing(pressure: float, oil: Oil) -> float:
    """A pressure [Pa], limited to the largest at which the oil flows (`SOLID`)."""
    alpha = oil.viscosity.alpha
    return min(pressure, SOLID / alpha) if alpha > 0 else pressure


def _resistance(body: Body, speed: float, half_width: float) -> float:
    """Temperature rise of a surface by a unit heat flux [m2 K/W]."""
    still = 1.5 * half_width / present(body.conductivity, "conductivity")
    if speed == 0:
        return still
    return min(still, 2 * sqrt(2 * half_width / (pi * body.thermal_inertia * speed)))


def _point(scene: Scene) -> Prediction:
    fed = with_auxiliary_entrainment(scene)
    size = scales(fed)
    origin = np.zeros(())
    ax, ay = size.hertz.semi_axis_x, size.hertz.semi_axis_y
    along, across = (
        1 / hypot(cos(angle) / ax, sin(angle) / ay) for angle in (size.angle, size.angle + pi / 2)
    )
    first, second = (
        hypot(*(float(part) for part in motion(origin, origin))) for motion in scene.motions
    )
    return Prediction(
        scene=scene,
        half_width=along,
        half_length=across,
        mean_to_max=POINT_MEAN,
        pressure_max=_flowing(size.hertz.pressure_max, scene.oil),
        film_central=size.open_film,
        film_min=size.least * size.open_film,
        speed=size.groups.speed
        * scene.reduced_modulus
        * size.groups.radius
        / scene.oil.viscosity.eta0,
        sliding=hypot(*(float(part) for part in scene.sliding(origin, origin))),
        velocities=(first, second),
        groups=size.groups,
        regime=size.regime,
        supply_ratio=size.supply_ratio,
        carried_by_heat=fed is not scene,
    )


def _line(scene: LineScene) -> Prediction:
    size = line_scales(scene)
    return Prediction(
        scene=scene,
        half_width=size.hertz.half_width,
        half_length=inf,
        mean_to_max=LINE_MEAN,
        pressure_max=_flowing(size.hertz.pressure_max, scene.oil),
        film_central=size.open_film,
        film_min=LINE_MINIMUM * size.open_film,
        speed=abs(scene.entrainment),
        sliding=abs(scene.sliding),
        velocities=(abs(scene.velocities[0]), abs(scene.velocities[1])),
        groups=size.groups,
        regime=size.regime,
        supply_ratio=size.supply_ratio,
    )


def _carried_load(past: Past[Any], ago: float) -> bool:
    """Whether a contact carried load some time ago [s]."""
    try:
        past.before(ago)
    except ValueError:
        return False
    return True


def _loaded_since(past: Past[Any], ago: float) -> float:
    """How long ago a contact began to carry its load that carried none some time ago [s]; 0 of the first."""
    loaded, empty = 0.0, ago
    for _ in range(HALVINGS):
        middle = (loaded + empty) / 2
        if _carried_load(past, middle):
            loaded = middle
        else:
            empty = middle
    return loaded
