"""What a case file asks to be rated, and its ratings."""

from dataclasses import dataclass
from pathlib import Path

from pyworm.case import Case, case_of, checked, read_toml
from pyworm.case_error import CaseError
from pyworm.drives.gear_pair import GearPairDrive
from pyworm.drives.zi_worm import ZiWormDrive
from pyworm.ratings.bearing import rate_bearing_table
from pyworm.ratings.gear import rate_gear_pair
from pyworm.ratings.rating import Rating
from pyworm.ratings.worm import (
    WormDuty,
    rate_worm_table,
    worm_duty_of_drive,
    worm_duty_of_table,
)
from pyworm.result import Result
from pyworm.schema.rating import RATING_TABLES, RatedCase, RatingCase


@dataclass(frozen=True)
class Asked:
    """A case file with something to be rated.

    Attributes
    ----------
    name : str
        File name without its ending.
    directory : Path
        Where it lies; files that it names are relative to it.
    tables : RatedCase or RatingCase
        The file, in SI.
    drive : ZiWormDrive, GearPairDrive or None
        Its drive, if it has one that can be rated.
    """

    name: str
    directory: Path
    tables: RatedCase | RatingCase
    drive: ZiWormDrive | GearPairDrive | None = None

    @property
    def worm_duty(self) -> WormDuty | None:
        """Its worm gear as the standards see it, if it has one."""
        if isinstance(self.drive, ZiWormDrive):
            return worm_duty_of_drive(self.drive)
        table = getattr(self.tables, "worm_gear", None)
        return None if table is None else worm_duty_of_table(table)


def load_asked(path: str | Path) -> Asked:
    """Read a case file for its ratings.

    Raises
    ------
    CaseError
        Whatever is wrong first, in one sentence.
    """
    path = Path(path)
    data = read_toml(path)
    try:
        if "drive" in data or "contact" in data:
            return asked_of(case_of(data, path.stem, path.parent))
        if not any(name in data for name in RATING_TABLES):
            raise CaseError("give a [drive], [bearings.NAME] or [worm_gear] to be rated")
        return Asked(path.stem, path.parent, checked(RatingCase, data))
    except CaseError as error:
        raise CaseError(f"{path}: {error}") from error


def asked_of(case: Case) -> Asked:
    """What a case that can be solved asks to be rated; CaseError if nothing can be."""
    if not isinstance(case.tables, RatedCase):
        raise CaseError('only drives of kind "zi-worm" and "gear-pair" and bearings are rated')
    return Asked(case.name, case.directory, case.tables, case.drive)


def ratings(asked: Asked, result: Result | None = None) -> tuple[Rating, ...]:
    """Every rating that a case asks for; none if it asks for none.

    Parameters
    ----------
    asked : Asked
        The case.
    result : Result, optional
        Solved contacts of its drive, shown beside.

    Raises
    ------
    CaseError
        What lies outside the methods, in one sentence.
    """
    tables, drive = asked.tables, asked.drive
    made: list[Rating] = []
    try:
        worm_rating = getattr(tables, "worm_rating", None)
        if worm_rating is not None:
            worm = drive if isinstance(drive, ZiWormDrive) else None
            made.append(
                rate_worm_table(worm_rating, asked.worm_duty, asked.directory, worm, result)
            )
        if isinstance(drive, GearPairDrive):
            made += rate_gear_pair(drive, tables.gear_rating, tables.published, result)
        made += [
            rate_bearing_table(name, table, asked.directory)
            for name, table in tables.bearings.items()
        ]
    except ValueError as error:
        raise CaseError(f"{asked.name}: {error}") from error
    return tuple(made)
