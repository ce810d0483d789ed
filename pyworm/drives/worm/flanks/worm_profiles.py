"""The flanks of worms and hobs by profile, from the numbers of a drawing (DIN 3975, ISO 1122-2)."""

from dataclasses import dataclass, replace
from math import atan, cos, inf, pi, tan
from typing import Literal

from pyworm.drives.worm.flanks.axial_arc import axial_arc
from pyworm.drives.worm.flanks.disc_helicoid import Disc, DiscHelicoid
from pyworm.drives.worm.flanks.ruled_helicoid import (
    RuledHelicoid,
    blade_angle,
    straight_axial,
    straight_normal,
)
from pyworm.drives.worm.flanks.screw_generator import ScrewGenerator

Profile = Literal["ZA", "ZN", "ZI", "ZK", "ZC", "ZC2"]

PROFILES: dict[Profile, str] = {
    "ZA": "straight in the axial plane",
    "ZN": "straight in the plane normal to the thread",
    "ZI": "involute helicoid",
    "ZK": "ground by a cone",
    "ZC": "ground by a disc of convex profile",
    "ZC2": "a concave arc in the axial plane",
}
"""Profiles of cylindrical worms, and what they are."""

PRESSURE_ANGLE_PLACES: dict[Profile, str] = {
    "ZA": "axial section",
    "ZN": "blade, normal to the thread",
    "ZI": "normal section",
    "ZK": "grinding disc",
    "ZC": "grinding disc",
    "ZC2": "normal section",
}
"""Profile -> where its pressure angle is defined, on the reference cylinder.

A blade or a disc lies in a plane normal to the thread in the middle of the space; the normal section of the
flank, half a space beside it, has a slightly different angle."""

CONCAVE_PROFILES = ("ZC", "ZC2")
"""Profiles of concave worms, which need a positive profile shift."""

BLADE_STEPS = 6
"""Corrections of a hob's blade angle; each leaves a hundredth of the difference or less."""

BELOW_ROOT, ABOVE_TIP = 0.3, 0.4
"""How far beyond root and tip a curved flank is found, over the axial module."""


@dataclass(frozen=True)
class Thread:
    """Numbers that form a flank of a worm or a hob."""

    module: float
    """Axial module of the worm [m]."""
    lead: float
    """Advance in one turn [m]."""
    lead_angle: float
    """Lead angle on the reference cylinder [rad]."""
    pressure_angle: float
    """Normal pressure angle on the reference cylinder; of blades (ZN) and discs the profile's [rad]."""
    reference_radius: float
    """Radius of its reference cylinder [m]."""
    root_radius: float
    """Radius of its root cylinder [m]."""
    tip_radius: float
    """Radius of its tip cylinder [m]."""
    space: float
    """Normal width of the space between threads on the reference cylinder [m]."""
    disc_diameter: float | None = None
    """Diameter of the disc where it touches the reference cylinder [m]."""
    arc_radius: float | None = None
    """Radius of the disc's profile [m]."""


def generator_of(profile: Profile, thread: Thread) -> ScrewGenerator | None:
    """What sweeps the flank of a thread; None of ZI, which is closed; ValueError without such a flank."""
    screw = thread.lead, thread.lead_angle, thread.pressure_angle
    if profile == "ZI":
        return None
    if profile == "ZA":
        return straight_axial(*screw)
    if profile == "ZN":
        return _straight_blade(thread)
    low, high = (
        thread.root_radius - BELOW_ROOT * thread.module,
        thread.tip_radius + ABOVE_TIP * thread.module,
    )
    if profile == "ZC2" and thread.arc_radius is not None:
        return axial_arc(*screw, thread.reference_radius, thread.arc_radius, (low, high))
    arc = inf if thread.arc_radius is None else thread.arc_radius
    if thread.disc_diameter is None:
        raise ValueError(f"profile {profile}: the diameter of the grinding disc is missing")
    disc = Disc(thread.disc_diameter / 2, thread.space, thread.pressure_angle, arc)
    return DiscHelicoid(disc, thread.reference_radius, thread.lead / (2 * pi), low, high)


def _straight_blade(thread: Thread) -> ScrewGenerator:
    apex = thread.reference_radius - thread.space / 2 / tan(thread.pressure_angle)
    return straight_normal(thread.lead, thread.lead_angle, thread.pressure_angle, apex)


def _blade_angle(thread: Thread) -> float:
    """Normal pressure angle of a ZN flank on the reference cylinder."""
    return _straight_blade(thread).pressure_angle(thread.reference_radius)


def hob_generator(profile: Profile, hob: Thread, worm: Thread) -> ScrewGenerator | None:
    """What sweeps the flank of the hob of a worm; None of ZI.

    The straight blade of a ZN hob has the angle by which both flanks have one normal pressure angle on their
    reference cylinders, and so one base pitch; with the worm's they would differ by some micrometres.

    ValueError if a disc of this size leaves no such flank.
    """
    if profile != "ZN":
        return generator_of(profile, hob)
    wanted = _blade_angle(worm)
    for _ in range(BLADE_STEPS):
        off = wanted - _blade_angle(hob)
        hob = replace(hob, pressure_angle=hob.pressure_angle + off)
    return generator_of(profile, hob)


def normal_pressure_angle(profile: Profile, pressure_angle: float, lead_angle: float) -> float:
    """Normal pressure angle of what a drawing gives, which of ZA is the angle in the axial plane."""
    return atan(tan(pressure_angle) * cos(lead_angle)) if profile == "ZA" else pressure_angle


def own_pressure_angle(
    profile: Profile, generator: ScrewGenerator | None, lead_angle: float, normal: float
) -> float:
    """Pressure angle in the definition of the profile (`PRESSURE_ANGLE_PLACES`) [rad]."""
    if profile == "ZA":
        return atan(tan(normal) / cos(lead_angle))
    if profile == "ZN" and isinstance(generator, RuledHelicoid):
        return blade_angle(generator, lead_angle)
    if isinstance(generator, DiscHelicoid):
        return generator.disc.pressure_angle
    return normal
