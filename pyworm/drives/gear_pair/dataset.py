"""Dataset of a gear pair for pictures: its line of action with the closed forms there."""

import json
from typing import Any

import numpy as np

from pyworm.drives.gear_pair.mesh import GearPairMesh
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


def line_of_action_data(mesh: GearPairMesh) -> "xr.Dataset":
    """The contacts along the line of action, and closed forms where known, as a dataset over phase."""
    contacts, teeth = mesh.contacts(mesh.cycle_phases()), mesh.teeth
    rating = mesh.rating(contacts)
    columns = {name: getattr(contacts, name) for name in _CONTACTS}
    columns |= {f"closed_form_{name}": getattr(rating, name) for name in _RATING}
    marks = {
        "SAP": 0.0,
        "LPSTC": mesh.phase_of(teeth.lowest_single),
        "P": mesh.phase_of(teeth.pitch_point),
        "HPSTC": mesh.phase_of(teeth.highest_single),
        "EAP": 1.0,
    }
    attributes: dict[str, Any] = {"drive": KIND, "driver": mesh.driver, "marks": json.dumps(marks)}
    if rating.scuffing_temperature is not None:
        attributes["scuffing_temperature_K"] = rating.scuffing_temperature
    attributes["loss_factor"] = mesh.loss_factor
    if mesh.surfaces is not None:
        friction = mesh.surfaces.friction_coefficient
        columns["friction_load_factor"] = mesh.friction_load_factor(contacts, friction)
        attributes["friction_coefficient"] = friction
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
