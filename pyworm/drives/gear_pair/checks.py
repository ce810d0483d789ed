"""Checks of a gear pair and its operation; each refusal is a sentence that begins with the key at fault."""

from math import ceil, cos, degrees, isfinite, pi, sin
from typing import get_args

from pyworm.drives.gear_pair.design import ContactKind, Driver
from pyworm.drives.gear_pair.gears import InvolutePair
from pyworm.drives.gear_pair.mesh import GearPairMesh

CIRCLES_TOUCH = 1e-9
"""Overlap of two circles, over the module, that counts as rounding."""

TIGHT = 1e-3
"""Negative backlash, over the module, that counts as the rounding of a table of profile shifts."""


def check_gears(pair: InvolutePair) -> None:
    """Refuse gears that do not mesh (ValueError)."""
    _check_values(pair)
    _check_centre_distance(pair)
    _check_teeth(pair)
    _check_engagement(pair)


def check_mesh(mesh: GearPairMesh) -> None:
    """Refuse sizes, choices, reliefs longer than their flanks and impossible load sharing (ValueError)."""
    for key in ("pinion_speed", "power", "load_factor"):
        value = getattr(mesh, key)
        if not (isfinite(value) and value > 0):
            raise ValueError(f"{key} is {value:g}; it must be positive and finite")
    for key, choices in (("driver", get_args(Driver)), ("contact", get_args(ContactKind))):
        if getattr(mesh, key) not in choices:
            raise ValueError(
                f'{key} is "{getattr(mesh, key)}"; it must be one of {", ".join(choices)}'
            )
    if not (isfinite(mesh.lead_crowning) and mesh.lead_crowning >= 0):
        raise ValueError(f"lead_crowning is {mesh.lead_crowning:g} m; it must be zero or more")
    if mesh.contact == "point" and mesh.lead_crowning == 0:
        raise ValueError(
            'lead_crowning is missing; contact = "point" needs some, such as "10 um", for the pressure at '
            "the ends of straight teeth has no bound"
        )
    longest = mesh.teeth.path_length
    for name, relief in zip(("pinion", "gear"), mesh.tip_relief, strict=True):
        if not (isfinite(relief.amount) and relief.amount >= 0):
            raise ValueError(f"{name}.tip_relief is {relief.amount:g} m; it must be zero or more")
        if relief.amount > 0 and not 0 < relief.length <= longest:
            raise ValueError(
                f"{name}.tip_relief_length is {relief.length * 1e3:.4g} mm; it must lie between 0 and the "
                f"length of the path of contact, {longest * 1e3:.4g} mm"
            )
    mesh.sharing  # noqa: B018  a rule that does not hold for these gears is refused here


def _check_values(pair: InvolutePair) -> None:
    """Refuse numbers that are not finite, or whose sign or size is impossible."""
    system = pair.system
    sizes = {
        "module": system.module,
        "centre_distance": pair.centre_distance,
        "face_width": pair.face_width,
        "pressure_angle": system.pressure_angle,
    }
    for name, gear in (("pinion", pair.pinion), ("gear", pair.gear)):
        sizes |= {f"{name}.addendum": gear.addendum, f"{name}.dedendum": gear.dedendum}
        if gear.teeth != int(gear.teeth) or gear.teeth < 1:
            raise ValueError(f"{name}.teeth is {gear.teeth:g}; a whole number of teeth is needed")
        if not isfinite(gear.profile_shift):
            raise ValueError(f"{name}.profile_shift is {gear.profile_shift}; it must be finite")
        if not 0 <= gear.fillet < gear.dedendum:
            raise ValueError(
                f"{name}.fillet is {gear.fillet:g}; it must lie between 0 and the dedendum, "
                f"{gear.dedendum:g}"
            )
    for key, value in sizes.items():
        if not (isfinite(value) and value > 0):
            raise ValueError(f"{key} is {value:g}; it must be positive and finite")
    if not system.pressure_angle < pi / 4:
        raise ValueError(
            f"pressure_angle is {degrees(system.pressure_angle):.4g} deg; it must be below 45 deg, "
            "such as 20 deg"
        )
    if not 0 <= system.helix_angle < pi / 3:
        raise ValueError(
            f"helix_angle is {degrees(system.helix_angle):.4g} deg; it must lie from 0 deg (spur) to "
            "60 deg"
        )
    if pair.gear.teeth < pair.pinion.teeth:
        raise ValueError(
            f"pinion.teeth is {pair.pinion.teeth}; the pinion is the gear with fewer teeth, the other one "
            f"has {pair.gear.teeth}"
        )


def _check_centre_distance(pair: InvolutePair) -> None:
    """Refuse overlapping base circles and teeth that jam."""
    base_circles = pair.reference_centre_distance * cos(pair.system.transverse_pressure_angle)
    if pair.centre_distance <= base_circles:
        raise ValueError(
            f"centre_distance is {pair.centre_distance * 1e3:.4g} mm; the base circles touch at "
            f"{base_circles * 1e3:.4g} mm, it must be larger"
        )
    if pair.backlash < -TIGHT * pair.system.module:
        shifts = pair.pinion.profile_shift + pair.gear.profile_shift
        raise ValueError(
            f"centre_distance is {pair.centre_distance * 1e3:.6g} mm; teeth of profile shifts that sum to "
            f"{shifts:.4g} jam below {pair.tight_centre_distance * 1e3:.6g} mm"
        )


def _check_teeth(pair: InvolutePair) -> None:
    """Refuse teeth without a flank above the fillet or with a pointed tip."""
    module = pair.system.module
    for name, gear, size in zip(
        ("pinion", "gear"), (pair.pinion, pair.gear), pair.cylinders, strict=True
    ):
        if size.form_length < -CIRCLES_TOUCH * module:
            least = (
                gear.profile_shift
                - size.form_length * sin(pair.system.transverse_pressure_angle) / module
            )
            raise ValueError(
                f"{name}.profile_shift is {gear.profile_shift:.4g}; {gear.teeth} teeth are undercut below "
                f"{_up(least)}"
            )
        if size.tip <= max(size.root, size.base):
            raise ValueError(
                f"{name}.addendum is {gear.addendum:.4g}; the tip circle of {size.tip * 1e3:.4g} mm radius "
                "lies below the flank, a larger one is needed"
            )
        if size.tip_thickness <= 0:
            raise ValueError(
                f"{name}.addendum is {gear.addendum:.4g}; with profile_shift {gear.profile_shift:.4g} the "
                "tooth comes to a point before its tip, one of them must be smaller"
            )


def _check_engagement(pair: InvolutePair) -> None:
    """Refuse tips that touch roots or fillets, and a contact ratio below one."""
    module = pair.system.module
    names = ("pinion", "gear")
    for mine, other in ((0, 1), (1, 0)):
        size, facing = pair.cylinders[mine], pair.cylinders[other]
        clearance = pair.centre_distance - size.tip - facing.root
        addendum = getattr(pair, names[mine]).addendum
        if clearance < -CIRCLES_TOUCH * module:
            raise ValueError(
                f"{names[mine]}.addendum is {addendum:.4g}; its tip reaches {-clearance * 1e3:.3g} mm into "
                f"the root of the {names[other]}, it must be smaller or {names[other]}.dedendum larger"
            )
        reached = pair.base_tangent - size.tip_length
        if reached < facing.form_length - CIRCLES_TOUCH * module:
            raise ValueError(
                f"{names[mine]}.addendum is {addendum:.4g}; its tip meets the {names[other]} "
                f"{(facing.form_length - reached) * 1e3:.3g} mm below where the involute begins "
                "(interference), it must be smaller"
            )
    if pair.transverse_contact_ratio < 1:
        raise ValueError(
            f"pinion.addendum and gear.addendum give a transverse contact ratio of "
            f"{pair.transverse_contact_ratio:.3f}; a pair of teeth parts before the next one meets, at least "
            "1 is needed"
        )


def _up(value: float) -> str:
    """Format with two decimals, rounded up so that the advised value is enough."""
    return f"{ceil(value * 100 - 1e-9) / 100:.2f}"
