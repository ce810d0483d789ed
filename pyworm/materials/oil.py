"""Oils as the kernel simulates them: laws of viscosity, density, flow and heat.

A constant that no oil has is refused with a ValueError when a law is made, since a solve with it may well
converge.
"""

from dataclasses import dataclass, replace
from math import exp, log
from typing import TYPE_CHECKING

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.formulas.ranges import positive, within
from pyworm.io import units
from pyworm.io.given import Given, WithUnit, in_si, kind_of, number, take
from pyworm.io.present import present
from pyworm.io.quantity_text import as_text
from pyworm.io.shown import Shown
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil_layer import OilLayer
from pyworm.materials.tabulated import Tabulated, TabulatedDensity, TabulatedViscosity
from pyworm.materials.thermal_properties import OilHeat
from pyworm.materials.viscosity_density import VISCOSITY_LAWS, Density, ViscosityLaw

BOUNDARY_FRICTION = 0.1
"""Friction coefficient of asperities in contact where none is given: that to which the worm standard's base
friction rises towards standstill, 0.094 to 0.1 (DIN 3996, bronze wheels; `formulas.worm_standard`)."""


SAME_WARMTH = 0.01
"""Largest difference of temperatures that count as one [K]."""


def require_kinds(name: str, law: object, *kinds: type) -> None:
    """Refuse a law that is not exactly one of these classes, such as one derived (ValueError)."""
    if type(law) not in kinds:
        known = " or ".join(kind.__name__ for kind in kinds if kind is not type(None))
        raise ValueError(
            f"{name} is a {type(law).__name__}: the kernel computes {known} from its constants, and would "
            f"ignore any other formula; give a {known} itself"
        )


def require_oil(oil: object) -> None:
    """Refuse what is no `Oil`, an oil over temperature among it; ValueError if it is of another class."""
    if isinstance(oil, Oil):
        require_kinds("oil", oil, Oil)
    elif callable(getattr(oil, "oil", None)):
        raise ValueError(
            f"oil is a {type(oil).__name__}, an oil over temperature: give it at that of the inlet, "
            'such as named_oil("PAO VG 220").oil("60 degC")'
        )
    else:
        raise ValueError(
            f"oil is a {type(oil).__name__}, {oil!r:.40}: must be an Oil, such as "
            'named_oil("PAO VG 220").oil("60 degC")'
        )


@dataclass(frozen=True, repr=False)
class Oil(Shown):
    """An oil as the kernel sees it.

    The kernel computes these laws itself, from their constants: a class derived from one of them, whose
    formula it would not use, is refused.
    """

    viscosity: ViscosityLaw | TabulatedViscosity
    """Viscosity against pressure at the inlet temperature."""
    density: Density | TabulatedDensity
    """Density against pressure at the inlet temperature."""
    flow: FlowLaw | None = None
    """How it shears under stress; None if nothing is known but its viscosity."""
    heat: OilHeat | None = None
    """How it takes heat; None where that is not known, and cannot be simulated."""
    supply: units.Film | OilLayer | None = None
    """Thickness of the inlet film of a contact, on both surfaces together [m], or its profile across
    the track; None where there is always enough."""
    boundary_friction: float = BOUNDARY_FRICTION
    """Friction coefficient of the bodies' asperities in contact under this oil [-]."""
    boundary_friction_spread: float | None = None
    """Relative uncertainty of that coefficient [-] where it was fitted to measured friction of such contacts,
    together with the law of contact of asperities; None where it is given."""
    alpha_spread: float = 0.0
    """Relative uncertainty of the pressure-viscosity coefficient [-]: its base stock's for an oil of the
    library, zero where it was measured."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI
        # fmt: off
        def __init__(
            self, viscosity: ViscosityLaw | TabulatedViscosity, density: Density | TabulatedDensity,
            flow: FlowLaw | None = ..., heat: OilHeat | None = ...,
            supply: WithUnit | OilLayer | None = ..., boundary_friction: float = ...,
            boundary_friction_spread: float | None = ..., alpha_spread: float = ...
        ) -> None: ...
        # fmt: on

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the oil in words, at its inlet temperature and ambient pressure."""
        law, heat = self.viscosity, self.heat
        return "Oil", {
            "viscosity": as_text(law.eta0, kind_of(units.Viscosity)),
            "alpha": as_text(law.alpha, kind_of(units.PressureViscosityOrZero)),
            "law": type(law).__name__,
            "density": as_text(self.density.rho0, kind_of(units.OilDensity)),
            **({} if self.flow is None else {"flow": self.flow.law}),
            **(
                {}
                if heat is None
                else {"inlet": as_text(heat.inlet_temperature, kind_of(units.Temperature))}
            ),
        }

    def __post_init__(self) -> None:
        """Refuse laws unknown to the kernel, and contradictory constants."""
        take(self, law=OilLayer)
        require_kinds("viscosity", self.viscosity, *VISCOSITY_LAWS, TabulatedViscosity)
        require_kinds("density", self.density, Density, TabulatedDensity)
        require_kinds("flow", self.flow, FlowLaw, type(None))
        require_kinds("heat", self.heat, OilHeat, type(None))
        for law in (self.viscosity, self.density):
            inlet = self.heat and self.heat.inlet_temperature
            if inlet and isinstance(law, Tabulated) and abs(law.reference - inlet) > SAME_WARMTH:
                raise ValueError(
                    f"a {type(law).__name__} is of {law.reference:g} K, but the oil enters at {inlet:g} K; "
                    "give both one temperature"
                )
        if isinstance(self.supply, float):
            positive("supply", self.supply, "m")
        positive("boundary_friction", self.boundary_friction, "")
        within("alpha_spread", self.alpha_spread, 0, 1, "")
        if self.boundary_friction_spread is not None:
            within("boundary_friction_spread", self.boundary_friction_spread, 0, 1, "")

    def layer_at(self, across: Given) -> Array:
        """Thickness of the inlet film at places across the entrainment [m], where it is limited."""
        across = in_si("across", across, units.Offset)
        if isinstance(self.supply, OilLayer):
            return self.supply.at(across)
        return np.full(np.shape(across), self.supply)

    def eta(self, pressure: WithUnit, rise: WithUnit = 0.0) -> float:
        """Viscosity [Pa s] at a pressure [Pa] and a temperature above the inlet's [K]."""
        pressure = in_si("pressure", pressure, units.PressureCoordinate)
        rise = in_si("rise", rise, units.TemperatureRise)
        if isinstance(self.viscosity, TabulatedViscosity):
            return float(self.viscosity(pressure, rise))
        if self.heat is None or rise == 0:
            eta: float = self.viscosity(pressure)
            return eta
        exponent = self.heat.viscosity_exponent
        law, inlet = self.viscosity, self.heat.inlet_temperature
        return law.THINNING.viscosity(law, pressure, rise, exponent, inlet)

    @property
    def thermal(self) -> OilHeat:
        """How an oil whose heat is simulated takes it; ValueError of one without `heat`."""
        return present(self.heat, "oil.heat")

    @property
    def sheared(self) -> FlowLaw:
        """How an oil whose friction is simulated shears; ValueError of one without `flow`."""
        return present(self.flow, "oil.shear")

    @property
    def beta(self) -> float:
        """Decay of the viscosity with temperature at the inlet, -d ln eta/dT [1/K]; of an oil with `heat`."""
        if isinstance(self.viscosity, TabulatedViscosity):
            return log(self.eta(0.0, -0.5) / self.eta(0.0, 0.5))
        law, heat = self.viscosity, self.thermal
        return law.THINNING.beta(law, heat.viscosity_exponent, heat.inlet_temperature)

    def with_(
        self,
        *,
        eta0: WithUnit | None = None,
        alpha: WithUnit | None = None,
        beta: WithUnit | None = None,
        rho0: WithUnit | None = None,
    ) -> "Oil":
        """The oil with one property of another size at the inlet, the others staying what they are.

        Exponents follow: Roelands' z keeps alpha where eta0 changes, his s0 keeps beta. A given alpha counts
        as measured, without `alpha_spread`.

        Args:
            eta0: Viscosity at ambient pressure [Pa s].
            alpha: Pressure-viscosity coefficient at ambient pressure [1/Pa].
            beta: Decay of the viscosity with temperature, -d ln eta/dT [1/K]; of an oil with heat.
            rho0: Density at ambient pressure [kg/m3].

        Raises:
            ValueError: A value that no oil has, an alpha of an isoviscous oil, or a beta of a table.
        """
        law, density, spread = self.viscosity, self.density, self.alpha_spread
        if eta0 is not None:
            law = law.with_eta0(eta0)
        if alpha is not None:
            wanted = number("alpha", alpha, kind_of(units.PressureViscosityOrZero))
            if not law.alpha > 0:
                raise ValueError(f"alpha = {wanted:g} 1/Pa: the oil is isoviscous; give it a law")
            law, spread = law.with_alpha_times(wanted / law.alpha), 0.0
        if rho0 is not None:
            density = density.with_rho0(rho0)
        heat = self._heat_of(law, beta)
        return replace(self, viscosity=law, density=density, heat=heat, alpha_spread=spread)

    def _heat_of(
        self, law: ViscosityLaw | TabulatedViscosity, beta: WithUnit | None
    ) -> OilHeat | None:
        """Thermal properties of an oil of another law, by default with the same beta."""
        heat = self.heat
        if beta is not None and (heat is None or isinstance(law, TabulatedViscosity)):
            raise ValueError("beta: the oil has no heat, or a table that has its own")
        if heat is None or isinstance(law, TabulatedViscosity):
            return heat
        if beta is None and law.eta0 == self.viscosity.eta0:
            return heat
        kept = self.beta if beta is None else in_si("beta", beta, units.TemperatureCoefficient)
        exponent = law.THINNING.exponent(law, kept, heat.inlet_temperature)
        return replace(heat, viscosity_exponent=exponent)

    def warmed(self, rise: WithUnit) -> "Oil":
        """The oil at an inlet temperature higher by some kelvin, by its own laws.

        Roelands: ln eta + 9.67 falls as the distance from the pole of temperature to the power -s0, at every
        pressure, so that z stays what it is. Density and heat capacity follow their laws at ambient pressure.
        """
        rise = in_si("rise", rise, units.TemperatureRise)
        heat = self.thermal
        thinner: ViscosityLaw | TabulatedViscosity
        if isinstance(self.viscosity, TabulatedViscosity):
            thinner = self.viscosity.at(self.viscosity.reference + rise)
        else:
            thinner = replace(self.viscosity, eta0=self.eta(0.0, rise))
        lighter = 1 - heat.expansivity * rise
        density: Density | TabulatedDensity
        if isinstance(self.density, TabulatedDensity):
            density = self.density.at(self.density.reference + rise)
        else:
            density = replace(self.density, rho0=self.density.rho0 * lighter)
        held = 1 + heat.heat_capacity_b0 * rise
        flow = self.flow and replace(
            self.flow, stress=self.flow.stress * exp(-self.flow.stress_temperature * rise)
        )
        return replace(
            self,
            viscosity=thinner,
            density=density,
            flow=flow,
            heat=replace(
                heat,
                inlet_temperature=heat.inlet_temperature + rise,
                specific_heat=heat.specific_heat * held / lighter,
                heat_capacity_b0=heat.heat_capacity_b0 / held,
                expansivity=heat.expansivity / lighter,
            ),
        )
