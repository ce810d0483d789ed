"""Files appear whole or not at all: on disk before they are renamed, and nothing of killed writers stays."""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
from errno import ENOSPC
from pathlib import Path

import pytest

from pyworm.io.atomic import NotWrittenError, atomic_directory, remove_abandoned, whole_file

NOBODY = 65534

KILLED = """
import os, signal, sys
from pathlib import Path
from pyworm.io.atomic import atomic_directory, whole_file
out = Path(sys.argv[1])
with atomic_directory(out) as aside, whole_file(out / "result.nc") as partial:
    (aside / "scene_000_film.png").write_text("half")
    partial.write_text("half")
    os.kill(os.getpid(), signal.SIGKILL)
"""


def names(directory):
    return sorted(path.name for path in directory.rglob("*"))


@pytest.fixture
def ordinary_user():
    """A directory of a user whom permissions bind, as they do not root."""
    directory = Path(tempfile.mkdtemp())
    root = os.geteuid() == 0
    if root:
        os.chown(directory, NOBODY, NOBODY)
        os.seteuid(NOBODY)
    yield directory
    if root:
        os.seteuid(0)
    directory.chmod(0o700)
    shutil.rmtree(directory)


def test_a_directory_is_written_to_whose_parent_is_closed_to_writing(ordinary_user):
    out = ordinary_user / "out"
    out.mkdir()
    ordinary_user.chmod(0o500)
    with pytest.raises(PermissionError):
        (ordinary_user / "other").mkdir()
    with atomic_directory(out) as aside:
        (aside / "picture.png").write_text("whole")
    with whole_file(out / "result.nc") as partial:
        partial.write_text("whole")
    assert names(out) == ["picture.png", "result.nc"]


@pytest.mark.parametrize("write", [atomic_directory, whole_file])
def test_a_directory_that_takes_no_files_is_named(write):
    """Such as /proc, which exists, and in which nothing can be made."""
    with (
        pytest.raises(NotWrittenError, match=r"^/proc/result\.nc: cannot be written \("),
        write(Path("/proc/result.nc")),
    ):
        pass


@pytest.mark.parametrize("write", [atomic_directory, whole_file])
def test_a_failure_while_writing_names_what_was_to_be_written(tmp_path, write):
    target = tmp_path / "out"
    with (
        pytest.raises(NotWrittenError, match=rf"^{target}: cannot be written \(No space left on"),
        write(target) as partial,
    ):
        (partial / "file" if partial.is_dir() else partial).write_text("half")
        raise OSError(ENOSPC, os.strerror(ENOSPC))
    assert names(tmp_path) == []


@pytest.mark.parametrize("kind", ["file", "directory"])
def test_content_is_on_disk_before_it_is_renamed(tmp_path, monkeypatch, kind):
    """Else a power cut may leave the new name with nothing in it."""
    done = []
    real = {name: getattr(os, name) for name in ("fsync", "replace")}

    def synced(handle):
        done.append((os.fstat(handle).st_ino, "on disk"))
        real["fsync"](handle)

    def renamed(old, new):
        done.append((os.stat(old).st_ino, "renamed"))
        real["replace"](old, new)

    monkeypatch.setattr(os, "fsync", synced)
    monkeypatch.setattr(os, "replace", renamed)
    target = tmp_path / "out" / "file"
    if kind == "file":
        with whole_file(target) as partial:
            partial.write_text("whole")
    else:
        with atomic_directory(target.parent) as aside:
            (aside / target.name).write_text("whole")
    inode = target.stat().st_ino
    assert done == [(inode, "on disk"), (inode, "renamed")]


def test_the_next_write_removes_files_of_killed_processes_only(tmp_path):
    out = tmp_path / "out"
    ended = subprocess.run([sys.executable, "-c", KILLED, str(out)], check=False)
    assert ended.returncode == -signal.SIGKILL
    assert (
        len(names(tmp_path)) == 4
    )  # the directory, what was collected and in it a picture, a file
    with whole_file(out / "live.nc") as partial, atomic_directory(out) as aside:
        partial.write_text("whole")
        (aside / "live.png").write_text("whole")
        remove_abandoned(out)
        assert sorted(path.name for path in out.iterdir()) == sorted([partial.name, aside.name])
    assert names(tmp_path) == ["live.nc", "live.png", "out"]


def test_files_that_only_look_alike_are_left_alone(tmp_path):
    for name in (".notes.part", "result.nc.0123abcd.part", ".result.nc.0123abcd.part~"):
        (tmp_path / name).write_text("mine")
    before = names(tmp_path)
    remove_abandoned(tmp_path)
    assert names(tmp_path) == before


def test_a_failed_write_leaves_neither_the_directory_nor_anything_in_it(tmp_path):
    with pytest.raises(ZeroDivisionError), atomic_directory(tmp_path / "new") as aside:
        (aside / "half.png").write_text("half")
        _ = 1 // 0
    assert names(tmp_path) == []
