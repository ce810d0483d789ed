"""Parts of the box of the atlas, and errors in them."""

import numpy as np
from atlas.contacts import DRAWN, sequence

from pyworm.formulas.film_atlas import AtlasGroups, pressure


def evenly_drawn(numbers: np.ndarray, solved: np.ndarray) -> np.ndarray:
    """Which contacts are of the beginning of the first sequence, all solved: they fill the box."""
    first = [number for number in sequence() if number < DRAWN]
    there = set(solved.astype(int).tolist())
    end = next((number for number in first if number not in there), DRAWN)
    return numbers < end


def regions(of: AtlasGroups) -> dict[str, np.ndarray]:
    """Which contacts are in each part."""
    degrees = np.degrees(of.angle)
    slender = of.ratio > 3
    return {
        "all": np.ones(len(of.moes_m), bool),
        "ratio of radii up to 3": ~slender,
        "slender, 0 to 10 deg": slender & (degrees <= 10),
        "slender, 10 to 60 deg": slender & (degrees > 10) & (degrees <= 60),
        "slender, 60 to 80 deg": slender & (degrees > 60) & (degrees <= 80),
        "slender, 80 to 90 deg": slender & (degrees > 80),
        "M below 10": of.moes_m < 10,
        "M 10 to 100": (of.moes_m >= 10) & (of.moes_m < 100),
        "M 100 to 1000": (of.moes_m >= 100) & (of.moes_m < 1000),
        "M above 1000": of.moes_m >= 1000,
        "L below 2": of.moes_l < 2,
        "L 2 to 10": (of.moes_l >= 2) & (of.moes_l < 10),
        "L above 10": of.moes_l >= 10,
        "alpha p_H below 5": pressure(of) < 5,
        "alpha p_H 5 to 20": (pressure(of) >= 5) & (pressure(of) < 20),
        "alpha p_H above 20": pressure(of) >= 20,
        "spin": of.spin != 0,
    }


def percent(missed: np.ndarray) -> str:
    """Median, 90, 95 and 99 of 100, and the largest of errors, in %."""
    if not len(missed):
        return ""
    return " ".join(
        f"{100 * value:6.2f}" for value in np.percentile(np.abs(missed), [50, 90, 95, 99, 100])
    )
