"""Units as users write them, parsed by a small grammar before pint evaluates them.

    unit   = [1] factor { [* or / or blank or point] factor }
    factor = name [exponent] | ( unit )

What is no unit (other numbers, sums, powers of powers) is refused here, in time that grows with the length of
the text and with nothing else.
"""

import re

LONGEST = 60
"""Characters of the longest unit that is read."""

_TOKEN = re.compile(
    r"\s*(?:(?P<name>[^\W\d_][^\W\d]*|%|°[CF]?)(?P<power>(?:\s*(?:\*\*|\^)\s*)?-?\d)?"
    r"|(?P<divide>/)|(?P<times>\*(?!\*)|·|⋅)|(?P<open>\()|(?P<close>\))|(?P<one>1)(?![\d.]))"
)

_RUN_TOGETHER = re.compile(r"([kMG]?N)(mm|cm|m)|([mkMG]?Pa)(s)")
"""Products that are written without a blank: N m of torques, Pa s of viscosities."""

_SUPERSCRIPTS = str.maketrans({"²": "2", "³": "3", "⁴": "4", "⁻": "-", "¹": "1"})

_RENAMED = {"%": "percent", "°": "degree", "°C": "degC", "°F": "degF", "percent": "percent"}

ROTATIONS = ("1/min", "min-1", "min^-1", "min**-1", "r/min", "rev/min", "U/min")
"""What revolutions in a minute are written as, beside rpm."""

DIVISORS_ONLY = ("degC", "degF")
"""Temperature scales with an offset; below a fraction bar they are differences."""


def plain(text: str) -> str:
    """A unit with its exponents on the line: "min⁻¹" as "min-1"."""
    return text.translate(_SUPERSCRIPTS).strip()


def expression(text: str) -> str:
    """A unit as an expression of names, products, quotients and powers of one digit.

    Raises
    ------
    ValueError
        What follows no such grammar.
    """
    if len(text) > LONGEST:
        raise ValueError(f"a unit of {len(text)} characters")
    text = plain(text)
    if text in _RENAMED or text in DIVISORS_ONLY:
        return _RENAMED.get(text, text)
    parts: list[str] = []
    below = [False]  # of each open bracket, whether it stands below a fraction bar
    at, whole = 0, False  # whole: whether the last part ends a factor
    while at < len(text):
        match = _TOKEN.match(text, at)
        if match is None:
            raise ValueError(f'"{text}" is no unit')
        at = match.end()
        if match["divide"] or match["times"] or match["close"]:
            if not whole or (match["close"] and len(below) == 1):
                raise ValueError(f'"{text}" is no unit')
            if match["close"]:
                below.pop()
            parts.append(match["divide"] or match["close"] or "*")
            whole = bool(match["close"])
            continue
        if match["one"] and (parts or not text[at:].lstrip().startswith("/")):
            raise ValueError(f'"{text}" has a number within')
        parts += ["*"] * whole
        divisor = below[-1] != (parts[-1:] == ["/"])
        if match["open"]:
            below.append(divisor)
        parts.append(_factor(match, divisor))
        whole = not match["open"]
    if (parts and not whole) or len(below) > 1:
        raise ValueError(f'"{text}" is no unit')
    return "".join(parts)


def _factor(match: re.Match, divisor: bool) -> str:
    """One name with its power, an opening bracket or the one of a reciprocal."""
    if match["name"] is None:
        return match["open"] or match["one"]
    name = _RENAMED.get(match["name"], match["name"])
    if name == "percent" or (name in DIVISORS_ONLY and not divisor):
        raise ValueError(f'"{name}" is a unit only by itself')
    together = _RUN_TOGETHER.fullmatch(name)
    if together:
        name = f"({'*'.join(filter(None, together.groups()))})"
    power = (match["power"] or "").strip("*^ \t")
    return f"{name}**({power})" if power else name
