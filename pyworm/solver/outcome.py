"""Fields, profile across the film and heat balance of the last level of a contact."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import nan
from typing import Any

import numpy as np

from pyworm import kernel
from pyworm.formulas.arrays import Array
from pyworm.io.plain_dataset import PlainDataset, described
from pyworm.planning.model import Model
from pyworm.scene.contact import Contact
from pyworm.solver.ending import Ending
from pyworm.solver.level import Level


@dataclass(frozen=True)
class Outcome:
    """Result of the last level of a contact."""

    figures: dict[str, Any]
    """The figures of `solution.Figures` without error bars."""
    fields: PlainDataset
    """Fields over the grid."""
    flaw: Ending | None = None
    """Reason why the figures are not to be trusted although the film converged."""
    profile: PlainDataset | None = None
    """Temperature and velocity across the film at its hottest point, where heat is simulated."""


def fields(
    scene: Contact,
    model: Model,
    level: Level,
    dry_pressure: Array | None,
    attributes: Mapping[str, float],
) -> PlainDataset:
    """All fields over a level's grid, in single precision: its 24 bits are far finer than any error bar.

    `dry_pressure` is None where it is Hertz's in closed form; `attributes` have names with units.
    """
    places = level.grid.mesh()
    variables = {
        "gap": level.gap,
        "covered": level.covered.astype(np.int8),
        **({} if dry_pressure is None else {"dry_pressure": dry_pressure}),
        "pressure": level.film.pressure,
        "film": level.film.thickness(),
        **_along("entrainment", scene.entrainment_at(*places)),
        **_along("sliding", scene.sliding_at(*places)),
        **(_shear_fields(level) if model.levels else {}),
        **(_rough_fields(level) if model.rough else {}),
        **({"oil_fraction": level.film.fraction()} if level.film.fed else {}),
        **(_heat_fields(level, scene.oil.thermal.inlet_temperature) if model.heated else {}),
    }
    axes = _axes(level)
    return described(
        {name: (tuple(reversed(axes)), _single(values).T) for name, values in variables.items()},
        {axis: ((axis,), places) for axis, places in axes.items()},
        attributes,
    )


def _single(values: Array) -> Array:
    """Numbers in single precision; marks, which are integers, unchanged."""
    if values.dtype.kind == "i":
        return values
    # fields of a film that was lost may exceed all numbers of that size
    largest = np.finfo(np.float32).max
    return np.clip(values, -largest, largest).astype(np.float32)


def _shear_fields(level: Level) -> dict[str, Array]:
    shear = level.film.shear_fields(factors=True)
    across = {"flow_factor_across": shear.across} if level.gap.ndim == 2 else {}
    return {
        **_along("shear_stress", shear.stress),
        "friction_power": shear.friction + level.rubbing()[1],
        "shear_rate": shear.rate,
        "slip": shear.slip.astype(np.int8),
        "flow_factor_sliding": shear.along,
        **across,
    }


def _rough_fields(level: Level) -> dict[str, Array]:
    asperities = level.film.asperities()
    return {"asperity_pressure": asperities.pressure, "real_area": asperities.area}


def _heat_fields(level: Level, inlet_temperature: float) -> dict[str, Array]:
    temperature = inlet_temperature + level.film.rise()
    return {
        "temperature_body_1": temperature[..., 0],
        "temperature_body_2": temperature[..., -1],
        "temperature_middle": temperature[..., level.film.levels // 2],
    }


def profile(scene: Contact, level: Level) -> PlainDataset:
    """Temperature and velocity across the film where it is hottest in the contact."""
    rise = level.film.rise()
    hottest = np.where(level.contact(), rise.max(axis=-1), -np.inf)
    node = tuple(int(index) for index in np.unravel_index(np.argmax(hottest), hottest.shape))
    place = [axis[index] for axis, index in zip(_axes(level).values(), node, strict=True)]
    body_1, _ = scene.velocities_at(*(np.array(coordinate) for coordinate in place))
    velocities = _along(
        "profile_velocity",
        level.film.profile(node, [np.asarray(component, dtype=float) for component in body_1]),
    )
    temperature = scene.oil.thermal.inlet_temperature + rise[node]
    return described(
        {
            "profile_temperature": (("level",), temperature),
            **{name: (("level",), values) for name, values in velocities.items()},
            **{name: ((), coordinate) for name, coordinate in _along("profile", place).items()},
        },
        {"level_position": (("level",), kernel.level_positions(rise.shape[-1]))},
    )


def heat_balance(level: Level) -> float:
    """Heat into both bodies and the oil, less the work of friction, over that work."""
    heat = level.film.heat_fields()
    friction = level.film.present_shear().friction.sum() + level.rubbing()[1].sum()
    if not friction > 0:  # of a film that was cooled down, where heat found none
        return nan
    return float((heat.flux.sum() + heat.carried.sum() - friction) / friction)


def _along(name: str, components: Sequence[Any]) -> dict[str, Any]:
    """Components of a vector by the names of their variables."""
    axes = "xy"[: len(components)]
    return {f"{name}_{axis}": component for axis, component in zip(axes, components, strict=True)}


def _axes(level: Level) -> dict[str, Array]:
    """Positions of a grid's nodes along each direction [m]."""
    return {axis: getattr(level.grid, axis) for axis in "xy"[: level.gap.ndim]}
