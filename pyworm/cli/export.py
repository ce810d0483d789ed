"""pyworm export: worm, wheel and hob as solids, and results on the wheel's flank for ParaView."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.case.case import Case, load
from pyworm.cli.arguments import add_anyway
from pyworm.cli.shared import CONVERGED, opened_result
from pyworm.io.atomic import atomic_directory, check_writable
from pyworm.io.input_error import CaseError
from pyworm.io.stage import stage
from pyworm.io.terminal import print_message, print_result
from pyworm.io.vtk import write_surface

if TYPE_CHECKING:
    import numpy as np

    from pyworm.io.solid import Solid
    from pyworm.result.flank_surface import WornFlank
    from pyworm.result.result import Result

FORMATS = "step", "stl", "glb"
"""Formats of solids."""

FLANK_FINER = 4
"""Steps of the flank with results for each step of its net."""

FLANK = "flank.vts"

Fields = dict[str, "np.ndarray"]
"""Fields at points of the flank, by their names."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    export = commands.add_parser(
        "export", help="worm, wheel and hob as STEP, STL and GLB, results on the flank as VTK"
    )
    export.add_argument("case", type=Path, metavar="CASE.toml")
    export.add_argument(
        "--out", type=Path, help="directory (default: results/ and the case's name)"
    )
    export.add_argument(
        "--formats",
        default=",".join(FORMATS),
        metavar="NAMES",
        help="comma-separated formats of the solids (default: %(default)s)",
    )
    export.add_argument(
        "--result",
        type=Path,
        metavar="RESULT",
        help=f"write pressure, film and temperatures of this result on the wheel's flank to {FLANK}",
    )
    export.add_argument(
        "--wear",
        type=Path,
        metavar="wear.npz",
        help=f"write the wear depth of the flank that pyworm wear has stored to {FLANK}",
    )
    add_anyway(export)
    export.set_defaults(command=_export)


def _export(options: argparse.Namespace) -> int:
    formats = _formats(options.formats)
    case = load(options.case)
    directory = options.out or Path("results") / case.name / "solids"
    check_writable(directory)
    result, worn = _results(options, case)
    try:
        with stage("making the solids"):
            solids = None if case.drive is None else case.drive.solids()
    except ValueError as error:
        raise CaseError(f"{options.case}: {error}") from None
    if solids is None:
        raise CaseError(f"{options.case}: solids are made of worm gear sets only")
    points = solids["wheel"].flank_points(FLANK_FINER)
    fields = _fields(options, points, result, worn)
    with stage("writing the solids"), atomic_directory(directory) as aside:
        _write(aside, solids, formats)
        if fields:
            write_surface(aside / FLANK, points, fields, next(iter(fields)))
        sizes = {path.name: path.stat().st_size for path in sorted(aside.iterdir())}
    for name, size in sizes.items():
        print_result(f"{directory / name}  {size * 1e-6:.1f} MB")
    return CONVERGED


def _formats(text: str) -> tuple[str, ...]:
    """Formats asked for; CaseError of others, and of STEP without a CAD kernel."""
    formats = tuple(name.strip() for name in text.split(","))
    unknown = [name for name in formats if name not in FORMATS]
    if unknown:
        raise CaseError(f"--formats {text}: {unknown[0]} is none of {', '.join(FORMATS)}")
    if "step" in formats:
        from pyworm.io.step import require_kernel

        try:
            require_kernel()
        except ValueError as error:
            raise CaseError(f"--formats {text}: {error}") from None
    return formats


def _results(options: argparse.Namespace, case: Case) -> "tuple[Result | None, WornFlank | None]":
    """The result and the worn flank whose fields are wanted; CaseError of wrong files."""
    from pyworm.result.flank_surface import worn_flank
    from pyworm.result.result_case import as_solved_in

    result, worn = None, None
    if options.result is not None:
        result = opened_result(options.result)
        advice = "; solve it again, or take it with --anyway"
        _, differ = as_solved_in(case, options.case, result, options.anyway, advice)
        if differ is not None:
            print_message(f"warning: {differ}")
    if options.wear is not None:
        try:
            worn = worn_flank(options.wear)
        except FileNotFoundError:
            raise CaseError(f"{options.wear}: no such file") from None
        except ValueError as error:
            raise CaseError(f"{error}") from None
    return result, worn


def _fields(
    options: argparse.Namespace,
    points: "np.ndarray",
    result: "Result | None",
    worn: "WornFlank | None",
) -> Fields:
    """Fields of results at points of the wheel's flank, by their names; CaseError of too few phases."""
    from pyworm.result.flank_surface import on_flank
    from pyworm.result.result import readable

    fields: Fields = {}
    if result is not None:
        with readable(options.result):
            found = on_flank(points, result)
        if found is None:
            raise CaseError(
                f"{options.result}: has too few converged phases for fields on the flank"
            )
        fields |= found
    return fields if worn is None else {**fields, "wear_depth": worn.depth_at(points)}


def _write(directory: Path, solids: "dict[str, Solid]", formats: tuple[str, ...]) -> None:
    """Write solids in some formats."""
    from pyworm.io.mesh_files import write_glb, write_stl
    from pyworm.io.step import write_step
    from pyworm.io.triangles import triangles

    if {"stl", "glb"} & {*formats}:
        meshes = {name: triangles(solid) for name, solid in solids.items()}
        if "stl" in formats:
            for name, mesh in meshes.items():
                write_stl(directory / f"{name}.stl", name, mesh)
        if "glb" in formats:
            pair = {name: meshes[name] for name in ("worm", "wheel")}
            write_glb(directory / "pair.glb", pair)
    if "step" in formats:
        for name, solid in solids.items():
            write_step(directory / f"{name}.step", solid)
