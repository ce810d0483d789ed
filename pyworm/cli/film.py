"""pyworm film: films of contacts by the formula of the atlas, without a solve."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pyworm.cli.arguments import add_json, add_places
from pyworm.cli.shared import CONVERGED, wanted_places, warn_of_unusual
from pyworm.io.input_error import CaseError
from pyworm.io.json import print_json
from pyworm.io.quantities import QUANTITIES, Quantity
from pyworm.io.stage import stage

if TYPE_CHECKING:
    from pyworm.scene.line import LineScene
    from pyworm.scene.point import Scene

STEEL = "16MnCr5"
"""Material of the bodies of a contact given by options, if they name none."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    film = commands.add_parser(
        "film", help="film thickness by a regression formula, without a solve"
    )
    film.add_argument("case", nargs="?", type=Path, metavar="CASE.toml")
    add_places(film)
    film.add_argument(
        "--radii", nargs=2, metavar="R", help='radii of relative curvature, "10 mm" "100 mm"'
    )
    film.add_argument("--load", help='normal load, "200 N"')
    film.add_argument(
        "--velocity",
        nargs="+",
        metavar="U",
        help='entrainment velocity along x (and y), "2 m/s" "0 m/s"',
    )
    film.add_argument("--oil", help='oil of the library, "PAG VG 460"; with --temperature')
    film.add_argument("--temperature", help='inlet temperature, "60 degC"')
    film.add_argument(
        "--bodies",
        nargs=2,
        metavar="MATERIAL",
        default=(STEEL, STEEL),
        help=f"materials of body 1 and 2 (default: {STEEL})",
    )
    add_json(film)
    film.set_defaults(command=_film)


def _film(options: argparse.Namespace) -> int:
    if options.case is None:
        name, warnings = "contact", []
        scenes: list[Scene | LineScene] = [_of_options(options)]
    else:
        from pyworm.case.case import load

        case = load(options.case)
        warn_of_unusual(case)
        places = wanted_places(case, options)
        name, warnings = case.name, list(case.warnings)
        with stage(f"making {len(places)} contacts"):
            scenes = [case.scene(**place.given) for place in places]
    try:
        with stage(f"evaluating films of {len(scenes)} contacts"):
            rows = [_summary(scene) for scene in scenes]
    except ValueError as error:
        raise CaseError(str(error)) from error
    if options.json:
        print_json({"case": name, "scenes": rows, "warnings": warnings})
    else:
        _show(rows)
    return CONVERGED


def _of_options(options: argparse.Namespace) -> "Scene":
    """The contact that options describe, in pure rolling."""
    missing = [
        f"--{name}"
        for name in ("radii", "load", "velocity", "oil", "temperature")
        if getattr(options, name) is None
    ]
    if missing:
        raise CaseError(f"give a case file, or {', '.join(missing)} too")
    from pyworm.io import units
    from pyworm.io.given import kind_of
    from pyworm.io.quantity import parse
    from pyworm.materials.body import Body
    from pyworm.materials.library import named_oil
    from pyworm.scene.point import Paraboloid, RigidMotion, Scene

    def read(name: str, text: str, kind: Any) -> float:
        try:
            return parse(text, kind_of(kind))
        except ValueError as error:
            raise CaseError(f'--{name} "{text}" {error}') from error

    try:
        velocity = [read("velocity", text, units.Velocity) for text in options.velocity]
        motion = RigidMotion(*[*velocity, 0.0][:2])
        temperature = read("temperature", options.temperature, units.Temperature)
        first, second = (Body.from_name(body, None, temperature) for body in options.bodies)
        return Scene(
            name="contact",
            gap=Paraboloid(*(read("radii", text, units.Radius) for text in options.radii)),
            motions=(motion, motion),
            load=read("load", options.load, units.Force),
            bodies=(first, second),
            oil=named_oil(options.oil).oil(temperature),
        )
    except ValueError as error:
        raise CaseError(str(error)) from error


JUDGED_AT = 0.02
"""Influence from which effects that the formula leaves out are told [-]."""


def _summary(scene: "Scene | LineScene") -> dict[str, Any]:
    from pyworm.planning.plan import plan_of
    from pyworm.result.formula_summary import formula_summary
    from pyworm.scene.formula_film import film_of
    from pyworm.scene.line import LineScene

    plan = plan_of(scene, JUDGED_AT, ("isothermal", "-real-gap"), ("film",))
    films = None if isinstance(scene, LineScene) else film_of(scene, reduced=True)
    holds = () if films is None else films.holds
    found = formula_summary(scene, plan, films)
    neglected = {name: value for name, value in found["left_out"].items() if name not in holds}
    return {**found, "holds": list(holds), "left_out": neglected}


def _show(rows: list[dict[str, Any]]) -> None:
    """Print films as a table, and what they leave out."""
    from pyworm.io.console import Console
    from pyworm.report.table import Table

    central, thin, ratio = (
        QUANTITIES[name] for name in ("film_central", "film_min", "specific_film")
    )
    cells = tuple(
        (
            row["name"],
            _with_bar(central, row),
            _with_bar(thin, row),
            f"{row[ratio.key]:.2g}" if ratio.key in row else "",
            row["regime"],
        )
        for row in rows
    )
    console = Console()
    if neglected := _neglected(rows):  # before films that it may change by their own size
        console.print(neglected)
    console.print(Table(("Contact", central.column, thin.column, ratio.column, "Regime"), cells))
    if any(row["kind"] == "line" for row in rows):
        console.print("Line contacts by the formula of Moes, without uncertainty.")
    if any(row["kind"] == "point" and not row["inside_atlas"] for row in rows):
        console.print("Film thicknesses without an uncertainty lie outside the range of the atlas.")
    held = sum(bool(row["holds"]) for row in rows)
    if held:
        whose = "" if held == len(rows) else f", in {held} of {len(rows)} contacts"
        console.print(f"Reduced by heat and shear thinning{whose}.")


def _neglected(rows: list[dict[str, Any]]) -> str:
    """What the formulas leave out, and what it changes at most in any contact; empty if that is nothing."""
    from pyworm.report.console.scenes import influence_percent

    largest: dict[str, float] = {}
    for row in rows:
        for effect, share in row["left_out"].items():
            largest[effect] = max(share, largest.get(effect, 0.0))
    listed = ", ".join(f"{effect} {influence_percent(share)}" for effect, share in largest.items())
    return listed and f"Neglected, and what each may change at most: {listed}."


def _with_bar(film: Quantity, row: dict[str, Any]) -> str:
    """A film thickness in the unit of its column with its bar, where one is known."""
    error = row[film.error_key]
    known = f" ± {100 * error:.2g} %" if error < 1 else ""
    return f"{film.digits(film.by_key(row[film.key]))}{known}"
