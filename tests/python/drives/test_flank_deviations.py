"""Deviations of the wheel's flank from a file: on the gap, the load sharing and the pattern; refusals."""

import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from zi_drives import coarse_patterns, coarse_springs

from pyworm.case.case import case_again, case_of
from pyworm.drives.zi_worm.gap import surface_points
from pyworm.drives.zi_worm.tooth import wheel_radius
from pyworm.io.input_error import CaseError

CASES = Path(__file__).parents[3] / "cases"
TEXT = (CASES / "worm_drawing.toml").read_text()
FACE, RADIUS = np.linspace(-15, 15, 7), np.linspace(76, 86, 5)


@pytest.fixture(scope="module", autouse=True)
def coarse():
    """Fewer places, phases and loads."""
    with pytest.MonkeyPatch.context() as patch:
        coarse_patterns(patch)
        coarse_springs(patch)
        yield


def grid(deviation) -> str:
    """A file with deviations [um] over face and radius [mm]."""
    rows = [f"{y},{r},{deviation(y, r)}" for y in FACE for r in RADIUS]
    return "\n".join(["face_mm,radius_mm,deviation_um", *rows]) + "\n"


def case_with(directory: Path, content: str):
    """The shipped drawing with a file of deviations."""
    (directory / "flank.csv").write_text(content)
    text = TEXT.replace("[drive.hob]", '[drive.wheel]\ndeviations = "flank.csv"\n\n[drive.hob]')
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
    off = drive.wheel.deviations.taken_off(np.array([-0.1, 0.1]), wheel_radius(point[:, :2, 0]))
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


def test_a_missing_file_and_no_name_are_refused(tmp_path):
    for given, right in (('"none.csv"', '"none.csv": no such file'), ("3", "must be the name of")):
        text = TEXT.replace("[drive.hob]", f"[drive.wheel]\ndeviations = {given}\n[drive.hob]")
        with pytest.raises(CaseError, match=right):
            case_of(tomllib.loads(text), "drawn", tmp_path)
