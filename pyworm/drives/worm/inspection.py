"""Dimensions by which worm and wheel are inspected: over balls and wires, chordal thickness, backlash.

Balls and chords touch the flank itself, of any profile. The other flank of a thread or a tooth is the first
one turned by half a turn about the line of centres.
"""

from dataclasses import dataclass, replace
from math import atan2, cos, hypot, isfinite, pi, sin, sqrt, tan

import numpy as np
import scipy

from pyworm.drives.limits import Limits, check_order
from pyworm.drives.worm.drawing.design import Assembly
from pyworm.drives.worm.flanks.surfaces import WormSurface
from pyworm.drives.worm.flanks.thread_section import axial_angle
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.drives.worm.teeth.tooth import wheel_radius
from pyworm.drives.worm.teeth.tooth_form import wheel_thickness, worm_thickness
from pyworm.drives.worm.teeth.tooth_outline import flank_places
from pyworm.io import units

ON_FLANK = 1e-6
"""Distance from a wanted place at which a point found is at that place [m]."""

CHORD_STEPS = 8
"""Corrections of a wheel's chord; each leaves less than a tenth of the difference."""

LARGEST_BALL = 3.0
"""Largest diameter of a ball that touches the reference cylinder, over the module."""


@dataclass(frozen=True)
class Inspection:
    """What the drawing gives for the inspection of worm and wheel."""

    worm_ball_diameter: units.Length | None = None
    """Diameter of balls or wires in the worm's spaces [m]; None for that which touches the reference
    cylinder, with two digits."""
    worm_thickness: Limits | None = None
    """Deviations of the worm's axial thickness on the reference cylinder, lower and upper [m]."""
    wheel_thickness: Limits | None = None
    """Deviations of the wheel's thickness on the reference circle, lower and upper [m]."""
    centre_distance: Limits | None = None
    """Deviations of the centre distance, lower and upper [m]."""

    def __post_init__(self) -> None:
        names = "worm_thickness", "wheel_thickness", "centre_distance"
        check_order({name: getattr(self, name) for name in names})


AS_DRAWN = Inspection()


@dataclass(frozen=True)
class SeatedBall:
    """A ball that touches both flanks of a worm's space.

    Wires of the same diameter give the same dimension: a wire that turns freely about the radius through its
    middle lies where its normals at both flanks meet on that radius, as the ball's do, and nowhere lower.
    """

    diameter: float
    """Diameter [m]."""
    contact_radius: float
    """Radius at which it touches the flanks [m]."""
    centre_radius: float
    """Distance of its centre from the worm's axis [m]."""

    @property
    def over(self) -> float:
        """Dimension over two balls or three wires, by jaws parallel to the axis [m]."""
        return 2 * self.centre_radius + self.diameter


@dataclass(frozen=True)
class Chord:
    """Thickness in the normal section as a tooth caliper measures it on the reference cylinder."""

    thickness: float
    """Chordal thickness [m]."""
    height: float
    """Chordal height from the tip [m]."""


def _ball_centre(flank: WormSurface, radius: float, ball: float) -> tuple[float, float]:
    """Distance of the centre from the axis and its place along the axis at polar angle zero [m].

    Of a ball with a radius [m] that touches the flank z = f(r) + p phi on a cylinder [m] from outside the
    thread: the centre lies on the normal (-f', -p/r, 1), which points into the thread, to the other side.
    """
    slope, rise = tan(axial_angle(flank, radius)), flank.screw / radius
    step = ball / sqrt(1 + slope**2 + rise**2)
    outwards, across = radius + slope * step, rise * step
    along = flank.axial_profile(radius) - step - flank.screw * atan2(across, outwards)
    return hypot(outwards, across), along


def _beyond_middle(gears: WormGears, radius: float, ball: float) -> float:
    """How far the centre of such a ball is from the middle of the space, towards the flank [m]."""
    flank, reference = gears.worm_flank, gears.reference_radius
    space = gears.worm.axial_pitch - worm_thickness(gears, reference)
    middle = flank.axial_profile(reference) - space / 2
    return _ball_centre(flank, radius, ball)[1] - middle


def reference_ball(gears: WormGears) -> float:
    """Diameter of the ball that touches the worm's flanks on its reference cylinder [m]."""
    reference = gears.reference_radius
    return 2 * float(
        scipy.optimize.brentq(
            lambda ball: _beyond_middle(gears, reference, ball),
            0.0,
            LARGEST_BALL / 2 * gears.module,
            xtol=1e-15,
        )
    )


def seated_ball(gears: WormGears, diameter: float | None) -> SeatedBall | None:
    """The ball of a diameter [m] in the worm's space; None beyond the flanks, or below the tips.

    Without a diameter it is `reference_ball` with two digits.
    """
    known = float(f"{reference_ball(gears):.2g}") if diameter is None else diameter
    low, high = gears.worm_tooth.start_radius, gears.worm.tip_radius

    def beyond(radius: float) -> float:
        return _beyond_middle(gears, radius, known / 2)

    if not beyond(low) < 0 < beyond(high):
        return None
    touch = float(scipy.optimize.brentq(beyond, low, high, xtol=1e-15))
    seated = SeatedBall(known, touch, _ball_centre(gears.worm_flank, touch, known / 2)[0])
    return seated if seated.over > 2 * high else None


def worm_chord(gears: WormGears) -> Chord:
    """Chordal thickness of the worm's thread in the plane normal to it, on the reference cylinder."""
    reference = gears.reference_radius
    screw, half = gears.worm_flank.screw, worm_thickness(gears, reference) / 2
    lead_angle = atan2(screw, reference)
    turn = scipy.optimize.brentq(
        # the plane has z = -y / tan(lead angle), the flank z = p phi + half the thickness
        lambda phi: reference * sin(phi) / tan(lead_angle) + screw * phi + half,
        -pi / 2,
        0.0,
        xtol=1e-15,
    )
    along = screw * turn + half
    return Chord(
        2 * hypot(along, reference * sin(turn)), gears.worm.tip_radius - reference * cos(turn)
    )


def wheel_chord(gears: WormGears) -> Chord | None:
    """Chordal thickness of the wheel's tooth in the plane normal to it, on the reference circle.

    At mid-face, where the tooth has the worm's lead angle; None if the flank does not reach there.
    """
    reference = gears.wheel_reference_radius
    lead_angle = atan2(gears.worm_flank.screw, gears.reference_radius)
    half, along = wheel_thickness(gears) / (2 * reference), 0.0
    for _ in range(CHORD_STEPS):
        angle = half + _grown(gears, along)
        if not isfinite(angle):
            return None
        along = -reference * sin(angle) * tan(lead_angle)
    across = reference * sin(angle)
    return Chord(2 * hypot(along, across), gears.wheel.throat_radius - reference * cos(angle))


def _grown(gears: WormGears, along: float) -> float:
    """Angle by which the flank on the reference circle lies farther out than at mid-face [rad].

    At a place along the face [m], counted to the side on which the tooth's middle line, which rises with the
    threads, leaves the flank.
    """
    reference = gears.wheel_reference_radius
    start = gears.wheel_flank.normal(*(np.array([value]) for value in gears.within))
    middle = gears.wheel_flank.point(*(np.array([value]) for value in gears.within))
    polar = np.arctan2(middle[2], -middle[0])
    outwards = float(np.sign(start[0] * np.sin(polar) + start[2] * np.cos(polar))[0])
    target = np.array([[reference, reference], [along * outwards, 0.0]])
    point = gears.wheel_flank.point(*flank_places(gears.wheel_flank, gears.within, target))
    if np.abs(np.stack([wheel_radius(point), point[1]]) - target).max() > ON_FLANK:
        return float("nan")
    there, here = np.arctan2(point[2], -point[0])
    return outwards * float(there - here)


def backlash_limits(gears: WormGears, inspection: Inspection) -> tuple[float, float] | None:
    """Least and largest circumferential backlash on the wheel's reference circle [m].

    By the deviations of both thicknesses and of the centre distance, the latter on the flanks themselves;
    None if the backlash or every deviation is unknown.
    """
    given = inspection.worm_thickness, inspection.wheel_thickness, inspection.centre_distance
    if gears.wheel.backlash is None or given == (None, None, None):
        return None
    thickness = [limits or (0.0, 0.0) for limits in given[:2]]
    apart = inspection.centre_distance or (0.0, 0.0)
    least, largest = (_play_apart(gears, deviation) for deviation in apart)
    return (
        least - sum(limits[1] for limits in thickness),
        largest - sum(limits[0] for limits in thickness),
    )


def _play_apart(gears: WormGears, deviation: float) -> float:
    """Backlash with an error of the centre distance alone [m]."""
    apart = replace(gears, assembly=Assembly(centre_distance=deviation))
    play = apart.play
    if play is None:
        raise ValueError("the backlash is not known")
    return play
