"""Worm drives with errors of the assembly: edge contact, play, allowed errors, shims."""

from dataclasses import replace
from functools import cache
from math import radians
from pathlib import Path

import numpy as np
import pytest
from worm_drawings import of_profile
from zi_drives import coarse_springs

from pyworm.case.case import case_of
from pyworm.drives.worm.drawing.design import Assembly
from pyworm.drives.worm.loads.dry_contact import dry_contact_of
from pyworm.drives.worm.patterns.hob_setting import drawn_gears, with_swivel
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.drives.worm.teeth.seen_path import SeenPath
from pyworm.drives.worm.tolerances import RISE
from pyworm.io.input_error import CaseError

MM = 1e-3
BACKLASH = 0.12 * MM

CASE = {
    "title": "Misaligned worm drive, a = 100 mm, 2/41",
    "source": "Reference gear of the worm standard's size, errors of assembly of DIN 3974's order",
    "accuracy": "10 %",
    "drive": {
        "kind": "worm",
        "profile": "ZI",
        "centre_distance": "100 mm",
        "threads": 2,
        "teeth": 41,
        "module": "4 mm",
        "diameter_factor": 9,
        "face_width": "30 mm",
    },
    "operation": {
        "worm_speed": "1500 1/min",
        "wheel_torque": "300 N m",
        "phases": [0.1, 0.3, 0.5, 0.7, 0.9],
    },
    "bodies": {
        "worm": {"material": "16MnCr5", "finish": "ground"},
        "wheel": {"material": "CuSn12Ni2-C-GZ", "finish": "run-in"},
    },
    "oil": {"name": "PAG VG 220", "temperature": "70 degC"},
}


@pytest.fixture(autouse=True, scope="module")
def coarse():
    """Fewer phases and loads for load sharing, which is looked at to a tenth."""
    with pytest.MonkeyPatch.context() as patch:
        coarse_springs(patch)
        yield


def misaligned(**errors):
    drive = CASE["drive"] | {"assembly": errors}
    return case_of(CASE | {"drive": drive}, "misaligned", Path())


@pytest.fixture(scope="module")
def drive():
    return case_of(CASE, "aligned", Path()).drive


def load_at(drive, worm_angle):
    """Load of the tooth pair at a turn of the worm."""
    first, last = (drive.contact(phase).worm_angle for phase in (0.0, 1.0))
    return drive.normal_load((worm_angle - first) / (last - first))


def moved(drive, **errors):
    return replace(drive, assembly=Assembly(**errors))


@pytest.mark.parametrize("away", [-0.1 * MM, -0.05 * MM, 0.03 * MM])
def test_play_grows_with_the_centre_distance_as_two_wedges_do(drive, away):
    """Each flank gives way by its axial pressure angle: 2 da tan(alpha_x) on the reference circle.

    The contact at mid-mesh lies a little beside that circle.
    """
    axial = np.tan(radians(20)) / np.cos(np.arctan(2 / 9))
    assert drive.play == BACKLASH
    found = moved(drive, centre_distance=away).play
    assert found - BACKLASH == pytest.approx(2 * away * axial, rel=0.05)


def test_a_shift_along_the_wheels_axis_costs_the_same_play_either_way(drive):
    left = [moved(drive, axial_shift=by * MM).play for by in (-0.1, 0.1)]
    assert left[0] == pytest.approx(left[1], abs=1e-9)
    assert left[0] < BACKLASH


def test_play_is_found_once_for_all_contacts_of_a_drive(drive, monkeypatch):
    """It takes seconds where the flanks touch at an edge, and a solution in time asks for many contacts."""
    asked = []
    monkeypatch.setattr(WormGears, "_turned_ahead", lambda gears: asked.append(gears) or 0.0)
    other = moved(drive, centre_distance=0.02 * MM)
    for phase in (0.4, 0.6):
        other.scene(phase)
    assert len(asked) == 2  # each of both flanks


def test_teeth_without_play_are_refused(drive):
    with pytest.raises(CaseError, match=r"assembly: with the worm -0\.3 mm .* the teeth jam"):
        misaligned(centre_distance="-0.3 mm")


@pytest.mark.parametrize(
    ("errors", "seen"),
    [({"axial_shift": "0.1 mm"}, False), ({"centre_distance": "0.1 mm"}, True)],
)
def test_misaligned_teeth_are_computed_to_the_edge_and_said_to_be(errors, seen):
    case = misaligned(**errors)
    of = case.drive
    assert isinstance(of.cycle.path, SeenPath) == seen
    (said,) = [one for one in case.warnings if "touch at an edge" in one]
    assert said.startswith("drive.assembly: ")
    (assumed,) = [one for one in of.assumptions if "near an edge" in one]
    assert "this edge contact" in assumed
    # towards the leaving end of the face, and the teeth that come into mesh carry more than aligned
    assert 10 * MM < of.edge_contact.face < 15 * MM
    scene = case.scene(phase=0.1)
    assert scene.load > 1.2 * case_of(CASE, "aligned", Path()).scene(phase=0.1).load
    loads = of.shared(0.1)
    torque = sum(of.arms(loads.phases).of("wheel", of.friction) * loads.forces)
    assert torque == pytest.approx(300, rel=1e-6)


def test_flanks_seen_over_aligned_tangent_planes_have_the_contact_of_their_own(drive):
    """Where the flanks have a contact point both ways are open: pressure, place and load sharing agree."""
    own = moved(drive, centre_distance=-0.1 * MM)
    seen = moved(drive, centre_distance=-0.1 * MM)
    aligned = own.aligned_cycle
    vars(seen)["cycle"] = replace(aligned, path=SeenPath(aligned.path, seen.worm_flank))
    for load in (500.0, 4000.0):
        one, other = dry_contact_of(own, load), dry_contact_of(seen, load)
        assert other.pressure_max == pytest.approx(one.pressure_max, rel=0.02)
        places = [
            of.flank_place(dry.contact, np.array([dry.x]), np.array([dry.y]))
            for of, dry in ((own, one), (seen, other))
        ]
        assert np.ravel(places[1]) == pytest.approx(np.ravel(places[0]), abs=0.5 * MM)
    assert seen.play == pytest.approx(own.play, abs=2e-6)


@pytest.mark.parametrize("profile", ["ZN", "ZK", "ZC"])
def test_other_profiles_are_seen_likewise(profile):
    of, _ = with_swivel(of_profile(profile))
    far = drawn_gears(of, Assembly(centre_distance=0.3 * MM, shaft_angle=-2e-3))
    assert isinstance(far.cycle.path, SeenPath)
    touch = far.first_touch(far.cycle.contact(0.5))
    assert np.isfinite(touch.gap) and np.hypot(touch.x, touch.y) > 3 * MM
    assert far.edge_contact.boundary


def test_pressure_passes_on_where_the_contact_point_leaves_the_flanks(drive):
    """At some centre distance their common normal is lost; edge contacts before and after are alike.

    To what the cells of dry contacts leave: before, the radius along the contact grows without bound.
    """

    @cache
    def at(away):
        return moved(drive, centre_distance=away)

    with_normal, without = 0.03 * MM, 0.1 * MM
    while without - with_normal > 0.5e-6:
        middle = (with_normal + without) / 2
        lost = isinstance(at(middle).cycle.path, SeenPath)
        with_normal, without = (with_normal, middle) if lost else (middle, without)
    before, after = (dry_contact_of(at(away), 3000.0) for away in (with_normal, without))
    assert after.pressure_max == pytest.approx(before.pressure_max, rel=0.06)
    # the same turns of the worm, at which their mesh cycles have different phases
    start = drive.contact(0.5).worm_angle
    for turn in (-2.8, -0.9, 0.0, 1.0, 1.9):
        loads = [load_at(at(away), start + turn) for away in (with_normal, without)]
        assert loads[1] == pytest.approx(loads[0], rel=0.1)


def test_allowed_errors_are_where_the_pressure_has_risen_or_the_play_is_gone(drive):
    load = drive.normal_load(0.5)
    allowed = RISE * dry_contact_of(drive, load).pressure_max
    for one in drive.tolerances:
        assert one.low < 0 < one.high
        for size, limit in ((one.low, one.low_limit), (one.high, one.high_limit)):
            inside, beyond = (moved(drive, **{one.entry: part * size}) for part in (0.9, 1.1))
            if limit == "backlash":
                assert beyond.play < 0 < inside.play
                continue
            assert dry_contact_of(inside, load).pressure_max < 1.02 * allowed
            assert inside.play > 0
            if limit == "pressure":
                assert dry_contact_of(beyond, load).pressure_max > allowed
    away = drive.allowed_errors()["centre_distance"]
    assert away["from_limited_by"] == "backlash" and away["to_limited_by"] == "pressure"
    assert set(drive.allowed_errors()["shaft_angle"]) >= {"from_deg", "to_deg"}


def test_a_shim_takes_back_the_shift_of_the_worm(drive):
    """An error by which the flanks touch at an edge; the wheel goes after the worm."""
    off = moved(drive, axial_shift=0.1 * MM)
    assert off.edge_contact is not None
    shim = off.wheel_shim(None)
    assert shim.reached and shim.shift == pytest.approx(0.1 * MM, abs=0.01 * MM)
    assert shim.before - shim.wanted > 3 * MM


def test_phases_without_load_are_left_out_and_said_to_be(capsys):
    case = misaligned(centre_distance="0.5 mm")
    phases = [of.phase for of in case.places()]
    assert phases and 0.9 not in phases
    (said,) = [one for one in case.warnings if one.startswith("operation.phases")]
    assert "0.9" in said and "carry all of the load" in said
    with pytest.raises(CaseError, match="carries no load there"):
        case.scene(phase=0.9)
