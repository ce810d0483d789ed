"""Numbers for a page: whole numbers of two bytes between the least and the largest value, as text."""

from base64 import b64encode
from math import log
from typing import Any

import numpy as np

LEVELS = 65534
"""Largest whole number of a value: one step is far below any error bar. One more says there is none."""


def packed(values: np.ndarray, logarithmic: bool = False) -> dict[str, Any]:
    """Values row by row, NaN where there are none, as the page unpacks them (`unpacked` in base.js).

    Steps may be even in the logarithm of the values. Others than positive ones are left out then: a film that
    was not found may be negative where the dry bodies overlap.
    """
    if logarithmic:
        values = np.where(values > 0, values, np.nan)
    known = values[np.isfinite(values)]
    if not known.size:
        known = np.ones(1)
    low, high = float(known.min()), float(known.max())
    if logarithmic:
        low, high, values = log(low), log(high), np.log(values)
    step = (high - low) / LEVELS or 1.0
    numbers = np.where(np.isfinite(values), np.rint((values - low) / step), LEVELS + 1)
    data = b64encode(numbers.astype("<u2").tobytes()).decode("ascii")
    return {"low": low, "step": step, "logarithmic": logarithmic, "data": data}
