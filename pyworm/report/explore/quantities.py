"""What the page shows: fields and flank maps by name, with words, units and colours."""

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from pyworm.formulas.unit_factors import ZERO_CELSIUS


@dataclass(frozen=True)
class Quantity:
    """How a field is shown.

    Attributes
    ----------
    label, unit : str
        Words, and the unit shown.
    scale, offset : float
        Shown value = (value in SI - offset) * scale.
    colours : str
        Colour map.
    logarithmic : bool
        Whether it is stored by its logarithm.
    clip : float
        Largest shown value over the least film in the contact; 0 where colours span all values.
    """

    label: str
    unit: str
    scale: float = 1.0
    offset: float = 0.0
    colours: str = "inferno"
    logarithmic: bool = False
    clip: float = 0.0


FIELDS = {
    "film": Quantity("film thickness", "µm", 1e6, 0.0, "viridis", True, 6.0),
    "pressure": Quantity("pressure", "MPa", 1e-6),
    "dry_pressure": Quantity("pressure of the dry contact", "MPa", 1e-6),
    "asperity_pressure": Quantity("pressure on asperities", "MPa", 1e-6),
    "temperature_middle": Quantity("temperature in the middle of the film", "°C", 1, ZERO_CELSIUS),
    "temperature_body_1": Quantity("temperature of the {0}", "°C", 1, ZERO_CELSIUS),
    "temperature_body_2": Quantity("temperature of the {1}", "°C", 1, ZERO_CELSIUS),
    "friction_power": Quantity("heat of friction", "MW/m²", 1e-6),
    "shear_stress": Quantity("shear stress", "MPa", 1e-6, 0.0, "cividis"),
    "sliding": Quantity("sliding speed", "m/s", 1.0, 0.0, "cividis"),
}
"""Field, or length of a vector of fields -> how it is shown."""

FLANK = {
    "film": Quantity("least film", "µm", 1e6, 0.0, "viridis", True, 6.0),
    "pressure": Quantity("largest pressure", "MPa", 1e-6),
    "temperature_body_2": Quantity("largest temperature of the {1}", "°C", 1, ZERO_CELSIUS),
    "temperature_middle": Quantity("largest temperature of the film", "°C", 1, ZERO_CELSIUS),
    "asperity_pressure": Quantity("largest pressure on asperities", "MPa", 1e-6),
    "entry": Quantity(
        "least speed of oil into the contact over the mean entrainment", "", 1.0, 0.0, "viridis"
    ),
}
"""Variable of the flank map -> how it is shown."""


def shown(quantities: dict[str, Quantity], names: set[str], bodies: tuple[str, str]) -> dict:
    """Those of some names in their order, for the page."""
    return {
        name: asdict(of) | {"label": of.label.format(*bodies)}
        for name, of in quantities.items()
        if name in names
    }


def colours(name: str) -> list[str]:
    """A colour map of matplotlib in 64 steps."""
    import matplotlib
    from matplotlib.colors import to_hex

    return [to_hex(of) for of in matplotlib.colormaps[name](np.linspace(0, 1, 64))]


def used(*shown_quantities: dict[str, Any]) -> dict[str, list[str]]:
    """The colour maps that they name."""
    return {
        of["colours"]: colours(of["colours"]) for one in shown_quantities for of in one.values()
    }
