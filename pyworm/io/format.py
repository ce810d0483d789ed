"""Rounded numbers and durations as text."""

from math import isinf

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


def percent(share: float) -> str:
    """A fraction as text, in per cent."""
    return f"{share * 100:.0f} %" if share >= 0.095 else f"{share * 100:.2g} %"


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
    return f"± {error * scale:.2g}{unit}{model_bar(model, scale, unit)}"


def model_bar(model: float | None, scale: float = 100.0, unit: str = " %") -> str:
    """The model uncertainty as text behind another error bar; empty where there is none.

    It is unknown (infinite) where no film was found under a change of what the model assumes.
    """
    if model is None:
        return ""
    return f" ± {UNKNOWN if isinf(model) else f'{model * scale:.2g}{unit}'} (model)"
