"""Tables on the console: scene, plan and solution, in workshop units."""

from collections.abc import Iterator, Mapping, Sequence
from math import inf, isfinite
from typing import Any

from pyworm.case.case_file import PublishedValue
from pyworm.io.quantities import BODIES, QUANTITIES, Quantity, listed
from pyworm.io.quantity_text import UNKNOWN, duration, rough, uncertainty_label
from pyworm.planning.effects.judgement import Judgement
from pyworm.planning.no_friction import no_friction
from pyworm.planning.plan import Plan
from pyworm.report.table import Table
from pyworm.result.accuracy import accuracy_words
from pyworm.result.result import plain_attributes
from pyworm.scene.index import INDEX_NAMES, ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.scene.summary import scene_summary
from pyworm.solver.cost.expected_time import Expectation
from pyworm.solver.neglected_effects import NeglectedEffects, worst
from pyworm.solver.neglected_effects import expected as expected_to_leave_out

_RUBBING = {"friction_coefficient", "power_loss"}
"""Figures that roughness adds to where it carries load."""

TERMS = {
    "phase": "Phase: mesh phase of a contact, 0 at its first and 1 at its last point.",
    "side lobe": "Side lobe: one of the two film constrictions at the sides of a contact, downstream of its "
    "centre.",
}
"""Word in tables -> what it means, written below them."""


def figures_table(
    scene: Scene | LineScene,
    summary: Mapping[str, Any],
    published: Mapping[str, PublishedValue],
    bodies: tuple[str, str] = BODIES,
) -> Table:
    """Figures of one solved contact by its `Solution.summary()`, with those that the source prints of it."""
    figures = plain_attributes({**scene_summary(scene), **summary})
    neglected_effects = NeglectedEffects.read(summary)
    mixed = "film_min_model_error" in summary
    head = ("Quantity", "Value", *(["± model"] if mixed else []))

    def cells(quantity: Quantity) -> Iterator[tuple[str, ...]]:
        label = f"  {quantity.words(bodies)}" if quantity.part else quantity.title(bodies)
        if quantity.figure in _RUBBING:
            label = neglected_effects.qualified(label)
        label += _directions(figures[quantity.key])
        beside = published.get(quantity.published)
        error, model = _errors(quantity, figures)
        unknown = not (summary["converged"] or isfinite(error or 0.0))
        value = "not converged" if unknown else _value(quantity, figures[quantity.key], error)
        row = [label, value, *([model] if mixed else [])]
        yield tuple(row) if beside is None else (*row, beside.text)
        reason = figures.get(f"{quantity.error_key}_reason")
        if error is not None and reason is not None and not unknown:
            reasons.append(f"{label}: {uncertainty_label(error)}, {reason}.")

    reasons: list[str] = []
    known = [quantity for quantity in listed("figures") if figures.get(quantity.key) is not None]
    rows = [row for quantity in known for row in cells(quantity)]
    words = [*([] if scene.phase is None else ["phase"]), summary["film_min_kind"]]
    return Table(
        head=(*head, "Published") if published else head,
        rows=tuple(rows),
        title=neglected_effects.titled(_title(scene)),
        note=" ".join((*reasons, _terms(words))).strip(),
    )


def _errors(quantity: Quantity, figures: Mapping[str, Any]) -> tuple[float | None, str]:
    """Numerical uncertainty of a figure, None of one without, and the model's as text."""
    if quantity.given:
        return None, ""
    model = figures.get(quantity.model_key)
    return figures.get(quantity.error_key), UNKNOWN if model == inf else _bar(quantity, model)


def solution_table(summary: Mapping[str, Any]) -> Table:
    """Regime of one solved contact, its last grid, whether it converged, and which accuracy was requested."""
    rows = [
        *_regime_rows(summary),
        ("Grid", _grid(summary["grid"])),
        ("Converged", _converged(summary)),
    ]
    if "accuracy_of" in summary:
        words = accuracy_words(summary["accuracy"], summary["accuracy_of"])
        rows.append(("Requested accuracy", words))
    return Table(("Regime and solution", ""), tuple(rows), texts=(1,))


def _terms(words: Sequence[str]) -> str:
    """The meaning of words of a table that has them."""
    return " ".join(TERMS[word] for word in words if word in TERMS)


def scenes_table(
    scenes: Sequence[Scene | LineScene], summaries: Sequence[Mapping[str, Any]]
) -> Table:
    """Figures for comparing contacts, one row each; the specific film thickness where roughness is known.

    Nothing simulated is shown for a contact that did not converge. The column of convergence is left away
    where all converged with the requested accuracy.
    """
    places, labels = _places(scenes)
    solved = [values for values in summaries if values["converged"]]
    rough = bool(solved) and all("specific_film" in values for values in solved)
    mixed = any("film_min_model_error" in values for values in solved)
    dry, pressure, central, thin, ratio = (QUANTITIES[name] for name in _COMPARED)
    head = [dry.column, pressure.column, central.column, "± %", thin.column, "± %"]
    head += [*(["model\n± %"] if mixed else []), *([ratio.column] if rough else [])]
    rows: list[tuple[str, ...]] = []
    perfect = all(values["converged"] and values["accurate"] for values in summaries)
    status_head = () if perfect else ("Converged",)
    for scene, label, values in zip(scenes, labels, summaries, strict=True):
        cells = [""] * len(head)
        if values["converged"]:
            cells = [
                dry.digits(dry.by_key(_dry_pressure(scene, values))),
                "≥ " * (not isfinite(values[pressure.error_key])) + _number(pressure, values),
                _number(central, values),
                _percent(values, central.error_key),
                _number(thin, values),
                _percent(values, thin.error_key),
                *([_percent(values, thin.model_key)] if mixed else []),
                *([f"{values[ratio.key]:.3g}"] if rough else []),
            ]
        status = [_converged(values)] * len(status_head)
        rows.append((label, *cells, f"{values['seconds']:.1f}", *status))
    return Table(
        head=(places, *head, QUANTITIES["solve_time"].column, *status_head),
        rows=tuple(rows),
        title=_at_worst(summaries).titled("All contacts"),
        note=f"{_terms(places.lower().split(chr(10)))} t: elapsed time.".strip(),
        texts=() if perfect else (len(head) + 2,),
        narrow=True,
    )


_COMPARED = "dry_pressure_max", "pressure_max", "film_central", "film_min", "specific_film"
"""Figures by which scenes are compared."""


def heat_table(
    scenes: Sequence[Scene | LineScene],
    summaries: Sequence[Mapping[str, Any]],
    bodies: tuple[str, str] = BODIES,
) -> Table:
    """Friction, and temperatures where heat was simulated, by scene; arguments as `scenes_table`.

    The error bar of the temperatures is the largest of the three; `bodies` is what the bodies are called.
    """
    heated = any("temperature_max_C" in values for values in summaries)
    heading, labels = _places(scenes)
    neglected_effects = _at_worst(summaries)
    friction = QUANTITIES["friction_coefficient"]
    mixed = any(friction.model_key in values for values in summaries)
    rows: list[tuple[str, ...]] = []
    losses = [
        QUANTITIES[name]
        for name in _LOSSES
        if any(QUANTITIES[name].key in values for values in summaries)
    ]
    head = [friction.column, "± %", *(["model\n± %"] if mixed else [])]
    head += [loss.column for loss in losses]
    if heated:
        head += [
            f"{body.capitalize()}\n{quantity.shown}" for body, quantity in _warmest(bodies)
        ] + ["± K"]
    for label, values in zip(labels, summaries, strict=True):
        if not values["converged"]:
            rows.append((label, "not converged"))
            continue
        cells = [
            _number(friction, values),
            _percent(values, friction.error_key),
            *([_percent(values, friction.model_key)] if mixed else []),
            *(_number(loss, values) if loss.key in values else "" for loss in losses),
        ]
        if "temperature_max_C" in values:
            flat = plain_attributes(values)
            cells += [_number(quantity, flat) for _, quantity in _warmest(bodies)]
            cells.append(f"{max(values['temperature_max_error_K'].values()):.2g}")
        rows.append((label, *cells))
    return Table(
        head=(heading, *head),
        rows=tuple(rows),
        title=neglected_effects.titled(
            neglected_effects.qualified("Friction and temperatures of all contacts")
        ),
        narrow=True,
    )


def _warmest(bodies: tuple[str, str]) -> list[tuple[str, Quantity]]:
    """Bodies and film with their maximum temperatures."""
    return [
        (name, QUANTITIES[f"temperature_max_{place}"])
        for name, place in zip((*bodies, "film"), ("body_1", "body_2", "film"), strict=True)
    ]


def _converged(summary: Mapping[str, Any]) -> str:
    """Whether a scene converged, and less accurate than asked for."""
    if not summary["converged"]:
        return "NO"
    return "yes" if summary["accurate"] else "less accurate"


def _number(quantity: Quantity, figures: Mapping[str, Any]) -> str:
    """A figure of a summary as shown, without its unit."""
    return quantity.digits(quantity.by_key(figures[quantity.key]))


def _percent(summary: Mapping[str, Any], key: str) -> str:
    """An uncertainty of a figure [%]; empty where there is none."""
    error = summary.get(key)
    if error is None:
        return ""
    return UNKNOWN if error == inf else f"{error * 100:.2g}"


def _at_worst(summaries: Sequence[Mapping[str, Any]]) -> NeglectedEffects:
    """Effects left out of the figures of scenes, at the worst of the converged ones."""
    good = [values for values in summaries if values["converged"]] or summaries
    return worst([NeglectedEffects.read(values) for values in good])


_LOSSES = "power_loss", "power_loss_per_length"
"""Power losses of kinds of contacts."""


def _dry_pressure(scene: Scene | LineScene, summary: Mapping[str, Any]) -> float:
    """Maximum dry contact pressure [Pa]: of a line contact it is Hertz's."""
    figures = {**scene_summary(scene), **summary}
    keys = [QUANTITIES[name].key for name in ("dry_pressure_max", "hertz_pressure_max")]
    return next(figures[key] for key in keys if key in figures)


def _places(scenes: Sequence[Scene | LineScene]) -> tuple[str, list[str]]:
    """Kind of place that distinguishes the scenes of a case, and the place of each."""
    names = [
        name for name in INDEX_NAMES if all(getattr(scene, name) is not None for scene in scenes)
    ]
    if not names:
        return "Contact", [scene.name for scene in scenes]
    heading = "\n".join(name.replace("_roll_", "-\nroll\n") for name in names)
    parts = [[getattr(scene, name) for name in names] for scene in scenes]
    return heading.capitalize(), [
        " ".join(value if isinstance(value, str) else f"{value:g}" for value in row)
        for row in parts
    ]


def published_for(
    summary: Mapping[str, Any], published: Mapping[str, PublishedValue]
) -> Mapping[str, PublishedValue]:
    """Published values for a scene: all of the case's, except those of other places."""
    for place in INDEX_NAMES:
        if place in published and published[place].value != summary[place]:
            return {}
    return published


def plan_table(scene: Scene | LineScene, plan: Plan, expected: Expectation) -> Table:
    """A scene, its plan, and the expected time."""
    summary = scene_summary(scene)
    words = expected_to_leave_out(scene, plan).words
    rows: list[tuple[str, ...]] = [
        (
            quantity.title() + _directions(summary[quantity.key]),
            _value(quantity, summary[quantity.key]),
        )
        for quantity in listed("contact")
        if quantity.key in summary
    ]
    rows += [*_regime_rows(plan.regime.summary()), ()]
    rows.append(
        ("Requested accuracy", f"{plan.accuracy * 100:g} % of {', '.join(plan.quantities)}")
    )
    lacking = no_friction(plan.effects)
    if lacking and "friction_coefficient" not in plan.target.figures:
        rows.append(("No friction", lacking))
    for grid in plan.grids:
        spacing = " x ".join(f"{step * 1e6:.3g}" for step in grid.spacing)
        rows.append(("Grid", f"{_grid(grid.shape)}, spacing {spacing} µm"))
    if plan.refusal is not None:
        rows.append(("Will not converge", plan.refusal))
    rows.append(("Expected time", duration(expected.seconds)))
    rows.append(("Expected convolutions", rough(expected.convolutions)))
    title = "\n".join(filter(None, (_title(scene), words)))
    return Table(("Contact", ""), tuple(rows), title, texts=(1,))


def effects_table(effects: Sequence[Judgement], title: str) -> Table:
    """Every effect: on or off, influence of leaving it out, reason."""
    influenced = next((tuple(effect.influence) for effect in effects if effect.influence), ())
    headings = [QUANTITY_HEADINGS[name] for name in influenced]
    rows = [
        (
            effect.name,
            "on" if effect.on else "off",
            "" if effect.indicator is None else f"{effect.indicator:.2g}",
            *(influence_percent(effect.influence.get(name)) for name in influenced),
            effect.reason,
        )
        for effect in effects
    ]
    head = ("Effect", "", "Indicator", *headings, "Why")
    return Table(head, tuple(rows), title, texts=(1, len(head) - 1), narrow=True)


QUANTITY_HEADINGS = {"film": "Film", "friction": "Friction", "temperature": "Temp."}


def influence_percent(fraction: float | None) -> str:
    """Influence of leaving an effect out as text; empty where it is not known."""
    if fraction is None:
        return ""
    return ">99 %" if fraction > 0.99 else f"{fraction * 100:.2g} %"


def _title(scene: Scene | LineScene) -> str:
    return scene.name if scene.phase is None else f"Mesh {ContactIndex.of(scene)}"


def _value(quantity: Quantity, value: Any, error: float | None = None) -> str:
    """A value of a JSON object with its unit and its error bar, if it has one."""
    if isinstance(value, str):
        return value
    values = value if isinstance(value, Sequence) else [value]
    text = quantity.with_unit(
        ", ".join(quantity.digits(quantity.by_key(value)) for value in values)
    )
    if error is None:
        return text
    return f"{text} {_bar(quantity, error)}" if isfinite(error) else f"≥ {text}"


def _directions(value: Any) -> str:
    """Directions of a vector, to be shown behind its label; empty for a scalar."""
    return " along x, y" if isinstance(value, Sequence) and len(value) > 1 else ""


def _bar(quantity: Quantity, error: float | None) -> str:
    """An error bar, of temperatures in K; empty without one."""
    if error is None:
        return ""
    size, unit = (error, "K") if quantity.unit == "K" else (error * 100.0, "%")
    return f"± {size:.0f} {unit}" if 100 <= size < inf else f"± {size:.2g} {unit}"


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
