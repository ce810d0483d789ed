"""Kinds of case files: one model for each table; text with units becomes SI.

Each model checks the values of its own table only; the drive checks that worm, wheel and hob fit. The models
of drives are imported when their kind is asked for: most cases have one, and each brings its drive along.
"""

from functools import cache
from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, create_model

from pyworm.case.case_file import CaseTable
from pyworm.case.contact import GapCase, LineCase, PointCase
from pyworm.case.ratings import RatedCase
from pyworm.drives.kinds import KINDS, module_of
from pyworm.io.present import present

CONTACTS: dict[str, type[CaseTable]] = {
    "point-contact": PointCase,
    "line-contact": LineCase,
    "gap": GapCase,
}

SUBJECTS = {"drive": KINDS, "contact": tuple(CONTACTS)}
"""Table of the subject of a case -> its kinds; a kind of drive has its model in its module of case tables."""


def case_model(about: str, kind: str) -> type[CaseTable]:
    """Model of the case file about a kind of subject."""
    if about == "contact":
        return CONTACTS[kind]
    return present(module_of(kind, "case"), f"case tables of {kind}").CASE


def rated() -> tuple[str, ...]:
    """Kinds of drives whose case files may ask for ratings."""
    kinds = SUBJECTS["drive"]
    return tuple(kind for kind in kinds if issubclass(case_model("drive", kind), RatedCase))


FORMER = {
    "zi-worm": 'must be "worm", with profile = "ZI", the keys threads, teeth and face_width in [drive], and '
    "diameters in place of radii: worm and hob have tip_diameter, root_diameter and base_diameter, the wheel "
    "outside_diameter and throat_diameter"
}
"""Former kind of a subject -> what is to be written in its place."""


def _not_former(kind: Any) -> Any:
    """A kind that there is, or is not known; ValueError of a former one."""
    if isinstance(kind, str) and kind in FORMER:
        raise ValueError(FORMER[kind])
    return kind


@cache
def kind_model(about: str) -> type[BaseModel]:
    """Model of the part of a case file that holds its kind."""
    named: dict[str, Any] = {
        "kind": (Annotated[Literal[SUBJECTS[about]], BeforeValidator(_not_former)], ...)
    }
    parts: dict[str, Any] = {about: (create_model("Kind", **named), ...)}
    return create_model("KindCase", **parts)
