"""Kinds of case files: one model for each table; text with units becomes SI.

Each model checks the values of its own table only; the drive checks that worm, wheel and hob fit.
"""

from typing import Literal

from pydantic import BaseModel, create_model

from pyworm.case.case_file import CaseTable
from pyworm.case.contact import GapCase, LineCase, PointCase
from pyworm.case.ratings import RatedCase
from pyworm.case.worm import DrawnWormCase
from pyworm.drives.kinds import KINDS, module_of

CASES: dict[str, dict[str, type[CaseTable]]] = {
    "drive": {"worm": DrawnWormCase}
    | {kind: module_of(kind, "pyworm.case").CASE for kind in KINDS},
    "contact": {"point-contact": PointCase, "line-contact": LineCase, "gap": GapCase},
}
"""Table of the subject of a case -> its kind -> the model of its file.

A worm drive by its drawing is no drive of its own kind: it becomes the design table of one.
"""

RATED = tuple(kind for kind, case in CASES["drive"].items() if issubclass(case, RatedCase))
"""Kinds of drives whose case files may ask for ratings."""


def kind_model(about: str) -> type[BaseModel]:
    """Model of the part of a case file that holds its kind."""
    kind = create_model("Kind", kind=(Literal[tuple(CASES[about])], ...))
    return create_model("KindCase", **{about: (kind, ...)})
