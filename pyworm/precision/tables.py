"""A study as tables for the console, as CSV and as JSON."""

import csv
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from pyworm.io.quantities import QUANTITIES
from pyworm.precision.study import TARGETS, Study

UNITS = {
    name: QUANTITIES[name].key for name in ("film_min", "film_central", "friction_coefficient")
} | {"temperature_max_film": "temperature_rise_max_K"}
"""Figure -> its key in CSV and JSON, of temperatures that of the rise."""

KINDS = {"formula": "formula", "model": "rung", "parameter": "knob"}
"""Kind of a curve -> its name in CSV and JSON, unchanged for programs that read them."""


def rows(study: Study) -> Iterator[dict[str, Any]]:
    """Yield an object for each point, units in the keys, errors relative."""
    for curve in study.curves:
        for point in curve.points:
            row: dict[str, Any] = {
                "kind": KINDS[curve.kind],
                "curve": curve.name,
                "grid": " x ".join(str(points) for points in point.shape),
                "setting": point.setting,
                "seconds": point.seconds,
                "convolutions": point.convolutions or None,
                "settled": point.converged,
            }
            for figure in study.references:
                row[UNITS[figure]] = point.figures.get(figure)
                row[f"{figure}_error"] = study.error(point, figure)
                row[f"{figure}_extrapolated_error"] = study.limit_error(point, figure)
                row[f"{figure}_grid_error"] = study.grid_error(curve, point, figure)
            yield row


def as_object(study: Study) -> dict[str, Any]:
    """The study as one object for JSON."""
    return {
        "scene": study.scene_name,
        "inlet_temperature_K": study.inlet_temperature,
        "references": {
            UNITS[figure]: {
                "value": reference.value,
                "relative_to": reference.size,
                "uncertainty": reference.band,
            }
            for figure, reference in study.references.items()
        },
        "rungs": {
            curve.name: {
                UNITS[figure]: {
                    "order": limit.order,
                    "model_error": study.model_error(curve, figure),
                }
                for figure, limit in curve.limits.items()
                if figure in study.references
            }
            for curve in study.curves
            if curve.kind == "model"
        },
        "cheapest": [_cheapest(study, accuracy) for accuracy in TARGETS],
        "points": list(rows(study)),
        "left_out": list(study.omitted),
        "seconds": study.seconds,
    }


def _cheapest(study: Study, accuracy: float) -> dict[str, Any]:
    asked = {UNITS[figure]: (figure,) for figure in study.references}
    found: dict[str, Any] = {"accuracy": accuracy}
    for key, figures in {**asked, "all": tuple(study.references)}.items():
        choice = study.cheapest(accuracy, figures)
        found[key] = choice and {
            "curve": choice[0].name,
            "grid": list(choice[1].shape),
            "seconds": choice[1].seconds,
            "convolutions": choice[1].convolutions or None,
        }
    return found


def write_csv(study: Study, path: Path) -> None:
    """Write all points, a row each."""
    table = list(rows(study))
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(table[0]))
        writer.writeheader()
        writer.writerows(table)
