"""What the pictures of a gear pair show beside solutions: its line of action with the closed forms there."""

import json
from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr

from pyworm.variables import describe

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
    contacts: Any,
    rating: Any,
    marks: Mapping[str, float],
    driver: str,
    friction_coefficient: float | None,
) -> xr.Dataset:
    """The contacts along a line of action as one dataset over phase.

    Parameters
    ----------
    contacts : ToothContacts
        The contacts, arrays over phase.
    rating : GearRating
        Closed forms there; what it does not know is left out.
    marks : mapping
        Name of a point of the line of action -> its phase.
    driver : str
        "pinion" or "gear".
    friction_coefficient : float or None
        That of the flash temperature.
    """
    columns = {name: getattr(contacts, name) for name in _CONTACTS}
    columns |= {f"closed_form_{name}": getattr(rating, name) for name in _RATING}
    attributes = {"drive": KIND, "driver": driver, "marks": json.dumps(dict(marks))}
    for name, value in (
        ("friction_coefficient", friction_coefficient),
        ("scuffing_temperature_K", rating.scuffing_temperature),
    ):
        if value is not None:
            attributes[name] = value
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
