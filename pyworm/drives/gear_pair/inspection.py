"""Dimensions by which involute gears are inspected: over balls, span, chordal thickness, backlash.

Formulas of ISO 21771:2007, exact for involute helicoids; lengths in m, angles in rad.
"""

from dataclasses import dataclass, replace
from math import acos, cos, hypot, pi, sin, sqrt, tan

import scipy

from pyworm.drives.gear_pair.gears import (
    Cylinders,
    Gear,
    InvolutePair,
    ToothSystem,
    inverse_involute,
    involute,
)
from pyworm.drives.limits import Limits, check_order
from pyworm.io import units
from pyworm.io.plain_values import Count


@dataclass(frozen=True)
class MeasuredGear:
    """What the drawing gives for the inspection of one gear."""

    ball_diameter: units.Length | None = None
    """Diameter of the balls [m]; None for that which touches at mid-tooth, with two digits."""
    span_teeth: Count | None = None
    """Number of teeth that the span measures; None for a span that touches at mid-tooth."""
    thickness: Limits | None = None
    """Deviations of the normal thickness on the reference cylinder, lower and upper [m]."""


@dataclass(frozen=True)
class PairInspection:
    """What the drawing gives for the inspection of a pair of gears."""

    pinion: MeasuredGear = MeasuredGear()
    """The pinion."""
    gear: MeasuredGear = MeasuredGear()
    """The gear."""
    centre_distance: Limits | None = None
    """Deviations of the centre distance, lower and upper [m]."""

    def __post_init__(self) -> None:
        gears = {"pinion": self.pinion, "gear": self.gear}
        thickness = {f"{name}.thickness": gear.thickness for name, gear in gears.items()}
        check_order(thickness | {"centre_distance": self.centre_distance})


AS_DRAWN = PairInspection()


@dataclass(frozen=True)
class ToothMeasures:
    """Nominal measures of one gear; None where the teeth cannot be measured so."""

    thickness: float
    """Normal thickness on the reference cylinder s_n [m]."""
    chordal_thickness: float
    """Normal chordal thickness [m]."""
    chordal_height: float
    """Chordal height from the tip [m]."""
    ball_diameter: float
    """Diameter of the balls D_M [m]."""
    over_balls: float | None
    """Dimension over balls M_dK; of odd numbers of teeth in one transverse plane [m]."""
    over_pins: float | None
    """Dimension over pins M_dR of that diameter; of odd numbers of helical teeth over three [m]."""
    span_teeth: int
    """Number k of teeth that the span measures."""
    span: float | None
    """Span W_k [m]; None if its jaws touch no flank, or the face is too narrow."""


def tooth_measures(pair: InvolutePair, number: int, measured: MeasuredGear) -> ToothMeasures:
    """Measures of the pinion (0) or the gear (1) of a pair."""
    system, gear, size = pair.system, (pair.pinion, pair.gear)[number], pair.cylinders[number]
    thickness = normal_thickness(system, gear)
    middle = (max(size.base, size.root) + size.tip) / 2
    ball = measured.ball_diameter or float(f"{_touching_ball(system, gear, size, middle):.2g}")
    teeth = measured.span_teeth or _spanned(system, gear, size, middle)
    chord, height = _chord(system, size, thickness)
    centre = _ball_centre(system, gear, size, ball)
    apart = cos(pi / (2 * gear.teeth)) if gear.teeth % 2 else 1.0
    over = None if centre is None else 2 * centre * apart + ball
    three_pins = gear.teeth % 2 == 1 and system.helix_angle != 0
    return ToothMeasures(
        thickness,
        chord,
        height,
        ball,
        over,
        2 * centre + ball if centre is not None and three_pins else over,
        teeth,
        _span(pair, gear, size, teeth),
    )


def normal_thickness(system: ToothSystem, gear: Gear) -> float:
    """s_n = m_n (pi/2 + 2 x tan alpha_n) on the reference cylinder [m]."""
    return system.module * (pi / 2 + 2 * gear.profile_shift * tan(system.pressure_angle))


def _chord(system: ToothSystem, size: Cylinders, thickness: float) -> tuple[float, float]:
    """Normal chord of a tooth on the reference cylinder, and its height from the tip [m].

    The chord lies in the plane normal to the tooth: a point of it that is s beside the tooth's middle line
    across the axis is s tan(beta) along it.
    """
    half = thickness * cos(system.helix_angle) / (2 * size.reference)
    tilt = tan(system.helix_angle)

    def beyond(angle: float) -> float:
        # on the flank x = half the transverse thickness + what the helix turns along the axis
        return angle + tilt**2 * sin(angle) - half * (1 + tilt**2)

    angle = scipy.optimize.brentq(beyond, 0.0, pi / 2, xtol=1e-15)
    across = size.reference * sin(angle)
    return 2 * hypot(across, across * tilt), size.tip - size.reference * cos(angle)


def _half_space(system: ToothSystem, gear: Gear) -> float:
    """Half the angle of a space at the base circle, negative where teeth overlap there [rad]."""
    half_tooth = (pi / 2 + 2 * gear.profile_shift * tan(system.pressure_angle)) / gear.teeth
    return pi / gear.teeth - half_tooth - involute(system.transverse_pressure_angle)


def _touching_ball(system: ToothSystem, gear: Gear, size: Cylinders, radius: float) -> float:
    """Diameter of the ball that touches both flanks of a space on a cylinder [m].

    Its centre lies at alpha_K, its contact at alpha_y, with D_M = d_b cos(beta_b) (inv alpha_K + eta_b) and
    D_M = d_b / cos(beta_b) (tan alpha_K - tan alpha_y).
    """
    tilt, space = cos(system.base_helix_angle), _half_space(system, gear)
    at_touch = tan(acos(size.base / radius))

    def excess(angle: float) -> float:
        return tan(angle) - at_touch - tilt**2 * (involute(angle) + space)

    angle = scipy.optimize.brentq(excess, 0.0, 1.5, xtol=1e-15)
    return 2 * size.base * tilt * (involute(angle) + space)


def _ball_centre(system: ToothSystem, gear: Gear, size: Cylinders, ball: float) -> float | None:
    """Distance of a ball in a space from the axis [m], inv alpha_K = D_M / (d_b cos beta_b) - eta_b.

    None where the ball touches no flank or does not reach over the tips.
    """
    tilt = cos(system.base_helix_angle)
    value = ball / (2 * size.base * tilt) - _half_space(system, gear)
    if value <= 0:
        return None
    angle = inverse_involute(value)
    centre = size.base / cos(angle)
    touch = size.base * tan(angle) - ball / 2 * tilt
    reached = max(size.form_length, 0.0) < touch < size.tip_length
    return centre if reached and centre + ball / 2 > size.tip else None


def _spanned(system: ToothSystem, gear: Gear, size: Cylinders, radius: float) -> int:
    """Number of teeth over which a span touches nearest to a cylinder [m]."""
    wanted = 2 * sqrt(radius**2 - size.base**2) / cos(system.base_helix_angle)
    pitch = pi * system.module * cos(system.pressure_angle)
    return max(round((wanted - _span_length(system, gear, 0)) / pitch), 1)


def _span_length(system: ToothSystem, gear: Gear, teeth: int) -> float:
    """W_k = m_n cos(alpha_n) [pi (k - 1/2) + z inv(alpha_t) + 2 x tan(alpha_n)] [m]."""
    turned = pi * (teeth - 0.5) + gear.teeth * involute(system.transverse_pressure_angle)
    shifted = 2 * gear.profile_shift * tan(system.pressure_angle)
    return system.module * cos(system.pressure_angle) * (turned + shifted)


def _span(pair: InvolutePair, gear: Gear, size: Cylinders, teeth: int) -> float | None:
    """W_k [m]; None where it touches beyond the involute or its line leaves the face."""
    system = pair.system
    span, helix = _span_length(system, gear, teeth), system.base_helix_angle
    touch = span * cos(helix) / 2
    if (
        not max(size.form_length, 0.0) < touch < size.tip_length
        or span * sin(helix) > pair.face_width
    ):
        return None
    return span


def backlash_limits(pair: InvolutePair, inspection: PairInspection) -> tuple[float, float] | None:
    """Least and largest circumferential backlash on the pitch circles [m]; None without deviations."""
    thickness = inspection.pinion.thickness, inspection.gear.thickness
    if (*thickness, inspection.centre_distance) == (None, None, None):
        return None
    apart = inspection.centre_distance or (0.0, 0.0)
    return (
        _backlash(pair, apart[0], [(limits or (0.0, 0.0))[1] for limits in thickness]),
        _backlash(pair, apart[1], [(limits or (0.0, 0.0))[0] for limits in thickness]),
    )


def _backlash(pair: InvolutePair, apart: float, thicker: list[float]) -> float:
    """Backlash with a deviation of the centre distance and of both normal thicknesses [m]."""
    moved = replace(pair, centre_distance=pair.centre_distance + apart)
    grown = (
        deviation / cos(pair.system.helix_angle) * size.pitch / size.reference
        for deviation, size in zip(thicker, moved.cylinders, strict=True)
    )
    return moved.backlash - sum(grown)


def normal_backlash(pair: InvolutePair) -> float:
    """Shortest distance of the idle flanks, j_bn = j_wt cos(alpha_wt) cos(beta_b) [m]."""
    return pair.backlash * cos(pair.pressure_angle) * cos(pair.system.base_helix_angle)
