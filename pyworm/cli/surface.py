"""pyworm surface: figures and curves of surfaces and profiles, and films between two surfaces."""

import argparse
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pyworm.cli.arguments import add_json
from pyworm.cli.shared import CONVERGED, FAILED, drawn_pictures, option_value
from pyworm.cli.surface_keys import add_keys, given_keys, keys_of
from pyworm.io.input_error import CaseError
from pyworm.io.json import print_json
from pyworm.io.stage import stage
from pyworm.io.terminal import print_result

if TYPE_CHECKING:
    from pyworm.surfaces.cell_table import CellTable
    from pyworm.surfaces.parameters import Texture
    from pyworm.surfaces.preparing import SeparatedWaves
    from pyworm.surfaces.profile import Profile

STEEL_ON_STEEL = 226e9
"""Reduced modulus E' of a surface that no case gives a body [Pa]."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    surface = commands.add_parser(
        "surface", help="parameters, contact and flow of a measured or generated surface"
    )
    surface.add_argument(
        "file",
        type=Path,
        metavar="FILE",
        help="measured heights (instrument format, .npy, .csv), .toml with keys of "
        "[bodies.NAME.surface], or case with such keys",
    )
    add_keys(surface)
    surface.add_argument(
        "--with",
        dest="other",
        type=Path,
        metavar="FILE",
        help="surface of the second body, that of the first being FILE; with --case",
    )
    surface.add_argument(
        "--case",
        type=Path,
        metavar="CASE.toml",
        help="solve a contact of a case whose bodies have these surfaces, as measured and run in",
    )
    surface.add_argument(
        "--phase", type=float, help="phase of the mesh of that contact (default: the middle one)"
    )
    surface.add_argument(
        "--resolved",
        type=int,
        nargs="?",
        const=513,
        metavar="NODES",
        help="move the surfaces through that contact node by node, compared with the averaged model",
    )
    surface.add_argument(
        "--modulus",
        help="reduced modulus E' for the contact, \"226 GPa\"; default: the case's, or steel",
    )
    surface.add_argument(
        "--hardness", help='maximum pressure, "1 GPa"; default: the case\'s, or none'
    )
    surface.add_argument(
        "--out", type=Path, metavar="DIR", help="solve contact and flow, draw pictures there"
    )
    add_json(surface)
    surface.set_defaults(command=_surface)


@dataclass(frozen=True)
class _Shown:
    """A surface to be shown: its name, waves and figures, and the body that it is on."""

    name: str
    waves: "SeparatedWaves"
    texture: "Texture"
    modulus: float
    hardness: float | None


def _surface(options: argparse.Namespace) -> int:
    from pyworm.io.atomic import check_writable
    from pyworm.surfaces.cell import periodic_cell
    from pyworm.surfaces.cell_table import cell_table
    from pyworm.surfaces.reading import IsProfileError
    from pyworm.surfaces.summary import curves, figures

    if options.out is not None:
        check_writable(options.out)
    if options.other is not None or options.case is not None or options.resolved is not None:
        from pyworm.cli.surface_film import film_between

        return film_between(options, given_keys(options))
    try:
        shown = _with_bodies(_surfaces(options), options)
    except IsProfileError as error:
        if options.file.suffix == ".toml":
            raise CaseError(f"{options.file}: {error}") from error
        return _show_profile(options, _profile(options))
    found = [{"name": surface.name, **figures(surface.waves, surface.texture)} for surface in shown]
    pictures: list[str] = []
    complete = True
    if options.out is not None:
        cells = [periodic_cell(surface.waves.roughness) for surface in shown]
        tables = []
        for surface, cell in zip(shown, cells, strict=True):
            with stage(f"solving contact and flow of {surface.name}"):
                tables.append(cell_table(cell, surface.modulus, surface.hardness))
        for entry, cell, table in zip(found, cells, tables, strict=True):
            entry["curves"] = curves(cell, table)
        pictures, complete = drawn_pictures(options.out, lambda aside: _draw(shown, tables, aside))
    if options.json:
        print_json({"surfaces": found, "pictures": pictures})
    else:
        _print(shown, found)
        for name in pictures:
            print_result(f"{options.out / name}")
    return CONVERGED if complete else FAILED


def _surfaces(options: argparse.Namespace) -> list[_Shown]:
    """The surfaces of a file: one, or those of a case's bodies."""
    from pyworm.io.toml import read_toml

    given, path = given_keys(options), options.file
    if path.suffix != ".toml":
        return [_shown(path.stem, keys_of(path, given), path)]
    if given:
        raise CaseError(f"--{next(iter(given)).replace('_', '-')}: {path} has keys for that")
    data = read_toml(path)
    if "bodies" not in data:
        return [_shown(path.stem, data, path)]
    return _of_case(path)


def _profile(options: argparse.Namespace) -> "Profile":
    """The profile in a file of one."""
    from pyworm.case.case import checked
    from pyworm.case.surface import SurfaceTable

    try:
        keys = keys_of(options.file, given_keys(options) | {"aspect": 1.0})
        table = checked(SurfaceTable, keys)
        table.lie_in(options.file.parent)
        return table.profiles()["across"][0]
    except ValueError as error:
        raise CaseError(f"{options.file}: {error}") from error


def _show_profile(options: argparse.Namespace, profile: "Profile") -> int:
    from pyworm.io.console import Console
    from pyworm.plots.attempts import Attempts
    from pyworm.plots.profile import draw_profile
    from pyworm.report.table import Table
    from pyworm.surfaces.profile_parameters import profile_figures
    from pyworm.surfaces.summary import profile_summary

    name, figures = options.file.stem, profile_figures(profile)
    known = {"name": name, **profile_summary(profile, figures)}
    pictures: list[str] = []
    complete = True
    if options.out is not None:

        def drawn(aside: Path) -> list[Path]:
            attempts = Attempts()
            attempts.draw(
                aside / f"{name}_profile.png", lambda: draw_profile(name, profile, figures)
            )
            return attempts.result()

        pictures, complete = drawn_pictures(options.out, drawn)
    if options.json:
        print_json({"profiles": [known], "pictures": pictures})
        return CONVERGED if complete else FAILED
    head = f"{name}\n{known['points']} points, {profile.length * 1e3:.4g} mm"
    rows = ((label, _cell(known, *rest)) for label, *rest in PROFILE_ROWS)
    Console().print(Table(("Profile", head), tuple(rows)))
    for picture in pictures:
        print_result(f"{options.out / picture}")
    return CONVERGED if complete else FAILED


def _shown(name: str, keys: dict[str, Any], path: Path) -> _Shown:
    """The surface of a table's keys, its files beside `path`."""
    from pyworm.case.case import checked
    from pyworm.case.surface import SurfaceTable, texture_of
    from pyworm.surfaces.reading import IsProfileError

    try:
        table = checked(SurfaceTable, keys)
        table.lie_in(path.parent)
        with stage(f"reading and filtering {path.name}"):
            waves = table.waves()
            texture = texture_of(waves.roughness)
    except IsProfileError:
        raise
    except ValueError as error:
        raise CaseError(f"{path}: {error}") from error
    return _Shown(name, waves, texture, STEEL_ON_STEEL, None)


def _of_case(path: Path) -> list[_Shown]:
    from pyworm.case.case import load
    from pyworm.case.surface import texture_of
    from pyworm.materials.body import reduced_modulus

    case = load(path)
    bodies = case.tables.bodies
    if not bodies.surfaces:
        raise CaseError(f"{path}: no body has a surface; give [bodies.NAME.surface]")
    pair = bodies.pair(case.tables.oil.oil())
    hardness = [body.hardness for body in pair if body.hardness is not None]
    return [
        _Shown(
            name,
            surface.waves(),
            texture_of(surface.waves().roughness),
            reduced_modulus(*pair),
            min(hardness) if hardness else None,
        )
        for name, surface in bodies.surfaces.items()
    ]


def _with_bodies(shown: list[_Shown], options: argparse.Namespace) -> list[_Shown]:
    """The surfaces on bodies whose modulus and hardness are those of the options, where given."""
    from pyworm.io.quantity import Kind

    instead: dict[str, Any] = {}
    for name, noun in (("modulus", "a reduced modulus"), ("hardness", "an indentation hardness")):
        if (text := getattr(options, name)) is not None:
            kind = Kind(noun, "Pa", "226 GPa", possible=("0.1 MPa", "1500 GPa"))
            instead[name] = option_value(name, text, kind)
    return [replace(surface, **instead) for surface in shown]


def _draw(shown: list[_Shown], tables: list["CellTable"], directory: Path) -> list[Path]:
    from functools import partial

    from pyworm.plots.attempts import Attempts
    from pyworm.plots.surface import draw_curves, draw_heights

    attempts = Attempts()
    for surface, table in zip(shown, tables, strict=True):
        heights = partial(draw_heights, surface.name, surface.waves.roughness, surface.texture)
        attempts.draw(directory / f"{surface.name}_heights.png", heights)
        known = partial(
            draw_curves, surface.name, table, surface.texture, surface.modulus, surface.hardness
        )
        attempts.draw(directory / f"{surface.name}_curves.png", known)
    return attempts.result()


MICRO, DEGREES = 1e6, 57.29577951308232
"""From metres to micrometres, from radians to degrees."""

ROWS = (
    ("Sq (Rq), root mean square height", "rq_m", MICRO, "µm"),
    ("Sa, arithmetic mean height", "ra_m", MICRO, "µm"),
    ("Sz, maximum height", "rz_m", MICRO, "µm"),
    ("Ssk, skewness", "skewness", 1, ""),
    ("Sku, kurtosis", "kurtosis", 1, ""),
    ("Sk, core height", "rk_m", MICRO, "µm"),
    ("Spk, reduced peak height", "rpk_m", MICRO, "µm"),
    ("Svk, reduced valley height", "rvk_m", MICRO, "µm"),
    ("Smrk1, Smrk2, ends of the core", ("mr1", "mr2"), 100, "%"),
    ("Sdq, root mean square slope", "slope", 1, ""),
    ("Slope along x and y", ("slope_x", "slope_y"), 1, ""),
    ("Correlation length across and along", ("length_across_m", "length_along_m"), MICRO, "µm"),
    ("Peklenik number", "aspect", 1, ""),
    ("Sal, Str", ("shortest_length_m", "texture_ratio"), (MICRO, 1), ("µm", "")),
    ("Lay, from the x axis", "lay_rad", DEGREES, "°"),
    ("Sq of longer waves", "long_waves_rq_m", MICRO, "µm"),
    ("Points filled", "filled_fraction", 100, "%"),
    ("Outliers among them", "outliers", 1, ""),
)
"""Row of the table of an area (ISO 25178-2), its keys, factors and units."""

PROFILE_ROWS = (
    ("Rq, root mean square height", "rq_m", MICRO, "µm"),
    ("Ra, arithmetic mean height", "ra_m", MICRO, "µm"),
    ("Rz, maximum height, mean of sections", "rz_m", MICRO, "µm"),
    ("Rp, Rv, peak height and pit depth", ("rp_m", "rv_m"), MICRO, "µm"),
    ("Rt, total height", "rt_m", MICRO, "µm"),
    ("Rsk, skewness", "skewness", 1, ""),
    ("Rku, kurtosis", "kurtosis", 1, ""),
    ("Rk, core height", "rk_m", MICRO, "µm"),
    ("Rpk, reduced peak height", "rpk_m", MICRO, "µm"),
    ("Rvk, reduced valley height", "rvk_m", MICRO, "µm"),
    ("Rmrk1, Rmrk2, ends of the core", ("mr1", "mr2"), 100, "%"),
    ("Rdq, root mean square slope", "slope", 1, ""),
    ("Rsm, mean width of elements", "width_m", MICRO, "µm"),
    ("Correlation length", "correlation_length_m", MICRO, "µm"),
    ("Section length", "section_m", 1e3, "mm"),
    ("Wq of longer waves", "long_waves_rq_m", MICRO, "µm"),
    ("Points filled", "filled_fraction", 100, "%"),
    ("Outliers among them", "outliers", 1, ""),
)
"""Row of the table of a profile (ISO 21920-2), its keys, factors and units."""


def _print(shown: list[_Shown], found: list[dict[str, Any]]) -> None:
    from pyworm.io.console import Console
    from pyworm.report.table import Table

    head = ["Surface"]
    for surface, known in zip(shown, found, strict=True):
        nx, ny = known["points"]
        sides = " x ".join(f"{side * 1e3:.4g}" for side in surface.waves.roughness.extent)
        head.append(f"{surface.name}\n{nx} x {ny}, {sides} mm")
    rows = (
        (name, *(_cell(known, keys, factors, units) for known in found))
        for name, keys, factors, units in ROWS
    )
    Console().print(Table(tuple(head), tuple(rows)))


def _cell(known: dict[str, Any], keys: Any, factors: Any, units: Any) -> str:
    """Values of a row in its units, with their uncertainty by the place where it is known."""
    if isinstance(keys, str):
        keys = (keys,)
    if not isinstance(factors, tuple):
        factors = (factors,) * len(keys)
    if not isinstance(units, tuple):
        units = ("",) * (len(keys) - 1) + (units,)
    scatter = known.get("uncertainty", {})
    parts = []
    for key, factor, unit in zip(keys, factors, units, strict=True):
        bar = f" ± {scatter[key] * factor:.2g}" if key in scatter else ""
        parts.append(f"{known[key] * factor:.3g}{bar} {unit}".strip())
    return ", ".join(parts)
