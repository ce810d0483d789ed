"""One oil in one file: the tables that name the oil of a drive's sump must not contradict each other."""

from collections.abc import Iterator, Mapping
from math import exp, log

from pyworm.case.oil import OilTable
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.materials.library import named_oil

ONE_GRADE = 1.5
"""Ratio of viscosities from which two oils are not the same: that of neighbouring grades of ISO 3448."""


def second_oil(oil: OilTable | None, others: Mapping[str, str]) -> Iterator[str]:
    """Sentences on a second oil: another one than that of `[oil]` in a table that names one.

    `others` has the oil by the key that names it, a file's name if it ends in .toml. ValueError if two tables
    name different oils, or one names an oil that is not as thick as `[oil]`.
    """
    known = {key: _canonical(name) for key, name in others.items()}
    named = {key: name for key, name in known.items() if name is not None}
    if oil is not None and oil.temperature is not None:
        named = {"oil.name": oil.name, **named}
    first = next(iter(named), "")
    for key, name in named.items():
        if name != named[first]:
            yield (
                f'{key} = "{name}", but {first} = "{named[first]}": one sump holds one oil, name the '
                "same in both"
            )
    if oil is not None and oil.temperature is None:
        yield from _other_thickness(oil, named)


def _canonical(name: str) -> str | None:
    """A name as in the list of oils, the path of a file unchanged; None for an unknown name."""
    try:
        return name if name.endswith(".toml") else named_oil(name).name
    except ValueError:
        return None


def _other_thickness(oil: OilTable, named: Mapping[str, str]) -> Iterator[str]:
    """Sentences on an oil given in `[oil]` whose viscosity at the inlet contradicts the named one."""
    if oil.heat is None:
        return
    kelvin = oil.heat.inlet_temperature
    stated = oil.oil().viscosity.eta0
    for key, name in named.items():
        if name.endswith(".toml"):
            continue  # an oil of the user's own, which is read where it is rated
        expected = float(named_oil(name).viscosity(kelvin))
        ratio = exp(abs(log(stated / expected)))
        if ratio > ONE_GRADE:
            yield (
                f'{key} = "{name}" has {expected:.3g} Pa s at {kelvin - ZERO_CELSIUS:.0f} degC, but '
                f"oil.viscosity is {stated:.3g} Pa s: one sump holds one oil"
            )
