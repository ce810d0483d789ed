"""Arguments that several commands take."""

import argparse
from pathlib import Path


def add_json(command: argparse.ArgumentParser) -> None:
    """Option that prints JSON in place of tables."""
    command.add_argument("--json", action="store_true", help="one JSON object on standard output")


def add_case(command: argparse.ArgumentParser) -> None:
    """The case of a command, and which of its contacts and quantities are meant; JSON."""
    command.add_argument("case", type=Path, metavar="CASE.toml")
    command.add_argument(
        "--quantities",
        type=_names,
        help="film,friction,temperature; default: the case's, or all that the oil data allow",
    )
    add_places(command)
    add_json(command)


def add_places(command: argparse.ArgumentParser) -> None:
    """Which of a case's contacts are meant."""
    for name, kind, metavar, places in (
        ("--section", str, "NAME", "sections of a roller worm"),
        ("--station", float, "PLACE", "positions along contact lines, 0 to 1,"),
        ("--phase", float, "PHASE", "mesh phases, 0 to 1,"),
        ("--slide-roll-ratio", float, "RATIO", "slide-roll ratios of a traction curve"),
    ):
        words = f"{places} to solve; default: the case's"
        command.add_argument(name, type=kind, nargs="+", metavar=metavar, help=words)


def add_accuracy_and_effects(command: argparse.ArgumentParser) -> None:
    """Options of how the contacts of a case are solved."""
    command.add_argument(
        "--accuracy", help='requested relative accuracy, such as "1%%"; default: the case\'s'
    )
    command.add_argument(
        "--effects",
        type=_names,
        help="auto, auto,-roughness,-squeeze, all, isothermal, or comma-separated effects; default: "
        "the case's",
    )


def add_processes(command: argparse.ArgumentParser) -> None:
    """Options of who solves the scenes of a batch."""
    who = command.add_mutually_exclusive_group()
    who.add_argument(
        "-j",
        dest="jobs",
        type=_process_count,
        default=1,
        metavar="N",
        help="worker processes (default: 1)",
    )
    who.add_argument(
        "--scheduler",
        metavar="ADDRESS",
        help="solve on the workers of this dask.distributed scheduler",
    )


def add_compared_case(command: argparse.ArgumentParser) -> None:
    """Options of a command on a result: the case to compare it with."""
    command.add_argument(
        "--case",
        type=Path,
        metavar="CASE.toml",
        help="check the result against this case",
    )
    add_anyway(command)


def add_anyway(command: argparse.ArgumentParser) -> None:
    """Option that accepts a result of a case that has changed."""
    command.add_argument(
        "--anyway", action="store_true", help="accept the result even if the case has changed since"
    )


def _names(text: str) -> tuple[str, ...]:
    """Names between commas."""
    return tuple(name.strip() for name in text.split(","))


def _process_count(text: str) -> int:
    if not text.isdecimal() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text}: must be a whole number from 1 on")
    return int(text)
