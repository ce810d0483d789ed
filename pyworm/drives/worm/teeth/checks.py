"""Checks of the input of a worm drive; each refusal begins with the key that is wrong.

Of the redundant entries of a design table the geometry uses the lead and the base radius; base lead angle and
axial pitch must agree with them within a table's rounding.
"""

from collections.abc import Mapping
from dataclasses import fields
from math import atan2, degrees, isfinite, pi

from pyworm.drives.worm.drawing.design import Hob, Worm
from pyworm.drives.worm.flanks.contact_curve import HobError
from pyworm.drives.worm.teeth.deviation_checks import check_deviations
from pyworm.drives.worm.teeth.fillet_checks import check_fillets
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.drives.worm.teeth.size_checks import check_sizes
from pyworm.io.present import present

TABLE_ROUNDING = 1e-3
"""Relative disagreement of redundant table entries (four digits each) taken as rounding."""

BASE_PITCH_MISMATCH = 0.01
"""Relative difference of normal base pitches above which worm and wheel cannot mesh in turn."""


def check_gears(gears: WormGears) -> None:
    """Refuse gears that do not mesh (ValueError); the message begins with the key that is wrong."""
    _check_numbers(gears)
    check_sizes(gears)
    _check_table(gears)
    _check_fit(gears)
    check_fillets(gears)
    gears.cycle  # noqa: B018  gears whose teeth do not touch are refused here
    check_deviations(gears)


def check_play(gears: WormGears) -> None:
    """Refuse teeth that errors of the assembly leave no play: ValueError, by table."""
    left, backlash = gears.play, gears.wheel.backlash
    if left is None or backlash is None or left >= 0 or gears.aligned:
        return
    raise ValueError(
        f"assembly: with {gears.errors_in_words} the teeth jam: of the backlash of "
        f"{backlash * 1e3:.3g} mm, {-left * 1e3:.3g} mm are missing; smaller errors or a larger "
        "backlash are needed"
    )


def check_values(entries: Mapping[str, float], signed: frozenset[str] = frozenset()) -> None:
    """Refuse values that are not finite or, unless signed, not positive (ValueError)."""
    for key, value in entries.items():
        if not isfinite(value):
            raise ValueError(f"{key} is {value}; a finite number is needed")
        if key not in signed and value <= 0:
            raise ValueError(f"{key} is {value:.6g}; it must be positive")


def _check_numbers(gears: WormGears) -> None:
    """Refuse counts and sizes of the design table that are not finite, or not positive where they must be."""
    entries: dict[str, float] = {
        f"{part}.{field.name}": getattr(getattr(gears, part), field.name)
        for part in ("worm", "wheel", "hob", "assembly")
        for field in fields(getattr(gears, part))
        if field.name not in ("tip_relief", "generator", "profile", "deviations", "fillet_radius")
        and getattr(getattr(gears, part), field.name) is not None
    }
    signed = {"hob.swivel", "hob.axial_shift"}
    signed |= {key for key in entries if key.startswith("assembly.")}
    if entries.get("wheel.backlash") == 0:
        signed.add("wheel.backlash")
    check_values(entries | {"centre_distance": gears.centre_distance}, frozenset(signed))
    for key in ("worm.threads", "wheel.teeth"):
        if entries[key] != int(entries[key]):
            raise ValueError(f"{key} is {entries[key]:.6g}; a whole number is needed")


def _check_table(gears: WormGears) -> None:
    """Refuse redundant entries that disagree beyond the table's rounding."""
    for name, screw in (("worm", gears.worm), ("hob", gears.hob)):
        pitch = screw.lead / gears.worm.threads
        threads = gears.worm.threads
        if threads > 1 and abs(screw.lead - screw.axial_pitch) <= TABLE_ROUNDING * pitch:
            raise ValueError(
                f"{name}.lead is {screw.lead * 1e3:.2f} mm, the same as {name}.axial_pitch; the lead is "
                f"threads x {name}.axial_pitch, {threads * screw.axial_pitch * 1e3:.2f} mm"
            )
        if abs(pitch - screw.axial_pitch) > TABLE_ROUNDING * pitch:
            raise ValueError(
                f"{name}.axial_pitch is {screw.axial_pitch * 1e3:.2f} mm, but {name}.lead over "
                f"threads gives {pitch * 1e3:.2f} mm"
            )
        if screw.generator is None:
            _check_base(name, screw)
        if screw.tip_radius <= screw.root_radius:
            raise ValueError(
                f"{name}.tip_diameter is {screw.tip_radius * 2e3:.2f} mm; it must be above "
                f"{name}.root_diameter, {screw.root_radius * 2e3:.2f} mm"
            )
    heights = {
        "worm": gears.worm.tip_radius - gears.worm.root_radius,
        "wheel": gears.hob.tip_radius - gears.hob.root_radius,
    }
    for name, height in heights.items():
        relief = getattr(gears, name).tip_relief
        if relief.amount > 0 and not 0 < relief.length < height:
            raise ValueError(
                f"{name}.tip_relief_length is {relief.length * 1e3:.4g} mm; it must lie between 0 and the "
                f"tooth's height, {height * 1e3:.4g} mm"
            )
    if gears.wheel.tip_radius < gears.wheel.throat_radius:
        raise ValueError(
            f"wheel.outside_diameter is {gears.wheel.tip_radius * 2e3:.2f} mm; it must not be below "
            f"wheel.throat_diameter, {gears.wheel.throat_radius * 2e3:.2f} mm"
        )
    (pitch, cut), radii = gears.base_pitches, gears.reference_radii
    if abs(cut / pitch - 1) > BASE_PITCH_MISMATCH:
        apart = f"a normal base pitch of {cut * 1e3:.3f} mm, but the worm has {pitch * 1e3:.3f} mm"
        if gears.worm.generator is None:
            raise HobError(
                f"hob.lead and hob.base_diameter give {apart}; they must be equal to mesh"
            )
        raise HobError(
            f"hob.oversize of {2e3 * (radii[1] - radii[0]):.4g} mm gives the hob {apart}; they must be equal "
            "to mesh, for which a smaller hob.oversize or a larger pressure_angle is needed"
        )


def _check_base(name: str, screw: Worm | Hob) -> None:
    """Refuse a base lead angle of an involute helicoid that its lead and its base radius do not make."""
    radius = present(screw.base_radius, f"{name}.base_radius")
    given = present(screw.base_lead_angle, f"{name}.base_lead_angle")
    angle = atan2(screw.lead, 2 * pi * radius)
    if abs(angle - given) > TABLE_ROUNDING:
        for factor, slip in (
            (0.5, f"did you mean {radius * 1e3:.2f} mm?"),
            (2, f"is it a radius? a diameter is required, {radius * 4e3:.2f} mm"),
        ):
            if abs(atan2(screw.lead, 2 * pi * factor * radius) - given) <= TABLE_ROUNDING:
                raise ValueError(
                    f"{name}.base_diameter is {radius * 2e3:.2f} mm, with which {name}.lead does not give "
                    f"{name}.base_lead_angle, {degrees(given):.2f} deg; {slip}"
                )
        raise ValueError(
            f"{name}.base_lead_angle is {degrees(given):.2f} deg, but {name}.lead and "
            f"{name}.base_diameter give {degrees(angle):.2f} deg (tan = lead / pi base_diameter)"
        )


def _check_fit(gears: WormGears) -> None:
    """Refuse worm, wheel and hob that do not engage, and tips that touch roots."""
    worm, wheel, hob = gears.worm, gears.wheel, gears.hob
    floor = hob.centre_distance - hob.tip_radius
    lowest = max(worm.tip_radius + floor, worm.root_radius + wheel.throat_radius)
    highest = worm.tip_radius + wheel.throat_radius
    if not lowest <= gears.axes_distance < highest:
        error = gears.assembly.centre_distance
        with_error = (
            f" with assembly.centre_distance, a difference of {error * 1e3:.4g} mm,"
            if error
            else ""
        )
        raise ValueError(
            f"centre_distance{with_error} is {gears.axes_distance * 1e3:.2f} mm; it must lie from "
            f"{lowest * 1e3:.2f} mm, where a tip touches a root, to {highest * 1e3:.2f} mm, where the "
            "teeth no longer reach each other"
        )
    lowest = hob.root_radius + wheel.throat_radius
    if (
        not lowest - TABLE_ROUNDING * hob.root_radius
        <= hob.centre_distance
        < hob.tip_radius + wheel.throat_radius
    ):
        raise HobError(
            f"hob.centre_distance is {hob.centre_distance * 1e3:.2f} mm; it must lie from "
            f"{lowest * 1e3:.2f} mm, where the hob's root touches the wheel's throat, to "
            f"{(hob.tip_radius + wheel.throat_radius) * 1e3:.2f} mm, where the hob cuts no tooth"
        )
