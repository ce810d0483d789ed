"""pyworm wear: the wear of the wheel of a worm gear set over its service life."""

import argparse
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.case.case import Case, load
from pyworm.cli.arguments import add_case, add_processes
from pyworm.cli.shared import CONVERGED, FAILED, batch_executor, end_with, planned_tasks
from pyworm.drives.duty import WormDuty
from pyworm.formulas.unknown import known
from pyworm.formulas.wear_law import (
    WEAR_COEFFICIENT,
    WEAR_SPREAD,
    WHEEL_HARDNESS,
    WORM_HARDNESS,
    energy_coefficient,
    harder_ratio,
)
from pyworm.io.atomic import check_writable, whole_file
from pyworm.io.input_error import CaseError
from pyworm.io.json import print_json
from pyworm.io.present import present
from pyworm.io.quantities import QUANTITIES
from pyworm.io.terminal import print_message, print_result

if TYPE_CHECKING:
    from pyworm.batch.wear_run import WearFigures, WearRun

ACCURACY = "10 %"
"""Accuracy of the contacts unless another is asked for: the wear coefficient is known to a factor of 3."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    wear = commands.add_parser("wear", help="wear of the worm wheel over its service life")
    add_case(wear)
    wear.add_argument(
        "--hours", type=float, required=True, metavar="H", help="operating hours to simulate"
    )
    how = wear.add_mutually_exclusive_group()
    how.add_argument(
        "--coefficient",
        type=float,
        metavar="K",
        help=f"k of Archard's law in m2/N (default: {WEAR_COEFFICIENT:g} for steel on tin bronze, known to a "
        "factor of 3; none for plastic wheels)",
    )
    how.add_argument(
        "--energy",
        type=float,
        metavar="E",
        help="friction energy per worn volume in J/m3, instead of k",
    )
    how.add_argument(
        "--calibrate",
        action="store_true",
        help="fit k to the wear rate of the run-in flank by the standard ([worm_rating])",
    )
    wear.add_argument(
        "--tolerance",
        type=float,
        default=0.25,
        metavar="UM",
        help="maximum error of the depth in a step in micrometres, in addition to 2 %% of the maximum depth "
        "(default: %(default)g)",
    )
    wear.add_argument(
        "--worm-ratio",
        type=float,
        metavar="R",
        help="k of the worm over that of the wheel (default: by their hardnesses)",
    )
    wear.add_argument("--out", type=Path, help="directory (default: results/ and the case's name)")
    add_processes(wear)
    wear.set_defaults(command=_wear, accuracy=ACCURACY, effects=None)


def _wear(options: argparse.Namespace) -> int:
    for name in ("hours", "coefficient", "energy", "tolerance", "worm_ratio"):
        value = getattr(options, name)
        if value is not None and not 0 < value < float("inf"):
            raise CaseError(f"--{name.replace('_', '-')} = {value:g}: must be above zero")
    case = load(options.case)
    directory = options.out or Path("results") / case.name / "wear"
    check_writable(directory)
    if case.drive is None or case.drive.rated_as is not WormDuty:
        raise CaseError(f"{options.case}: wear is simulated of worm drives only")
    tasks = planned_tasks(case, options)

    from pyworm.batch.case_run import NothingSolvedError
    from pyworm.batch.wear_run import STATE, WearPlan, WearRun, worm_duty

    found, by = _coefficient(options, case)
    ratio, on_worm = _worm_ratio(options, case)
    plan = WearPlan(options.hours, tolerance=options.tolerance * 1e-6, worm_ratio=ratio, **found)
    with batch_executor(options) as executor:
        try:
            run = WearRun(case, tasks, plan, directory, print_message, executor=executor)
            steps = run.run()
        except NothingSolvedError as error:
            return end_with(f"{case.name}: {error}", FAILED)
        except ValueError as error:
            raise CaseError(f"{options.case}: {error}") from None
    limit = worm_duty(case).gear.wear_limit
    allowed = steps[-1].hours >= plan.hours * (1 - 1e-9)
    assumed = (
        f"k = {run.coefficient:.3g} m2/N, {by}; roughness of both falls to {plan.run_in:g} of that as cut; "
        f"before the first and after the last phase of the case their contacts go on; {on_worm}"
    )
    if options.json:
        print_json(
            {
                "case": case.name,
                "steps": [asdict(step) for step in steps],
                "wear_limit_m": limit,
                "within_limit": allowed,
                "hours_allowed": run.hours_allowed,
                "coefficient_m2_N": run.coefficient,
                "worm_ratio": plan.worm_ratio,
                "assumed": assumed,
                "state": str(directory / STATE),
            }
        )
        return CONVERGED
    _show(steps)
    verdict = "within" if allowed else f"WORN OUT before {plan.hours:g} h"
    print_result(
        f"Allowed: {limit * 1e6:.4g} µm: {verdict}; at the last rate as deep after "
        f"{run.hours_allowed:.4g} h. {assumed}."
    )
    _draw(case, run, limit)
    return CONVERGED


def _draw(case: Case, run: "WearRun", limit: float) -> None:
    """The worm's wear in words, and the picture."""
    from pyworm.batch.wear_run import STATE
    from pyworm.plots.layout import DOTS_PER_INCH
    from pyworm.plots.wear import draw_wear

    last = run.steps[-1]
    deep = last.worm_depth_max_m
    print_result(
        f"Worm: {deep * 1e6:.3g} µm at most, {last.worm_mass_kg * 1e3:.3g} g: {run.plan.worm_ratio:.2g} of "
        f"the wheel's volume, {deep / last.depth_max_m:.2g} of its depth."
    )
    picture = run.directory / "wear.png"
    with whole_file(picture) as partial:
        draw_wear(case.name, run, limit).savefig(partial, format="png", dpi=DOTS_PER_INCH)
    print_result(f"Maps: {run.directory / STATE}, picture: {picture}")


def _coefficient(options: argparse.Namespace, case: Case) -> tuple[dict[str, float], str]:
    """What a plan takes for the wear coefficient, and where it comes from."""
    if options.energy is not None:
        friction = present(case.drive, "drive").oil.boundary_friction
        by = f"{friction:g}/{options.energy:g} J/m3 by the energy form"
        return {"coefficient": energy_coefficient(options.energy, friction)}, by
    if options.coefficient is not None:
        return {"coefficient": options.coefficient}, "as given"
    if not options.calibrate:
        if present(case.drive, "drive").bodies[1].temperature_limit is not None:
            raise CaseError(
                "--coefficient is missing: none is known of wheels with a temperature limit, such as plastics"
            )
        return {"coefficient": WEAR_COEFFICIENT}, f"known to a factor of {WEAR_SPREAD:g}"
    from pyworm.ratings.worm_loads import RatedWormGear

    if getattr(case.tables, "worm_rating", None) is None:
        raise CaseError("--calibrate: needs [worm_rating] with wheel_material and life")
    duty = case.tables.duty(case.drive)
    loads = RatedWormGear(case.tables.rating_as_run(), duty, case.directory).loads
    if len(loads) != 1:
        raise CaseError("--calibrate: needs [worm_rating] with one life, and it gives a spectrum")
    (load,) = loads
    try:
        rate = load.rated.wear.depth / known(load.hours)
    except ValueError as error:
        raise CaseError(f"--calibrate: the standard has no wear of this gear: {error}") from error
    return {"calibrated_to": rate}, (
        f"by which the run-in flank wears {rate * 1e9:.3g} nm/h in the mean, as by the standard"
    )


def _worm_ratio(options: argparse.Namespace, case: Case) -> tuple[float, str]:
    """k of the worm over that of the wheel, and what it rests on."""
    if options.worm_ratio is not None:
        return (
            options.worm_ratio,
            f"the worm's k is {options.worm_ratio:g} of the wheel's, as given",
        )
    usual = WORM_HARDNESS, WHEEL_HARDNESS
    bodies = present(case.drive, "drive").bodies
    worm, wheel = (body.hardness or hardness for body, hardness in zip(bodies, usual, strict=True))
    ratio, linear = (harder_ratio(max(worm, wheel), wheel, power) for power in (2.0, 1.0))
    return ratio, (
        f"the worm's k is {ratio:.2g} of the wheel's, the square of their hardnesses {wheel * 1e-9:.3g} and "
        f"{worm * 1e-9:.3g} GPa (Rabinowicz; {linear:.2g} by hardness alone)"
    )


def _show(steps: "Sequence[WearFigures]") -> None:
    from pyworm.io.console import Console
    from pyworm.report.table import Table

    friction, film = QUANTITIES["friction_coefficient"], QUANTITIES["film_min"]
    rows = (
        (
            f"{step.hours:.4g}",
            f"{step.depth_max_m * 1e6:.3g}",
            f"{step.depth_mean_m * 1e6:.3g}",
            f"{step.mass_kg * 1e6:.3g}",
            f"{step.backlash_m * 1e6:.2f}",
            f"{step.pattern_m2 * 1e6:.1f}",
            f"{step.asperity_share * 100:.1f}",
            f"{step.friction:.4f}",
            f"{film.number(step.film_min_m):.3g}",
            f"{step.wheel_roughness_m * 1e6:.3g}",
        )
        for step in steps
    )
    carried = QUANTITIES["asperity_load_fraction"].column
    depths = "Max.\ndepth\nµm", "Mean\ndepth\nµm"
    worn = "Mass\nmg", "Backlash\nµm", "Pattern\nmm²"
    head = ("Time\nh", *depths, *worn, carried, friction.column, film.column, "Rq\nµm")
    Console().print(Table(head, tuple(rows), "Wear of the wheel", narrow=True))
