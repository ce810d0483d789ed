"""Case files that come with pyworm: tested examples, and templates to fill in."""

import re
import tomllib
from pathlib import Path

from pyworm.io.input_error import CaseError

PACKAGE = Path(__file__).parents[1]

TEMPLATES = PACKAGE / "case/templates"
"""Files for `pyworm new`, by the kind of contact or gears."""

KINDS = tuple(sorted(path.stem for path in TEMPLATES.glob("*.toml")))
"""Kinds of contacts and gears that have a template."""


def examples() -> dict[str, str]:
    """Names of the tested cases -> their titles."""
    return {path.stem: _title(path) for path in sorted(_folder().glob("*.toml"))}


def example(name: str) -> tuple[Path, ...]:
    """A tested case, and the files that it names.

    CaseError with the names that there are if there is none so called.
    """
    path = _folder() / f"{name}.toml"
    if not path.is_file():
        raise CaseError(f"{name}: no such example; choose one of {', '.join(examples())}")
    named = re.findall(r'^file = "([^"]+)"', path.read_text(encoding="utf-8"), re.MULTILINE)
    return path, *(path.parent / file for file in named)


def first_command(path: Path) -> str:
    """Command by which a case is looked at first: `rate` where it has ratings alone, `check` otherwise."""
    tables = tomllib.loads(path.read_text(encoding="utf-8"))
    return "check" if {"drive", "contact"} & tables.keys() else "rate"


def _folder() -> Path:
    """Folder of the tested cases: in the installed package, or next to it in the repository."""
    installed = PACKAGE / "cases"
    return installed if installed.is_dir() else PACKAGE.parent / "cases"


def _title(path: Path) -> str:
    title: str = tomllib.loads(path.read_text(encoding="utf-8"))["title"]
    return title
