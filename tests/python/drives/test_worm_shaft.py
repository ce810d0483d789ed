"""The worm's shaft bends under the forces of the mesh, which moves the mesh."""

import tomllib
from dataclasses import replace
from math import atan, cos, radians, tan
from pathlib import Path

import numpy as np
import pytest
from folders import CASES
from zi_drives import coarse_springs

from pyworm.case.case import case_of
from pyworm.case.ratings import WormRatingTable
from pyworm.drives.worm.loads.worm_shaft import WormShaft
from pyworm.formulas.worm_deflection import deflection_limit
from pyworm.io.input_error import CaseError
from pyworm.ratings.worm_loads import RatedWormGear
from pyworm.ratings.worm_safeties import safeties
from pyworm.ratings.worm_verdict import failures

TEXT = (CASES / "worm_drawing.toml").read_text()


def drive_with(shaft: str):
    """The shipped drawing under 600 N m with a table of its shaft."""
    text = TEXT.replace("300 Nm", "600 Nm").replace(
        "[operation]", f"[drive.shaft]\n{shaft}\n[operation]"
    )
    return case_of(tomllib.loads(text), "drawn", CASES).drive


@pytest.fixture(scope="module", autouse=True)
def coarse():
    """Fewer dry contacts for the load sharing."""
    with pytest.MonkeyPatch.context() as patch:
        coarse_springs(patch)
        yield


@pytest.fixture(scope="module")
def drive():
    return drive_with('bearing_span = "180 mm"\nbearing_stiffness = "20 N/um"\ndiameter = "35 mm"')


def test_a_shaft_in_the_middle_bends_as_the_standard_has_it(drive):
    """Its coefficient, 2e-6 l^3 / d^4 with F in N and lengths in mm, is that of steel in mid-span."""
    bent = replace(drive, shaft=WormShaft(0.18, diameter=35e-3)).shaft_deflection
    force = 600 / drive.wheel_reference_radius
    lead, friction = atan(0.2), drive.friction
    across = np.hypot(tan(lead + atan(friction)), tan(radians(20)) / cos(lead))
    standard = 2e-6 * 180**3 * force * across / 35**4 * 1e-3
    assert bent.deflection == pytest.approx(standard, rel=0.08)
    assert bent.force[2] == pytest.approx(force, rel=0.03)
    assert deflection_limit(4e-3) == pytest.approx(0.08e-3)


def test_the_shaft_yields_to_the_radial_force_and_its_bearings_carry_it(drive):
    force = drive.with_rigid_shaft.mean_force.force
    rigid, soft = (
        replace(drive, shaft=replace(drive.shaft, bearing_stiffness=of)).shaft_deflection
        for of in (np.inf, 20e6)
    )
    assert force[0] < 0 and rigid.away > 0 and np.sign(rigid.along) == np.sign(force[1])
    assert soft.away - rigid.away == pytest.approx(-force[0] / 40e6, rel=0.03)
    assert np.hypot(*force[:2]) < sum(rigid.reactions)
    # nearer to the bearing of the thrust the shaft tilts, and that bearing carries more
    aside = replace(drive, shaft=WormShaft(0.18, bearing_offset=-0.04)).shaft_deflection
    assert abs(aside.tilt) > 3 * abs(rigid.tilt) and aside.reactions[1] > rigid.reactions[1]


def test_the_mesh_shares_its_load_where_the_bent_shaft_has_it(drive):
    """As with the same displacements as errors of the assembly, and not as without them."""
    phases = 0.1, 0.4, 0.9
    bent, rigid = (
        [of.normal_load(phase) for phase in phases] for of in (drive, drive.with_rigid_shaft)
    )
    displaced = replace(drive.with_rigid_shaft, assembly=drive.assembly_under_load)
    assert bent == pytest.approx([displaced.normal_load(phase) for phase in phases], rel=1e-9)
    assert max(abs(np.array(bent) / rigid - 1)) > 0.01
    np.testing.assert_array_equal(
        drive.driven_pattern.face, drive.with_rigid_shaft.driven_pattern.face
    )
    assert drive.driven_pattern is drive.with_rigid_shaft.driven_pattern
    assert drive.turned is drive
    assert (
        "bends" in drive.assumptions[1] and "do not bend" in drive.with_rigid_shaft.assumptions[1]
    )


@pytest.mark.parametrize(
    ("shaft", "right"),
    [
        (
            'bearing_span = "180 mm"\nbearing_offset = "95 mm"',
            "drive.shaft.bearing_offset is 95 mm; it must be less",
        ),
        ('bearing_span = "180 mm"\ndiameter = "15.2 mm"', "shaft.diameter 15.2 mm, which bends 0."),
        ('diameter = "30 mm"', "drive.shaft.bearing_span is missing"),
        ('bearing_span = "180 mm"\ndiameter = "60 mm"', "thicker than the worm's tip, 48 mm"),
        (
            'bearing_span = "180 mm"\nbearing_stiffness = "20 N/m"',
            "drive.shaft.bearing_stiffness is 2e-05 N/um, with which the mesh moves",
        ),
        # the throat's circle of 84 mm leaves the worm's tip line, 76 mm from the wheel's axis, at 35.8 mm
        ('bearing_span = "60 mm"', "drive.shaft.bearing_span is 60 mm, which leaves 30 mm from"),
        (
            'bearing_span = "120 mm"\nbearing_offset = "-30 mm"',
            "leaves 30 mm from the line of centres to a bearing; the wheel's teeth are between the threads "
            "up to 35.78 mm from there, and the bearings lie beyond, 71.55 mm apart or more",
        ),
    ],
)
def test_shafts_that_do_not_carry_the_worm_are_refused(shaft, right):
    with pytest.raises(CaseError) as refused:
        drive_with(shaft).shaft_deflection  # noqa: B018
    assert right in str(refused.value)


def test_the_standard_rates_the_deflection(drive):
    assert drive.duty().deflection == drive.shaft_deflection.deflection
    table = WormRatingTable(oil="PAG VG 220", sump_temperature="80 degC").completed()
    duty = replace(drive.duty(), deflection=0.1e-3)
    rated = RatedWormGear(table, duty, Path())
    built = safeties(rated)
    bent = next(of for of in built if of.symbol == "S_delta")
    assert bent.value == pytest.approx(0.8) and bent.verdict == "not sufficient"
    assert failures(rated, built) == (
        "S_delta = 0.8 against deflection of the worm shaft is below 1.",
    )
