"""Gap, curvatures and velocities over the tangent plane."""

import time
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from folders import DATA
from scipy.optimize import brentq, root
from worm_drawings import of_profile
from zi_drives import WHEEL, WORM, changed, sharif

import pyworm
from pyworm.drives.worm.drawing.design import ParabolicRelief
from pyworm.drives.worm.drawing.usual_values import completed
from pyworm.drives.worm.flanks.flank_height import OUTLINE_RAYS
from pyworm.drives.worm.flanks.point_cache import PointCache
from pyworm.drives.worm.patterns.hob_setting import drawn_gears, with_swivel
from pyworm.drives.worm.teeth.gear_warnings import gear_warnings
from pyworm.drives.worm.teeth.tooth_form import flank_start

PHASES = (0.0, 0.3, 0.5, 1.0)


def window(half_x, half_y, count):
    return np.meshgrid(
        np.linspace(-half_x, half_x, count), np.linspace(-half_y, half_y, count), indexing="ij"
    )


@pytest.mark.parametrize("phase", PHASES)
def test_the_contact_frame_is_right_handed_along_the_normal(phase):
    contact = sharif().contact(phase)
    np.testing.assert_allclose(contact.axes @ contact.axes.T, np.eye(3), rtol=0, atol=1e-14)
    assert np.linalg.det(contact.axes) == pytest.approx(1)
    assert contact.radii[0] > contact.radii[1] > 0
    worm_motion, wheel_motion = sharif().scene(phase).motions
    assert worm_motion(0.0, 0.0)[0] > 0
    # larger worm radius at the top, the wheel moving down (Sharif et al. 2001, Figs 2 and 13)
    assert contact.y_axis[0] > 0
    assert wheel_motion(0.0, 0.0)[1] < 0


@pytest.mark.parametrize("phase", PHASES)
def test_curvatures_agree_with_second_differences_of_the_gap(phase):
    scene = sharif().scene(phase)
    exact = np.array([[1 / scene.radii[0], 0.0], [0.0, 1 / scene.radii[1]]])
    errors = []
    for h in (8e-4, 4e-4, 2e-4):
        x, y = window(h, h, 3)
        gap = scene.gap(x, y)[0]
        xx = (gap[2, 1] - 2 * gap[1, 1] + gap[0, 1]) / h**2
        yy = (gap[1, 2] - 2 * gap[1, 1] + gap[1, 0]) / h**2
        xy = (gap[2, 2] - gap[2, 0] - gap[0, 2] + gap[0, 0]) / (4 * h**2)
        errors.append(np.max(np.abs(np.array([[xx, xy], [xy, yy]]) - exact)))
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    np.testing.assert_allclose(orders, 2.0, atol=0.05)
    assert errors[-1] < 1e-3 * exact[1, 1]


def test_slopes_and_curvatures_of_each_flank_away_from_the_contact():
    contact = sharif().contact(0.5)
    for flank in (contact.worm_height, contact.wheel_height):
        x, y, h = np.array([0.006, -0.01]), np.array([-0.002, 0.003]), 2e-5
        _, q, _ = flank.solve(x, y)
        height, slope, bend = flank.expansion(q, x, y)
        east, west = flank.solve(x + h, y)[0], flank.solve(x - h, y)[0]
        north, south = flank.solve(x, y + h)[0], flank.solve(x, y - h)[0]
        np.testing.assert_allclose(slope[0], (east - west) / (2 * h), rtol=0, atol=1e-7)
        np.testing.assert_allclose(slope[1], (north - south) / (2 * h), rtol=0, atol=1e-7)
        np.testing.assert_allclose(
            bend[0, 0], (east - 2 * height + west) / h**2, rtol=1e-6, atol=1e-5
        )
        np.testing.assert_allclose(
            bend[1, 1], (north - 2 * height + south) / h**2, rtol=1e-6, atol=1e-5
        )


@pytest.mark.parametrize("phase", PHASES)
def test_gap_is_nowhere_negative(phase):
    x, y = window(0.025, 0.012, 129)
    gap, covered = sharif().scene(phase).gap(x, y)
    assert np.all(np.isfinite(gap))
    assert gap.min() > -1e-15
    assert covered.any()
    assert covered[64, 64]


def worm_height_by_involute(drive, contact, x, y):
    """Height of the worm from its explicit involute, one point at a time."""
    base = contact.point + x * contact.x_axis + y * contact.y_axis - drive.worm_flank.axis_point

    def miss(height):
        px, py, pz = base + height * contact.normal
        pressure = np.arccos(drive.worm.base_radius / np.hypot(px, py))
        turn = np.arctan2(py, px) - contact.worm_angle + np.tan(pressure) - pressure
        return pz - drive.worm.lead / (2 * np.pi) * turn

    return brentq(miss, -4e-3, 4e-3, xtol=1e-15)


def wheel_height_by_generation(drive, contact, x, y, guess):
    """Height of the wheel from points of the hob that leave the wheel's tooth no normal velocity."""
    flank, hob = drive.wheel_flank, drive.wheel_flank.hob
    across = contact.axes
    hob_axis = hob.axes[:, 2]

    def place(theta, along, hob_angle):
        cut = hob.point(theta, along, hob_angle)
        turn = flank.ratio * hob_angle - contact.wheel_angle
        cos, sin = np.cos(turn), np.sin(turn)
        matrix = np.array([[cos, 0, sin], [0, 1, 0], [-sin, 0, cos]])
        return cut, across @ (matrix @ cut - contact.point)

    def miss(unknown):
        theta, along, hob_angle = unknown[0], unknown[1] * 0.03, unknown[2]
        cut, here = place(theta, along, hob_angle)
        slide = np.cross(hob_axis, cut - hob.axis_point) + np.cross([0, flank.ratio, 0], cut)
        lift = 1e-5
        along_theta = hob.point(theta + lift, along) - hob.point(theta - lift, along)
        along_line = hob.point(theta, along + lift) - hob.point(theta, along - lift)
        normal = np.cross(along_theta, along_line)
        normal /= np.linalg.norm(normal)
        return np.array([here[0] - x, here[1] - y, normal @ slide]) * 1e3

    found = root(miss, guess, method="hybr", options={"xtol": 1e-13})
    theta, along, hob_angle = found.x[0], found.x[1] * 0.03, found.x[2]
    assert np.max(np.abs(found.fun)) < 1e-8
    return place(theta, along, hob_angle)[1][2]


@pytest.mark.parametrize("phase", (0.1, 0.5))
def test_gap_agrees_with_an_independent_evaluation(phase):
    drive = sharif()
    contact = drive.contact(phase)
    gap = drive.gap(contact)
    hob = drive.wheel_flank.hob
    line = drive.cycle.path.line
    roll = line.lag + contact.wheel_angle
    cut = drive.wheel_flank.cut_point(line.hob_theta, roll)
    own = hob.axes.T @ (cut - hob.axis_point)
    along = np.sqrt(own[0] ** 2 + own[1] ** 2 - hob.base_radius**2) / np.cos(hob.base_lead_angle)
    guess = np.array([line.hob_theta, along / 0.03, roll / drive.ratio])
    for x, y in (
        (0, 0),
        (4e-3, 1e-3),
        (-8e-3, 1e-3),
        (12e-3, -2e-3),
        (-12e-3, -3e-3),
        (2e-3, 5e-3),
    ):
        worm = worm_height_by_involute(drive, contact, x, y)
        wheel = wheel_height_by_generation(drive, contact, x, y, guess)
        assert abs(gap(x, y)[0] - (wheel - worm)) < 1e-10


def test_gap_is_the_same_whatever_window_asks():
    scene = sharif().scene(0.5)
    x, y = window(0.02, 0.006, 65)
    whole = scene.gap(x, y)[0]
    single = [float(scene.gap(x[i, j], y[i, j])[0]) for i, j in ((3, 60), (32, 32), (64, 0))]
    np.testing.assert_allclose(single, [whole[3, 60], whole[32, 32], whole[64, 0]], atol=1e-15)


def test_tip_relief_is_taken_off_towards_the_tips():
    relief = ParabolicRelief(20e-6, 3e-3)
    plain = sharif()
    relieved = sharif(
        worm=changed(WORM, tip_relief=relief), wheel=changed(WHEEL, tip_relief=relief)
    )
    x, y = window(0.02, 0.012, 65)
    for phase in (0.05, 0.5, 0.95):
        contact = relieved.contact(phase)
        more = relieved.gap(contact)(x, y)[0] - plain.gap(plain.contact(phase))(x, y)[0]
        expected = np.zeros(x.shape)
        for flank, tooth in (
            (contact.worm_height, relieved.worm_tooth),
            (contact.wheel_height, relieved.wheel_tooth),
        ):
            height = flank.solve(x, y)[0]
            point = contact.point + np.moveaxis(np.stack([x, y, height]), 0, -1) @ contact.axes
            point = np.moveaxis(point, -1, 0)
            depth = {
                name: margin for name, margin in tooth.margins(point).items() if "root" not in name
            }
            depth.pop("wheel face", None)
            into = np.maximum(3e-3 - np.minimum.reduce(list(depth.values())), 0.0)
            expected += 20e-6 * (into / 3e-3) ** 2
        np.testing.assert_allclose(more, expected, rtol=0, atol=1e-15)
        assert more.max() > 0
    assert relieved.gap(relieved.contact(0.5))(0.0, 0.0)[0] < 1e-15


def test_the_gap_is_continued_beyond_the_teeth():
    scene = sharif().scene(0.5)
    x, y = window(0.06, 0.04, 81)
    gap, covered = scene.gap(x, y)
    assert np.all(np.isfinite(gap))
    assert not covered[0].any() and not covered[-1].any()
    # without a jump, also where the worm's flank ends at its base cylinder
    line = np.linspace(-0.04, 0.04, 4001)
    fine, _ = scene.gap(0 * line, line)
    steps = np.diff(fine, 2) / (line[1] - line[0]) ** 2
    assert np.max(np.abs(steps)) < 500


def test_heights_are_cached_while_there_is_room():
    kept, asked = PointCache(10), []

    def ask(count, value):
        points = np.full(count, value), np.zeros(count)
        return kept.recall(points, lambda: asked.append(value) or value)

    assert [ask(4, 1.0), ask(4, 2.0), ask(4, 1.0), ask(2, 3.0)] == [1.0, 2.0, 1.0, 3.0]
    assert asked == [1.0, 2.0, 3.0]
    ask(4, 4.0)  # room for it is made by what was not asked for longest
    ask(4, 1.0)
    ask(20, 5.0)  # kept alone, larger than all room
    ask(20, 5.0)
    ask(4, 1.0)
    assert asked == [1.0, 2.0, 3.0, 4.0, 5.0, 1.0]


@pytest.mark.parametrize("phase", (-0.2, 0.3, 1.1))
def test_a_flank_is_continued_along_rays_without_a_jump(phase):
    """Newton's method from afar must find the part of the flank that the contact lies on."""
    contact = sharif().cycle.contact(phase)
    angle = np.linspace(0, 2 * np.pi, 37)[:, None]
    reach = np.linspace(0, 0.045, 451)
    for flank in (contact.worm_height, contact.wheel_height):
        height, q, exists = flank.solve(reach * np.cos(angle), reach * np.sin(angle))
        on_flank = np.logical_and.accumulate(exists, axis=1)
        both = on_flank[:, 1:] & on_flank[:, :-1]
        assert on_flank[:, 20].all() and not on_flank.all()
        for part in q:
            assert np.abs(np.diff(part, axis=1))[both].max() < 0.05
        assert np.abs(np.diff(height, axis=1))[both].max() < 1e-4


@pytest.mark.parametrize("phase", (0.3, 0.7, 1.1))
def test_many_points_beyond_the_end_of_a_flank_are_continued_as_a_few_are(phase):
    """Many take its end between rays that they share, a few along a ray of their own."""
    contact = sharif().cycle.contact(phase)
    angle = np.linspace(0, 2 * np.pi, 180, endpoint=False)[:, None] + 1e-3
    reach = np.linspace(0.005, 0.045, 40)
    x, y = (reach * np.cos(angle)).ravel(), (reach * np.sin(angle)).ravel()
    for flank in (contact.worm_height, contact.wheel_height):
        height, _, exists = flank.solve(x, y)
        assert np.sum(~exists) > OUTLINE_RAYS  # else all have a ray of their own
        beyond = np.flatnonzero(~exists)[::20]
        for some in (beyond[:500], np.flatnonzero(exists)[::20][:500]):
            few, _, on_flank = flank.solve(x[some], y[some])
            np.testing.assert_array_equal(on_flank, exists[some])
            np.testing.assert_allclose(height[some], few, rtol=0, atol=5e-6)


def test_a_flank_that_ends_at_its_contact_point_is_continued_from_there_at_once():
    """Its height is that of the curvatures."""
    worm = drawn_gears(of_profile("ZN")).cycle.contact(0.3).worm_height
    there = replace(worm.surface.numbers, bounds=(worm.start[0], worm.start[0]))
    flank = replace(worm, surface=SimpleNamespace(numbers=there))
    x, y = window(0.01, 0.005, 7)
    height, _, exists = flank.solve(x, y)
    assert not exists.any()
    (xx, xy), (_, yy) = flank.curvatures
    expected = (xx * x**2 + 2 * xy * x * y + yy * y**2) / 2
    np.testing.assert_allclose(height, expected, rtol=0, atol=1e-15)


@pytest.mark.parametrize("phase", (-0.2, 0.1, 0.4))
def test_the_worm_ends_on_the_ray_near_its_base_helix(phase):
    """There the generator has a tenth of its length from the base helix to the contact point."""
    drive = sharif()
    worm, contact = drive.worm_flank, drive.cycle.contact(phase)
    angle = np.linspace(0, 2 * np.pi, 73)
    x, y = 0.04 * np.cos(angle), 0.04 * np.sin(angle)
    _, (theta,), exists = contact.worm_height.solve(x, y)
    ended = ~exists & (np.abs(theta - contact.worm_height.start[0]) < 1.5)
    assert ended.sum() > 10
    x, y, theta = x[ended], y[ended], theta[ended]
    along = np.sqrt(worm.radius(contact.point) ** 2 - worm.base_radius**2)
    along = along / np.cos(worm.base_lead_angle)
    # det T_ij is this length over normal . ez, which is -1 at the contact point
    along = -0.1 * along * (contact.normal @ worm.normals(theta)[0])
    end = worm.point(theta, along, contact.worm_angle) - contact.point[:, None]
    seen = contact.axes[:2] @ end
    np.testing.assert_allclose(seen[0] * y - seen[1] * x, 0, atol=1e-8 * 0.04)
    share = (seen[0] * x + seen[1] * y) / 0.04**2
    assert np.all((share > 0) & (share < 1))


def test_beyond_its_end_a_flank_moves_as_its_last_point_does():
    """As continued it is so far off that the worm would turn backwards there.

    Heat led along such ways grew without bound: drive 5 of seed 82001 lost its transient solution.
    """
    contact = sharif().cycle.contact(0.1)
    flank, (motion, _) = contact.worm_height, sharif().scene(0.1).motions
    angle = np.linspace(0, 2 * np.pi, 37)[:, None]
    reach = np.linspace(0, 0.08, 321)
    x, y = reach * np.cos(angle), reach * np.sin(angle)
    height, _, exists = flank.solve(x, y)
    moving = flank.moving(x, y)
    np.testing.assert_array_equal(moving[exists], height[exists])
    assert 0 < exists.mean() < 1
    farthest = np.abs(height[exists]).max()
    assert np.abs(moving).max() < 1.02 * farthest
    assert np.abs(height).max() > 2 * farthest
    # over the tangent plane the worm's surface turns about y with its height
    about_y = abs(motion.rotation @ contact.axes[1])
    plane = motion(0 * x, 0 * y)[0] - (motion.rotation @ contact.axes[2]) * y
    assert np.abs(motion(x, y)[0] - plane).max() < 1.02 * about_y * farthest


def test_a_window_takes_well_below_a_second():
    scene = sharif().scene(0.5)
    x, y = window(0.018, 0.005, 257)
    begin = time.perf_counter()
    scene.gap(x, y)
    assert time.perf_counter() - begin < 3.0


@pytest.mark.parametrize("phase", PHASES)
def test_velocities_agree_with_positions_in_time(phase):
    drive = sharif()
    contact = drive.contact(phase)
    scene = drive.scene(phase)
    dt = 1e-6
    span = drive.cycle.worm_rotation / drive.speed
    ahead, behind = (drive.cycle.contact(phase + s * dt / span, drive.speed) for s in (1, -1))
    np.testing.assert_allclose(
        (ahead.point - behind.point) / (2 * dt), contact.velocity, rtol=0, atol=1e-7
    )
    assert (ahead.worm_angle - behind.worm_angle) / (2 * dt) == pytest.approx(drive.speed, rel=1e-8)

    x, y = np.array([0.0, 5e-3, -9e-3]), np.array([0.0, 1e-3, -2e-3])
    flanks = contact.worm_height, contact.wheel_height
    for motion, flank, angle, about, centre in zip(
        scene.motions,
        flanks,
        ("worm_angle", "wheel_angle"),
        (np.array([0.0, 0.0, 1.0]), np.array([0.0, -1.0, 0.0])),
        (drive.worm_flank.axis_point, np.zeros(3)),
        strict=True,
    ):
        height = flank.solve(x, y)[0]
        point = contact.point[:, None] + contact.axes.T @ np.stack([x, y, height])

        def turned(turn, point=point, about=about, centre=centre):
            arm = point - centre[:, None]
            along = np.outer(about, about @ arm)
            across = np.cross(about, arm, axisb=0, axisc=0)
            return centre[:, None] + along + np.cos(turn) * (arm - along) + np.sin(turn) * across

        late, early = (turned(getattr(c, angle) - getattr(contact, angle)) for c in (ahead, behind))
        velocity = (late - early - (ahead.point - behind.point)[:, None]) / (2 * dt)
        np.testing.assert_allclose(
            motion.velocity(x, y), contact.axes @ velocity, rtol=0, atol=1e-6
        )


@pytest.mark.parametrize("phase", PHASES)
def test_normal_velocities_agree_at_the_contact(phase):
    worm, wheel = (motion.velocity(0.0, 0.0) for motion in sharif().scene(phase).motions)
    assert abs(worm[2]) < 1e-12 and abs(wheel[2]) < 1e-12
    # nearly simple sliding: slide-roll ratio close to 2 (Sharif et al. 2001, section 3)
    mean, difference = (worm + wheel) / 2, worm - wheel
    assert 1.5 < np.linalg.norm(difference) / np.linalg.norm(mean) < 3


def test_outline_encloses_the_contact_and_the_path():
    drive = sharif()
    contact = drive.contact(0.5)
    outline = drive.tooth_outline(contact)
    assert np.all(np.isfinite(outline.x)) and np.all(np.isfinite(outline.y))
    assert outline.x[0] == pytest.approx(outline.x[-1], abs=1e-12)
    # every point lies on a boundary of the tooth, seen through the flank's height, or the hob's tip cut it
    height = contact.wheel_height.solve(outline.x, outline.y)[0]
    point = contact.point[:, None] + contact.axes.T @ np.stack([outline.x, outline.y, height])
    margins = np.stack(list(drive.wheel_tooth.margins(point).values())).min(axis=0)
    on_rim = margins < 1e-9
    assert margins.min() > -1e-9 and on_rim.sum() > 150
    cut = drive.wheel_flank.cut_point(*drive.rim)
    by = drive.wheel_flank.hob.radius(cut)
    assert by.max() < drive.hob.tip_radius
    np.testing.assert_allclose(by[~on_rim], drive.hob.tip_radius, atol=1e-6)
    middle = len(outline.path_x) // 2
    assert np.hypot(outline.path_x[middle], outline.path_y[middle]) < 1e-12


@pytest.fixture(scope="module")
def low_root():
    """A wheel whose root lies below its base circle: a fillet, and no flank is missing."""
    return pyworm.load(DATA / "zi_a100.toml").drive


@pytest.fixture(scope="module")
def undercut():
    """A wheel of so few teeth that a hob of sharp edges reaches below the end of their involutes."""
    few = {"threads": 1, "teeth": 18, "module": 4e-3, "diameter_factor": 10.0}
    few["wheel_fillet_radius"] = 0.0
    return drawn_gears(with_swivel(completed(few | {"centre_distance": 0.056})[0])[0])


def inside(gears):
    """How far points of the outline lie within the tooth's rim, and the hob's radius that cut them [m]."""
    cut = gears.wheel_flank.cut_point(*gears.rim)
    margins = np.stack(list(gears.wheel_tooth.margins(cut).values()))
    return margins.min(axis=0), gears.wheel_flank.hob.radius(cut)


def test_a_root_below_the_base_circle_is_no_undercut(low_root):
    """The flank of a wheel ends at the radius that the tip of its rack reaches on the line of action.

    The mid-plane section of a worm of a small lead angle is nearly such a rack.
    """
    within, by = inside(low_root)
    ended = within > 1e-6
    assert 20 < ended.sum() < 100
    np.testing.assert_allclose(by[ended], low_root.hob.tip_radius, atol=1e-6)
    assert gear_warnings(low_root) == ()
    axial = np.arctan(np.tan(np.radians(20)) * np.hypot(1, 0.2))
    depth = 82e-3 - (low_root.hob.centre_distance - low_root.hob.tip_radius)
    by_rack = np.hypot(82e-3 - depth, depth / np.tan(axial))
    assert flank_start(low_root) == pytest.approx(by_rack, abs=0.5e-3)
    assert flank_start(low_root) > 82e-3 * np.cos(axial)  # beyond the base circle


def test_an_undercut_tooth_ends_at_the_edge_of_the_envelope_and_is_told(undercut):
    """There the envelope's tangents are parallel, and the hob has not yet cut with its tip."""
    theta, roll = undercut.rim
    step = 1e-5
    point, ahead, beside = (
        undercut.wheel_flank.point(theta + a * step, roll + b * step)
        for a, b in ((0, 0), (1, 0), (0, 1))
    )
    within, by = inside(undercut)
    at_edge = (within > 1e-6) & (by < undercut.hob.tip_radius - 1e-5)
    first, second = ((side - point) / step for side in (ahead, beside))
    size = np.linalg.norm(first, axis=0) * np.linalg.norm(second, axis=0)
    angle = np.linalg.norm(np.cross(first, second, axis=0), axis=0) / size
    assert at_edge.sum() > 10
    assert angle[at_edge].max() < 0.02 < angle[within < 1e-8].min()
    (told,) = gear_warnings(undercut)
    assert told.startswith("wheel: it is undercut")


@pytest.mark.parametrize("gears", ["low_root", "undercut"])
def test_outline_is_no_larger_than_the_tooth(gears, request):
    """Lines of metres were drawn where Newton's method left the flank; a tooth is 30 mm wide, 11 mm high."""
    gears = request.getfixturevalue(gears)
    for phase in (0.0, 0.5, 1.0):
        outline = gears.tooth_outline(gears.cycle.contact(phase))
        sides = np.hypot(np.diff(outline.x), np.diff(outline.y))
        assert np.ptp(outline.x) < 35e-3 and np.ptp(outline.y) < 15e-3 and sides.max() < 2e-3


def test_outline_of_an_undercut_tooth_bounds_its_flank(undercut):
    """The flank's heights, found by another method, exist within the outline and end a little beyond it."""
    contact = undercut.cycle.contact(0.5)
    outline = undercut.tooth_outline(contact)
    inner, outer = (
        contact.wheel_height.solve(share * outline.x, share * outline.y)[2]
        for share in (0.98, 1.03)
    )
    within, by = inside(undercut)
    at_edge = (within > 1e-6) & (by < undercut.hob.tip_radius - 1e-4)
    assert inner.all() and not outer[at_edge].any()
