"""The suite of random gear drives: its draws, and what it takes for a fault of a command."""

import sys
from math import acos, atan, cos, radians, tan

import drive_trial
import pytest
from draws import Drawn
from drive_report import complaints_of_drives, counts, in_time
from drive_trial import DriveTrial, DriveVerdict, drive_verdict, walked
from gear_draws import (
    ACCURACY_CLASSES,
    CENTRE_DISTANCE,
    FASTEST,
    KINDS,
    PROFILES,
    RATIO,
    TEETH,
    THREADS,
    WORM_SPEED,
    drive,
)
from promise import DRIVES

from pyworm.case.case import case_of

MANY = [drive(number) for number in range(400)]
WORMS = [one for one in MANY if one.traits["kind"] == "worm"]


def test_a_drive_depends_on_its_number_and_seed_alone():
    assert drive(17) == drive(17) == MANY[17]
    assert drive(17, seed=3) != drive(17)


def test_every_ten_drives_have_the_kinds_of_the_suite():
    assert [one.traits["kind"] for one in MANY] == list(KINDS) * 40


def test_worm_sets_cover_what_they_are_to_cover():
    assert {one.traits["profile"] for one in WORMS} == set(PROFILES)
    assert {one.traits["threads"] for one in WORMS} == set(THREADS)
    drives = [one.tables["drive"] for one in WORMS]
    assert {table["hand"] for table in drives} == {"right", "left"}
    assert {one.tables["operation"]["driver"] for one in WORMS} == {"worm", "wheel"}
    assert {one.tables["oil"]["name"] for one in WORMS} >= {"mineral VG 68", "PAG VG 1000"}
    for name, covered, part in (
        ("centre_distance", CENTRE_DISTANCE, 0.9),
        ("ratio", RATIO, 0.9),
        ("rpm", WORM_SPEED, 0.6),
    ):
        values = [one.traits[name] for one in WORMS]
        assert min(values) >= covered.low and max(values) <= covered.high
        assert max(values) / min(values) > (covered.high / covered.low) ** part


@pytest.mark.parametrize("one", WORMS[:60], ids=lambda one: one.tables["title"])
def test_numbers_of_a_worm_set_belong_together(one):
    table = one.tables["drive"]
    module, factor = float(table["module"].split()[0]), table["diameter_factor"]
    distance = float(table["centre_distance"].split()[0])
    shift = distance / module - (factor + table["teeth"]) / 2
    assert -0.2 - 1e-6 < shift < 0.8 + 1e-6
    assert table["teeth"] in TEETH
    assert one.traits["rpm"] / 60 * 3.1416 * factor * module * 1e-3 < FASTEST * 1.001
    # tolerance grades 6 to 9 of a centre distance of 25 to 400 mm are 13 to 140 um wide (ISO 286-1)
    assert len(ACCURACY_CLASSES) == 4
    assert abs(float(table["assembly"]["centre_distance"].split()[0])) < 70


@pytest.mark.parametrize("number", [7, 8, 17, 18])
def test_the_centre_distance_of_a_pair_is_that_of_its_profile_shifts(number):
    table = drive(number).tables["drive"]
    helix, teeth = radians(float(table["helix_angle"].split()[0])), 0
    shifts = 0.0
    for name in ("pinion", "gear"):
        teeth += table[name]["teeth"]
        shifts += table[name]["profile_shift"]
    angle = tan(radians(20)) / cos(helix)
    module, distance = (float(table[key].split()[0]) for key in ("module", "centre_distance"))
    zero = module * teeth / (2 * cos(helix))
    # a cos(working) = a0 cos(alpha_t); shifts by the difference of involutes (ISO 21771)
    working = acos(zero * cos(atan(angle)) / distance)
    difference = (tan(working) - working) - (angle - atan(angle))
    assert difference * teeth / (2 * tan(radians(20))) == pytest.approx(shifts, abs=1e-5)


@pytest.mark.parametrize("number", [2, 7, 8, 9])
def test_one_of_each_kind_is_a_case(tmp_path, number):
    one = drive(number)
    case = case_of(one.tables, "drawn", tmp_path)
    assert len(case.places()) >= 3


# ------------------------------------------------------------------------- what counts as a fault


@pytest.fixture
def trial(tmp_path):
    drawn = Drawn({"title": "a", "operation": {"phases": [0.1, 0.5]}}, {"kind": "worm"})
    return DriveTrial("drive:0", drawn, tmp_path / "000")


@pytest.fixture
def program(monkeypatch):
    """Put a script in the place of the program."""

    def is_(script):
        monkeypatch.setattr(drive_trial, "PROGRAM", (sys.executable, "-c", script))

    return is_


@pytest.mark.parametrize(
    ("script", "outcome", "flaw"),
    [
        ("print('{}')", "done", None),
        ("import sys; print('pyworm: no', file=sys.stderr); sys.exit(2)", "refused", None),
        (
            "import sys; print('{}'); print('pyworm: no', file=sys.stderr); sys.exit(3)",
            "not converged",
            None,
        ),
        ("1 / 0", "broken", "a traceback: ZeroDivisionError"),
        ("import sys; sys.exit(3)", "broken", "exit code 3 without a reason"),
        (
            "import sys; print('pyworm: p1: NameError: name', file=sys.stderr); sys.exit(3)",
            "broken",
            "an error of the program as a reason: NameError: name",
        ),
        ("import sys; sys.exit(7)", "broken", "exit code 7"),
        ("import os; os.abort()", "broken", "exit code -6"),
        ("import warnings; warnings.warn('odd'); print('{}')", "broken", "a line that is no mess"),
        ("print('no')", "broken", "no JSON on standard output"),
        ("import time; time.sleep(60)", "out of time", "was stopped: it did not end within 60 s"),
        ("while True: pass", "out of time", "was stopped: it did not end within 1 s of processor"),
        (
            "import sys; print('pyworm: still at it', file=sys.stderr); print('{}')",
            "done",
            None,
        ),
    ],
)
def test_what_counts_as_a_fault(trial, program, monkeypatch, script, outcome, flaw):
    program(script)
    monkeypatch.setattr(drive_trial, "LONGEST", 3.0 if "sleep" in script else 60.0)
    done = trial.called("check", "CASE", "--json", limit=1.0 if "while" in script else 60.0)
    assert done.outcome == outcome
    assert bool(done.flaws) == (flaw is not None)
    assert flaw is None or done.flaws[0].startswith(flaw)


def test_what_a_command_came_to_is_kept_for_one_program_and_case(trial, program, monkeypatch):
    program(
        "import time; t = time.process_time()\nwhile time.process_time() < t + 0.2: pass\nprint('{}')"
    )
    assert trial.known("check", "CASE") is None
    done = trial.called("check", "CASE")
    assert trial.known("check", "CASE") == done
    assert 0.2 < done.processor < 5
    monkeypatch.setattr(drive_trial, "program_digest", lambda: "another")
    assert trial.known("check", "CASE") is None


RUN = """
import json, sys
if sys.argv[1] == "check":
    print(json.dumps({"expected_seconds": 3.0, "expected_seconds_of_search": 1.0}))
else:
    scenes = [{"name": "p1", "converged": True, "accurate": True, "stop_reason": ""},
              {"name": "p2", "converged": False, "accurate": False, "stop_reason": "it stopped"}]
    print(json.dumps({"scenes": scenes, "failed": {"p3": "no film"}}))
    print("pyworm: lost", file=sys.stderr)
    sys.exit(3)
"""


def test_the_verdict_counts_phases_and_times(trial, program):
    program(RUN)
    verdict = drive_verdict(trial, "10 %")
    assert (verdict.outcome, verdict.phases, verdict.converged) == ("incomplete", 3, 1)
    assert verdict.expected == 4.0
    assert verdict.reason == "p2: it stopped; p3: no film"
    assert "1/3" in verdict.line and "it stopped" in verdict.line


def test_commands_on_a_result_are_left_out_where_there_is_none(trial, program):
    program("import sys; print('pyworm: no', file=sys.stderr); sys.exit(2)")
    done = list(walked(trial, ["check", "run", "report", "explore"]))
    assert [one.command.split()[0] for one in done] == ["check", "run"]


def came_to(outcome, converged, processor, accuracy="5 %"):
    return DriveVerdict("drive:0", "worm", accuracy, outcome, 5, converged, 1.0, processor, 10.0)


def test_counts_and_broken_promises():
    good, slow = came_to("complete", 5, 12.0), came_to("complete", 5, 21.0)
    lost, broken = came_to("incomplete", 4, 12.0), came_to("broken", 0, 12.0)
    assert in_time(good) and not in_time(slow) and not in_time(came_to("complete", 5, 4.9))
    lines = list(counts([good, slow, lost]))
    assert "of 3 that ran 2 cycles are complete, 14 of 15 phases converged" in lines[0]
    assert "within a factor of 2: 2 of 3" in lines[1]
    assert list(complaints_of_drives([good] * DRIVES)) == []
    assert list(complaints_of_drives([good, broken])) == ["drive:0 at 5 % is broken: "]
    said = list(complaints_of_drives([good] * (DRIVES // 2) + [lost] * (DRIVES // 2)))
    assert said == [
        "90.0% of phases converged at 5 %, 99% are promised",
        "50.0% of cycles are complete at 5 %, 97% are promised",
    ]
    said = list(complaints_of_drives([good] * (DRIVES - 6) + [slow] * 6))
    assert said == ["94.0% of runs took the expected time at 5 %, 95% are promised"]
