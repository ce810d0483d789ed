"""Kinds of case files: one model for each table; text with units becomes SI.

Each model checks the values of its own table only; the drive checks that worm, wheel and hob fit. The models
of drives are imported when their kind is asked for: most cases have one, and each brings its drive along.
"""

from functools import cache
from importlib import import_module
from typing import Any, Literal

from pydantic import BaseModel, create_model

from pyworm.case.case_file import CaseTable
from pyworm.case.contact import GapCase, LineCase, PointCase
from pyworm.case.ratings import RatedCase
from pyworm.drives.kinds import KINDS

DRAWN = "worm"
"""A worm drive by its drawing is no drive of its own kind: it becomes the design table of one."""

CONTACTS: dict[str, type[CaseTable]] = {
    "point-contact": PointCase,
    "line-contact": LineCase,
    "gap": GapCase,
}

SUBJECTS = {"drive": (DRAWN, *KINDS), "contact": tuple(CONTACTS)}
"""Table of the subject of a case -> its kinds; each kind of drive has its model in the module of its name."""


def case_model(about: str, kind: str) -> type[CaseTable]:
    """Model of the case file about a kind of subject."""
    if about == "contact":
        return CONTACTS[kind]
    model: type[CaseTable] = import_module(f"pyworm.case.{kind.replace('-', '_')}").CASE
    return model


def rated() -> tuple[str, ...]:
    """Kinds of drives whose case files may ask for ratings."""
    kinds = SUBJECTS["drive"]
    return tuple(kind for kind in kinds if issubclass(case_model("drive", kind), RatedCase))


@cache
def kind_model(about: str) -> type[BaseModel]:
    """Model of the part of a case file that holds its kind."""
    named: dict[str, Any] = {"kind": (Literal[SUBJECTS[about]], ...)}
    parts: dict[str, Any] = {about: (create_model("Kind", **named), ...)}
    return create_model("KindCase", **parts)
