"""Set-up of the hob for a contact pattern, its regrinding, allowed errors of assembly, shim of the wheel."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from warnings import warn

from pyworm.case.case import Case, load
from pyworm.drives.answers import HobSetup, Row, Shim
from pyworm.drives.drive import AllowedErrors
from pyworm.io import units
from pyworm.io.given import WithUnit, kind_of, number
from pyworm.io.input_error import CaseError
from pyworm.io.present import present
from pyworm.io.shown import Shown
from pyworm.io.stage import stage
from pyworm.scene.plausibility import UnusualWarning


@dataclass(frozen=True, repr=False)
class CaseSetup(Shown, HobSetup):
    """Set-up of the hob of a worm gear set; rows have keys that end in their unit."""

    wanted: Mapping[str, float] | None = None
    """Required pattern: `face`, its place [m], and `size`, its share of the flank [-]."""
    allowed_errors: AllowedErrors | None = None
    """Errors of the assembly that are allowed, each alone, with what limits them."""
    hob_life: tuple[Row, ...] = ()
    """What the hob cuts as it is reground, swivelled anew each time."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the set-up in words."""
        return "CaseSetup", {
            "required pattern": ", ".join(self.wanted or {}) or "none",
            "proposed": "no" if self.proposed is None else "yes",
            "allowed errors": f"{len(self.allowed_errors or {})}",
            "regrinds": f"{len(self.hob_life)}",
        }

    def summary(self) -> dict[str, Any]:
        """All of it as one object, as `pyworm setup --json` prints it."""
        return {
            "wanted": self.wanted,
            "reached": self.reached,
            "now": self.current,
            **({} if self.proposed is None else {"found": self.proposed}),
            "allowed_assembly_errors": self.allowed_errors,
            "hob_life": self.hob_life,
        }


def setup(
    case: Case | str | Path | Mapping[str, Any],
    place: WithUnit | None = None,
    size: WithUnit | None = None,
) -> CaseSetup:
    """Set-up of the hob of a worm gear set for a contact pattern, as the command `pyworm setup`.

    Args:
        case: A worm gear set, its file or its tables.
        place: Centre of the required pattern along the face [m], positive to the leaving side.
        size: Required marked share of the flank [-]; without both the present set-up is described.

    Raises:
        CaseError: Invalid input, or gears without a hob.
    """
    wanted = {}
    if place is not None:
        wanted["face"] = number("place", place, kind_of(units.Offset))
    if size is not None:
        wanted["size"] = number("size", size, kind_of(units.Share))
    if not 0 < wanted.get("size", 0.5) < 1:
        raise CaseError(f"size = {size}: must lie between 0 and 100 %")
    case = case if isinstance(case, Case) else load(case)

    def said(sentence: str) -> None:
        warn(f"{case.name}: {sentence}", UnusualWarning, stacklevel=3)

    return case_setup(case, wanted, case.name, said)


def case_setup(
    case: Case, wanted: dict[str, float], name: object, say: Callable[[str], None]
) -> CaseSetup:
    """The set-up of the hob of a case; hobs that cut no wheel are named.

    Args:
        wanted: Required pattern, as `Drive.hob_setup` takes it.
        name: What the case is called in a CaseError, raised where it has no hob.
    """
    with stage("cutting wheels with other set-ups of the hob"):
        found = None if case.drive is None else case.drive.hob_setup(wanted)
    if found is None:
        raise CaseError(f"{name}: has no hob that could be set up; give a worm drive")
    with stage("finding the errors of the assembly that are allowed"):
        allowed = present(case.drive, "drive").allowed_errors()
    with stage("cutting wheels with the reground hob"):
        life = tuple(_life(case, say))
    return CaseSetup(found.current, found.proposed, found.reached, wanted, allowed, life)


def _life(case: Case, say: Callable[[str], None]) -> list[Row]:
    """What the hob cuts as it is reground; a part of its oversize that cuts no wheel is named."""
    rows = []
    for part in case.tables.hob_life:
        try:
            oversize, drive = case.tables.reground_drive(case.drive, part)
            rows.append(drive.hob_setup({}).current | {"hob_oversize_m": oversize})
        except ValueError as error:
            say(f"a hob with {part:.0%} of its oversize left is not shown: {error}")
    return rows


def shim(case: Case | str | Path | Mapping[str, Any], place: WithUnit | None = None) -> Shim:
    """Shim of the wheel for its contact pattern, as the command `pyworm setup --shim`.

    Args:
        case: A worm gear set, its file or its tables.
        place: Centre of the required pattern along the face [m], positive to the leaving side; by default
            that without errors of assembly.

    Raises:
        CaseError: Invalid input, or gears without such a wheel.
    """
    wanted = None if place is None else number("place", place, kind_of(units.Offset))
    case = case if isinstance(case, Case) else load(case)
    return case_shim(case, wanted, case.name)


def case_shim(case: Case, wanted: float | None, name: object) -> Shim:
    """The shim of the wheel of a case; CaseError with its name if there is none."""
    with stage("shifting the wheel"):
        found = None if case.drive is None else case.drive.wheel_shim(wanted)
    if found is None:
        raise CaseError(f"{name}: has no wheel that a shim could move; give a worm drive")
    return found
