"""Figures of a whole mesh cycle from a result: extremes over its phases, loss and efficiency."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from pyworm.drives.tooth_loss import FEWEST_PHASES, Array, Loss, cycle_loss
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.on_demand import xarray as xr
from pyworm.io.present import present
from pyworm.result.contact_loss import contact_losses
from pyworm.result.headline import of_all
from pyworm.result.result import Result
from pyworm.solver.neglected_effects import NeglectedEffects
from pyworm.solver.solution import Estimate, Solution


@dataclass(frozen=True)
class Extreme:
    """The largest or least of a figure over the phases solved."""

    value: float
    """The figure in SI units."""
    error: float
    """Its numerical error bar in the same unit."""
    phase: float
    """Phase in the mesh cycle."""
    place: tuple[float, float] | None = None
    """On the wheel's flank: along the face from its middle, and distance from the wheel's axis [m]; None of a
    temperature."""
    reason: str | None = None
    """Reason why its error bar is infinite (`solution.Estimate`)."""
    model: float | None = None
    """Its model uncertainty in the same unit; None where there is none."""


@dataclass(frozen=True)
class DriveCycle:
    """Figures of a mesh cycle."""

    phases: tuple[float, ...]
    """Phases that converged."""
    unconverged: tuple[float, ...]
    """Phases that did not converge."""
    film_min: Extreme
    """Least film over all phases [m]."""
    pressure_max: Extreme
    """Largest pressure over all phases [Pa]."""
    temperatures: dict[str, Extreme]
    """Largest of "body_1", "body_2" and "film" [K]; empty where heat was not simulated."""
    lambda_min: Extreme | None
    """Least film over composite roughness [-]; None where a roughness is not known."""
    loss: Loss | None
    """Loss of the drive; None where the shear of the film was not computed."""
    bulk: dict[str, float]
    """Temperatures of "sump", "worm" and "wheel" in the solved scenes [K]; empty where heat was not
    simulated."""
    lifts: tuple[tuple[float, float], ...] = ()
    """Phases and the lift of the teeth by the film there [m]; empty where it is not known."""
    lifted: tuple[float, float] | None = None
    """Largest relative change of the load of a solved phase by the films' lift, and that phase; None where
    the load sharing is without lift."""
    lambda_central: Extreme | None = None
    """Least central film over composite roughness [-]; None where a roughness is not known."""
    neglected_effects: NeglectedEffects = field(default_factory=NeglectedEffects)
    """Effects left out of these figures, at the worst of the phases."""
    missing: str = ""
    """Contacts without a converged solution, in words; empty where every one has one."""

    def summary(self) -> dict:
        """The figures as one object, units in the keys."""
        loss = self.loss
        return {
            "left_out": self.neglected_effects.influence,
            "lubrication": self.neglected_effects.lubrication,
            "phases": list(self.phases),
            "phases_left_out": list(self.unconverged),
            "film_min": _told(self.film_min, "m"),
            "pressure_max": _told(self.pressure_max, "Pa"),
            "temperature_max": {
                name: _told(replace(extreme, value=extreme.value - ZERO_CELSIUS), "C")
                for name, extreme in self.temperatures.items()
            },
            "bulk_temperature_C": {
                name: temperature - ZERO_CELSIUS for name, temperature in self.bulk.items()
            },
            "lambda_min": self.lambda_min and _told(self.lambda_min, ""),
            "lambda_central": self.lambda_central and _told(self.lambda_central, ""),
            "load_moved_by_lift": self.lifted
            and dict(zip(("share", "phase"), self.lifted, strict=True)),
            **(
                {}
                if loss is None
                else {
                    "power_loss_W": loss.power,
                    "power_loss_error_W": loss.error,
                    "power_loss_error_scenes_W": loss.scene_error,
                    "power_loss_error_phases_W": loss.phase_error,
                    "power_loss_error_ends_W": loss.end_error,
                    "friction": loss.friction,
                    "wheel_torque_N_m": loss.wheel_torque,
                    "worm_torque_N_m": loss.worm_torque,
                    "efficiency": loss.efficiency,
                    **({"missing": self.missing} if self.missing else {}),
                    "reverse_efficiency": loss.reverse_efficiency,
                    "efficiency_error": loss.efficiency_error,
                    **(
                        {}
                        if loss.model_error is None
                        else {
                            "power_loss_model_error_W": loss.model_error,
                            "efficiency_model_error": loss.efficiency_model_error,
                        }
                    ),
                }
            ),
        }


def _told(extreme: Extreme, unit: str) -> dict:
    values: dict[str, Any] = {
        f"value_{unit}".rstrip("_"): extreme.value,
        "error": extreme.error,
        "phase": extreme.phase,
    }
    if extreme.place is not None:
        values |= {"face_m": extreme.place[0], "radius_m": extreme.place[1]}
    if extreme.model is not None:
        values["model_error"] = extreme.model
    if extreme.reason is not None:
        values["error_reason"] = extreme.reason
    return values


def drive_cycle(result: Result) -> DriveCycle | None:
    """The mesh cycle of a drive whose tooth pairs share its load; None for other results."""
    cycle = result.mesh_cycle
    if cycle is None or "tooth_load" not in cycle:
        return None
    solved = sorted(result.solutions, key=phase_of)
    good = [solution for solution in solved if solution.converged]
    if len(good) < FEWEST_PHASES:
        return None
    lifts = [
        (phase_of(solution), solution.figures.lift)
        for solution in good
        if solution.figures.lift is not None
    ]
    heated = all(solution.figures.temperature_max_film is not None for solution in good)
    film = _extreme(good, "film_min", min, _least_at)
    return DriveCycle(
        phases=tuple(phase_of(solution) for solution in good),
        unconverged=tuple(phase_of(solution) for solution in solved if not solution.converged),
        film_min=film,
        pressure_max=_extreme(good, "pressure_max", max, _largest_at),
        temperatures={
            name: _extreme(good, f"temperature_max_{name}", max)
            for name in (("body_1", "body_2", "film") if heated else ())
        },
        bulk={
            name: float(cycle.attrs[f"{name}_temperature"])
            for name in (("sump", "worm", "wheel") if heated else ())
        },
        lambda_min=_lambda(film, good[0].composite_roughness),
        loss=(
            cycle_loss(cycle, contact_losses(good))
            if all(solution.figures.power_loss is not None for solution in good)
            else None
        ),
        lifts=(tuple(lifts) if len(lifts) == len(good) else ()),
        lifted=_lifted(cycle, good) if "dry_tooth_load" in cycle else None,
        lambda_central=_lambda(_extreme(good, "film_central", min), good[0].composite_roughness),
        neglected_effects=of_all(good),
        missing=result.missing,
    )


def _lifted(cycle: "xr.Dataset", good: list[Solution]) -> tuple[float, float]:
    """Largest relative change of the load of a solved phase by the lifts, and that phase."""
    phases = np.array([solution.phase for solution in good])
    loads = (
        np.interp(phases, cycle["load_phase"], cycle[name])
        for name in ("tooth_load", "dry_tooth_load")
    )
    fraction = np.divide(*loads) - 1
    most = int(np.argmax(np.abs(fraction)))
    return float(fraction[most]), float(phases[most])


def _extreme(
    solutions: list[Solution],
    name: str,
    pick: Callable,
    place: Callable[[Solution], tuple[float, float]] | None = None,
) -> Extreme:
    extreme = pick(solutions, key=lambda solution: getattr(solution.figures, name).value)
    estimate: Estimate = getattr(extreme.figures, name)
    heat = name.startswith("temperature")
    size = extreme.rise(estimate) if heat else estimate.value
    flank_position = None if place is None else flank_place(extreme, *place(extreme))
    model = None if estimate.model is None else estimate.model * abs(size)
    return Extreme(
        estimate.value,
        estimate.error * abs(size),
        extreme.phase,
        flank_position,
        estimate.reason,
        model,
    )


def phase_of(solution: Solution) -> float:
    """Phase of a solution of a mesh cycle; ValueError of one outside a cycle."""
    return present(solution.phase, f"phase of {solution.name}")


def _least_at(solution: Solution) -> tuple[float, float]:
    """Place of the minimum film of a point contact [m]."""
    x, y = solution.figures.film_min_at
    return x, y


def _largest_at(solution: Solution) -> tuple[float, float]:
    """Place of the largest pressure [m]: the middle of its nodes, of which rounded fields have several."""
    pressure = solution.fields["pressure"].transpose("x", "y")
    nodes = np.nonzero(pressure.values == pressure.values.max())
    x, y = (
        pressure[axis].values[indices].mean() for axis, indices in zip("xy", nodes, strict=True)
    )
    return float(x), float(y)


def flank_place(
    solution: Solution,
    x: Array | float,
    y: Array | float,
    names: tuple[str, str] = ("tooth_face", "tooth_radius"),
) -> tuple:
    """Place on a flank over points of a solution's tangent plane [m], by default on the wheel's.

    Along the wheel's face from its middle, and distance from its axis, or what the fields of other names hold
    [m]; of the shape of x and y. Flanks go straight on beyond the tooth: a contact that moves to its edge is
    followed over points that were beyond it.
    """
    fields = solution.fields
    points = {"tooth_x": ("point", np.ravel(x)), "tooth_y": ("point", np.ravel(y))}
    places = [
        fields[name]
        .interp(points, assume_sorted=True, kwargs={"fill_value": None})
        .values.reshape(np.shape(x))
        for name in names
    ]
    return tuple(float(place) if np.ndim(x) == 0 else place for place in places)


def _lambda(film: Extreme, roughness: float | None) -> Extreme | None:
    """Least film over the composite roughness of worm and wheel [m]."""
    if roughness is None:
        return None
    model = None if film.model is None else film.model / roughness
    return replace(film, value=film.value / roughness, error=film.error / roughness, model=model)
