"""Solids of worm, wheel and hob: closed, on the exact flanks, and without overlap when assembled."""

from dataclasses import replace
from functools import cache
from math import pi

import numpy as np
import pytest
from worm_drawings import of_profile
from zi_drives import sharif

from pyworm.drives.worm.drawing.design import ParabolicRelief
from pyworm.drives.worm.drawing.deviations import FlankDeviations
from pyworm.drives.worm.flanks.wheel_envelope import turned
from pyworm.drives.worm.patterns.hob_setting import drawn_gears
from pyworm.drives.worm.solids import as_designed, solids
from pyworm.drives.worm.teeth.tooth import wheel_radius
from pyworm.drives.worm.teeth.tooth_form import worm_thickness
from pyworm.drives.worm.teeth.tooth_outline import flank_places
from pyworm.drives.worm.thread_solid import hob_solid, worm_solid
from pyworm.drives.worm.wheel_solid import wheel_solid
from pyworm.io.solid import accurate, resampled
from pyworm.io.triangles import triangles

PROFILES = ("ZA", "ZN", "ZI", "ZK", "ZC", "ZC2")

MICROMETRE = 1e-6


@cache
def gears(profile):
    """a = 100 mm, 2/41, m 4 mm, q 10, with backlash and relief, and ZC flanks to the tip."""
    drawing = of_profile(profile, hob_oversize=1.6e-3, face_width=26e-3)
    return drawn_gears(replace(drawing, hob_swivel=0.9 * drawing.normal_swivel))


def without_backlash_and_relief(profile):
    pair = gears(profile)
    sharp = ParabolicRelief()
    worm = replace(pair.worm, tip_relief=sharp)
    wheel = replace(pair.wheel, tip_relief=sharp, backlash=0.0)
    return replace(pair, worm=worm, wheel=wheel)


@cache
def wheel(profile):
    return wheel_solid(gears(profile), gears(profile).cycle.contact(0.5).wheel_angle)


def volume(corners):
    return float(np.sum(np.cross(corners[:, 0], corners[:, 1]) * corners[:, 2]) / 6)


def open_edges(corners):
    """Edges that do not run once to each side; corners within 0.1 um are one."""
    places = np.rint(corners.reshape(-1, 3) * 1e7).astype(np.int64) + 2**20 * 3
    keys = (places[:, 0] << 42) + (places[:, 1] << 21) + places[:, 2]
    index = np.unique(keys, return_inverse=True)[1].reshape(-1, 3)
    edges = np.concatenate([index[:, side] for side in ([0, 1], [1, 2], [2, 0])])
    edges = edges[edges[:, 0] != edges[:, 1]]
    there, back = edges[:, 0] * len(keys) + edges[:, 1], edges[:, 1] * len(keys) + edges[:, 0]
    return len(np.setxor1d(there, back)) + len(there) - len(np.unique(there))


@cache
def finer(solid, factor=2):
    """Points of a solid's splines between the points of its nets, (points, 3)."""
    strips = [strip for strips in solid.smooth_nets for strip in strips]
    dense = (resampled(s, *(factor * (n - 1) for n in s.shape[:2])) for s in strips)
    return np.concatenate([strip.reshape(-1, 3) for strip in dense])


@cache
def known_profile(profile):
    """Radii, axial profile and cosine of the normal to the axis of a worm's exact flank."""
    flank = gears(profile).worm_flank
    radius = np.linspace(flank.start_radius, gears(profile).worm.tip_radius, 2001)
    heights, travels = zip(
        *((flank.axial_profile(r), flank.normal_travel(r)) for r in radius), strict=True
    )
    return radius, np.array(heights), np.array(travels) / flank.screw


def depth_in_worm(profile, points, angle):
    """How deep points (3, n) are in the relieved threads at a rotation angle [m], negative outside."""
    pair = gears(profile)
    flank, reference, tip = pair.worm_flank, pair.reference_radius, pair.worm.tip_radius
    near = points[:, -points[0] > pair.centre_distance - tip]
    local = flank.axes.T @ (near - flank.axis_point[:, None])
    radius = np.hypot(local[0], local[1])
    local, radius = local[:, radius < tip], radius[radius < tip]
    known, heights, cosines = known_profile(profile)
    height, cosine = (np.interp(radius, known, values) for values in (heights, cosines))
    thickness = worm_thickness(pair, reference) - 2 * (height - flank.axial_profile(reference))
    behind = local[2] - height - flank.screw * (np.arctan2(local[1], local[0]) - angle)
    behind -= pair.worm.axial_pitch * np.rint((behind - thickness / 2) / pair.worm.axial_pitch)
    relief = pair.worm.tip_relief(tip - radius)
    return np.minimum(behind, thickness - behind) * cosine - relief


def deepest_in_worm(profile, turn, ahead):
    """Depth [m] of the wheel's deepest point in the worm after a turn, some angle ahead of the ratio."""
    pair = gears(profile)
    points, tooth = finer(wheel(profile)).T, 2 * pi / pair.wheel.teeth
    angle = pair.cycle.contact(0.5).worm_angle + turn
    first = np.rint(pair.ratio * turn / tooth)
    depths = [
        depth_in_worm(profile, turned(points, number * tooth - pair.ratio * turn - ahead), angle)
        for number in first + np.arange(-3, 4)
    ]
    return float(np.concatenate(depths).max())


@pytest.mark.parametrize("profile", PROFILES)
def test_assembled_teeth_touch_and_do_not_overlap_over_a_turn(profile):
    """Points of the wheel against the exact threads, as far ahead as the leading pair turns the wheel."""
    pair = gears(profile)
    cycle, deepest = pair.cycle, []
    for turn in 2 * pi * np.arange(10) / 10:
        phases = 0.5 + turn / cycle.worm_rotation + pair.pitch * np.arange(-9, 10)
        phases = phases[(phases >= 0) & (phases <= 1)]
        at = cycle.points(phases)
        relief = pair.worm_tooth.removed(at) + pair.wheel_tooth.removed(at)
        ahead = (cycle.transmission_error(phases) - relief / abs(cycle.lever)).max()
        deepest.append(deepest_in_worm(profile, turn, ahead))
    print(f"{profile}: {min(deepest) * 1e6:.3f} to {max(deepest) * 1e6:.3f} um deep")
    assert max(deepest) < MICROMETRE
    assert min(deepest) > -MICROMETRE


@pytest.mark.parametrize("profile", PROFILES)
def test_splines_of_the_wheel_are_on_the_exact_flank(profile):
    pair = without_backlash_and_relief(profile)
    solid = accurate(lambda steps: wheel_solid(pair, 0.0, steps))
    net = solid.nets[solid.flank[0]]
    assert len(solid.flank) == 1
    points = solid.flank_points(3).reshape(-1, 3).T
    q = flank_places(pair.wheel_flank, pair.within, np.stack([wheel_radius(points), points[1]]))
    exact, normal = pair.wheel_flank.point(*q), pair.wheel_flank.normal(*q)
    pitch = 2 * pi / pair.wheel.teeth
    ahead = np.arctan2(exact[2], -exact[0]) - np.arctan2(points[2], -points[0])
    exact, normal = (turned(vector, -pitch * np.rint(ahead / pitch)) for vector in (exact, normal))
    off = np.abs(np.sum((points - exact) * normal, axis=0)).max()
    print(f"{profile}: {off * 1e9:.1f} nm, net {net.shape[:2]}")
    assert off < MICROMETRE


@pytest.mark.parametrize("profile", PROFILES)
def test_meshes_are_closed_and_as_large_as_their_sections(profile, monkeypatch):
    monkeypatch.setattr("pyworm.io.triangles.SAG", 0.1e-3)
    pair = gears(profile)
    worm, cut = triangles(worm_solid(pair, 0.3)), triangles(wheel(profile))
    assert open_edges(worm) == open_edges(cut) == 0
    assert volume(worm) == pytest.approx(layered_worm(pair), rel=0.02)
    assert volume(cut) == pytest.approx(half_filled_wheel(pair), rel=0.04)


def test_meshes_of_a_hob_and_of_mirror_images_are_closed(monkeypatch):
    monkeypatch.setattr("pyworm.io.triangles.SAG", 0.1e-3)
    hob = hob_solid(gears("ZI"), 0.0)
    for solid in (hob, hob.mirrored(), wheel("ZI").mirrored()):
        mesh = triangles(solid)
        assert open_edges(mesh) == 0
        assert volume(mesh) > 0


def layered_worm(pair):
    """Volume of a worm without fillets [m3], of threads as thick on each cylinder as the drive has them.

    The section square to the axis is the same along it: V = pi L (r_f^2 + integral of 2 r s dr / pitch).
    """
    worm = pair.worm
    half = np.sqrt(pair.wheel.tip_radius**2 - (pair.centre_distance - worm.tip_radius) ** 2)
    radius = np.linspace(worm.root_radius, worm.tip_radius, 101)
    thickness = np.array([worm_thickness(pair, float(r)) for r in radius])
    threads = np.trapezoid(2 * radius * thickness, radius) / worm.axial_pitch
    return float(pi * 2 * (half + pair.module) * (worm.root_radius**2 + threads))


def half_filled_wheel(pair):
    """Volume of a wheel of whose teeth and spaces each fill one half between root and tip [m3]."""
    tooth = pair.wheel_tooth
    along = np.linspace(-0.5, 0.5, 401) * pair.wheel.face_width
    bore = pair.hob.centre_distance - pair.hob.tip_radius - 2 * pair.module
    square = (tooth.root(along) ** 2 + tooth.tip(along) ** 2) / 2 - bore**2
    return float(pi * np.trapezoid(square, along))


def test_a_left_hand_drive_is_the_mirror_image():
    pair = gears("ZI")
    right, left = (solids(pair, hand) for hand in ("right", "left"))
    for name, solid in right.items():
        mirrored = finer(left[name], 1)
        ordered = finer(solid, 1) * [1.0, 1.0, -1.0]
        assert np.sort(mirrored[:, 2]) == pytest.approx(np.sort(ordered[:, 2]))
    assert np.allclose(
        left["wheel"].flank_points(1)[..., 2].mean(), -right["wheel"].flank_points(1)[..., 2].mean()
    )


def test_backlash_is_that_of_the_drawing():
    """The gap at the other flank is the backlash turned into a normal distance by the wheel's lever."""
    pair = gears("ZI")
    play = pair.wheel.backlash / pair.wheel_reference_radius
    assert deepest_in_worm("ZI", 0.0, 0.0) == pytest.approx(0.0, abs=0.2e-6)
    assert deepest_in_worm("ZI", 0.0, play) == pytest.approx(0.0, abs=0.2e-6)
    half = -play / 2 * abs(pair.cycle.lever)
    assert deepest_in_worm("ZI", 0.0, play / 2) == pytest.approx(half, abs=0.2e-6)


def test_relief_and_deviations_set_the_flank_back():
    pair, plain = gears("ZI"), without_backlash_and_relief("ZI")
    worn = FlankDeviations((-0.02, 0.02), (0.05, 0.1), ((-20e-6, -20e-6), (0.0, 0.0)))
    back = replace(plain, wheel=replace(plain.wheel, deviations=worn))
    lever = abs(plain.cycle.lever)
    whole, off, relieved = (wheel_solid(body, 0.0).flank_points(1) for body in (plain, back, pair))
    radius = np.hypot(off[..., 0], off[..., 2])
    assert np.allclose(off[..., 1], whole[..., 1]) and np.allclose(
        radius, np.hypot(whole[..., 0], whole[..., 2])
    )
    angle = np.arctan2(whole[..., 2], -whole[..., 0]) - np.arctan2(off[..., 2], -off[..., 0])
    assert angle * lever == pytest.approx(10e-6 * (1 - off[..., 1] / 20e-3), rel=0.02)
    corner, cut = whole[0, 0], relieved[0, 0]  # the tip at a face
    angle = np.arctan2(corner[2], -corner[0]) - np.arctan2(cut[2], -cut[0])
    assert angle * lever == pytest.approx(pair.wheel.tip_relief.amount, rel=0.05)


def test_a_sharp_hob_and_a_wheel_without_given_backlash():
    pair = as_designed(sharif())
    assert pair.wheel.fillet_radius == 0 and pair.wheel.backlash is None
    mesh = triangles(wheel_solid(pair, 0.0))
    assert open_edges(mesh) == 0 and volume(mesh) > 0


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"wheel": {"tip_radius": 0.1, "throat_radius": 0.094}}, "wheel: its flanks? "),
        ({"worm": {"thickness": 2.5e-3}}, "worm: its flanks meet before its tip"),
    ],
)
def test_teeth_without_a_solid_are_refused(changed, words):
    pair = gears("ZI")
    parts = {name: replace(getattr(pair, name), **values) for name, values in changed.items()}
    with pytest.raises(ValueError, match=words):
        solids(replace(pair, **parts), "right")
