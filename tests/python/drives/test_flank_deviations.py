"""Deviations of the flanks of worm and wheel from files: on gap, load sharing and pattern; refusals."""

import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from folders import CASES

from pyworm.case.case import case_again, case_of
from pyworm.drives.worm.teeth.gap import surface_points
from pyworm.drives.worm.teeth.tooth import wheel_radius
from pyworm.io.input_error import CaseError

pytestmark = pytest.mark.usefixtures("coarse_mesh")

TEXT = (CASES / "worm_drawing.toml").read_text()
FACE, RADIUS = np.linspace(-15, 15, 7), np.linspace(76, 86, 5)
AXIAL, HEIGHT = np.linspace(-24, 24, 7), np.linspace(15, 24, 4)


def grid(deviation) -> str:
    """A file with deviations of the wheel [um] over face and radius [mm]."""
    rows = [f"{y},{r},{deviation(y, r)}" for y in FACE for r in RADIUS]
    return "\n".join(["face_mm,radius_mm,deviation_um", *rows]) + "\n"


def worm_grid(deviation) -> str:
    """A file with deviations of the worm [um] over axis and radius [mm]."""
    rows = [f"{z},{r},{deviation(z, r)}" for z in AXIAL for r in HEIGHT]
    return "\n".join(["axial_mm,radius_mm,deviation_um", *rows]) + "\n"


def case_with(directory: Path, content: str, part: str = "wheel"):
    """The shipped drawing with a file of deviations."""
    (directory / "flank.csv").write_text(content)
    text = TEXT.replace("[drive.hob]", f'[drive.{part}]\ndeviations = "flank.csv"\n\n[drive.hob]')
    return case_of(tomllib.loads(text), "drawn", directory)


@pytest.fixture(scope="module")
def tilted(tmp_path_factory):
    """One micrometre more on the flank for each millimetre to the leaving side."""
    return case_with(tmp_path_factory.mktemp("tilted"), grid(lambda y, _: y))


@pytest.fixture(scope="module")
def plain(tilted):
    return replace(tilted.drive, wheel=replace(tilted.drive.wheel, deviations=None))


def test_the_gap_opens_by_what_is_below_the_highest_place(tilted, plain):
    drive = tilted.drive
    contact = drive.contact(0.4)
    x, y = np.meshgrid(np.linspace(-6e-3, 6e-3, 9), np.linspace(-1e-3, 1e-3, 5), indexing="ij")
    opened = drive.gap(contact)(x, y)[0] - plain.gap(contact)(x, y)[0]
    point = surface_points(contact, x, y, contact.wheel_height.solve(x, y)[0])
    np.testing.assert_allclose(opened, 15e-6 - 1e-3 * point[1], atol=1e-12)
    off = drive.wheel.deviations.removed(np.array([-0.1, 0.1]), wheel_radius(point[:, :2, 0]))
    np.testing.assert_allclose(off, [30e-6, 0.0], atol=1e-12)


def test_pattern_and_loads_go_to_the_high_side(tilted, plain):
    drive = tilted.drive
    moved = [
        float(pattern.face[pattern.marked()].mean())
        for pattern in (plain.driven_pattern, drive.driven_pattern)
    ]
    assert moved[1] > moved[0] + 1e-3
    # worm and wheel still touch, though no contact point lies on the highest place
    assert np.nanmin(drive.driven_pattern.separation) < 1e-6
    assert drive.normal_load(0.1) < 0.9 * plain.normal_load(0.1)
    # a file is of the driven flank
    assert any("differ by 30 µm over the driven flank" in said for said in drive.assumptions)
    assert drive.turned.wheel == plain.wheel


def test_the_same_deviation_all_over_changes_nothing(tilted, plain):
    wheel = tilted.drive.wheel
    level = np.full(np.shape(wheel.deviations.deviation), -7e-6)
    even = replace(wheel, deviations=replace(wheel.deviations, deviation=tuple(map(tuple, level))))
    drive = replace(plain, wheel=even)
    np.testing.assert_allclose(
        drive.driven_pattern.separation, plain.driven_pattern.separation, atol=0.3e-6
    )
    assert drive.normal_load(0.3) == pytest.approx(plain.normal_load(0.3), rel=1e-6)


LEAD = 8e-4
"""Relative error of a worm's lead."""


@pytest.fixture(scope="module")
def of_longer_lead(tmp_path_factory, plain):
    """The deviations of a worm whose lead is too long, along its normal; its material is towards +z."""
    normal = 1e3 * LEAD * np.cos(plain.worm.base_lead_angle)
    content = worm_grid(lambda z, _: -normal * z)
    return case_with(tmp_path_factory.mktemp("lead"), content, "worm").drive


def test_a_worm_that_deviates_as_if_its_lead_were_longer_shares_loads_as_that_one(
    of_longer_lead, plain
):
    worm = plain.worm
    lead = worm.lead * (1 + LEAD)
    angle = np.arctan(lead / (2 * np.pi * worm.base_radius))
    longer = replace(worm, lead=lead, axial_pitch=lead / 2, base_lead_angle=angle)
    truly = replace(plain, worm=longer)
    for phase in (0.1, 0.5, 0.8):
        load = of_longer_lead.normal_load(phase)
        assert load == pytest.approx(truly.normal_load(phase), rel=0.03)
        assert abs(load / plain.normal_load(phase) - 1) > 0.1
    assert of_longer_lead.driven_pattern.fraction() == pytest.approx(
        truly.driven_pattern.fraction(), rel=0.15
    )


def test_deviations_of_the_worm_open_the_gap_of_its_driving_flank(of_longer_lead, plain):
    drive = of_longer_lead
    contact = drive.contact(0.4)
    x, y = np.meshgrid(np.linspace(-6e-3, 6e-3, 9), np.linspace(-1e-3, 1e-3, 5), indexing="ij")
    opened = drive.gap(contact)(x, y)[0] - plain.gap(contact)(x, y)[0]
    place = surface_points(contact, x, y, contact.worm_height.solve(x, y)[0])[2]
    slope = LEAD * np.cos(plain.worm.base_lead_angle)
    np.testing.assert_allclose(opened, slope * (place + 24e-3), atol=1e-11)
    assert any("driving flank of each thread of the worm" in said for said in drive.assumptions)
    assert drive.turned.worm == plain.worm


def test_a_stored_case_has_the_content_of_its_file(tilted):
    again = case_again(tilted.resolved)
    assert again.drive.wheel == tilted.drive.wheel
    assert again.physics == tilted.physics


GOOD = grid(lambda y, r: 0.1 * y)


@pytest.mark.parametrize(
    ("content", "right"),
    [
        (GOOD.replace("deviation_um", "deviation"), "it must be face_mm,radius_mm,deviation_um"),
        ("", "its first line is empty"),
        ("face_mm,radius_mm,deviation_um\n", "it has no places"),
        (GOOD.replace("-15.0,76.0,", "-15.0;76.0;", 1), "line 2 is -15.0;76.0;-1.5; three numbers"),
        (GOOD.replace("76.0,-1.5", "76.0,nan", 1), "line 2 is -15.0,76.0,nan; three numbers"),
        (
            GOOD.replace("-15.0,76.0", "-14.0,76.0", 1),
            "its 35 places are no grid: 8 of face_mm and 5",
        ),
        (GOOD.replace("-15.0,76.0", "-15.0,78.5", 1), "ask for each of 35 pairs once"),
        ("face_mm,radius_mm,deviation_um\n1,80,0\n2,80,0\n", "radius_mm is the same in all rows"),
        (grid(lambda y, _: 20 * y), "wheel.deviations differ by 0.60 mm, more than a twentieth"),
        (
            GOOD.replace("15.0,", "10.5,"),
            "reach along the face from -10.50 mm to 10.50 mm; they must",
        ),
        (GOOD.replace("86.0,", "83.75,"), "must reach from 80.00 mm or less to 84.00 mm or more"),
    ],
)
def test_files_of_no_deviations_are_refused(tmp_path, content, right):
    with pytest.raises(CaseError) as refused:
        case_with(tmp_path, content)
    assert "drive.wheel.deviations" in str(refused.value) and right in str(refused.value)


GOOD_WORM = worm_grid(lambda z, r: 0.1 * z)


@pytest.mark.parametrize(
    ("content", "right"),
    [
        (GOOD, "its first line is face_mm, radius_mm, deviation_um; it must be axial_mm,radius_mm"),
        (
            worm_grid(lambda z, _: 20 * z),
            "worm.deviations differ by 0.96 mm, more than a twentieth",
        ),
        (
            GOOD_WORM.replace("-24.0,", "-10,").replace("-16.0,", "-9,"),
            "along the axis from -10.00 mm to 24.00 mm; they must reach from -15.72 mm to 5.49 mm",
        ),
        (
            GOOD_WORM.replace(",24.0,", ",23.0,"),
            "must reach from 20.00 mm or less to 24.00 mm or more",
        ),
    ],
)
def test_files_of_no_deviations_of_the_worm_are_refused(tmp_path, content, right):
    with pytest.raises(CaseError) as refused:
        case_with(tmp_path, content, "worm")
    assert "drive.worm.deviations" in str(refused.value) and right in str(refused.value)


def test_a_missing_file_and_no_name_are_refused(tmp_path):
    for given, right in (('"none.csv"', '"none.csv": no such file'), ("3", "must be the name of")):
        text = TEXT.replace("[drive.hob]", f"[drive.wheel]\ndeviations = {given}\n[drive.hob]")
        with pytest.raises(CaseError, match=right):
            case_of(tomllib.loads(text), "drawn", tmp_path)
