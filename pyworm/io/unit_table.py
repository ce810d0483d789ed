"""Units by name: what one of each is in SI base units.

Symbols of SI units take prefixes ("kN", "GPa"), and so do their names ("kilonewton"), which have a plural.
Radians count as a base unit, so that angles are no plain numbers and revolutions no frequencies.
"""

from dataclasses import dataclass
from functools import cache
from math import pi

BASE = ("A", "K", "kg", "m", "rad", "s")
"""The base units, in the order in which they are written."""


@dataclass(frozen=True)
class Unit:
    """A unit."""

    factor: float
    """Size in SI base units."""
    powers: tuple[int, ...]
    """Powers of the base units, in their order."""
    zero: float = 0.0
    """Its zero in the base unit, of temperature scales."""

    @property
    def base(self) -> str:
        """The base units it comes down to, such as "kg/m/s**2"."""
        above = [
            _power(name, power) for name, power in zip(BASE, self.powers, strict=True) if power > 0
        ]
        below = [
            f"/{_power(name, -power)}"
            for name, power in zip(BASE, self.powers, strict=True)
            if power < 0
        ]
        return "".join(["*".join(above) or "1" * bool(below), *below])


def _power(name: str, power: int) -> str:
    return name if power == 1 else f"{name}**{power}"


def product(factors: tuple[tuple[str, int], ...]) -> Unit:
    """The unit that is a product of powers of units by name; ValueError if one is not known.

    A temperature scale by itself keeps its zero, as a factor it measures differences.
    """
    if len(factors) == 1 and factors[0][1] == 1:
        return named(factors[0][0])
    size, powers = 1.0, (0,) * len(BASE)
    for name, power in factors:
        unit = named(name)
        size *= unit.factor**power
        powers = tuple(
            exponent + power * added for exponent, added in zip(powers, unit.powers, strict=True)
        )
    return Unit(size, powers)


@cache
def named(name: str) -> Unit:
    """A unit by its symbol or name; ValueError if it is not known."""
    if name in _UNITS:
        return _UNITS[name]
    for symbols, prefixes in ((_SYMBOLS, _PREFIXES), (_NAMES, _PREFIX_NAMES)):
        for prefix, size in prefixes.items():
            rest = name.removeprefix(prefix)
            if rest != name and rest in symbols:
                unit = symbols[rest]
                return Unit(size * unit.factor, unit.powers)
    raise ValueError(f'"{name}" is no unit')


def _unit(factor: float, zero: float = 0.0, **powers: int) -> Unit:
    return Unit(factor, tuple(powers.get(name, 0) for name in BASE), zero)


_PREFIXES = {
    "T": 1e12, "G": 1e9, "M": 1e6, "k": 1e3, "h": 1e2, "da": 1e1, "d": 1e-1, "c": 1e-2, "m": 1e-3,
    "u": 1e-6, "µ": 1e-6, "μ": 1e-6, "n": 1e-9, "p": 1e-12, "f": 1e-15,
}  # fmt: skip
"""Symbols of prefixes; micro is the sign of Latin 1, or the Greek letter."""

_PREFIX_NAMES = {
    "tera": 1e12, "giga": 1e9, "mega": 1e6, "kilo": 1e3, "hecto": 1e2, "deca": 1e1, "deci": 1e-1,
    "centi": 1e-2, "milli": 1e-3, "micro": 1e-6, "nano": 1e-9, "pico": 1e-12, "femto": 1e-15,
}  # fmt: skip

_LENGTH, _MASS, _FORCE = {"m": 1}, {"kg": 1}, {"m": 1, "kg": 1, "s": -2}
_PRESSURE, _ENERGY = {"m": -1, "kg": 1, "s": -2}, {"m": 2, "kg": 1, "s": -2}
_POWER, _VOLUME = {"m": 2, "kg": 1, "s": -3}, {"m": 3}
_DYNAMIC, _KINEMATIC = {"m": -1, "kg": 1, "s": -1}, {"m": 2, "s": -1}

_INCH, _POUND, _GRAVITY = 0.0254, 0.45359237, 9.80665
"""Inch [m], pound [kg] and standard gravity [m/s2], all exact by definition."""

_SYMBOLS = {
    "m": _unit(1.0, **_LENGTH),
    "g": _unit(1e-3, **_MASS),
    "s": _unit(1.0, s=1),
    "K": _unit(1.0, K=1),
    "A": _unit(1.0, A=1),
    "V": _unit(1.0, A=-1, **_POWER),
    "rad": _unit(1.0, rad=1),
    "Hz": _unit(1.0, s=-1),
    "N": _unit(1.0, **_FORCE),
    "Pa": _unit(1.0, **_PRESSURE),
    "bar": _unit(1e5, **_PRESSURE),
    "J": _unit(1.0, **_ENERGY),
    "cal": _unit(4.184, **_ENERGY),
    "W": _unit(1.0, **_POWER),
    "Wh": _unit(3600.0, **_ENERGY),
    "l": _unit(1e-3, **_VOLUME),
    "L": _unit(1e-3, **_VOLUME),
    "P": _unit(0.1, **_DYNAMIC),
    "St": _unit(1e-4, **_KINEMATIC),
    "lbf": _unit(_POUND * _GRAVITY, **_FORCE),
    "psi": _unit(_POUND * _GRAVITY / _INCH**2, **_PRESSURE),
    "reyn": _unit(_POUND * _GRAVITY / _INCH**2, **_DYNAMIC),
}
"""Units whose symbols take prefixes."""

_SINGULAR = {
    "metre": "m", "meter": "m", "gram": "g", "second": "s", "kelvin": "K", "ampere": "A",
    "volt": "V", "radian": "rad", "newton": "N", "pascal": "Pa", "joule": "J", "calorie": "cal",
    "watt": "W", "litre": "l", "liter": "l", "poise": "P", "stokes": "St", "reyn": "reyn",
}  # fmt: skip

_NAMES = {
    name: _SYMBOLS[symbol]
    for singular, symbol in _SINGULAR.items()
    for name in (singular, f"{singular}s")
} | {"hertz": _SYMBOLS["Hz"]}
"""Units by their English names, singular and plural."""

_OTHERS = {
    ("percent",): _unit(1e-2),
    ("ppm",): _unit(1e-6),
    ("degC", "celsius"): _unit(1.0, 273.15, K=1),
    ("degF", "fahrenheit"): _unit(5 / 9, 459.67 * 5 / 9, K=1),
    ("delta_degC",): _unit(1.0, K=1),
    ("delta_degF", "degR", "rankine"): _unit(5 / 9, K=1),
    ("deg", "degree", "degrees"): _unit(pi / 180, rad=1),
    ("arcmin", "arcminute", "arcminutes"): _unit(pi / 10800, rad=1),
    ("arcsec", "arcsecond", "arcseconds"): _unit(pi / 648000, rad=1),
    ("turn", "turns", "rev", "revolution", "revolutions"): _unit(2 * pi, rad=1),
    ("rpm",): _unit(pi / 30, rad=1, s=-1),
    ("rps",): _unit(2 * pi, rad=1, s=-1),
    ("min", "minute", "minutes"): _unit(60.0, s=1),
    ("h", "hr", "hour", "hours"): _unit(3600.0, s=1),
    ("d", "day", "days"): _unit(86400.0, s=1),
    ("micron", "microns"): _unit(1e-6, **_LENGTH),
    ("angstrom", "angstroms"): _unit(1e-10, **_LENGTH),
    ("in", "inch", "inches"): _unit(_INCH, **_LENGTH),
    ("uin", "microinch", "microinches"): _unit(1e-6 * _INCH, **_LENGTH),
    ("thou",): _unit(1e-3 * _INCH, **_LENGTH),
    ("ft", "foot", "feet"): _unit(12 * _INCH, **_LENGTH),
    ("yd", "yard", "yards"): _unit(36 * _INCH, **_LENGTH),
    ("mph",): _unit(63360 * _INCH / 3600, m=1, s=-1),
    ("t", "tonne", "tonnes"): _unit(1e3, **_MASS),
    ("lb", "lbs", "pound", "pounds"): _unit(_POUND, **_MASS),
    ("oz", "ounce", "ounces"): _unit(_POUND / 16, **_MASS),
    ("kgf", "kp"): _unit(_GRAVITY, **_FORCE),
    ("dyn", "dyne"): _unit(1e-5, **_FORCE),
    ("ksi",): _unit(1e3 * _POUND * _GRAVITY / _INCH**2, **_PRESSURE),
    ("atm",): _unit(101325.0, **_PRESSURE),
    ("Torr", "torr"): _unit(101325.0 / 760, **_PRESSURE),
    ("erg",): _unit(1e-7, **_ENERGY),
    ("Btu", "BTU"): _unit(1055.056, **_ENERGY),
    ("hp", "horsepower"): _unit(550 * 12 * _INCH * _POUND * _GRAVITY, **_POWER),
    ("PS", "metric_horsepower"): _unit(75 * _GRAVITY, **_POWER),
    ("gal", "gallon", "gallons"): _unit(231 * _INCH**3, **_VOLUME),
}
"""Units without prefixes, by symbols and names."""

_UNITS = _SYMBOLS | _NAMES | {name: unit for names, unit in _OTHERS.items() for name in names}
