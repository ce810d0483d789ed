"""pyworm rexs: write a worm drive, and its solved contacts, as a REXS file."""

import argparse
from datetime import UTC, datetime
from pathlib import Path

import pyworm
from pyworm.case.case import Case, case_again, load
from pyworm.cli.shared import CONVERGED, opened_result
from pyworm.io.atomic import check_writable
from pyworm.io.input_error import CaseError
from pyworm.io.rexs import Model, write_rexs
from pyworm.io.terminal import print_message, print_result


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    rexs = commands.add_parser(
        "rexs", help="write a worm drive, and its solved contacts, as a REXS 2.0 file"
    )
    rexs.add_argument(
        "source", type=Path, metavar="CASE.toml|RESULT.nc", help="case or results file"
    )
    rexs.add_argument(
        "--out", type=Path, metavar="FILE.rexs", help="default: next to the source, named after it"
    )
    rexs.set_defaults(command=_rexs)


def _rexs(options: argparse.Namespace) -> int:
    path = options.out or options.source.with_suffix(".rexs")
    if path.suffix != ".rexs":
        raise CaseError(f"--out {path}: must end in .rexs")
    check_writable(path.parent)
    case, model = _model(options.source)
    for words in _unwritten(case):
        print_message(f"warning: REXS has no attributes for the {words}; not written")
    path.parent.mkdir(parents=True, exist_ok=True)
    write_rexs(model, path, pyworm.__version__, datetime.now(UTC).isoformat(timespec="seconds"))
    print_result(f"{path}: REXS 2.0, {len(model.components)} components")
    return CONVERGED


def _unwritten(case: Case) -> tuple[str, ...]:
    from pyworm.case.to_rexs import unwritten_in_rexs

    return unwritten_in_rexs(case)


def _model(source: Path) -> tuple[Case, Model]:
    """The case of a case file or a result, and its model."""
    if source.suffix == ".toml":
        from pyworm.case.to_rexs import rexs_model

        case = load(source)
        return case, rexs_model(case)
    from pyworm.result.rexs import rexs_of_result

    result = opened_result(source)
    return case_again(result.case), rexs_of_result(result)
