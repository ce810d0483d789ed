"""Tables on the console: scene, plan and solution, in workshop units."""

from collections.abc import Iterator, Mapping, Sequence
from math import inf, isfinite
from typing import Any

from rich.box import SIMPLE_HEAD
from rich.table import Table

from pyworm.case.case_file import PublishedValue
from pyworm.io.format import UNKNOWN, duration, rough
from pyworm.planning.effects.judgement import Judgement
from pyworm.planning.no_friction import no_friction
from pyworm.planning.plan import Plan
from pyworm.result.accuracy import accuracy_words
from pyworm.scene.contact import BODIES
from pyworm.scene.index import PLACE_NAMES, Place
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.scene.summary import scene_summary
from pyworm.solver.cost.expected_time import Expectation
from pyworm.solver.left_out import LeftOut, worst
from pyworm.solver.left_out import expected as expected_to_leave_out

# Label, key in a scene's summary, factor from SI to the unit shown, unit. Rows without key are left out.
_SCENE = (
    ("Load", "load_N", 1e-3, "kN"),
    ("Load per length", "load_per_length_N_m", 1e-3, "kN/m"),
    ("Relative radius", "radii_m", 1e3, "mm"),
    ("Reduced modulus", "reduced_modulus_Pa", 1e-9, "GPa"),
    ("Composite roughness", "composite_roughness_m", 1e6, "µm"),
    ("Entrainment", "entrainment_m_per_s", 1.0, "m/s"),
    ("Sliding", "sliding_m_per_s", 1.0, "m/s"),
    ("Hertz: length", "hertz_length_m", 1e3, "mm"),
    ("Hertz: width", "hertz_width_m", 1e3, "mm"),
    ("Hertz: largest pressure", "hertz_pressure_max_Pa", 1e-6, "MPa"),
)

# The same of a solution, with the key of the relative error, and the name under which a case's [published]
# has the same figure.
_FIGURES = (
    ("Load", "load_N", 1e-3, "kN", None, "load"),
    ("Load per length", "load_per_length_N_m", 1e-3, "kN/m", None, "load"),
    ("Relative radius", "radius_m", 1e3, "mm", None, "radius"),
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
    ("Composite roughness", "composite_roughness_m", 1e6, "µm", None, "composite_roughness"),
    ("Specific film lambda", "specific_film", 1.0, "", "specific_film_error", "specific_film"),
    ("  central", "lambda_central", 1.0, "", "film_central_error", None),
    ("Film over the flooded one", "film_over_flooded", 100.0, "%", "film_over_flooded_error", None),
    ("  oil supplied over it", "supply_ratio", 1.0, "", "supply_ratio_error", None),
    ("  inlet meniscus before the contact point", "meniscus_m", 1e3, "mm", None, None),
    ("  oil that flows around the middle", "side_flow", 100.0, "%", None, None),
    ("  layer left behind it", "layer_left_m", 1e6, "µm", None, None),
    (
        "Load on asperities",
        "asperity_load_fraction",
        100.0,
        "%",
        "asperity_load_fraction_error",
        None,
    ),
    (
        "Friction coefficient",
        "friction_coefficient",
        1.0,
        "",
        "friction_coefficient_error",
        "friction_coefficient",
    ),
    ("  by asperities", "friction_boundary", 1.0, "", "friction_boundary_error", None),
    ("Power loss", "power_loss_W", 1.0, "W", "power_loss_error", "power_loss"),
    (
        "Power loss per length",
        "power_loss_per_length_W_m",
        1e-3,
        "kW/m",
        "power_loss_error",
        "power_loss",
    ),
    (
        "Largest shear rate",
        "shear_rate_max_1_s",
        1.0,
        "1/s",
        "shear_rate_max_error",
        "shear_rate_max",
    ),
    ("Inlet temperature", "inlet_temperature_C", 1.0, "°C", None, "inlet_temperature"),
    ("Heat balance", "heat_balance", 100.0, "%", None, None),
    ("Moes' load parameter M", "moes_M", 1.0, "", None, None),
    ("Moes' lubricant parameter L", "moes_L", 1.0, "", None, None),
    ("Load error", "load_error", 100.0, "%", None, None),
    ("Mass error", "mass_error", 100.0, "%", None, None),
    ("Residual", "residual", 1.0, "", None, None),
    ("Time", "seconds", 1.0, "s", None, None),
    ("Convolutions", "convolutions", 1.0, "", None, None),
)


_RUBBING = {"friction_coefficient", "power_loss_W", "power_loss_per_length_W_m"}
"""Keys of figures that roughness adds to where it carries load."""


def _slender(heading: str | None, title: str) -> Table:
    """A table with a row a scene, whose columns must share a terminal's width."""
    headings = () if heading is None else (heading,)
    return Table(
        *headings, title=title, title_justify="left", box=SIMPLE_HEAD, padding=(0, 1, 0, 0)
    )


HOT_PLACES = "body_1", "body_2", "film"
"""Keys of largest temperatures in summaries."""

TERMS = {
    "phase": "Phase: place in the mesh, from 0 where a contact begins to 1 where it ends.",
    "side lobe": "Side lobe: one of the two places beside and behind the middle of a contact where the film "
    "is thinnest.",
}
"""Word in tables -> what it means, written below them."""


def figures_table(
    scene: Scene | LineScene,
    summary: Mapping[str, Any],
    published: Mapping[str, PublishedValue],
    bodies: tuple[str, str] = BODIES,
) -> Table:
    """Figures of one solved scene, beside the published values.

    Parameters
    ----------
    scene : Scene or LineScene
        The scene.
    summary : mapping
        `Solution.summary()` of its solution.
    published : mapping
        What the case's source prints for this scene; empty if nothing.
    bodies : tuple of str
        What the bodies are called.
    """
    figures = {**scene_summary(scene), **summary}
    left_out = LeftOut.read(summary)
    table = Table("Figure", title=left_out.titled(_title(scene)), title_justify="left")
    table.add_column("Value", justify="right")
    mixed = "film_min_model_error" in summary
    if mixed:
        table.add_column("Model\nuncertainty", justify="right")
    if published:
        table.add_column("Published", justify="right")

    def add(label: str, value: str, name: str | None, model: str = "") -> None:
        printed = published[name].text if name is not None and name in published else ""
        table.add_row(label, value, *([model] if mixed else []), *([printed] if published else []))

    for label, key, scale, unit, error_key, name in _FIGURES:
        if figures.get(key) is None:
            continue
        if key in _RUBBING:
            label = left_out.headed(label)
        if not summary["converged"] and not isfinite(_figure(figures, error_key) or 0.0):
            add(label, "not converged", name)
            continue
        error, model = (_figure(figures, name_of) for name_of in (error_key, _of_model(error_key)))
        of_model = UNKNOWN if model == inf else _bar(model, 100.0, "%")
        add(label, _value(figures[key] * scale, unit, error), name, of_model)
        if error_key is not None and f"{error_key}_reason" in figures:
            table.add_row(_reason_label(figures[error_key]), figures[f"{error_key}_reason"])
        if key == "film_min_m":
            place = ", ".join(f"{along * 1e3:.3g}" for along in summary["film_min_at_m"])
            table.add_row("  at x, y" if "," in place else "  at x", f"{place} mm")
            table.add_row("  which is", summary["film_min_kind"])
        if key == "inlet_temperature_C":
            for row in _temperature_rows(summary, bodies):
                add(*row)
    for label, text in (*_regime_rows(summary), *_solution_rows(summary)):
        table.add_row(label, text)
    words = [] if scene.phase is None else ["phase"]
    _explain(table, [*words, summary["film_min_kind"]])
    return table


def _solution_rows(summary: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """The last grid, whether the solution converged, and which figures the accuracy refers to."""
    yield "Grid", _grid(summary["grid"])
    yield "Converged", _converged(summary)
    if "accuracy_of" in summary:
        words = accuracy_words(summary["accuracy"], summary["accuracy_of"])
        yield "Accuracy asked for", words


def _temperature_rows(
    summary: Mapping[str, Any], bodies: tuple[str, str]
) -> Iterator[tuple[str, str, str, str]]:
    """Maximum temperatures: label, value, name of the published one, and bar of the model of roughness."""
    for place, of in zip(HOT_PLACES, (*bodies, "the film"), strict=True):
        model = summary.get("temperature_max_model_error_K", {}).get(place)
        text, name = _temperature(summary, place), f"temperature_max_{place}"
        of_model = UNKNOWN if model == inf else _bar(model, 1.0, "K")
        yield f"Largest temperature of {of}", text, name, of_model


def _explain(table: Table, words: Sequence[str]) -> None:
    """The meaning of words below a table that has them."""
    said = [TERMS[word] for word in words if word in TERMS]
    if said:
        table.caption, table.caption_justify = " ".join(said), "left"


def scenes_table(scenes: Sequence[Scene], summaries: Sequence[Mapping[str, Any]]) -> Table:
    """Figures for comparing scenes, one row each; the specific film where roughness is known.

    Of a scene that did not converge nothing simulated is shown.

    Parameters
    ----------
    scenes : sequence of Scene
        The scenes.
    summaries : sequence of mapping
        `Solution.summary()` of each one's solution.
    """
    places, labels = _places(scenes)
    title = _at_worst(summaries).titled("All scenes")
    table = _slender(None, title)
    table.add_column(places, no_wrap=True)
    solved = [values for values in summaries if values["converged"]]
    rough = bool(solved) and all("specific_film" in values for values in solved)
    mixed = any("film_min_model_error" in values for values in solved)
    headings = ["Dry\nMPa", "Peak\nMPa", "Central\nµm", "± %", "Least\nµm", "± %"]
    headings += [*(["model\n± %"] if mixed else []), *(["lambda"] if rough else [])]
    for heading in (*headings, "s"):
        table.add_column(heading, justify="right")
    table.add_column("Con-\nver-\nged")
    for scene, label, values in zip(scenes, labels, summaries, strict=True):
        cells = [""] * len(headings)
        if values["converged"]:
            cells = [
                f"{_dry_pressure(scene, values) / 1e6:.4g}",
                f"{_at_least(values['pressure_max_error'])}{values['pressure_max_Pa'] / 1e6:.4g}",
                f"{values['film_central_m'] * 1e6:.4g}",
                f"{values['film_central_error'] * 100:.2g}",
                f"{values['film_min_m'] * 1e6:.4g}",
                f"{values['film_min_error'] * 100:.2g}",
                *([_model_bar(values, "film_min")] if mixed else []),
                *([f"{values['specific_film']:.3g}"] if rough else []),
            ]
        table.add_row(label, *cells, f"{values['seconds']:.1f}", _converged(values))
    _explain(table, places.lower().split("\n"))
    return table


def heat_table(
    scenes: Sequence[Scene],
    summaries: Sequence[Mapping[str, Any]],
    bodies: tuple[str, str] = BODIES,
) -> Table:
    """Friction, and temperatures where heat was simulated, by scene; arguments as `scenes_table`.

    The error bar of the temperatures is the largest of the three; `bodies` is what the bodies are called.
    """
    heated = any("temperature_max_C" in values for values in summaries)
    heading, labels = _places(scenes)
    left_out = _at_worst(summaries)
    title = left_out.titled(left_out.headed("Friction and heat of all scenes"))
    table = _slender(heading, title)
    mixed = any("friction_coefficient_model_error" in values for values in summaries)
    headings = ["Friction", "± %", *(["model\n± %"] if mixed else []), "Loss"]
    if heated:
        headings += [*(f"{body.capitalize()}\n°C" for body in bodies), "Film\n°C", "± K"]
    for heading in headings:
        table.add_column(heading, justify="right")
    for label, values in zip(labels, summaries, strict=True):
        if not values["converged"]:
            table.add_row(label, "not converged")
            continue
        loss, unit, scale = _LOSSES[values["kind"]]
        cells = [
            f"{values['friction_coefficient']:.4g}",
            f"{values['friction_coefficient_error'] * 100:.2g}",
            *([_model_bar(values, "friction_coefficient")] if mixed else []),
            f"{values[loss] * scale:.4g} {unit}",
        ]
        if "temperature_max_C" in values:
            cells += [f"{values['temperature_max_C'][place]:.1f}" for place in HOT_PLACES]
            cells.append(f"{max(values['temperature_max_error_K'].values()):.2g}")
        table.add_row(label, *cells)
    return table


def _converged(summary: Mapping[str, Any]) -> str:
    """Whether a scene converged, and less accurate than asked for."""
    if not summary["converged"]:
        return "NO"
    return "yes" if summary["accurate"] else "less accurate"


def _model_bar(summary: Mapping[str, Any], name: str) -> str:
    """Model uncertainty of a figure [%]; empty where there is none."""
    error = summary.get(f"{name}_model_error")
    if error is None:
        return ""
    return UNKNOWN if error == inf else f"{error * 100:.2g}"


def _at_worst(summaries: Sequence[Mapping[str, Any]]) -> LeftOut:
    """Effects left out of the figures of scenes, at the worst of the converged ones."""
    good = [values for values in summaries if values["converged"]] or summaries
    return worst([LeftOut.read(values) for values in good])


_LOSSES = {"point": ("power_loss_W", "W", 1.0), "line": ("power_loss_per_length_W_m", "kW/m", 1e-3)}
"""Kind of contact -> key of its power loss in summaries, the unit shown and the factor to it."""


def _dry_pressure(scene: Scene | LineScene, summary: Mapping[str, Any]) -> float:
    """Largest pressure of the dry contact [Pa]: of a line contact it is Hertz's."""
    if "dry_pressure_max_Pa" in summary:
        dry_pressure: float = summary["dry_pressure_max_Pa"]
        return dry_pressure
    dry_pressure = scene_summary(scene)["hertz_pressure_max_Pa"]
    return dry_pressure


def _places(scenes: Sequence[Scene | LineScene]) -> tuple[str, list[str]]:
    """Kind of place that distinguishes the scenes of a case, and the place of each."""
    names = [name for name in PLACE_NAMES if all(getattr(one, name) is not None for one in scenes)]
    if not names:
        return "Scene", [scene.name for scene in scenes]
    heading = "\n".join(name.replace("_roll_", "-\nroll\n") for name in names)
    parts = [[getattr(one, name) for name in names] for one in scenes]
    return heading.capitalize(), [
        " ".join(of if isinstance(of, str) else f"{of:g}" for of in row) for row in parts
    ]


def published_for(
    summary: Mapping[str, Any], published: Mapping[str, PublishedValue]
) -> Mapping[str, PublishedValue]:
    """Published values for a scene: all of the case's, except those of other places."""
    for place in PLACE_NAMES:
        if place in published and published[place].value != summary[place]:
            return {}
    return published


def plan_table(scene: Scene | LineScene, plan: Plan, expected: Expectation) -> Table:
    """A scene, its plan, and the expected time."""
    summary = scene_summary(scene)
    words = expected_to_leave_out(scene, plan).words
    table = Table(title="\n".join(filter(None, (_title(scene), words))), title_justify="left")
    table.add_column("Scene")
    table.add_column("", overflow="fold")
    for label, key, scale, unit in _SCENE:
        if key in summary:
            table.add_row(*_quantity(label, summary[key], scale, unit))
    for row in _regime_rows(plan.regime.summary()):
        table.add_row(*row)
    table.add_section()
    table.add_row("Accuracy wanted", f"{plan.accuracy * 100:g} % of {', '.join(plan.quantities)}")
    lacking = no_friction(plan.effects)
    if lacking and "friction_coefficient" not in plan.aim.figures:
        table.add_row("No friction", lacking)
    for grid in plan.grids:
        spacing = " x ".join(f"{step * 1e6:.3g}" for step in grid.spacing)
        table.add_row("Grid", f"{_grid(grid.shape)}, spacing {spacing} µm")
    if plan.refusal is not None:
        table.add_row("Will not converge", plan.refusal)
    table.add_row("Expected time", duration(expected.seconds))
    table.add_row("Expected convolutions", rough(expected.convolutions))
    return table


def effects_table(effects: Sequence[Judgement], title: str) -> Table:
    """Every effect: on or off, influence of leaving it out, reason."""
    table = Table(
        title=title, title_justify="left", box=SIMPLE_HEAD, pad_edge=False, collapse_padding=True
    )
    table.add_column("Effect", no_wrap=True)
    table.add_column("")
    table.add_column("Indicator", justify="right", no_wrap=True)
    quantities = next((tuple(effect.influence) for effect in effects if effect.influence), ())
    for quantity in quantities:
        table.add_column(QUANTITY_HEADINGS[quantity], justify="right", no_wrap=True)
    table.add_column("Why")
    for effect in effects:
        table.add_row(
            effect.name,
            "on" if effect.on else "off",
            "" if effect.indicator is None else f"{effect.indicator:.2g}",
            *(influence_percent(effect.influence.get(quantity)) for quantity in quantities),
            effect.reason,
        )
    return table


QUANTITY_HEADINGS = {"film": "Film", "friction": "Friction", "temperature": "Temp."}


def influence_percent(fraction: float | None) -> str:
    """Influence of leaving an effect out as text; empty where it is not known."""
    if fraction is None:
        return ""
    return ">99 %" if fraction > 0.99 else f"{fraction * 100:.2g} %"


def _title(scene: Scene | LineScene) -> str:
    return scene.name if scene.phase is None else f"Mesh {Place.of(scene)}"


def _value(value: float, unit: str, error: float | None = None) -> str:
    text = f"{value:.4g} {unit}".rstrip()
    if error is None:
        return text
    return f"{text} {_bar(error, 100.0, '%')}" if isfinite(error) else f"≥ {text}"


def _reason_label(error: float) -> str:
    """What the reason of an unusual error bar is the reason of."""
    return "  error bar" if isfinite(error) else "  no upper bound"


def _at_least(error: float) -> str:
    """Mark of a lower bound before a value whose error has no bound."""
    return "" if isfinite(error) else "≥ "


def _temperature(summary: Mapping[str, Any], place: str) -> str:
    value, error = (summary[key][place] for key in ("temperature_max_C", "temperature_max_error_K"))
    return f"{value:.1f} °C {_bar(error, 1.0, 'K')}" if isfinite(error) else f"≥ {value:.1f} °C"


def _bar(error: float | None, scale: float, unit: str) -> str:
    """An error bar; empty without one."""
    if error is None:
        return ""
    size = error * scale
    return f"± {size:.0f} {unit}" if 100 <= size < inf else f"± {size:.2g} {unit}"


def _figure(figures: Mapping[str, Any], key: str | None) -> float | None:
    """A figure by its key; None without a key or a figure."""
    return None if key is None else figures.get(key)


def _of_model(error_key: str | None) -> str | None:
    """Key of the model uncertainty beside that of a numerical error bar."""
    return error_key and error_key.replace("_error", "_model_error")


def _quantity(label: str, value: float | Sequence[float], scale: float, unit: str) -> tuple:
    """Label and value of a row; vectors are labelled with their directions."""
    values = value if isinstance(value, Sequence) else [value]
    text = ", ".join(f"{part * scale:.4g}" for part in values)
    return f"{label} along x, y" if len(values) > 1 else label, f"{text} {unit}"


def _regime_rows(summary: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """The regime of a contact, and how far it is from both borders."""
    yield "Regime", ", close to ".join((summary["regime"], *summary["regime_close_to"]))
    for label, key, beyond in (
        ("  deflection over film", "deflection_over_film", "elastic"),
        ("  alpha p in the inlet", "inlet_thickening", "piezoviscous"),
    ):
        value, error = summary[key], summary[f"{key}_error"]
        known = f"± {100 * error:.2g} %" if error < 0.2 else f"within a factor of {1 + error:.3g}"
        yield label, f"{value:.3g} {known} ({beyond} above 1)"


def _grid(shape: Sequence[int]) -> str:
    return " x ".join(str(count) for count in shape)
