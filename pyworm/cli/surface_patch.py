"""`pyworm surface FILE --case CASE.toml --resolved`: the surfaces node by node beside their averages."""

import argparse
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pyworm.cli.shared import CONVERGED, FAILED, NOT_CONVERGED, drawn_pictures, end_with
from pyworm.io.input_error import CaseError
from pyworm.io.json import print_json
from pyworm.io.stage import stage
from pyworm.io.terminal import print_message, print_result

if TYPE_CHECKING:
    from pyworm.solver.patch.patch_record import RoughPatch
    from pyworm.solver.solution import Solution

ROWS = {
    "film_mean_m": "film_central",
    "film_min_m": "film_min",
    "asperity_load_fraction": "asperity_load_fraction",
    "friction_coefficient": "friction_coefficient",
    "temperature_max_body_1_C": "temperature_max_body_1",
    "temperature_max_body_2_C": "temperature_max_body_2",
    "pressure_max_Pa": "pressure_max",
}
"""Figure of the patch -> quantity of the averaged model."""


def resolved_between(
    options: argparse.Namespace, tables: Sequence[Mapping[str, Any]], nodes: int
) -> int:
    """Move measured surfaces through a contact of a case; print and draw them beside the averaged model."""
    from pyworm.batch.measured_pair import measured_pair, middle_contact, solve_contact
    from pyworm.scene.point import Scene
    from pyworm.solver.patch.rough_patch import rough_patch

    case = measured_pair(options.case, tables, run_in=False)
    scene = middle_contact(case, options.phase)
    if not isinstance(scene, Scene):
        raise CaseError("--resolved: the contact of the case is a line; give a point contact")
    with stage(f"moving the surfaces through {scene.name}"):
        try:
            patch = rough_patch(scene, [body.topography for body in scene.bodies], nodes=nodes)
        except ValueError as error:
            raise CaseError(f"--resolved: {error}") from error
        except RuntimeError as error:
            return end_with(f"--resolved: {error}", NOT_CONVERGED)
    with stage(f"solving {scene.name} with averaged surfaces"):
        averaged = solve_contact(case, scene)
    pictures: list[str] = []
    complete = True
    if options.out is not None:
        pictures, complete = drawn_pictures(
            options.out, lambda aside: _draw(scene.name, patch, aside)
        )
    if options.json:
        found = {"averaged": averaged.summary(), "resolved": patch.summary()}
        print_json({"case": case.name, "contacts": found, "pictures": pictures})
    else:
        _print(case.body_names, averaged, patch)
        for name in pictures:
            print_result(f"{options.out / name}")
    if not (averaged.converged and patch.converged):
        return NOT_CONVERGED
    return CONVERGED if complete else FAILED


def _print(names: Sequence[str], averaged: "Solution", patch: "RoughPatch") -> None:
    from pyworm.io.console import Console
    from pyworm.io.quantities import QUANTITIES
    from pyworm.report.table import Table

    found, rows = patch.summary(), []
    for key, name in ROWS.items():
        quantity = QUANTITIES[name]
        value = found[key] + (quantity.offset if key.endswith("_C") else 0.0)
        rows.append(
            (
                quantity.title((names[0], names[1])),
                averaged.figure_text(quantity),
                quantity.text(value),
            )
        )
    nodes = " x ".join(map(str, patch.grid.shape))
    head = "Contact between measured surfaces", "averaged", f"resolved, {nodes} nodes"
    Console().print(Table(head, tuple(rows)))
    if not patch.converged:
        print_message("resolved surfaces: some time steps did not converge")
    print_result(
        f"{len(patch.records)} time steps; of the resolved surfaces the central film thickness is that in "
        "the inner half, the asperity load ratio that below a nanometre"
    )


def _draw(name: str, patch: "RoughPatch", directory: Path) -> list[Path]:
    from pyworm.plots.attempts import Attempts
    from pyworm.plots.patch import draw_patch

    attempts = Attempts()
    attempts.draw(directory / "resolved_surfaces.png", lambda: draw_patch(name, patch))
    return attempts.result()
