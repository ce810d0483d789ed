"""Involute gears on parallel axes: identities, worked examples of others, and what is refused."""

from dataclasses import replace
from math import atan, cos, hypot, pi, radians, sin, sqrt, tan

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from pyworm.drives.gear_pair.checks import check_gears
from pyworm.drives.gear_pair.gears import (
    Gear,
    InvolutePair,
    ToothSystem,
    inverse_involute,
    involute,
)
from pyworm.drives.gear_pair.load_sharing import LoadSharing

FZG_C = InvolutePair(
    ToothSystem(4.5e-3, radians(20)), Gear(16, 0.1817), Gear(24, 0.1715), 91.5e-3, 14e-3
)
HELICAL = InvolutePair(
    ToothSystem(3.5e-3, radians(20), radians(15)),
    Gear(20, 0.1809),
    Gear(30, 0.0891),
    91.5e-3,
    23e-3,
)


@st.composite
def pairs(draw, spur=False):
    """Gears without backlash, of usual proportions; what does not mesh is passed over."""
    system = ToothSystem(
        draw(st.floats(1e-3, 10e-3)),
        radians(draw(st.floats(18, 27))),
        0.0 if spur else radians(draw(st.floats(0, 30))),
    )
    z1 = draw(st.integers(15, 40))
    z2 = draw(st.integers(z1, 150))
    x1, x2 = draw(st.floats(-0.2, 0.6)), draw(st.floats(-0.4, 0.5))
    angle = system.transverse_pressure_angle
    value = involute(angle) + 2 * tan(system.pressure_angle) * (x1 + x2) / (z1 + z2)
    assume(value > 0.003)
    tight = inverse_involute(value)
    distance = (z1 + z2) * system.transverse_module / 2 * cos(angle) / cos(tight)
    width = system.module * draw(st.floats(3, 25))
    pair = InvolutePair(system, Gear(z1, x1), Gear(z2, x2), distance * (1 + 1e-9), width)
    try:
        check_gears(pair)
    except ValueError:
        assume(False)
    return pair


# ------------------------------------------------------------------------- examples of others


def test_fzg_c_gears_as_in_the_report_c14_of_gearpie():
    """github.com/cfernandesFEUP/GEARpie, REPORT/C14.txt: millimetres, two to three decimals."""
    pair = FZG_C
    pinion, gear = pair.cylinders
    millimetres = [1e3 * radius for radius in (pinion.tip, gear.tip, pinion.root, gear.root)]
    assert millimetres == pytest.approx([41.228, 59.182, 31.193, 49.147], abs=6e-4)
    assert [1e3 * one.pitch for one in pair.cylinders] == pytest.approx([36.6, 54.9], abs=1e-9)
    assert 1e3 * pair.system.base_pitch == pytest.approx(13.285, abs=6e-4)
    assert pair.transverse_contact_ratio == pytest.approx(1.44, abs=5e-3)
    from_start = np.array([pair.lowest_single, pair.pitch_point, pair.highest_single, pair.end])
    assert 1e3 * (from_start - pair.start) == pytest.approx([5.81, 9.50, 13.28, 19.10], abs=6e-3)
    assert 1e3 * pair.base_tangent == pytest.approx(34.93, abs=6e-3)


def test_helical_gears_as_in_the_report_h501_of_gearpie():
    """github.com/cfernandesFEUP/GEARpie, REPORT/H501.txt."""
    pair = HELICAL
    pinion, gear = pair.cylinders
    millimetres = [1e3 * radius for radius in (pinion.tip, gear.tip, pinion.root, gear.root)]
    assert millimetres == pytest.approx([40.336, 58.132, 32.493, 50.289], abs=6e-4)
    assert 1e3 * pinion.reference == pytest.approx(36.235, abs=6e-4)
    assert 1e3 * pair.system.base_pitch == pytest.approx(10.652, abs=6e-4)
    normal = pair.system.base_pitch * cos(pair.system.base_helix_angle)
    assert 1e3 * normal == pytest.approx(10.332, abs=6e-4)
    assert pair.transverse_contact_ratio == pytest.approx(1.46, abs=5e-3)
    assert pair.overlap_ratio == pytest.approx(0.54, abs=5e-3)
    from_start = np.array([pair.lowest_single, pair.pitch_point, pair.highest_single, pair.end])
    assert 1e3 * (from_start - pair.start) == pytest.approx([4.90, 7.48, 10.65, 15.55], abs=6e-3)


def test_profile_shifted_spur_gears_as_worked_by_bolsover():
    """bolsover.com, Utilities for Alibre, "Profile Shifted External Spur Gears"."""
    pair = InvolutePair(
        ToothSystem(3e-3, radians(20)), Gear(12, 0.6), Gear(24, 0.36), 56.5e-3, 30e-3
    )
    pinion, gear = pair.cylinders
    assert np.degrees(pair.pressure_angle) == pytest.approx(26.0888, abs=6e-5)
    diameters = [2e3 * radius for radius in (pinion.base, gear.base, pinion.pitch, gear.pitch)]
    assert diameters == pytest.approx([33.8289, 67.6579, 37.667, 75.333], abs=6e-4)
    diameters = [2e3 * radius for radius in (pinion.tip, gear.tip, pinion.root, gear.root)]
    assert diameters == pytest.approx([44.840, 79.400, 32.100, 66.660], abs=6e-4)
    assert pair.transverse_contact_ratio == pytest.approx(1.202, abs=6e-4)
    assert involute(pair.pressure_angle) == pytest.approx(0.034317, abs=6e-7)
    # the shifts were chosen for 56.4999 mm, so that hardly any backlash is left
    assert 0 < pair.backlash < 1e-6


# -------------------------------------------------------------------------------- identities


@settings(max_examples=60, deadline=None)
@given(pairs())
def test_the_line_of_action_is_that_of_two_base_circles(pair):
    pinion, gear = pair.cylinders
    assert pinion.base + gear.base == pytest.approx(
        pair.centre_distance * cos(pair.pressure_angle), rel=1e-12
    )
    assert pair.base_tangent == pytest.approx(
        sqrt(pair.centre_distance**2 - (pinion.base + gear.base) ** 2), rel=1e-9
    )
    assert pair.system.base_pitch == pytest.approx(2 * pi * gear.base / pair.gear.teeth, rel=1e-12)
    assert pinion.pitch + gear.pitch == pytest.approx(pair.centre_distance, rel=1e-12)
    # where both tips cut the line of action
    assert hypot(gear.base, pair.base_tangent - pair.start) == pytest.approx(gear.tip, rel=1e-12)
    assert hypot(pinion.base, pair.end) == pytest.approx(pinion.tip, rel=1e-12)
    assert pair.path_length >= pair.system.base_pitch
    assert tan(pair.system.base_helix_angle) == pytest.approx(
        tan(pair.system.helix_angle) * cos(pair.system.transverse_pressure_angle), abs=1e-12
    )


@settings(max_examples=60, deadline=None)
@given(pairs(spur=True))
def test_the_flank_begins_where_the_rack_leaves_it(pair):
    """The rack's straight flank ends on the line of action of cutting, below the pitch line."""
    for gear, size in zip((pair.pinion, pair.gear), pair.cylinders, strict=True):
        angle = pair.system.pressure_angle
        straight = gear.dedendum - gear.fillet * (1 - sin(angle)) - gear.profile_shift
        # from the pitch point of cutting back along the line of action
        back = straight * pair.system.module / sin(angle)
        foot = size.reference - back * sin(angle), back * cos(angle)
        assert hypot(*foot) == pytest.approx(hypot(size.base, size.form_length), rel=1e-12)


@settings(max_examples=60, deadline=None)
@given(pairs())
def test_no_backlash_at_the_centre_distance_without(pair):
    assert abs(pair.backlash) < 1e-6 * pair.system.module
    wider = replace(pair, centre_distance=pair.centre_distance * (1 + 1e-4))
    # both flanks open by twice the added distance times tan(alpha_w)
    added = wider.centre_distance - pair.centre_distance
    assert wider.backlash == pytest.approx(2 * added * tan(pair.pressure_angle), rel=5e-3)


def test_tip_thickness_as_an_involute_is_drawn():
    """Both flanks of the pinion's tooth from the parametric involute."""
    pair = FZG_C
    pinion = pair.cylinders[0]
    angle = pair.system.pressure_angle
    thick = pair.system.module * (pi / 2 + 2 * pair.pinion.profile_shift * tan(angle))
    half = thick / (2 * pinion.reference) + tan(angle) - angle  # from the middle to the base point
    rolled = sqrt((pinion.tip / pinion.base) ** 2 - 1)
    x = pinion.base * (np.cos(rolled) + rolled * np.sin(rolled))
    y = pinion.base * (np.sin(rolled) - rolled * np.cos(rolled))
    assert pinion.tip_thickness == pytest.approx(2 * pinion.tip * (half - atan(y / x)), rel=1e-9)


# ------------------------------------------------------------------------------ load sharing


@settings(max_examples=60, deadline=None)
@given(pairs(), st.sampled_from(["uniform", "elastic"]), st.floats(0.001, 0.999))
def test_all_lines_together_carry_the_normal_force(pair, rule, part):
    assume(pair.transverse_contact_ratio < 2)
    sharing = LoadSharing(pair, rule)
    first = pair.start + part * pair.system.base_pitch
    lines = first + pair.system.base_pitch * np.arange(-200, 201)
    assert sharing.of_line(lines).sum() == pytest.approx(1, rel=1e-9)


@settings(max_examples=60, deadline=None)
@given(pairs(spur=True), st.sampled_from(["ramp", "uniform", "elastic"]), st.floats(0.001, 0.999))
def test_pairs_of_spur_teeth_together_carry_the_normal_force(pair, rule, part):
    assume(pair.transverse_contact_ratio < 2)
    sharing = LoadSharing(pair, rule)
    places = pair.start + pair.system.base_pitch * (part + np.arange(3))
    assert sharing.of_line(places).sum() == pytest.approx(1, rel=1e-9)
    assert sharing.per_length(places).sum() * pair.face_width == pytest.approx(1, rel=1e-9)


def test_the_ramp_of_blok():
    pair = FZG_C
    ramp = LoadSharing(pair, "ramp")
    tiny = 1e-9
    places = [pair.start, pair.lowest_single - tiny, pair.lowest_single + tiny, pair.pitch_point]
    places += [pair.highest_single - tiny, pair.highest_single + tiny, pair.end]
    assert ramp.of_line(places) == pytest.approx([1 / 3, 2 / 3, 1, 1, 1, 2 / 3, 1 / 3], abs=1e-6)
    assert ramp.of_line([pair.start - 1e-6, pair.end + 1e-6]) == pytest.approx([0, 0])


def test_elastic_sharing_is_smooth_where_the_ramp_is_drawn_by_hand():
    pair = FZG_C
    elastic = LoadSharing(pair, "elastic")
    tiny = 1e-9
    ends = elastic.of_line([pair.start, pair.lowest_single - tiny, pair.highest_single + tiny])
    assert ends == pytest.approx([0.355, 0.645, 0.645], abs=1e-3)


@settings(max_examples=40, deadline=None)
@given(pairs())
def test_the_shortest_line_is_the_least_over_the_mesh_cycle(pair):
    assume(pair.overlap_ratio > 0.02)
    uniform = LoadSharing(pair, "uniform")
    places = pair.start + pair.system.base_pitch * np.linspace(0, 1, 3001)
    lines = places[:, None] + pair.system.base_pitch * np.arange(-60, 61)
    together = uniform.line_length(lines).sum(axis=1)
    # piecewise linear between changes that the samples miss by a step at most
    step = together.max() * 2e-3
    assert pair.shortest_line <= together.min() * (1 + 1e-12)
    assert pair.shortest_line == pytest.approx(together.min(), abs=step)
    mean = pair.transverse_contact_ratio * pair.face_width / cos(pair.system.base_helix_angle)
    assert together.mean() == pytest.approx(mean, rel=2e-3)


@pytest.mark.parametrize("rule", ["ramp", "uniform", "elastic"])
def test_a_helix_that_vanishes_leaves_a_spur_pair(rule):
    tilted = replace(FZG_C, system=replace(FZG_C.system, helix_angle=1e-5))
    places = FZG_C.start + FZG_C.path_length * np.array([0.1, 0.25, 0.5, 0.75, 0.9])
    spur, helical = (LoadSharing(pair, rule) for pair in (FZG_C, tilted))
    assert helical.per_length(places) == pytest.approx(spur.per_length(places), rel=1e-4)
    assert helical.of_line(places) == pytest.approx(spur.of_line(places), rel=1e-4)


# ------------------------------------------------------------------------------- what is refused


def changed(part, **values):
    return {part: replace(getattr(FZG_C, part), **values)}


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (changed("pinion", teeth=0), "pinion.teeth is 0; a whole number of teeth is needed"),
        (changed("pinion", teeth=25), "pinion.teeth is 25; the pinion is the gear with fewer teeth"),
        (changed("pinion", profile_shift=float("nan")), "pinion.profile_shift is nan; it must be fin"),
        (changed("pinion", profile_shift=-0.3), "16 teeth are undercut below 0.07"),
        (changed("pinion", addendum=-1.0), "pinion.addendum is -1; it must be positive and finite"),
        (changed("pinion", addendum=2.2), "the tooth comes to a point before its tip"),
        (changed("gear", addendum=1.3), "gear.addendum is 1.3; its tip reaches"),
        (changed("gear", dedendum=1.6, fillet=0.0), "profile_shift is 0.1715; 24 teeth are undercut"),
        (changed("gear", fillet=1.25), "gear.fillet is 1.25; it must lie between 0 and the dedendum"),
        ({"centre_distance": 84e-3}, "the base circles touch at 84.57 mm"),
        ({"centre_distance": 91e-3}, "centre_distance is 91 mm; teeth of profile shifts that sum to"),
        ({"centre_distance": 95e-3}, "transverse contact ratio of"),
        ({"face_width": 0.0}, "face_width is 0; it must be positive and finite"),
        (changed("system", pressure_angle=1.0), "pressure_angle is 57.3 deg; it must be below 45 deg"),
        (changed("system", helix_angle=1.2), "helix_angle is 68.75 deg; it must lie from 0 deg (spur)"),
    ],
)  # fmt: skip
def test_gears_that_do_not_mesh_are_refused(change, sentence):
    with pytest.raises(ValueError) as refusal:
        check_gears(replace(FZG_C, **change))
    assert sentence in str(refusal.value)


def test_interference_is_distinguished_from_undercut():
    """A gear of long teeth digs below where the involute of a small pinion begins, not into its root."""
    system = ToothSystem(4e-3, radians(20))
    pair = InvolutePair(system, Gear(20), Gear(100, addendum=1.2), 240e-3, 40e-3)
    with pytest.raises(ValueError, match=r"gear.addendum .* \(interference\)"):
        check_gears(pair)


def test_the_advised_profile_shift_is_enough():
    small = replace(FZG_C.pinion, profile_shift=0.07)
    pair = replace(FZG_C, pinion=small)
    check_gears(pair)
    assert pair.cylinders[0].form_length > 0


def test_a_contact_ratio_of_two_has_no_ramp():
    system = ToothSystem(2e-3, radians(18))
    long = {"addendum": 1.35, "dedendum": 1.6}
    pair = InvolutePair(system, Gear(60, **long), Gear(80, **long), 0.14, 20e-3)
    assert pair.transverse_contact_ratio > 2
    with pytest.raises(ValueError, match="below 2, here it is 2"):
        LoadSharing(pair, "ramp")
    middle = LoadSharing(pair, "uniform").per_length((pair.start + pair.end) / 2)
    assert middle == pytest.approx(1 / (3 * pair.face_width), rel=1e-9)
    with pytest.raises(ValueError, match='load_sharing is "even"; it must be one of ramp'):
        LoadSharing(pair, "even")
