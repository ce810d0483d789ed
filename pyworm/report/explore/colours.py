"""What the page shows: fields and flank maps by name, with words, units and colours."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from pyworm.io.quantities import QUANTITIES

FIELDS = (
    "film", "pressure", "dry_pressure", "asperity_pressure", "temperature_middle", "temperature_body_1",
    "temperature_body_2", "friction_power", "shear_stress", "sliding", "fatigue_ratio_body_1",
    "fatigue_ratio_body_2",
)  # fmt: skip
"""Fields of a contact that are shown, or lengths of vectors of fields."""

FLANK = (
    "film", "pressure", "temperature_body_2", "temperature_middle", "asperity_pressure", "entry",
    "fatigue_ratio_body_2", "pitting_probability",
)  # fmt: skip
"""Variables of the flank map that are shown."""


def shown(
    names: Sequence[str], known: set[str], bodies: tuple[str, str], extremes: bool = False
) -> dict[str, dict[str, Any]]:
    """How those quantities that are known are shown, by the script of the page; maybe as `extremes`."""
    chosen = [QUANTITIES[name] for name in names if name in known]
    return {
        quantity.name: {
            "label": quantity.worst(bodies) if extremes else quantity.words(bodies),
            "unit": quantity.shown,
            "colours": quantity.colours,
            "logarithmic": quantity.logarithmic,
            "clip": quantity.clip,
        }
        for quantity in chosen
    }


def colours(name: str) -> list[str]:
    """A colour map of matplotlib in 64 steps."""
    import matplotlib
    from matplotlib.colors import to_hex

    return [to_hex(colour) for colour in matplotlib.colormaps[name](np.linspace(0, 1, 64))]


def used(*shown_quantities: dict[str, Any]) -> dict[str, list[str]]:
    """The colour maps that they name."""
    return {
        quantity["colours"]: colours(quantity["colours"])
        for quantities in shown_quantities
        for quantity in quantities.values()
    }
