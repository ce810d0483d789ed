"""What a case file may say: one table, one model; text with units comes in, SI comes out.

Each model answers for the values of its own table only. Whether worm, wheel and hob make a drive is the
drive's to say.
"""

from collections.abc import Callable
from typing import Literal

from pydantic import BaseModel, create_model

from pyworm.case.case_file import CaseTable
from pyworm.case.contact import GapCase, LineCase, PointCase
from pyworm.case.gear_pair import GearPairCase, gear_pair_drive
from pyworm.case.roller_worm import RollerWormCase, roller_worm_drive
from pyworm.case.zi_worm import ZiWormCase, zi_worm_drive
from pyworm.drives.drive import Drive
from pyworm.io.input_error import CaseError

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


def case_drive(tables: CaseTable) -> Drive:
    """The machine that a case file describes.

    Parameters
    ----------
    tables : CaseTable
        The file, in SI; one of the kinds about a drive.

    Raises
    ------
    CaseError
        The parts do not make a drive.
    """
    try:
        return _DRIVES[type(tables)](tables)
    except ValueError as error:
        raise CaseError(f"drive.{error}") from error


_DRIVES: dict[type[CaseTable], Callable[..., Drive]] = {
    ZiWormCase: zi_worm_drive,
    GearPairCase: gear_pair_drive,
    RollerWormCase: roller_worm_drive,
}
"""What makes the drive of each kind of case."""
