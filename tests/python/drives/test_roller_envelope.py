"""The worm flank is the exact envelope of the roller: swept rollers, second differences, closed forms."""

from math import atan, cos, degrees, pi, radians, sin

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from roller_sections import CENTRE_DISTANCE, ROLLERS, envelope, section

from pyworm.drives.roller_worm.checks import check_section
from pyworm.drives.roller_worm.envelope import RollerEnvelope, dot
from pyworm.drives.roller_worm.load_sharing import lever, worm_lever
from pyworm.drives.roller_worm.profile import RollerProfile

KINDS = [
    {},
    {"flank": "idle"},
    {"hand": 1},
    {"shape": "cone", "half_angle": 0.15},
    {"shape": "cone", "half_angle": -0.1, "flank": "idle", "tilt": 0.4},
    {"shape": "ball", "radius": 8e-3},
    {"tilt": 0.9},
]

shapes = st.sampled_from(KINDS)
places = st.floats(-5e-3, 5e-3)
angles = st.floats(-1.0, 1.0)


def swept_distance(flank, place, angle, others):
    """How far the flank's point lies outside the roller's surface while the wheel turns on [m].

    Written from the roller's own definition: distance from an axis that stands in the turning wheel.
    """
    point = flank.into_worm(flank.point(place, angle), np.asarray(angle))
    distances = []
    for other in others:
        x, y, z = flank.from_worm(point, np.asarray(other))
        radial = x * sin(other) + y * cos(other) - flank.pitch_radius
        going = x * cos(other) - y * sin(other)
        up = z - flank.height
        along = radial * cos(flank.tilt) + up * sin(flank.tilt)
        away = np.hypot(going, up * cos(flank.tilt) - radial * sin(flank.tilt))
        shape = flank.profile.shape
        if shape == "ball":
            distances.append(np.hypot(along, away) - flank.profile.radius)
        else:
            slope = np.tan(flank.profile.half_angle) if shape == "cone" else 0.0
            side = away - flank.profile.radius - slope * along
            distances.append(side * cos(atan(slope)))
    return np.array(distances)


@settings(deadline=None, max_examples=60)
@given(kind=shapes, place=places, angle=angles)
def test_the_flank_touches_the_roller_to_a_nanometre_and_lets_it_pass(kind, place, angle):
    flank = envelope(**kind)
    swing = np.linspace(-0.02, 0.02, 81)
    distance = swept_distance(flank, place, angle, angle + swing)
    assert abs(distance[40]) < 1e-15
    # least where it touches, never inside the roller
    assert distance.min() > -1e-9
    assert distance[0] > 1e-5 and distance[-1] > 1e-5


@settings(deadline=None, max_examples=60)
@given(kind=shapes, place=places, angle=angles)
def test_the_surfaces_do_not_part_or_press_along_the_normal(kind, place, angle):
    flank = envelope(**kind)
    contact = flank.contact(place, angle)
    step = 1e-5
    fixed = flank.into_worm(contact.point, contact.wheel_angle)
    worm = flank.from_worm(fixed, angle + step) - flank.from_worm(fixed, angle - step)
    x, y, _ = contact.point
    wheel = 2 * step * np.array([y, -x, 0.0])
    assert abs(dot(contact.normal, worm - wheel)) / (2 * step) < 1e-7 * CENTRE_DISTANCE


@settings(deadline=None, max_examples=40)
@given(kind=shapes, place=places, angle=angles)
def test_worm_and_roller_share_their_normal(kind, place, angle):
    flank = envelope(**kind)
    contact = flank.contact(place, angle)
    step = 1e-5
    along = flank.worm_point(place + step, angle) - flank.worm_point(place - step, angle)
    onward = flank.worm_point(place, angle + step) - flank.worm_point(place, angle - step)
    normal = np.cross(along, onward)
    normal /= np.linalg.norm(normal)
    tip = flank.into_worm(contact.point + contact.normal, contact.wheel_angle)
    seen = tip - flank.into_worm(contact.point, contact.wheel_angle)
    assert abs(abs(normal @ seen) - 1) < 1e-9


def gap(flank, contact, x, y):
    """Gap along the common normal over (x, y) of the tangent plane, by Newton's method."""
    line = contact.point + x * contact.across + y * contact.along

    def crossing(point, start):
        """Where a surface of two parameters meets the line along the normal: height above the plane."""
        q = np.array(start)
        for _ in range(30):
            base = point(*q)
            jacobian = []
            for step in np.diag(1e-6 * np.array([1e-2, 1.0])):
                jacobian.append((point(*(q + step)) - point(*(q - step))) / 2)
            matrix = np.array([[j @ contact.across, j @ contact.along] for j in jacobian]).T
            off = base - line
            move = np.linalg.solve(matrix, -np.array([off @ contact.across, off @ contact.along]))
            q = q + move * np.array([1e-8, 1e-6])
            if np.abs(move).max() < 1e-6:
                break
        return (point(*q) - line) @ contact.normal

    def worm(place, angle):
        fixed = flank.worm_point(place, np.asarray(angle))
        return flank.from_worm(fixed, contact.wheel_angle)

    going, side, axis, middle = flank.axes(contact.wheel_angle)

    def roller(place, theta):
        radius, _ = flank.profile(place)
        return middle + place * axis + radius * (np.cos(theta) * going + np.sin(theta) * side)

    here = contact.place
    worm_height = crossing(worm, (here, contact.wheel_angle))
    return worm_height - crossing(roller, (here, contact.theta))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(("place", "angle"), [(-4e-3, 0.15), (0.0, 0.6), (4e-3, 0.95)])
def test_induced_curvature_is_the_second_difference_of_the_gap(kind, place, angle):
    flank = envelope(**kind)
    contact = flank.contact(place, angle)
    h = 2e-5
    ahead, here, behind = (gap(flank, contact, x, 0.0) for x in (h, 0.0, -h))
    assert abs(here) < 1e-15
    assert (ahead + behind) / h**2 == pytest.approx(contact.curvature, rel=1e-5)
    # along the line the gap does not open, nor does it twist
    scale = contact.curvature * h**2
    along = gap(flank, contact, 0.0, h) + gap(flank, contact, 0.0, -h)
    twist = sum(a * b * gap(flank, contact, a * h, b * h) for a in (1, -1) for b in (1, -1)) / 4
    assert abs(along) < 2e-5 * scale
    assert abs(twist) < 2e-5 * scale


@pytest.mark.parametrize("flank", ["driving", "idle"])
@pytest.mark.parametrize("hand", [1, -1])
def test_a_radial_cylinder_is_touched_where_its_axis_moves_square_to_the_normal(flank, hand):
    place, angle = 3e-3, 0.7
    worm = envelope(flank=flank, hand=hand)
    distance = worm.pitch_radius + place
    to_worm = CENTRE_DISTANCE - distance * cos(angle)
    theta = worm.contact(place, angle).theta
    # of the two points across the roller, the one behind or in front
    assert abs(np.tan(theta)) == pytest.approx(distance / (ROLLERS * to_worm), rel=1e-12)
    assert np.cos(theta) * (1 if flank == "idle" else -1) > 0.99


@pytest.mark.parametrize("flank", ["driving", "idle"])
def test_a_ball_sweeps_a_canal(flank):
    """The tube of radius R about the path of the ball's centre, whose curvatures are known."""
    worm = envelope(shape="ball", radius=8e-3, flank=flank)
    angle = 0.5

    def centre(phi):
        *_, middle = worm.axes(np.asarray(phi))
        return worm.into_worm(middle, np.asarray(phi))

    h = 1e-4
    first = (centre(angle + h) - centre(angle - h)) / (2 * h)
    second = (centre(angle + h) - 2 * centre(angle) + centre(angle - h)) / h**2
    speed = np.linalg.norm(first)
    bend = (second - first * (second @ first) / speed**2) / speed**2  # curvature times normal
    for place in (-5e-3, 0.0, 4e-3):
        contact = worm.contact(place, angle)
        away = worm.into_worm(contact.point, contact.wheel_angle) - centre(angle)
        normal = away / np.linalg.norm(away)
        assert abs(normal @ first) / speed < 1e-6
        towards = bend @ normal
        radius = worm.profile.radius
        assert contact.curvature == pytest.approx(1 / (radius * (1 - radius * towards)), rel=1e-6)


@pytest.mark.parametrize("radius", [1e-5, 2e-3, 6.5e-3])
def test_on_a_large_wheel_a_radial_cylinder_cuts_the_offset_of_a_straight_sided_helicoid(radius):
    """A rack of rollers: the ruled helicoid of lead 2 pi p, whose curvatures at r are +-p / (p^2 + r^2).

    Its offset by R leaves 1/R (1 + R^2 kappa^2) / (1 - R^2 kappa^2), kappa = p/(p^2 + r^2).
    """
    pitch, throat, threads = 0.023, 0.032, 3
    rollers = 10**6
    wheel = rollers * pitch / (2 * pi)
    worm = RollerEnvelope(
        RollerProfile(radius, 14e-3),
        rollers / threads,
        wheel + throat,
        wheel,
        0.0,
        0.0,
        "driving",
        -1,
    )
    p = threads * pitch / (2 * pi)
    for place in (-5e-3, 0.0, 5e-3):
        contact = worm.contact(place, 0.0)
        kappa = p / (p**2 + (throat - place) ** 2)
        exact = (1 + (radius * kappa) ** 2) / (1 - (radius * kappa) ** 2) / radius
        assert contact.curvature == pytest.approx(exact, rel=1e-6)
        assert abs(np.tan(contact.theta)) == pytest.approx(p / (throat - place), rel=1e-5)


def test_the_lead_angle_at_the_throat_is_the_source_s():
    worm = envelope()
    lean = atan(abs(np.tan(worm.contact(0.0, 0.0).theta)))
    assert degrees(lean) == pytest.approx(6.52, abs=0.005)


@settings(deadline=None, max_examples=60)
@given(kind=shapes, place=places, angle=angles)
def test_power_balances_at_every_point(kind, place, angle):
    part = section(outer=60.0, **{k: v for k, v in kind.items() if k != "flank"})
    contact = part.envelope.contact(place, angle)
    assert lever(contact) == pytest.approx(ROLLERS * worm_lever(part, contact), rel=1e-9)


def test_right_and_left_section_are_mirrored():
    left, right = section("left"), section("right")
    for place, angle in ((-4e-3, 0.3), (2e-3, 0.9)):
        one, other = left.envelope.contact(place, angle), right.envelope.contact(place, -angle)
        assert one.curvature == pytest.approx(other.curvature, rel=1e-12)
        assert one.point[0] == pytest.approx(-other.point[0], rel=1e-12)


def test_undercut_is_reported_and_real():
    part = section(tilt=pi / 2, inner=10.0)
    with pytest.raises(ValueError, match=r"left section's flank is undercut by .* of wheel angle"):
        check_section(part)
    flank = part.envelope
    place, angle = 4e-3, radians(30)
    assert flank.contact(place, angle).limit < 0
    # the roller cuts the point away a little before or after it would have touched it
    assert swept_distance(flank, place, angle, [angle - 0.01, angle + 0.01]).min() < -1e-6


@pytest.mark.parametrize("name", ["left", "right"])
def test_the_reference_section_is_whole(name):
    """No roller, on its way, cuts away what another place of it has left, and no undercut is told."""
    part = section(name)
    check_section(part)
    swing = np.linspace(-0.02, 0.02, 81)
    for place in (part.lowest, 0.0, part.highest):
        for angle in np.linspace(part.first, part.last, 5):
            distance = swept_distance(part.envelope, place, angle, angle + swing)
            assert abs(distance[40]) < 1e-15
            assert np.delete(distance, 40).min() > 0


@pytest.mark.parametrize("name", ["left", "right"])
def test_contact_lines_end_at_the_faces(name):
    part = section(name)
    before, after = part.faces
    low, high = part.span(np.array([part.first, part.last, (part.first + part.last) / 2]))
    assert low[2] == part.lowest and high[2] == part.highest
    for index, (face, angle) in enumerate(((before, part.first), (after, part.last))):
        cut = low[index] if abs(low[index]) < 1e-9 else high[index]
        assert abs(cut) < 1e-9  # the middle of the roller stands at the face
        assert part.envelope.point(cut, angle)[0] == pytest.approx(face, abs=1e-12)
        assert high[index] - low[index] == pytest.approx(6e-3, abs=1e-9)


def test_rollers_in_mesh_stand_a_pitch_apart_on_the_worm_s_side():
    part = section("left")
    found = part.in_mesh(part.wheel_angle(0.4))
    assert np.allclose(np.diff(found), part.pitch)
    assert (np.abs(found) < pi / 2).all()
    assert part.phase(found).min() > -0.2 and part.phase(found).max() < 1.2
    assert len(found) in (5, 6)
