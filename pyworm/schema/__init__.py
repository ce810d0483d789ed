"""What a case file may say: one table, one model; text with units comes in, SI comes out.

Each model answers for the values of its own table only. Whether worm, wheel and hob make a drive is the
drive's to say.
"""

from typing import Literal

from pydantic import BaseModel, create_model

from pyworm.schema.case import CaseTable
from pyworm.schema.contact import GapCase, LineCase, PointCase
from pyworm.schema.gear_pair import GearPairCase
from pyworm.schema.roller_worm import RollerWormCase
from pyworm.schema.zi_worm import ZiWormCase

CASES: dict[str, dict[str, type[CaseTable]]] = {
    "drive": {
        "zi-worm": ZiWormCase,
        "gear-pair": GearPairCase,
        "roller-worm": RollerWormCase,
    },
    "contact": {"point-contact": PointCase, "line-contact": LineCase, "gap": GapCase},
}
"""Table that says what a case is about -> its kind -> what the file may say."""


def kind_model(about: str) -> type[BaseModel]:
    """As much of a case file as tells its kind, which stands in the table that says what it is about."""
    kind = create_model("Kind", kind=(Literal[tuple(CASES[about])], ...))
    return create_model("KindCase", **{about: (kind, ...)})
