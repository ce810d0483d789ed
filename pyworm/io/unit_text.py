"""Units as users write them, parsed by a small grammar into names with their powers.

    unit   = [1] factor { [* or / or blank or point] factor }
    factor = name [exponent] | ( unit )

What is no unit (other numbers, sums, powers of powers) is refused here, in time that grows with the length of
the text and with nothing else.
"""

import re

MAX_UNIT_LENGTH = 60
"""Characters of the longest unit that is read."""

_TOKEN = re.compile(
    r"\s*(?:(?P<name>[^\W\d_][^\W\d]*|%|°[CF]?)(?P<power>(?:\s*(?:\*\*|\^)\s*)?-?\d)?"
    r"|(?P<divide>/)|(?P<times>\*(?!\*)|·|⋅)|(?P<open>\()|(?P<close>\))|(?P<one>1)(?![\d.]))"
)

_RUN_TOGETHER = re.compile(r"([kMG]?N)(mm|cm|m)|([mkMG]?Pa)(s)")
"""Products that are written without a blank: N m of torques, Pa s of viscosities."""

_SUPERSCRIPTS = str.maketrans({"²": "2", "³": "3", "⁴": "4", "⁻": "-", "¹": "1"})

_RENAMED = {"%": "percent", "°": "degree", "°C": "degC", "°F": "degF", "percent": "percent"}

_ROTATIONS = ("1/min", "/min", "min-1", "min^-1", "min**-1", "r/min", "rev/min", "U/min", "RPM")
"""What revolutions in a minute are written as, beside rpm."""

_CELSIUS = ("degC", "°C", "C", "℃", "deg C", "° C")
_FAHRENHEIT = ("degF", "°F", "F", "℉", "deg F", "° F")

_POUND_INCHES = (
    "in-lb",
    "in lb",
    "lb in",
    "lb-in",
    "in-lbs",
    "in lbs",
    "in-lbf",
    "lbf-in",
    "in.lb",
    "lb.in",
)
_POUND_FEET = (
    "ft-lb",
    "ft lb",
    "lb ft",
    "lb-ft",
    "ft-lbs",
    "ft lbs",
    "ft-lbf",
    "lbf-ft",
    "ft.lb",
    "lb.ft",
)

MEANT = {
    "N m": dict.fromkeys(_POUND_INCHES, "lbf in") | dict.fromkeys(_POUND_FEET, "lbf ft"),
    "rad/s": dict.fromkeys(_ROTATIONS, "rpm"),
    "K": dict.fromkeys(_CELSIUS, "degC") | dict.fromkeys(_FAHRENHEIT, "degF"),
    "delta_degC": dict.fromkeys(_CELSIUS, "delta_degC") | dict.fromkeys(_FAHRENHEIT, "delta_degF"),
    "W/(m K)": dict.fromkeys(("W/mK", "W/m K", "W/m/K"), "W/(m K)"),
    "J/(kg K)": dict.fromkeys(("J/kgK", "J/kg K", "J/kg/K"), "J/(kg K)"),
}
"""Unit that is wanted -> how people write it, and what they mean: elsewhere C is no temperature, mK is a
thousandth of a kelvin, and lb a mass; of torques it is the force."""

DIVISORS_ONLY = ("degC", "degF")
"""Temperature scales with an offset; below a fraction bar they are differences."""


def plain(text: str) -> str:
    """A unit with its exponents on the line: "min⁻¹" as "min-1"."""
    return text.translate(_SUPERSCRIPTS).strip()


def factors(text: str) -> tuple[tuple[str, int], ...]:
    """The names in a unit, each with its power; ValueError of what follows no such grammar."""
    if len(text) > MAX_UNIT_LENGTH:
        raise ValueError(f"a unit of {len(text)} characters")
    text = plain(text)
    if text in _RENAMED or text in DIVISORS_ONLY:
        return ((_RENAMED.get(text, text), 1),)
    found: list[tuple[str, int]] = []
    below = [False]  # of each open bracket, whether it stands below a fraction bar
    position, whole, bar = (
        0,
        False,
        False,
    )  # whole: whether the last part ends a factor; bar: whether it is one
    while position < len(text):
        match = _TOKEN.match(text, position)
        if match is None:
            raise ValueError(f'"{text}" is no unit')
        if match["divide"] or match["times"] or match["close"]:
            if not whole or (match["close"] and len(below) == 1):
                raise ValueError(f'"{text}" is no unit')
            if match["close"]:
                below.pop()
            whole, bar = bool(match["close"]), bool(match["divide"])
            position = match.end()
            continue
        if match["one"] and (position or not text[match.end() :].lstrip().startswith("/")):
            raise ValueError(f'"{text}" has a number within')
        divisor = below[-1] != bar
        if match["open"]:
            below.append(divisor)
        elif match["name"]:
            found += _powers(match, divisor)
        position, whole, bar = match.end(), not match["open"], False
    if (position and not whole) or len(below) > 1:
        raise ValueError(f'"{text}" is no unit')
    return tuple(found)


def _powers(match: re.Match[str], divisor: bool) -> list[tuple[str, int]]:
    """One name with its power, or two that are run together."""
    name = _RENAMED.get(match["name"], match["name"])
    if name == "percent" or (name in DIVISORS_ONLY and not divisor):
        raise ValueError(f'"{name}" is a unit only by itself')
    together = _RUN_TOGETHER.fullmatch(name)
    names = filter(None, together.groups()) if together else (name,)
    power = int((match["power"] or "1").strip("*^ \t"))
    return [(name, -power if divisor else power) for name in names]
