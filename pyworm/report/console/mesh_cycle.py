"""Tables on the console: the whole mesh cycle of a result."""

from collections.abc import Iterator
from math import isfinite, isinf

from pyworm.drives.kinds import module_of
from pyworm.drives.mesh_loss import MeshLoss
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.on_demand import xarray as xr
from pyworm.io.present import present
from pyworm.io.quantities import BODIES, QUANTITIES, Quantity
from pyworm.io.quantity_text import UNKNOWN, model_bar, uncertainty_label
from pyworm.ratings.heating import Heating
from pyworm.ratings.standard_loss import NoStandard, StandardLoss
from pyworm.report.table import Table
from pyworm.result.mesh_cycle import DriveCycle, Extreme
from pyworm.solver.neglected_effects import AS_IF_SMOOTH


def closed_form_table(cycle: "xr.Dataset") -> Table | None:
    """Table of the closed forms of a mesh cycle; None for a kind of drive without such a table.

    It is `CYCLE_TABLE` of the drive's module for the console (`pyworm.drives.kinds`).
    """
    module = module_of(cycle.attrs["drive"], "console")
    return None if module is None else module.CYCLE_TABLE(cycle)


def cycle_table(cycle: DriveCycle, bodies: tuple[str, str] = BODIES) -> Table:
    """Extremes of a drive's mesh cycle with their phase and place on the wheel's flank."""
    title = f"Whole mesh cycle, from {len(cycle.phases)} phases"
    if cycle.unconverged:
        phases = ", ".join(f"{phase:g}" for phase in cycle.unconverged)
        title += f" ({phases} not converged, not included)"
    found = {"film_min": cycle.film_min, "pressure_max": cycle.pressure_max}
    found |= {f"temperature_max_{name}": extreme for name, extreme in cycle.temperatures.items()}
    rows = [
        row
        for name, extreme in found.items()
        for row in _extreme(QUANTITIES[name], extreme, bodies)
    ]
    for name, label in (
        ("sump", "Oil in the sump"),
        ("worm", "Bulk of the worm"),
        ("wheel", "Bulk of the wheel"),
    ):
        if name in cycle.bulk:
            rows.append((label, f"{cycle.bulk[name] - ZERO_CELSIUS:.1f} °C"))
    for name, ratio in (
        ("specific_film", cycle.lambda_min),
        ("lambda_central", cycle.lambda_central),
    ):
        if ratio is not None:
            rows += _extreme(QUANTITIES[name], ratio, bodies)
    notes = [_reason(QUANTITIES[name], extreme, bodies) for name, extreme in found.items()]
    if cycle.lifted is not None:
        fraction, phase = cycle.lifted
        rows.append(("Load redistributed by the films", f"{fraction * 100:+.2g} %", f"{phase:g}"))
        notes.append(
            "Load redistributed by the films: largest change of a contact's load by the separation of "
            "worm and wheel that the film causes."
        )
    head = ("Quantity", "Value", "Phase", "Face\nmm", "Radius\nmm")
    return Table(
        head, tuple(rows), cycle.neglected_effects.titled(title), " ".join(filter(None, notes))
    )


def _extreme(
    quantity: Quantity, extreme: Extreme, bodies: tuple[str, str]
) -> Iterator[tuple[str, ...]]:
    """Rows of the extreme of a quantity: its value, phase and place, and its model uncertainty."""
    value = quantity.text(extreme.value)
    value = (
        f"{value} ± {_two(extreme.error * quantity.scale)}"
        if isfinite(extreme.error)
        else f"≥ {value}"
    )
    place = () if extreme.place is None else tuple(f"{part * 1e3:.1f}" for part in extreme.place)
    label = f"  {quantity.words(bodies)}" if quantity.part else quantity.worst_title(bodies)
    yield (label, value, f"{extreme.phase:g}", *place)
    if extreme.model is not None:
        yield "  model uncertainty", f"± {quantity.with_unit(_two(extreme.model * quantity.scale))}"


def _reason(quantity: Quantity, extreme: Extreme, bodies: tuple[str, str]) -> str:
    """Why the uncertainty of an extreme is unusual; empty where it is not."""
    if extreme.reason is None:
        return ""
    label = uncertainty_label(extreme.error)
    return f"{quantity.worst_title(bodies)}: {label}, {extreme.reason}."


def loss_table(
    cycle: DriveCycle, standard: StandardLoss | NoStandard, heating: Heating | None
) -> Table:
    """Loss, friction, torques and efficiency of all teeth over a mesh cycle.

    The rating of the teeth by a standard stands beside the simulation where roughness carries load.
    """
    loss, neglected_effects = present(cycle.loss, "loss"), cycle.neglected_effects
    power, friction, efficiency, wheel, worm = (
        QUANTITIES[name]
        for name in ("mesh_loss", "mesh_friction", "mesh_efficiency", "wheel_torque", "worm_torque")
    )
    beside: dict[str, str] = {}
    if neglected_effects.as_if_smooth and isinstance(standard, StandardLoss):
        beside = {
            power.name: power.text(standard.power),
            friction.name: f"{standard.friction:.3g}",
            efficiency.name: f"{standard.efficiency * 100:.3g} %",
        }
    bar, rough = f"± {loss.efficiency_error * 100:.2g}", ""
    missing = f"; {cycle.missing}" if cycle.missing else ""
    mean = f"{friction.text(loss.friction)} ± {loss.error / loss.power * 100:.2g} %"
    if loss.model_error is not None and loss.efficiency_model_error is not None:
        rough = f" ± {_two(loss.model_error)} (model)"
        bar += model_bar(loss.efficiency_model_error, 100.0, "")
        mean += model_bar(loss.model_error / loss.power)
    parts = (
        ("uncertainty from the contacts", loss.scene_error),
        ("from interpolation between phases", loss.phase_error),
        ("from extrapolation to mesh ends", loss.end_error),
    )
    rows: tuple[tuple[Quantity | str, str], ...] = (
        (power, f"{power.text(loss.power)} ± {_two(loss.error)}{rough}"),
        *((f"  {words}", power.with_unit(_two(error))) for words, error in parts),
        (friction, mean),
        (wheel, wheel.with_unit(f"{loss.wheel_torque:.5g}")),
        (worm, worm.text(loss.worm_torque)),
        (efficiency, f"{loss.efficiency * 100:.2f} % {bar}{missing}"),
        ("  wheel driving", f"{loss.reverse_efficiency * 100:.2f} % {bar}{missing}"),
    )
    heading = AS_IF_SMOOTH.capitalize() if neglected_effects.as_if_smooth else "Value"
    return Table(
        head=("Quantity", heading, *(["Rough, by\nthe standard"] if beside else [])),
        rows=tuple(
            (row, value)
            if isinstance(row, str)
            else (row.title(), value, *filter(None, [beside.get(row.name)]))
            for row, value in rows
        ),
        title=neglected_effects.titled("Power loss of all teeth"),
        note="" if heating is None else heating.words,
    )


def loss_sentence(loss: MeshLoss) -> str:
    """Efficiency and loss of a drive without a table of its cycle's loss."""
    power, friction, efficiency = (
        QUANTITIES[name] for name in ("mesh_loss", "mesh_friction", "mesh_efficiency")
    )
    bar = loss.loss / loss.power * loss.error * 100
    rough = "" if loss.model is None else model_bar(loss.loss * loss.model, 1.0, " W")
    missing = f" ({loss.missing})" if loss.missing else ""
    return (
        f"{efficiency.title()} {loss.efficiency * 100:.2f} % ± {bar:.1g}{missing}, {power.words()} "
        f"{power.text(loss.loss)}{rough} of {power.text(loss.power)}, {friction.words()} "
        f"{loss.friction:.3g}: {loss.words}."
    )


def _two(value: float) -> str:
    """Two digits, without an exponent; an uncertainty without a bound in a word."""
    return UNKNOWN if isinf(value) else f"{float(f'{value:.2g}'):g}"
