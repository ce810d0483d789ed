"""A drive is added as docs/how-to/add-a-drive.md says, in a copy of the sources, and all commands know it."""

import json
import re
from pathlib import Path

import pytest
from pages import files_written, lines_replaced
from source_copy import ROOT, SourceCopy

from pyworm.result.result import open_result

PAGE = (ROOT / "docs/how-to/add-a-drive.md").read_text()
CASE = "cases/eccentric_cam.toml"


@pytest.fixture(scope="module")
def copy(tmp_path_factory) -> SourceCopy:
    copy = SourceCopy.in_folder(tmp_path_factory.mktemp("new_drive"))
    for name, content in files_written(PAGE).items():
        copy.write(name, content)
    for name, line, assigned in lines_replaced(PAGE):
        before = (copy.root / name).read_text()
        after, count = re.subn(rf"^{assigned} = .*$", line, before, flags=re.M)
        assert count == 1
        copy.write(name, after)
    return copy


@pytest.fixture(scope="module")
def ran(copy) -> str:
    """What `pyworm run` prints."""
    return copy.pyworm("run", CASE, "--out", "results")


def test_a_drive_is_a_folder_three_files_and_a_word():
    assert sorted(files_written(PAGE)) == [
        CASE,
        "pyworm/case/eccentric_cam.py",
        "pyworm/drives/eccentric_cam/__init__.py",
        "pyworm/drives/eccentric_cam/drive.py",
        "pyworm/plots/drives/eccentric_cam.py",
    ]
    ((name, line, _),) = lines_replaced(PAGE)
    assert name == "pyworm/drives/kinds.py"
    (before,) = re.findall("^KINDS = .*$", (ROOT / name).read_text(), re.M)
    assert line == before.replace(")", ', "eccentric-cam")')


def test_the_copy_is_what_runs(copy):
    ended = copy.python("-c", "import pyworm; print(pyworm.__file__)")
    assert Path(ended.stdout.strip()) == copy.root / "pyworm" / "__init__.py"


def test_it_is_checked_and_planned(copy):
    told = json.loads(copy.pyworm("check", CASE, "--json"))
    assert len(told["scenes"]) == 3


def test_parts_that_do_not_fit_are_refused(copy):
    text = files_written(PAGE)[CASE]
    (copy.root / "wide.toml").write_text(text.replace('"4 mm"', '"20 mm"'))
    ended = copy.python("-m", "pyworm.cli", "check", "wide.toml")
    assert ended.returncode == 2
    assert "drive.eccentricity is 20 mm; it must be below drive.radius, 16 mm" in ended.stderr


def test_it_is_solved_and_drawn(copy, ran):
    result = open_result(copy.root / "results/result.nc")
    assert [solution.phase for solution in result.solutions] == [0.05, 0.25, 0.5]
    films = [solution.figures.film_min.value for solution in result.solutions]
    assert films[0] < films[1] < films[2]  # as entrainment rises
    assert result.mesh_cycle.attrs["drive"] == "eccentric-cam"
    assert (copy.root / "results/entrainment.png").stat().st_size > 0
    assert "Eccentric cam against a flat tappet" in ran


def test_its_report_says_what_it_knows_and_what_not(copy, ran):
    copy.pyworm("report", "results/result.nc", "--out", "report.html")
    report = (copy.root / "report.html").read_text()
    for said in (
        "Entrainment over a turn",
        "The tappet presses with the same force all the time and does not turn.",
        "How misalignment changes the contacts of this drive is not known in closed form.",
        "only drives of kind worm, gear-pair, roller-worm are",
    ):
        assert said in report


def test_python_plans_it_as_the_page_prints(copy):
    code, printed = re.search(
        r"^```python\n(import pyworm\n.*?)^```\n\nprints\n\n```\n(.*?)^```$", PAGE, re.M | re.S
    ).groups()
    ended = copy.python("-c", code)
    assert ended.stdout == printed, ended.stderr


@pytest.fixture
def rated(copy):
    """The copy with the case that may ask for ratings."""
    module = copy.root / "pyworm/case/eccentric_cam.py"
    own = module.read_text()
    asking = own.replace("pyworm.case.drive_case", "pyworm.case.ratings")
    module.write_text(asking.replace("DriveCase", "RatedCase"))
    yield copy
    module.write_text(own)


def test_films_are_all_that_is_rated_of_a_drive_that_no_standard_knows(rated):
    told = json.loads(rated.pyworm("rate", CASE, "--json"))
    assert [one["rating"] for one in told["ratings"]] == ["films"]
    assert told["not_rated"] == [
        "Teeth or rollers: no standard that is known here covers this kind of drive.",
        "Bearings: the case has no [bearings.NAME].",
    ]


def test_no_oil_is_chosen_for_it(rated):
    wanted = re.search(r"^\[oil_choice\]\n(.+\n)+", (ROOT / "cases/oil_zi.toml").read_text(), re.M)
    (rated.root / "wanted.toml").write_text(files_written(PAGE)[CASE] + "\n" + wanted[0])
    ended = rated.python("-m", "pyworm.cli", "oil", "choose", "wanted.toml")
    assert ended.returncode == 2
    assert "no oil can be chosen for a drive of this kind" in ended.stderr
