"""Which interpreters `make wheel` finds."""

import os
import subprocess
import sys

from folders import ROOT

TOOL = ROOT / "tools/pythons.py"


def found(path, *, says=None):
    done = subprocess.run(
        [sys.executable, TOOL],
        env=os.environ | {"PATH": str(path)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert says is None or says in done.stderr
    return done.stdout.split()


def interpreter(folder, name, answer):
    """A file that answers as an interpreter would."""
    file = folder / name
    file.write_text(f"#!/bin/sh\n{answer}\n")
    file.chmod(0o755)
    return str(file)


def test_there_is_one_for_each_version_the_first_of_the_path(tmp_path):
    folders = [tmp_path / name for name in ("first", "second")]
    for folder in folders:
        folder.mkdir()
        interpreter(folder, "python3.98", "echo 'cpython|3|98'")
    other = interpreter(folders[1], "python3.99", "echo 'cpython|3|99'")
    path = os.pathsep.join(map(str, folders))
    assert found(path) == [sys.executable, str(folders[0] / "python3.98"), other]


def test_what_is_too_old_or_dead_or_another_kind_is_left_out(tmp_path):
    interpreter(tmp_path, "python3.9", "echo 'cpython|3|9'")
    interpreter(tmp_path, "python3.97", "echo 'pypy|3|97'")
    interpreter(tmp_path, "python3.98", "exit 127")
    interpreter(tmp_path, "python3.99-config", "echo 'cpython|3|99'")
    assert found(tmp_path) == [sys.executable]


def test_what_cannot_build_is_told(tmp_path):
    interpreter(tmp_path, "python3.98", "echo 'cpython|3|98|venv|Python.h'")
    assert found(tmp_path, says="it has no venv, no Python.h") == [sys.executable]
