"""Life of rolling bearings under real lubrication and dirt: ISO 281:2007.

Lengths are in metres, speeds of rotation in rad/s, kinematic viscosities in m2/s, lives in revolutions;
the standard's own rpm, mm and mm2/s are used inside only.
"""

from dataclasses import dataclass
from math import inf, log, pi
from typing import Literal

from pyworm.formulas.ranges import one_of, positive, within
from pyworm.formulas.unknown import Unknown, known
from pyworm.io import units

Elements = Literal["ball", "roller"]
Direction = Literal["radial", "thrust"]

SOURCE = "ISO 281:2007"

REVOLUTIONS = 1e6
"""Revolutions in which basic lives are counted."""

LARGEST_MODIFICATION = 50.0
"""Cap of a_ISO."""

LARGEST_WITH_ADDITIVES = 3.0
"""Cap of a_ISO where kappa is taken as 1 because of additives."""

DIRTIEST_WITH_ADDITIVES = 0.2
"""e_C from which this is allowed."""

SMALLEST_RATIO, LARGEST_RATIO = 0.1, 4.0
"""kappa below which a_ISO does not hold, and above which it no longer grows."""

_LIFE_EXPONENT = {"ball": 3.0, "roller": 10 / 3}

# kappa up to which a row holds, k1, k2
_MODIFICATION = {
    "ball": ((0.4, 2.2649, 0.054381), (1.0, 1.9987, 0.19087), (inf, 1.9987, 0.071739)),
    "roller": ((0.4, 1.3993, 0.054381), (1.0, 1.2348, 0.19087), (inf, 1.2348, 0.071739)),
}

_THRUST_FACTOR = {"ball": 3.0, "roller": 2.5}

# c and b by cleanliness, cleanest first
_CLEANLINESS = {
    "inline filter": {
        "-/13/10": (0.0864, 0.5663),
        "-/15/12": (0.0432, 0.9987),
        "-/17/14": (0.0288, 1.6329),
        "-/19/16": (0.0216, 2.3362),
    },
    "oil bath": {
        "-/13/10": (0.0864, 0.6796),
        "-/15/12": (0.0288, 1.141),
        "-/17/14": (0.0133, 1.67),
        "-/19/16": (0.00864, 2.5164),
        "-/21/18": (0.00411, 3.8974),
    },
    "grease": {
        "high": (0.0864, 0.6796),
        "normal": (0.0432, 1.141),
        "slight": (0.0177, 1.887),
        "severe": (0.0115, 2.662),
        "very severe": (0.00617, 4.06),
    },
}

_LARGE_SLIGHT_GREASE = 1.677
"""b of slightly contaminated grease in bearings of 500 mm and more."""

CONTAMINATION = {
    "extreme cleanliness": ((1.0, 1.0), (1.0, 1.0)),
    "high cleanliness": ((0.6, 0.8), (0.8, 0.9)),
    "normal cleanliness": ((0.5, 0.6), (0.6, 0.8)),
    "slight contamination": ((0.3, 0.5), (0.4, 0.6)),
    "typical contamination": ((0.1, 0.3), (0.2, 0.4)),
    "severe contamination": ((0.0, 0.1), (0.0, 0.1)),
    "very severe contamination": ((0.0, 0.0), (0.0, 0.0)),
}
"""Range of e_C by words, for mean diameters below 100 mm and from 100 mm (table 13 of the standard)."""


def reference_viscosity(speed: float, mean_diameter: float) -> float:
    """Kinematic viscosity nu1 [m2/s] that a bearing needs at a speed [rad/s] and a mean diameter D [m].

    45000 n^-0.83 D^-0.5 mm2/s below 1000 rpm, 4500 (n D)^-0.5 from there on, n in rpm and D in mm; D is half
    of bore plus outside diameter, or the pitch diameter of the elements. Range (ValueError beyond): 1 to 1e5
    rpm, 5 mm to 5 m. Source: ISO 281:2007, equations 27 and 28. At 1000 rpm both forms differ by 2.3 %, as
    printed.
    """
    rpm = speed * 30 / pi
    within("speed of rotation", rpm, 1, 1e5, "rpm")
    within("mean diameter of the bearing", mean_diameter, 5e-3, 5, "m")
    millimetres = mean_diameter * 1e3
    if rpm < 1000 * (1 - 1e-9):  # 1000 rpm may come back from rad/s as a little less
        return float(45000 * rpm**-0.83 * millimetres**-0.5 * 1e-6)
    return float(4500 * rpm**-0.5 * millimetres**-0.5 * 1e-6)


def viscosity_ratio(viscosity: float, speed: float, mean_diameter: float) -> float:
    """kappa [-], the oil's kinematic viscosity at the bearing [m2/s] over `reference_viscosity`."""
    within("kinematic viscosity", viscosity, 1e-7, 1e-1, "m2/s")
    return viscosity / reference_viscosity(speed, mean_diameter)


def contamination_range(words: str, mean_diameter: float) -> tuple[float, float]:
    """Smallest and largest e_C [-] of a degree of contamination in words, `CONTAMINATION`."""
    one_of("contamination", words, CONTAMINATION)
    within("mean diameter of the bearing", mean_diameter, 5e-3, 5, "m")
    return CONTAMINATION[words][mean_diameter >= 0.1]


def contamination_factor(
    lubrication: str, cleanliness: str, kappa: float, mean_diameter: float
) -> float:
    """e_C [-] = a (1 - b/D^(1/3)), a = c kappa^0.68 D^0.55, at most 1, D in mm; not below zero.

    Lubrication is by "inline filter" (circulating oil filtered before the bearing), "oil bath" (or filtered
    off-line) or "grease"; cleanliness an ISO 4406 code such as "-/17/14", of grease "high", "normal",
    "slight", "severe" or "very severe". kappa, the viscosity ratio, is 0.1 or more and taken as 4 at most.
    ValueError for another word, code, ratio or mean diameter [m]. Source: ISO 281:2007, Annex A; constants as
    found in two codes, the form from memory, checked by its limits (grows with kappa and D, 1 in a large
    clean bearing).
    """
    one_of("lubrication", lubrication, _CLEANLINESS)
    classes = _CLEANLINESS[lubrication]
    one_of(f"cleanliness with {lubrication}", cleanliness, classes)
    within("mean diameter of the bearing", mean_diameter, 5e-3, 5, "m")
    if not kappa >= SMALLEST_RATIO:
        raise ValueError(f"kappa = {kappa:g}: ISO 281 holds from {SMALLEST_RATIO:g} on")
    c, b = classes[cleanliness]
    if cleanliness == "slight" and mean_diameter >= 0.5:
        b = _LARGE_SLIGHT_GREASE
    millimetres = mean_diameter * 1e3
    a = min(c * min(kappa, LARGEST_RATIO) ** 0.68 * millimetres**0.55, 1.0)
    return float(max(a * (1 - b / millimetres ** (1 / 3)), 0.0))


def fatigue_load_limit(static_rating: float, elements: Elements, mean_diameter: float) -> float:
    """Estimate of the fatigue load limit C_u [N]: C0/22 of ball and C0/8.2 of roller bearings.

    C0 is the static rating. Source: ISO 281:2007, B.3.3; ball bearings above 100 mm mean diameter times (100
    mm/D)^0.5. Range: roller bearings to 100 mm only, since their exponent above could not be checked.
    """
    positive("static load rating", static_rating, "N")
    one_of("elements", elements, _LIFE_EXPONENT)
    within("mean diameter of the bearing", mean_diameter, 5e-3, 5, "m")
    if elements == "roller":
        if mean_diameter > 0.1:
            raise ValueError(
                f"mean diameter of the bearing = {mean_diameter:g} m: C_u of roller bearings is estimated "
                "up to 0.1 m; take it from the catalogue"
            )
        return static_rating / 8.2
    return float(static_rating / 22 * min(1.0, (0.1 / mean_diameter) ** 0.5))


def life_modification(
    kappa: float,
    load_ratio: float,
    elements: Elements,
    direction: Direction = "radial",
    additives: bool = False,
    contamination: float = 1.0,
) -> float:
    """Life modification factor a_ISO [-] at a viscosity ratio kappa and a load ratio e_C C_u/P.

        ball     0.1 [1 - (2.5671 - k1/kappa^k2)^0.83 x^(1/3)]^-9.3
        roller   0.1 [1 - (1.5859 - k1/kappa^k2) x^0.4]^-9.185

    with x = e_C C_u/P of radial bearings, a third of it for thrust ball and 1/2.5 for thrust roller bearings;
    k1 and k2 by range of kappa. At most 50, which also holds where the bracket is not positive; kappa above 4
    counts as 4. Additives of proven effect allow kappa = 1 instead of a smaller one where the contamination
    e_C is 0.2 or more, a_ISO then being 3 at most, never less than without. ValueError for kappa below 0.1, a
    negative load ratio, or another word.

    Source: ISO 281:2007, equations 31 to 42. k2 = 0.19087 between 0.4 and 1 (0.019087 in circulation) follows
    from continuity at 0.4; a code independent of the others has the same constants. The fractions of thrust
    bearings are from memory.
    """
    one_of("elements", elements, _LIFE_EXPONENT)
    one_of("direction", direction, ("radial", "thrust"))
    if not kappa >= SMALLEST_RATIO:
        raise ValueError(f"kappa = {kappa:g}: ISO 281 holds from {SMALLEST_RATIO:g} on")
    within("e_C C_u/P", load_ratio, 0, inf, "")
    factor = _THRUST_FACTOR[elements] if direction == "thrust" else 1.0
    plain = _modification(kappa, load_ratio / factor, elements)
    if not additives or kappa >= 1 or contamination < DIRTIEST_WITH_ADDITIVES:
        return plain
    helped = min(_modification(1.0, load_ratio / factor, elements), LARGEST_WITH_ADDITIVES)
    return max(plain, helped)


def _modification(kappa: float, x: float, elements: Elements) -> float:
    kappa = min(kappa, LARGEST_RATIO)
    _, k1, k2 = next(row for row in _MODIFICATION[elements] if kappa < row[0])
    if elements == "ball":
        bracket, power = 1 - (2.5671 - k1 / kappa**k2) ** 0.83 * x ** (1 / 3), -9.3
    else:
        bracket, power = 1 - (1.5859 - k1 / kappa**k2) * x**0.4, -9.185
    if bracket <= 0:
        return LARGEST_MODIFICATION
    return float(min(0.1 * bracket**power, LARGEST_MODIFICATION))


def reliability_factor(reliability: float) -> float:
    """Reliability factor a1 [-] = 0.95 [ln(1/R)/ln(1/0.9)]^(2/3) + 0.05, R the fraction that lives longer.

    Source: the Weibull law behind the table of ISO 281:2007 (slope 1.5, 5 % of the life free of failures),
    which it gives to its two digits: 1, 0.64, 0.55, 0.47, 0.37, 0.25 for 90, 95, 96, 97, 98 and 99 %. Range:
    90 to 99.95 %.
    """
    within("reliability", reliability, 0.9, 0.9995, "")
    return float(0.95 * (log(1 / reliability) / log(1 / 0.9)) ** (2 / 3) + 0.05)


def basic_life(dynamic_rating: float, load: float, elements: Elements) -> float:
    """Basic rating life L10 [revolutions], 1e6 (C/P)^p with p = 3 for balls and 10/3 for rollers.

    C is the dynamic rating and P the equivalent dynamic load [N]. Source: ISO 281:2007. Range: P up to C/2,
    above which the standard does not hold.
    """
    positive("dynamic load rating", dynamic_rating, "N")
    positive("equivalent load", load, "N")
    one_of("elements", elements, _LIFE_EXPONENT)
    if load > dynamic_rating / 2:
        raise ValueError(
            f"equivalent load = {load:g} N: ISO 281 holds up to half of the dynamic load rating, "
            f"{dynamic_rating / 2:g} N"
        )
    return float(REVOLUTIONS * (dynamic_rating / load) ** _LIFE_EXPONENT[elements])


@dataclass(frozen=True, kw_only=True)
class RollingBearing:
    """A rolling bearing."""

    elements: Elements
    """Rolling elements, "ball" or "roller"."""
    direction: Direction = "radial"
    """Direction of the load, "radial" or "thrust"."""
    dynamic_rating: units.Force
    """Dynamic load rating C [N]."""
    additives: bool = False
    """Whether the oil has additives that lessen wear (`life_modification`)."""
    reliability: units.Share = 0.9
    """Share of bearings that reach the life (`reliability_factor`)."""


@dataclass(frozen=True, kw_only=True)
class BearingRating(RollingBearing):
    """Life of one bearing by ISO 281; ValueError by a figure outside the standard or without its data."""

    load: float
    """Equivalent load P [N]."""
    speed: float
    """Speed [rad/s]."""
    fatigue_load_limit: float | Unknown
    """Fatigue load limit C_u [N]."""
    mean_diameter: float | Unknown
    """Mean diameter [m]."""
    viscosity: float | Unknown
    """Kinematic viscosity of the oil at the bearing [m2/s]."""
    contamination: float | Unknown
    """e_C [-], see `contamination_factor` and `contamination_range`."""
    source = SOURCE

    @property
    def reference_viscosity(self) -> float:
        """nu1 [m2/s]."""
        return reference_viscosity(self.speed, known(self.mean_diameter))

    @property
    def kappa(self) -> float:
        """Viscosity ratio [-]."""
        return viscosity_ratio(known(self.viscosity), self.speed, known(self.mean_diameter))

    @property
    def load_ratio(self) -> float:
        """e_C C_u/P [-]."""
        dirt, limit = known(self.contamination), known(self.fatigue_load_limit)
        within("e_C", dirt, 0, 1, "")
        positive("fatigue load limit", limit, "N")
        return dirt * limit / self.load

    @property
    def modification(self) -> float:
        """a_ISO [-]."""
        how = self.elements, self.direction, self.additives, known(self.contamination)
        return life_modification(self.kappa, self.load_ratio, *how)

    @property
    def reliability_factor(self) -> float:
        """a1 [-]."""
        return reliability_factor(self.reliability)

    @property
    def basic_life(self) -> float:
        """L10 [revolutions]."""
        return basic_life(self.dynamic_rating, self.load, self.elements)

    @property
    def modified_life(self) -> float:
        """L_nm = a1 a_ISO L10 [revolutions]."""
        return self.reliability_factor * self.modification * self.basic_life

    @property
    def basic_hours(self) -> float:
        """L10 [h]."""
        return self._hours(self.basic_life)

    @property
    def modified_hours(self) -> float:
        """L_nm [h]."""
        return self._hours(self.modified_life)

    def _hours(self, revolutions: float) -> float:
        return revolutions * 2 * pi / self.speed / 3600
