"""Young's modulus of plastics over temperature, by interpolation between measured points."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from pyworm.io.given import WithUnit, kind_of, number
from pyworm.io.units import MaterialTemperature, Modulus, Temperature

Points = tuple[tuple[MaterialTemperature, Modulus], ...]
"""Temperatures [K] and Young's moduli there [Pa], in order of temperature."""


def points(name: str, given: Sequence[Sequence[WithUnit]]) -> Points:
    """Points of a modulus over temperature, numbers in SI or texts with units.

    ValueError for no pairs, temperatures that do not rise, or a modulus that does.
    """
    read = []
    for place, pair in enumerate(given):
        if isinstance(pair, str) or len(pair) != 2:
            raise ValueError(
                f'{name}[{place}]: must be a temperature and a modulus, such as ["80 degC", "1.3 GPa"]'
            )
        temperature, modulus = (
            number(f"{name}[{place}]", value, kind_of(kind))
            for value, kind in zip(pair, (Temperature, Modulus), strict=True)
        )
        read.append((temperature, modulus))
    check_points(name, read)
    return tuple(read)


def check_points(name: str, read: Sequence[tuple[float, float]]) -> None:
    """Refuse temperatures that do not rise, and a modulus that rises with temperature; ValueError."""
    for (cold, stiff), (warm, soft) in pairwise(read):
        if warm <= cold:
            raise ValueError(f"{name}: temperatures must rise from point to point")
        if soft > stiff:
            raise ValueError(f"{name}: the modulus must not rise with temperature")


def modulus_at(given: Points, temperature: float) -> float:
    """Young's modulus [Pa] at a temperature [K].

    Its logarithm is interpolated linearly, so that the modulus stays positive and falls steadily through a
    glass transition. Beyond the points it is that of the nearest one.
    """
    temperatures, moduli = zip(*given, strict=True)
    return float(np.exp(np.interp(temperature, temperatures, np.log(moduli))))
