"""Flow laws of oils: the shear rate under a stress."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from math import asinh, exp, expm1, inf, sinh
from typing import TYPE_CHECKING, Any, Literal, get_args

import numpy as np
import scipy

from pyworm.formulas.arrays import Array
from pyworm.formulas.ranges import one_of, positive, scalar, within
from pyworm.io import units
from pyworm.io.given import WithUnit, in_si, kind_of, number, take
from pyworm.io.plain_values import AboveZeroToOne, Fraction, NumberOrZero, PositiveNumber
from pyworm.io.shown import ShownFields

LEAST_LIMIT = 0.1e6
"""Limiting stress below which none falls [Pa]."""

FlowLawName = Literal[
    "newtonian", "eyring", "bair-winer", "eyring-limited", "carreau", "carreau-yasuda", "tabulated"
]
"""Names of the laws; the stress of the last two may be limited."""


@dataclass(frozen=True, repr=False)
class Branch(ShownFields):
    """One branch of a liquid of several: a part of its viscosity that thins by Carreau and Yasuda's law."""

    fraction: Fraction
    """Its part of the viscosity at rest [-]."""
    ratio: PositiveNumber
    """Its stress G over that of the flow law [-]."""
    exponent: AboveZeroToOne
    """Exponent n [-]."""
    yasuda: PositiveNumber = 2.0
    """Yasuda's exponent a [-]."""

    def __post_init__(self) -> None:
        """Refuse what is no branch."""
        within("fraction", self.fraction, 0, 1, "")
        positive("ratio", self.ratio, "")
        positive("yasuda", self.yasuda, "")
        if not 0 < scalar("exponent", self.exponent) <= 1:
            raise ValueError(f"exponent = {self.exponent:g}: a branch's n is above 0 and at most 1")


@dataclass(frozen=True, kw_only=True)
class ThinningStress:
    """The stress at which an oil begins to thin, with its dependence on pressure and temperature."""

    stress: units.Stress
    """Eyring stress tau0 or Carreau's G at ambient pressure and inlet temperature [Pa]."""
    stress_pressure: units.PressureCoefficientAnySign = 0.0
    """How the stress follows pressure [1/Pa]."""
    stress_temperature: units.TemperatureCoefficientAnySign = 0.0
    """How the stress follows temperature [1/K]."""


@dataclass(frozen=True, kw_only=True)
class LimitingStress:
    """The stress that an oil cannot exceed: constant, proportional to pressure, or both."""

    limit: units.StressOrZero = 0.0
    """Limiting stress at ambient pressure [Pa]."""
    limit_pressure: NumberOrZero = 0.0
    """Its rise with pressure [-]."""


@dataclass(frozen=True, kw_only=True, repr=False)
class FlowLaw(ShownFields, ThinningStress, LimitingStress):
    """Flow law: the shear rate of an oil of viscosity eta under a stress tau.

    | law            | shear rate                                                               |
    |----------------|--------------------------------------------------------------------------|
    | newtonian      | tau/eta                                                                  |
    | eyring         | tau0/eta sinh(tau/tau0)                                                  |
    | bair-winer     | -tauL/eta ln(1 - tau/tauL)           (Sharif et al. 2001, equation 5)    |
    | eyring-limited | tau0/eta sinh(tau/tau0) [tauL^(2 n)/(tauL^(2 n) - tau^(2 n))]     (eq. 6) |
    | carreau        | tau/eta [1 + (tau/G)^2]^((1/n - 1)/2)                                    |
    | carreau-yasuda | that at which tau = eta rate sum f [1 + (eta rate/(r G))^a]^((n - 1)/a)  |
    | tabulated      | that at which tau/G is what `table` has at eta rate/G                    |

    tau0 and G are `stress` exp[`stress_pressure` p - `stress_temperature` (T - T0)], T being the mean
    temperature across the film and T0 the inlet's; tauL = `limit` + `limit_pressure` p,
    but at least 0.1 MPa; n = `exponent`, a = `yasuda`, or f, r, n, a of each of several
    `branches`. The last two laws are limited as eyring-limited is where `limit` or `limit_pressure` is given.
    What a law does not name it does not read.
    """

    law: FlowLawName = field(kw_only=False)
    """Name of the law."""
    stress: units.StressOrZero = 0.0
    """Eyring stress tau0 or Carreau's G at ambient pressure and inlet temperature [Pa]."""
    exponent: float = 1.0
    """lambda of equation 6, which the paper takes as 1, or Carreau's n [-]."""
    yasuda: float = 2.0
    """Yasuda's a [-]; 2 is Carreau's law."""
    branches: tuple[Branch, ...] = ()
    """Branches of a liquid of several, whose fractions add up to one."""
    table: tuple[tuple[float, float], ...] = ()
    """Pairs of Newtonian stress eta rate and stress tau, both over G, increasing (`FlowLaw.of`)."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI
        # fmt: off
        def __init__(
            self, law: FlowLawName, *, limit: WithUnit = ..., limit_pressure: float = ...,
            stress: WithUnit = ..., stress_pressure: WithUnit = ..., stress_temperature: WithUnit = ...,
            exponent: float = ..., yasuda: float = ..., branches: tuple[Branch, ...] = ...,
            table: tuple[tuple[float, float], ...] = ...
        ) -> None: ...
        # fmt: on

    def __post_init__(self) -> None:
        """Refuse impossible values of the constants that the law uses."""
        take(self, sizes=False)  # a continuation goes through larger stresses than any oil has
        one_of("law", self.law, get_args(FlowLawName))
        if self.law in ("eyring", "eyring-limited", "carreau", *SHAPED):
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
        if self.law == "tabulated":
            _require_table(self.table)
        if self.law == "carreau-yasuda":
            positive("yasuda", self.yasuda, "")
            _require_branches(self.branches)
        single = self.law == "carreau-yasuda" and not self.branches
        thins = 0 < scalar("exponent", self.exponent) <= 1
        if (single or self.law == "carreau") and not thins:
            raise ValueError(
                f"exponent = {self.exponent:g}: Carreau's n is above 0 and at most 1, since oils thin"
            )

    @classmethod
    def of(cls, function: Callable[[float], float], stress: WithUnit, **limit: Any) -> "FlowLaw":
        """The law by which a function gives the stress [Pa] at a Newtonian one, viscosity times rate [Pa].

        Args:
            function: Newtonian stress -> stress, both at ambient pressure [Pa]; increasing, never above its
                argument.
            stress: Stress at which the oil begins to thin [Pa], by which both scale with pressure and
                temperature.
            **limit: `limit`, `limit_pressure`, `stress_pressure` and `stress_temperature`.
        """
        stress = number("stress", stress, kind_of(units.Stress))
        places = np.geomspace(1e-4, 1e8, 400)
        table = tuple((float(y), float(function(y * stress)) / stress) for y in places)
        return replace(cls("tabulated", stress=stress, table=table), **limit)

    def shape_at(self, newtonian: Array) -> Array:
        """Stress over G at a Newtonian stress over G, without the limit, of the laws in `SHAPED`."""
        if self.law == "carreau-yasuda":
            branches = self.branches or (Branch(1.0, 1.0, self.exponent, self.yasuda),)
            factors = (
                branch.fraction
                * (1 + (newtonian / branch.ratio) ** branch.yasuda)
                ** ((branch.exponent - 1) / branch.yasuda)
                for branch in branches
            )
            return newtonian * sum(factors)
        places, stresses = np.log(np.array(self.table)).T
        place = np.log(newtonian)
        inside = np.clip(place, places[0], places[-1])
        curve = scipy.interpolate.PchipInterpolator(places, stresses)
        # before the table the oil is Newtonian, beyond it a power law
        slope = np.where(place < places[0], 1.0, float(curve(places[-1], nu=1)))
        shape_at: Array = np.exp(curve(inside) + slope * (place - inside))
        return shape_at

    def limit_at(self, pressure: WithUnit) -> float:
        """Limiting stress tauL [Pa] at a pressure [Pa]."""
        pressure = in_si("pressure", pressure, units.PressureCoordinate)
        return max(self.limit + self.limit_pressure * pressure, LEAST_LIMIT)

    def stress_at(self, newtonian: WithUnit, pressure: WithUnit) -> float:
        """Shear stress [Pa] at a shear rate and a pressure [Pa], at the inlet's temperature.

        Args:
            newtonian: Viscosity times shear rate [Pa].
            pressure: Pressure [Pa].
        """
        newtonian = in_si("newtonian", newtonian, units.StressOrZero)
        pressure = in_si("pressure", pressure, units.PressureCoordinate)
        onset, limit = self.stress * exp(self.stress_pressure * pressure), self.limit_at(pressure)
        if newtonian == 0 or self.law == "newtonian":
            return newtonian
        if self.law == "bair-winer":
            return -limit * expm1(-newtonian / limit)
        if self.law == "carreau":
            stress_at: float = newtonian * (1 + (newtonian / onset) ** 2) ** (
                (self.exponent - 1) / 2
            )
            return stress_at
        if self.law in SHAPED:
            return self._shaped_stress(newtonian, onset, limit)
        thinned = onset * asinh(newtonian / onset)
        if self.law == "eyring":
            return thinned

        def excess(stress: float) -> float:
            held = 1 - (stress / limit) ** (2 * self.exponent)
            excess: float = onset * sinh(stress / onset) - newtonian * held
            return excess

        highest = min(thinned, limit)
        if (
            not excess(highest) > 0
        ):  # a limit so far away that thinned and limited differ by rounding only
            return highest
        stress_at = scipy.optimize.brentq(excess, 0.0, highest, xtol=1e-9 * limit)
        return stress_at

    def _shaped_stress(self, newtonian: float, onset: float, limit: float) -> float:
        """Stress [Pa] of a law in `SHAPED`: its own, of which a limit holds back a part."""
        if not self.limited:
            return onset * float(self.shape_at(np.array(newtonian / onset)))

        def excess(stress: float) -> float:
            held = newtonian * (1 - (stress / limit) ** 2)
            return stress - onset * float(self.shape_at(np.array(held / onset)))

        highest = limit * (1 - 1e-12)
        low, high = excess(0.0), excess(highest)
        if low * high > 0:
            return onset * float(self.shape_at(np.array(newtonian / onset)))
        return float(scipy.optimize.brentq(excess, 0.0, highest, xtol=1e-9 * limit))

    @property
    def thins(self) -> bool:
        """Whether the law thins the oil under shear."""
        return self.law != "newtonian"

    @property
    def limited(self) -> bool:
        """Whether the law has a limiting stress."""
        if self.law in SHAPED:
            return self.limit > 0 or self.limit_pressure > 0
        return self.law in ("bair-winer", "eyring-limited")

    def with_stress_factor(self, stress_factor: float) -> "FlowLaw":
        """The law with all its stresses multiplied by a factor, for stress continuation."""
        return replace(
            self,
            stress=stress_factor * self.stress,
            limit=stress_factor * self.limit,
            limit_pressure=stress_factor * self.limit_pressure,
        )


SHAPED = ("carreau-yasuda", "tabulated")
"""Laws that the kernel has by a table of their shape (`kernel/numbers.py`)."""


def _require_branches(branches: tuple[Branch, ...]) -> None:
    """Refuse branches that are not the whole liquid."""
    whole = sum(branch.fraction for branch in branches)
    if branches and abs(whole - 1) > 1e-6:
        raise ValueError(f"branches: their fractions add up to {whole:g}, and must to 1")


def _require_table(table: tuple[tuple[float, float], ...]) -> None:
    """Refuse a table that no thinning oil has."""
    pairs = np.array(table, dtype=float)
    if pairs.ndim != 2 or pairs.shape[1:] != (2,) or len(pairs) < 4:
        raise ValueError("table: must have four or more pairs of a Newtonian stress and a stress")
    if not (np.isfinite(pairs).all() and (pairs > 0).all() and (np.diff(pairs, axis=0) > 0).all()):
        raise ValueError("table: both stresses must be above zero and increase from pair to pair")
    if (pairs[:, 1] > pairs[:, 0] * (1 + 1e-9)).any():
        raise ValueError("table: no stress may exceed its Newtonian one, since oils thin")


NEWTONIAN = FlowLaw("newtonian")
"""The flow law of an oil that shears by its viscosity alone."""
