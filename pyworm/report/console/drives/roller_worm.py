"""The mesh cycle of a roller enveloping drive by closed forms, for people."""

from collections.abc import Callable
from typing import Any

import numpy as np

from pyworm.formulas.unit_factors import RPM
from pyworm.formulas.wear_distress import regime
from pyworm.io.on_demand import xarray as xr
from pyworm.io.quantities import QUANTITIES
from pyworm.report.table import Table

FILM = QUANTITIES["film_min"]


def _at_entry(place: "xr.Dataset", name: str) -> float:
    """A figure of the spin-up where rollers enter; NaN elsewhere, or where rollers do not turn freely."""
    entered = float(place["phase"]) == (0.0 if place.attrs.get("driving") != "right" else 1.0)
    return float(place[name]) if entered and name in place else float("nan")


_ROWS: tuple[tuple[str, Callable[["xr.Dataset"], Any], str], ...] = (
    ("Wheel angle / deg", lambda place: np.degrees(place["wheel_angle"]), ".1f"),
    ("Load per length / kN/m", lambda place: place["load_per_length"] / 1e3, ".1f"),
    ("Relative radius / mm", lambda place: place["contact_radius"] * 1e3, ".3f"),
    ("Induced curvature / 1/mm", lambda place: place["induced_curvature"] / 1e3, ".4f"),
    ("Worm across the line / m/s", lambda place: place["worm_velocity"], ".3f"),
    ("Roller across the line / m/s", lambda place: place["roller_velocity"], ".3f"),
    ("Sliding along the line / m/s", lambda place: place["sliding_along"], ".3f"),
    ("Spin / rad/s", lambda place: place["relative_spin"], ".1f"),
    ("Roller about its axis / rpm", lambda place: place["roller_speed"] * RPM, ".0f"),
    ("Lubrication angle / deg", lambda place: np.degrees(place["lubrication_angle"]), ".1f"),
    ("Self-rotation angle / deg", lambda place: np.degrees(place["self_rotation_angle"]), ".1f"),
    ("Pin, radial load / N", lambda place: place["pin_radial"], ".0f"),
    ("Pin, thrust / N", lambda place: place["pin_axial"], ".1f"),
    ("  spin-up time / ms", lambda place: _at_entry(place, "spin_up_time") * 1e3, ".2f"),
    ("  sliding until then / mm", lambda place: _at_entry(place, "spin_up_distance") * 1e3, ".1f"),
    ("  loss until then / J", lambda place: _at_entry(place, "spin_up_loss"), ".2f"),
    (FILM.axis(FILM.title()), lambda place: FILM.number(place["formula_film_min"]), ".3f"),
    ("  by the source's formula", lambda place: FILM.number(place["printed_film_min"]), ".3f"),
    ("  left by heat, share", lambda place: place["heated_share"], ".2f"),
    (QUANTITIES["specific_film"].title(), lambda place: place["specific_film"], ".2f"),
)
"""Label, number at the middle of a contact line, its format."""


def ends_table(cycle: "xr.Dataset") -> Table:
    """Entry and exit of both sections of a roller enveloping drive, in the middle of the contact line."""
    middle = cycle.isel(station=cycle.sizes["station"] // 2)
    places = [
        middle.sel(section=section).isel(phase=end)
        for section in cycle["section"].values
        for end in (0, -1)
    ]
    rows: list[tuple[str, ...]] = []
    for label, value, style in _ROWS:
        numbers = [float(value(place)) for place in places]
        if np.isfinite(numbers).any():
            shown = ("" if np.isnan(number) else f"{number:{style}}" for number in numbers)
            rows.append((label, *shown))
    specific = [float(place["specific_film"]) for place in places]
    if np.isfinite(specific).any():
        rows.append(
            ("Lubrication", *("" if np.isnan(ratio) else regime(ratio) for ratio in specific))
        )
    rows.append(("Regime", *(_regime(cycle, place) for place in places)))
    sides = ("entry", "exit") if cycle.attrs.get("driving") != "right" else ("exit", "entry")
    ends = (f"{section}\n{end}" for section in cycle["section"].values for end in sides)
    head = ("In the middle of\nthe contact line", *ends)
    return Table(head, tuple(rows), "Entry and exit by closed forms")


def _regime(cycle: "xr.Dataset", place: "xr.Dataset") -> str:
    number = float(place["regime_number"])
    if np.isnan(number) or np.isnan(float(place["formula_film_min"])):
        return ""
    viscous, elastic = str(cycle["regime"].values[int(number)]).split("-")
    return f"{elastic},\n{viscous.removesuffix('viscous')}-\nviscous"


CYCLE_TABLE = ends_table
"""What `pyworm run` prints of the mesh cycle."""
