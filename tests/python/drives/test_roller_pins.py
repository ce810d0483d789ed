"""Indices of the mesh, and loads and losses of the rollers' pins, against balances and closed forms."""

from dataclasses import replace
from math import cos, pi, radians, tan

import numpy as np
import pytest
from folders import CASES
from roller_sections import CENTRE_DISTANCE, ROLLERS, envelope

import pyworm
from pyworm.drives.roller_worm.envelope import cross
from pyworm.drives.roller_worm.indices import lubrication_angle, self_rotation_angle
from pyworm.drives.roller_worm.load_sharing import slices
from pyworm.drives.roller_worm.motion import FREE_OF_FRICTION, Pin
from pyworm.drives.roller_worm.pins import pin_bearing, pin_load
from pyworm.formulas.bearing_life import basic_life
from pyworm.ratings.bearing import bearing_life, carried_load
from pyworm.ratings.element_bearing import element_load, rate_element_bearing
from pyworm.ratings.motion import rate_motion
from pyworm.ratings.rated_case import rating_request

SEATS = [
    {},
    {"tilt": 0.3},
    {"shape": "cone", "half_angle": 0.1},
    {"tilt": pi / 2, "height": -0.032},
]


@pytest.fixture(scope="module")
def case():
    return pyworm.load(CASES / "rollers" / "double.toml")


@pytest.fixture(scope="module")
def drive(case):
    return case.drive


@pytest.mark.parametrize("seat", SEATS)
def test_angles_are_those_of_vectors_by_differences(seat):
    """The contact line and the relative velocity by differences of positions alone."""
    flank, place, angle, h = envelope(**seat), 2e-3, 0.5, 1e-6
    line = flank.point(place + h, angle) - flank.point(place - h, angle)
    fixed = flank.into_worm(flank.point(place, angle), np.asarray(angle))
    moved = [flank.from_worm(fixed, np.asarray(angle + side * h)) for side in (1, -1)]
    # a point of the wheel goes with it
    x, y, _ = flank.point(place, angle)
    velocity = (moved[0] - moved[1]) / (2 * h) - np.array([y, -x, 0.0])
    axis = flank.axes(np.asarray(angle))[2]

    def between(a, b):
        across = np.linalg.norm(np.cross(a, b))
        return np.arctan2(across, abs(a @ b))

    contact = flank.contact(place, angle)
    assert lubrication_angle(flank, contact) == pytest.approx(between(line, velocity), abs=1e-7)
    assert self_rotation_angle(flank, contact) == pytest.approx(between(axis, velocity), abs=1e-7)


def test_a_radial_roller_at_the_throat_slides_by_the_height_of_its_contact():
    """Along the axis a roller slides by what the worm moves at the height to which its contact is turned."""
    flank = envelope()
    contact = flank.contact(np.array([-4e-3, 0.0, 4e-3]), 0.0)
    s = flank.pitch_radius + contact.place
    lead = s / (ROLLERS * (CENTRE_DISTANCE - s))  # equation 3
    off = flank.profile.radius / np.hypot(1, lead)
    along = off * (1 + ROLLERS * lead)
    whole = np.sqrt(s**2 + along**2 + (ROLLERS * (CENTRE_DISTANCE - s)) ** 2)
    assert self_rotation_angle(flank, contact) == pytest.approx(np.arccos(along / whole), abs=1e-9)


def test_forces_on_the_pins_make_the_torque_of_the_wheel(drive):
    """Normal loads and shears of a section about the wheel's axis; without shear exactly the torque."""
    still = replace(drive, oil=replace(drive.oil, flow=None), rolling="rolling")
    section = still.sections["left"]
    angle = float(section.wheel_angle(0.5))
    shared = still.shared("left", angle)
    torque, radial = 0.0, []
    for number, place in enumerate(shared.wheel_angles):
        contact, lengths = slices(section, np.array(place))
        force = shared.load(contact, number) * lengths * -contact.normal
        torque += float(cross(contact.point, force)[2].sum())
        whole = force.sum(axis=1)
        axis = section.envelope.axes(np.array(place))[2]
        radial.append(np.linalg.norm(np.cross(whole, axis)))
        pin = pin_load(still, "left", float(section.phase(place)))
        assert pin.radial == pytest.approx(radial[-1], rel=1e-9)
        # a cylinder's normals have no part along it, and without shear nothing is lost
        assert abs(pin.axial) < 1e-9 * pin.radial
        assert pin.turning_loss == pin.axial_loss == 0
    assert abs(torque) == pytest.approx(still.wheel_torque("left"), rel=1e-9)


def test_a_cone_is_pushed_along_its_axis_by_its_half_angle():
    cone = pyworm.load(CASES / "rollers" / "cone.toml").drive
    still = replace(cone, oil=replace(cone.oil, flow=None), rolling="rolling")
    pin = pin_load(still, "left", 0.5)
    assert abs(pin.axial) / pin.radial == pytest.approx(tan(radians(6)), rel=1e-3)


def test_the_film_turns_a_roller_with_the_power_that_its_pin_takes(drive):
    """The worm gives a roller's film its power: what that loses, and what the pin's friction takes."""
    section = drive.sections["left"]
    for phase in (0.3, 0.6):
        pin = pin_load(drive, "left", phase)
        angle = float(section.wheel_angle(phase))
        contact, lengths = slices(section, np.array(angle))
        shared = drive.shared("left", angle)
        load = shared.load(contact, shared.roller(angle)) * lengths
        assert pin.pin_loss == pytest.approx(0.0025 * 3e-3 * load.sum() * abs(pin.speed), rel=1e-9)
        # along a roller the worm slides by its speed at the height of the contact
        along = drive.speed * np.average(contact.point[2], weights=load) * cos(angle)
        assert pin.axial_loss / abs(pin.axial) == pytest.approx(along, rel=0.05)


def test_the_mean_load_is_that_of_equal_life(drive):
    found = pin_bearing(drive)
    pins = [pin_load(drive, "left", (n + 0.5) / 12) for n in range(12)]
    wear = sum(abs(pin.speed) / basic_life(1e5, pin.radial, "roller") for pin in pins)
    even = sum(abs(pin.speed) for pin in pins) / basic_life(1e5, found.radial, "roller")
    assert wear == pytest.approx(even, rel=1e-9)
    turned = np.mean([abs(pin.speed) for pin in pins]) * (2 * 45 / 360)
    assert found.speed == pytest.approx(turned, rel=1e-9)
    assert found.radial < found.radial_max


def test_pins_without_friction_lose_nothing_and_friction_is_in_the_efficiency(drive):
    free = replace(drive, rollers=replace(drive.rollers, pin=FREE_OF_FRICTION))
    assert pin_bearing(free).losses["pins"] == 0
    rough = replace(drive, rollers=replace(drive.rollers, pin=Pin(3e-3, 5e-3)))
    once, twice = (pin_bearing(one).losses["pins"] for one in (drive, rough))
    assert twice == pytest.approx(2 * once, rel=0.05)
    rating = rate_element_bearing(pin_bearing(drive))
    values = {figure.key: figure.values[0] for figure in rating.figures}
    assert values["loss_W"] == pytest.approx(sum(values[f"loss_{n}_W"] for n in range(3)))


def in_rpm(row, part, drive):
    """A speed in SI that rolling makes plausible, shown in rpm."""
    speed = abs(row.values[part])
    # rollers of 6.5 mm on a worm of 32 mm at the throat and some 80 mm at its ends
    assert drive.speed * 32 / 6.5 < speed < drive.speed * 90 / 6.5
    assert float(row.shown(part).split()[0]) == pytest.approx(row.values[part] * 30 / pi, rel=1e-3)


def test_speeds_of_pins_are_kept_in_si_and_shown_in_rpm(drive):
    rows = {row.key: row for row in rate_element_bearing(pin_bearing(drive)).figures}
    in_rpm(rows["speed_max_rad_s"], 0, drive)


@pytest.mark.long
def test_speeds_of_the_rotation_are_kept_in_si_and_shown_in_rpm(drive):
    rows = {row.key: row for row in rate_motion(drive.motion_figures()).figures}
    in_rpm(rows["rolling_speed_rad_s"], 1, drive)


def test_the_needle_bearing_is_rated_by_its_roller(case):
    request = rating_request(case)
    table = request.tables.bearings["needles"]
    element = request.bearing_element(table)
    assert request.bearing_speed(table) == element.speed
    rated = bearing_life(table, request.directory, carried_load(table, element_load(element)))
    assert rated.load == element.radial
    assert rated.basic_life == pytest.approx((4e3 / element.radial) ** (10 / 3) * 1e6)
    assert rated.basic_hours == pytest.approx(rated.basic_life * 2 * pi / element.speed / 3600)


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        (
            'shaft = "roller"',
            'shaft = "roller"\nside = "thrust"',
            "a bearing of each roller has no side",
        ),
        ('shaft = "roller"', 'shaft = "worm"', "give shaft and side together"),
    ],
)
def test_a_bearing_of_rollers_has_no_side(tmp_path, old, new, sentence):
    file = tmp_path / "case.toml"
    file.write_text((CASES / "rollers" / "double.toml").read_text().replace(old, new))
    with pytest.raises(pyworm.CaseError, match=sentence):
        pyworm.load(file)
