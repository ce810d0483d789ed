"""`pyworm surface FILE --with FILE --case CASE.toml`: from measured surfaces to the film between them."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pyworm.cli.shared import CONVERGED, FAILED, NOT_CONVERGED, drawn_pictures
from pyworm.io.input_error import CaseError
from pyworm.io.json import print_json
from pyworm.io.present import present
from pyworm.io.stage import stage
from pyworm.io.terminal import print_result

if TYPE_CHECKING:
    from pyworm.case.case import Case
    from pyworm.scene.any_contact import AnyContact
    from pyworm.solver.solution import Solution

STATES = {"as measured": False, "run in": True}
"""Columns of the table: whether the summits of the last body's surface are worn off."""

RESULTS_SHOWN = (
    "film_min", "film_central", "specific_film", "asperity_load_fraction", "pressure_max",
    "friction_coefficient", "temperature_max_body_1", "temperature_max_body_2",
)  # fmt: skip
"""Results in the table."""


def film_between(options: argparse.Namespace, given: dict[str, Any]) -> int:
    """Solve a contact of a case between measured surfaces, as measured and run in; print and draw both."""
    from pyworm.batch.measured_pair import measured_pair, middle_contact, solve_contact

    if options.case is None:
        raise CaseError(
            "--with, --resolved: give --case CASE.toml too, whose bodies have these surfaces"
        )
    files = [options.file] if options.other is None else [options.file, options.other]
    tables = [_keys(path, given) for path in files]
    if options.resolved is not None:
        from pyworm.cli.surface_patch import resolved_between

        return resolved_between(options, tables, options.resolved)
    cases, scenes, solutions = {}, {}, {}
    for state, worn in STATES.items():
        cases[state] = measured_pair(options.case, tables, run_in=worn)
        scenes[state] = middle_contact(cases[state], options.phase)
        with stage(f"solving {scenes[state].name} with its surfaces {state}"):
            solutions[state] = solve_contact(cases[state], scenes[state])
    found = {state: solution.summary() for state, solution in solutions.items()}
    pictures: list[str] = []
    complete = True
    if options.out is not None:
        pictures, complete = drawn_pictures(
            options.out, lambda aside: _draw(scenes, solutions, aside)
        )
    if options.json:
        print_json({"case": cases["as measured"].name, "contacts": found, "pictures": pictures})
    else:
        _print(cases, solutions)
        for name in pictures:
            print_result(f"{options.out / name}")
    if not all(solution.converged for solution in solutions.values()):
        return NOT_CONVERGED
    return CONVERGED if complete else FAILED


def _keys(path: Path, given: dict[str, Any]) -> dict[str, Any]:
    """Keys of `[bodies.NAME.surface]` of a file, or those that a .toml holds."""
    from pyworm.cli.surface_keys import keys_of
    from pyworm.io.toml import read_toml

    if not path.is_file():
        raise CaseError(f"{path}: no such file")
    keys = read_toml(path) if path.suffix == ".toml" else keys_of(path, given)
    beside = {
        key: str((path.parent / keys[key]).absolute()) for key in ("file", "mask") if key in keys
    }
    lists = {
        key: [str((path.parent / name).absolute()) for name in keys[key]]
        for key in ("across", "along")
        if key in keys
    }
    return keys | beside | lists


def _print(cases: "dict[str, Case]", solutions: "dict[str, Solution]") -> None:
    from pyworm.case.surface import texture_of
    from pyworm.io.console import Console
    from pyworm.io.quantities import QUANTITIES
    from pyworm.report.table import Table

    rows: list[tuple[str, ...]] = []
    surfaces = {state: case.tables.bodies.surfaces for state, case in cases.items()}
    for body in surfaces["as measured"]:
        textures = [texture_of(tables[body].topography()) for tables in surfaces.values()]
        for name, size in (
            ("Sq", [f"{texture.rq * 1e6:.3g} µm" for texture in textures]),
            ("Spk", [f"{texture.rpk * 1e6:.3g} µm" for texture in textures]),
            ("Sdq", [f"{texture.slope:.3g}" for texture in textures]),
        ):
            rows.append((f"{body}, {name}", *size))
    for quantity in QUANTITIES.values():
        if quantity.name in RESULTS_SHOWN:
            texts = [solution.figure_text(quantity) for solution in solutions.values()]
            names = cases["as measured"].body_names
            if any(texts):
                label = quantity.label.format(*names)
                rows.append((label[:1].upper() + label[1:], *texts))
    Console().print(Table(("Contact between measured surfaces", *solutions), tuple(rows)))
    for state, solution in solutions.items():
        if not solution.accurate:
            print_result(f"{state}: {solution.stop_reason}")


def _draw(
    scenes: "dict[str, AnyContact]", solutions: "dict[str, Solution]", directory: Path
) -> list[Path]:
    from pyworm.plots.attempts import Attempts
    from pyworm.plots.surface import draw_states

    pairs = {
        state: (present(scene.rough_pair, "roughness"), solutions[state].figures.film_central.value)
        for state, scene in scenes.items()
    }
    attempts = Attempts()
    attempts.draw(directory / "between_surfaces.png", lambda: draw_states(pairs))
    return attempts.result()
