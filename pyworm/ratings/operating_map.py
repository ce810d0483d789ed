"""Films, temperatures and asperities of a gear set over speed and load, by closed forms of all its contacts.

At each operating point the contacts that the case lists are predicted at the loads and velocities there, as
for the friction of a mesh (`mesh_estimate`), with teeth and oil at the inlet temperature; films are reduced
by the heat of the inlet (`thermal_reduction.wilson_sheu`).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pyworm.drives.drive import Drive
from pyworm.formulas import thermal_reduction
from pyworm.formulas.arrays import Array
from pyworm.formulas.unit_factors import RPM, ZERO_CELSIUS
from pyworm.io.present import present
from pyworm.planning.prediction import Prediction, predicted
from pyworm.ratings.films import MOST_SLIDING
from pyworm.ratings.mesh_estimate import MeshFriction, estimated
from pyworm.scene.index import ContactIndex

MAPPED_QUANTITIES = ("film_min", "specific_film", "asperity_load_fraction", "temperature_max")
"""Quantities of an operating point, by their names: extremes over all contacts."""


@dataclass(frozen=True)
class OperatingMap:
    """Extremes over the contacts of a gear set at its operating points."""

    speeds: tuple[float, ...]
    """Speeds of the first shaft [rad/s]."""
    torques: tuple[float, ...]
    """Torques of the second shaft [N m]."""
    values: dict[str, Array]
    """Quantity -> its extreme at each point [SI], (speeds, torques); NaN where it is unknown."""
    places: dict[str, list[list[str]]]
    """Quantity -> contact that has it, at each point."""

    def summary(self) -> list[dict[str, Any]]:
        """The points as objects, units in the keys."""
        return [
            {
                "speed_rpm": speed * RPM,
                "torque_N_m": torque,
                "film_min_m": float(self.values["film_min"][i, j]),
                "film_min_at": self.places["film_min"][i][j],
                "specific_film": float(self.values["specific_film"][i, j]),
                "asperity_load_fraction": float(self.values["asperity_load_fraction"][i, j]),
                "temperature_max_C": float(self.values["temperature_max"][i, j]) - ZERO_CELSIUS,
                "temperature_max_at": self.places["temperature_max"][i][j],
            }
            for i, speed in enumerate(self.speeds)
            for j, torque in enumerate(self.torques)
        ]


def operating_map(
    drive: Drive,
    places: Sequence[ContactIndex],
    speeds: Sequence[float],
    torques: Sequence[float],
) -> OperatingMap:
    """The map over speeds of the first shaft [rad/s] and torques of the second [N m].

    Raises:
        ValueError: An oil without flow law or heat, or a load that is not that of a shaft.
    """
    shape = len(speeds), len(torques)
    values = {name: np.full(shape, np.nan) for name in MAPPED_QUANTITIES}
    where = {name: [[""] * shape[1] for _ in speeds] for name in MAPPED_QUANTITIES}
    for i, speed in enumerate(speeds):
        for j, torque in enumerate(torques):
            found = _extremes(drive.at_load(speed, torque), places)
            for name, (value, place) in found.items():
                values[name][i, j], where[name][i][j] = value, place
    return OperatingMap(tuple(speeds), tuple(torques), values, where)


def _extremes(drive: Drive, places: Sequence[ContactIndex]) -> dict[str, tuple[float, str]]:
    """Extremes over the contacts of a drive, each with its contact."""
    friction = MeshFriction(drive, places)
    inlet = present(drive.oil_supplied.heat, "oil.heat").inlet_temperature
    rows: list[tuple[str, dict[str, float]]] = []
    for scene in friction.warmed(inlet):
        prediction = _heated(predicted(scene))
        contact = estimated(prediction)
        row = {
            "film_min": contact.film_min,
            "specific_film": contact.specific_film,
            "asperity_load_fraction": contact.asperity_load_fraction,
            "temperature_max": inlet + contact.surface_rise,
        }
        rows.append((str(ContactIndex.of(scene)), row))
    found = {}
    for name in MAPPED_QUANTITIES:
        least = name in ("film_min", "specific_film")
        place, row = (min if least else max)(rows, key=lambda pair: pair[1][name])
        found[name] = row[name] if np.isfinite(row[name]) else np.nan, place
    return found


def _heated(prediction: Prediction) -> Prediction:
    """The prediction with films reduced by the heat of the inlet; unchanged without entrainment."""
    if prediction.speed <= 0:
        return prediction
    loading = thermal_reduction.thermal_loading(
        prediction.oil.viscosity.eta0,
        prediction.inlet_beta,
        prediction.speed,
        prediction.oil.thermal.conductivity,
    )
    ratio = min(prediction.sliding / prediction.speed, MOST_SLIDING)
    left = float(thermal_reduction.wilson_sheu(loading, ratio))
    films = prediction.film_central * left, prediction.film_min * left
    return replace(prediction, film_central=films[0], film_min=films[1])
