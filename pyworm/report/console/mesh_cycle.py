"""Tables of a whole mesh cycle, for people; they read a result's cycle, or its figures, and nothing else."""

from collections.abc import Callable

import numpy as np
import xarray as xr
from rich.table import Table

from pyworm.formulas.wear_distress import regime
from pyworm.ratings.heating import Heating
from pyworm.ratings.standard_loss import NoStandard, StandardLoss
from pyworm.result.mesh_cycle import DriveCycle, Extreme
from pyworm.solver.left_out import AS_IF_SMOOTH
from pyworm.solver.solution import ZERO_CELSIUS

_ROWS: tuple[tuple[str, Callable[[xr.Dataset], float], str], ...] = (
    ("Wheel angle / deg", lambda at: np.degrees(at["wheel_angle"]), ".1f"),
    ("Load per length / kN/m", lambda at: at["load_per_length"] / 1e3, ".1f"),
    ("Relative radius / mm", lambda at: at["contact_radius"] * 1e3, ".3f"),
    ("Worm across the line / m/s", lambda at: at["worm_velocity"], ".3f"),
    ("Roller across the line / m/s", lambda at: at["roller_velocity"], ".3f"),
    ("Sliding along the line / m/s", lambda at: at["sliding_along"], ".3f"),
    ("Spin / rad/s", lambda at: at["relative_spin"], ".1f"),
    ("Roller about its axis / rpm", lambda at: at["roller_speed"] * 30 / np.pi, ".0f"),
    ("Minimum film / µm", lambda at: at["formula_film_min"] * 1e6, ".3f"),
    ("  by the source's formula", lambda at: at["printed_film_min"] * 1e6, ".3f"),
    ("  left by heat, share", lambda at: at["heated_share"], ".2f"),
    ("Specific film lambda", lambda at: at["specific_film"], ".2f"),
)
"""Label, number at the middle of a contact line, its format."""


def ends_table(cycle: xr.Dataset) -> Table:
    """Entry and exit of both sections of a roller enveloping drive, in the middle of the contact line."""
    table = Table(title="Entry and exit by closed forms", title_justify="left")
    table.add_column("In the middle of\nthe contact line", no_wrap=True)
    middle = cycle.isel(station=cycle.sizes["station"] // 2)
    places = [
        middle.sel(section=section).isel(phase=end)
        for section in cycle["section"].values
        for end in (0, -1)
    ]
    for section in cycle["section"].values:
        for end in ("entry", "exit"):
            table.add_column(f"{section}\n{end}", justify="right")
    for label, value, style in _ROWS:
        numbers = [float(value(at)) for at in places]
        if np.isfinite(numbers).any():
            table.add_row(label, *(f"{number:{style}}" for number in numbers))
    specific = [float(at["specific_film"]) for at in places]
    if np.isfinite(specific).any():
        table.add_row("Lubrication", *("" if np.isnan(one) else regime(one) for one in specific))
    table.add_row("Regime", *(_regime(cycle, at) for at in places))
    return table


def _regime(cycle: xr.Dataset, at: xr.Dataset) -> str:
    number = float(at["regime_number"])
    if np.isnan(number):
        return ""
    viscous, elastic = str(cycle["regime"].values[int(number)]).split("-")
    return f"{elastic},\n{viscous.removesuffix('viscous')}-\nviscous"


def sensitivity_table(cycle: xr.Dataset) -> Table:
    """Contact of a ZI worm drive in mid-mesh with errors of assembly and set-up, one at a time."""
    load = cycle.attrs["varied_load"]
    table = Table(
        title=f"Contact in mid-mesh under {load / 1e3:.4g} kN with errors of the assembly",
        title_justify="left",
    )
    table.add_column("Error", no_wrap=True)
    columns = (
        ("Face\nmm", "contact_face", 1e3, ".1f"),
        ("Radius\nmm", "contact_radius_on_wheel", 1e3, ".1f"),
        ("Rx\nmm", "radius_long", 1e3, ".0f"),
        ("Ry\nmm", "radius_short", 1e3, ".1f"),
        ("Dry\nMPa", "dry_pressure_max", 1e-6, ".0f"),
        ("Formula\nfilm µm", "formula_film", 1e6, ".2f"),
    )
    for heading, *_ in columns:
        table.add_column(heading, justify="right")
    for number, error in enumerate(cycle["error"].values):
        size = float(cycle["error_size"][number])
        angle = error in ANGLES
        shown = f"{np.degrees(size):.2g} deg" if angle else f"{size * 1e3:.2g} mm"
        for side, sign in ((0, "-"), (1, ""), (2, "+")):
            if side == 1 and number > 0:
                continue
            label = f"{_ERRORS[error]} {sign}{shown}" if sign else "as it is"
            at = cycle.isel(error=number, side=side)
            values = [float(at[f"varied_{name}"]) * scale for _, name, scale, _ in columns]
            known = np.isfinite(values[0])
            cells = [f"{value:{style}}" for value, (*_, style) in zip(values, columns, strict=True)]
            table.add_row(label, *(cells if known else ["no contact"]))
    return table


_ERRORS = {
    "assembly.centre_distance": "centre distance",
    "assembly.axial_shift": "shift of the worm",
    "assembly.shaft_angle": "shaft angle",
    "hob.swivel": "hob's swivel",
}
"""Entry in error -> what people call it."""

ANGLES = ("assembly.shaft_angle", "hob.swivel")

CYCLE_TABLES: dict[str, Callable[[xr.Dataset], Table]] = {
    "roller-worm": ends_table,
    "zi-worm": sensitivity_table,
}
"""Kind of drive -> table of its whole mesh cycle."""


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
        place = ("", "") if one.place is None else (f"{part * 1e3:.1f}" for part in one.place)
        table.add_row(label, f"{value} ± {_two(one.error * scale)}", f"{one.phase:g}", *place)
        if one.reason is not None:
            table.add_row("  error bar", one.reason)

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
        extreme("  of the central film", cycle.lambda_central, 1.0, "")
    if cycle.lifted is not None:
        share, phase = cycle.lifted
        table.add_row("Load moved by films' lift", f"{share * 100:+.2g} %", f"{phase:g}")
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
        What a standard says of its teeth; shown beside the simulation where roughness carries load.
    heating : Heating or None
        The loss that warms it; None where temperatures are given.
    """
    loss, left_out = cycle.loss, cycle.left_out
    table = Table("Figure", title=left_out.titled("Loss of all teeth"), title_justify="left")
    table.add_column(AS_IF_SMOOTH.capitalize() if left_out.rough else "Value", justify="right")
    beside: dict[str, str] = {}
    if left_out.rough and isinstance(standard, StandardLoss):
        table.add_column("Rough, by\nthe standard", justify="right")
        beside = {
            "Loss": f"{standard.power:.4g} W",
            "Mean friction": f"{standard.friction:.3g}",
            "Efficiency": f"{standard.efficiency * 100:.3g} %",
        }
    bar = f"± {loss.efficiency_error * 100:.2g}"
    for label, value in (
        ("Loss", f"{loss.power:.4g} W ± {_two(loss.error)}"),
        ("  error by the scenes' errors", f"{_two(loss.scene_error)} W"),
        ("  by the phases", f"{_two(loss.phase_error)} W"),
        ("  by friction at the ends", f"{_two(loss.end_error)} W"),
        ("Mean friction", f"{loss.friction:.4g} ± {loss.error / loss.power * 100:.2g} %"),
        ("Torque of the wheel", f"{loss.wheel_torque:.5g} N m"),
        ("Torque of the worm", f"{loss.worm_torque:.4g} N m"),
        ("Efficiency", f"{loss.efficiency * 100:.2f} % {bar}"),
        ("  power the other way", f"{loss.reverse_efficiency * 100:.2f} % {bar}"),
    ):
        table.add_row(label, value, *([beside.get(label, "")] if beside else []))
    if heating is not None:
        table.caption, table.caption_justify = heating.words, "left"
    return table


def _two(value: float) -> str:
    """Two digits, without an exponent."""
    return f"{float(f'{value:.2g}'):g}"
