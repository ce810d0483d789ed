"""pyworm new: write the case file of a worm drive from its drawing, or one of another kind to fill in."""

import argparse
import shutil
import sys
import tomllib
from pathlib import Path

from pyworm.case.case import case_of
from pyworm.case.new_worm import (
    ASKED,
    CASE_KEYS,
    OPTIONAL,
    answer_value,
    loaded_phases,
    new_worm_text,
)
from pyworm.case.shipped import KINDS, TEMPLATES
from pyworm.cli.shared import CONVERGED, warn_of_unusual
from pyworm.io.atomic import check_writable, whole_file
from pyworm.io.input_error import CaseError
from pyworm.io.present import present
from pyworm.io.terminal import print_message, print_result
from pyworm.io.toml import toml_text

WORM = "worm"
"""Kind whose file is made from the numbers of its drawing."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command to those of the program."""
    new = commands.add_parser("new", help="write the case file of a worm gear set from its drawing")
    new.add_argument("case", type=Path, metavar="CASE.toml", help="file to write")
    new.add_argument(
        "--kind",
        choices=(WORM, *KINDS),
        default=WORM,
        help="worm (default); other kinds: a file with example values to replace",
    )
    new.add_argument(
        "--from",
        dest="rexs",
        type=Path,
        metavar="FILE.rexs",
        help="take the worm drive of a REXS file; other options replace its values",
    )
    new.add_argument("--title", help="default: size of the gear unit")
    for key, (what, example) in (ASKED | OPTIONAL).items():
        asked = "prompted for if missing" if key in ASKED else "default: common practice"
        new.add_argument(
            f"--{key.replace('_', '-')}",
            metavar="VALUE",
            help=f'{what}, such as "{example}"; {asked}',
        )
    new.set_defaults(command=_new)


def _new(options: argparse.Namespace) -> int:
    path = options.case
    if path.exists():
        raise CaseError(f"{path}: already exists; choose another name, or remove it first")
    if path.suffix != ".toml":
        raise CaseError(f"{path}: must end in .toml")
    if options.kind != WORM:
        return _filled_in(path, options)
    if options.rexs is not None:
        return _from_rexs(path, options)
    answers = {key: getattr(options, key) for key in OPTIONAL if getattr(options, key) is not None}
    for key, (what, example) in ASKED.items():
        given = getattr(options, key)
        answers[key] = _asked(key, what, example) if given is None else given
    title = options.title or _title(answers)
    case = case_of(tomllib.loads(new_worm_text(answers, title)), path.stem, path.parent)
    check_writable(path.parent)
    drive = present(case.drive, "drive")
    phases = loaded_phases(drive.normal_load)
    text = new_worm_text(answers, title, getattr(drive, "assumed", ()), phases)
    with whole_file(path) as partial:
        partial.write_text(text, encoding="utf-8")
    warn_of_unusual(case)
    print_result(f"{path}: {title}. Next: pyworm check {path}")
    return CONVERGED


def _from_rexs(path: Path, options: argparse.Namespace) -> int:
    """Write the case of the worm drive in a REXS file."""
    from pyworm.case.from_rexs import rexs_content

    instead = {
        key: answer_value(name, getattr(options, name))
        for name, key in CASE_KEYS.items()
        if getattr(options, name) is not None
    }
    content, case = rexs_content(options.rexs, instead)
    if options.title is not None:
        content["title"] = options.title
    check_writable(path.parent)
    drive = present(case.drive, "drive")
    content["operation"] = {**content["operation"], "phases": [*loaded_phases(drive.normal_load)]}
    with whole_file(path) as partial:
        partial.write_text(toml_text(content), encoding="utf-8")
    warn_of_unusual(case)
    print_result(f"{path}: {content['title']}. Next: pyworm check {path}")
    return CONVERGED


def _filled_in(path: Path, options: argparse.Namespace) -> int:
    """Write the template of a kind; its values are replaced in the file, and no options."""
    names = {"rexs": "from"} | {key: key for key in ("title", *ASKED, *OPTIONAL)}
    given = [name for key, name in names.items() if getattr(options, key) is not None]
    if given:
        raise CaseError(
            f"--{given[0].replace('_', '-')} has no effect with --kind {options.kind}; replace the values "
            "in the file"
        )
    check_writable(path.parent)
    with whole_file(path) as partial:
        shutil.copyfile(TEMPLATES / f"{options.kind}.toml", partial)
    print_result(f"{path}: replace the example values. Next: pyworm check {path}")
    return CONVERGED


def _asked(key: str, what: str, example: str) -> str:
    """The answer to a question on the terminal."""
    print_message(f'{what}, such as "{example}"?')
    answer = sys.stdin.readline().strip().strip('"')
    if not answer:
        raise CaseError(f'--{key.replace("_", "-")} is missing ({what}, such as "{example}")')
    return answer


def _title(answers: dict[str, str]) -> str:
    """Title of a drive by its size."""
    return f"Worm drive, a = {answers['centre_distance']}, {answers['threads']}/{answers['teeth']}"
