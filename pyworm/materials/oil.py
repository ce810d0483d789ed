"""Oils: viscosity and density under pressure and temperature, flow laws, thermal laws.

Two viscosity laws and one density law cover what the kernel simulates; the published variants of each
differ only in the constants that the constructors here fill in. A constant that no oil has is refused with a
ValueError when the law is made, since a solve with it may well converge.
"""

from dataclasses import dataclass, replace
from math import asinh, exp, expm1, inf, log, sinh
from typing import Any, Literal, get_args

import numpy as np
from scipy.optimize import brentq

from pyworm.formulas.ranges import one_of, positive, within

ROELANDS_PRESSURE = 1.96e8
"""Pole pressure [Pa] of Roelands' law in its usual rounding (Roelands 1966)."""

ROELANDS_PRESSURE_COEFFICIENT = 5.1e-9
"""Reciprocal pole pressure [1/Pa] in the form of Sharif et al. (2001), equation 20."""

ROELANDS_POLE_LOG = 9.67
"""-ln of the viscosity [Pa s] at which Roelands' isotherms meet."""

ROELANDS_POLE_TEMPERATURE = 138.0
"""Temperature [K] of the pole of Roelands' law (Sharif et al. 2001, equation 20)."""


LARGEST_ALPHA = 1e-6
"""Largest pressure-viscosity coefficient [1/Pa]: a tenfold viscosity in some MPa."""


@dataclass(frozen=True)
class Barus:
    """Barus' law, eta = eta0 exp(alpha p); alpha = 0 is an isoviscous oil.

    Attributes
    ----------
    eta0 : float
        Viscosity at ambient pressure [Pa s].
    alpha : float
        Pressure-viscosity coefficient [1/Pa].
    """

    eta0: float
    alpha: float

    def __post_init__(self) -> None:
        """Refuse impossible constants of an oil."""
        positive("eta0", self.eta0, "Pa s")
        within("alpha", self.alpha, 0, LARGEST_ALPHA, "1/Pa")

    def __call__(self, pressure):
        """Viscosity [Pa s] at a pressure or pressures [Pa]."""
        return self.eta0 * np.exp(self.alpha * pressure)


LARGEST_Z = 1e6
"""Largest exponent of Roelands' law [-]; that of oils is around 0.6."""


@dataclass(frozen=True)
class Roelands:
    """Roelands' law, eta = eta0 exp{(ln eta0 + 9.67) [(1 + p/p0)^z - 1]} (Roelands 1966).

    Attributes
    ----------
    eta0 : float
        Viscosity at ambient pressure [Pa s].
    z : float
        Pressure exponent [-].
    p0 : float
        Pole pressure [Pa].
    """

    eta0: float
    z: float
    p0: float = ROELANDS_PRESSURE

    def __post_init__(self) -> None:
        """Refuse impossible constants of an oil."""
        positive("eta0", self.eta0, "Pa s")
        if self.eta0 <= exp(-ROELANDS_POLE_LOG):
            raise ValueError(
                f"eta0 = {self.eta0:g} Pa s: must be above {exp(-ROELANDS_POLE_LOG):.2g} Pa s, the pole of "
                "Roelands' law"
            )
        within("z", self.z, 0, LARGEST_Z, "")
        positive("p0", self.p0, "Pa")

    @classmethod
    def from_alpha(cls, eta0: float, alpha: float, p0: float = ROELANDS_PRESSURE) -> "Roelands":
        """The law whose slope at p = 0 is Barus' alpha [1/Pa]: z = alpha p0 / (ln eta0 + 9.67)."""
        return cls(eta0, alpha * p0 / (log(eta0) + ROELANDS_POLE_LOG), p0)

    @property
    def alpha(self) -> float:
        """Pressure-viscosity coefficient at p = 0 [1/Pa]."""
        return self.z * (log(self.eta0) + ROELANDS_POLE_LOG) / self.p0

    def s0(self, beta: float, temperature: float) -> float:
        """Exponent of temperature [-] by which -d ln eta/dT is beta [1/K] at p = 0 and a temperature [K]."""
        return (
            beta * (temperature - ROELANDS_POLE_TEMPERATURE) / (log(self.eta0) + ROELANDS_POLE_LOG)
        )

    def __call__(self, pressure):
        """Viscosity [Pa s] at a pressure or pressures [Pa]."""
        rise = (log(self.eta0) + ROELANDS_POLE_LOG) * ((1 + pressure / self.p0) ** self.z - 1)
        return self.eta0 * np.exp(rise)


@dataclass(frozen=True)
class Density:
    """Density law rho = rho0 [1 + d1 p / (1 + d2 p)] (Dowson and Higginson 1966).

    Attributes
    ----------
    rho0 : float
        Density at ambient pressure [kg/m3].
    d1, d2 : float
        Coefficients [1/Pa]; d1 = 0 is an incompressible oil.
    """

    rho0: float
    d1: float
    d2: float

    def __post_init__(self) -> None:
        """Refuse impossible constants of an oil."""
        positive("rho0", self.rho0, "kg/m3")
        within("d1, d2", [self.d1, self.d2], 0, inf, "1/Pa")

    @classmethod
    def incompressible(cls, rho0: float) -> "Density":
        """Constant density."""
        return cls(rho0, 0.0, 0.0)

    @classmethod
    def dowson_higginson(cls, rho0: float) -> "Density":
        """The form 1 + 0.6e-9 p / (1 + 1.7e-9 p)."""
        return cls(rho0, 0.6e-9, 1.7e-9)

    @classmethod
    def dowson_higginson_pole(cls, rho0: float) -> "Density":
        """The form (5.9e8 + 1.34 p) / (5.9e8 + p): close to the other, not identical."""
        return cls(rho0, 0.34 / 5.9e8, 1 / 5.9e8)

    def __call__(self, pressure: float) -> float:
        """Density [kg/m3] at a pressure [Pa]."""
        return self.rho0 * (1 + self.d1 * pressure / (1 + self.d2 * pressure))


LEAST_LIMIT = 0.1e6
"""Limiting stress below which none falls [Pa]."""

FlowLawName = Literal["newtonian", "eyring", "bair-winer", "eyring-limited", "carreau"]


@dataclass(frozen=True)
class FlowLaw:
    """Flow law: the shear rate of an oil of viscosity eta under a stress tau.

    | law            | shear rate                                                               |
    |----------------|--------------------------------------------------------------------------|
    | newtonian      | tau/eta                                                                  |
    | eyring         | tau0/eta sinh(tau/tau0)                                                  |
    | bair-winer     | -tauL/eta ln(1 - tau/tauL)           (Sharif et al. 2001, equation 5)    |
    | eyring-limited | tau0/eta sinh(tau/tau0) [tauL^(2 n)/(tauL^(2 n) - tau^(2 n))]     (eq. 6) |
    | carreau        | that at which tau = eta rate [1 + (eta rate/G)^2]^((n - 1)/2)            |

    tau0 and G are `stress` exp[`stress_pressure` p - `stress_temperature` (T - T0)], T being the mean
    temperature across the film and T0 the inlet's; tauL = `limit` + `limit_pressure` p,
    but at least 0.1 MPa; n = `exponent`.
    What a law does not name it does not read.

    Attributes
    ----------
    law : str
        Name of the law.
    stress : float
        Eyring stress tau0 or Carreau's G at ambient pressure and inlet temperature [Pa].
    stress_pressure, stress_temperature : float
        How these follow pressure [1/Pa] and temperature [1/K].
    limit : float
        Limiting stress at ambient pressure [Pa].
    limit_pressure : float
        Its rise with pressure [-].
    exponent : float
        lambda of equation 6, which the paper takes as 1, or Carreau's n [-].
    """

    law: FlowLawName
    stress: float = 0.0
    stress_pressure: float = 0.0
    stress_temperature: float = 0.0
    limit: float = 0.0
    limit_pressure: float = 0.0
    exponent: float = 1.0

    def __post_init__(self) -> None:
        """Refuse impossible values of the constants that the law uses."""
        one_of("law", self.law, get_args(FlowLawName))
        if self.law in ("eyring", "eyring-limited", "carreau"):
            positive("stress", self.stress, "Pa")
            courses = [self.stress_pressure, self.stress_temperature]
            within("stress_pressure, stress_temperature", courses, -inf, inf, "")
        if self.limited:
            within("limit", self.limit, 0, inf, "Pa")
            within("limit_pressure", self.limit_pressure, 0, inf, "")
            positive(
                "the larger of limit and limit_pressure", max(self.limit, self.limit_pressure), ""
            )
        if self.law == "eyring-limited":
            positive("exponent", self.exponent, "")
        if self.law == "carreau" and not 0 < self.exponent <= 1:
            raise ValueError(
                f"exponent = {self.exponent:g}: Carreau's n is above 0 and at most 1, since oils thin"
            )

    def limit_at(self, pressure: float) -> float:
        """Limiting stress tauL [Pa] at a pressure [Pa]."""
        return max(self.limit + self.limit_pressure * pressure, LEAST_LIMIT)

    def stress_at(self, newtonian: float, pressure: float) -> float:
        """Shear stress [Pa] at a shear rate and a pressure [Pa], at the inlet's temperature.

        Parameters
        ----------
        newtonian : float
            Viscosity times shear rate [Pa].
        pressure : float
            Pressure [Pa].
        """
        onset, limit = self.stress * exp(self.stress_pressure * pressure), self.limit_at(pressure)
        if newtonian == 0 or self.law == "newtonian":
            return newtonian
        if self.law == "bair-winer":
            return -limit * expm1(-newtonian / limit)
        if self.law == "carreau":
            return newtonian * (1 + (newtonian / onset) ** 2) ** ((self.exponent - 1) / 2)
        thinned = onset * asinh(newtonian / onset)
        if self.law == "eyring":
            return thinned

        def excess(stress: float) -> float:
            held = 1 - (stress / limit) ** (2 * self.exponent)
            return onset * sinh(stress / onset) - newtonian * held

        highest = min(thinned, limit)
        if (
            not excess(highest) > 0
        ):  # a limit so far away that only rounding tells thinned from limited
            return highest
        return brentq(excess, 0.0, highest, xtol=1e-9 * limit)

    @property
    def thins(self) -> bool:
        """Whether the law thins the oil under shear."""
        return self.law != "newtonian"

    @property
    def limited(self) -> bool:
        """Whether the law has a limiting stress."""
        return self.law in ("bair-winer", "eyring-limited")

    def firmer(self, times: float) -> "FlowLaw":
        """The law with all its stresses multiplied by a factor, for stress continuation."""
        return replace(
            self,
            stress=times * self.stress,
            limit=times * self.limit,
            limit_pressure=times * self.limit_pressure,
        )


NEWTONIAN = FlowLaw("newtonian")
"""The flow law of an oil that shears by its viscosity alone."""


@dataclass(frozen=True)
class OilHeat:
    """Thermal laws of an oil, those of the Appendix of Sharif et al. (2001).

    T0 is the inlet temperature, rho0 and eta0 are density and viscosity there at ambient pressure. Viscosity
    falls by Roelands' law, eta = eta0 exp{(ln eta0 + 9.67) [(1 + p/p0)^z ((T - 138 K)/(T0 - 138 K))^-s0 - 1]}
    (equation 20), or by Barus' law with eta0 exp(alpha p - beta (T - T0)).

    Attributes
    ----------
    inlet_temperature : float
        T0 [K].
    viscosity_exponent : float
        s0 [-] of an oil with Roelands' law, beta [1/K] of one with Barus'.
    conductivity, conductivity_c1, conductivity_c2 : float
        k0 [W/(m K)], c1, c2 [1/Pa] of the conductivity k = k0 [1 + c1 p / (1 + c2 p)].
    specific_heat : float
        c0 [J/(kg K)] of rho c = rho0 c0 [1 + b0 (1 + b1 p + b2 p^2) (T - T0)] [1 + k1 p / (1 + k2 p)].
    heat_capacity_b0, heat_capacity_b1, heat_capacity_b2 : float
        b0 [1/K], b1 [1/Pa], b2 [1/Pa2] in it.
    heat_capacity_k1, heat_capacity_k2 : float
        k1, k2 [1/Pa] in it.
    expansivity, expansivity_decay : float
        eps0 [1/K] and lambda [1/Pa] of the expansivity eps = eps0 exp(-lambda p), by which the density is
        rho(p) [1 - eps (T - T0)].
    """

    inlet_temperature: float
    viscosity_exponent: float
    conductivity: float
    specific_heat: float
    expansivity: float = 0.0
    expansivity_decay: float = 0.0
    conductivity_c1: float = 0.0
    conductivity_c2: float = 0.0
    heat_capacity_b0: float = 0.0
    heat_capacity_b1: float = 0.0
    heat_capacity_b2: float = 0.0
    heat_capacity_k1: float = 0.0
    heat_capacity_k2: float = 0.0

    def __post_init__(self) -> None:
        """Refuse impossible constants of an oil."""
        positive("inlet_temperature", self.inlet_temperature, "K")
        positive("conductivity", self.conductivity, "W/(m K)")
        positive("specific_heat", self.specific_heat, "J/(kg K)")
        within("viscosity_exponent", self.viscosity_exponent, 0, inf, "")
        within("expansivity", self.expansivity, 0, inf, "1/K")


def require_kinds(name: str, law: Any, *kinds: type) -> None:
    """Refuse a law that is not exactly one of these classes.

    Raises
    ------
    ValueError
        It is of another class, or of one derived from them.
    """
    if type(law) not in kinds:
        known = " or ".join(kind.__name__ for kind in kinds if kind is not type(None))
        raise ValueError(
            f"{name} is a {type(law).__name__}: the kernel computes {known} from its constants, and would "
            f"ignore any other formula; give a {known} itself"
        )


@dataclass(frozen=True)
class Oil:
    """An oil as the kernel sees it.

    The kernel computes these laws itself, from their constants: a class derived from one of them, whose
    formula it would not use, is refused.

    Attributes
    ----------
    viscosity : Barus or Roelands
        Viscosity against pressure at the inlet temperature.
    density : Density
        Density against pressure at the inlet temperature.
    flow : FlowLaw or None
        How it shears under stress; None if nothing is known but its viscosity.
    heat : OilHeat or None
        How it takes heat; None where that is not known, and cannot be simulated.
    supply : float or None
        Thickness of the oil that arrives at a contact [m]; None where there is always enough.
    """

    viscosity: Barus | Roelands
    density: Density
    flow: FlowLaw | None = None
    heat: OilHeat | None = None
    supply: float | None = None

    def __post_init__(self) -> None:
        """Refuse laws unknown to the kernel, and contradictory constants."""
        require_kinds("viscosity", self.viscosity, Barus, Roelands)
        require_kinds("density", self.density, Density)
        require_kinds("flow", self.flow, FlowLaw, type(None))
        require_kinds("heat", self.heat, OilHeat, type(None))
        if self.supply is not None:
            positive("supply", self.supply, "m")
        if self.heat is not None and isinstance(self.viscosity, Roelands):
            if self.heat.inlet_temperature <= ROELANDS_POLE_TEMPERATURE:
                raise ValueError(
                    f"inlet_temperature = {self.heat.inlet_temperature:g} K: must be above "
                    f"{ROELANDS_POLE_TEMPERATURE:g} K, the pole of Roelands' law"
                )

    def eta(self, pressure: float, rise: float = 0.0) -> float:
        """Viscosity [Pa s] at a pressure [Pa] and a temperature above the inlet's [K]."""
        if self.heat is None or rise == 0:
            return self.viscosity(pressure)
        exponent = self.heat.viscosity_exponent
        if isinstance(self.viscosity, Barus):
            return self.viscosity(pressure) * exp(-exponent * rise)
        law, inlet = self.viscosity, self.heat.inlet_temperature - ROELANDS_POLE_TEMPERATURE
        span = log(law.eta0) + ROELANDS_POLE_LOG
        warmed = (1 + pressure / law.p0) ** law.z * (1 + rise / inlet) ** -exponent
        return law.eta0 * exp(span * (warmed - 1))

    def warmed(self, rise: float) -> "Oil":
        """The oil at an inlet temperature higher by some kelvin, by its own laws.

        Roelands: ln eta + 9.67 falls as the distance from the pole of temperature to the power -s0, at every
        pressure, so that z stays what it is. Density and heat capacity follow their laws at ambient pressure.
        """
        heat = self.heat
        thinner = replace(self.viscosity, eta0=self.eta(0.0, rise))
        lighter = 1 - heat.expansivity * rise
        held = 1 + heat.heat_capacity_b0 * rise
        flow = self.flow and replace(
            self.flow, stress=self.flow.stress * exp(-self.flow.stress_temperature * rise)
        )
        return replace(
            self,
            viscosity=thinner,
            density=replace(self.density, rho0=self.density.rho0 * lighter),
            flow=flow,
            heat=replace(
                heat,
                inlet_temperature=heat.inlet_temperature + rise,
                specific_heat=heat.specific_heat * held / lighter,
                heat_capacity_b0=heat.heat_capacity_b0 / held,
                expansivity=heat.expansivity / lighter,
            ),
        )
