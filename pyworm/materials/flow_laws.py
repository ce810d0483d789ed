"""Flow laws of oils: the shear rate under a stress."""

from dataclasses import dataclass, replace
from math import asinh, exp, expm1, inf, sinh
from typing import Any, ClassVar, Literal, get_args

import scipy

from pyworm.formulas.ranges import one_of, positive, within
from pyworm.io import units
from pyworm.io.given import take

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

    QUANTITIES: ClassVar[dict[str, Any]] = {
        "stress": units.StressOrZero,
        "stress_pressure": units.PressureCoefficientAnySign,
        "stress_temperature": units.TemperatureCoefficientAnySign,
        "limit": units.StressOrZero,
    }

    def __post_init__(self) -> None:
        """Refuse impossible values of the constants that the law uses."""
        take(self, sizes=False)  # a continuation goes through larger stresses than any oil has
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
        ):  # a limit so far away that thinned and limited differ by rounding only
            return highest
        return scipy.optimize.brentq(excess, 0.0, highest, xtol=1e-9 * limit)

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
