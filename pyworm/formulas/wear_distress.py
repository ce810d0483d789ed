"""Specific film and the probability of wear distress of the teeth."""

from dataclasses import dataclass

import numpy as np
import scipy

from pyworm.formulas.arrays import Values
from pyworm.formulas.lubrication import BOUNDARY, FULL_FILM
from pyworm.formulas.ranges import positive, within

SOURCE = "Wellauer and Holloway 1976, as fitted in AGMA 925-A03"

MIN_ROUGHNESS, MAX_ROUGHNESS = 1e-10, 1e-4
"""Root mean square heights of surfaces in contact [m]; what lies beyond is in a wrong unit."""

# pitch line velocity [m/s] up to which a row holds, mean and standard deviation of lambda
_DISTRESS = ((5.0, 0.47767, 0.21525), (60.0, 0.86072, 0.33124), (np.inf, 1.07624, 0.23536))


def composite_roughness(roughness_1: float, roughness_2: float) -> float:
    """Composite roughness [m], the root of the sum of the squares of both rms roughnesses [m]."""
    within("roughness", [roughness_1, roughness_2], MIN_ROUGHNESS, MAX_ROUGHNESS, "m")
    return float(np.hypot(roughness_1, roughness_2))


def specific_film(film_min: Values, roughness: Values) -> Values:
    """lambda [-], minimum film over composite roughness, both in metres; NaN where there is no film."""
    within("minimum film thickness", np.nan_to_num(film_min, nan=0.0), 0, 1e-3, "m")
    within("composite roughness", roughness, MIN_ROUGHNESS, np.sqrt(2) * MAX_ROUGHNESS, "m")
    return np.asarray(film_min) / roughness


def regime(specific_film: float) -> str:
    """What carries the load: "boundary" below lambda = 1, "mixed" to 3, "full film" from 3 on."""
    within("lambda", specific_film, 0, np.inf, "")
    if specific_film < BOUNDARY:
        return "boundary"
    return "mixed" if specific_film < FULL_FILM else "full film"


def distress_probability(specific_film: Values, pitch_line_velocity: float) -> Values:
    """Probability of wear-related surface distress [-] by lambda and a pitch line velocity [m/s], 0 to 300.

    One minus the normal distribution of lambda with mean and standard deviation

        0.47767, 0.21525 up to 5 m/s;  0.86072, 0.33124 up to 60 m/s;  1.07624, 0.23536 above.

    Source: AGMA 925-A03's fit to several hundred gear drives of E. J. Wellauer and G. A. Holloway, J. Eng.
    Ind. 98 (1976) 626-634; from memory. Verified by Errichello's case history: lambda 0.073 and 0.097 give 97
    % ("above 95 %") and 96 % (94 %). Range: gears with the minimum film of Dowson and Higginson and the
    composite rms roughness. At lambda = 0 the fit has 98.7 %, not all.
    """
    within("lambda", specific_film, 0, np.inf, "")
    positive("pitch line velocity", pitch_line_velocity, "m/s")
    within("pitch line velocity", pitch_line_velocity, 0, 300, "m/s")
    _, mean, spread = next(row for row in _DISTRESS if pitch_line_velocity <= row[0])
    distress_probability: Values = 1 - scipy.special.ndtr(
        (np.asarray(specific_film) - mean) / spread
    )
    return distress_probability


def film_of_probability(probability: float, pitch_line_velocity: float) -> float:
    """lambda [-] at which distress has a probability: the inverse of `distress_probability`."""
    within("probability", probability, 1e-6, 0.95, "")
    positive("pitch line velocity", pitch_line_velocity, "m/s")
    _, mean, spread = next(row for row in _DISTRESS if pitch_line_velocity <= row[0])
    return float(mean + spread * scipy.special.ndtri(1 - probability))


@dataclass(frozen=True)
class WearRating:
    """Specific film along a pair of teeth, or at one contact."""

    roughness: float
    """Composite roughness [m]."""
    specific_film_min: float
    """Smallest lambda [-]."""
    worst: int
    """Index of the contact that has it."""
    regime: str
    """Regime there: "boundary", "mixed" or "full film"."""
    probability: float
    """Probability of wear-related distress [-]."""
    source: str = SOURCE
    """Source of the method."""


def rate_wear(film_min: Values, roughness: float, pitch_line_velocity: float) -> WearRating:
    """Rate the minimum films [m] of a mesh, or one; ValueError for what lies outside the fit."""
    ratios = np.atleast_1d(specific_film(film_min, roughness))
    worst = int(np.argmin(ratios))
    thinnest = float(ratios[worst])
    return WearRating(
        roughness=roughness,
        specific_film_min=thinnest,
        worst=worst,
        regime=regime(thinnest),
        probability=float(distress_probability(thinnest, pitch_line_velocity)),
    )
