"""Dataset of a gear pair for pictures: its line of action with the closed forms there."""

import json
from collections.abc import Mapping
from typing import Any

import numpy as np

from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import describe

KIND = "gear-pair"

_CONTACTS = (
    "roll_angle",
    "radius",
    "pinion_velocity",
    "gear_velocity",
    "unit_load",
    "load_share",
    "pinion_specific_sliding",
    "gear_specific_sliding",
)

_RATING = (
    "hertz_pressure",
    "film_central",
    "film_min",
    "specific_film",
    "flash_temperature",
    "contact_temperature",
)


def line_of_action_data(
    contacts: Any, rating: Any, marks: Mapping[str, float], driver: str
) -> "xr.Dataset":
    """The contacts along a line of action, and closed forms where known, as a dataset over phase.

    `marks` has the phases of points of the line of action by their names.
    """
    columns = {name: getattr(contacts, name) for name in _CONTACTS}
    columns |= {f"closed_form_{name}": getattr(rating, name) for name in _RATING}
    attributes = {"drive": KIND, "driver": driver, "marks": json.dumps(dict(marks))}
    if rating.scuffing_temperature is not None:
        attributes["scuffing_temperature_K"] = rating.scuffing_temperature
    return describe(
        xr.Dataset(
            {
                name: ("phase", np.asarray(values, float))
                for name, values in columns.items()
                if values is not None
            },
            coords={"phase": np.asarray(contacts.phase)},
            attrs=attributes,
        )
    )


def with_friction(data: "xr.Dataset", friction: float, load_factor: np.ndarray) -> "xr.Dataset":
    """Add a coefficient of friction, and what it does to the normal load, to `line_of_action_data`."""
    data = data.assign(friction_load_factor=("phase", load_factor))
    return describe(data.assign_attrs(friction_coefficient=friction))
