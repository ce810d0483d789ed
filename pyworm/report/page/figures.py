"""The figures of a result with their error bars: at a glance, phase by phase, beside the printed ones."""

from collections.abc import Callable
from math import pi
from typing import Any

from pyworm.case.case import Case
from pyworm.case.case_file import PublishedValue
from pyworm.case.contact import GapCase
from pyworm.drives.mesh_loss import MeshLoss
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.format import bars, with_bars
from pyworm.io.present import present
from pyworm.io.quantity_text import shown_like
from pyworm.ratings.mesh_loss import mesh_loss
from pyworm.ratings.rating import Rating
from pyworm.ratings.standard_loss import NoStandard, StandardLoss
from pyworm.report.page.content import Block, Section, Table, Words
from pyworm.result.headline import of_all
from pyworm.result.result import Result
from pyworm.scene.index import Place
from pyworm.scene.summary import scene_summary
from pyworm.solver.left_out import LeftOut
from pyworm.solver.solution import Estimate, Solution

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


def composite_roughness(result: Result) -> float | None:
    """Composite roughness of the surfaces [m], where it is known."""
    return result.solutions[0].composite_roughness if result.solutions else None


def place_of(solution: Solution) -> str:
    """Name of a contact: its place in the cycle."""
    return str(Place.of(solution)) or solution.name


def glance_section(
    case: Case, result: Result, made: tuple[Rating, ...], standard: StandardLoss | NoStandard
) -> Section:
    """The decisive figures, each at its worst contact, and the ratings in `DECIDE`.

    The result has solutions that converged alone; without any, only ratings decide. Where roughness carries
    load the standard's loss stands beside the simulated one.
    """
    if not result.solutions:
        table = Table(("", "Value", "Where"), _decisive(made))
        return Section("At a glance", (Words("No contact converged."), table))
    loss = mesh_loss(case.drive, result)
    note = ERROR_BARS if loss is None else f"{ERROR_BARS} Loss: {loss.words}."
    rows = (*glance_rows(case, result, standard), *_decisive(made))
    return Section("At a glance", (Table(("", "Value", "Where"), rows, note=note),))


ERROR_BARS = (
    "± is numerical: the error of the solution of the model; ± (model) is what averages over roughness "
    "do not know. Errors of the inputs are in neither."
)
"""What the error bars of a report mean."""


def glance_rows(
    case: Case, result: Result, standard: StandardLoss | NoStandard
) -> tuple[tuple[str, str, str], ...]:
    """The decisive simulated figures, each at its worst contact; every solution converged."""
    solutions, headed = result.solutions, of_all(result.solutions).headed
    rows = [
        _worst("Least film", solutions, min, lambda of: of.film_min, 1e6, "µm"),
        _worst("Thinnest central film", solutions, min, lambda of: of.film_central, 1e6, "µm"),
        _worst("Largest pressure", solutions, max, lambda of: of.pressure_max, 1e-6, "MPa"),
    ]
    roughness = composite_roughness(result)
    if roughness is not None:
        thin = min(solutions, key=lambda of: of.figures.film_min.value)
        film = thin.figures.film_min
        label = f"Least specific film lambda (roughness {roughness * 1e6:.3g} µm)"
        value = f"{film.value / roughness:.3g} {bars(film.error, film.model)}"
        rows.append((label, value, place_of(thin)))
    if all(of.figures.friction_coefficient is not None for of in solutions):
        rows.append(
            _worst(
                headed("Largest friction"),
                solutions,
                max,
                lambda of: of.friction_coefficient,
                1.0,
                "",
            )
        )
    heats = [of.figures.temperature_max_film for of in solutions]
    warm = [(heat, of) for heat, of in zip(heats, solutions, strict=True) if heat is not None]
    if len(warm) == len(solutions):
        heat, hot = max(warm, key=lambda of: of[0].value)
        rows.append(("Largest temperature of the film", temperature(heat, hot), place_of(hot)))
    loss = mesh_loss(case.drive, result)
    if loss is not None:
        rows += _loss_rows(loss, of_all(solutions), standard)
    return tuple(rows)


def life_rows(case: Case, made: tuple[Rating, ...]) -> tuple[tuple[str, str, str], ...]:
    """Life or spectrum that a case asks for, and the rated figures that depend on it."""
    table = getattr(case.tables, "worm_rating", None)
    rows = []
    if table is not None and table.life is not None:
        rows.append(("Life asked for", f"{table.life / HOUR:.6g} h", "of the case"))
    for number, of in enumerate(() if table is None else table.spectrum, 1):
        load = f"{of.wheel_torque:.4g} N m, {of.worm_speed * PER_MINUTE:.4g} 1/min"
        rows.append((f"Load {number}", f"{of.duration / HOUR:.6g} h", load))
    return tuple(rows) + tuple(
        (figure.label, figure.shown(0), f"{rating.title}, {rating.columns[0]}")
        for rating in made
        for figure in rating.figures
        if figure.key in LASTING
    )


def _decisive(made: tuple[Rating, ...]) -> tuple[tuple[str, str, str], ...]:
    """Decisive figures of ratings, and the safeties with their verdicts."""
    safeties = tuple(
        (
            f"{of.symbol}, {of.label}",
            f"{of.shown}, required {of.minimum:g}: {of.verdict}".removeprefix(", "),
            f"{rating.title}, {rating.columns[0]}",
        )
        for rating in made
        for of in rating.safeties
    )
    return safeties + tuple(
        (figure.label, figure.shown(0), f"{rating.title}, {rating.columns[0]}")
        for rating in made
        for figure in rating.figures
        if figure.key in DECIDE
    )


def _worst(
    label: str,
    solutions: tuple[Solution, ...],
    worst: Callable[..., Solution],
    figure: Callable[[Any], Estimate],
    scale: float,
    unit: str,
) -> tuple[str, str, str]:
    at = worst(solutions, key=lambda of: figure(of.figures).value)
    return label, estimate(figure(at.figures), scale, unit), place_of(at)


def _loss_rows(
    loss: MeshLoss, left_out: LeftOut, standard: StandardLoss | NoStandard
) -> list[tuple[str, str, str]]:
    bar, headed = bars(loss.error, loss.model), left_out.headed
    lost = loss.loss / loss.power
    rows = [
        (headed("Mean friction between the teeth"), f"{loss.friction:.4g} {bar}", "mesh cycle"),
        (headed("Loss between the teeth"), f"{loss.loss:.4g} W {bar}", "mesh cycle"),
        (
            headed("Efficiency of the teeth, forward"),
            f"{loss.efficiency * 100:.4g} % {bars(loss.error, loss.model, 100 * lost)}",
            f"of {loss.power / 1e3:.4g} kW; without bearings, seals and churning"
            + (f"; {loss.missing}" if loss.missing else ""),
        ),
    ]
    if not left_out.as_if_smooth or isinstance(standard, NoStandard):
        return rows
    beside = f"{standard.friction:.3g}", f"{standard.power:.4g} W", f"{standard.efficiency:.1%}"
    return [
        part
        for row, value in zip(rows, beside, strict=True)
        for part in (row, ("  rough, by the standard", value.replace("%", " %"), standard.source))
    ]


def estimate(figure: Estimate, scale: float, unit: str) -> str:
    """A figure with its error bar."""
    value = f"{figure.value * scale:.4g} {unit}".rstrip()
    return with_bars(value, figure.error, figure.model, reason=figure.reason)


def temperature(figure: Estimate, solution: Solution) -> str:
    """A temperature of a solution with its error bar in kelvin."""
    value, rise = f"{figure.value - ZERO_CELSIUS:.1f} °C", solution.rise(figure)
    return with_bars(value, figure.error, figure.model, rise, " K", figure.reason)


def film_section(case: Case, result: Result) -> Section:
    """Load, pressure and film of every contact; nothing simulated of one that did not converge."""
    roughness = composite_roughness(result)
    head = ["", "Load", "Hertz", "Dry contact", "Largest pressure", "Central film", "Minimum film"]
    head += ["which is"] + (["lambda"] if roughness else []) + ["Converged"]
    rows = []
    for solution in result.solutions:
        figures = solution.figures
        hertz = _hertz(case, solution)
        cells = [
            place_of(solution),
            _load(solution),
            "" if hertz is None else f"{hertz / 1e6:.4g} MPa",
            "" if figures.dry is None else f"{figures.dry.pressure_max / 1e6:.4g} MPa",
        ]
        values = [
            estimate(figures.pressure_max, 1e-6, "MPa"),
            estimate(figures.film_central, 1e6, "µm"),
            estimate(figures.film_min, 1e6, "µm"),
            figures.film_min_kind,
        ]
        if roughness:
            values.append(f"{figures.film_min.value / roughness:.3g}")
        cells += values if solution.converged else [""] * len(values)
        rows.append((*cells, _converged(solution)))
    blocks: list[Block] = [_without_empty(Table(tuple(head), tuple(rows)))]
    if roughness:
        words = f"lambda is the minimum film over a composite roughness of {roughness * 1e6:.3g} µm: below 1 "
        words += "roughness carries load (boundary), from 3 on the film separates the flanks."
        blocks.append(Words(words))
    return Section("Film and pressure", tuple(blocks))


def _without_empty(table: Table) -> Table:
    """The table without empty columns."""
    filled = [n for n, name in enumerate(table.head) if n == 0 or any(row[n] for row in table.rows)]

    def selected(cells: tuple[str, ...]) -> tuple[str, ...]:
        return tuple(cells[n] for n in filled)

    return Table(selected(table.head), tuple(selected(row) for row in table.rows))


def _load(solution: Solution) -> str:
    unit = "N" if solution.kind == "point" else "N/m"
    if solution.load < 1e3:
        return f"{solution.load:.4g} {unit}"
    return f"{solution.load / 1e3:.4g} k{unit}"


def _scene_summary(case: Case, solution: Solution) -> dict[str, Any]:
    """Figures of the scene alone; none for a sampled gap, whose file the result does not contain."""
    if isinstance(case.tables, GapCase):
        return {}
    return scene_summary(case.scene(**Place.of(solution).given))


def _hertz(case: Case, solution: Solution) -> float | None:
    return _scene_summary(case, solution).get("hertz_pressure_max_Pa")


def _converged(solution: Solution) -> str:
    if solution.accurate:
        return "yes"
    return f"{'yes' if solution.converged else 'NO'}: {solution.stop_reason}"


def heat_section(case: Case, result: Result) -> Section | None:
    """Friction, loss and temperatures of every contact; None where friction was not simulated.

    A contact that did not converge has no figures.
    """
    if any(of.figures.friction_coefficient is None for of in result.solutions):
        return None
    heated = all(of.figures.temperature_max_film is not None for of in result.solutions)
    bodies = case.body_names
    headed = of_all(result.solutions).headed
    head = ["", headed("Friction coefficient"), headed("Power loss")]
    head += [f"Hottest on {body}" for body in bodies] + ["Hottest in the film"] if heated else []
    rows = []
    for solution in result.solutions:
        if not solution.converged:
            rows.append((place_of(solution), "not converged", *[""] * (len(head) - 2)))
            continue
        figures = solution.figures
        scale, unit = (1.0, "W") if solution.kind == "point" else (1e-3, "kW/m")
        cells = [
            place_of(solution),
            estimate(present(figures.friction_coefficient, "friction_coefficient"), 1.0, ""),
            estimate(present(figures.power_loss, "power_loss"), scale, unit),
        ]
        if heated:
            cells += [
                temperature(present(of, "temperature_max"), solution)
                for of in (
                    figures.temperature_max_body_1,
                    figures.temperature_max_body_2,
                    figures.temperature_max_film,
                )
            ]
        rows.append(tuple(cells))
    return Section("Friction, loss and temperature", (Table(tuple(head), tuple(rows)),))


def printed_section(case: Case, result: Result) -> Section | None:
    """Published values beside the computed ones; None where they share no figure."""
    blocks = []
    for solution in result.solutions:
        if not _is_meant(case.published, solution):
            continue
        known = _known(case, solution)
        rows = tuple(
            (
                name.replace("_", " "),
                _printed(printed.text),
                _printed(shown_like(*known[name], printed.text)),
            )
            for name, printed in case.published.items()
            if name in known
        )
        if rows:
            title = place_of(solution)
            blocks.append(Table(("", "Printed", "Computed"), rows, title=title))
    return Section("Beside the source's figures", tuple(blocks)) if blocks else None


def _printed(text: str) -> str:
    """A quantity of a case file, typeset."""
    return text.replace("degC", "°C").replace("degF", "°F").replace("uin", "µin")


def _is_meant(published: dict[str, PublishedValue], solution: Solution) -> bool:
    place = {name: of for name, of in Place.of(solution).given.items() if name in published}
    return all(published[name].value == of for name, of in place.items())


def _known(case: Case, solution: Solution) -> dict[str, tuple[float, str]]:
    """Figures of a contact by the names that `[published]` has for them, each with its SI unit."""
    summary = solution.summary()
    known: dict[str, tuple[float, str]] = {}
    for key, value in {**_scene_summary(case, solution), **summary}.items():
        for suffix, unit in _UNITS.items():
            if key.endswith(suffix) and isinstance(value, float):
                known[key.removesuffix(suffix)] = value, unit
    if solution.figures.friction_coefficient is not None:
        known["friction_coefficient"] = summary["friction_coefficient"], ""
    for place, celsius in summary.get("temperature_max_C", {}).items():
        known[f"temperature_max_{place}"] = celsius + ZERO_CELSIUS, "K"
    if "specific_film" in summary:
        known["specific_film"] = summary["specific_film"], ""
    return known


_UNITS = {"_m": "m", "_Pa": "Pa", "_N": "N", "_W": "W", "_N_m": "N/m", "_per_length_W_m": "W/m"}
"""Endings of keys of summaries -> their units."""
