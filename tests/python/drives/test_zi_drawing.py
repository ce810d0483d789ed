"""A worm gear by its drawing: the design table that follows, what is taken as usual, form of its teeth."""

from dataclasses import replace
from math import atan2, cos, degrees, pi, sin, sqrt

import numpy as np
import pytest
from worm_drawings import BY_HOB
from zi_drives import changed, sharif

from pyworm.drives.worm.drawing.design import Design
from pyworm.drives.worm.drawing.usual_values import completed
from pyworm.drives.worm.patterns.hob_setting import drawn_gears, with_swivel
from pyworm.drives.worm.teeth.gear_warnings import gear_warnings
from pyworm.drives.worm.teeth.tooth import wheel_radius
from pyworm.drives.worm.teeth.tooth_form import (
    tooth_form_warnings,
    wheel_thickness,
    wheel_tip_thickness,
    worm_thickness,
)
from pyworm.drives.worm.teeth.tooth_outline import flank_places
from pyworm.materials.body import Body
from pyworm.materials.topography import Topography


def drawing(**changes):
    return completed(BY_HOB | changes)[0]


def test_the_design_table_is_that_computed_by_hand():
    """a = 100 mm, 2/41, m 4 mm, q 10, 20 deg; hob 1.6 mm larger: with a pocket calculator, to its digits."""
    of = drawing()
    assert of.worm.base_radius * 1e3 == pytest.approx(9.48695, abs=5e-6)
    assert of.worm.lead * 1e3 == pytest.approx(25.13274, abs=5e-6)
    assert degrees(of.worm.base_lead_angle) == pytest.approx(22.8618, abs=5e-5)
    assert of.hob.base_radius * 1e3 == pytest.approx(9.56851, abs=2e-5)
    assert of.hob.lead * 1e3 == pytest.approx(25.09490, abs=1e-5)
    assert degrees(of.hob.base_lead_angle) == pytest.approx(22.6561, abs=5e-5)
    assert degrees(of.hob.swivel) == pytest.approx(0.4404, abs=5e-5)
    assert of.hob.centre_distance * 1e3 == pytest.approx(100.8)
    assert of.profile_shift == pytest.approx(-0.5)
    radii = of.worm.tip_radius, of.worm.root_radius, of.wheel.throat_radius, of.wheel.tip_radius
    assert radii == pytest.approx((24e-3, 15.2e-3, 84e-3, 86e-3))


@pytest.mark.parametrize("oversize", [0.0, 0.5e-3, 3e-3])
def test_hob_and_worm_have_one_base_pitch_and_one_normal_in_the_pitch_point(oversize):
    of = drawing(hob_oversize=oversize)
    gears = drawn_gears(with_swivel(of)[0])
    worm, hob = gears.base_pitches
    assert hob == pytest.approx(worm, rel=1e-12)

    def normal(radius, lead, base, swivel):
        """Of a flank on a cylinder over polar angle zero, which is the line of centres."""
        base_angle = atan2(lead, 2 * pi * base)
        theta = -atan2(sqrt(radius**2 - base**2), base)
        x, y, z = (
            sin(base_angle) * sin(theta), -sin(base_angle) * cos(theta), cos(base_angle)
        )  # fmt: skip
        return x, cos(swivel) * y - sin(swivel) * z, sin(swivel) * y + cos(swivel) * z

    pitch = of.reference_diameter / 2
    of_worm = normal(pitch, of.lead, of.base_radius, 0.0)
    of_hob = normal(pitch + oversize / 2, of.hob.lead, of.hob.base_radius, of.normal_swivel)
    assert of_hob == pytest.approx(of_worm, abs=1e-12)


def test_what_is_left_out_is_taken_as_usual_and_told():
    least = {key: BY_HOB[key] for key in list(BY_HOB)[:5]}
    of, taken = completed(least)
    assert degrees(of.pressure_angle) == pytest.approx(20)
    assert of.hob_oversize == pytest.approx(0.8e-3)
    assert of.face_width == pytest.approx(8e-3 * (0.5 + sqrt(11)))
    told = {one.partition(" = ")[0] for one in taken}
    assert {"pressure_angle", "hob.oversize", "face_width", "worm.tip_diameter"} <= told
    assert not told & {"module", "teeth", "centre_distance"}
    assert "hob.oversize = 0.8 mm, 2 % of the worm's reference diameter" in taken


def test_a_given_number_is_neither_changed_nor_told():
    of, taken = completed(BY_HOB | {"worm_tip_diameter": 47e-3, "backlash": 0.2e-3})
    assert of.worm_tip_diameter == 47e-3 and of.backlash == 0.2e-3
    assert not [one for one in taken if one.startswith(("worm.tip_diameter", "backlash"))]


def test_a_steep_worm_gets_a_swivel_by_which_it_does_not_cut_into_its_wheel():
    """With the difference of the lead angles it would, by ten micrometres and more."""
    of, _ = completed(
        {
            "centre_distance": 0.075,
            "threads": 4,
            "teeth": 28,
            "module": 4e-3,
            "diameter_factor": 9.0,
        }
    )
    plain = drawn_gears(replace(of, hob_swivel=of.normal_swivel)).interference
    assert plain is not None and plain.depth > 5e-6
    found, words = with_swivel(of)
    assert found.hob_swivel < of.normal_swivel
    assert drawn_gears(found).interference is None
    assert "would cut into the wheel" in words


def test_a_worm_that_no_swivel_fits_is_refused_with_the_least_cut(monkeypatch):
    monkeypatch.setattr("pyworm.drives.worm.patterns.hob_setting.FRACTIONS", (1.0, 0.99))
    of, _ = completed(
        {"centre_distance": 0.16, "threads": 4, "teeth": 36, "module": 7e-3, "diameter_factor": 9.0}
    )
    with pytest.raises(
        ValueError, match=r"^hob\.swivel is not given, and none from 0\.49\d* to"
    ) as refused:
        with_swivel(of)
    depths = [
        drawn_gears(replace(of, hob_swivel=part * of.normal_swivel)).interference.depth
        for part in (1.0, 0.99)
    ]
    assert f"cut {min(depths) * 1e6:.1f} um or more" in str(refused.value)


def space_half_width(gears):
    """Half the wheel's space on its reference circle, by the mesh itself [m].

    The middle of the thread is over the line of centres; the wheel is turned until it touches one flank.
    """
    worm, flank = gears.worm_flank, gears.wheel_flank
    radius = gears.reference_radius
    across = sqrt(radius**2 - worm.base_radius**2)
    theta = -atan2(across, worm.base_radius)
    advance = worm.screw * theta + across * np.tan(worm.base_lead_angle)
    angle = (
        advance + gears.worm.thickness / 2
    ) / worm.screw  # flank half a thickness below the middle
    at, wheel = gears.cycle.angles((gears.cycle.begin + gears.cycle.end) / 2)
    turned = wheel + gears.cycle.speed_ratio * (angle - at)
    reference = gears.wheel_reference_radius
    q = flank_places(flank, gears.within, np.array([[reference], [0.0]]))
    point = flank.point(*q, wheel_angle=turned)
    assert wheel_radius(point) == pytest.approx(reference)
    arc = reference * float(np.arctan2(point[2], -point[0])[0])
    pitch = pi * gears.module
    return abs((arc + pitch / 2) % pitch - pitch / 2)


@pytest.mark.parametrize("shift", [-0.5, 0.0, 0.4])
def test_threads_teeth_and_backlash_fill_the_pitch(shift):
    """A wheel cut by the worm's own likeness: its space is what the mesh leaves between two threads."""
    distance = 4e-3 * (51 / 2 + shift)
    of = drawing(centre_distance=distance, hob_oversize=0.0, backlash=0.2e-3)
    gears = drawn_gears(with_swivel(of)[0])
    space = pi * gears.module - wheel_thickness(gears) - 0.2e-3
    assert space == pytest.approx(2 * space_half_width(gears), abs=1e-6)


def test_teeth_and_threads_are_thinner_at_their_tips():
    gears = drawn_gears(with_swivel(drawing())[0])
    along, thickness = wheel_tip_thickness(gears)
    middle = thickness[len(along) // 2]
    assert 0 < middle < wheel_thickness(gears)
    assert thickness == pytest.approx(thickness[::-1], rel=1e-9)  # both flanks are one
    assert (
        0 < worm_thickness(gears, 24e-3) < worm_thickness(gears, 20e-3) == pytest.approx(2e-3 * pi)
    )
    assert tooth_form_warnings(gears) == ()


def test_pointed_threads_and_teeth_are_told():
    far = drawn_gears(
        with_swivel(
            drawing(worm_tip_diameter=47e-3, worm_thickness=2.6e-3, wheel_root_diameter=150e-3)
        )[0]
    )
    assert worm_thickness(far, 23.5e-3) < 0
    assert any(one.startswith("worm: its threads are pointed") for one in gear_warnings(far))
    thin = drawn_gears(with_swivel(drawing(worm_thickness=9.9e-3))[0])
    assert np.nanmin(wheel_tip_thickness(thin)[1]) < 0
    assert any(one.startswith("wheel: its teeth are pointed") for one in gear_warnings(thin))


def test_the_groove_of_the_throat_is_where_the_drawing_has_it():
    gears = drawn_gears(with_swivel(drawing(wheel_groove_radius=18e-3))[0])
    tooth = gears.wheel_tooth
    assert tooth.tip(np.zeros(1)) == pytest.approx(84e-3)
    y = 5e-3
    radius = 84e-3 + 18e-3 - sqrt(18e-3**2 - y**2)
    assert tooth.tip(np.array([y])) == pytest.approx(radius)
    at = np.array([-radius, y, 0.0])
    assert tooth.margins(at)["wheel throat"] == pytest.approx(0, abs=1e-15)


def test_a_design_table_reads_its_groove_as_concentric_with_the_hob():
    plain = sharif().wheel_tooth
    hob = plain.hob.centre_distance - plain.throat_radius
    given = sharif(wheel=changed(sharif().wheel, groove_radius=hob)).wheel_tooth
    along = np.linspace(-25e-3, 25e-3, 7)
    assert given.tip(along) == pytest.approx(plain.tip(along), rel=1e-12)


def test_the_lay_of_a_left_hand_drive_is_mirrored():
    bodies = tuple(
        Body(200e9, 0.3, roughness=1e-6, roughness_aspect=3.0, lay=lay) for lay in (0.2, 0.0)
    )
    of = drawing()
    parts = of.worm, of.wheel, of.hob, of.centre_distance
    worm, wheel = Design(*parts, "left").seen(bodies)
    assert worm.lay == pytest.approx(pi - 0.2) and wheel.lay == 0
    assert Design(*parts).seen(bodies) == bodies


def test_the_heights_of_a_left_hand_drive_are_mirrored():
    ridge = np.outer(np.arange(3.0), np.ones(4)) + np.arange(4.0)
    heights = Topography(ridge, (1e-6, 1e-6), x_direction=0.3)
    body = Body(200e9, 0.3, roughness=1e-6, topography=heights)
    of = drawing()
    worm, _ = Design(of.worm, of.wheel, of.hob, of.centre_distance, "left").seen((body, body))
    assert worm.topography.x_direction == -0.3
    assert np.all(worm.topography.height == ridge[:, ::-1])
    assert worm.topography.mirrored == heights
