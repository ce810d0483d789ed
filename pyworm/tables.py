"""Tables for people: what a scene is, what is planned for it, and what came out, in workshop units."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from rich.table import Table

from pyworm.effects import Plan
from pyworm.formulas.hertz import hertz
from pyworm.scene import Scene
from pyworm.schema import PublishedValue

# Label, key in a summary, factor from SI to the unit shown, unit, key of the relative error, and the name
# under which a case's [published] has the same figure.
_FIGURES = (
    ("Load", "load_N", 1e-3, "kN", None, "load"),
    ("Relative radius, larger", "radius_long_m", 1e3, "mm", None, "radius_long"),
    ("Relative radius, smaller", "radius_short_m", 1e3, "mm", None, "radius_short"),
    ("Hertz: largest pressure", "hertz_pressure_max_Pa", 1e-6, "MPa", None, "hertz_pressure_max"),
    ("Hertz: length", "hertz_length_m", 1e3, "mm", None, "hertz_length"),
    ("Hertz: width", "hertz_width_m", 1e3, "mm", None, "hertz_width"),
    ("Dry contact: largest pressure", "dry_pressure_max_Pa", 1e-6, "MPa", None, "dry_pressure_max"),
    ("Dry contact: length", "dry_length_m", 1e3, "mm", None, "dry_length"),
    ("Dry contact: width", "dry_width_m", 1e3, "mm", None, "dry_width"),
    ("Largest pressure", "pressure_max_Pa", 1e-6, "MPa", "pressure_max_error", "pressure_max"),
    ("Central film", "film_central_m", 1e6, "µm", "film_central_error", "film_central"),
    ("Minimum film", "film_min_m", 1e6, "µm", "film_min_error", "film_min"),
    ("Minimum film on the centre line", "film_exit_min_m", 1e6, "µm", None, "film_exit_min"),
    ("  along it at", "film_exit_min_at_m", 1e3, "mm", None, "film_exit_min_at"),
    ("Moes' load parameter M", "moes_M", 1.0, "", None, None),
    ("Moes' lubricant parameter L", "moes_L", 1.0, "", None, None),
    ("Load error", "load_error", 100.0, "%", None, None),
    ("Mass error", "mass_error", 100.0, "%", None, None),
    ("Residual", "residual", 1.0, "", None, None),
    ("Time", "seconds", 1.0, "s", None, None),
    ("Convolutions", "convolutions", 1.0, "", None, None),
)


def figures_table(
    scene: Scene, summary: Mapping[str, Any], published: Mapping[str, PublishedValue]
) -> Table:
    """Figures of one solved scene, with what the source prints beside them.

    Parameters
    ----------
    scene : Scene
        The scene.
    summary : mapping
        `Solution.summary()` of its solution.
    published : mapping
        What the case's source prints for this scene; empty if nothing.
    """
    figures = _hertz_figures(scene) | summary
    table = Table("Figure", title=_title(scene), title_justify="left")
    table.add_column("Value", justify="right")
    if published:
        table.add_column("Published", justify="right")
    for label, key, scale, unit, error_key, name in _FIGURES:
        cells = [label, _value(figures[key] * scale, unit, figures.get(error_key))]
        if published:
            cells.append(published[name].text if name in published else "")
        table.add_row(*cells)
        if key == "film_min_m":
            x, y = (place * 1e3 for place in summary["film_min_at_m"])
            table.add_row("  at x, y", f"{x:.3g}, {y:.3g} mm")
    table.add_row("Grid", " x ".join(str(count) for count in summary["grid"]))
    table.add_row("Converged", "yes" if summary["converged"] else "NO")
    return table


def scenes_table(scenes: Sequence[Scene], summaries: Sequence[Mapping[str, Any]]) -> Table:
    """The figures by which scenes are compared, a row a scene.

    Parameters
    ----------
    scenes : sequence of Scene
        The scenes.
    summaries : sequence of mapping
        `Solution.summary()` of each one's solution.
    """
    table = Table("Scene", title="All scenes", title_justify="left")
    for heading in ("Dry\nMPa", "Largest\nMPa", "Central\nµm", "± %", "Minimum\nµm", "± %", "s"):
        table.add_column(heading, justify="right")
    table.add_column("Converged")
    for scene, values in zip(scenes, summaries, strict=True):
        table.add_row(
            scene.name if scene.phase is None else f"{scene.phase:g}",
            f"{values['dry_pressure_max_Pa'] / 1e6:.4g}",
            f"{values['pressure_max_Pa'] / 1e6:.4g}",
            f"{values['film_central_m'] * 1e6:.4g}",
            f"{values['film_central_error'] * 100:.2g}",
            f"{values['film_min_m'] * 1e6:.4g}",
            f"{values['film_min_error'] * 100:.2g}",
            f"{values['seconds']:.1f}",
            "yes" if values["converged"] else "NO",
        )
    return table


def published_for(
    summary: Mapping[str, Any], published: Mapping[str, PublishedValue]
) -> Mapping[str, PublishedValue]:
    """What a case's source prints for a scene: all of it, unless it names another phase."""
    if "phase" in published and published["phase"].value != summary["phase"]:
        return {}
    return published


def scene_summary(scene: Scene) -> dict[str, Any]:
    """What a scene asks of the solver, as one flat object, units in the keys."""
    origin = np.zeros(1)
    entrainment, sliding = (
        [float(component[0]) for component in velocity(origin, origin)]
        for velocity in (scene.entrainment, scene.sliding)
    )
    return {
        "name": scene.name,
        "phase": scene.phase,
        "load_N": scene.load,
        "radii_m": list(scene.radii),
        "reduced_modulus_Pa": scene.reduced_modulus,
        "entrainment_m_per_s": entrainment,
        "sliding_m_per_s": sliding,
    } | _hertz_figures(scene)


def plan_table(scene: Scene, plan: Plan) -> Table:
    """A scene and what is planned for it."""
    summary = scene_summary(scene)
    table = Table(title=_title(scene), title_justify="left")
    table.add_column("Scene")
    table.add_column("", overflow="fold")
    table.add_row("Load", _value(summary["load_N"] / 1e3, "kN"))
    table.add_row("Relative radii along x, y", _pair(summary["radii_m"], 1e3, "mm"))
    table.add_row("Reduced modulus", _value(summary["reduced_modulus_Pa"] / 1e9, "GPa"))
    table.add_row("Entrainment along x, y", _pair(summary["entrainment_m_per_s"], 1, "m/s"))
    table.add_row("Sliding along x, y", _pair(summary["sliding_m_per_s"], 1, "m/s"))
    ellipse = summary["hertz_length_m"], summary["hertz_width_m"]
    table.add_row("Hertz: length, width", _pair(ellipse, 1e3, "mm"))
    table.add_row("Hertz: largest pressure", _value(summary["hertz_pressure_max_Pa"] / 1e6, "MPa"))
    table.add_section()
    table.add_row("Accuracy wanted", f"{plan.accuracy * 100:g} %")
    for effect in plan.effects:
        table.add_row(effect.name, f"{'on' if effect.on else 'off'}: {effect.reason}")
    for grid in plan.grids:
        spacing = f"{grid.dx * 1e6:.3g} x {grid.dy * 1e6:.3g} µm"
        table.add_row("Grid", f"{grid.nx} x {grid.ny}, spacing {spacing}")
    table.add_row("Expected convolutions", f"{plan.expected_convolutions:.0f}")
    return table


def _hertz_figures(scene: Scene) -> dict[str, float]:
    """Radii of a scene and the Hertz contact that they make."""
    contact = hertz(*scene.radii, scene.load, scene.reduced_modulus)
    semi_axes = contact.semi_axis_x, contact.semi_axis_y
    return {
        "radius_long_m": max(scene.radii),
        "radius_short_m": min(scene.radii),
        "hertz_length_m": 2 * max(semi_axes),
        "hertz_width_m": 2 * min(semi_axes),
        "hertz_pressure_max_Pa": contact.pressure_max,
    }


def _title(scene: Scene) -> str:
    return scene.name if scene.phase is None else f"Mesh phase {scene.phase:g}"


def _value(value: float, unit: str, error: float | None = None) -> str:
    text = f"{value:.4g} {unit}".rstrip()
    return text if error is None else f"{text} ± {error * 100:.2g} %"


def _pair(values, scale: float, unit: str) -> str:
    return f"{values[0] * scale:.4g}, {values[1] * scale:.4g} {unit}"
