"""Odd surroundings: no home, another encoding, nowhere to write, two threads, one kill after another."""

import json
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from refusals import changed

import pyworm
from pyworm.io import cache
from pyworm.io.cache import cache_directory
from pyworm.result.result import open_result

CASES = Path(__file__).parents[3] / "cases"
DATA = Path(__file__).parents[2] / "data"
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


def pyworm_in(directory, *words):
    """A command in a process of its own."""
    return in_process("-m", "pyworm.cli", *words, directory=directory)


@pytest.fixture
def case(tmp_path):
    """A case whose title and source are not in ASCII."""
    text = changed(POINT, ('title = "', 'title = "Stößel µ 潤滑 '))
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    return tmp_path


NO_HOME = {"HOME": "/nonexistent/home", "XDG_CACHE_HOME": None, "MPLCONFIGDIR": None}
FULL_HOME = {"HOME": "/proc", "XDG_CACHE_HOME": "/proc/cache"}  # where nothing can be made
ASCII = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
LATIN = {"PYTHONIOENCODING": "latin-1", "PYTHONUTF8": "0"}


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
print([main(words) for words in json.loads(sys.argv[1])], file=sys.stderr)
"""
"""Several commands in one process, their exit codes at the end of standard error."""


@pytest.mark.parametrize(
    "odd", [NO_HOME, FULL_HOME, ASCII, LATIN], ids=["nohome", "full", "C", "latin"]
)
def test_every_command_works_in_odd_surroundings(case, odd):
    commands = json.dumps([list(map(str, words)) for words in COMMANDS])
    done = in_process("-c", ALL, commands, directory=case, **odd)
    assert b"Traceback" not in done.stderr, done.stderr
    assert done.stderr.split(b"\n")[-2] == b"[0, 0, 0, 0, 0, 0, 0]", done.stderr
    assert "Stößel µ 潤滑" in (case / "out/report.html").read_text(encoding="utf-8")
    assert "Stößel µ 潤滑" in (case / "out/explore.html").read_text(encoding="utf-8")


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


@pytest.mark.parametrize(
    "name", ["impact_ball", "starved_ball", "attacked_line", "attacked_pair", "zi_cooled"]
)
def test_a_case_with_new_features_is_itself_after_pickling(name):
    folder = DATA if name.startswith("attacked") else CASES
    case = pyworm.load(folder / f"{name}.toml")
    again = pickle.loads(pickle.dumps(case))
    assert again.resolved == case.resolved
    scene = case.scene()
    assert pickle.loads(pickle.dumps(scene)) == scene
    assert again.scene().load == scene.load


# ------------------------------------------------------------------------ killed and resumed

CURVE = ("run", CASES / "traction_steel.toml", *COARSE, "--json")


def killed_after(directory, seconds):
    """Kill a run after a time, wherever it is."""
    process = subprocess.Popen(
        [sys.executable, "-m", "pyworm.cli", *map(str, CURVE), "--out", str(directory)],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    time.sleep(seconds)
    process.send_signal(signal.SIGKILL)
    process.wait()


@pytest.mark.long
def test_a_run_that_is_killed_twenty_times_ends_with_the_same_bits(tmp_path):
    began = time.monotonic()
    assert pyworm_in(tmp_path, *CURVE, "--out", "whole").returncode == 0
    taken = time.monotonic() - began
    random = np.random.default_rng(7)
    for _ in range(20):
        killed_after(tmp_path / "killed", float(random.uniform(0.2, 0.7) * taken))
    assert pyworm_in(tmp_path, *CURVE, "--out", "killed").returncode == 0
    whole, again = (open_result(tmp_path / name / "result.nc") for name in ("whole", "killed"))
    assert len(whole.solutions) == len(again.solutions)
    for one, other in zip(whole.solutions, again.solutions, strict=True):
        assert one.figures == other.figures
        for name in one.fields.data_vars:
            np.testing.assert_array_equal(one.fields[name], other.fields[name])
    assert not list((tmp_path / "killed").rglob("*.part"))
