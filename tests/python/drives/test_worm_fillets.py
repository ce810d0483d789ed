"""Fillets of worm and wheel: where they begin, what they take away, and which do not fit."""

from dataclasses import replace
from math import atan, cos, pi, radians, sin, tan

import numpy as np
import pytest
import scipy
from worm_drawings import SWIVELLED

from pyworm.drives.worm.drawing.drawing import Drawing
from pyworm.drives.worm.drawing.usual_values import completed
from pyworm.drives.worm.flanks.helicoid import Helicoid
from pyworm.drives.worm.flanks.thread_section import form_radius
from pyworm.drives.worm.patterns.hob_setting import drawn_gears, with_swivel
from pyworm.drives.worm.teeth.gear_warnings import gear_warnings
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.drives.worm.teeth.tooth_form import worm_thickness


def drawing(**changes) -> Drawing:
    return completed(SWIVELLED | changes)[0]


def filleted(worm: float, wheel: float) -> WormGears:
    return drawn_gears(drawing(worm_fillet_radius=worm, wheel_fillet_radius=wheel))


def test_the_fillet_of_a_straight_flank_begins_where_the_triangle_has_it():
    """ZA is straight in its axial section, at the pressure angle of its drawing."""
    gears = drawn_gears(completed(SWIVELLED | {"worm_fillet_radius": 1e-3}, "ZA")[0])
    expected = 15.2e-3 + 1e-3 * (1 - sin(radians(20)))
    assert gears.worm_tooth.form_radius == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize(("part", "side"), [("worm", 1), ("hob", -1)])
def test_the_arc_touches_the_flank_of_the_axial_section_at_the_form_radius(part, side):
    """Its centre is a radius from the cylinder, and is moved along the axis until the flank is as far."""
    fillet = 0.9e-3
    gears = filleted(fillet, fillet)
    if part == "worm":
        flank, end, form = gears.worm_flank, 15.2e-3, gears.worm_tooth.form_radius
    else:
        flank, end, form = gears.wheel_flank.hob, 25.6e-3, gears.wheel_tooth.hob_form_radius
    # as the involute helicoid is built: the point at s along the generator is at this height
    radius = np.linspace(form - 0.5e-3, form + 0.5e-3, 20001)
    base = flank.base_radius
    reach = np.sqrt(radius**2 - base**2)
    height = flank.screw * (reach / base - np.arctan(reach / base))
    centre = end + side * fillet

    def apart(along):
        return np.hypot(radius - centre, height - along).min() - fillet

    middle = np.interp(form, radius, height)
    along = scipy.optimize.brentq(apart, middle - side * 0.6e-3, middle - side * 1.5e-3, xtol=1e-15)
    touched = radius[np.argmin(np.hypot(radius - centre, height - along))]
    assert touched == pytest.approx(form, abs=0.2e-6)


def test_flanks_end_where_fillets_begin():
    """The closed form of the pressure angle of an involute helicoid: tan(alpha_x) = p s / (r_b r)."""
    gears = filleted(0.8e-3, 0.8e-3)
    form, worm = gears.worm_tooth.form_radius, gears.worm_flank
    slope = worm.screw * np.sqrt(form**2 - worm.base_radius**2) / (worm.base_radius * form)
    assert form == pytest.approx(15.2e-3 + 0.8e-3 * (1 - sin(atan(slope))), abs=1e-12)
    on_worm = worm.axis_point + form * np.array([1.0, 0.0, 0.0])
    assert gears.worm_tooth.margins(on_worm)["worm root"] == pytest.approx(0, abs=1e-12)
    reach = gears.wheel_tooth.hob_form_radius
    on_wheel = np.array([reach - gears.hob.centre_distance, 0.0, 0.0])
    assert gears.wheel_tooth.margins(on_wheel)["wheel root"] == pytest.approx(0, abs=1e-12)
    # both cylinders of the hob are beyond what has cut the outline of the tooth
    cut = gears.wheel_flank.hob.radius(gears.wheel_flank.cut_point(*gears.rim))
    assert cut.max() <= reach + 1e-9


def test_fillets_within_the_clearance_leave_the_path_of_contact():
    plain, usual, large = filleted(0, 0), filleted(0.8e-3, 0.8e-3), filleted(1.6e-3, 0.8e-3)
    assert plain.worm_tooth.form_radius == 15.2e-3
    assert plain.wheel_tooth.hob_form_radius == plain.hob.tip_radius
    assert (usual.cycle.begin, usual.cycle.end) == (plain.cycle.begin, plain.cycle.end)
    assert gear_warnings(usual) == gear_warnings(plain) == ()
    assert usual.flank_grid.found.sum() < plain.flank_grid.found.sum()
    assert large.cycle.begin_boundary == "worm root"
    assert abs(large.cycle.worm_rotation) < abs(plain.cycle.worm_rotation)
    (said,) = gear_warnings(large)
    assert said.startswith(
        "worm.fillet_radius is 1.6 mm; the fillet begins on a diameter of 32.56 mm"
    )
    assert "the path of contact runs into it" in said


def test_a_tip_that_reaches_below_a_form_diameter_is_told():
    (said,) = gear_warnings(filleted(0, 1.3e-3))
    assert said.startswith("wheel.fillet_radius is 1.3 mm")
    assert "the tip of the worm, which reaches to 152 mm, may touch it" in said


def test_a_fillet_below_the_base_cylinder_takes_nothing_of_the_flank():
    flank = Helicoid(base_radius=9.5e-3, lead=25e-3, centre_distance=0.1)
    assert form_radius(flank, 7e-3, 1e-3, 14e-3) == 9.5e-3
    assert form_radius(flank, 9.4e-3, 1e-3, 14e-3) > 9.5e-3
    with pytest.raises(ValueError, match="leaves no flank"):
        form_radius(flank, 7e-3, 15e-3, 14e-3)


def test_the_usual_fillet_is_told_and_gets_smaller_in_a_narrow_root():
    of, taken = completed(SWIVELLED)
    assert of.worm_fillet_radius == of.wheel_fillet_radius == pytest.approx(0.8e-3)
    told = [one for one in taken if "fillet_radius" in one]
    assert [one.partition(" = ")[0] for one in told] == [
        "worm.fillet_radius",
        "wheel.fillet_radius",
    ]
    assert all("0.8 mm, 0.2 modules or what fits, assumed without a source" in one for one in told)
    narrow = completed(SWIVELLED | {"pressure_angle": radians(28)}, "ZA")[0]
    half = (pi / 4 - 1.2 * tan(radians(28))) * 4e-3
    most = half * cos(radians(28)) / (1 - sin(radians(28)))
    assert narrow.worm_fillet_radius == pytest.approx(0.8 * most)


def steep(profile, threads, diameter_factor, pressure_angle):
    """A drawing of a worm of a large lead angle, with what is usual of its fillets."""
    given = {key: value for key, value in SWIVELLED.items() if not key.startswith("hob_")}
    given |= {"threads": threads, "teeth": 61, "diameter_factor": diameter_factor}
    given |= {"pressure_angle": radians(pressure_angle)}
    given |= {"centre_distance": given["module"] * (diameter_factor + 61 + 1) / 2}
    return completed(given, profile)[0]


@pytest.mark.parametrize(
    ("profile", "threads", "factor", "angle"),
    [("ZI", 5, 10.0, 22), ("ZC2", 5, 10.0, 22), ("ZC2", 6, 9.0, 27), ("ZN", 6, 9.0, 27)],
)
def test_the_usual_fillet_fits_between_threads_of_a_large_lead_angle(
    profile, threads, factor, angle
):
    """Two of 1 / 0.8 of its radius fill the root, the axial section of the flank being as it is."""
    of = steep(profile, threads, factor, angle)
    gears = drawn_gears(with_swivel(of)[0])
    assert gears.worm.fillet_radius == of.worm_fillet_radius <= 0.2 * of.module
    if of.worm_fillet_radius == 0:
        assert worm_thickness(gears, gears.worm.root_radius) >= pi * of.module
    elif of.worm_fillet_radius < 0.2 * of.module:
        full, flank = of.worm_fillet_radius / 0.8, gears.worm_flank
        radius = form_radius(flank, gears.worm.root_radius, full, gears.worm.tip_radius)
        rise = (flank.axial_profile(radius + 1e-8) - flank.axial_profile(radius - 1e-8)) / 2e-8
        assert radius - gears.worm.root_radius == pytest.approx(full * (1 - sin(atan(rise))))
        half = (pi * of.module - worm_thickness(gears, radius)) / 2
        assert full * cos(atan(rise)) == pytest.approx(half)


def test_a_space_that_closes_above_the_root_is_warned_of_and_has_no_fillet():
    """It is the depth of the thread that does not fit, not a fillet, which nobody gave."""
    of = steep("ZC2", 6, 9.0, 23)
    assert of.worm_fillet_radius == 0
    (said,) = (one for one in gear_warnings(drawn_gears(with_swivel(of)[0])) if "root" in one)
    assert said.startswith("worm.root_diameter leaves no room: both flanks of the space")
    with pytest.raises(ValueError, match=r"^worm\.root_diameter leaves no room"):
        with_swivel(replace(of, worm_fillet_radius=0.1e-3))
