"""Odd surroundings: no home, another encoding, nowhere to write, two threads, one kill after another."""

import json
import os
import pickle
import shutil
import subprocess
import sys
import threading
from dataclasses import asdict

import numpy as np
import pytest
import xarray
from folders import CASES, DATA
from killed import killed_and_resumed
from refusals import changed

import pyworm
from pyworm.cli.main import main
from pyworm.io import cache
from pyworm.io.cache import cache_directory
from pyworm.result.result import open_result
from pyworm.scene.summary import scene_summary
from pyworm.solver.cost.calibration import calibration

POINT = (CASES / "point_m20_l10.toml").read_text()
COARSE = ("--accuracy", "30%", "--effects", "isothermal", "--pictures", "none")


def in_process(*words, directory, **surroundings):
    """A Python process with other environment variables; None removes one."""
    environment = {**os.environ, **surroundings}
    return subprocess.run(
        [sys.executable, *map(str, words)],
        capture_output=True,
        cwd=directory,
        env={name: value for name, value in environment.items() if value is not None},
        check=False,
    )


@pytest.fixture
def case(tmp_path):
    """A case whose title and source are not in ASCII."""
    text = changed(POINT, ('title = "', 'title = "Stößel µ 潤滑 '))
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    return tmp_path


NO_HOME = {"HOME": "/nonexistent/home", "XDG_CACHE_HOME": None, "MPLCONFIGDIR": None}
FULL_HOME = {"HOME": "/proc", "XDG_CACHE_HOME": "/proc/cache"}  # where nothing can be made
ASCII = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
LATIN = {"LC_ALL": "C.UTF-8", "PYTHONIOENCODING": "latin-1", "PYTHONUTF8": "0"}


COMMANDS = (
    ("check", "case.toml"),
    ("film", "case.toml"),
    ("run", "case.toml", *COARSE, "--out", "out"),
    ("report", "out/result.nc"),
    ("explore", "out/result.nc"),
    ("rate", DATA / "attacked_pair.toml"),
    ("surface", CASES / "surfaces/ground.toml"),
)

ALL = """
import json, sys
from pyworm.cli.main import main
from pyworm.solver.cost import calibration
calibration.calibrate = lambda: calibration._read(json.loads(sys.argv[2]))
print([main(words) for words in json.loads(sys.argv[1])], file=sys.stderr)
"""
"""Several commands in one process, their exit codes at the end of standard error. The speed of the machine,
which is measured again where it cannot be cached, is given: its measurement takes as long as all of them."""


def all_commands(directory, before="", **surroundings):
    """The commands in a process of their own, after some other lines of Python."""
    commands = json.dumps([list(map(str, words)) for words in COMMANDS])
    speed = json.dumps(asdict(calibration()))
    return in_process("-c", before + ALL, commands, speed, directory=directory, **surroundings)


@pytest.mark.parametrize(
    "odd",
    [NO_HOME | ASCII, pytest.param(FULL_HOME | LATIN, marks=pytest.mark.long)],
    ids=["nohome, C", "full, latin"],
)
def test_every_command_works_in_odd_surroundings(case, odd):
    done = all_commands(case, **odd)
    assert b"Traceback" not in done.stderr, done.stderr
    assert done.stderr.split(b"\n")[-2] == b"[0, 0, 0, 0, 0, 0, 0]", done.stderr
    assert "Stößel µ 潤滑" in (case / "out/report.html").read_text(encoding="utf-8")
    assert "Stößel µ 潤滑" in (case / "out/explore.html").read_text(encoding="utf-8")


TURKISH = """
import locale
locale.setlocale(locale.LC_ALL, "")
assert locale.localeconv()["decimal_point"] == ",", locale.setlocale(locale.LC_ALL)
"""
"""What a program of which pyworm is a part may have done: all of the C library speaks its language."""


@pytest.fixture(params=[pytest.param("UTF-8", marks=pytest.mark.long), "ISO-8859-9"])
def turkish(request, tmp_path_factory):
    """Environment of Turkish: an i without a dot, a comma in numbers, and a character set of its own.

    Locales of the machine are not touched: this one is made in a directory.
    """
    if shutil.which("localedef") is None:
        pytest.skip("no localedef on this machine")
    locales, charset = tmp_path_factory.mktemp("locales"), request.param
    name = f"tr_TR.{charset}"
    # it warns of what a character set lacks, and exits with 1 then, but writes the locale (--force)
    words = ("localedef", "--force", "-i", "tr_TR", "-f", charset, str(locales / name))
    built = subprocess.run(words, capture_output=True, text=True, check=False)
    if not (locales / name / "LC_NUMERIC").is_file():
        pytest.skip(f"localedef makes no {name} here: {built.stderr.strip()[-200:]}")
    return {"LC_ALL": name, "LOCPATH": str(locales), "PYTHONUTF8": "0"}


def test_every_command_works_in_turkish(case, turkish):
    done = all_commands(case, TURKISH, **turkish)
    assert b"Traceback" not in done.stderr, done.stderr
    assert done.stderr.split(b"\n")[-2] == b"[0, 0, 0, 0, 0, 0, 0]", done.stderr
    said = (case / "out/report.html").read_text(encoding="utf-8")
    assert "Stößel µ 潤滑" in said
    (figures,) = open_result(case / "out/result.nc").solutions
    scene = pyworm.load(case / "case.toml").scene()
    plain = pyworm.solve(scene, pyworm.plan(scene, 0.3, "isothermal"))
    assert figures.figures == plain.figures


def test_a_user_without_a_home_has_a_cache(monkeypatch, tmp_path):
    def homeless():
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(cache.Path, "home", homeless)
    monkeypatch.setattr(cache, "gettempdir", lambda: str(tmp_path))
    assert cache_directory() == tmp_path / "pyworm"


# -------------------------------------------------------------------------- threads and pickles


def solved(name):
    scene = pyworm.load(CASES / f"{name}.toml").scene()
    return pyworm.solve(scene, pyworm.plan(scene, 0.1, "isothermal"))


def test_two_threads_solve_as_one_does():
    """Different contacts at once, and the same one twice: the same bits as one after the other."""
    names = ("point_m20_l10", "line_m20_l10", "point_m20_l10")
    alone = {name: solved(name) for name in set(names)}
    found = [None] * len(names)

    def work(place):
        found[place] = solved(names[place])

    threads = [threading.Thread(target=work, args=(place,)) for place in range(len(names))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for name, one in zip(names, found, strict=True):
        assert one is not None
        assert one.figures == alone[name].figures
        np.testing.assert_array_equal(one.fields["pressure"], alone[name].fields["pressure"])


def same_contact(one, other):
    """Whether two contacts have the same numbers, to the last bit."""
    return scene_summary(one) == scene_summary(other) and one.oil == other.oil


@pytest.mark.parametrize(
    "name", ["impact_ball", "starved_ball", "attacked_line", "attacked_pair", "zi_cooled"]
)
def test_a_case_with_new_features_is_itself_after_pickling(name):
    folder = DATA if name.startswith("attacked") else CASES
    case = pyworm.load(folder / f"{name}.toml")
    again = pickle.loads(pickle.dumps(case))
    assert again.resolved == case.resolved
    scene = case.scene()
    copy = pickle.loads(pickle.dumps(scene))
    # the tooth pairs that a history is made of are not compared: what they make of a time is
    assert same_contact(copy, scene) and same_contact(again.scene(), scene)
    if scene.past is not None:
        moment = 0.3 * scene.past.life.duration
        assert same_contact(copy.past.life.at(moment), scene.past.life.at(moment))


def test_a_plan_and_what_is_found_with_it_are_themselves_after_pickling(tmp_path):
    scene = pyworm.load(CASES / "point_m20_l10.toml").scene()
    plan = pyworm.plan(scene, 0.3, "isothermal")
    again = pickle.loads(pickle.dumps(plan))
    assert again == plan
    found = pyworm.solve(scene, plan)
    assert pyworm.solve(scene, again).figures == found.figures
    copy = pickle.loads(pickle.dumps(found))
    assert copy.figures == found.figures
    xarray.testing.assert_identical(copy.fields, found.fields)
    words = ["run", str(CASES / "point_m20_l10.toml"), *COARSE, "--out", str(tmp_path)]
    assert main(words) == 0
    result = open_result(tmp_path / "result.nc")
    same = pickle.loads(pickle.dumps(result))
    assert same.provenance == result.provenance
    for one, other in zip(result.solutions, same.solutions, strict=True):
        assert one.figures == other.figures
        xarray.testing.assert_identical(one.fields, other.fields)


# ------------------------------------------------------------------------ killed and resumed


@pytest.mark.long
def test_a_batch_that_is_killed_twenty_times_ends_with_the_same_bits(tmp_path):
    assert killed_and_resumed(print, tmp_path) == []
