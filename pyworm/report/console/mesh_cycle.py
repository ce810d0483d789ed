"""Tables on the console: the whole mesh cycle of a result."""

from math import isfinite, isinf

from rich.table import Table

from pyworm.drives.kinds import module_of
from pyworm.drives.mesh_loss import MeshLoss
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.format import UNKNOWN, model_bar
from pyworm.io.on_demand import xarray as xr
from pyworm.io.present import present
from pyworm.ratings.heating import Heating
from pyworm.ratings.standard_loss import NoStandard, StandardLoss
from pyworm.result.mesh_cycle import DriveCycle, Extreme
from pyworm.solver.left_out import AS_IF_SMOOTH


def closed_form_table(cycle: "xr.Dataset") -> Table | None:
    """Table of the closed forms of a mesh cycle; None for a kind of drive without such a table.

    It is `CYCLE_TABLE` of the module in `drives` beside that is named after the kind.
    """
    module = module_of(cycle.attrs["drive"], "pyworm.report.console.drives")
    return None if module is None else module.CYCLE_TABLE(cycle)


def cycle_table(cycle: DriveCycle) -> Table:
    """Extremes of a drive's mesh cycle with their phase and place on the wheel's flank."""
    title = f"Whole mesh cycle, from {len(cycle.phases)} phases"
    if cycle.unconverged:
        phases = ", ".join(f"{phase:g}" for phase in cycle.unconverged)
        title += f" ({phases} not converged, left out)"
    table = Table("Figure", title=cycle.left_out.titled(title), title_justify="left")
    for heading in ("Value", "Phase", "Along the\nface / mm", "Radius\n/ mm"):
        table.add_column(heading, justify="right")

    def extreme(label: str, one: Extreme, scale: float, unit: str, offset: float = 0.0) -> None:
        value = f"{(one.value - offset) * scale:.4g} {unit}".rstrip()
        value = f"{value} ± {_two(one.error * scale)}" if isfinite(one.error) else f"≥ {value}"
        value += "" if one.model is None else f" ± {_two(one.model * scale)} (model)"
        place = ("", "") if one.place is None else (f"{part * 1e3:.1f}" for part in one.place)
        table.add_row(label, value, f"{one.phase:g}", *place)
        if one.reason is not None:
            table.add_row("  error bar" if isfinite(one.error) else "  no upper bound", one.reason)

    extreme("Least film", cycle.film_min, 1e6, "µm")
    extreme("Largest pressure", cycle.pressure_max, 1e-6, "MPa")
    for name, label in (("body_1", "worm"), ("body_2", "wheel"), ("film", "film")):
        if name in cycle.temperatures:
            label = f"Largest temperature, {label}"
            extreme(label, cycle.temperatures[name], 1.0, "°C", ZERO_CELSIUS)
    for name, label in (
        ("sump", "Oil in the sump"),
        ("worm", "Bulk of the worm"),
        ("wheel", "Bulk of the wheel"),
    ):
        if name in cycle.bulk:
            table.add_row(label, f"{cycle.bulk[name] - ZERO_CELSIUS:.1f} °C")
    if cycle.lambda_min is not None:
        extreme("Least lambda", cycle.lambda_min, 1.0, "")
    if cycle.lambda_central is not None:
        extreme("  of the central film", cycle.lambda_central, 1.0, "")
    if cycle.lifted is not None:
        fraction, phase = cycle.lifted
        table.add_row("Load moved by films' lift", f"{fraction * 100:+.2g} %", f"{phase:g}")
        table.caption = (
            "Lift: how much farther a film holds worm and wheel apart under the same load."
        )
        table.caption_justify = "left"
    return table


def loss_table(
    cycle: DriveCycle, standard: StandardLoss | NoStandard, heating: Heating | None
) -> Table:
    """Loss, friction, torques and efficiency of all teeth over a mesh cycle.

    Parameters
    ----------
    cycle : DriveCycle
        A cycle with a loss.
    standard : StandardLoss or NoStandard
        Rating of its teeth by a standard, shown beside the simulation where roughness carries load.
    heating : Heating or None
        The loss that warms it; None where temperatures are given.
    """
    loss, left_out = present(cycle.loss, "loss"), cycle.left_out
    table = Table("Figure", title=left_out.titled("Loss of all teeth"), title_justify="left")
    table.add_column(
        AS_IF_SMOOTH.capitalize() if left_out.as_if_smooth else "Value", justify="right"
    )
    beside: dict[str, str] = {}
    if left_out.as_if_smooth and isinstance(standard, StandardLoss):
        table.add_column("Rough, by\nthe standard", justify="right")
        beside = {
            "Loss": f"{standard.power:.4g} W",
            "Mean friction": f"{standard.friction:.3g}",
            "Efficiency": f"{standard.efficiency * 100:.3g} %",
        }
    bar, rough = f"± {loss.efficiency_error * 100:.2g}", ""
    missing = f"; {cycle.missing}" if cycle.missing else ""
    friction = f"{loss.friction:.4g} ± {loss.error / loss.power * 100:.2g} %"
    if loss.model_error is not None and loss.efficiency_model_error is not None:
        rough = f" ± {_two(loss.model_error)} (model)"
        bar += model_bar(loss.efficiency_model_error, 100.0, "")
        friction += model_bar(loss.model_error / loss.power)
    for label, value in (
        ("Loss", f"{loss.power:.4g} W ± {_two(loss.error)}{rough}"),
        ("  error by the scenes' errors", f"{_two(loss.scene_error)} W"),
        ("  by the phases", f"{_two(loss.phase_error)} W"),
        ("  by friction at the ends", f"{_two(loss.end_error)} W"),
        ("Mean friction", friction),
        ("Torque of the wheel", f"{loss.wheel_torque:.5g} N m"),
        ("Torque of the worm", f"{loss.worm_torque:.4g} N m"),
        ("Efficiency", f"{loss.efficiency * 100:.2f} % {bar}{missing}"),
        ("  power the other way", f"{loss.reverse_efficiency * 100:.2f} % {bar}{missing}"),
    ):
        table.add_row(label, value, *([beside.get(label, "")] if beside else []))
    if heating is not None:
        table.caption, table.caption_justify = heating.words, "left"
    return table


def loss_sentence(loss: MeshLoss) -> str:
    """Efficiency and loss of a drive without a table of its cycle's loss."""
    bar = loss.loss / loss.power * loss.error * 100
    rough = "" if loss.model is None else model_bar(loss.loss * loss.model, 1.0, " W")
    missing = f" ({loss.missing})" if loss.missing else ""
    return (
        f"Efficiency {loss.efficiency * 100:.2f} % ± {bar:.1g}{missing}, loss {loss.loss:.4g} W{rough} of "
        f"{loss.power:.4g} W, mean friction {loss.friction:.3g}: {loss.words}."
    )


def _two(value: float) -> str:
    """Two digits, without an exponent; an uncertainty without a bound in a word."""
    return UNKNOWN if isinf(value) else f"{float(f'{value:.2g}'):g}"
