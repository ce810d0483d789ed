"""The figures of a result with their error bars: key results, phase by phase, beside the printed ones."""

from math import pi
from typing import Any

from pyworm.case.case import Case
from pyworm.case.case_file import PublishedValue
from pyworm.case.contact import GapCase
from pyworm.drives.mesh_loss import MeshLoss
from pyworm.io.quantities import QUANTITIES, Quantity, listed
from pyworm.io.quantity_text import bars, shown_like
from pyworm.ratings.rating import Rating
from pyworm.ratings.standard_loss import NoStandard
from pyworm.report.findings import Findings
from pyworm.report.page.content import Block, Section
from pyworm.report.table import Table
from pyworm.result.result import plain_attributes
from pyworm.scene.index import ContactIndex
from pyworm.scene.summary import scene_summary
from pyworm.solver.solution import Solution

DECIDE = (
    "wear_probability",
    "scuffing_probability",
    "scuffing_risk",
    "wear_depth_m",
    "modified_life_h",
)
"""Keys of the rated figures in the summary of a report."""


LASTING = ("wear_depth_m", "wear_limit_m", "basic_life_h", "modified_life_h", "wear_probability")
"""Keys of the rated figures that tell how long a drive lasts."""

HOUR = 3600.0
PER_MINUTE = 30 / pi
"""From rad/s."""

Row = tuple[str, str, str]
"""Figure, value, and where it is."""


def place_of(solution: Solution) -> str:
    """Name of a contact: its place in the cycle."""
    return str(ContactIndex.of(solution)) or solution.name


def key_results_section(found: Findings) -> Section:
    """The decisive figures, each at its worst contact, and the ratings in `DECIDE`.

    Without a converged contact only ratings decide. Where roughness carries load the standard's loss stands
    beside the simulated one.
    """
    decisive = _decisive(found.ratings)
    if not found.sound.solutions:
        table = Table(("", "Value", "Where"), decisive)
        return Section("Key results", ("No contact converged.", table))
    loss = found.mesh_loss
    note = ERROR_BARS if loss is None else f"{ERROR_BARS} Loss: {loss.words}."
    rows = (*key_result_rows(found), *decisive)
    return Section("Key results", (Table(("", "Value", "Where"), rows, note=note),))


ERROR_BARS = (
    "± is numerical: the error of the solution of the model; ± (model) is what averages over roughness "
    "do not know. Errors of the inputs are in neither."
)
"""What the error bars of a report mean."""


def key_result_rows(found: Findings) -> tuple[Row, ...]:
    """The decisive simulated figures, each at its worst contact; none without a converged one."""
    solutions = found.sound.solutions
    rows = []
    for quantity in listed("key") if solutions else ():
        figures = [quantity.value_in(solution) for solution in solutions]
        if all(figure is not None for figure in figures):
            rows.append(_worst(quantity, found))
    if solutions and found.mesh_loss is not None:
        rows += _loss_rows(found.mesh_loss, found)
    return tuple(rows)


def _worst(quantity: Quantity, found: Findings) -> Row:
    """A figure at the contact where it is worst."""
    worst = min if quantity.extreme == "minimum" else max
    solution = worst(found.sound.solutions, key=lambda solution: quantity.value_in(solution).value)
    label = quantity.worst_title()
    if quantity.name == "friction_coefficient":
        label = found.neglected_effects.qualified(label)
    if quantity.name == "specific_film" and found.composite_roughness:
        roughness = QUANTITIES["composite_roughness"]
        label += f" ({roughness.words()} {roughness.text(found.composite_roughness)})"
    return label, solution.figure_text(quantity), place_of(solution)


def life_rows(case: Case, ratings: tuple[Rating, ...]) -> tuple[Row, ...]:
    """Life or spectrum that a case asks for, and the rated figures that depend on it."""
    table = getattr(case.tables, "worm_rating", None)
    rows = []
    if table is not None and table.life is not None:
        rows.append(("Required life", f"{table.life / HOUR:.6g} h", "of the case"))
    for number, step in enumerate(() if table is None else table.spectrum, 1):
        torque = QUANTITIES["wheel_torque"].text(step.wheel_torque)
        load = f"{torque}, {step.worm_speed * PER_MINUTE:.4g} 1/min"
        rows.append((f"Load {number}", f"{step.duration / HOUR:.6g} h", load))
    return tuple(rows) + tuple(
        (figure.label, figure.shown(0), f"{rating.title}, {rating.columns[0]}")
        for rating in ratings
        for figure in rating.figures
        if figure.key in LASTING
    )


def _decisive(ratings: tuple[Rating, ...]) -> tuple[Row, ...]:
    """Decisive figures of ratings, and the safeties with their verdicts."""
    safeties = tuple(
        (
            f"{safety.symbol}, {safety.label}",
            f"{safety.shown}, required {safety.minimum:g}: {safety.verdict}".removeprefix(", "),
            f"{rating.title}, {rating.columns[0]}",
        )
        for rating in ratings
        for safety in rating.safeties
    )
    return safeties + tuple(
        (figure.label, figure.shown(0), f"{rating.title}, {rating.columns[0]}")
        for rating in ratings
        for figure in rating.figures
        if figure.key in DECIDE
    )


def _loss_rows(loss: MeshLoss, found: Findings) -> list[Row]:
    bar, qualified, standard = (
        bars(loss.error, loss.model),
        found.neglected_effects.qualified,
        found.standard,
    )
    power, friction, efficiency = (
        QUANTITIES[name] for name in ("mesh_loss", "mesh_friction", "mesh_efficiency")
    )
    loss_share = loss.loss / loss.power
    rows = [
        (qualified(friction.title()), f"{friction.text(loss.friction)} {bar}", "mesh cycle"),
        (qualified(power.title()), f"{power.text(loss.loss)} {bar}", "mesh cycle"),
        (
            qualified(f"{efficiency.title()}, forward"),
            f"{efficiency.text(loss.efficiency)} {bars(loss.error, loss.model, 100 * loss_share)}",
            f"of {loss.power / 1e3:.4g} kW; without bearings, seals and churning"
            + (f"; {loss.missing}" if loss.missing else ""),
        ),
    ]
    if not found.neglected_effects.as_if_smooth or isinstance(standard, NoStandard):
        return rows
    beside = (
        f"{standard.friction:.3g}",
        power.text(standard.power),
        f"{standard.efficiency * 100:.1f} %",
    )
    return [
        part
        for row, value in zip(rows, beside, strict=True)
        for part in (row, ("  rough, by the standard", value, standard.source))
    ]


def film_section(found: Findings) -> Section:
    """Load, pressure and film of every contact; nothing simulated of one that did not converge."""
    shown = listed("film")
    rows = []
    for solution in found.result.solutions:
        scene = _scene_summary(found.case, solution)
        cells = [
            quantity.text(scene[quantity.key])
            if quantity.key in scene
            else solution.figure_text(quantity)
            for quantity in shown
        ]
        rows.append((place_of(solution), load_of(solution), *cells, _converged(solution)))
    titles = (quantity.title() for quantity in shown)
    head = ("", "Load", *titles, "Converged")
    blocks: list[Block] = [_without_empty(Table(head, tuple(rows)))]
    roughness = QUANTITIES["composite_roughness"]
    if found.composite_roughness:
        ratio, film = QUANTITIES["specific_film"], QUANTITIES["film_min"]
        words = f"{ratio.symbol} is the {film.words()} over a {roughness.words()} of "
        words += f"{roughness.text(found.composite_roughness)}: below 1 roughness carries load (boundary), "
        words += "from 3 on the film separates the flanks."
        blocks.append(words)
    return Section("Film and pressure", tuple(blocks))


def _without_empty(table: Table) -> Table:
    """The table without empty columns."""
    filled = [n for n, name in enumerate(table.head) if n == 0 or any(table.column(n))]

    def selected(cells: tuple[str, ...]) -> tuple[str, ...]:
        return tuple(cells[n] for n in filled if n < len(cells))

    return Table(selected(table.head), tuple(selected(row) for row in table.rows))


def load_of(solution: Solution) -> str:
    """Load of a contact, of a line for each length."""
    load = next(QUANTITIES[name] for name in LOADS if QUANTITIES[name].kind == solution.kind)
    return load.text(solution.load)


LOADS = "load", "load_per_length"
"""Loads of kinds of contacts."""


def _scene_summary(case: Case, solution: Solution) -> dict[str, Any]:
    """Figures of the scene alone; none for a sampled gap, whose file the result does not contain."""
    if isinstance(case.tables, GapCase):
        return {}
    return scene_summary(case.scene(**ContactIndex.of(solution).given))


def _converged(solution: Solution) -> str:
    if solution.accurate:
        return "yes"
    return f"{'yes' if solution.converged else 'NO'}: {solution.stop_reason}"


def heat_section(found: Findings) -> Section | None:
    """Friction, loss and temperatures of every contact; None where friction was not simulated.

    A contact that did not converge has no figures.
    """
    solutions = found.result.solutions
    if any(solution.figures.friction_coefficient is None for solution in solutions):
        return None
    bodies, qualified = found.case.body_names, found.neglected_effects.qualified
    shown = [
        quantity
        for quantity in listed("heat")
        if all(quantity.value_in(solution) is not None for solution in solutions)
    ]
    rows = [
        (place_of(solution), *map(solution.figure_text, shown))
        if solution.converged
        else (place_of(solution), "not converged")
        for solution in solutions
    ]
    titles = [
        qualified(quantity.title()) if quantity.unit != "K" else quantity.title(bodies)
        for quantity in shown
    ]
    return Section("Friction, loss and temperature", (Table(("", *titles), tuple(rows)),))


def printed_section(found: Findings) -> Section | None:
    """Published values beside the computed ones; None where they share no figure."""
    case, blocks = found.case, []
    for solution in found.sound.solutions:
        if not _is_meant(case.published, solution):
            continue
        known = _known(case, solution)
        rows = tuple(
            (
                quantity.title(case.body_names),
                _printed(printed.text),
                _printed(shown_like(value, _si_unit(quantity), printed.text)),
            )
            for name, printed in case.published.items()
            if name in known
            for quantity, value in (known[name],)
        )
        if rows:
            title = place_of(solution)
            blocks.append(Table(("", "Printed", "Computed"), rows, title=title))
    return Section("Comparison with published values", tuple(blocks)) if blocks else None


def _si_unit(quantity: Quantity) -> str:
    """Its SI unit as case files write it."""
    return "" if quantity.unit == "1" else quantity.unit


def _printed(text: str) -> str:
    """A quantity of a case file, typeset."""
    return text.replace("degC", "°C").replace("degF", "°F").replace("uin", "µin")


def _is_meant(published: dict[str, PublishedValue], solution: Solution) -> bool:
    place = {
        name: value for name, value in ContactIndex.of(solution).given.items() if name in published
    }
    return all(published[name].value == value for name, value in place.items())


def _known(case: Case, solution: Solution) -> dict[str, tuple[Quantity, float]]:
    """Figures of a contact in SI by the names that `[published]` has for them."""
    values = plain_attributes({**_scene_summary(case, solution), **solution.summary()})
    return {
        quantity.published: (quantity, values[quantity.key] + quantity.offset)
        for quantity in QUANTITIES.values()
        if quantity.published and isinstance(values.get(quantity.key), float)
    }
