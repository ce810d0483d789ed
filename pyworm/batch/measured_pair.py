"""A contact of a case between measured surfaces, as measured and after running in."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from pyworm.case.case import Case, case_of
from pyworm.formulas.wear_law import RUN_IN
from pyworm.io.input_error import CaseError
from pyworm.io.toml import read_toml
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.solution import Solution
from pyworm.solver.solve import solve

OF_ROUGHNESS = (
    "finish", "roughness", "roughness_ra", "roughness_rz", "roughness_slope", "roughness_aspect", "lay",
    "asperity_sharpness", "asperity_density",
)  # fmt: skip
"""Keys of a body that a surface replaces."""


def measured_pair(path: Path, surfaces: Sequence[Mapping[str, Any]], run_in: bool) -> Case:
    """A case file whose first body, or first and second, have surfaces by keys of `[bodies.NAME.surface]`.

    Run in, the summits of the last of these surfaces, that of the softer wheel of a worm gear set, are worn
    off until its Rq is `wear_law.RUN_IN` of what it was. CaseError for keys or a case that make no contact.
    """
    content = read_toml(path)
    bodies = content.get("bodies", {})
    names = list(bodies)
    if len(names) < len(surfaces):
        raise CaseError(f"{path}: has {len(names)} bodies, {len(surfaces)} surfaces were given")
    chosen = dict(zip(names[: len(surfaces)], surfaces, strict=True))
    for name, keys in chosen.items():
        kept = {key: value for key, value in bodies[name].items() if key not in OF_ROUGHNESS}
        worn = {"run_in": RUN_IN} if run_in and name == names[len(surfaces) - 1] else {}
        bodies[name] = kept | {"surface": dict(keys) | worn}
    return case_of(content, path.stem, path.parent)


def middle_contact(case: Case, phase: float | None) -> Scene | LineScene:
    """The contact of a case at a phase, or at the middle one of its places; CaseError where there is none."""
    if phase is not None:
        return case.scene(phase=phase)
    places = case.places()
    return case.scene(**places[len(places) // 2].given)


def solve_contact(case: Case, scene: Scene | LineScene) -> Solution:
    """The film of a contact to its case's accuracy; KernelError as of `solve`."""
    return solve(scene, accuracy=case.accuracy, effects=case.effects)
