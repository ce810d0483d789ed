"""Checks of the input of a gear pair; each refusal is a sentence that begins with the key that is wrong."""

from math import isfinite
from typing import TYPE_CHECKING, get_args

from pyworm.drives.gear_pair.design import ContactKind, Driver

if TYPE_CHECKING:
    from pyworm.drives.gear_pair.drive import GearPairDrive


def check_drive(drive: "GearPairDrive") -> None:
    """Refuse sizes not finite and positive, unknown choices, and reliefs longer than their flanks."""
    for key in ("pinion_speed", "power", "load_factor"):
        value = getattr(drive, key)
        if not (isfinite(value) and value > 0):
            raise ValueError(f"{key} is {value:g}; it must be positive and finite")
    for key, choices in (("driver", get_args(Driver)), ("contact", get_args(ContactKind))):
        if getattr(drive, key) not in choices:
            raise ValueError(
                f'{key} is "{getattr(drive, key)}"; it must be one of {", ".join(choices)}'
            )
    if not (isfinite(drive.lead_crowning) and drive.lead_crowning >= 0):
        raise ValueError(f"lead_crowning is {drive.lead_crowning:g} m; it must be zero or more")
    if drive.contact == "point" and drive.lead_crowning == 0:
        raise ValueError(
            'lead_crowning is missing; contact = "point" needs some, such as "10 um", for the pressure at '
            "the ends of straight teeth has no bound"
        )
    longest = drive.teeth.path_length
    for name, relief in zip(("pinion", "gear"), drive.tip_relief, strict=True):
        if not (isfinite(relief.amount) and relief.amount >= 0):
            raise ValueError(f"{name}.tip_relief is {relief.amount:g} m; it must be zero or more")
        if relief.amount > 0 and not 0 < relief.length <= longest:
            raise ValueError(
                f"{name}.tip_relief_length is {relief.length * 1e3:.4g} mm; it must lie between 0 and the "
                f"length of the path of contact, {longest * 1e3:.4g} mm"
            )
