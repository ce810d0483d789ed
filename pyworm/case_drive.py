"""The drive of a case file."""

from collections.abc import Callable

from pyworm.case_error import CaseError
from pyworm.drives.drive import Drive
from pyworm.drives.zi_worm import Hob, Wheel, Worm, ZiWormDrive
from pyworm.schema.case import CaseTable
from pyworm.schema.zi_worm import ZiWormCase


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


def _zi_worm(tables: ZiWormCase) -> ZiWormDrive:
    oil = tables.oil.oil()
    return ZiWormDrive(
        worm=Worm(**dict(tables.drive.worm)),
        wheel=Wheel(**dict(tables.drive.wheel)),
        hob=Hob(**dict(tables.drive.hob)),
        centre_distance=tables.drive.centre_distance,
        speed=tables.operation.worm_speed,
        load=tables.operation.load,
        bodies=tables.bodies.pair(oil),
        oil=oil,
    )


_DRIVES: dict[type[CaseTable], Callable[..., Drive]] = {ZiWormCase: _zi_worm}
"""What makes the drive of each kind of case."""
