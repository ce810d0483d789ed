"""The loaded tooth contact analysis of a worm stage in a REXS model: pressure, sliding and film."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from pyworm.case.case import case_again
from pyworm.case.rexs_slots import CUSTOM, in_rexs
from pyworm.case.to_rexs import rexs_model
from pyworm.io.input_error import CaseError
from pyworm.io.rexs import Model, Value
from pyworm.result.mesh_cycle import drive_cycle
from pyworm.result.result import Result

_STRESS = "hertzian_stress_ltca_worm_stage"
_SLIDING = "sliding_velocity_ltca_worm_stage"
_FILM = "minimum_lubricant_film_thickness_ltca_worm_stage"

_REXS_STRESS = "MPa"
"""Unit of stresses in REXS."""

ANALYSED = (
    (
        (f"minimum_{_STRESS}", f"mean_{_STRESS}", f"maximum_{_STRESS}"),
        *(_REXS_STRESS, "dry_pressure_max_Pa"),
    ),
    (
        (f"minimum_{_SLIDING}", f"mean_{_SLIDING}", f"maximum_{_SLIDING}"),
        *("m / s", "sliding_speed_m_per_s"),
    ),
    (
        (f"minimum_value_{_FILM}", f"mean_{_FILM}", f"maximum_value_{_FILM}"),
        *("mum", "film_min_m"),
    ),
)
"""Attributes of the least, mean and largest value over the contacts, their unit, and the contacts' entry."""

CURVES = (
    ("phase", "none", "phase"),
    ("normal_load", "N", "load_N"),
    ("maximum_hertzian_stress", _REXS_STRESS, "dry_pressure_max_Pa"),
    ("minimum_lubricant_film_thickness", "mum", "film_min_m"),
    ("central_lubricant_film_thickness", "mum", "film_central_m"),
    ("coefficient_of_friction", "none", "friction_coefficient"),
)
"""Attribute of one's own with a number for each contact, its unit, and the entry of the contact."""


def rexs_of_result(result: Result) -> Model:
    """The REXS model of a result about a worm drive, with its loaded contact analysis.

    CaseError of a result of another kind, or without a converged contact.
    """
    case = case_again(result.case)
    model = rexs_model(case)
    sound = sorted(
        (_contact(result, solution.summary()) for solution in result.sound.solutions),
        key=lambda contact: contact["phase"],
    )
    if not sound:
        raise CaseError(f"{result.case_name}: no contact converged, there is nothing to write")
    (stage,) = model.of_kind("worm_stage")
    added = Model(model.application).add("", "", dict(_analysis(result, sound)))
    stage.attributes |= added.attributes
    return model


def _contact(result: Result, summary: Mapping[str, Any]) -> dict[str, Any]:
    """Scalars of a contact, with the sliding speed of its phase."""
    cycle = result.cycle_data
    if "load_phase" not in cycle:
        return dict(summary)
    speed = np.interp(summary["phase"], cycle["load_phase"], cycle["sliding_speed"])
    return {**summary, "sliding_speed_m_per_s": float(speed)}


def _analysis(
    result: Result, contacts: list[dict[str, Any]]
) -> Iterator[tuple[str, tuple[Value, str]]]:
    """Attributes of the stage from its solved contacts; of what is not solved none."""
    for names, unit, entry in ANALYSED:
        values = np.array([contact[entry] for contact in contacts if entry in contact])
        if values.size:
            found = values.min(), values.mean(), values.max()
            for name, value in zip(names, found, strict=True):
                yield name, (in_rexs(float(value), unit), unit)
    for name, unit, entry in CURVES:
        if all(contact.get(entry) is not None for contact in contacts):
            row = tuple(in_rexs(contact[entry], unit) for contact in contacts)
            yield f"{CUSTOM}{name}", (row, unit)
    cycle = drive_cycle(result)
    if cycle is not None and cycle.loss is not None:
        yield f"{CUSTOM}meshing_power_loss", (in_rexs(cycle.loss.power, "W"), "W")
        yield f"{CUSTOM}mean_coefficient_of_friction", (cycle.loss.friction, "none")
        yield f"{CUSTOM}efficiency", (cycle.loss.efficiency, "none")
        yield f"{CUSTOM}efficiency_reverse", (cycle.loss.reverse_efficiency, "none")
