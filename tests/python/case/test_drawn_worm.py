"""Worm drives by the numbers of their drawing: the same drive as by its design table, and refusals."""

import json
import re
import tomllib
from functools import cache
from typing import get_args

import numpy as np
import pytest
from folders import ROOT
from zi_drives import coarse_patterns, coarse_springs, without_allowed_errors

from pyworm.case.bodies import BodyTable
from pyworm.case.case import case_again, case_of
from pyworm.case.worm_table import WormDriveTable
from pyworm.cli.main import main
from pyworm.io.input_error import CaseError
from pyworm.ratings.rated_case import rating_request, ratings

TEXT = (ROOT / "cases/worm_drawing.toml").read_text()


@pytest.fixture(scope="module", autouse=True)
def coarse():
    """Fewer dry contacts for the load sharing and fewer places of patterns; no allowed errors."""
    with pytest.MonkeyPatch.context() as patch:
        coarse_springs(patch)
        coarse_patterns(patch)
        without_allowed_errors(patch)
        yield


def drawn(*changes: tuple[str, str]):
    """The shipped drawing with some of its text replaced."""
    text = TEXT
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return case_of(tomllib.loads(text), "drawn", ROOT / "cases")


@cache
def unit():
    return drawn()


def in_table(part: str, line: str) -> tuple[str, str]:
    """A change that adds a line to a table of the drawing."""
    return (
        "[drive.hob]",
        f"[drive.hob]\n{line}" if part == "hob" else f"[drive.{part}]\n{line}\n[drive.hob]",
    )


def in_drive(line: str) -> tuple[str, str]:
    return ("module = ", f"{line}\nmodule = ")


DESIGN = """
[drive]
kind = "worm"
profile = "ZI"
centre_distance = "100 mm"
threads = 2
teeth = 41
face_width = "30 mm"
[drive.worm]
tip_diameter = "48 mm"
root_diameter = "30.4 mm"
base_diameter = "18.97390 mm"
axial_pitch = "12.56637 mm"
lead = "25.13274 mm"
base_lead_angle = "22.8618 deg"
tip_relief = "16 um"
tip_relief_length = "1 mm"
[drive.wheel]
outside_diameter = "172 mm"
throat_diameter = "168 mm"
tip_relief = "16 um"
tip_relief_length = "1 mm"
[drive.hob]
tip_diameter = "51.2 mm"
root_diameter = "32 mm"
base_diameter = "19.13702 mm"
lead = "25.09490 mm"
axial_pitch = "12.54745 mm"
base_lead_angle = "22.6561 deg"
centre_distance = "100.8 mm"
swivel = "0.4404 deg"
axial_shift = "0 mm"
"""
"""The same unit by a design table computed by hand."""


def test_a_drawing_makes_the_drive_of_its_design_table():
    head, rest = TEXT.partition("[drive]")[0], TEXT[TEXT.index("[operation]") :]
    table = case_of(tomllib.loads(head + DESIGN + rest), "table", ROOT)
    by_table, by_drawing = table.drive, unit().drive
    for phase in (0.2, 0.5, 0.8):
        one, other = by_table.contact(phase), by_drawing.contact(phase)
        # the digits of a table move the contact by hundredths of a millimetre
        assert other.point == pytest.approx(one.point, abs=0.05e-3)
        assert other.radii == pytest.approx(one.radii, rel=2e-3)
        assert by_drawing.normal_load(phase) == pytest.approx(by_table.normal_load(phase), rel=0.01)


def test_a_drawing_without_its_hob_has_one_of_the_usual_size():
    case = drawn(('[drive.hob]\noversize = "1.6 mm" # on the reference diameter', ""))
    assert case.drive.geometry_table()["hob_oversize_m"] == pytest.approx(0.8e-3)
    assert any("hob.oversize = 0.8 mm" in one for one in case.drive.assumptions)


@pytest.mark.parametrize(
    "instead",
    [
        [("diameter_factor = 10", ""), in_table("worm", 'reference_diameter = "40 mm"')],
        [("diameter_factor = 10", "profile_shift = -0.5")],
        [("diameter_factor = 10", "diameter_factor = 10\nprofile_shift = -0.5")],
        [
            in_table(
                "worm", 'reference_diameter = "40 mm"\nlead = "25.133 mm"\nlead_angle = "11.31 deg"'
            )
        ],
        [in_table("worm", 'axial_pitch = "12.566 mm"\nbase_diameter = "18.97 mm"')],
        [in_table("wheel", 'reference_diameter = "164 mm"\nthroat_diameter = "168 mm"')],
        [('oversize = "1.6 mm"', 'reference_diameter = "41.6 mm"')],
        [('oversize = "1.6 mm"', 'oversize = "1.6 mm"\nreference_diameter = "41.6 mm"')],
    ],
)
def test_redundant_numbers_that_agree_change_nothing(instead):
    drive = drawn(*instead).drive
    assert drive.worm.base_radius == pytest.approx(unit().drive.worm.base_radius, rel=1e-9)
    assert drive.hob.lead == pytest.approx(unit().drive.hob.lead, rel=1e-9)


def test_a_left_hand_drive_is_the_mirror_image_of_the_right_hand_one():
    left = drawn(('"right"', '"left"'))
    mine, other = left.scene(0.3), unit().scene(0.3)
    assert mine.load == other.load and mine.radii == other.radii
    assert left.drive.geometry_table()["hand"] == "left"
    assert any("mirror image" in one for one in left.drive.assumptions)
    assert not any("mirror image" in one for one in unit().drive.assumptions)


def test_check_prints_the_computed_drawing_back(tmp_path, capsys):
    path = tmp_path / "drawn.toml"
    path.write_text(TEXT)
    assert main(["check", str(path), "--phase", "0.5"]) == 0
    printed = capsys.readouterr().out
    for label, value in (
        ("Lead", "25.133 mm"), ("Lead angle", "11.31 °"), ("Base lead angle", "22.862 °"),
        ("Base diameter", "18.974 mm"), ("Reference diameter", "40 mm"),
        ("Hob swivel", "0.4404 °"), ("Backlash", "0.12 mm"), ("Profile shift", "-0.5"),
    ):  # fmt: skip
        assert re.search(rf"│ {label} +│ +{re.escape(value)} +│", printed), label
    assert "Assumed by common practice: drive.worm.tip_diameter = 48 mm" in printed


def test_check_gives_the_drawing_in_si_units_as_json(tmp_path, capsys):
    path = tmp_path / "drawn.toml"
    path.write_text(TEXT)
    assert main(["check", str(path), "--phase", "0.5", "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    drive = said["drive"]
    assert drive["base_radius_m"] == pytest.approx(9.48695e-3, rel=1e-6)
    assert drive["lead_m"] == pytest.approx(8e-3 * np.pi)
    assert drive["lead_angle_deg"] == pytest.approx(11.3099, abs=1e-4)
    # v_g = d_m1 omega / (2 cos gamma), at 1500 rpm
    assert drive["sliding_speed_m_per_s"] == pytest.approx(
        20e-3 * 50 * np.pi * np.sqrt(1.04), rel=1e-9
    )
    assert drive["pressure_angle_deg"] == pytest.approx(20)
    assert 1.5 < drive["contact_ratio"] < 2.5
    assert abs(drive["pattern_along_face_m"]) < 15e-3
    assert 75e-3 < drive["pattern_radius_m"] < 86e-3
    assert any("hob.axial_shift" in one for one in said["assumptions"])


def test_check_prints_the_pressure_angle_as_given_and_the_normal_one(tmp_path, capsys):
    """Of ZN worms the blade's angle is given, in the middle of the space; the flank has a little less."""
    path = tmp_path / "drawn.toml"
    path.write_text(TEXT.replace('"ZI"', '"ZN"'))
    assert main(["check", str(path), "--phase", "0.5", "--json"]) == 0
    drive = json.loads(capsys.readouterr().out)["drive"]
    assert drive["pressure_angle_deg"] == pytest.approx(20, abs=1e-9)
    assert drive["pressure_angle_of"] == "blade, normal to the thread"
    assert 0.1 < 20 - drive["normal_pressure_angle_deg"] < 0.5


def test_a_centre_distance_follows_from_the_profile_shift():
    """m ((q + z2)/2 + x), and a right shaft angle may be given."""
    case = drawn(
        ('centre_distance = "100 mm"', "profile_shift = -0.5"), in_drive('shaft_angle = "90 deg"')
    )
    assert case.drive.centre_distance == pytest.approx(0.1, rel=1e-12)
    assert case.drive.profile_shift == pytest.approx(-0.5)


def test_a_concave_worm_that_loses_its_contact_point_is_computed_at_the_edge():
    """Cut by a hob 0.76 mm larger it has none from 20 um of centre distance on."""
    case = drawn(
        *(('"ZI"', '"ZC"'), ("teeth = 41", "teeth = 39"), ("factor = 10", "factor = 9.5")),
        *(("1.6 mm", "0.76 mm"), in_table("assembly", 'centre_distance = "20 um"')),
    )
    assert case.drive.edge_contact.boundary == "worm tip"
    assert any("touch at an edge" in one for one in case.warnings)


def test_teeth_may_have_no_backlash():
    assert drawn(in_drive('backlash = "0 mm"')).drive.wheel.backlash == 0


def test_the_standards_take_the_reference_diameter_of_the_drawing():
    rated = """
[worm_rating]
oil = "PAG VG 460"
sump_temperature = "60 degC"
temperature_limit = "100 degC"
wheel_material = "CuSn12Ni2"
life = "25000 h"
"""
    case = drawn(in_table("worm", 'tip_diameter = "47 mm"'), ("[oil]\n", f"{rated}\n[oil]\n"))
    duty = case.drive.duty()
    assert duty.gear.diameter_factor == pytest.approx(10)
    assert duty.gear.profile_shift == pytest.approx(-0.5)
    assert "as drawn" in duty.words[0]
    assert ratings(rating_request(case))


def test_a_stored_drawing_is_the_case_again():
    again = case_again(json.loads(json.dumps(unit().resolved)))
    assert again.tables.model_dump() == unit().tables.model_dump()
    assert again.drive.hob == unit().drive.hob


REFUSED = [
    # counts
    ([("threads = 2", "threads = 41"), ("teeth = 41", "teeth = 2")],
     "drive.threads is 41 with 2 teeth", "swapped? threads = 2, teeth = 41"),
    ([("threads = 2", "threads = 20")], "drive.threads is 20", "1 to 12 threads"),
    ([("threads = 2", "threads = 0")], "drive.threads = 0", "greater than 0"),
    ([("threads = 2", "threads = 2.5")], "drive.threads = 2.5", "whole number"),
    ([("threads = 2\n", "")], "drive.threads is missing", ""),
    ([("teeth = 41", "teeth = 14")], "drive.centre_distance is 100 mm", "and teeth make 48 mm"),
    # pressure angle
    ([('"20 deg"', '"0 deg"')], "drive.pressure_angle is 0 deg", '"20 deg"'),
    ([('"20 deg"', '"60 deg"')], "drive.pressure_angle is 60 deg", "10 to 30 deg"),
    ([('"20 deg"', '"-20 deg"')], 'drive.pressure_angle = "-20 deg"', "zero or more"),
    ([('"20 deg"', "20")], "drive.pressure_angle = 20", "with its unit"),
    # shaft angle and grade
    ([in_drive('shaft_angle = "85 deg"')], "drive: shaft_angle is 85 deg", "axes at 90 deg"),
    ([in_drive("quality = 7")], "drive: quality: nothing is computed by a grade", "[drive.assembly]"),
    # centre distance
    ([('"100 mm"', '"200 mm"')], "drive.centre_distance is 200 mm", "is it twice the distance?"),
    ([('"100 mm"', '"50 mm"')], "drive.centre_distance is 50 mm", "make 102 mm"),
    ([('"100 mm"', "100")], "drive.centre_distance = 100", "with its unit"),
    ([('"100 mm"', '"100,5 mm"')], 'drive.centre_distance = "100,5 mm"', 'write "100.5 mm"'),
    ([('centre_distance = "100 mm"\n', "")], "drive: centre_distance is missing (a)", "give profile_shift"),
    ([in_drive("profile_shift = 0.5")], "drive.profile_shift is 0.5", "give -0.5"),
    ([in_drive("profile_shift = -0.48")], "drive.profile_shift is -0.48", "give -0.5"),
    # module and diameter factor
    ([('"4 mm"', '"0.4 mm"')], "drive.centre_distance is 100 mm", "make 10.2 mm"),
    ([('"4 mm"', "4")], "drive.module = 4", "with its unit"),
    ([("module = ", "modul = ")], "drive.modul: no such key", "did you mean module"),
    ([("diameter_factor = 10", "diameter_factor = 40")], "drive.centre_distance is 100 mm", "make 162 mm"),
    ([("diameter_factor = 10", "diameter_factor = 2")], "drive.diameter_factor is 2", "4 to 40"),
    ([('module = "4 mm"', "")], "drive.module is missing (axial, m)", "worm.base_diameter"),
    ([("diameter_factor = 10", "")], "drive: diameter_factor is missing", "worm.reference_diameter"),
    # worm
    ([in_table("worm", 'tip_radius = "24 mm"')], "drive.worm: tip_radius", "give tip_diameter"),
    ([in_table("worm", 'lead_angle = "12 deg"')], "drive.worm.lead_angle is 12.00 deg", "give 11.31 deg"),
    ([in_table("worm", 'tip_relief = "20 um"\ntip_relief_length = "9 mm"')],
     "drive.worm.tip_relief_length is 9 mm", "the tooth's height"),
    # wheel
    ([in_table("wheel", 'throat_radius = "84 mm"')], "drive.wheel: throat_radius", "give throat_diameter"),
    ([in_table("wheel", 'root_diameter = "153 mm"')], "drive.worm.tip_diameter is 48", "wheel.root_diameter"),
    ([('"30 mm"', '"300 mm"')], "drive.face_width is 300 mm", "30.533 mm"),
    ([('"30 mm"', '"2 mm"')], "drive.face_width is 2 mm", "30.533 mm"),
    ([in_drive('backlash = "6 mm"')], "drive.backlash is 6 mm", "0.12 mm"),
    # hob
    ([('"1.6 mm"', '"-1.6 mm"')], "drive.hob.oversize is -1.6 mm", "smaller than the worm"),
    ([('oversize = "1.6 mm"', 'oversize = "41.6 mm"')], "drive.hob.oversize is 41.6 mm", "at most 10 mm"),
    ([in_table("hob", 'swivel = "3 deg"')],
     "drive.hob.swivel, hob.axial_shift and hob.centre_distance are 3 deg", "face ends"),
    ([in_table("hob", 'axial_shift = "20 mm"')], "drive.hob.swivel, hob.axial_shift and", "20 mm"),
    # hand and profile
    ([('"right"', '"links"')], 'drive.hand = "links"', '"right" or "left"'),
    ([('"ZI"', '"globoid"')], 'drive.profile = "globoid"', "roller-worm"),
    ([('"ZI"', '3')], "drive.profile", 'must be one of "ZA", "ZN"'),
    ([('"ZI"', '"XX"')], 'drive.profile = "XX"', 'must be one of "ZA", "ZN", "ZI", "ZK", "ZC"'),
    ([in_table("worm", 'disc_diameter = "500 mm"')], "drive.worm.disc_diameter belongs to", '"ZK" and "ZC"'),
    ([('"ZI"', '"ZK"'), in_table("worm", 'arc_radius = "24 mm"')], "drive.worm.arc_radius belongs", '"ZC"'),
    ([('"ZI"', '"ZA"'), in_table("worm", 'base_diameter = "19 mm"')],
     "drive.worm.base_diameter belongs", '"ZI"'),
    ([('"ZI"', '"ZN"'), ('"1.6 mm"', '"0 mm"')], "drive.hob.oversize is 0 mm", "0.8 mm"),
    ([('"ZI"', '"ZK"'), in_table("worm", 'disc_diameter = "20 mm"')],
     "drive.worm.disc_diameter is 20 mm", "larger than the worm, 40 mm"),
    ([('"ZI"', '"ZC"'), in_table("worm", 'arc_radius = "4 mm"')],
     "drive.worm.arc_radius is 4 mm", "20 mm to 28 mm"),
    ([('"ZI"', '"ZC"'), ('"20 deg"', '"12 deg"'),
      in_table("worm", 'arc_radius = "12 mm"\ndisc_diameter = "45 mm"')],
     "drive.worm.disc_diameter, worm.arc_radius and pressure_angle do not fit",
     "a disc of 45 mm leaves no flank from 40 to 51.2 mm"),
    ([('"ZI"', '"ZC"')], "drive.profile_shift is -0.5", "0.5 to 1"),
    ([('"ZI"', '"ZC2"'), ('"20 deg"', '"12 deg"'), in_table("worm", 'arc_radius = "14 mm"')],
     "drive.worm.arc_radius and pressure_angle do not fit", "the flank from 14 mm to 25.6 mm"),
    ([('"ZI"', '"ZC2"'), in_table("worm", 'disc_diameter = "500 mm"')],
     "drive.worm.disc_diameter belongs to", '"ZK" and "ZC"'),
    ([('"ZI"', '"Globoid"')], 'drive.profile = "Globoid"', "roller-worm"),
    ([('"ZI"', '"ZH"')], 'drive.profile = "ZH"', 'did you mean "ZC"?'),
    ([('"ZI"', '"zi"')], 'drive.profile = "zi"', 'did you mean "ZI"?'),
    ([('"1.6 mm"', '"0 mm"')], "drive.hob.oversize is 0 mm", "contact along a line"),
    ([in_table("hob", 'centre_distance = "99 mm"')], "drive.hob.centre_distance is 99 mm", "47.6 mm, below"),
    ([in_table("hob", 'centre_distance = "100 mm"')],
     "drive.hob.swivel, hob.axial_shift and hob.centre_distance are 0.4404 deg, 0 mm and 100 mm", "set-up"),
    ([('"4 mm"', '"4 cm"')], "drive.centre_distance is 100 mm", "a module of 3.9216 mm would need none"),
    ([in_table("assembly", 'centre_distance = "100.1 mm"')],
     "drive.centre_distance with assembly.centre_distance, a difference of 100.1 mm,", "108.00 mm"),
    ([in_table("assembly", 'axial_shift = "5 mm"')],
     "drive at phase 0.5: assembly: with the worm 0 mm farther from the wheel, 5 mm along", "the teeth jam"),
    ([in_table("assembly", 'shaft_angle = "90 deg"')], "drive.assembly: with the worm", "90 deg tilted"),
    # words of drawings
    ([("threads = 2", "z1 = 2")], "drive.z1: no such key", "give threads instead"),
    ([("teeth = 41", "ratio = 20.5")], "drive.ratio: no such key", "give threads and teeth instead"),
    ([in_drive('lead_angle = "11.31 deg"')], "drive.lead_angle: no such key", "give worm.lead_angle instead"),
    ([in_table("worm", 'addendum = "4 mm"')], "drive.worm.addendum: no such key", "give tip_diameter"),
    ([in_table("wheel", 'face_width = "30 mm"')], "drive.wheel.face_width: no such key", "give drive.face"),
    ([in_table("wheel", 'tip_diameter = "168 mm"')], "drive.wheel.tip_diameter: no such key", "throat_dia"),
    ([in_table("hob", 'edge_radius = "1 mm"')], "drive.hob.edge_radius: no such key", "wheel.fillet_radius"),
    ([in_table("hob", 'tip_diameter = "51 mm"')], "drive.hob.tip_diameter has no effect", "wheel.root_dia"),
    ([('kind = "worm"', 'kind = "wurm"')], 'drive.kind = "wurm"', '"worm"'),
]  # fmt: skip

WRONG_SIZES = [
    ("worm.tip_diameter", "24 mm", "is it a radius?"),
    ("worm.tip_diameter", "39 mm", "above the reference diameter"),
    ("worm.tip_diameter", "96 mm", "did you mean 48 mm?"),
    ("worm.root_diameter", "15.2 mm", "is it a radius?"),
    ("worm.root_diameter", "42 mm", "below the reference diameter"),
    ("worm.lead", "12.566 mm", "give 25.1327 mm"),
    ("worm.reference_diameter", "20 mm", "is it a radius?"),
    ("worm.reference_diameter", "44 mm", "give 40 mm"),
    ("worm.base_diameter", "9.487 mm", "is it a radius?"),
    ("worm.axial_pitch", "12 mm", "give 12.5664 mm"),
    ("worm.thickness", "12 mm", "6.2832 mm"),
    ("worm.fillet_radius", "3 mm", "which is 4.258 mm wide on a diameter of 34.41 mm"),
    ("wheel.fillet_radius", "9 mm", "as a rule it is 0.2 modules, 0.8 mm"),
    ("wheel.throat_diameter", "16 mm", "groove_radius"),
    ("wheel.throat_diameter", "32 mm", "groove_radius"),
    ("wheel.throat_diameter", "84 mm", "is it a radius?"),
    ("wheel.throat_diameter", "159 mm", "twice the addendum"),
    ("wheel.throat_diameter", "171 mm", "worm.root_diameter"),
    ("wheel.outside_diameter", "86 mm", "is it a radius?"),
    ("wheel.outside_diameter", "160 mm", "throat's"),
    ("wheel.root_diameter", "75.2 mm", "is it a radius?"),
    ("wheel.groove_radius", "84 mm", "16 mm as a rule"),
    ("wheel.reference_diameter", "82 mm", "is it a radius?"),
    ("wheel.reference_diameter", "160 mm", "give 164 mm"),
    ("hob.reference_diameter", "43 mm", "give 41.6 mm"),
]
"""Key, its value and what would be right."""


@pytest.mark.parametrize(("key", "value", "right"), WRONG_SIZES)
def test_a_wrong_size_is_refused_at_its_key_with_what_would_be_right(key, value, right):
    part, name = key.split(".")
    with pytest.raises(CaseError) as refused:
        drawn(in_table(part, f'{name} = "{value}"'))
    message = str(refused.value)
    assert message.startswith(f"drive.{key} is {value}")
    assert right in message
    assert "\n" not in message


@pytest.mark.parametrize(("changes", "begins", "right"), REFUSED, ids=[row[1] for row in REFUSED])
def test_a_wrong_drawing_is_refused_at_its_key_with_what_would_be_right(changes, begins, right):
    with pytest.raises(CaseError) as refused:
        drawn(*changes)
    message = str(refused.value)
    assert message.startswith(begins)
    assert right in message
    assert "\n" not in message


def test_other_names_of_keys_are_those_of_keys_that_there_are():
    drive = WormDriveTable
    tables = {
        "drive": drive,
        **{part: drive.model_fields[part].annotation for part in ("worm", "wheel", "hob")},
    }
    for name, table in tables.items():
        for called, right in table.also_called.items():
            assert called not in table.model_fields
            for key in right.split(" and "):
                at = drive if name == "drive" or key.startswith("drive.") else table
                *above, last = key.removeprefix("drive.").split(".")
                for part in above:
                    at = at.model_fields[part].annotation
                    at = get_args(at)[0] if get_args(at) else at
                assert last in at.model_fields, (name, called)


def test_a_worm_softer_than_its_wheel_gives_a_warning():
    swapped = drawn(
        ('material = "16MnCr5"', 'material = "X"'),
        ('material = "CuSn12Ni2-C-GZ"', 'material = "16MnCr5"'),
        ('material = "X"', 'material = "CuSn12Ni2-C-GZ"'),
    )
    (said,) = swapped.warnings
    assert said.startswith(
        "drive.worm has flanks of a hardness of 0.93 GPa, softer than the wheel's 6.7"
    )
    assert unit().warnings == ()


def test_teeth_that_part_before_the_next_ones_meet_give_a_warning():
    aside = drawn(in_table("hob", 'axial_shift = "0.9 mm"'))
    (said,) = aside.warnings
    assert said.startswith("drive.wheel: its contact ratio is 0.18, below 1")
    assert aside.drive.mean_teeth_in_contact == pytest.approx(0.18, abs=0.005)


def test_a_large_profile_shift_gives_a_warning():
    (said,) = drawn(('"100 mm"', '"107 mm"')).warnings
    assert said.startswith(
        "drive.centre_distance is 107 mm, which asks for a profile shift of 1.25"
    )


def test_a_roughness_may_be_a_mean_peak_to_valley_height():
    """Ra = Rz/6, and Rq = sqrt(pi/2) Ra of heights spread normally."""
    body = BodyTable(material="CuSn12", roughness_rz="3 um").body(unit().drive.oil)
    assert body.roughness == pytest.approx(np.sqrt(np.pi / 2) * 0.5e-6, rel=1e-3)
