"""pyworm table: losses of a worm drive over speed, torque and temperature, for simulators of drive trains."""

import argparse
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pyworm.case.case import Case, load
from pyworm.cli.arguments import add_accuracy_and_effects, add_json, add_processes
from pyworm.cli.shared import (
    CONVERGED,
    NOT_CONVERGED,
    batch_executor,
    end_with,
    option_value,
    warn_of_unusual,
)
from pyworm.io import units
from pyworm.io.atomic import atomic_directory, check_writable
from pyworm.io.given import kind_of
from pyworm.io.input_error import CaseError
from pyworm.io.json import print_json
from pyworm.io.present import present
from pyworm.io.quantity import SHARE_KIND
from pyworm.io.quantity_text import percent
from pyworm.io.terminal import print_message, print_result

if TYPE_CHECKING:
    from pyworm.batch.loss_table import Checked, Grid
    from pyworm.result.loss_table import LossTable

TABLE_NAME = "loss_table.csv"

AXES = (
    ("speeds", units.Speed, "speeds of the worm", '"100 rpm" "1500 rpm"'),
    ("torques", units.Torque, "torques of the wheel", '"50 N m" "300 N m"'),
    ("temperatures", units.Temperature, "oil temperatures", '"40 degC" "80 degC"'),
)
"""Option, kind of its values, what they are, and an example."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    table = commands.add_parser(
        "table",
        help="losses of a worm gear set over speed, torque, temperature, for other simulators",
    )
    table.add_argument("case", type=Path, metavar="CASE.toml")
    for name, _, what, example in AXES:
        table.add_argument(
            f"--{name}",
            nargs="+",
            metavar="VALUE",
            help=f"{what}, such as {example}; default: the case's",
        )
    table.add_argument(
        "--points", type=int, metavar="N", help="points that are solved (default: 16)"
    )
    table.add_argument(
        "--check", type=int, default=0, metavar="N", help="solve N further points to compare"
    )
    table.add_argument(
        "--phase", type=float, nargs="+", metavar="PHASE", help="mesh phases; default: the case's"
    )
    add_accuracy_and_effects(table)
    table.add_argument("--out", type=Path, help="directory (default: results/ and CASE_table)")
    add_json(table)
    add_processes(table)
    table.set_defaults(command=_table)


def _table(options: argparse.Namespace) -> int:
    from pyworm.batch.loss_table import POINTS, loss_table, table_mesh
    from pyworm.batch.operating_points import NotSolvedError, Solving
    from pyworm.io.console import progress_bar

    case = load(options.case)
    mesh = table_mesh(case, options.temperatures is not None)
    inlet = present(present(case.drive, "drive").oil.heat, "oil.heat").inlet_temperature
    grid = _grid(options, (mesh.speed, mesh.torque, inlet))
    directory = options.out or Path("results") / f"{case.name}_table"
    check_writable(directory)
    warn_of_unusual(case)
    accuracy = case.accuracy
    if options.accuracy is not None:
        accuracy = option_value("accuracy", options.accuracy, SHARE_KIND)
    for name in ("points", "check"):
        if (count := getattr(options, name)) is not None and not 0 <= count <= 1000:
            raise CaseError(f"--{name} {count}: must be between 0 and 1000")
    points = POINTS if options.points is None else max(options.points, 1)
    try:
        with progress_bar() as progress, batch_executor(options) as executor:
            how = options.effects or case.effects, executor, progress
            solving = Solving(directory, accuracy, *how)
            table, checked = loss_table(case, grid, solving, points, options.phase, options.check)
    except NotSolvedError as error:
        return end_with(f"{case.name}: {error}; the others are kept in {directory}", NOT_CONVERGED)
    files = _write(table, directory)
    _show(case, table, checked, files, options)
    if checked.within < len(checked.deviations):
        return end_with(f"{case.name}: {_check_sentence(checked)}", NOT_CONVERGED)
    return CONVERGED


def _grid(options: argparse.Namespace, defaults: tuple[float, float, float]) -> "Grid":
    """The values of the table, rising; those of the case, the defaults, where no option gives them."""
    from pyworm.batch.loss_table import Grid

    found = []
    for (name, kind, _, _), value in zip(AXES, defaults, strict=True):
        texts = getattr(options, name)
        values = (
            [value]
            if texts is None
            else [option_value(name, text, kind_of(kind)) for text in texts]
        )
        if any(after <= before for before, after in pairwise(values)):
            raise CaseError(f"--{name} {' '.join(texts)}: must rise")
        found.append(tuple(values))
    return Grid(*found)


def _write(table: "LossTable", directory: Path) -> dict[str, Path]:
    """Write all files of a table; what they are -> file."""
    from pyworm.report.fmu import identifier, write_fmu
    from pyworm.report.simulators import modelica, mujoco, urdf

    name = identifier(table.name)
    texts = {
        "table": (TABLE_NAME, table.as_csv()),
        "modelica": (f"{name}.mo", modelica(table)),
        "mujoco": (f"{name}_mujoco.xml", mujoco(table)),
        "urdf": (f"{name}.urdf", urdf(table)),
    }
    with atomic_directory(directory) as aside:
        for file, text in texts.values():
            (aside / file).write_text(text, encoding="utf-8")
        reason = write_fmu(table, aside / f"{name}.fmu")
    if reason is not None:
        print_message(f"warning: {name}.fmu has its C source only: {reason}")
    files = {kind: file for kind, (file, _) in texts.items()} | {"fmu": f"{name}.fmu"}
    return {kind: directory / file for kind, file in files.items()}


def _show(
    case: Case,
    table: "LossTable",
    checked: "Checked",
    files: dict[str, Path],
    options: argparse.Namespace,
) -> None:
    """Show the errors of a table and its files."""
    if options.json:
        found: dict[str, Any] = {
            "case": case.name,
            "points": list(table.rows()),
            "emulation_error": table.emulation_error,
            "solution_error": table.solution_error,
            "check": checked.summary(),
            **{kind: str(file) for kind, file in files.items()},
        }
        print_json(found)
        return
    print_result(
        f"{int(table.solved.sum())} of {table.solved.size} points solved, their losses within "
        f"{percent(table.solution_error)}; losses between them within {percent(table.emulation_error)}"
    )
    low, high = table.efficiency.min(), table.efficiency.max()
    print_result(f"Efficiency {percent(low, 3)} to {percent(high, 3)}, worm driving")
    locked = int(table.locked.sum())
    print_result(
        f"Locked     {locked} of {table.solved.size} points: the wheel cannot drive the worm"
    )
    if checked.deviations:
        print_result(f"Checked    {_check_sentence(checked)}")
    for kind, file in files.items():
        print_result(f"{kind.capitalize():<10} {file}")


def _check_sentence(checked: "Checked") -> str:
    deviation = max(map(abs, checked.deviations))
    return (
        f"{checked.within} of {len(checked.deviations)} further points within the error of "
        f"{percent(checked.error)}; largest deviation {percent(deviation)}"
    )
