"""Numbers, durations, shares and quantities as text."""

from math import isfinite, isinf

from pyworm.io.number_with_unit import converted, parse_in
from pyworm.io.quantity import Kind

UNKNOWN = "unknown"
"""An uncertainty without a bound, as text."""


def rough(value: float) -> str:
    """An approximate number as text: two digits, without powers of ten."""
    return f"{float(f'{value:.2g}'):.10g}"


def short(value: float) -> str:
    """A value as text: four digits, without exponent where that is short."""
    return f"{value:.0f}" if 1e4 <= abs(value) < 1e7 else f"{value:.4g}"


def duration(seconds: float) -> str:
    """A time [s] as text with a suitable unit."""
    return f"{rough(seconds)} s" if seconds >= 0.01 else f"{rough(seconds * 1e3)} ms"


def percent(share: float, digits: int = 2) -> str:
    """A fraction as text, in per cent, with some digits."""
    number = 100 * share
    return f"{number:.0f} %" if number >= 10**digits - 0.5 else f"{number:.{digits}g} %"


def with_bars(
    value: str,
    error: float,
    model: float | None = None,
    scale: float = 100.0,
    unit: str = " %",
    reason: str | None = None,
) -> str:
    """A value with its error bars as text; a lower bound, with the reason, where the error has no bound.

    Errors without a bound are those of unresolved peaks, of which a grid shows no more than there is.
    """
    because = "" if reason is None else f" ({reason})"
    if isinf(error):
        return f"≥ {value}{model_bar(model, scale, unit)}{because or ' (error not known)'}"
    return f"{value} {bars(error, model, scale, unit)}{because}"


def bars(error: float, model: float | None, scale: float = 100.0, unit: str = " %") -> str:
    """Error bars as text, relative ones in per cent: the numerical one and, if there is one, the model's."""
    return f"± {rough(error * scale)}{unit}{model_bar(model, scale, unit)}"


def uncertainty_label(error: float) -> str:
    """What an unusual uncertainty is called, before its reason."""
    return "numerical uncertainty" if isfinite(error) else "no upper bound"


def model_bar(model: float | None, scale: float = 100.0, unit: str = " %") -> str:
    """The model uncertainty as text behind another error bar; empty where there is none.

    It is unknown (infinite) where no film was found under a change of what the model assumes.
    """
    if model is None:
        return ""
    return f" ± {UNKNOWN if isinf(model) else rough(model * scale) + unit} (model)"


_FINER = {"mm": "µm", "Pa s": "mPa s", "GPa": "MPa", "kN": "N", "kW": "W"}
"""Units shown for values below a twentieth of those of the examples."""

_PRINTED = (("deg", "°"), ("^2", "²"), ("^3", "³"), ("um", "µm"))
"""Parts of units as written -> as printed."""


def as_text(value: float, kind: Kind) -> str:
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
    _, written = parse_in(text)
    if not written:
        return f"{value:.4g}"
    return f"{converted(value, unit, written):.4g} {written}"
