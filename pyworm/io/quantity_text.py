"""Values in SI as text, in the units that people write them with."""

from pyworm.io.number_with_unit import converted, parse_in
from pyworm.io.quantity import Kind

_FINER = {"mm": "µm", "Pa s": "mPa s", "GPa": "MPa", "kN": "N", "kW": "W"}
"""Units shown for values below a twentieth of those of the examples."""

_PRINTED = (("deg", "°"), ("^2", "²"), ("^3", "³"), ("um", "µm"))
"""Parts of units as written -> as printed."""


def shown(value: float, kind: Kind) -> str:
    """A value in SI as text: in the unit of its kind's example, or a smaller one."""
    if kind.unit == "":
        return f"{value * 100:.4g} %"
    _, unit = parse_in(kind.example)
    number = converted(value, kind.unit, unit)
    if abs(number) < 0.05 and number != 0 and unit in _FINER:
        unit = _FINER[unit]
        number = converted(value, kind.unit, unit)
    for written, printed in _PRINTED:
        unit = unit.replace(written, printed)
    return f"{number:.5g} {unit}"


def shown_like(value: float, unit: str, text: str) -> str:
    """A value in an SI unit as another quantity, given as text, is written."""
    _, own = parse_in(text)
    if not own:
        return f"{value:.4g}"
    return f"{converted(value, unit, own):.4g} {own}"
