"""Regimes of lubrication: whether bodies deform, and whether pressure thickens the oil that forms the film.

Two numbers place a contact, each with its border at 1:

    deflection  b^2 / (2 R h_min): flattening of Hertz's contact along the entrainment over the minimum film;
                above 1 the bodies count as elastic, below as rigid;
    thickening  alpha times the pressure that an isoviscous oil has where the film forms; above 1 the oil
                counts as piezoviscous, below as isoviscous.

The second follows from the films of the four limits, with and without pressure-viscosity. Of rigid bodies
both are equal where alpha times the maximum isoviscous pressure is 1, and their ratio goes with that pressure
to the power 2/3. Of elastic ones the pressure of the inlet goes as p_H (h/delta)^(1/3), and the ratio of the
limits goes with it to the power 3/4 (`thickening`).

The films of the limits alone do not separate rigid from elastic bodies: in a piezoviscous oil both films
differ by a factor of (M/L)^(1/12) only, so that a tenth of error in either moves their crossing threefold in
load. The deflection is that of the plan's effects (`pyworm.planning.effects`), whose influence follows it.
"""

from dataclasses import dataclass

import numpy as np

from pyworm.formulas.arrays import Indices, Values
from pyworm.formulas.film import LineGroups, joined_line, line_asymptotes, moes_line

ISOVISCOUS_RIGID = "isoviscous-rigid"
PIEZOVISCOUS_RIGID = "piezoviscous-rigid"
ISOVISCOUS_ELASTIC = "isoviscous-elastic"
PIEZOVISCOUS_ELASTIC = "piezoviscous-elastic"

REGIMES = (ISOVISCOUS_RIGID, PIEZOVISCOUS_RIGID, ISOVISCOUS_ELASTIC, PIEZOVISCOUS_ELASTIC)
"""Regimes in the order of their numbers in data: 1 for a piezoviscous oil, 2 more for elastic bodies."""

LINE_MINIMUM = 0.8
"""Typical ratio of the minimum to the central film of line contacts."""

LINE_ERROR = 0.1
"""Relative error of a line's film by Moes' formula (docs/evidence/validation.md) [-]."""

UNKNOWN_ERROR = 1.0
"""Relative error of the film outside the box of the atlas, where none is known: a factor of two."""

THICKENING_ERROR = 0.45
"""Relative error of the thickening near its border, 0.4 to 2.5, within which 29 of 30 solved contacts lay
of elastic bodies (`benchmarks/atlas/regimes.py`) [-]."""


@dataclass(frozen=True)
class Regime:
    """The regime of a contact by its distance from both borders."""

    deflection: float
    """Deflection number of this module, 1 at the border [-]."""
    thickening: float
    """Thickening number of this module, 1 at the border [-]."""
    deflection_error: float
    """Relative uncertainty of the deflection number [-]."""
    thickening_error: float
    """Relative uncertainty of the thickening number [-]."""
    moes_m: float
    """Moes' M along the entrainment [-]."""
    moes_l: float
    """Moes' L along the entrainment, with alpha at zero pressure [-]."""
    alpha_ratio: float = 1.0
    """The alpha ratio of `pyworm.formulas.film_atlas.AtlasGroups` [-]."""
    compression: float = 0.0
    """The compression of `pyworm.formulas.film_atlas.AtlasGroups` [-]."""
    ratio: float | None = None
    """Larger over smaller relative radius [-]; None of a line contact."""
    angle: float | None = None
    """Angle of entrainment from the smaller relative radius' direction [rad]; None of a line."""
    spin: float = 0.0
    """As of those groups [-]."""

    @property
    def name(self) -> str:
        """Isoviscous or piezoviscous, rigid or elastic, as "piezoviscous-elastic"."""
        return REGIMES[int(regime_number(self.deflection, self.thickening))]

    @property
    def shape(self) -> tuple[float, float] | None:
        """Ratio of radii and angle of a point contact; None of a line."""
        return None if self.ratio is None or self.angle is None else (self.ratio, self.angle)

    @property
    def close_to(self) -> tuple[str, ...]:
        """Regimes beyond a border that is within its uncertainty."""
        number = int(regime_number(self.deflection, self.thickening))
        measures = (
            (self.thickening, self.thickening_error),
            (self.deflection, self.deflection_error),
        )
        return tuple(
            REGIMES[number ^ bit]
            for bit, (measure, error) in zip((1, 2), measures, strict=True)
            if 1 / (1 + error) < measure < 1 + error
        )

    @property
    def words(self) -> str:
        """The name, and what it is close to."""
        return ", close to ".join((self.name, *self.close_to))

    def summary(self) -> dict[str, str | float | list[str]]:
        """The regime as part of a flat object for JSON."""
        return {
            "regime": self.name,
            "regime_close_to": list(self.close_to),
            "deflection_over_film": self.deflection,
            "deflection_over_film_error": self.deflection_error,
            "inlet_thickening": self.thickening,
            "inlet_thickening_error": self.thickening_error,
        }


def regime_number(deflection: Values, thickening: Values) -> Indices:
    """Place in `REGIMES` from both numbers; where one is NaN no comparison holds, and 0 is returned."""
    return np.asarray(2 * (np.asarray(deflection) > 1) + 1 * (np.asarray(thickening) > 1))


def flattening(half_width: Values, radius: Values, film_min: Values) -> Values:
    """Deflection over minimum film [-]: b^2 / 2R, by which Hertz's contact is flattened along it."""
    return half_width**2 / (2 * radius * film_min)


def thickening(film_ratio: Values, deflection: Values) -> Values:
    """alpha times the pressure of an isoviscous oil where the film forms [-].

    By the film in the limits of an oil that thickens under pressure over that of one that does not, and the
    deflection over film, by which the exponent passes from 3/2 of rigid bodies to 4/3.
    """
    return film_ratio ** (4 / 3 + 1 / 6 / (1 + deflection))


def line_measures(groups: LineGroups, alpha_ratio: Values = 1.0) -> tuple[Values, Values]:
    """Deflection and thickening of line contacts by Moes' limits, of which the rigid ones are exact.

    `alpha_ratio`: reciprocal asymptotic isoviscous pressure coefficient over alpha [-]; 1 of Barus' law.
    """
    central = np.asarray(moes_line(groups).central) / groups.moes_film
    # in Moes' units b^2/R^2 is 8 M/pi
    deflection = flattening(np.sqrt(8 * groups.moes_m / np.pi), 1.0, LINE_MINIMUM * central)
    limits = line_asymptotes(groups.moes_m, groups.moes_l * alpha_ratio)
    isoviscous, piezoviscous = joined_line(limits)
    return deflection, thickening(piezoviscous / isoviscous, deflection)


def line_regime(groups: LineGroups, alpha_ratio: float = 1.0) -> Regime:
    """The regime of a line contact; arguments as of `line_measures`."""
    deflection, thick = line_measures(groups, alpha_ratio)
    return Regime(
        deflection=float(deflection),
        thickening=float(thick),
        deflection_error=LINE_ERROR,
        thickening_error=THICKENING_ERROR,
        moes_m=float(groups.moes_m),
        moes_l=float(groups.moes_l),
        alpha_ratio=alpha_ratio,
    )
