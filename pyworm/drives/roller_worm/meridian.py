"""Meridian of a roller as a case file gives it: a closed form of the place along the axis, or points.

The radius is rho(s) = radius + rise(s). A formula is read as an expression of s, radius and length and never
run as code; it is evaluated with its first and second derivative by s, which are exact to rounding. Points
are joined by a cubic spline.
"""

import ast
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import scipy

from pyworm.io import units

Array = np.ndarray

FEWEST_POINTS = 4
"""Points that a cubic spline without further conditions needs."""

LONGEST_FORMULA = 200
"""Characters of a formula; those of rollers have some twenty."""

NAMES = "s", "radius", "length"
"""Variables of a formula, all in metres."""

Jet = tuple[Any, Any, Any]
"""A value with its first and second derivative by s."""

_FUNCTIONS: dict[str, Callable[[Any], Jet]] = {
    "sqrt": lambda u: (np.sqrt(u), u**-0.5 / 2, -(u**-1.5) / 4),
    "exp": lambda u: (np.exp(u),) * 3,
    "log": lambda u: (np.log(u), 1 / u, -1 / u**2),
    "sin": lambda u: (np.sin(u), np.cos(u), -np.sin(u)),
    "cos": lambda u: (np.cos(u), -np.sin(u), -np.cos(u)),
    "cosh": lambda u: (np.cosh(u), np.sinh(u), np.cosh(u)),
}
"""Function -> its value and its derivatives by its argument."""


@dataclass(frozen=True)
class Meridian:
    """Rise of a roller's radius along its axis, by a formula or by points."""

    formula: str = ""
    """Rise [m] as a formula of s, radius and length [m], such as "sqrt(radius^2 - s^2) - radius"."""
    places: tuple[units.Offset, ...] = ()
    """Places of points along the axis from the roller's middle, rising, over the whole length [m]."""
    rises: tuple[units.Offset, ...] = ()
    """Rises of the radius there [m]."""

    def __call__(self, place: Array, radius: float, length: float) -> Jet:
        """Rise [m], slope [-] and second derivative [1/m]; straight on beyond the roller's ends."""
        inside = np.clip(place, -length / 2, length / 2)
        if self.formula:
            unit, none = np.ones(np.shape(inside)), np.zeros(np.shape(inside))
            values = {"s": (inside, unit, none), "radius": (radius, 0, 0), "length": (length, 0, 0)}
            rise, slope, bend = (part + none for part in _jet(read_formula(self.formula), values))
        else:
            spline = scipy.interpolate.CubicSpline(self.places, self.rises)
            rise, slope, bend = (spline(inside, order) for order in range(3))
        return rise + slope * (place - inside), slope, np.where(place == inside, bend, 0.0)


def read_formula(text: str) -> ast.expr:
    """The expression of a formula; ValueError where it has more than numbers, `NAMES` and functions."""
    if len(text) > LONGEST_FORMULA:
        raise ValueError(f"a formula has at most {LONGEST_FORMULA} characters")
    try:
        expression = ast.parse(text.replace("^", "**").strip(), mode="eval").body
    except SyntaxError:
        raise ValueError(f'"{text}" is no formula') from None
    if not _readable(expression):
        raise ValueError(
            f'"{text}": a formula has numbers, {", ".join(NAMES)}, + - * /, ^ with a number, and '
            f"{', '.join(_FUNCTIONS)}"
        )
    return expression


def _readable(node: ast.AST) -> bool:
    match node:
        case ast.Constant(value):
            return isinstance(value, int | float) and not isinstance(value, bool)
        case ast.Name(name):
            return name in NAMES
        case ast.Call(ast.Name(name), [argument], []):
            return name in _FUNCTIONS and _readable(argument)
        case ast.UnaryOp(ast.USub(), part):
            return _readable(part)
        case ast.BinOp(first, ast.Pow(), ast.Constant() as power):
            return _readable(first) and _readable(power)
        case ast.BinOp(first, ast.Add() | ast.Sub() | ast.Mult() | ast.Div(), other):
            return _readable(first) and _readable(other)
    return False


def _jet(node: ast.AST, values: Mapping[str, Jet]) -> Jet:
    """Value and derivatives of an expression that `read_formula` has accepted."""
    match node:
        case ast.Constant(value):
            return value, 0.0, 0.0
        case ast.Call(ast.Name(name), [argument]):
            u, first, second = _jet(argument, values)
            f, by_u, by_u_twice = _FUNCTIONS[name](u)
            return f, by_u * first, by_u_twice * first**2 + by_u * second
        case ast.UnaryOp(_, part):
            value, first, second = _jet(part, values)
            return -value, -first, -second
        case ast.BinOp(base, ast.Pow(), ast.Constant(int() | float() as power)):
            return _power(_jet(base, values), power)
        case ast.BinOp(left, operation, right):
            return _combined(_jet(left, values), operation, _jet(right, values))
    return values[node.id]  # type: ignore[attr-defined]  # a name


def _combined(a: Jet, operation: ast.operator, b: Jet) -> Jet:
    if isinstance(operation, ast.Add):
        return a[0] + b[0], a[1] + b[1], a[2] + b[2]
    if isinstance(operation, ast.Sub):
        return a[0] - b[0], a[1] - b[1], a[2] - b[2]
    if isinstance(operation, ast.Div):
        b = _power(b, -1)
    return a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + 2 * a[1] * b[1] + a[0] * b[2]


def _power(base: Jet, power: float) -> Jet:
    u, first, second = base
    u = np.asarray(u, float)
    by_u = power * u ** (power - 1) if power else 0.0
    by_u_twice = power * (power - 1) * u ** (power - 2) if power not in (0, 1) else 0.0
    return u**power, by_u * first, by_u_twice * first**2 + by_u * second
