"""pyworm example: list the case files that come with pyworm, or write one of them."""

import argparse
import shutil
from pathlib import Path

from pyworm.case.shipped import example, examples, first_command
from pyworm.cli.shared import CONVERGED
from pyworm.io.atomic import check_writable, whole_file
from pyworm.io.input_error import CaseError
from pyworm.io.terminal import print_result


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command `example`."""
    command = commands.add_parser("example", help="list tested case files, or write one of them")
    command.add_argument("name", nargs="?", metavar="NAME", help="case to write; default: list all")
    command.add_argument(
        "--out", type=Path, default=Path(), help="directory (default: the current one)"
    )
    command.set_defaults(command=_example)


def _example(options: argparse.Namespace) -> int:
    if options.name is None:
        _list()
        return CONVERGED
    files = example(options.name)
    for file in files:
        if (path := options.out / file.name).exists():
            raise CaseError(f"{path}: already exists; choose another directory, or remove it first")
    check_writable(options.out)
    options.out.mkdir(parents=True, exist_ok=True)
    for file in files:
        with whole_file(options.out / file.name) as partial:
            shutil.copyfile(file, partial)
    path = options.out / files[0].name
    print_result(f"{path}. Next: pyworm {first_command(files[0])} {path}")
    return CONVERGED


def _list() -> None:
    """The names and titles of all examples."""
    from pyworm.io.console import Console
    from pyworm.report.table import Table

    Console().print(Table(("Example", ""), tuple(examples().items()), texts=(0, 1)))
