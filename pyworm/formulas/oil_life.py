"""Life of oil in a sump: oxidation by Arrhenius' law, and what an analysis of used oil makes of it.

Makers of gear units differ by more than two: Flender (operating instructions BA 7300) has 10,000 h for
mineral oils and esters, 20,000 h for PAO and PAG at 80 degC, halved by each 10 K more; Bonfiglioli (series
300) has a table of intervals.
"""

from dataclasses import dataclass
from math import exp, log

from pyworm.formulas.ranges import within
from pyworm.io import units
from pyworm.io.plain_values import NumberOrZero

HOUR = 3600.0
"""[s]."""

REFERENCE_TEMPERATURE = 353.15
"""Temperature of the sump to which the reference lives belong [K]."""

REFERENCE_LIFE = {"mineral": 10_000.0, "ester": 10_000.0, "PAO": 20_000.0, "PAG": 20_000.0}
"""Base stock -> life of its oils at that temperature [h] (Flender BA 7300)."""

LONGEST_LIFE = {"mineral": 2, "ester": 2, "PAO": 4, "PAG": 4}
"""Base stock -> years after which its oils are changed however cool they are (Flender BA 7300)."""

HALVING = 10.0
"""Excess over the reference temperature that halves the life [K] (Flender BA 7300)."""

MAKER_INTERVALS = ((338.15, 8000.0, 25000.0), (353.15, 4000.0, 15000.0), (368.15, 2000.0, 12500.0))
"""Temperature up to which an interval holds [K], intervals of mineral and of synthetic oil [h] (Bonfiglioli,
series 300; the hottest is discouraged for mineral oil)."""

GAS_CONSTANT = 8.314462618
"""[J/(mol K)]."""

ACTIVATION_ENERGY = (
    GAS_CONSTANT * log(2) * REFERENCE_TEMPERATURE * (REFERENCE_TEMPERATURE + HALVING) / HALVING
)
"""Of the oxidation [J/mol], which halves the life from 80 to 90 degC; 74 kJ/mol."""

FIRST_CHANGE = 500.0
"""Hours after which oil is changed first, for what running-in wears off (AGMA 9005-D94, from memory)."""

VISCOSITY_CAUTION, VISCOSITY_LIMIT = 0.05, 0.10
"""Relative changes of the viscosity that call for attention, and for new oil [-] (usual limits of
laboratories; Amarillo Gear has the latter for gear oils)."""

MEASURABLE = 0.1
"""Part of the way to a limit that tests of viscosity can tell: 1 % of it [-]."""

ACID_LIMIT = 2.0
"""Acid number from which gear oil is changed [mg KOH/g] (Amarillo Gear)."""


def oil_life(base: str, temperature: float) -> float:
    """Life of an oil in a sump of a temperature [K], in hours of operation.

    L = L_80 exp[E/R (1/T - 1/T_80)] with `REFERENCE_LIFE` and `ACTIVATION_ENERGY`. Additives, water, copper
    and air shorten it; it holds from 40 to 120 degC.
    """
    within("sump temperature", temperature, 230, 470, "K")
    slowed = ACTIVATION_ENERGY / GAS_CONSTANT * (1 / temperature - 1 / REFERENCE_TEMPERATURE)
    return REFERENCE_LIFE[base] * exp(slowed)


def maker_interval(base: str, temperature: float) -> float | None:
    """Hours between changes by `MAKER_INTERVALS`; None for a hotter sump [K]. Esters count as mineral oil."""
    for limit, mineral, synthetic in MAKER_INTERVALS:
        if temperature <= limit:
            return synthetic if base in ("PAO", "PAG") else mineral
    return None


def change_interval(base: str, temperature: float, hours_per_year: float) -> float:
    """Hours of operation between changes of oil: its life, a maker's interval or years."""
    within("hours of operation in a year", hours_per_year, 1, 8784, "h")
    life = oil_life(base, temperature)
    return min(life, maker_interval(base, temperature) or life, LONGEST_LIFE[base] * hours_per_year)


@dataclass(frozen=True, kw_only=True)
class UsedOil:
    """Analysis of used oil beside that of the new one."""

    operation: units.Duration
    """Time in operation since it was new [s]."""
    viscosity_40: units.KinematicViscosity
    """Kinematic viscosity at 40 degC [m2/s]."""
    new_viscosity_40: units.KinematicViscosity
    """That of the new oil [m2/s]."""
    acid_number: NumberOrZero | None = None
    """Acid number [mg KOH/g]; None where not measured."""
    new_acid_number: NumberOrZero = 0.0
    """That of the new oil, of its additives [mg KOH/g]."""

    def __post_init__(self) -> None:
        """Refuse acid numbers of other units."""
        within("acid number of the new oil", self.new_acid_number, 0, 0.99 * ACID_LIMIT, "mg KOH/g")
        if self.acid_number is not None:
            within("acid number", self.acid_number, 0, 50, "mg KOH/g")

    @property
    def thickening(self) -> float:
        """Relative change of its viscosity [-]; negative of sheared or diluted oil."""
        return self.viscosity_40 / self.new_viscosity_40 - 1

    @property
    def consumed(self) -> float:
        """Part of the way to the nearest limit that it has gone [-]; from 1 on the oil is spent."""
        parts = [abs(self.thickening) / VISCOSITY_LIMIT]
        if self.acid_number is not None:
            gone = self.acid_number - self.new_acid_number
            parts.append(max(gone, 0.0) / (ACID_LIMIT - self.new_acid_number))
        return max(parts)

    @property
    def verdict(self) -> str:
        """Either "change it now", "watch it" or "usable"."""
        if self.consumed >= 1:
            return "change it now"
        return "watch it" if self.consumed >= VISCOSITY_CAUTION / VISCOSITY_LIMIT else "usable"

    @property
    def life(self) -> float | None:
        """Hours to the nearest limit at the mean rate so far [h]; None where no change is measurable."""
        return self.operation / HOUR / self.consumed if self.consumed > MEASURABLE else None
