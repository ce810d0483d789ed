"""The hob's set-up for a wanted contact pattern."""

import json
import re

import pytest
from folders import CASES
from refusals import refusal
from zi_drives import without_allowed_errors

import pyworm
from pyworm.cli.main import main
from pyworm.drives.worm.patterns import hob_for_pattern
from pyworm.drives.worm.patterns.hob_for_pattern import TOLERANCES, found_setting, mark_of

pytestmark = pytest.mark.usefixtures("coarse_mesh")

DRAWING = (CASES / "worm_drawing.toml").read_text()


@pytest.fixture(scope="module")
def drive():
    return pyworm.load(CASES / "worm_drawing.toml").drive


def test_the_blurred_mark_is_that_of_the_compound(drive):
    pattern = drive.driven_pattern
    assert mark_of(pattern).size == pytest.approx(pattern.fraction(), rel=0.05)
    first, last = pattern.along_face()
    assert first < mark_of(pattern).face < last


def test_what_cannot_be_reached_is_the_nearest(drive, monkeypatch):
    monkeypatch.setattr(hob_for_pattern, "MOST_STEPS", 1)
    before = mark_of(drive.driven_pattern)
    found = found_setting(drive, {"size": 0.9})
    assert not found.reached
    assert before.size < found.mark.size < 0.9
    assert found.mesh.interference is None


def test_the_command_prints_a_hob_that_marks_so(tmp_path, capsys, monkeypatch):
    """Its life is a larger mark from one regrinding to the next; larger contacts, smaller pressures."""
    monkeypatch.setattr("pyworm.case.worm.HOB_LIFE", (1.0, 0.5))
    without_allowed_errors(monkeypatch)
    path = CASES / "worm_drawing.toml"
    assert main(["setup", str(path), "--place", "-0.5 mm", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    found, life = told["found"], told["hob_life"]
    assert told["reached"] and abs(found["marking_face_m"] + 0.5e-3) <= TOLERANCES["face"]
    hob = "\n".join(
        (
            f'swivel = "{found["hob_swivel_deg"]!r} deg"',
            f'axial_shift = "{found["hob_axial_shift_m"]!r} m"',
            f'centre_distance = "{found["hob_centre_distance_m"]!r} m"',
        )
    )
    (tmp_path / "set.toml").write_text(DRAWING.replace("[drive.hob]", f"[drive.hob]\n{hob}", 1))
    mark = mark_of(pyworm.load(tmp_path / "set.toml").drive.driven_pattern)
    assert mark.face == pytest.approx(found["marking_face_m"], abs=5e-5)
    assert mark.size == pytest.approx(found["marking_fraction"], rel=0.02)
    sizes, pressures = (
        [row[key] for row in life] for key in ("marking_fraction", "dry_pressure_max_Pa")
    )
    assert sizes == sorted(sizes) and pressures == sorted(pressures, reverse=True)


def test_the_command_tells_a_fitter_the_nearest_shim(tmp_path, capsys, monkeypatch):
    """A worm shifted to the entering side, where the other flank would touch at the end of the face only."""
    monkeypatch.setattr("pyworm.drives.worm.patterns.shim.MOST_STEPS", 1)
    path = tmp_path / "shifted.toml"
    text = (CASES / "zi_sharif_2001.toml").read_text()
    path.write_text(text + '\n[drive.assembly]\naxial_shift = "-0.05 mm"\n')
    assert main(["setup", str(path), "--shim", "40 mm"]) == 3
    told = capsys.readouterr()
    assert re.search(r"Shift the wheel 0\.500 mm to the entering side\.", told.out)
    place = re.search(r"other flank: from \S+ mm to (\S+) mm\.", told.out)
    assert float(place[1]) == pytest.approx(30, abs=1)
    assert "Required on the driven flank: +40.00 mm" in told.out
    assert "no shim brings the pattern there" in told.err


@pytest.mark.parametrize(
    ("name", "options", "sentence"),
    [
        ("roller_ref", ["--place", "1mm"], "has no hob that could be set up"),
        (
            "worm_drawing",
            ["--place", "2"],
            "--place 2: must be a place along the face with its unit",
        ),
        ("worm_drawing", ["--size", "150%"], "--size 150%: must lie between 0 and 100 %"),
        ("worm_drawing", ["--shim", "--size", "30%"], "omit --place and --size"),
        ("spur_pair", ["--shim"], "has no wheel that a shim could move; give a worm drive"),
    ],
)
def test_what_cannot_be_set_up_is_refused(tmp_path, capsys, name, options, sentence):
    assert sentence in refusal(["setup", str(CASES / f"{name}.toml"), *options], tmp_path, capsys)


def test_a_worm_gear_without_errors_needs_no_shim(capsys):
    assert main(["setup", str(CASES / "worm_drawing.toml"), "--shim"]) == 0
    assert "The wheel needs no shift." in capsys.readouterr().out
