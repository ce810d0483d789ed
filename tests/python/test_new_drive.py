"""A drive is added as docs/how-to/add-a-drive.md says, by a package of its own; all commands know it."""

import json
import re
import tomllib

import pytest
from source_copy import ROOT, Folder

from pyworm.drives.kinds import BUILT_IN, KINDS
from pyworm.result.result import open_result

PAGE = (ROOT / "docs/how-to/add-a-drive.md").read_text()
CASE = "cases/eccentric_cam.toml"
EXAMPLE = ROOT / "examples/eccentric_cam"
FILES = {
    file.relative_to(EXAMPLE).as_posix(): file.read_text()
    for folder in (".", "cases", "eccentric_cam")
    for file in sorted((EXAMPLE / folder).glob("*"))
    if file.suffix in (".py", ".toml")
}
"""Files of the example: name -> content."""


@pytest.fixture(scope="module")
def outside(tmp_path_factory) -> Folder:
    """A folder with the package of the page, installed beside pyworm as an installer leaves it."""
    installed = Folder(tmp_path_factory.mktemp("installed"))
    for name, content in FILES.items():
        installed.write(name, content)
    project = tomllib.loads(FILES["pyproject.toml"])["project"]
    about = f"{project['name'].replace('-', '_')}-{project['version']}.dist-info"
    installed.write(
        f"{about}/METADATA", f"Name: {project['name']}\nVersion: {project['version']}\n"
    )
    ((group, points),) = project["entry-points"].items()
    lines = [f"{name} = {package}" for name, package in points.items()]
    installed.write(f"{about}/entry_points.txt", "\n".join([f"[{group}]", *lines]))
    return installed


@pytest.fixture(scope="module")
def ran(outside) -> str:
    """What `pyworm run` prints."""
    return outside.pyworm("run", CASE, "--out", "results")


def test_a_drive_is_one_folder_outside_of_pyworm():
    assert sorted(FILES) == [
        CASE,
        "eccentric_cam/__init__.py",
        "eccentric_cam/case.py",
        "eccentric_cam/drive.py",
        "eccentric_cam/plots.py",
        "pyproject.toml",
    ]
    assert all(f"`{name}`" in PAGE for name in FILES if "__init__" not in name)


def test_its_kind_is_known_where_it_is_installed_alone(outside):
    ended = outside.python("-c", "from pyworm.drives.kinds import KINDS; print(*KINDS)")
    assert ended.stdout.split() == [*KINDS, "eccentric-cam"]
    assert KINDS == BUILT_IN


def test_it_is_checked_and_planned(outside):
    told = json.loads(outside.pyworm("check", CASE, "--json"))
    assert len(told["scenes"]) == 3


def test_parts_that_do_not_fit_are_refused(outside):
    text = FILES[CASE]
    (outside.root / "wide.toml").write_text(text.replace('"4 mm"', '"20 mm"'))
    ended = outside.python("-m", "pyworm.cli", "check", "wide.toml")
    assert ended.returncode == 2
    assert "drive.eccentricity is 20 mm; it must be below drive.radius, 16 mm" in ended.stderr


def test_it_is_solved_and_drawn(outside, ran):
    result = open_result(outside.root / "results/result.nc")
    assert [solution.phase for solution in result.solutions] == [0.05, 0.25, 0.5]
    films = [solution.figures.film_min.value for solution in result.solutions]
    assert films[0] < films[1] < films[2]  # as entrainment rises
    assert result.mesh_cycle.attrs["drive"] == "eccentric-cam"
    assert (outside.root / "results/entrainment.png").stat().st_size > 0
    assert "Eccentric cam against a flat tappet" in ran


def test_its_report_says_what_it_knows_and_what_not(outside, ran):
    outside.pyworm("report", "results/result.nc", "--out", "report.html")
    report = (outside.root / "report.html").read_text()
    for said in (
        "Entrainment over a turn",
        "The tappet presses with the same force all the time and does not turn.",
        "How misalignment changes the contacts of this gear set is not known in closed form.",
        "only drives of kind worm, gear-pair, roller-worm are",
    ):
        assert said in report


def test_python_plans_it_as_the_page_prints(outside):
    code, printed = re.search(
        r"^```python\n(import pyworm\n.*?)^```\n\nprints\n\n```\n(.*?)^```$", PAGE, re.M | re.S
    ).groups()
    ended = outside.python("-c", code)
    assert ended.stdout == printed, ended.stderr


@pytest.fixture
def rated(outside):
    """The package with the case that may ask for ratings."""
    module = outside.root / "eccentric_cam/case.py"
    own = module.read_text()
    asking = own.replace("pyworm.case.drive_case", "pyworm.case.ratings")
    module.write_text(asking.replace("DriveCase", "RatedCase"))
    yield outside
    module.write_text(own)


def test_films_are_all_that_is_rated_of_a_drive_that_no_standard_knows(rated):
    told = json.loads(rated.pyworm("rate", CASE, "--json"))
    assert [one["rating"] for one in told["ratings"]] == ["films"]
    assert told["not_rated"] == [
        "Teeth or rollers: no standard that is known here covers this kind of gears.",
        "Bearings: the case has no [bearings.NAME].",
    ]


def test_no_oil_is_chosen_for_it(rated):
    wanted = re.search(r"^\[oil_choice\]\n(.+\n)+", (ROOT / "cases/oil_zi.toml").read_text(), re.M)
    (rated.root / "wanted.toml").write_text(FILES[CASE] + "\n" + wanted[0])
    ended = rated.python("-m", "pyworm.cli", "oil", "choose", "wanted.toml")
    assert ended.returncode == 2
    assert "no oil can be chosen for gears of this kind" in ended.stderr
